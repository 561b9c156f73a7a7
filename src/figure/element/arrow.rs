//! An arrow between two points: a velocity, a current, a direction of motion.
//!
//! ```toml
//! elements = [{ arrow = ["[0, 0]", "[1.4, 0]"], label = "v" }]
//! ```

use super::Takes;
use super::family::Straight;

pub(crate) static ARROW: Straight = Straight {
    name: "arrow",
    takes: Takes::Two,
    ..Straight::USUAL
};
