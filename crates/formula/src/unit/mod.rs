//! Dimensions, units, exact decimals and quantities: their reading, conversion and printing.
//!
//! - A [`Dimension`] says what can be added to what; angles have dimension 1.
//! - A [`Unit`] is a product of table units with rational powers, as it was written, with an exact factor to SI.
//! - A [`Decimal`] is a number as it was written, exact. Data stay decimals from the file to the sheet, so
//!   what the learner reads is exactly what the solver used.
//! - A [`Quantity`] is a decimal with a unit, a [`Range`] two decimals with a unit.
//! - A [`Grid`] holds the values that a parameter can be drawn from.
//! - A [`Conversion`] takes a value from the unit in which it is written to the one in which it is wanted.
//!
//! Conversions are exact until the end and rounded once, also for degrees, revolutions and roots of units.
//!
//! There are two ways to read: `parse` is strict, for files, and `read` is lenient, for what people type.
//! Neither guesses: what has more than one meaning is an [`Error`] with its place, and what was
//! understood can be printed back.
//!
//! # Angles and cycles
//!
//! rad/s, Hz, rev/s, rpm and 1/s have one dimension. A quantity declared in rad/s holds radians per second,
//! one declared in Hz, rev/s or rpm holds cycles per second. Only reading converts, by 2π: see [`Conversion`].
//! Formulas convert nothing.
//!
//! # Examples
//!
//! ```
//! use vibank_formula::unit::{DecimalMark, Decimal, Quantity, Unit};
//!
//! // A student answers in rpm what is declared in rad/s.
//! let declared = Unit::parse("rad/s").unwrap();
//! let typed = Quantity::read("2,4·10^3 rpm", DecimalMark::Point).unwrap();
//! let conversion = typed.conversion(&declared).unwrap();
//! assert!(conversion.applies_two_pi());
//! assert_eq!(conversion.apply_decimal(&typed.value), 80.0 * std::f64::consts::PI);
//!
//! // A computed value is printed in the unit of the answer, with three figures.
//! let unit = Unit::parse("mm").unwrap();
//! let printed = Quantity::new(Decimal::rounded(unit.of_si(0.015), 3).unwrap(), unit);
//! assert_eq!(printed.text(DecimalMark::Point), "15.0 mm");
//! ```

mod conversion;
mod decimal;
mod dimension;
mod error;
mod factor;
mod figures;
mod grid;
mod joined;
mod known;
mod lenient;
mod nearest;
mod notation;
mod number;
mod product;
mod quantity;
mod range;
mod rational;
mod scale;
mod scanner;
mod spoken;
mod strict;
mod table;
mod text;
mod typeset;
mod wide;

pub use conversion::Conversion;
pub use decimal::Decimal;
pub use dimension::Dimension;
pub use error::{DimensionMismatch, Error, ErrorKind};
pub use grid::{Grid, GridError};
pub use known::KnownUnit;
pub use notation::DecimalMark;
pub use product::Unit;
pub use quantity::Quantity;
pub use range::Range;
pub use rational::Rational;

/// What is read and written as text by others, too: the strict form, as files have it.
macro_rules! textual {
    ($($type:ty),+) => {$(
        impl std::str::FromStr for $type {
            type Err = Error;

            fn from_str(text: &str) -> Result<Self, Error> {
                Self::parse(text)
            }
        }

        impl From<$type> for String {
            fn from(value: $type) -> Self {
                value.to_string()
            }
        }

        impl TryFrom<String> for $type {
            type Error = Error;

            fn try_from(text: String) -> Result<Self, Error> {
                Self::parse(&text)
            }
        }
    )+};
}

textual!(Decimal, Dimension, Unit, Quantity, Range);
