//! A ring or hoop of outer `radius`.
//!
//! ```toml
//! elements = [{ ring = [1, 1], radius = 1, label = "M" }]
//! ```

use std::f64::consts::{PI, TAU};

use super::family::{Round, outside};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static RING: Round = Round {
    name: "ring",
    body: Noun::new("ring", "un anneau"),
    has_axle: false,
    spots: outside,
    draw,
    ..Round::USUAL
};

const THICKNESS: f64 = 0.12;

fn draw(part: &Part<'_>, centre: Point, outer: f64, drawing: &mut Drawing) {
    let inner = (outer - THICKNESS).max(0.5 * outer);
    // The inner circle runs the other way round, so that the hole stays empty.
    let hole = Path::new()
        .move_to(centre + Point::new(inner, 0.0))
        .arc_on(centre, inner, TAU, PI)
        .arc_on(centre, inner, PI, 0.0)
        .close();
    let path = Path::circle(centre, outer).and(hole);
    drawing.shape(path, Some(part.pen(Weight::Medium)), part.fill(Fill::Shade));
}
