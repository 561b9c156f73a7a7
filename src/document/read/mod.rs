//! Texts read into trees.
//!
//! Placeholders are put out of sight first ([`mask`]), then the Markdown parser cuts the text into
//! events, which [`text`] folds into blocks; each formula is read by [`crate::math`]. All findings of a text are
//! reported together, with their places in the text as it was written.

mod error;
mod lint;
mod mask;
mod text;

pub use crate::math::read_latex as read_math;
pub use error::TextError;
pub(crate) use text::read;

use super::Document;
use crate::diagnostic::Finding;
use crate::source::{Source, Text};

/// A text as it was read: what could be read of it, and what is wrong with it.
#[derive(Clone, Debug, PartialEq)]
pub struct TextReading {
    /// The document; where something is wrong, without it.
    pub document: Document,
    /// What is wrong, in the order of the text; of very many errors the first hundred.
    pub errors: Vec<TextError>,
}

/// Reads a text of a file that has no data to show: instructions, formulas of a chapter. All that cannot be set is
/// found, placeholders included.
pub(crate) fn read_bare(text: &Text, source: &Source) -> (Document, Vec<Finding>) {
    let reading = Document::read(&text.value);
    let holes = reading.document.placeholders().iter();
    let misplaced = holes.map(|hole| TextError::MisplacedPlaceholder {
        place: "a text without data",
        span: hole.span,
    });
    let errors = reading.errors.iter().cloned().chain(misplaced);
    let findings = errors
        .map(|error| Finding::within(&error, source, text))
        .collect();
    (reading.document, findings)
}
