//! The values of bounds.

use std::cell::Cell;

use super::read::{Read, like_interval};
use super::set::End;
use super::{Setup, Written, compared, is_infinite};
use crate::answer::numeric;
use crate::answer::{Example, Misfit, Unreadable, Why};
use crate::expr::{Expr, Kind, Precise, Workspace};
use crate::numerics::SortedMap;
use crate::response::{Manner, Passage};
use crate::unit::{DecimalMark, Quantity, Unit};

/// Reads the ends of sets for an instance.
pub(crate) struct Ends<'a> {
    pub(crate) setup: &'a Setup,
    pub(crate) data: &'a [Precise],
    pub(crate) mark: DecimalMark,
    /// Whether numbers that may be meant otherwise are, `1,250` as a decimal or in thousands.
    pub(crate) is_otherwise: bool,
    /// Which ends are left out where words do not say, `from 0.2 to 0.5`.
    pub(crate) open: [bool; 2],
    /// Whether a number may be meant otherwise; noted while a set is read.
    pub(crate) is_doubtful: Cell<bool>,
    /// Whether words do not say which ends are left out, and it counts; noted likewise.
    pub(crate) is_unsaid: Cell<bool>,
}

impl Ends<'_> {
    /// An end of an interval.
    pub(crate) fn end(
        &self,
        side: Passage<'_>,
        is_open: bool,
        unit: &mut Option<Unit>,
    ) -> Read<End> {
        let value = self.side(side, unit)?;
        let is_open = is_open || !value.is_finite();
        Ok(End { value, is_open })
    }

    /// The unit that comes after a bracket.
    pub(crate) fn unit_behind(&self, unit: Passage<'_>) -> Read<Unit> {
        let one = unit.one_of_unit();
        // A unit of another dimension is reported as that of a bound is.
        self.number(one.passage(), &mut None)?;
        let one = self
            .quantity(one.passage())
            .filter(|one| !one.unit.is_one());
        let one = one.ok_or_else(|| Unreadable::at(unit, Why::NoUnit).like(Example::Interval))?;
        Ok(one.unit)
    }

    /// Which ends are left out, by what is said or by what this reading takes for meant.
    pub(crate) fn said_open(&self, open: Option<[bool; 2]>) -> [bool; 2] {
        if open.is_none() && self.setup.is_strict {
            self.is_unsaid.set(true);
        }
        open.unwrap_or(self.open)
    }

    /// The value of a bound in SI units; of `√(2km) = 7.9` that which is asked for, if both are the same.
    fn side(&self, side: Passage<'_>, unit: &mut Option<Unit>) -> Read<f64> {
        /// Two values that were each rounded to three figures differ by no more.
        const SHARE: f64 = 0.01;
        let forms = side.statement();
        let [first, .., last] = &forms[..] else {
            return self.one_side(side, unit);
        };
        if self.setup.written == Written::Formula {
            return self.one_side(*first, unit);
        }
        let value = self.one_side(*last, unit)?;
        for form in &forms[..forms.len() - 1] {
            // `x_b = 3 m` names the bound.
            let own = match self.one_side(*form, &mut { *unit }) {
                Err(_) if form.is_symbol() => continue,
                own => own?,
            };
            if (own - value).abs() > SHARE * own.abs().max(value.abs()) {
                return Err(Why::UnequalSides(form.short(), last.short()).into());
            }
        }
        Ok(value)
    }

    fn one_side(&self, side: Passage<'_>, unit: &mut Option<Unit>) -> Read<f64> {
        let number = self.number(side, unit);
        // Of `√(2km)` the letters could be a unit, kilometres, that does not fit.
        let is_formula = number.is_err() && self.fits_in_letters(side);
        if !is_formula && let Some(number) = number? {
            return match self.setup.written {
                Written::Formula => Err(Why::BoundsAsFormulas.into()),
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
            return Err(like_interval(Why::SolveFor(symbol)).into());
        }
        let found = expr
            .check(&self.setup.meaning)
            .map_err(|errors| Unreadable::at(side, Why::Dimension(errors.first().cloned())))?;
        let has_names = !expr.names().free.is_empty();
        if self.setup.written == Written::Number && has_names {
            return Err(Why::BoundsAsNumbers.into());
        }
        if has_names && !found.fits(&compared(self.setup)) {
            return Err(Misfit::Bound {
                typed: side.into(),
                read: self.setup.lexicon.written(&expr),
                symbol,
            }
            .into());
        }
        let value = self.value(&expr);
        let value = value.ok_or_else(|| Unreadable::at(side, Why::BoundValue))?;
        Ok(if has_names {
            value
        } else {
            unit.unwrap_or(self.setup.unit).to_si(value)
        })
    }

    /// Whether a bound is a formula with letters of the question that has the dimension of what is asked.
    fn fits_in_letters(&self, side: Passage<'_>) -> bool {
        self.formula(side).is_ok_and(|expr| {
            let found = expr.check(&self.setup.meaning);
            !expr.names().free.is_empty()
                && found.is_ok_and(|found| found.fits(&compared(self.setup)))
        })
    }

    /// The number that a bound is in SI units, if it is one; without a unit it has the one at hand.
    pub(crate) fn number(&self, side: Passage<'_>, unit: &mut Option<Unit>) -> Read<Option<f64>> {
        let Some(number) = self.quantity(side) else {
            return Ok(None);
        };
        let asked = self.setup.unit;
        if number.unit.is_one() {
            let taken = Quantity::new(number.value, unit.unwrap_or(asked));
            return Ok(Some(taken.si()));
        }
        let Ok(si) = number.si_for(&asked) else {
            return Err(Misfit::BoundUnit {
                symbol: self.setup.symbol.plain(),
                typed: number.unit,
                asked,
            }
            .into());
        };
        *unit = Some(number.unit);
        Ok(Some(si))
    }

    /// A quantity, if a side is one.
    fn quantity(&self, side: Passage<'_>) -> Option<Quantity> {
        let (first, others) = numeric::readings(side, self.mark).ok()?;
        if !others.is_empty() {
            self.is_doubtful.set(true);
        }
        let other = others.into_iter().next().filter(|_| self.is_otherwise);
        Some(other.unwrap_or(first))
    }

    pub(crate) fn formula(&self, side: Passage<'_>) -> Result<Expr, Unreadable> {
        side.formula(&self.setup.lexicon, Manner::REAL)
            .map(|typed| typed.value)
            .map_err(|error| Unreadable::typed(&error, side))
    }

    /// The value of a formula in SI units.
    pub(crate) fn value(&self, formula: &Expr) -> Option<f64> {
        let program = self
            .setup
            .meaning
            .compile(formula, &SortedMap::new())
            .ok()?;
        program
            .evaluate(self.data, &mut Workspace::default())
            .ok()?
            .as_real()
    }
}
