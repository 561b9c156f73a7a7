//! Ranges: two decimals in one unit.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::decimal::Decimal;
use super::error::{Error, ErrorKind};
use super::product::Unit;
use super::quantity::{Quantity, strict_number};
use super::scanner::Scanner;
use super::strict;

/// A range of values in one unit, `0.5 .. 5 kg`.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Range;
///
/// let range = Range::parse("0.5 .. 5 kg").unwrap();
/// assert_eq!((range.lo().si(), range.hi().si()), (0.5, 5.0));
/// assert_eq!(range.to_string(), "0.5 .. 5 kg");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Range {
    lo: Decimal,
    hi: Decimal,
    unit: Unit,
}

impl Range {
    /// Reads a range as it is written in files; the unit stands at the end.
    ///
    /// # Errors
    ///
    /// If it is not a range, or its end comes before its beginning.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let mut scanner = Scanner::new(text)?;
        scanner.space();
        let start = scanner.at();
        let lo = strict_number(&mut scanner)?;
        scanner.space();
        if !scanner.takes_text("..") {
            return Err(Error::new(ErrorKind::NotARange, scanner.at()..text.len()));
        }
        scanner.space();
        let hi = strict_number(&mut scanner)?;
        let end = scanner.at();
        scanner.space();
        let unit = if scanner.is_at_end() {
            Unit::ONE
        } else {
            strict::rest(scanner)?
        };
        if hi < lo {
            return Err(Error::new(ErrorKind::EmptyRange, start..end));
        }
        let range = Self { lo, hi, unit };
        range.lo().checked(text)?;
        range.hi().checked(text)?;
        Ok(range)
    }

    /// The lower bound.
    pub const fn lo(&self) -> Quantity {
        Quantity::new(self.lo, self.unit)
    }

    /// The upper bound.
    pub const fn hi(&self) -> Quantity {
        Quantity::new(self.hi, self.unit)
    }

    /// The unit after the second number, which counts for both.
    pub const fn unit(&self) -> Unit {
        self.unit
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} .. {}", self.lo, self.hi())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn ranges() {
        for (text, printed) in [
            ("0.5 .. 5 kg", "0.5 .. 5 kg"),
            ("-1..1", "-1 .. 1"),
            ("0 .. 90 deg", "0 .. 90 deg"),
        ] {
            assert_eq!(Range::parse(text).unwrap().to_string(), printed);
        }
        for (text, place) in [
            ("5", ""),
            ("5 kg", "kg"),
            ("5 .. 1 kg", "5 .. 1"),
            ("1 .. x", "x"),
            ("1 .. 2 foo", "foo"),
        ] {
            let error = Range::parse(text).unwrap_err();
            assert_eq!(&text[error.span.clone()], place, "`{text}`: {error}");
        }
    }

    proptest! {
        #[test]
        fn any_text_is_read_or_refused_in_place(text in "-?[0-9]{0,3} ?[.]{0,3} ?[0-9]{0,3} ?[a-zµ]{0,3}") {
            if let Err(error) = Range::parse(&text) {
                prop_assert!(text.get(error.span).is_some());
            }
        }
    }
}
