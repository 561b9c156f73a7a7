//! Texts and formulas: read, written, read again.

mod corpus;
pub(crate) mod decimals;
mod documents;
mod hostile;
