//! A slope with its angle: it rises from its point over the horizontal `length`, by `angle` in radians.
//!
//! With a negative angle it falls to the right from its upper end, above the point.
//! The label is written at the angle.
//!
//! ```toml
//! elements = [{ incline = [0, 0], angle = "0.4", length = 6, label = "theta" }]
//! ```

use super::ground::{DEPTH, hatch};
use super::{Element, ElementKey, Layer, Role, number};
use crate::figure::outline::Side;
use crate::figure::part::Part;
use crate::figure::{Anchor, Drawing, Fill, Noun, Path, Point, Spot, Weight, spots};
use crate::numerics::{cos, tan};

pub(crate) struct Incline;

/// Radius of the arc at the angle.
const ARC: f64 = 1.3;

impl Incline {
    /// The foot, the other end of the base, the upper end, and the angle.
    fn corners(part: &Part<'_>) -> (Point, Point, Point, f64) {
        let angle = part.number("angle").unwrap_or(0.4).clamp(-1.4, 1.4);
        let (start, length) = (part.point(), part.length("length", 6.0));
        let end = start + Point::new(length, 0.0);
        let rise = Point::new(0.0, length * tan(angle.abs()));
        if angle < 0.0 {
            (end, start, start + rise, angle)
        } else {
            (start, end, end + rise, angle)
        }
    }
}

impl Element for Incline {
    fn name(&self) -> &'static str {
        "incline"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[number("angle"), number("length")] }
    }

    fn layer(&self) -> Layer {
        Layer::Support
    }

    fn role(&self) -> Role {
        Role::Thing(Noun::new("slope", "un plan incliné"))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (foot, far, upper, angle) = Self::corners(part);
        drawing.stroke(Path::line(foot, far), part.pen(Weight::Thin));
        drawing.stroke(Path::line(foot, upper), part.pen(Weight::Bold));
        // The strokes stay within the slope: above its base and before its upper end.
        let steep = tan(angle.abs()).max(1e-3);
        let (a, b) = if angle < 0.0 {
            within(upper, foot, [steep, (1.0 / steep - 1.0).max(0.0)])
        } else {
            within(foot, upper, [1.0 / steep, (steep - 1.0).max(0.0)])
        };
        hatch(part, a, b, 0.0, drawing);
        if part.label.is_some() {
            let (from, to) = if angle < 0.0 {
                (std::f64::consts::PI + angle, std::f64::consts::PI)
            } else {
                (0.0, angle)
            };
            let radius = ARC.min(foot.distance(far) / 2.0);
            let arc = Path::arc(foot, radius, from, to);
            drawing.shape(arc, Some(part.pen(Weight::Thin)), Fill::None);
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (foot, far, _, angle) = Self::corners(part);
        let base = (far - foot).unit();
        // Between the base and the hatching under the slope.
        let middle = |along: f64| {
            let room = along * tan(angle.abs()) - DEPTH / cos(angle);
            foot + base * along + Point::new(0.0, room / 2.0)
        };
        let radius = ARC.min(foot.distance(far) / 2.0);
        let mut spots = Vec::new();
        for step in 0..8 {
            let at = middle(radius + 0.2 + 0.2 * f64::from(step));
            spots.push(Spot::new(at, Anchor::MIDDLE));
        }
        spots.extend(spots::beside(foot, far, 0.0, Some(Side::Below)));
        spots
    }
}

/// A line shortened at its ends, by shares of the depth.
fn within(from: Point, to: Point, [first, last]: [f64; 2]) -> (Point, Point) {
    let length = from.distance(to).max(1e-9);
    let [first, last] = [first, last].map(|share| (share * DEPTH / length).min(0.45));
    (from.towards(to, first), to.towards(from, last))
}
