//! Double-double numbers: an unevaluated sum of two `f64`, about 106 bits.
//!
//! They form the small differences on which everything else depends, carry the phases of long motions, and evaluate a
//! formula again where its error bound is too wide. Arithmetic errors are a few u², with u² = 1.2e-32; the elementary
//! functions keep relative errors of about 1e-31 for any argument, also next to their zeros.
//!
//! # References
//!
//! M. Joldes, J.-M. Muller, V. Popescu, ACM TOMS 44:15 (2017).

mod arithmetic;
mod circular;
mod constants;
mod exponential;
mod hyperbolic;
mod reduction;

use std::cmp::Ordering;

use super::elementary::scale_by_power_of_two;
use super::exact::{fast_two_sum, two_prod, two_sum};

/// A number of about 106 bits: the exact sum of two `f64`, the first of which is that sum rounded.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::Dd;
///
/// let third = Dd::from(1.0) / 3.0;
/// assert_eq!(f64::from(third), 1.0 / 3.0);
/// assert!((third * 3.0 - 1.0).abs() < Dd::from(1e-31));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dd {
    hi: f64,
    lo: f64,
}

impl Dd {
    /// Zero.
    pub const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    /// Unity, exactly.
    pub const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    /// Not a number.
    pub const NAN: Self = Self {
        hi: f64::NAN,
        lo: 0.0,
    };

    /// The exact sum of two numbers.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        Self::of(two_sum(a, b))
    }

    /// The exact product of two numbers, barring over- and underflow.
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        Self::of(two_prod(a, b))
    }

    /// The quotient of two numbers.
    #[inline]
    pub fn quotient(a: f64, b: f64) -> Self {
        Self::from(a) / b
    }

    /// The integer `n`, exactly.
    #[inline]
    pub fn from_integer(n: i64) -> Self {
        // Halves of 32 bits are exact in binary64; a conversion of all 64 would round.
        let high = (n >> 32) as f64 * 4_294_967_296.0;
        Self::sum(high, (n & 0xffff_ffff) as f64)
    }

    /// A pair whose second member is below half an ulp of the first, by bits.
    const fn from_bits(hi: u64, lo: u64) -> Self {
        Self {
            hi: f64::from_bits(hi),
            lo: f64::from_bits(lo),
        }
    }

    /// A rounded result and its error; the error of a result that is not finite is dropped.
    #[inline]
    fn of((hi, lo): (f64, f64)) -> Self {
        if hi.is_finite() {
            Self { hi, lo }
        } else {
            Self { hi, lo: 0.0 }
        }
    }

    /// Sum of a leading part and a correction below it.
    #[inline]
    fn normalized(hi: f64, lo: f64) -> Self {
        Self::of(fast_two_sum(hi, lo))
    }

    /// The same where the caller looks after results that are not finite.
    #[inline]
    fn fast_sum(hi: f64, lo: f64) -> Self {
        let (hi, lo) = fast_two_sum(hi, lo);
        Self { hi, lo }
    }

    /// The nearest `f64`.
    #[inline]
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// What the nearest `f64` leaves.
    #[inline]
    pub const fn lo(self) -> f64 {
        self.lo
    }

    /// Whether the number is neither infinite nor NaN.
    #[inline]
    pub const fn is_finite(self) -> bool {
        self.hi.is_finite()
    }

    /// Whether this is not a number.
    #[inline]
    pub const fn is_nan(self) -> bool {
        self.hi.is_nan()
    }

    /// Whether the number is below zero.
    #[inline]
    pub fn is_negative(self) -> bool {
        self.hi < 0.0
    }

    /// Magnitude.
    #[inline]
    #[must_use]
    pub fn abs(self) -> Self {
        if self.hi.is_sign_negative() {
            -self
        } else {
            self
        }
    }

    /// The square, rounded to double-double.
    #[inline]
    #[must_use]
    pub fn square(self) -> Self {
        self * self
    }

    /// Reciprocal.
    #[inline]
    #[must_use]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// Square root; NaN below zero.
    #[must_use]
    pub fn sqrt(self) -> Self {
        // The error of the square of the root, down to 2^-106 of it, has to stay above the smallest number of
        // binary64.
        const TINY: f64 = 1e-280;
        if self.hi > 0.0 && self.hi < TINY {
            return self.scale(256).sqrt().scale(-128);
        }
        let root = self.hi.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::from(root);
        }
        // The quotient does not wait for the product.
        let half_reciprocal = 0.5 / root;
        let (square, error) = two_prod(root, root);
        Self::normalized(
            root,
            ((self.hi - square) - error + self.lo) * half_reciprocal,
        )
    }

    /// Number times 2^n, exactly barring over- and underflow.
    #[must_use]
    pub fn scale(self, n: i32) -> Self {
        Self::of((
            scale_by_power_of_two(self.hi, n),
            scale_by_power_of_two(self.lo, n),
        ))
    }

    /// Largest integer that is not above the number.
    #[must_use]
    pub fn floor(self) -> Self {
        let high = self.hi.floor();
        if high == self.hi {
            Self::normalized(high, self.lo.floor())
        } else {
            Self::from(high)
        }
    }

    /// Smallest integer that is not below the number.
    #[must_use]
    pub fn ceil(self) -> Self {
        -(-self).floor()
    }

    /// Nearest integer, halves upwards.
    #[must_use]
    pub fn round(self) -> Self {
        (self + 0.5).floor()
    }
}

impl From<f64> for Dd {
    #[inline]
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl From<Dd> for f64 {
    #[inline]
    fn from(x: Dd) -> Self {
        x.hi
    }
}

impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            order => order,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_looks_at_both_parts() {
        let above = Dd::sum(1.0, 1e-20);
        assert!(above > Dd::ONE);
        assert!(-above < -Dd::ONE);
        assert!(Dd::NAN.partial_cmp(&Dd::ONE).is_none());
    }

    #[test]
    fn rounding_looks_at_both_parts() {
        assert_eq!(Dd::sum(5.0, -1e-20).floor(), Dd::from(4.0));
        assert_eq!(Dd::sum(5.0, 1e-20).ceil(), Dd::from(6.0));
        assert_eq!(Dd::sum(1e17, 2.5).round(), Dd::sum(1e17, 3.0));
    }

    #[test]
    fn square_roots_hold_at_the_ends_of_the_exponent_range() {
        for x in [2e-308, 3e-200, 2.0, 1e300, 1.7e308] {
            let root = Dd::from(x).sqrt();
            assert!(
                (root.square().scale(-2) - Dd::from(x).scale(-2)).abs() <= Dd::from(x * 1e-31),
                "{x}"
            );
        }
        assert_eq!(Dd::ZERO.sqrt(), Dd::ZERO);
        assert!(Dd::from(-1.0).sqrt().is_nan());
        assert_eq!(Dd::from(f64::INFINITY).sqrt().hi(), f64::INFINITY);
    }

    #[test]
    fn integers_are_exact() {
        let n = i64::MAX;
        assert_eq!(
            Dd::from_integer(n),
            Dd::sum(9_223_372_036_854_775_808.0, -1.0)
        );
        assert_eq!(Dd::from_integer(-3), Dd::from(-3.0));
    }
}
