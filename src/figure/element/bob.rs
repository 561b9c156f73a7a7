//! The bob of a pendulum, a point mass, of `radius`; a rod to its point ends at its outline.
//!
//! ```toml
//! points = { O = [1, 2], A = [1.6, 0.4] }
//! elements = [{ rod = ["O", "A"], label = "l" }, { pin = "O" }, { bob = "A", label = "m" }]
//! ```

use super::Layer;
use super::family::Round;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static BOB: Round = Round {
    name: "bob",
    body: Noun::new("ball", "une boule"),
    layer: Layer::Joint,
    radius: 0.2,
    has_axle: false,
    draw: ball,
    ..Round::USUAL
};

/// A ball, as of a point mass.
pub(crate) fn ball(part: &Part<'_>, centre: Point, radius: f64, drawing: &mut Drawing) {
    let pen = part.pen(Weight::Medium);
    drawing.shape(
        Path::circle(centre, radius),
        Some(pen),
        part.fill(Fill::Shade),
    );
}
