//! How a command ends.

use std::fmt;
use std::process::ExitCode;

use super::shown::shown;

/// A command that ran to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Nothing to complain about.
    Done,
    /// Findings, or wrong answers.
    Findings,
    /// All but what a press would have printed.
    Unprinted,
}

/// A command that could not run: what is wrong and how to mend it.
#[derive(Debug)]
pub(crate) struct Failure {
    message: String,
    help: Option<String>,
}

impl Failure {
    /// A failure with this message: lower case, no full stop.
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            help: None,
        }
    }

    /// What an error of the library says.
    pub(crate) fn of(error: impl fmt::Display) -> Self {
        Self::new(error.to_string())
    }

    /// A format that nothing is written in; beside those of pages there may be others.
    pub(crate) fn unknown_format(name: &str, others: &[&str]) -> Self {
        let pages = vibank::output::WRITERS.iter().map(|writer| writer.name());
        let known: Vec<&str> = pages.chain(others.iter().copied()).collect();
        Self::new(format!("`{name}` is not a format here"))
            .help(format!("the formats are {}", known.join(", ")))
    }

    /// The way out, an imperative.
    #[must_use]
    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        Self::from(match outcome {
            Outcome::Done => 0,
            Outcome::Findings => 1,
            Outcome::Unprinted => 3,
        })
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "error: {}", shown(&self.message))?;
        match &self.help {
            Some(help) => writeln!(formatter, "help: {}", shown(help)),
            None => Ok(()),
        }
    }
}
