//! Bank text, the places in it, and the reader that takes typed fields out of a TOML table.
//!
//! A file becomes a [`Value`] tree in which every key and value knows its place; a [`Table`] takes
//! typed fields out of it, and notes what is wrong ([`Problem`]) instead of stopping.
//! Reading TOML itself belongs to the feature `files`: a compiled item brings its tree along.

mod case;
pub mod diagnostic;
mod json;
mod nearest;
mod problem;
mod span;
mod table;
mod text;
#[cfg(feature = "files")]
pub mod toml;
mod value;

pub use case::{capital, lower};
pub use json::{Fields, FromJson, Misfit, variant};
pub use nearest::nearest;
pub use problem::Problem;
pub use span::Span;
pub use table::{Problems, Table};
pub use text::{Source, Text};
pub use value::{Data, Entry, Value};
