//! Axes x and y at a point; `direction` is that of the x axis, and its length.
//!
//! ```toml
//! elements = [{ axes = [0.2, 0.2] }]
//! ```

use super::{Element, ElementKey, Layer, vector};
use crate::figure::arrow::{ArrowHead, arrow};
use crate::figure::part::Part;
use crate::figure::{Drawing, FigureLabel, Point, Spot, Weight, spots};

pub(crate) struct Axes;

impl Element for Axes {
    fn name(&self) -> &'static str {
        "axes"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[vector("direction")] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let origin = part.point();
        let x = part.vector("direction").unwrap_or(Point::new(1.0, 0.0));
        for (way, name) in [(x, "x"), (x.left(), "y")] {
            let tip = origin + way;
            arrow(
                drawing,
                origin,
                tip,
                part.pen(Weight::Thin),
                ArrowHead::USUAL,
            );
            drawing.place(FigureLabel::words(name), spots::at_tip(origin, tip, None));
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        spots::around(part.point(), 0.08, part.at)
    }
}
