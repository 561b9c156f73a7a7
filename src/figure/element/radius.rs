//! A radius from a point at an angle in degrees, `of` this length: an arrow to the rim.
//!
//! ```toml
//! points = { O = [1.2, 1.2] }
//! elements = [{ disk = "O", radius = 1.2 }, { radius = ["O", 30], of = 1.2, label = "r" }]
//! ```

use super::{Element, Key, Layer, Role, Takes, number};
use crate::figure::arrow::{Head, arrow};
use crate::figure::part::Part;
use crate::figure::{Drawing, Point, Spot, Weight, spots};

pub(super) struct Radius;

fn ends(part: &Part<'_>) -> (Point, Point) {
    let angle = part.number("degrees").unwrap_or(0.0).to_radians();
    (
        part.point(),
        part.point() + Point::at_angle(angle) * part.length("of", 1.0),
    )
}

impl Element for Radius {
    fn name(&self) -> &'static str {
        "radius"
    }

    fn takes(&self) -> Takes {
        Takes::PointAndDegrees
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("of")] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = ends(part);
        arrow(drawing, from, to, part.pen(Weight::Hair), Head::SLIM);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (from, to) = ends(part);
        let mut spots = spots::beside(from, from.towards(to, 0.9), 0.0, part.at);
        spots.extend(spots::off(to, to - from, 0.0));
        spots
    }
}
