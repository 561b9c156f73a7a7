//! A bead, a small body on a wire or hoop, of `radius`.
//!
//! ```toml
//! elements = [{ line = ["[0, 0]", "[3, 0]"] }, { bead = [1.5, 0], label = "m" }]
//! ```

use super::{Element, Key, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Label, Path, Spot, Weight, spots};

pub(super) struct Bead;

impl Element for Bead {
    fn name(&self) -> &'static str {
        "bead"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius")] }
    }

    fn layer(&self) -> Layer {
        Layer::Joint
    }

    fn role(&self) -> Role {
        Role::Body("bead")
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::round(
            part.point(),
            part.length("radius", 0.13),
            false,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let circle = Path::circle(part.point(), part.length("radius", 0.13));
        drawing.shape(
            circle,
            Some(part.pen(Weight::Medium)),
            part.fill(Fill::Shade),
        );
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let label = part
            .label
            .as_ref()
            .map_or_else(Label::default, Clone::clone);
        self.outline(part).map_or(Vec::new(), |outline| {
            spots::inside(&outline, &label, part.at)
        })
    }
}
