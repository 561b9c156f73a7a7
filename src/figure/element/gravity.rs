//! The acceleration of gravity, an arrow from a point along `direction`, downward if none is given.
//!
//! ```toml
//! elements = [{ gravity = [0.5, 1] }]
//! ```

use super::family::Straight;
use super::{Role, vector};
use crate::figure::arrow::ArrowHead;
use crate::figure::part::Part;
use crate::figure::{Point, Weight, spots};

pub(crate) static GRAVITY: Straight = Straight {
    name: "gravity",
    keys: &[vector("direction")],
    role: Role::Mark,
    label: "g",
    weight: Weight::Medium,
    head: ArrowHead::BOLD,
    ends,
    spots: |from, to, part| {
        let mut spots = spots::around(from.towards(to, 0.45), 0.06, part.at);
        spots.extend(spots::at_tip(from, to, part.at));
        spots
    },
    ..Straight::USUAL
};

const LENGTH: f64 = 0.95;

fn ends(part: &Part<'_>) -> (Point, Point) {
    let direction = part.vector("direction").unwrap_or(Point::new(0.0, -1.0));
    (part.point(), part.point() + direction * LENGTH)
}
