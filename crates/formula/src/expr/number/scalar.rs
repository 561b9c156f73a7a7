//! The numbers over which a program runs.

use std::cmp::Ordering;

use super::{Precise, Undefined};
use crate::expr::Function;

/// A number over which a program of a formula runs.
///
/// Implemented by [`Approx`](super::Approx) over binary64 and double-double numbers; numbers that carry derivatives
/// can implement it as well. Truth is the number 1, falsehood 0; complex numbers are pairs, matrices lists of entries.
///
/// An operation without a value says why. One that takes a decision (a comparison, a rounding) notes in [`Doubt`]
/// whether more digits could change it.
pub trait Scalar: Clone {
    /// Bound on the relative error of one arithmetic operation.
    const ROUNDOFF: f64;

    /// Whether programs with searches, for roots and integrals, are run over it.
    const SEARCHES: bool = true;

    /// The number with these digits.
    fn of(precise: &Precise) -> Self;

    /// The sum.
    #[must_use]
    fn add(&self, other: &Self) -> Self;

    /// The difference.
    #[must_use]
    fn subtract(&self, other: &Self) -> Self;

    /// The product.
    #[must_use]
    fn multiply(&self, other: &Self) -> Self;

    /// The quotient.
    ///
    /// # Errors
    ///
    /// [`Undefined::DivisionByZero`], also where the divisor cannot be told from zero.
    fn divide(&self, other: &Self) -> Result<Self, Undefined>;

    /// The opposite.
    #[must_use]
    fn negate(&self) -> Self;

    /// The power with a whole exponent.
    ///
    /// # Errors
    ///
    /// [`Undefined::DivisionByZero`] for a negative power of zero.
    fn power_whole(&self, exponent: i32) -> Result<Self, Undefined>;

    /// The power; that of a negative number needs a whole exponent.
    ///
    /// # Errors
    ///
    /// [`Undefined::PowerOfNegative`], [`Undefined::DivisionByZero`].
    fn power(&self, exponent: &Self, doubt: &mut Doubt) -> Result<Self, Undefined>;

    /// A real function of one number.
    ///
    /// # Errors
    ///
    /// Why the function has no value there.
    fn unary(&self, function: Function, doubt: &mut Doubt) -> Result<Self, Undefined>;

    /// A real function of two numbers: `atan2`, `hypot`, `mod`, `min`, `max`.
    ///
    /// # Errors
    ///
    /// Why the function has no value there.
    fn binary(
        &self,
        function: Function,
        other: &Self,
        doubt: &mut Doubt,
    ) -> Result<Self, Undefined>;

    /// How two numbers compare; those within their bounds are equal.
    fn compare(&self, other: &Self, doubt: &mut Doubt) -> Ordering;

    /// The number rounded to binary64.
    fn to_f64(&self) -> f64;

    /// Bound on the error of the number.
    fn bound(&self) -> f64;

    /// The same number with a larger bound on its error.
    #[must_use]
    fn widened(&self, more: f64) -> Self;

    /// The same number taken as it is, without error.
    #[must_use]
    fn centre(&self) -> Self;

    /// A number that is exactly a binary64.
    #[must_use]
    fn exact(value: f64) -> Self {
        Self::of(&Precise::exact(value))
    }
}

/// Whether a decision was taken that more digits could change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Doubt {
    /// Whether there was one.
    pub is_open: bool,
}

impl Doubt {
    /// Notes a decision among numbers whose bounds add up to `bound`: only exact numbers leave no doubt.
    #[inline]
    pub fn note(&mut self, bound: f64) {
        self.is_open |= bound > 0.0;
    }
}
