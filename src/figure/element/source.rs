//! A source of alternating voltage between two points.
//!
//! ```toml
//! elements = [{ source = ["[0, 0]", "[2.4, 0]"], label = "'e(t)'" }]
//! ```

use super::family::Branch;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static SOURCE: Branch = Branch {
    name: "source",
    link: Noun::new("voltage source", "une source de tension"),
    length: 2.0 * RADIUS,
    half_width: RADIUS,
    symbol,
};

const RADIUS: f64 = 0.34;

fn symbol(part: &Part<'_>, from: Point, to: Point, drawing: &mut Drawing) {
    let (centre, radius) = (from.towards(to, 0.5), from.distance(to) / 2.0);
    let circle = Path::circle(centre, radius);
    drawing.shape(circle, Some(part.pen(Weight::Medium)), Fill::None);
    let at = |x: f64, y: f64| centre + Point::new(x, y) * radius;
    let wave = Path::new()
        .move_to(at(-0.55, 0.0))
        .curve_to(at(-0.35, 0.5), at(-0.2, 0.5), at(0.0, 0.0))
        .curve_to(at(0.2, -0.5), at(0.35, -0.5), at(0.55, 0.0));
    drawing.stroke(wave, part.pen(Weight::Thin));
}
