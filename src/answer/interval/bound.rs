//! The values of bounds.

use std::collections::BTreeMap;

use super::read::{Ends, HELP, Read, Refusal};
use super::{Written, compared, is_infinite};
use crate::answer::numeric;
use crate::expr::{Expr, Kind, Workspace};
use crate::response::{self, Manner};
use crate::unit::{DecimalMark, Quantity, Unit};

impl Ends<'_> {
    /// The value of a bound in SI units.
    pub(super) fn side(&self, side: &str, unit: &mut Option<Unit>) -> Read<f64> {
        if let Some(number) = self.number(side, unit)? {
            return match self.setup.written {
                Written::Formula => {
                    Err("Give the bounds as formulas in symbols.".to_owned().into())
                }
                _ => Ok(number),
            };
        }
        let expr = self.formula(side)?;
        if is_infinite(&expr) {
            let is_negative = !matches!(expr.kind(), Kind::Constant(_));
            return Ok(if is_negative {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            });
        }
        let symbol = self.setup.symbol.plain();
        if expr.names().uses(&self.setup.variable) {
            return Err(format!("Solve for `{symbol}` first. {HELP}").into());
        }
        let found = expr.check(&self.setup.meaning).map_err(|errors| {
            let first = errors.first();
            first.map_or(HELP.to_owned(), |error| format!("At `{side}`: {error}."))
        })?;
        let has_names = !expr.names().free.is_empty();
        if self.setup.written == Written::Number && has_names {
            return Err("Give the bounds as numbers.".to_owned().into());
        }
        if has_names && !found.fits(&compared(self.setup)) {
            return Err(Refusal::Dimension(format!(
                "`{side}`, read as `{expr}`, has another dimension than `{symbol}`."
            )));
        }
        let value = self.value(&expr);
        let value = value.ok_or_else(|| format!("At `{side}`: this has no value."))?;
        Ok(if has_names {
            value
        } else {
            unit.unwrap_or(self.setup.unit).to_si(value)
        })
    }

    /// The number that a bound is in SI units, if it is one; without a unit it has the one at hand.
    pub(super) fn number(&self, text: &str, unit: &mut Option<Unit>) -> Read<Option<f64>> {
        let Some(number) = quantity(text, self.mark) else {
            return Ok(None);
        };
        let asked = self.setup.unit;
        if number.unit.is_one() {
            let taken = Quantity::new(number.value, unit.unwrap_or(asked));
            return Ok(Some(taken.si()));
        }
        let Ok(si) = number.si_for(&asked) else {
            let (symbol, found) = (self.setup.symbol.plain(), number.unit.text());
            let due = if asked.is_one() {
                "a pure number".to_owned()
            } else {
                format!("in {}", asked.text())
            };
            return Err(Refusal::Dimension(format!(
                "The unit {found} does not fit: `{symbol}` is {due}."
            )));
        };
        *unit = Some(number.unit);
        Ok(Some(si))
    }

    pub(super) fn formula(&self, side: &str) -> Result<Expr, String> {
        let manner = Manner {
            comma_is_decimal: true,
            has_imaginary_unit: false,
        };
        response::formula(side, &self.setup.lexicon, manner)
            .map(|typed| typed.value)
            .map_err(|error| error.sentence(side))
    }

    /// The value of a formula in SI units.
    pub(super) fn value(&self, formula: &Expr) -> Option<f64> {
        let program = self.setup.meaning.compile(formula, &BTreeMap::new()).ok()?;
        program
            .evaluate(self.data, &mut Workspace::default())
            .ok()?
            .as_real()
    }
}

/// A quantity, if a text is one.
pub(super) fn quantity(text: &str, mark: DecimalMark) -> Option<Quantity> {
    numeric::quantity(text, mark).ok()
}
