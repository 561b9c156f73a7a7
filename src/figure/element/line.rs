//! A straight line between two points: a wire of a circuit, a line of reference (`style = "dashed"`).
//!
//! ```toml
//! elements = [
//!   { line = ["[0, 0]", "[2, 0]"] },
//!   { line = ["[0, 0.4]", "[2, 0.4]"], style = "dashed" },
//!   { line = ["[0, 0.8]", "[2, 0.8]"], style = "dotted" },
//! ]
//! ```

use super::{Element, Layer, Takes};
use crate::figure::part::{LineStyle, Part};
use crate::figure::{Drawing, Path, Spot, Weight, spots};

pub(crate) struct Line;

impl Element for Line {
    fn name(&self) -> &'static str {
        "line"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = (part.ends[0].point, part.ends[1].point);
        let weight = if part.style == LineStyle::Solid {
            Weight::Medium
        } else {
            Weight::Thin
        };
        drawing.stroke(Path::line(a, b), part.pen(weight));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = (part.ends[0].point, part.ends[1].point);
        let mut spots = Vec::new();
        if let Some(side) = part.at {
            // The name of an axis stands at its end.
            let out = side.direction();
            let end = if (b - a).dot(out) >= 0.0 { b } else { a };
            if (b - a).unit().dot(out).abs() > 0.7 {
                spots.extend(spots::off(end, out, 0.0));
            }
        }
        spots.extend(spots::beside(a, b, 0.02, part.at));
        spots
    }
}
