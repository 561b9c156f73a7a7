//! A rotor of `radius` with an unbalanced mass at the angle `unbalance`, in degrees.
//!
//! ```toml
//! elements = [{ rotor = [1, 1], radius = 0.9, unbalance = 40 }]
//! ```

use super::family::{Round, outside};
use super::number;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static ROTOR: Round = Round {
    name: "rotor",
    body: Noun::new("unbalanced rotor", "un rotor à balourd"),
    keys: &[number("radius"), number("unbalance")],
    radius: 0.8,
    spots: outside,
    draw,
    ..Round::USUAL
};

fn draw(part: &Part<'_>, centre: Point, radius: f64, drawing: &mut Drawing) {
    let pen = part.pen(Weight::Medium);
    let circle = Path::circle(centre, radius);
    drawing.shape(circle, Some(pen), part.fill(Fill::Tint));
    let angle = part.number("unbalance").unwrap_or(40.0).to_radians();
    let mass = centre + Point::at_angle(angle) * (0.66 * radius);
    drawing.stroke(Path::line(centre, mass), part.pen(Weight::Thin));
    let dot = Path::circle(mass, (0.16 * radius).max(0.08));
    drawing.shape(dot, None, Fill::Ink);
    drawing.shape(Path::circle(centre, 0.06), None, Fill::Ink);
}
