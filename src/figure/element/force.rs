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

use super::{Element, Holds, Key, Layer, Role, Takes, vector};
use crate::figure::arrow::{Head, arrow};
use crate::figure::part::Part;
use crate::figure::{Drawing, Point, Spot, Weight, spots};

pub(super) struct Force;

/// Length of an arrow of direction 1.
const LENGTH: f64 = 1.1;

fn ends(part: &Part<'_>) -> (Point, Point) {
    let from = part.point();
    let out = part.ends[0].out.unwrap_or(Point::new(1.0, 0.0));
    let direction = part.vector("direction").unwrap_or(out);
    (from, from + direction * LENGTH)
}

impl Element for Force {
    fn name(&self) -> &'static str {
        "force"
    }

    fn takes(&self) -> Takes {
        Takes::PointOrLabel
    }

    fn keys(&self) -> &'static [Key] {
        const {
            &[
                vector("direction"),
                Key {
                    name: "from",
                    holds: Holds::Point,
                },
            ]
        }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Thing("force")
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = ends(part);
        arrow(drawing, from, to, part.pen(Weight::Bold), Head::BOLD);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (from, to) = ends(part);
        spots::at_tip(from, to, part.at)
    }
}
