//! Formats of what is handed out, one file each, over the page layouts in `templates/`.
//!
//! A format is a [`Writer`] of texts and formulas and a folder of layouts; [`Pages`] fills the layouts
//! with what a sheet shows. Layouts can read no files and run no code, and see finished pieces only:
//! numbers are printed by `unit`, texts by `document`, and everything else is escaped.

mod html;
mod json;
mod layouts;
mod markdown;
mod pages;

pub use layouts::{Layouts, OutputError};
pub use pages::{Feedback, FeedbackPart, FeedbackQuestion, KeyTable, Kind, Pages, Run};

use crate::document::{Block, Document};
use crate::math::Math;
use crate::scene::Shown;

/// Writes texts and formulas in one notation.
pub trait Writer: Sync {
    /// Name of the format and of its folder of layouts.
    fn name(&self) -> &'static str;

    /// Ending of its files.
    fn extension(&self) -> &'static str;

    /// Whether layouts escape what they place.
    fn escapes(&self) -> bool;

    /// Some words that are no markup.
    fn words(&self, words: &str) -> String;

    /// A formula in the line.
    fn math(&self, math: &Math) -> String;

    /// Texts, one after the other.
    fn texts(&self, shown: &[Shown<'_>]) -> String;

    /// A text of one paragraph, without the marks of a paragraph.
    fn line(&self, document: &Document) -> String;
}

/// The formats that layouts fill.
pub static WRITERS: &[&dyn Writer] = &[&html::Html, &markdown::Markdown];

/// The format of this name, or `json`.
pub fn writer(name: &str) -> Option<&'static dyn Writer> {
    WRITERS.iter().copied().find(|writer| writer.name() == name)
}

pub use json::sheet as json;

/// Whether a document is one paragraph.
fn is_line(document: &Document) -> bool {
    matches!(document.blocks(), [Block::Paragraph(_)])
}
