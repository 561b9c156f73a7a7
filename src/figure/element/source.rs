//! A source of alternating voltage between two points.
//!
//! ```toml
//! elements = [{ source = ["[0, 0]", "[2.4, 0]"], label = "'e(t)'" }]
//! ```

use super::resistor::middle;
use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(super) struct Source;

const RADIUS: f64 = 0.34;

impl Element for Source {
    fn name(&self) -> &'static str {
        "source"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link("voltage source")
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let (from, to) = middle(a, b, 2.0 * RADIUS);
        let (centre, radius) = (from.towards(to, 0.5), from.distance(to) / 2.0);
        let pen = part.pen(Weight::Medium);
        drawing.stroke(Path::line(a, from).and(Path::line(to, b)), pen);
        drawing.shape(Path::circle(centre, radius), Some(pen), Fill::None);
        let at = |x: f64, y: f64| centre + Point::new(x, y) * radius;
        let wave = Path::new()
            .move_to(at(-0.55, 0.0))
            .curve_to(at(-0.35, 0.5), at(-0.2, 0.5), at(0.0, 0.0))
            .curve_to(at(0.2, -0.5), at(0.35, -0.5), at(0.55, 0.0));
        drawing.stroke(wave, part.pen(Weight::Thin));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, RADIUS, part.at)
    }
}
