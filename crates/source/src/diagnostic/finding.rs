//! A finding, and the trait through which errors become one.

use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

use serde::Serialize;

use crate::{Problem, Source, Span, Text};

/// How grave a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The file serves, but could be better.
    Advice,
    /// The item can be used, but something is likely wrong.
    Warning,
    /// The item cannot be used.
    Error,
}

/// A place to point at, and what to say there.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The bytes of the text that the message points at.
    pub span: Span,
    /// What to say; may be empty.
    pub text: String,
}

/// Whether an error is a text: where nothing is reported, errors are dropped with their texts, which a linker would keep
/// for the trait object.
#[cfg(feature = "files")]
pub trait Worded: fmt::Display {}
#[cfg(feature = "files")]
impl<T: fmt::Display + ?Sized> Worded for T {}
/// Whether an error is a text: here it need not be.
#[cfg(not(feature = "files"))]
pub trait Worded {}
#[cfg(not(feature = "files"))]
impl<T: ?Sized> Worded for T {}

/// An error or advice that can be reported: its message is its `Display`. Without the feature `files` a finding has its
/// code alone.
pub trait Diagnose: Worded {
    /// The code under which it is explained.
    fn code(&self) -> Code;

    /// How grave it is.
    fn severity(&self) -> Severity {
        Severity::Error
    }

    /// What to point at, the main place first.
    #[cfg(feature = "files")]
    fn labels(&self) -> Vec<Label>;
    /// What to point at, the main place first.
    #[cfg(not(feature = "files"))]
    fn labels(&self) -> Vec<Label>
    where
        Self: Sized;

    /// A way out, as an imperative.
    #[cfg(feature = "files")]
    fn help(&self) -> Option<String> {
        None
    }
    /// A way out, as an imperative.
    #[cfg(not(feature = "files"))]
    fn help(&self) -> Option<String>
    where
        Self: Sized,
    {
        None
    }
}

use super::Code;

/// One thing that is wrong with a file.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The code under which it is explained.
    pub code: Code,
    /// How grave it is.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// What to point at, the main place first; empty if it concerns the whole file.
    pub labels: Vec<Label>,
    /// A way out.
    pub help: Option<String>,
    /// The file.
    pub source: Source,
}

impl Finding {
    /// What `error` reports about the file `source`, its places counted in that file.
    #[cfg(not(feature = "files"))]
    pub fn of(error: &(impl Diagnose + ?Sized), source: &Source) -> Self {
        let code = error.code();
        Self {
            code,
            severity: error.severity(),
            message: code.name().to_owned(),
            labels: Vec::new(),
            help: None,
            source: source.clone(),
        }
    }

    /// What `error` reports about the file `source`, its places counted in that file.
    #[cfg(feature = "files")]
    pub fn of(error: &(impl Diagnose + ?Sized), source: &Source) -> Self {
        Self {
            code: error.code(),
            severity: error.severity(),
            message: error.to_string(),
            labels: error.labels(),
            help: error.help(),
            source: source.clone(),
        }
    }

    /// What `error` reports about a text of the file, its places counted in that text.
    pub fn within(error: &(impl Diagnose + ?Sized), source: &Source, text: &Text) -> Self {
        let mut finding = Self::of(error, source);
        for label in &mut finding.labels {
            label.span = source.place(text, label.span);
        }
        finding
    }

    /// The byte at which it stands in its file.
    pub fn offset(&self) -> usize {
        self.labels
            .first()
            .filter(|label| !label.span.is_none())
            .map_or(0, |label| label.span.start as usize)
    }

    /// Path, line and column of its place.
    pub fn place(&self) -> String {
        let (line, column) = self.source.position(self.offset());
        if self.labels.is_empty() {
            return self.source.path.to_string();
        }
        format!("{}:{line}:{column}", self.source.path)
    }

    /// Sorts findings by file and place, for reports.
    pub fn sort(findings: &mut [Self]) {
        findings.sort_by(Self::order);
    }

    /// The order of findings in reports: by file and place, there the graver ones first.
    pub fn order(&self, other: &Self) -> Ordering {
        let place = |own: &Self| (Arc::clone(&own.source.path), own.offset());
        let places = place(self).cmp(&place(other));
        places
            .then(other.severity.cmp(&self.severity))
            .then_with(|| self.message.cmp(&other.message))
    }
}

/// One line without the source: place, severity, code, message and help.
impl fmt::Display for Finding {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{}: {} [{}] {}",
            self.place(),
            self.severity,
            self.code,
            self.message
        )?;
        match &self.help {
            Some(help) => write!(formatter, " (help: {help})"),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Severity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Advice => "advice",
            Self::Warning => "warning",
            Self::Error => "error",
        })
    }
}

impl Serialize for Finding {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let (line, column) = self.source.position(self.offset());
        let mut object = serializer.serialize_struct("Finding", 7)?;
        object.serialize_field("code", self.code.name())?;
        object.serialize_field("severity", &self.severity)?;
        object.serialize_field("message", &self.message)?;
        object.serialize_field("help", &self.help)?;
        object.serialize_field("file", &*self.source.path)?;
        object.serialize_field("line", &line)?;
        object.serialize_field("column", &column)?;
        object.end()
    }
}

impl Diagnose for Problem {
    fn code(&self) -> Code {
        match self {
            Self::Syntax { .. } => Code::TOML_SYNTAX,
            Self::Missing { .. } | Self::Blank { .. } => Code::MISSING_KEY,
            Self::Unknown { .. } => Code::UNKNOWN_KEY,
            Self::Kind { .. } => Code::WRONG_KIND,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let text = match self {
            Self::Kind { expected, .. } => format!("expected {expected}"),
            Self::Unknown { .. } => "not a key here".to_owned(),
            _ => String::new(),
        };
        vec![Label {
            span: self.span(),
            text,
        }]
    }

    fn help(&self) -> Option<String> {
        Problem::help(self)
    }
}
