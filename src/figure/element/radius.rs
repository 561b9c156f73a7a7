//! A radius from a point at an angle in degrees, `of` this length: an arrow to the rim.
//!
//! ```toml
//! points = { O = [1.2, 1.2] }
//! elements = [{ disk = "O", radius = 1.2 }, { radius = ["O", 30], of = 1.2, label = "r" }]
//! ```

use super::family::Straight;
use super::{Takes, number};
use crate::figure::arrow::ArrowHead;
use crate::figure::part::Part;
use crate::figure::{Point, Weight, spots};

pub(crate) static RADIUS: Straight = Straight {
    name: "radius",
    takes: Takes::PointAndDegrees,
    keys: &[number("of")],
    weight: Weight::Hair,
    head: ArrowHead::SLIM,
    ends,
    spots: |from, to, part| {
        let mut spots = spots::beside(from, from.towards(to, 0.9), 0.0, part.at);
        spots.extend(spots::off(to, to - from, 0.0));
        spots
    },
    ..Straight::USUAL
};

fn ends(part: &Part<'_>) -> (Point, Point) {
    let angle = part.number("degrees").unwrap_or(0.0).to_radians();
    let along = Point::at_angle(angle) * part.length("of", 1.0);
    (part.point(), part.point() + along)
}
