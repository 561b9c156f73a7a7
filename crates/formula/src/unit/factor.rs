//! The factors of a unit, and the list of them while a unit is put together.

use super::error::ErrorKind;
use super::product::Unit;
use super::rational::Rational;
use super::scale::Scale;
use super::table::{Found, Prefix, ROWS, Row, prefix};

/// The most factors that a unit may have.
pub(super) const MAX_FACTORS: usize = 8;

/// One factor of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Factor {
    pub(super) row: u8,
    pub(super) prefix: i8,
    /// Whether it stands below the slash; then its power is negative.
    pub(super) below: bool,
    pub(super) power: Rational,
}

impl Factor {
    pub(super) const NONE: Self = Self {
        row: 0,
        prefix: 0,
        below: false,
        power: Rational::ZERO,
    };

    pub(super) fn new(found: Found, power: Rational) -> Self {
        Self {
            row: found.row,
            prefix: found.prefix,
            below: false,
            power,
        }
    }

    pub(super) fn row(self) -> &'static Row {
        &ROWS[usize::from(self.row)]
    }

    pub(super) fn prefix(self) -> Option<&'static Prefix> {
        prefix(self.prefix)
    }

    pub(super) fn scale(self) -> Option<Scale> {
        Scale::ten(i32::from(self.prefix))
            .times(self.row().scale)
            .pow(self.power)
    }
}

/// A unit that is being put together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Builder {
    factors: [Factor; MAX_FACTORS],
    length: usize,
}

impl Builder {
    /// Nothing yet.
    pub(super) const fn new() -> Self {
        Self {
            factors: [Factor::NONE; MAX_FACTORS],
            length: 0,
        }
    }

    /// With the factors of a finished unit.
    pub(super) fn of(known: &[Factor]) -> Self {
        let mut builder = Self::new();
        builder.length = known.len().min(MAX_FACTORS);
        builder.factors[..builder.length].copy_from_slice(&known[..builder.length]);
        builder
    }

    /// How many factors there are.
    pub(super) fn len(&self) -> usize {
        self.length
    }

    pub(super) fn push(&mut self, factor: Factor) -> Result<(), ErrorKind> {
        let place = self
            .factors
            .get_mut(self.length)
            .ok_or(ErrorKind::TooManyFactors { limit: MAX_FACTORS })?;
        *place = factor;
        self.length += 1;
        Ok(())
    }

    /// Whether two factors are of one unit with one power.
    pub(super) fn are_equal(&self, first: usize, second: usize) -> bool {
        let known = &self.factors[..self.length];
        known.get(first).is_some() && known.get(first) == known.get(second)
    }

    /// Whether the last factor is a sign such as `°`, behind which no power stands.
    pub(super) fn ends_with_sign(&self) -> bool {
        let last = self.factors[..self.length].last();
        last.is_some_and(|last| ["°", "′", "″", "%"].contains(&last.row().print))
    }

    /// The factors from the place `start` on.
    pub(super) fn since(&mut self, start: usize) -> &mut [Factor] {
        &mut self.factors[start..self.length]
    }

    /// Raises the factors from `start` on to a power.
    pub(super) fn raise(&mut self, start: usize, power: Rational) -> Result<(), ErrorKind> {
        for factor in self.since(start) {
            factor.power = factor
                .power
                .checked_mul(power)
                .ok_or(ErrorKind::NotAnExponent)?;
        }
        Ok(())
    }

    /// Moves the factors from `start` on to the other side of the slash.
    pub(super) fn divide(&mut self, start: usize) {
        for factor in self.since(start) {
            factor.power = factor.power.negated();
            factor.below = !factor.below;
        }
    }

    /// The finished unit, unless an exponent is too large or too odd.
    pub(super) fn finish(self) -> Result<Unit, ErrorKind> {
        Unit::of_factors(&self.factors[..self.length]).ok_or(ErrorKind::NotAnExponent)
    }
}
