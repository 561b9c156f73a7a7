//! A roller bearing: it holds its point above the ground and lets it move along.
//!
//! ```toml
//! elements = [{ bar = ["[0.5, 1]", "[3, 1]"] }, { roller = [3, 1] }, { pin = [0.5, 1], support = "below" }]
//! ```

use super::pin::{BEARING, bearing};
use super::{Element, Layer};
use crate::figure::outline::Side;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(crate) struct Roller;

const WHEEL: f64 = 0.07;

impl Element for Roller {
    fn name(&self) -> &'static str {
        "roller"
    }

    fn layer(&self) -> Layer {
        Layer::Joint
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let point = part.point();
        bearing(part, point, Side::Below, 2.0 * WHEEL, drawing);
        for side in [-0.14, 0.14] {
            let wheel = Path::circle(point + Point::new(side, WHEEL - BEARING), WHEEL);
            drawing.decorate(wheel, Some(part.pen(Weight::Thin)), Fill::None);
        }
        let circle = Path::circle(point, 0.08);
        drawing.shape(circle, Some(part.pen(Weight::Medium)), Fill::Paper);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        spots::around(part.point(), 0.14, part.at)
    }
}
