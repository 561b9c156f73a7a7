//! An arrow between two points: a velocity, a current, a direction of motion.
//!
//! ```toml
//! elements = [{ arrow = ["[0, 0]", "[1.4, 0]"], label = "v" }]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::arrow::{Head, arrow};
use crate::figure::part::Part;
use crate::figure::{Drawing, Spot, Weight, spots};

pub(super) struct Arrow;

impl Element for Arrow {
    fn name(&self) -> &'static str {
        "arrow"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = (part.ends[0].point, part.ends[1].point);
        arrow(drawing, from, to, part.pen(Weight::Thin), Head::USUAL);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        spots::at_tip(part.ends[0].point, part.ends[1].point, part.at)
    }
}
