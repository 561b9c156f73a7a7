//! How far a number may be from the key.
//!
//! A tolerance is a share (`2 %`), a share of another quantity (`1 % of omega2`), a number with a unit
//! (`0.05 rad`), a figure (`3 sf`: half a unit of the third significant figure of the key), or several
//! of these joined by commas, of which the widest counts. Where an item states none, it follows from
//! the working precision and the conditioning of the answer:
//!
//! ```text
//! half-width = 0.005 · 10^(3−s) · ( |y| + Σ |z ∂y/∂z| )     over the steps z between data and answer y,
//! ```
//!
//! with s the significant figures that are asked for, so that honest work with every intermediate result
//! rounded to s figures passes. Nothing narrows it: where a known slip lies within it, the data are not handed
//! out. A key that is rounded to these figures is right also where the tolerance is stated. There is no hidden
//! absolute floor.

use super::{AnswerError, Declare};
use crate::expr::Expr;
use crate::numerics::Rational;
use crate::quantity::{Evaluation, NodeId};
use crate::source::{Span, Text};
use crate::unit::{Quantity, Unit};

/// How far a number may be from the key, as declared; empty is derived.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tolerance(Vec<ErrorTerm>);

#[derive(Clone, Debug, PartialEq)]
enum ErrorTerm {
    /// A share of the key, or of another quantity.
    Share(Rational, Option<NodeId>),
    /// A half-width in SI units.
    Width(f64),
    /// Half a unit of this significant figure of the key.
    Figures(u32),
}

impl Tolerance {
    /// Reads a tolerance for a key in `unit`.
    pub(crate) fn read(text: &Text, unit: &Unit, declare: &mut dyn Declare) -> Option<Self> {
        let mut terms = Vec::new();
        let mut start = 0;
        for piece in text.value.split(',') {
            let span = Span::new(start, start + piece.len());
            start += piece.len() + 1;
            match term(piece.trim(), unit, declare) {
                Ok(term) => terms.push(term),
                Err(Some(error)) => declare.find(&error, text),
                Err(None) => {
                    declare.find(
                        &AnswerError::Tolerance {
                            found: piece.trim().to_owned(),
                            span,
                        },
                        text,
                    );
                }
            }
        }
        (!terms.is_empty()).then_some(Self(terms))
    }

    /// Whether nothing is declared.
    pub(crate) fn is_derived(&self) -> bool {
        self.0.is_empty()
    }

    /// The half-width around a key, in SI units.
    ///
    /// `spread` is |y| + Σ |z ∂y/∂z| of the key, `figures` the working precision; both serve where
    /// nothing is declared.
    pub(crate) fn half_width(
        &self,
        key: f64,
        spread: impl FnOnce() -> f64,
        figures: u32,
        evaluation: &Evaluation<'_>,
    ) -> f64 {
        if self.0.is_empty() {
            // Half a per cent: the most that rounding to three figures takes, of numbers that begin with 100.
            return 0.005 * power_of_ten(3 - figures as i32) * spread();
        }
        let width = |term: &ErrorTerm| match term {
            ErrorTerm::Share(share, None) => share.to_f64() * key.abs(),
            ErrorTerm::Share(share, Some(of)) => evaluation
                .real(*of)
                .map_or(0.0, |of| share.to_f64() * of.abs()),
            ErrorTerm::Width(width) => *width,
            ErrorTerm::Figures(figures) => half_unit(key, *figures),
        };
        self.0.iter().map(width).fold(0.0, f64::max)
    }
}

/// Half a unit of the given significant figure of a number.
pub(crate) fn half_unit(number: f64, figures: u32) -> f64 {
    if number == 0.0 {
        return 0.0;
    }
    // The printed form knows the decade of a number exactly.
    let Some(rounded) = crate::unit::Decimal::rounded(number, figures) else {
        return 0.0;
    };
    0.5 * rounded.last_place().to_f64()
}

fn power_of_ten(exponent: i32) -> f64 {
    crate::numerics::powi(10.0, exponent)
}

fn term(
    text: &str,
    unit: &Unit,
    declare: &mut dyn Declare,
) -> Result<ErrorTerm, Option<AnswerError>> {
    if let Some(figures) = text.strip_suffix("sf") {
        let figures = figures
            .trim()
            .parse()
            .ok()
            .filter(|figures| (1..=12).contains(figures));
        return figures.map(ErrorTerm::Figures).ok_or(None);
    }
    if let Some((share, of)) = text.split_once('%') {
        let hundredth = Rational::new(1, 100).expect("a fraction");
        let share =
            Rational::from_decimal(share.trim()).and_then(|share| share.checked_mul(hundredth));
        let share = share.filter(|share| !share.is_negative()).ok_or(None)?;
        return match of.trim().strip_prefix("of ") {
            None if of.trim().is_empty() => Ok(ErrorTerm::Share(share, None)),
            None => Err(None),
            Some(name) => {
                let text = Text {
                    value: name.trim().to_owned(),
                    span: Span::NONE,
                };
                if Expr::read(&text.value).is_err() {
                    return Err(None);
                }
                declare
                    .formula("scale of a tolerance", &text)
                    .map(|of| ErrorTerm::Share(share, Some(of)))
                    .ok_or(None)
            }
        };
    }
    let quantity = Quantity::parse(text).map_err(|_| None)?;
    let conversion = quantity.conversion(unit).map_err(|error| {
        Some(AnswerError::Unit {
            expected: error.expected.describe(),
            found: error.found.describe(),
        })
    })?;
    Ok(ErrorTerm::Width(
        conversion.apply_decimal(&quantity.value).abs(),
    ))
}
