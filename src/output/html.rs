//! `html`: one self-contained page with MathML, an embedded math font and a print style.
//!
//! Nothing is fetched: the page works from a disk, without a network, and prints on A4 or Letter.

use super::Writer;
use super::layouts::style;
use crate::document::{Document, Filling};
use crate::math::{Display, MATHML_STYLE, Math, escape};
use crate::scene::Shown;

/// The format.
pub(crate) struct Html;

/// Letters of a formula that surely fit in a line.
const LONG: usize = 48;

impl Writer for Html {
    fn name(&self) -> &'static str {
        "html"
    }

    fn extension(&self) -> &'static str {
        "html"
    }

    fn escape(&self) -> Option<super::Escape> {
        Some(tera::escape_html)
    }

    fn style(&self) -> String {
        format!("{MATHML_STYLE}{}", style())
    }

    fn words(&self, words: &str) -> String {
        let mut out = String::with_capacity(words.len());
        escape(&mut out, words);
        out
    }

    /// A long sum may go on in the next line, which browsers do not do by themselves.
    fn math(&self, math: &Math) -> String {
        if math.plain().chars().count() < LONG {
            return math.mathml(Display::Inline);
        }
        let terms = math.terms();
        let terms = terms.iter().map(|term| term.mathml(Display::Inline));
        terms.collect::<Vec<_>>().join("<wbr>")
    }

    fn texts(&self, shown: &[Shown<'_>]) -> String {
        let mut out = String::new();
        for piece in shown {
            piece.document.write_html(&mut out, &piece.fillings);
        }
        out
    }

    fn line(&self, document: &Document) -> String {
        let mut out = String::new();
        if super::is_line(document) {
            document.write_html_line(&mut out, &Vec::<Filling>::new());
        } else {
            document.write_html(&mut out, &Vec::<Filling>::new());
        }
        out
    }
}
