//! A pulley of `radius` with its groove and axle; `spokes = true` draws a heavy wheel with spokes.
//!
//! Fixed or moving: it stands where its point is. A cord goes round it as `"P cw"` or `"P ccw"`.
//!
//! ```toml
//! points = { P = [1, 1], Q = [4, 1] }
//! elements = [
//!   { pulley = "P", radius = 0.5 },
//!   { pulley = "Q", radius = 0.9, spokes = true, label = "I" },
//! ]
//! ```

use std::f64::consts::FRAC_PI_2;

use super::family::Round;
use super::{flag, number};
use crate::figure::part::Part;
use crate::figure::{Bounds, Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static PULLEY: Round = Round {
    name: "pulley",
    body: Noun::new("pulley", "une poulie"),
    keys: &[number("radius"), flag("spokes")],
    radius: 0.4,
    draw,
    ..Round::USUAL
};

/// The radius of the hub of a wheel with spokes.
const HUB: f64 = 0.12;

fn draw(part: &Part<'_>, centre: Point, radius: f64, drawing: &mut Drawing) {
    let pen = part.pen(Weight::Medium);
    let rim = Path::circle(centre, radius);
    drawing.shape(rim, Some(pen), part.fill(Fill::Tint));
    let groove = radius - (0.16 * radius).clamp(0.05, 0.12);
    drawing.stroke(Path::circle(centre, groove), part.pen(Weight::Hair));
    if part.is("spokes") {
        for quarter in 0..4 {
            let direction = Point::at_angle(f64::from(quarter) * FRAC_PI_2 + 0.4);
            let spoke = Path::line(centre + direction * HUB, centre + direction * groove);
            drawing.stroke(spoke, pen);
        }
        drawing.stroke(Path::circle(centre, HUB), pen);
    }
    drawing.shape(Path::circle(centre, 0.05), None, Fill::Ink);
    drawing.inside(Bounds::around(centre, 1.4 * radius, 1.4 * radius));
}
