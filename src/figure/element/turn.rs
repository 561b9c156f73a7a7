//! A rotation about a point: an arrow along the circle of `radius`, from the angle `from` to the angle `to`, in degrees.
//!
//! With `axis`, a direction `[x, y]` in the plane of the drawing, it turns about this axis: its circle is seen
//! obliquely, and the angles are counted counterclockwise as seen from the tip of the axis; 270 is in front.
//!
//! ```toml
//! points = { O = [1.2, 1.2] }
//! elements = [
//!   { disk = "O", radius = 1 },
//!   { turn = "O", radius = 1.25, from = 20, to = 70, label = "theta" },
//!   { wire = ["[4, 2.4]", "[4, 0.8]"] },
//!   { block = [4, 0.5], size = [2, 0.6] },
//!   { turn = [4, 1.5], axis = [0, 1], radius = 0.6, label = "theta" },
//! ]
//! ```

use super::{Element, ElementKey, Layer, Role, number, vector};
use crate::figure::arrow::{Orbit, bent};
use crate::figure::part::Part;
use crate::figure::{Drawing, Spot, Weight, spots};

pub(crate) struct Turn;

/// The front of a circle that is seen obliquely, in degrees.
pub(crate) const FRONT: (f64, f64) = (200.0, 340.0);

/// From where to where it turns, in degrees; counterclockwise if the second is greater.
pub(crate) fn degrees(part: &Part<'_>) -> (f64, f64) {
    let usual = match part.vector("axis") {
        Some(_) => FRONT,
        None => (20.0, 70.0),
    };
    let degrees = |key: &str, usual: f64| part.number(key).unwrap_or(usual).clamp(-720.0, 720.0);
    (degrees("from", usual.0), degrees("to", usual.1))
}

fn span(part: &Part<'_>) -> (f64, f64) {
    let (from, to) = degrees(part);
    (from.to_radians(), to.to_radians())
}

fn orbit(part: &Part<'_>) -> Orbit {
    Orbit {
        centre: part.point(),
        radius: part.length("radius", 1.0),
        axis: part.vector("axis"),
    }
}

impl Element for Turn {
    fn name(&self) -> &'static str {
        "turn"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const {
            &[
                number("radius"),
                number("from"),
                number("to"),
                vector("axis"),
            ]
        }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = span(part);
        bent(drawing, orbit(part), from, to, part.pen(Weight::Thin));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (from, to) = span(part);
        let orbit = orbit(part);
        let mut spots = Vec::new();
        for share in [0.5, 0.65, 0.35, 0.8, 0.2] {
            let arm = orbit.arm(from + (to - from) * share);
            spots.extend(spots::off(orbit.centre, arm, arm.length()));
        }
        if let Some(side) = part.at {
            crate::numerics::sort_by_key(&mut spots, |spot| {
                spot.anchor != crate::figure::Anchor::facing(side.direction())
            });
        }
        let middle = orbit.arm(f64::midpoint(from, to));
        let inside = orbit.centre + middle - middle.unit() * 0.1;
        spots.extend(spots::off(inside, -middle, 0.0));
        spots
    }
}
