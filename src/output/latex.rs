//! `tex`: LaTeX for those who edit further; compiles with a plain TeX Live.
//!
//! Figures are PDF files beside the pages, in the folder `figures`, printed by `vibank-press`.

use super::Writer;
use crate::document::{Document, Filling, latex_words, picture_name};
use crate::math::{Math, Voice};
use crate::scene::Shown;

/// The format.
pub(crate) struct Latex;

impl Writer for Latex {
    fn name(&self) -> &'static str {
        "tex"
    }

    fn extension(&self) -> &'static str {
        "tex"
    }

    fn has_braces(&self) -> bool {
        true
    }

    fn escape(&self) -> Option<super::Escape> {
        Some(|words, out| {
            let mut escaped = String::with_capacity(words.len());
            latex_words(&mut escaped, words);
            out.write_all(escaped.as_bytes())
        })
    }

    fn words(&self, words: &str) -> String {
        let mut out = String::with_capacity(words.len());
        latex_words(&mut out, words);
        out
    }

    fn math(&self, math: &Math, _: &'static Voice) -> String {
        format!("${}$", math.latex())
    }

    fn texts(&self, shown: &[Shown<'_>], _: &'static Voice) -> String {
        let pieces = shown
            .iter()
            .map(|piece| piece.document.latex(&piece.fillings));
        pieces.collect::<Vec<_>>().join("\n\n")
    }

    fn line(&self, document: &Document, _: &'static Voice) -> String {
        document.latex(&Vec::<Filling>::new())
    }

    fn figure(&self, svg: &str) -> String {
        picture_name(svg)
    }

    fn picture_name(&self, svg: &str) -> Option<String> {
        (!svg.is_empty()).then(|| format!("figures/{}.pdf", picture_name(svg)))
    }

    fn needs_press(&self) -> bool {
        true
    }
}
