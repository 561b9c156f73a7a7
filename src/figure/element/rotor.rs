//! A rotor of `radius` with an unbalanced mass at the angle `unbalance`, in degrees.
//!
//! ```toml
//! elements = [{ rotor = [1, 1], radius = 0.9, unbalance = 40 }]
//! ```

use super::{Element, Key, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(super) struct Rotor;

impl Element for Rotor {
    fn name(&self) -> &'static str {
        "rotor"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius"), number("unbalance")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Body("unbalanced rotor")
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::round(
            part.point(),
            part.length("radius", 0.8),
            true,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (centre, radius) = (part.point(), part.length("radius", 0.8));
        let circle = Path::circle(centre, radius);
        drawing.shape(
            circle,
            Some(part.pen(Weight::Medium)),
            part.fill(Fill::Tint),
        );
        let angle = part.number("unbalance").unwrap_or(40.0).to_radians();
        let mass = centre + Point::at_angle(angle) * (0.66 * radius);
        drawing.stroke(Path::line(centre, mass), part.pen(Weight::Thin));
        drawing.shape(
            Path::circle(mass, (0.16 * radius).max(0.08)),
            None,
            Fill::Ink,
        );
        drawing.shape(Path::circle(centre, 0.06), None, Fill::Ink);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        self.outline(part).map_or(Vec::new(), |outline| {
            spots::outside(outline.bounds(), part.at)
        })
    }
}
