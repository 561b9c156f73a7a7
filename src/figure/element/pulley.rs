//! A pulley of `radius` with its groove and axle; `spokes = true` draws a heavy wheel with spokes.
//!
//! Fixed or moving: it stands where its point is. A cord goes round it as `"P cw"` or `"P ccw"`.
//!
//! ```toml
//! points = { P = [1, 1], Q = [4, 1] }
//! elements = [
//!   { pulley = "P", radius = 0.5 },
//!   { pulley = "Q", radius = 0.9, spokes = true, label = "I" },
//! ]
//! ```

use super::{Element, Key, Layer, Role, flag, number};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Bounds, Drawing, Fill, Label, Path, Point, Spot, Weight, spots};

pub(super) struct Pulley;

impl Element for Pulley {
    fn name(&self) -> &'static str {
        "pulley"
    }

    fn keys(&self) -> &'static [Key] {
        const { &[number("radius"), flag("spokes")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Body("pulley")
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(Outline::round(
            part.point(),
            part.length("radius", 0.4),
            true,
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (centre, radius) = (part.point(), part.length("radius", 0.4));
        let pen = part.pen(Weight::Medium);
        drawing.shape(
            Path::circle(centre, radius),
            Some(pen),
            part.fill(Fill::Tint),
        );
        let groove = radius - (0.16 * radius).clamp(0.05, 0.12);
        drawing.stroke(Path::circle(centre, groove), part.pen(Weight::Hair));
        if part.is("spokes") {
            for quarter in 0..4 {
                let direction =
                    Point::at_angle(f64::from(quarter) * std::f64::consts::FRAC_PI_2 + 0.4);
                let spoke = Path::line(centre + direction * 0.12, centre + direction * groove);
                drawing.stroke(spoke, part.pen(Weight::Medium));
            }
            drawing.stroke(Path::circle(centre, 0.12), part.pen(Weight::Medium));
        }
        drawing.shape(Path::circle(centre, 0.05), None, Fill::Ink);
        drawing.inside(Bounds::around(centre, 1.4 * radius, 1.4 * radius));
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
