//! A plate that moves as a base does; its point is the middle of its upper side, `width` its length.
//!
//! ```toml
//! points = { P = [2, 0] }
//! elements = [
//!   { platform = "P", width = 3 },
//!   { coordinate = "u", from = "P.right", direction = [0, 1] },
//! ]
//! ```

use super::{Element, ElementKey, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Spot, Weight, spots};

pub(crate) struct Platform;

const THICKNESS: f64 = 0.22;

impl Element for Platform {
    fn name(&self) -> &'static str {
        "platform"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[number("width")] }
    }

    fn layer(&self) -> Layer {
        Layer::Support
    }

    fn role(&self) -> Role {
        Role::Body(Noun::new("moving base", "un support mobile"))
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        let centre = part.point() - Point::new(0.0, THICKNESS / 2.0);
        Some(Outline::boxed(centre, part.length("width", 3.0), THICKNESS))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let Some(outline) = self.outline(part) else {
            return;
        };
        let path = Path::polygon(outline.corners());
        drawing.shape(path, Some(part.pen(Weight::Bold)), part.fill(Fill::Shade));
        drawing.inside(outline.bounds());
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        self.outline(part).map_or(Vec::new(), |outline| {
            spots::outside(outline.bounds(), part.at)
        })
    }
}
