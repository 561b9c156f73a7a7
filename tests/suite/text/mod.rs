//! Texts and formulas: read, written, read again.

mod corpus;
mod decimals;
mod documents;
mod hostile;
