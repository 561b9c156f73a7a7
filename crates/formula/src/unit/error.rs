//! What can be wrong with a number, a unit or a quantity that somebody wrote.

use std::ops::Range;

use thiserror::Error;

use super::dimension::Dimension;
use super::nearest::nearest;

/// A text that could not be read: what is wrong, and where.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::{ErrorKind, Unit};
///
/// let error = Unit::parse("N m/rad s").unwrap_err();
/// assert_eq!(error.kind, ErrorKind::ProductAfterSlash);
/// assert_eq!(&"N m/rad s"[error.span.clone()], "s");
/// assert_eq!(error.help().unwrap(), "put the divisor in parentheses, `N/(m s)`, or before the slash, `N s/m`");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{kind}")]
pub struct Error {
    /// What is wrong.
    pub kind: ErrorKind,
    /// The bytes of the text that it is about.
    pub span: Range<usize>,
}

/// What is wrong with a text that should be a number, a unit or a quantity.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// There is nothing.
    #[error("nothing is written")]
    Empty,
    /// More text than any quantity needs.
    #[error("more than {limit} bytes")]
    TooLong {
        /// The largest length.
        limit: usize,
    },
    /// A number was expected.
    #[error("a number is missing")]
    NumberMissing,
    /// Digits must stand on both sides of the decimal point.
    #[error("`{found}` is not a number")]
    NotANumber {
        /// What is written.
        found: String,
    },
    /// More digits than are kept exactly.
    #[error("more than {limit} significant digits")]
    TooManyDigits {
        /// How many are kept.
        limit: u32,
    },
    /// Too large or too small to calculate with.
    #[error("the value is out of range")]
    OutOfRange,
    /// A comma that may separate decimals or thousands.
    #[error("the comma in `{found}` may separate decimals or thousands")]
    AmbiguousComma {
        /// The number.
        found: String,
    },
    /// A unit that is not in the table.
    #[error("`{found}` is not a known unit")]
    UnknownUnit {
        /// What is written.
        found: String,
    },
    /// A run of letters with more than one meaning.
    #[error("`{found}` has more than one meaning")]
    AmbiguousUnit {
        /// What is written.
        found: String,
        /// One of its meanings.
        one: String,
        /// Another one.
        other: String,
    },
    /// A slash after a slash.
    #[error("a second slash")]
    SecondSlash,
    /// A product after a slash, which may belong above or below it.
    #[error("a product after a slash may belong above or below it")]
    ProductAfterSlash,
    /// A number where a unit was expected.
    #[error("a number does not belong into a unit")]
    NumberWithinUnit,
    /// A factor was expected.
    #[error("a unit is missing")]
    UnitMissing,
    /// An exponent was expected, or it is not a small fraction.
    #[error("not an exponent")]
    NotAnExponent,
    /// More factors than any unit needs.
    #[error("more than {limit} factors")]
    TooManyFactors {
        /// The largest number of factors.
        limit: usize,
    },
    /// A parenthesis without its partner.
    #[error("a parenthesis without its partner")]
    Parenthesis,
    /// Something that does not belong here.
    #[error("`{found}` does not belong here")]
    Unexpected {
        /// The character.
        found: char,
    },
    /// No range `lo .. hi unit`.
    #[error("not a range")]
    NotARange,
    /// A range that ends before it begins.
    #[error("the range ends before it begins")]
    EmptyRange,
}

impl Error {
    pub(crate) fn new(kind: ErrorKind, span: Range<usize>) -> Self {
        Self { kind, span }
    }

    /// The same error in a text that begins `offset` bytes further on.
    #[must_use]
    pub fn shifted(self, offset: usize) -> Self {
        Self {
            kind: self.kind,
            span: self.span.start + offset..self.span.end + offset,
        }
    }

    /// What to do about it, as an imperative.
    pub fn help(&self) -> Option<String> {
        let text = match &self.kind {
            // Only whoever is shown the error wants to know: readers try many a text that is not a unit.
            ErrorKind::UnknownUnit { found } => {
                return nearest(found).map(|nearest| format!("write `{nearest}`"));
            }
            ErrorKind::AmbiguousUnit { one, other, .. } => {
                return Some(format!("write `{one}` or `{other}`"));
            }
            ErrorKind::AmbiguousComma { found } => {
                let (decimal, thousand) = (found.replace(',', "."), found.replace(',', ""));
                return Some(format!("write `{decimal}` or `{thousand}`"));
            }
            ErrorKind::SecondSlash => {
                "put the whole divisor in parentheses, `N/(m s)` or `N/(m/s)`"
            }
            ErrorKind::ProductAfterSlash => {
                "put the divisor in parentheses, `N/(m s)`, or before the slash, `N s/m`"
            }
            ErrorKind::NumberWithinUnit => {
                "type one number, and its unit after it, as in `15.8 rad/s`"
            }
            ErrorKind::NotAnExponent => "write a small integer or fraction, `m^2` or `kg^(-1/2)`",
            ErrorKind::NotARange | ErrorKind::EmptyRange => {
                "write `lo .. hi unit`, as in `0.5 .. 5 kg`"
            }
            ErrorKind::NotANumber { .. } | ErrorKind::NumberMissing => {
                "write a decimal, as in `12.5` or `1.6e-2`"
            }
            _ => return None,
        };
        Some(text.to_owned())
    }
}

/// Two quantities that cannot be compared, since one cannot be added to the other.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Unit;
///
/// let error = Unit::parse("N/m").unwrap().conversion(&Unit::parse("N").unwrap()).unwrap_err();
/// assert_eq!(error.to_string(), "`N/m` where `N` is expected");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("`{}` where `{}` is expected", found.describe(), expected.describe())]
pub struct DimensionMismatch {
    /// The dimension of what is written.
    pub found: Dimension,
    /// The dimension of what it is for.
    pub expected: Dimension,
}
