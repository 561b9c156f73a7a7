//! The factors of a unit, and the list of them while a unit is put together.

use super::error::ErrorKind;
use super::product::Unit;
use super::rational::Rational;
use super::scale::Scale;
use super::table::{Found, Prefix, ROWS, UnitRow, prefix};

/// The most factors that a unit may have.
pub(crate) const MAX_FACTORS: usize = 8;

/// One factor of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Factor {
    pub(crate) row: u8,
    pub(crate) prefix: i8,
    /// Whether it stands below the slash; then its power is negative.
    pub(crate) below: bool,
    pub(crate) power: Rational,
}

impl Factor {
    pub(crate) const NONE: Self = Self {
        row: 0,
        prefix: 0,
        below: false,
        power: Rational::ZERO,
    };

    pub(crate) fn new(found: Found, power: Rational) -> Self {
        Self {
            row: found.row,
            prefix: found.prefix,
            below: false,
            power,
        }
    }

    pub(crate) fn row(self) -> &'static UnitRow {
        &ROWS[usize::from(self.row)]
    }

    pub(crate) fn prefix(self) -> Option<&'static Prefix> {
        prefix(self.prefix)
    }

    pub(crate) fn scale(self) -> Option<Scale> {
        Scale::ten(i32::from(self.prefix))
            .times(self.row().scale)
            .pow(self.power)
    }
}

/// A unit that is being put together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Builder {
    factors: [Factor; MAX_FACTORS],
    length: usize,
}

impl Builder {
    /// Nothing yet.
    pub(crate) const fn new() -> Self {
        Self {
            factors: [Factor::NONE; MAX_FACTORS],
            length: 0,
        }
    }

    /// With the factors of a finished unit.
    pub(crate) fn of(known: &[Factor]) -> Self {
        let mut builder = Self::new();
        builder.length = known.len().min(MAX_FACTORS);
        builder.factors[..builder.length].copy_from_slice(&known[..builder.length]);
        builder
    }

    /// How many factors there are.
    pub(crate) fn len(&self) -> usize {
        self.length
    }

    pub(crate) fn push(&mut self, factor: Factor) -> Result<(), ErrorKind> {
        let place = self
            .factors
            .get_mut(self.length)
            .ok_or(ErrorKind::TooManyFactors { limit: MAX_FACTORS })?;
        *place = factor;
        self.length += 1;
        Ok(())
    }

    /// Whether two factors are of one unit with one power.
    pub(crate) fn are_equal(&self, first: usize, second: usize) -> bool {
        let known = &self.factors[..self.length];
        known.get(first).is_some() && known.get(first) == known.get(second)
    }

    /// Whether the last factor is a sign such as `°`, after which no power stands.
    pub(crate) fn ends_with_sign(&self) -> bool {
        let last = self.factors[..self.length].last();
        last.is_some_and(|last| ["°", "′", "″", "%", "‰"].contains(&last.row().print))
    }

    /// The factors from the place `start` on.
    pub(crate) fn since(&mut self, start: usize) -> &mut [Factor] {
        &mut self.factors[start..self.length]
    }

    /// Raises the factors from `start` on to a power.
    pub(crate) fn raise(&mut self, start: usize, power: Rational) -> Result<(), ErrorKind> {
        for factor in self.since(start) {
            factor.power = factor
                .power
                .checked_mul(power)
                .ok_or(ErrorKind::NotAnExponent)?;
        }
        Ok(())
    }

    /// Moves the factors from `start` on to the other side of the slash.
    pub(crate) fn divide(&mut self, start: usize) {
        for factor in self.since(start) {
            factor.power = factor.power.negated();
            factor.below = !factor.below;
        }
    }

    /// The finished unit, unless an exponent is too large or too odd.
    pub(crate) fn finish(self) -> Result<Unit, ErrorKind> {
        Unit::of_factors(&self.factors[..self.length]).ok_or(ErrorKind::NotAnExponent)
    }
}
