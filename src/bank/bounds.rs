//! How large an item may be, and how much work it may be to read it and to work it out.
//!
//! The largest item that comes with the program has a tenth to a hundredth of what is allowed here.

use crate::diagnostic::{Code, Diagnose, Finding, Label};
use crate::source::{Data, Source, Span, Value};

/// Bytes of a file of a bank.
pub(crate) const MAX_FILE: usize = 1 << 18;

/// Entries of a table or array of an item.
const MAX_ENTRIES: usize = 500;

/// Parts of an item: a sheet counts them by letters.
const MAX_PARTS: usize = 100;

/// Letters of a title.
pub(crate) const MAX_TITLE_LENGTH: usize = 300;

/// Findings about one file that are reported.
const MAX_FINDINGS: usize = 100;

/// Units of work that reading an item may take: about a second.
pub(crate) const READING: u64 = 100_000_000;

/// Something that is larger than its bound.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum Excess {
    #[cfg_attr(
        not(feature = "render"),
        expect(dead_code, reason = "files belong to the command line")
    )]
    #[error("the file has {found} bytes, at most {MAX_FILE} are read")]
    File { found: usize },
    #[error("`{key}` has {found} entries, at most {most} are read")]
    Entries {
        key: String,
        found: usize,
        most: usize,
        span: Span,
    },
    #[error("the title has {found} letters, at most {MAX_TITLE_LENGTH} are read")]
    Title { found: usize, span: Span },
    #[error(
        "deriving and simplifying the formulas of this item takes more than {} million steps",
        READING / 1_000_000
    )]
    Work,
    #[error("more than {MAX_FINDINGS} findings about this file, of which the first are shown")]
    Findings,
}

/// What of a file's tree is larger than its bound.
pub(crate) fn excesses(tree: &Value) -> Vec<Excess> {
    let mut found = Vec::new();
    let mut open = vec![("", tree)];
    while let Some((key, value)) = open.pop() {
        let entries = match &value.data {
            Data::Table(entries) => {
                open.extend(entries.iter().map(|entry| (&*entry.key, &entry.value)));
                entries.len()
            }
            Data::List(items) => {
                open.extend(items.iter().map(|item| (key, item)));
                items.len()
            }
            Data::Text(text) if key == "title" => {
                let letters = text.chars().count();
                if letters > MAX_TITLE_LENGTH {
                    let span = value.span;
                    found.push(Excess::Title {
                        found: letters,
                        span,
                    });
                }
                continue;
            }
            _ => continue,
        };
        let most = if key == "part" {
            MAX_PARTS
        } else {
            MAX_ENTRIES
        };
        if entries > most {
            found.push(Excess::Entries {
                key: if key.is_empty() { "the file" } else { key }.to_owned(),
                found: entries,
                most,
                span: value.span,
            });
        }
    }
    found
}

/// The first findings, and that there are others.
pub(crate) fn shortened(mut findings: Vec<Finding>, source: &Source) -> Vec<Finding> {
    if findings.len() > MAX_FINDINGS {
        findings.truncate(MAX_FINDINGS);
        findings.push(Finding::of(&Excess::Findings, source));
    }
    findings
}

impl Diagnose for Excess {
    fn code(&self) -> Code {
        Code::SIZE
    }

    fn labels(&self) -> Vec<Label> {
        let span = match self {
            Self::Entries { span, .. } | Self::Title { span, .. } => *span,
            Self::File { .. } | Self::Work | Self::Findings => return Vec::new(),
        };
        vec![Label {
            span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::File { .. } | Self::Entries { .. } => "divide it into several items",
            Self::Title { .. } => "shorten it, and say the rest in `notes`",
            Self::Work => {
                "give intermediate results a unit, so that they are numbers, or nest fewer functions"
            }
            Self::Findings => "mend those that are shown first",
        };
        Some(help.to_owned())
    }
}
