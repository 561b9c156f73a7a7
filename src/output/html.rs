//! `html`: one self-contained page with MathML, an embedded math font and a print style.
//!
//! Nothing is fetched: the page works from a disk, without a network, and prints on A4 or Letter.

use std::fmt::Write as _;

use super::Writer;
use super::layouts::style;
use crate::document::{Document, Filling, Formulas};
use crate::math::{Display, MATHML_STYLE, Math, Voice, escape};
use crate::scene::Shown;
use crate::seed::Variant;
use crate::worksheet::ScanMark;

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

    fn keeps_questions_together(&self) -> bool {
        true
    }

    fn words(&self, words: &str) -> String {
        let mut out = String::with_capacity(words.len());
        escape(&mut out, words);
        out
    }

    /// A long sum may go on in the next line, which browsers do not do by themselves.
    fn math(&self, math: &Math, voice: &'static Voice) -> String {
        let written = |math: &Math| {
            let mut out = String::new();
            Formulas::Measured.write(&mut out, math, Display::Inline, voice);
            out
        };
        if math.plain().chars().count() < LONG {
            return written(math);
        }
        let terms: Vec<String> = math.terms().iter().map(written).collect();
        terms.join("<wbr>")
    }

    /// A picture, as an address within a style; a browser does not say in it which page it is.
    fn scan_mark(&self, variant: Variant) -> String {
        let mark = ScanMark {
            variant,
            page: 0,
            is_last: false,
        };
        let mut path = String::new();
        for (y, row) in mark.modules().iter().enumerate() {
            for x in (0..ScanMark::WIDTH).filter(|x| row >> x & 1 == 1) {
                let _ = write!(path, "M{x} {y}h1v1h-1z");
            }
        }
        let width = ScanMark::WIDTH;
        format!(
            "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' width='12.6mm' height='12.6mm' \
             viewBox='0 0 {width} {width}'%3E%3Cpath d='{path}'/%3E%3C/svg%3E"
        )
    }

    fn texts(&self, shown: &[Shown<'_>], voice: &'static Voice) -> String {
        let mut out = String::new();
        for piece in shown {
            let formulas = Formulas::Measured;
            piece
                .document
                .write_html_with(&mut out, &piece.fillings, formulas, voice);
        }
        out
    }

    fn line(&self, document: &Document, voice: &'static Voice) -> String {
        let mut out = String::new();
        let (none, formulas) = (Vec::<Filling>::new(), Formulas::Measured);
        if super::is_line(document) {
            document.write_html_line_with(&mut out, &none, formulas, voice);
        } else {
            document.write_html_with(&mut out, &none, formulas, voice);
        }
        out
    }
}
