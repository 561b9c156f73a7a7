//! `md`: Markdown with LaTeX math between dollar signs, for those who edit further.

use super::Writer;
use crate::document::{Document, Filling};
use crate::math::{Math, Voice};
use crate::scene::Shown;

/// The format.
pub(crate) struct Markdown;

impl Writer for Markdown {
    fn name(&self) -> &'static str {
        "md"
    }

    fn extension(&self) -> &'static str {
        "md"
    }

    fn words(&self, words: &str) -> String {
        let mut out = String::with_capacity(words.len());
        for letter in words.chars() {
            if "\\`*_{}[]<>#$|~".contains(letter) {
                out.push('\\');
            }
            out.push(if letter == '\n' || letter == '\r' {
                ' '
            } else {
                letter
            });
        }
        out
    }

    fn math(&self, math: &Math, _: &'static Voice) -> String {
        format!("${}$", math.latex())
    }

    fn texts(&self, shown: &[Shown<'_>], _: &'static Voice) -> String {
        let pieces = shown.iter().map(|piece| {
            piece
                .document
                .markdown(&piece.fillings)
                .trim_end()
                .to_owned()
        });
        pieces.collect::<Vec<_>>().join("\n\n")
    }

    fn line(&self, document: &Document, _: &'static Voice) -> String {
        document
            .markdown(&Vec::<Filling>::new())
            .trim_end()
            .to_owned()
    }
}
