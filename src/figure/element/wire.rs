//! An elastic wire between two points, such as that of a torsion pendulum, clamped at both.
//!
//! ```toml
//! elements = [{ wire = ["[1, 2]", "[1, 0]"], label = "kappa" }]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Spot, Weight, spots};

pub(crate) struct Wire;

/// Half of its breadth.
const HALF: f64 = 0.035;

/// From one mark of the twist to the next.
const TWIST: f64 = 0.2;

impl Element for Wire {
    fn name(&self) -> &'static str {
        "wire"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(Noun::new("elastic wire", "un fil élastique"))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let along = (b - a).unit();
        let across = along.left() * HALF;
        let sides = Path::line(a + across, b + across).and(Path::line(a - across, b - across));
        drawing.stroke(sides, part.pen(Weight::Thin));
        let count = (a.distance(b) / TWIST).floor().clamp(1.0, 200.0) as usize;
        let mut marks = Path::new();
        for mark in 0..count {
            let at = a.towards(b, (mark as f64 + 0.5) / count as f64);
            let lean = along * (0.3 * TWIST);
            marks = marks.and(Path::line(at - lean + across, at + lean - across));
        }
        drawing.decorate(marks, Some(part.pen(Weight::Hair)), Fill::None);
        for end in [a, b] {
            let clamp = Path::line(end + across * 4.0, end - across * 4.0);
            drawing.stroke(clamp, part.pen(Weight::Heavy));
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, 0.1, part.at)
    }
}
