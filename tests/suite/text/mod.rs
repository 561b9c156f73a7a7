//! Texts and formulas: read, written, read again.

mod corpus;
mod documents;
mod hostile;
