//! Where the texts of an item come from: the parsers, or a compiled item.

use crate::diagnostic::Diagnose;
use crate::document::Document;
use crate::math::Math;
use crate::source::{Problem, Text};

/// What is wrong with a text.
pub(in crate::bank) type Errors = Vec<Box<dyn Diagnose>>;

/// Gives the texts and symbols of an item as trees.
pub(in crate::bank) trait Texts {
    /// A text as a document: what could be read of it.
    fn document(&mut self, text: &Text, errors: &mut Errors) -> Document;

    /// A symbol that is written in LaTeX; `None`, with an error, where it cannot be read.
    fn math(&mut self, text: &Text, errors: &mut Errors) -> Option<Math>;
}

/// Reads texts as they are written.
#[cfg(feature = "render")]
pub(in crate::bank) struct Parsers;

#[cfg(feature = "render")]
impl Texts for Parsers {
    fn document(&mut self, text: &Text, errors: &mut Errors) -> Document {
        let reading = Document::read(&text.value);
        for error in reading.errors {
            errors.push(Box::new(error));
        }
        reading.document
    }

    fn math(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
        match crate::document::read_math(&text.value) {
            Ok(math) => Some(math),
            Err(error) => {
                errors.push(Box::new(error));
                None
            }
        }
    }
}

/// Reads texts as they are written, and notes each with its place in the file.
#[cfg(feature = "render")]
#[derive(Default)]
pub(in crate::bank) struct Noting {
    pub(in crate::bank) documents: Vec<(crate::source::Span, Document)>,
    pub(in crate::bank) symbols: Vec<(crate::source::Span, Math)>,
}

#[cfg(feature = "render")]
impl Texts for Noting {
    fn document(&mut self, text: &Text, errors: &mut Errors) -> Document {
        let document = Parsers.document(text, errors);
        self.documents.push((text.span, document.clone()));
        document
    }

    fn math(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
        let math = Parsers.math(text, errors)?;
        self.symbols.push((text.span, math.clone()));
        Some(math)
    }
}

/// Takes texts from a compiled item, in whose tree each is the number of its document or symbol.
pub(in crate::bank) struct Stored<'c> {
    pub(in crate::bank) documents: &'c [Document],
    pub(in crate::bank) symbols: &'c [Math],
}

impl Texts for Stored<'_> {
    fn document(&mut self, text: &Text, errors: &mut Errors) -> Document {
        stored(self.documents, text, errors).unwrap_or_default()
    }

    fn math(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
        stored(self.symbols, text, errors)
    }
}

fn stored<T: Clone>(list: &[T], text: &Text, errors: &mut Errors) -> Option<T> {
    let number: Option<usize> = text.value.parse().ok();
    let found = number.and_then(|number| list.get(number)).cloned();
    if found.is_none() {
        errors.push(Box::new(Problem::Kind {
            key: "text".to_owned(),
            expected: "the number of a compiled text",
            found: format!("`{}`", text.value.chars().take(40).collect::<String>()),
            span: text.span,
        }));
    }
    found
}
