//! Exports: questions in the formats of course platforms, one file each.
//!
//! A platform marks by its own means, so that an export carries what those can hold and names the rest.

mod cloze;
mod moodle;
mod pictures;

pub use moodle::{Moodle, Unfit};
