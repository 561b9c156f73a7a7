//! A massless rod between two points.
//!
//! ```toml
//! points = { O = [0.4, 1.6], A = [2, 0.4] }
//! elements = [{ rod = ["O", "A"], label = "l" }, { bob = "A" }]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Noun, Path, Spot, Weight, spots};

pub(crate) struct Rod;

impl Element for Rod {
    fn name(&self) -> &'static str {
        "rod"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(Noun::ROD)
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        drawing.stroke(Path::line(a, b), part.pen(Weight::Bold));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, 0.03, part.at)
    }
}
