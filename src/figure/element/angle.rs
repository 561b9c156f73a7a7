//! The angle at the second of three points, from the ray to the first to the ray to the third, the shorter way; `radius` is that of its arc.
//!
//! ```toml
//! points = { O = [0, 0], A = [2.4, 0], B = [2, 1.3] }
//! elements = [
//!   { line = ["O", "A"] }, { line = ["O", "B"] },
//!   { angle = ["A", "O", "B"], label = "theta" },
//! ]
//! ```

use super::{Element, ElementKey, Layer, Role, Takes, number};
use crate::figure::part::Part;
use crate::figure::{Drawing, Path, Point, Spot, Weight, spots};
use std::f64::consts::PI;

pub(crate) struct Angle;

/// The vertex, the radius, and the angles of both rays.
fn arc(part: &Part<'_>) -> (Point, f64, f64, f64) {
    let [a, vertex, b] = [0, 1, 2].map(|place| part.ends[place].point);
    let reach = a.distance(vertex).min(b.distance(vertex));
    let radius = part
        .number("radius")
        .unwrap_or((0.55 * reach).clamp(0.4, 1.2));
    let from = (a - vertex).angle();
    let mut turn = (b - vertex).angle() - from;
    if turn > PI {
        turn -= 2.0 * PI;
    } else if turn < -PI {
        turn += 2.0 * PI;
    }
    (vertex, radius.clamp(0.05, 100.0), from, from + turn)
}

impl Element for Angle {
    fn name(&self) -> &'static str {
        "angle"
    }

    fn takes(&self) -> Takes {
        Takes::Three
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[number("radius")] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (vertex, radius, from, to) = arc(part);
        drawing.stroke(Path::arc(vertex, radius, from, to), part.pen(Weight::Thin));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (vertex, radius, from, to) = arc(part);
        let middle = Point::at_angle(f64::midpoint(from, to));
        let mut spots = Vec::new();
        if let Some(side) = part.at {
            let tip = vertex + middle * radius;
            spots.extend(spots::off(tip, side.direction(), 0.02));
        }
        for more in [0.2, 0.3, 0.45, 0.6, 0.8] {
            let at = vertex + middle * (radius + more);
            spots.push(Spot::new(at, crate::figure::Anchor::MIDDLE));
        }
        for more in [0.25, 0.35] {
            let at = vertex + middle * (radius - more);
            spots.push(Spot::new(at, crate::figure::Anchor::MIDDLE));
        }
        for (angle, turn) in [(from, from - to), (to, to - from)] {
            let tip = Point::at_angle(angle);
            spots.extend(spots::off(
                vertex + tip * radius,
                tip.left() * turn.signum(),
                0.02,
            ));
        }
        spots
    }
}
