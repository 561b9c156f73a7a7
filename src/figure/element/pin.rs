//! A hinge or axle; `support` = `below`, `above`, `left` or `right` draws the fixed bearing that holds it.
//!
//! ```toml
//! elements = [
//!   { pin = [0.5, 0.6] },
//!   { pin = [2, 0.6], support = "below", label = "'O'" },
//! ]
//! ```

use super::ground::hatch;
use super::{Element, ElementKey, Holds, Layer};
use crate::figure::outline::Side;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(crate) struct Pin;

const RADIUS: f64 = 0.08;

/// Height of the bearing, from the hinge to the ground.
pub(crate) const BEARING: f64 = 0.42;

/// Draws a bearing that holds a point from a side, hatched; it stands `lift` above its ground.
pub(crate) fn bearing(part: &Part<'_>, point: Point, side: Side, lift: f64, drawing: &mut Drawing) {
    let out = side.direction();
    let across = out.left();
    let foot = point + out * (BEARING - lift);
    let triangle = Path::polygon([point, foot + across * 0.26, foot - across * 0.26]);
    drawing.shape(
        triangle,
        Some(part.pen(Weight::Medium)),
        part.fill(Fill::Paper),
    );
    let ground = point + out * BEARING;
    let (a, b) = (ground + across * 0.42, ground - across * 0.42);
    drawing.stroke(Path::line(a, b), part.pen(Weight::Medium));
    // Hatching lies to the right of the way, away from the point.
    let (a, b) = if (b - a).cross(out) < 0.0 {
        (a, b)
    } else {
        (b, a)
    };
    hatch(part, a, b, 0.0, drawing);
    drawing.keep_clear(a + out * 0.12, b + out * 0.12, 0.12);
}

impl Element for Pin {
    fn name(&self) -> &'static str {
        "pin"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const {
            &[ElementKey {
                name: "support",
                holds: Holds::Word(&Side::WORDS),
            }]
        }
    }

    fn layer(&self) -> Layer {
        Layer::Joint
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        if let Some(side) = part.word("support").and_then(Side::of_word) {
            bearing(part, part.point(), side, 0.0, drawing);
        }
        let circle = Path::circle(part.point(), RADIUS);
        drawing.shape(circle, Some(part.pen(Weight::Medium)), Fill::Paper);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        spots::around(part.point(), RADIUS + 0.06, part.at)
    }
}
