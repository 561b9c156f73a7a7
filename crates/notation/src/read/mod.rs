//! LaTeX read into trees.
//!
//! A formula is looked over ([`check`]), parsed, folded ([`tex`]) and brought into its one form ([`tidy`]). The
//! characters of [`holes`] stand for what is not LaTeX.

mod check;
mod error;
pub mod holes;
mod tex;
mod tidy;

pub use check::faults;
pub use error::LatexError;
pub use tex::{read_all, read_latex};
