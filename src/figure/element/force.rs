//! A force at a point, along `direction`, whose length is that of the arrow.
//!
//! At a side of a body it points out of it if no direction is given.
//!
//! ```toml
//! points = { B = [1, 0.6] }
//! elements = [
//!   { block = "B", size = [1.6, 1.2], label = "m" },
//!   { force = "B.right", label = "'F(t)'" },
//! ]
//! ```

use super::family::Straight;
use super::{FROM, Role, Takes, vector};
use crate::figure::arrow::ArrowHead;
use crate::figure::part::Part;
use crate::figure::{Noun, Point, Weight};

pub(crate) static FORCE: Straight = Straight {
    name: "force",
    takes: Takes::PointOrLabel,
    keys: &[vector("direction"), FROM],
    role: Role::Thing(Noun::FORCE),
    weight: Weight::Bold,
    head: ArrowHead::BOLD,
    ends,
    ..Straight::USUAL
};

/// Length of an arrow of direction 1.
const LENGTH: f64 = 1.1;

fn ends(part: &Part<'_>) -> (Point, Point) {
    let from = part.point();
    let out = part.ends[0].out.unwrap_or(Point::new(1.0, 0.0));
    let direction = part.vector("direction").unwrap_or(out);
    (from, from + direction * LENGTH)
}
