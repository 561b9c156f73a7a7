//! Where the texts of an item come from: the parsers, or a compiled item.

use crate::diagnostic::Diagnose;
use crate::document::Document;
use crate::math::Math;
use crate::source::{Problem, Text};

/// What is wrong with a text.
pub(crate) type Errors = Vec<Box<dyn Diagnose>>;

/// Gives the texts and symbols of an item as trees.
pub(crate) trait Texts {
    /// A text as a document: what could be read of it.
    fn document(&mut self, text: &Text, errors: &mut Errors) -> Document;

    /// A symbol that is written in LaTeX; `None`, with an error, where it cannot be read.
    fn math(&mut self, text: &Text, errors: &mut Errors) -> Option<Math>;

    /// A label of a drawing: words, words with formulas between dollar signs, or a formula in LaTeX.
    fn label(&mut self, text: &Text, errors: &mut Errors) -> Option<Math>;
}

/// Reads texts as they are written.
#[cfg(feature = "render")]
pub(crate) struct Parsers;

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
        Self::formula(&text.value, errors)
    }

    fn label(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
        let words = text.value.trim();
        let quoted = words
            .strip_prefix('\'')
            .and_then(|rest| rest.strip_suffix('\''));
        if let Some(words) = quoted.or_else(|| Self::is_words(words).then_some(words)) {
            return Some(Math::text(words));
        }
        if !words.contains('$') {
            return Self::formula(words, errors);
        }
        let pieces = words
            .split('$')
            .enumerate()
            .filter(|(_, piece)| !piece.is_empty());
        let pieces = pieces.map(|(place, piece)| match place % 2 {
            0 => Some(Math::text(piece)),
            _ => Self::formula(piece, errors),
        });
        Some(Math::row(pieces.collect::<Option<Vec<_>>>()?))
    }
}

#[cfg(feature = "render")]
impl Parsers {
    fn formula(latex: &str, errors: &mut Errors) -> Option<Math> {
        match crate::document::read_math(latex) {
            Ok(math) => Some(math),
            Err(error) => {
                errors.push(Box::new(error));
                None
            }
        }
    }

    /// Whether a label is words and no formula: letters and blanks, at least two letters in a row.
    fn is_words(label: &str) -> bool {
        let mut pieces = label.split(|letter: char| !letter.is_alphabetic());
        label
            .chars()
            .all(|letter| letter.is_alphabetic() || " ,-'".contains(letter))
            && pieces.any(|piece| piece.chars().count() > 1)
    }
}

/// Reads texts as they are written, and notes each with its place in the file.
#[cfg(feature = "render")]
#[derive(Default)]
pub(crate) struct Noting {
    pub(crate) documents: Vec<(crate::source::Span, Document)>,
    pub(crate) symbols: Vec<(crate::source::Span, Math)>,
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

    fn label(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
        let math = Parsers.label(text, errors)?;
        self.symbols.push((text.span, math.clone()));
        Some(math)
    }
}

/// Takes texts from a compiled item, in whose tree each is the number of its document or symbol.
pub(crate) struct Stored<'c> {
    pub(crate) documents: &'c [Document],
    pub(crate) symbols: &'c [Math],
}

impl Texts for Stored<'_> {
    fn document(&mut self, text: &Text, errors: &mut Errors) -> Document {
        stored(self.documents, text, errors).unwrap_or_default()
    }

    fn math(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
        stored(self.symbols, text, errors)
    }

    fn label(&mut self, text: &Text, errors: &mut Errors) -> Option<Math> {
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
