//! Texts, the places in them, typed fields out of TOML and JSON, and findings with a way out.
//!
//! A file becomes a tree of values in which every key and value knows its place ([`Value`]); a [`Table`] takes typed
//! fields out of it, and notes what is wrong ([`Problem`]) instead of stopping, so that one mistake does not hide the
//! next. What is wrong becomes a [`Finding`](diagnostic::Finding): a code with an explanation, places to point at, and
//! what to do about it.
//!
//! ```
//! # #[cfg(feature = "files")] {
//! use vibank_source::diagnostic::Finding;
//! use vibank_source::{Problems, Source, Table, toml};
//!
//! let source = Source::new("block.toml", "title = \"Block\"\nlevel = \"easy\"\n");
//! let problems = Problems::default();
//! let root = toml::read(&source, &problems);
//! let table = Table::of(&source, &problems, "", &root).expect("a file is a table");
//! assert_eq!(table.text("title").expect("a title").value, "Block");
//! assert_eq!(table.number("level"), None);
//!
//! let finding = Finding::of(&problems.take()[0], &source);
//! assert_eq!(finding.message, "`level` is a text, expected a number");
//! assert_eq!(&source.text[finding.labels[0].span.range()], "\"easy\"");
//! # }
//! ```
//!
//! Reading TOML, and messages of findings, belong to the feature `files`: a compiled item brings its tree along as JSON
//! ([`FromJson`]), and the grader in the browser needs no messages about files.

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

pub use case::{capital, is_capital, is_lower, lower};
pub use json::{Fields, FromJson, Misfit, variant};
pub use nearest::{EditDistance, nearest};
pub use problem::Problem;
pub use span::Span;
pub use table::{Problems, Table};
pub use text::{Source, Text};
pub use value::{Data, Entry, Value};
