//! A bead, a small body on a wire or hoop, of `radius`.
//!
//! ```toml
//! elements = [{ line = ["[0, 0]", "[3, 0]"] }, { bead = [1.5, 0], label = "m" }]
//! ```

use super::Layer;
use super::bob::ball;
use super::family::Round;

pub(crate) static BEAD: Round = Round {
    name: "bead",
    body: "bead",
    layer: Layer::Joint,
    radius: 0.13,
    has_axle: false,
    draw: ball,
    ..Round::USUAL
};
