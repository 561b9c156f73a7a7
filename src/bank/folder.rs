//! The files of a bank beside its items: `bank.toml` and `_chapter.toml`.

use std::collections::BTreeMap;

use crate::document::Document;

#[cfg(feature = "render")]
use crate::{
    diagnostic::{Code, Diagnose, Finding, Label, Severity},
    document::read_bare,
    source::{Problems, Source, Span, Table, Text, toml},
};

/// The version of the bank format that this program reads.
pub const FORMAT: i64 = 1;

/// `bank.toml`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BankFile {
    /// The title that lists and pages show.
    pub title: String,
    /// Its licence; may be empty.
    pub licence: String,
    /// The language of its texts.
    pub language: String,
    /// The vocabulary of topics with what they mean.
    pub topics: BTreeMap<String, String>,
}

/// `_chapter.toml`.
#[derive(Clone, Debug, PartialEq)]
pub struct Chapter {
    /// The name of its folder.
    pub folder: String,
    /// The title that lists and pages show.
    pub title: String,
    /// Its number, for the order.
    pub number: i64,
    /// What it is about.
    pub text: String,
    /// Its formulas, for sheets that come with them; may be empty.
    pub formulas: Document,
}

/// What is wrong with the folder of a bank.
#[cfg(feature = "render")]
#[derive(Debug, thiserror::Error)]
pub(crate) enum FolderError {
    #[error("the bank has no `bank.toml`")]
    NoBankFile,
    #[error("the chapter `{0}` has no `_chapter.toml`")]
    NoChapterFile(String),
    #[error("`{0}` cannot be the name of an item")]
    Path(String),
    #[error("`{item}` builds on `{after}`, which is not an item of this bank")]
    After {
        item: String,
        after: String,
        nearest: Option<String>,
        span: Span,
    },
}

#[cfg(feature = "render")]
#[derive(Debug, thiserror::Error)]
#[error("this bank has format {found}, this program reads format {FORMAT}")]
struct WrongFormat {
    found: String,
    span: Span,
}

#[cfg(feature = "render")]
impl Diagnose for WrongFormat {
    fn code(&self) -> Code {
        Code::BANK_FORMAT
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        Some("take the version of the program that belongs to the bank".to_owned())
    }
}

#[cfg(feature = "render")]
impl Diagnose for FolderError {
    fn code(&self) -> Code {
        Code::FOLDER
    }

    fn severity(&self) -> Severity {
        match self {
            Self::NoBankFile | Self::Path(_) => Severity::Error,
            Self::NoChapterFile(_) | Self::After { .. } => Severity::Warning,
        }
    }

    fn labels(&self) -> Vec<Label> {
        match self {
            Self::After { span, .. } => vec![Label {
                span: *span,
                text: String::new(),
            }],
            _ => Vec::new(),
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::NoBankFile => Some("add one with `format = 1` and a `title`".to_owned()),
            Self::NoChapterFile(_) => Some("add one with a `title` and a `number`".to_owned()),
            Self::Path(_) => {
                Some("name it `chapter/slug.toml` in small letters, digits and hyphens".to_owned())
            }
            Self::After { nearest, .. } => nearest
                .as_ref()
                .map(|near| format!("did you mean `{near}`?")),
        }
    }
}

#[cfg(feature = "render")]
impl BankFile {
    /// Reads `bank.toml`.
    pub(crate) fn read(source: &Source) -> (Self, Vec<Finding>) {
        let problems = Problems::default();
        let value = toml::read(source, &problems);
        let mut findings = Vec::new();
        let mut file = Self {
            language: "en".to_owned(),
            ..Self::default()
        };
        if let Some(table) = Table::of(source, &problems, "", &value) {
            file.title = table
                .required_text("title")
                .map(|text| text.value)
                .unwrap_or_default();
            file.licence = table
                .text("licence")
                .map(|text| text.value)
                .unwrap_or_default();
            file.language = table
                .text("language")
                .map_or_else(|| "en".to_owned(), |text| text.value);
            if let Some(topics) = table.table("topics") {
                let words = topics.entries().iter();
                file.topics = words
                    .filter_map(|entry| {
                        Some((
                            entry.key.clone(),
                            topics.as_text(&entry.key, &entry.value)?.value,
                        ))
                    })
                    .collect();
            }
            let format = table.integer("format", "an integer", 0..=i64::MAX);
            if let Some(found) = format.filter(|format| *format != FORMAT) {
                let span = table.value("format").map_or(Span::NONE, |value| value.span);
                findings.push(Finding::of(
                    &WrongFormat {
                        found: found.to_string(),
                        span,
                    },
                    source,
                ));
            }
            table.required("format");
            table.finish();
        }
        findings.extend(
            problems
                .take()
                .iter()
                .map(|problem| Finding::of(problem, source)),
        );
        (file, findings)
    }
}

#[cfg(feature = "render")]
impl Chapter {
    /// Reads the `_chapter.toml` of a folder.
    pub(crate) fn read(folder: &str, source: &Source) -> (Self, Vec<Finding>) {
        let problems = Problems::default();
        let value = toml::read(source, &problems);
        let mut chapter = Self {
            folder: folder.to_owned(),
            title: folder.to_owned(),
            number: i64::MAX,
            text: String::new(),
            formulas: Document::default(),
        };
        let mut findings = Vec::new();
        if let Some(table) = Table::of(source, &problems, "", &value) {
            if let Some(title) = table.required_text("title") {
                chapter.title = title.value;
            }
            if let Some(number) = table.integer("number", "an integer", 0..=i64::MAX) {
                chapter.number = number;
            }
            let mut bare = |text: &Text| {
                let (document, mut found) = read_bare(text, source);
                findings.append(&mut found);
                document
            };
            if let Some(text) = table.text("text") {
                bare(&text);
                chapter.text = text.value;
            }
            if let Some(formulas) = table.text("formulas") {
                chapter.formulas = bare(&formulas);
            }
            table.finish();
        }
        let problems = problems.take();
        let problems = problems.iter().map(|problem| Finding::of(problem, source));
        findings.extend(problems);
        (chapter, findings)
    }
}
