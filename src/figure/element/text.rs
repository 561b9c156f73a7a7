//! Words or a symbol at a point.
//!
//! ```toml
//! elements = [{ text = [1, 0], label = "'C'" }]
//! ```

use super::{Element, Layer};
use crate::figure::part::Part;
use crate::figure::{Anchor, Drawing, Point, Spot, spots};

pub(crate) struct Text;

impl Element for Text {
    fn name(&self) -> &'static str {
        "text"
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn draw(&self, _: &Part<'_>, _: &mut Drawing) {}

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let mut spots: Vec<Spot> = Vec::new();
        match part.at {
            Some(side) => spots.extend(spots::off(part.point(), side.direction(), -0.04)),
            None => spots.push(Spot::new(part.point(), Anchor::MIDDLE)),
        }
        for step in [0.08, 0.16, 0.26, 0.4] {
            for (x, y) in [
                (0.0, 1.0),
                (0.0, -1.0),
                (1.0, 0.0),
                (-1.0, 0.0),
                (1.0, 1.0),
                (-1.0, 1.0),
                (1.0, -1.0),
                (-1.0, -1.0),
            ] {
                let at = part.point() + Point::new(x, y) * step;
                spots.push(Spot::new(at, Anchor::MIDDLE));
            }
        }
        spots
    }
}
