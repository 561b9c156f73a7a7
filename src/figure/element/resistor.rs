//! A resistor between two points, as a rectangle (IEC 60617).
//!
//! ```toml
//! elements = [{ resistor = ["[0, 0]", "[2.4, 0]"], label = "R" }]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(super) struct Resistor;

const HALF: f64 = 0.17;

/// The ends of the middle part of a circuit element, of at most this length.
pub(super) fn middle(a: Point, b: Point, most: f64) -> (Point, Point) {
    let share = (most / a.distance(b).max(1e-9)).min(0.8) / 2.0;
    (a.towards(b, 0.5 - share), a.towards(b, 0.5 + share))
}

impl Element for Resistor {
    fn name(&self) -> &'static str {
        "resistor"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link("resistor")
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let (from, to) = middle(a, b, 1.0);
        let across = (b - a).unit().left() * HALF;
        let pen = part.pen(Weight::Medium);
        drawing.stroke(Path::line(a, from).and(Path::line(to, b)), pen);
        let body = Path::polygon([from + across, to + across, to - across, from - across]);
        drawing.shape(body, Some(pen), Fill::None);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, HALF, part.at)
    }
}
