//! A block: `size` is its width and height, `angle` (in radians) turns it, as on a slope.
//!
//! ```toml
//! elements = [
//!   { block = [1, 0.6], size = [1.6, 1.2], label = "m" },
//!   { block = [4, 0.6], size = [1.2, 0.8], angle = "0.4", label = "m" },
//! ]
//! ```

use super::family::inside;
use super::{Element, ElementKey, Layer, Role, number, vector};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Spot, Weight};

pub(crate) struct Block;

impl Element for Block {
    fn name(&self) -> &'static str {
        "block"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[vector("size"), number("angle")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Body(Noun::new("block", "un bloc"))
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        let size = part.vector("size").unwrap_or(Point::new(1.4, 1.0));
        let angle = part.number("angle").unwrap_or(0.0);
        Some(Outline::turned(
            part.point(),
            size.x.abs(),
            size.y.abs(),
            angle,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        if let Some(outline) = self.outline(part) {
            let path = Path::polygon(outline.corners());
            drawing.shape(path, Some(part.pen(Weight::Bold)), part.fill(Fill::Tint));
            drawing.inside(outline.bounds());
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        self.outline(part)
            .map_or(Vec::new(), |outline| inside(&outline, part))
    }
}
