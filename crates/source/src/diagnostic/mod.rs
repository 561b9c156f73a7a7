//! Findings: what is wrong with a file, where, and what to do about it.
//!
//! Each module has its own error types; they say through [`Diagnose`] which code they bear, what to
//! point at and how to mend it, and become a [`Finding`] in the file in which they occurred.
//! Drawing a finding with its source lines belongs to the command line.
//! Every code has an explanation in the [`codes`] table, which `vibank explain` and the book print.

pub mod codes;
mod finding;

pub use codes::Code;
pub use finding::{Diagnose, Finding, Label, Severity};
