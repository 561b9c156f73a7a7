//! Why a request has no result.

use serde::{Serialize, Serializer};
use thiserror::Error;

/// Why a request has no result; serialized as `{"code", "message"}`.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RequestError {
    /// The line is longer than any request.
    #[error(
        "the line has {bytes} bytes, and at most {} are read",
        super::MAX_LINE_LENGTH
    )]
    LineTooLong {
        /// Its length.
        bytes: usize,
    },
    /// The line is not JSON.
    #[error("the line is not JSON: {reason}")]
    NotJson {
        /// What the reader says.
        reason: String,
    },
    /// The line is JSON, but no object.
    #[error("a request is a JSON object")]
    NotAnObject,
    /// The task is missing or no text.
    #[error("a request names its task as a string under `task`")]
    NoTask,
    /// The parameters are missing or no object.
    #[error("a request holds its parameters as an object under `params`")]
    NoParameters,
    /// There is no task of this name.
    #[error("there is no task `{name}`; there are {}", listed(super::tasks()))]
    UnknownTask {
        /// The name, or the beginning of it.
        name: String,
    },
    /// A key that nobody reads.
    #[error("the key `{key}` is not known here; known are {}", listed(known.iter().copied()))]
    UnknownKey {
        /// The key, or the beginning of it.
        key: String,
        /// The keys that may stand there.
        known: &'static [&'static str],
    },
    /// A parameter that the task needs.
    #[error("the parameter `{name}` is missing")]
    MissingParameter {
        /// The key under `params`, as the request has it.
        name: &'static str,
    },
    /// A parameter that cannot be read as what it should be.
    #[error("the parameter `{name}` must be {expected}")]
    NotANumber {
        /// The key under `params`, as the request has it.
        name: &'static str,
        /// What it should be.
        expected: &'static str,
    },
    /// A list that is too long.
    #[error("the parameter `{name}` has {count} entries, and at most {most} are read")]
    TooMany {
        /// The key under `params`, as the request has it.
        name: &'static str,
        /// Its length.
        count: usize,
        /// The longest allowed.
        most: usize,
    },
    /// Parameters for which the task has no answer.
    #[error("{reason}")]
    OutOfDomain {
        /// What is wrong with them.
        reason: String,
    },
    /// A result that is too large for a number.
    #[error("the result `{name}` leaves the range of numbers")]
    NotFinite {
        /// The key under `params`, as the request has it.
        name: &'static str,
    },
}

impl RequestError {
    /// The error for parameters that a model refuses.
    pub(crate) fn domain(error: impl std::error::Error) -> Self {
        Self::OutOfDomain {
            reason: error.to_string(),
        }
    }

    /// The error's name for programs.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::LineTooLong { .. } => "line_too_long",
            Self::NotJson { .. } => "not_json",
            Self::NotAnObject => "not_an_object",
            Self::NoTask => "no_task",
            Self::NoParameters => "no_parameters",
            Self::UnknownTask { .. } => "unknown_task",
            Self::UnknownKey { .. } => "unknown_key",
            Self::MissingParameter { .. } => "missing_parameter",
            Self::NotANumber { .. } => "not_a_number",
            Self::TooMany { .. } => "too_many",
            Self::OutOfDomain { .. } => "out_of_domain",
            Self::NotFinite { .. } => "not_finite",
        }
    }
}

impl Serialize for RequestError {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serde_json::json!({ "code": self.code(), "message": self.to_string() })
            .serialize(serializer)
    }
}

/// The beginning of a text that came from outside.
pub(crate) fn excerpt(text: &str) -> String {
    // Enough to recognize what was given, and a message stays a line.
    const MAX_LENGTH: usize = 40;
    match text.char_indices().nth(MAX_LENGTH) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ")
}
