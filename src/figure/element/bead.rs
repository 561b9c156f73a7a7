//! A bead, a small body on a wire or hoop, of `radius`.
//!
//! ```toml
//! elements = [{ line = ["[0, 0]", "[3, 0]"] }, { bead = [1.5, 0], label = "m" }]
//! ```

use super::Layer;
use super::bob::ball;
use super::family::Round;
use crate::figure::Noun;

pub(crate) static BEAD: Round = Round {
    name: "bead",
    body: Noun::new("bead", "une perle"),
    layer: Layer::Joint,
    radius: 0.13,
    has_axle: false,
    draw: ball,
    ..Round::USUAL
};
