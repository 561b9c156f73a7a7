//! A rotation about a point: an arrow along the circle of `radius`, from the angle `from` to the angle `to`, in degrees.
//!
//! ```toml
//! points = { O = [1.2, 1.2] }
//! elements = [{ disk = "O", radius = 1 }, { turn = "O", radius = 1.25, from = 20, to = 70, label = "theta" }]
//! ```

use super::{Element, Key, Layer, Role, number};
use crate::figure::arrow::bent;
use crate::figure::part::Part;
use crate::figure::{Drawing, Point, Spot, Weight, spots};

pub(crate) struct Turn;

fn span(part: &Part<'_>) -> (f64, f64) {
    let degrees = |key: &str, usual: f64| part.number(key).unwrap_or(usual).clamp(-720.0, 720.0);
    (
        degrees("from", 20.0).to_radians(),
        degrees("to", 70.0).to_radians(),
    )
}

impl Element for Turn {
    fn name(&self) -> &'static str {
        "turn"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius"), number("from"), number("to")] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = span(part);
        let radius = part.length("radius", 1.0);
        bent(
            drawing,
            part.point(),
            radius,
            from,
            to,
            part.pen(Weight::Thin),
        );
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (from, to) = span(part);
        let (centre, radius) = (part.point(), part.length("radius", 1.0));
        let mut spots = Vec::new();
        for share in [0.5, 0.65, 0.35, 0.8, 0.2] {
            let direction = Point::at_angle(from + (to - from) * share);
            spots.extend(spots::off(centre, direction, radius));
        }
        if let Some(side) = part.at {
            crate::numerics::sort_by_key(&mut spots, |spot| {
                spot.anchor != crate::figure::Anchor::facing(side.direction())
            });
        }
        let direction = Point::at_angle(f64::midpoint(from, to));
        spots.extend(spots::off(
            centre + direction * (radius - 0.1),
            -direction,
            0.0,
        ));
        spots
    }
}
