//! A cart on two wheels: its point is the middle of its body, the wheels stand 0.9 below it; `width` is its length.
//!
//! ```toml
//! elements = [
//!   { ground = ["[0, 0]", "[4, 0]"] },
//!   { cart = [2, 0.9], width = 2, label = "m" },
//! ]
//! ```

use super::family::inside;
use super::{Element, ElementKey, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Spot, Weight};

pub(crate) struct Cart;

const HEIGHT: f64 = 1.0;
// The middle of the cart is then 0.9 above its ground, a number that authors type.
const WHEEL: f64 = 0.2;

impl Element for Cart {
    fn name(&self) -> &'static str {
        "cart"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[number("width")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Body(Noun::new("cart", "un chariot"))
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::boxed(
            part.point(),
            part.length("width", 2.0),
            HEIGHT,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let Some(outline) = self.outline(part) else {
            return;
        };
        let path = Path::polygon(outline.corners());
        drawing.shape(path, Some(part.pen(Weight::Bold)), part.fill(Fill::Tint));
        drawing.inside(outline.bounds());
        let reach = (part.length("width", 2.0) / 2.0 - 0.35).max(WHEEL);
        for side in [-reach, reach] {
            let centre = part.point() + Point::new(side, -HEIGHT / 2.0 - WHEEL);
            let pen = Some(part.pen(Weight::Medium));
            drawing.shape(Path::circle(centre, WHEEL), pen, part.fill(Fill::Tint));
            drawing.decorate(Path::circle(centre, 0.04), None, Fill::Ink);
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        self.outline(part)
            .map_or(Vec::new(), |outline| inside(&outline, part))
    }
}
