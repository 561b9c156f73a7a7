//! A ring or hoop of outer `radius`.
//!
//! ```toml
//! elements = [{ ring = [1, 1], radius = 1, label = "M" }]
//! ```

use std::f64::consts::{PI, TAU};

use super::{Element, Key, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(super) struct Ring;

const THICKNESS: f64 = 0.12;

impl Element for Ring {
    fn name(&self) -> &'static str {
        "ring"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Body("ring")
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::round(
            part.point(),
            part.length("radius", 1.0),
            false,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (centre, outer) = (part.point(), part.length("radius", 1.0));
        let inner = (outer - THICKNESS).max(0.5 * outer);
        // The inner circle runs the other way round, so that the hole stays empty.
        let hole = Path::new()
            .move_to(centre + Point::new(inner, 0.0))
            .arc_on(centre, inner, TAU, PI)
            .arc_on(centre, inner, PI, 0.0)
            .close();
        let path = Path::circle(centre, outer).and(hole);
        drawing.shape(path, Some(part.pen(Weight::Medium)), part.fill(Fill::Shade));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        self.outline(part).map_or(Vec::new(), |outline| {
            spots::outside(outline.bounds(), part.at)
        })
    }
}
