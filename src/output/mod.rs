//! Formats of what is handed out, one file each, over the page layouts in `templates/`.
//!
//! A format is a [`Writer`] of texts and formulas and a folder of layouts; [`Pages`] fills the layouts
//! with what a sheet shows. Layouts can read no files and run no code, and see finished pieces only:
//! numbers are printed by `unit`, texts by `document`, and everything else is escaped.

mod chapter;
mod extent;
mod fairness;
mod feedback;
mod form;
mod html;
mod json;
mod key_table;
mod latex;
mod layouts;
mod lists;
mod markdown;
mod marks;
mod page;
mod pages;
mod pdf;
mod quoted;
mod report;
mod scorm;
mod textbook;
mod view;
mod words;

pub use chapter::{ChapterError, ChapterPiece, pieces as chapter_pieces};
pub use fairness::fairness_page;
pub use feedback::feedback_page;
pub use form::{FormQuestion, FormSheet, form};
pub use key_table::{KeyRow, KeyTable, key_row, key_table_page};
pub use layouts::{Layouts, OutputError, has_layout};
pub use lists::{List, Roll, list_page, separator_page};
pub use marks::MarkedRun;
pub use page::practice;
pub use pages::{Names, Page, PageKind, Pages, Run};
pub use report::{Analysed, Decided, DecidedMark, Lost, LostSheet, report_page};
pub use scorm::{DESCRIPTION, Scorm, scorm};
pub use textbook::{TextbookError, textbook_body};

use crate::document::{Block, Document};
use crate::math::{Math, Voice};
use crate::scene::Shown;
use crate::seed::Variant;

/// Writes words that a layout places so that they mean themselves.
pub type Escape = fn(&str, &mut dyn std::io::Write) -> std::io::Result<()>;

/// Writes texts and formulas in one notation.
pub trait Writer: Sync {
    /// Name of the format and of its folder of layouts.
    fn name(&self) -> &'static str;

    /// Ending of its files.
    fn extension(&self) -> &'static str;

    /// Ending of its layouts.
    fn layout(&self) -> &'static str {
        self.extension()
    }

    /// Whether the notation is full of braces, so that layouts mark their places by `<< >>` and `<% %>`.
    fn has_braces(&self) -> bool {
        false
    }

    /// How layouts escape the words that they place; without, they are written as they stand.
    fn escape(&self) -> Option<Escape> {
        None
    }

    /// What a file defines before its first page.
    fn style(&self) -> String {
        String::new()
    }

    /// Some words that are not markup.
    fn words(&self, words: &str) -> String;

    /// A formula in the line, heard in a voice where the notation can say it.
    fn math(&self, math: &Math, voice: &'static Voice) -> String;

    /// Texts, one after the other.
    fn texts(&self, shown: &[Shown<'_>], voice: &'static Voice) -> String;

    /// A text of one paragraph, without the marks of a paragraph.
    fn line(&self, document: &Document, voice: &'static Voice) -> String;

    /// A figure, given as SVG, beside a text.
    fn figure(&self, svg: &str) -> String {
        svg.to_owned()
    }

    /// The mark by which scans of the pages of a variant are sorted; empty where pages are set elsewhere.
    fn scan_mark(&self, _variant: Variant) -> String {
        String::new()
    }

    /// The name of the file of a figure that the notation cannot hold.
    fn picture_name(&self, _svg: &str) -> Option<String> {
        None
    }

    /// Whether a finished text is not yet the file: a press makes it, and each sheet is a file of its own.
    fn is_bound(&self) -> bool {
        false
    }

    /// Whether its layout of sheets keeps questions together on a page unless they are long, so that their heights are
    /// estimated.
    fn keeps_questions_together(&self) -> bool {
        false
    }

    /// Whether the format comes from a press, in whole or for its figures.
    fn needs_press(&self) -> bool {
        self.is_bound()
    }
}

/// The formats that layouts fill.
pub static WRITERS: &[&dyn Writer] = &[&html::Html, &markdown::Markdown, &pdf::Pdf, &latex::Latex];

/// The format of this name, or `json`.
pub fn writer(name: &str) -> Option<&'static dyn Writer> {
    WRITERS.iter().copied().find(|writer| writer.name() == name)
}

pub use json::sheet as json;

/// Whether a document is one paragraph.
fn is_line(document: &Document) -> bool {
    matches!(document.blocks(), [Block::Paragraph(_)])
}
