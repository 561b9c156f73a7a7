//! What can be wrong with the form of a file.

use super::{Span, nearest};

/// A fault in the form of a file: syntax, a key, the kind of a value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The file is no TOML there.
    #[error("{message}")]
    Syntax {
        /// What the reader of TOML says.
        message: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A key that has to be there is not.
    #[error("{} has no `{key}`", called(table))]
    Missing {
        /// The table, as it is called in the file.
        table: String,
        /// The key, as the reader asks for it.
        key: &'static str,
        /// Its header.
        span: Span,
    },
    /// A text that has to say something, without a word in it.
    #[error("`{key}` is empty")]
    Blank {
        /// The key, as the reader asks for it.
        key: &'static str,
        /// The text.
        span: Span,
    },
    /// A key that nothing reads.
    #[error("`{key}` is not a key of {}", called(table))]
    Unknown {
        /// The table, as it is called in the file.
        table: String,
        /// The key as written.
        key: String,
        /// The keys that the table may have.
        known: Vec<&'static str>,
        /// Whether the whole file has a key of this name, so that it may stand below a header by mistake.
        is_of_file: bool,
        /// The key.
        span: Span,
    },
    /// A value of another kind than its key asks for.
    #[error("`{key}` is {found}, expected {expected}")]
    Kind {
        /// The key, as the reader asks for it.
        key: String,
        /// What is due.
        expected: &'static str,
        /// What stands there.
        found: String,
        /// The value.
        span: Span,
    },
}

/// What a key is called elsewhere, and the key.
const SYNONYMS: [(&str, &str); 14] = [
    ("answer", "key"),
    ("class", "students"),
    ("copies", "variants"),
    ("damping", "dissipation"),
    ("data", "parameters"),
    ("dof", "coordinates"),
    ("explanation", "solution"),
    ("given", "parameters"),
    ("prompt", "ask"),
    ("question", "ask"),
    ("roster", "students"),
    ("score", "points"),
    ("versions", "variants"),
    ("weight", "points"),
];

/// The known key that is nearest to another one, in its letters or by its meaning.
fn meant(key: &str, known: &[&'static str]) -> Option<&'static str> {
    nearest(key, known.iter().copied()).or_else(|| {
        let mut synonyms = SYNONYMS.iter();
        let (_, meant) = synonyms.find(|(word, meant)| *word == key && known.contains(meant))?;
        Some(*meant)
    })
}

/// A table as messages call it; the table of the whole file has no name.
fn called(table: &str) -> String {
    if table.is_empty() {
        "the file".to_owned()
    } else {
        format!("`{table}`")
    }
}

impl Problem {
    /// The bytes of the file that the message points at.
    pub fn span(&self) -> Span {
        match self {
            Self::Syntax { span, .. }
            | Self::Missing { span, .. }
            | Self::Blank { span, .. }
            | Self::Unknown { span, .. }
            | Self::Kind { span, .. } => *span,
        }
    }

    /// A way out, where one is known.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Syntax { .. } => None,
            Self::Kind { key, expected, .. } => Some(format!("give `{key}` as {expected}")),
            Self::Blank { key, .. } => Some(format!("write the {key} between the quotes")),
            Self::Missing { table, key, .. } => Some(format!("add `{key}` to {}", called(table))),
            Self::Unknown {
                key,
                is_of_file: true,
                ..
            } => Some(format!(
                "`{key}` is a key of the whole file: move it above the first `[header]`, for what stands below a header belongs to that"
            )),
            Self::Unknown { key, known, .. } => Some(match meant(key, known) {
                Some(name) => format!("did you mean `{name}`?"),
                None => format!("the keys are {}", known.join(", ")),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_known_by_their_letters_and_by_what_they_are_called_elsewhere() {
        let blueprint = ["seed", "students", "variants"];
        assert_eq!(meant("student", &blueprint), Some("students"));
        assert_eq!(meant("class", &blueprint), Some("students"));
        assert_eq!(meant("class", &["seed"]), None);
    }
}
