//! The acceleration of gravity, an arrow from a point along `direction`, downward if none is given.
//!
//! ```toml
//! elements = [{ gravity = [0.5, 1] }]
//! ```

use super::{Element, Key, Layer, Takes, vector};
use crate::figure::arrow::{Head, arrow};
use crate::figure::part::Part;
use crate::figure::{Drawing, Point, Spot, Weight, spots};

pub(super) struct Gravity;

const LENGTH: f64 = 0.95;

fn ends(part: &Part<'_>) -> (Point, Point) {
    let direction = part.vector("direction").unwrap_or(Point::new(0.0, -1.0));
    (part.point(), part.point() + direction * LENGTH)
}

impl Element for Gravity {
    fn name(&self) -> &'static str {
        "gravity"
    }

    fn takes(&self) -> Takes {
        Takes::Point
    }

    fn keys(&self) -> &'static [Key] {
        const { &[vector("direction")] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn usual_label(&self) -> &'static str {
        "g"
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = ends(part);
        arrow(drawing, from, to, part.pen(Weight::Medium), Head::BOLD);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (from, to) = ends(part);
        let mut spots = spots::around(from.towards(to, 0.45), 0.06, part.at);
        spots.extend(spots::at_tip(from, to, part.at));
        spots
    }
}
