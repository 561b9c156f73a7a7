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

use super::family::Round;
use crate::figure::part::Part;
use crate::figure::{Bounds, Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static DISK: Round = Round {
    name: "disk",
    body: Noun::new("disk", "un disque"),
    draw,
    ..Round::USUAL
};

fn draw(part: &Part<'_>, centre: Point, radius: f64, drawing: &mut Drawing) {
    let circle = Path::circle(centre, radius);
    drawing.shape(circle, Some(part.pen(Weight::Bold)), part.fill(Fill::Tint));
    drawing.shape(Path::circle(centre, 0.05), None, Fill::Ink);
    drawing.inside(Bounds::around(centre, 1.4 * radius, 1.4 * radius));
}
