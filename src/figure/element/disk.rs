//! A disk of `radius` with its axle, to which links to its point go.
//!
//! Two disks at one point make a stepped disk, or a disk with a hub.
//!
//! ```toml
//! points = { O = [2, 1.2] }
//! elements = [
//!   { disk = "O", radius = 1.2, label = "I" },
//!   { disk = "O", radius = 0.6 },
//!   { radius = ["O", 200], of = 1.2, label = "r" },
//! ]
//! ```

use super::{Element, Key, Layer, Role, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Label, Path, Spot, Weight, spots};

pub(super) struct Disk;

impl Element for Disk {
    fn name(&self) -> &'static str {
        "disk"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Body("disk")
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::round(
            part.point(),
            part.length("radius", 1.0),
            true,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let radius = part.length("radius", 1.0);
        let circle = Path::circle(part.point(), radius);
        drawing.shape(circle, Some(part.pen(Weight::Bold)), part.fill(Fill::Tint));
        drawing.shape(Path::circle(part.point(), 0.05), None, Fill::Ink);
        drawing.inside(crate::figure::Bounds::around(
            part.point(),
            1.4 * radius,
            1.4 * radius,
        ));
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
