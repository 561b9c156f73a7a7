//! `pdf`: pages printed by `vibank-press`, tagged for readers who cannot see them (PDF/UA-1).
//!
//! A page is written as Typst markup, words and formulas quoted; the press makes a file of it. The same
//! sheet gives the same bytes on every machine.

use super::Writer;
use crate::document::{Document, Filling, write_picture};
use crate::math::{Display, Math, TYPST_PRELUDE, Voice, quote};
use crate::scene::Shown;
use crate::seed::Variant;
use crate::worksheet::{Modules, ScanMark};

/// The format.
pub(crate) struct Pdf;

impl Writer for Pdf {
    fn name(&self) -> &'static str {
        "pdf"
    }

    fn extension(&self) -> &'static str {
        "pdf"
    }

    fn layout(&self) -> &'static str {
        "typ"
    }

    fn has_braces(&self) -> bool {
        true
    }

    fn escape(&self) -> Option<super::Escape> {
        Some(|words, out| {
            // A layout sees whether a place is empty.
            if words.is_empty() {
                return Ok(());
            }
            let mut quoted = String::from("#");
            quote(&mut quoted, words);
            out.write_all(quoted.as_bytes())
        })
    }

    fn style(&self) -> String {
        TYPST_PRELUDE.to_owned()
    }

    fn words(&self, words: &str) -> String {
        let mut out = String::from("#");
        quote(&mut out, words);
        out
    }

    fn math(&self, math: &Math, voice: &'static Voice) -> String {
        math.typst(Display::Inline, voice)
    }

    fn texts(&self, shown: &[Shown<'_>], voice: &'static Voice) -> String {
        let pieces = shown
            .iter()
            .map(|piece| piece.document.typst(&piece.fillings, voice));
        pieces.collect::<Vec<_>>().join("\n\n")
    }

    fn line(&self, document: &Document, voice: &'static Voice) -> String {
        document.typst(&Vec::<Filling>::new(), voice)
    }

    fn figure(&self, svg: &str) -> String {
        let mut out = String::new();
        write_picture(&mut out, svg);
        out
    }

    /// Rows of modules of page 0, and the rows that each bit of the page inverts, for `scan-marks` of the layout.
    fn scan_mark(&self, variant: Variant) -> String {
        let bits: Vec<String> = ScanMark::page_bits().iter().map(rows).collect();
        let mark = ScanMark {
            variant,
            page: 0,
            is_last: false,
        };
        format!("{},({})", rows(&mark.modules()), bits.join(","))
    }

    fn is_bound(&self) -> bool {
        true
    }
}

/// The rows of modules, as Typst reads them.
fn rows(modules: &Modules) -> String {
    let rows: Vec<String> = modules.iter().map(u32::to_string).collect();
    format!("({})", rows.join(","))
}
