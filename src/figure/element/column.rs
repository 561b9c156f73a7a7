//! An elastic column, beam or cantilever between two points, clamped at the first.
//!
//! ```toml
//! elements = [{ column = ["[1, 0]", "[1, 2]"], label = "A" }]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Spot, Weight, spots};

pub(crate) struct Column;

/// Half of its breadth.
const HALF: f64 = 0.14;

impl Element for Column {
    fn name(&self) -> &'static str {
        "column"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Link(Noun::new("elastic column", "une colonne élastique"))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let across = (b - a).unit().left() * HALF;
        let path = Path::polygon([a + across, b + across, b - across, a - across]);
        drawing.shape(path, Some(part.pen(Weight::Medium)), part.fill(Fill::Tint));
        // The clamp is wider than what it holds.
        let clamp = Path::line(a + across * 1.9, a - across * 1.9);
        drawing.stroke(clamp, part.pen(Weight::Heavy));
        drawing.keep_clear(a, b, HALF);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, HALF, part.at)
    }
}
