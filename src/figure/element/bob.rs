//! The bob of a pendulum, a point mass, of `radius`; a rod to its point ends at its outline.
//!
//! ```toml
//! points = { O = [1, 2], A = [1.6, 0.4] }
//! elements = [{ rod = ["O", "A"], label = "l" }, { pin = "O" }, { bob = "A", label = "m" }]
//! ```

use super::{Element, Key, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Label, Path, Spot, Weight, spots};

pub(super) struct Bob;

impl Element for Bob {
    fn name(&self) -> &'static str {
        "bob"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius")] }
    }

    fn layer(&self) -> Layer {
        Layer::Joint
    }

    fn role(&self) -> Role {
        Role::Body("ball")
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::round(
            part.point(),
            part.length("radius", 0.2),
            false,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let circle = Path::circle(part.point(), part.length("radius", 0.2));
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
