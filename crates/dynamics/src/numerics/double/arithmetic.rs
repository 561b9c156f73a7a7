//! The four operations, between double-double numbers and with `f64` on either side.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::Dd;
use crate::numerics::exact::{fast_two_sum, two_prod, two_sum};

/// The result, or the plain operation on the leading parts where that is not finite.
#[inline]
fn guarded(result: Dd, plain: impl FnOnce() -> f64) -> Dd {
    if result.hi.is_finite() {
        result
    } else {
        Dd::from(plain())
    }
}

/// From here on a low part keeps all its digits: 2⁻⁹⁶⁸.
const SMALLEST_FULL: f64 = f64::MIN_POSITIVE * 18_014_398_509_481_984.0;

/// A product or a quotient, from the plain operation where that leaves the range of numbers. Where the low part would be
/// rounded to the smallest numbers, and might then move the leading part, all is done with a number that is raised.
#[inline]
fn ranged(result: Dd, plain: impl FnOnce() -> f64, raised: impl FnOnce() -> Dd) -> Dd {
    if (SMALLEST_FULL..f64::INFINITY).contains(&result.hi.abs()) {
        return result;
    }
    let plain = plain();
    // Below this there is no low part.
    if (2.0 * f64::MIN_POSITIVE..SMALLEST_FULL).contains(&plain.abs()) {
        raised()
    } else {
        Dd::from(plain)
    }
}

impl Neg for Dd {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Add for Dd {
    type Output = Self;

    /// `AccurateDWPlusDW`, relative error 3 u².
    #[inline]
    fn add(self, other: Self) -> Self {
        let (high, high_error) = two_sum(self.hi, other.hi);
        let (low, low_error) = two_sum(self.lo, other.lo);
        let (high, correction) = fast_two_sum(high, high_error + low);
        guarded(Self::fast_sum(high, low_error + correction), || {
            self.hi + other.hi
        })
    }
}

impl Add<f64> for Dd {
    type Output = Self;

    /// `DWPlusFP`, relative error 2 u².
    #[inline]
    fn add(self, other: f64) -> Self {
        let (high, error) = two_sum(self.hi, other);
        guarded(Self::fast_sum(high, self.lo + error), || self.hi + other)
    }
}

impl Mul for Dd {
    type Output = Self;

    /// `DWTimesDW`, relative error 5 u².
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (high, error) = two_prod(self.hi, other.hi);
        let cross = self.hi * other.lo + self.lo * other.hi;
        let product = Self::fast_sum(high, error + cross);
        let raise = || raised(self, |raised| raised * other);
        ranged(product, || self.hi * other.hi, raise)
    }
}

impl Mul<f64> for Dd {
    type Output = Self;

    /// `DWTimesFP2`, relative error 3 u².
    #[inline]
    fn mul(self, other: f64) -> Self {
        let (high, error) = two_prod(self.hi, other);
        let product = Self::fast_sum(high, error + self.lo * other);
        let raise = || raised(self, |raised| raised * other);
        ranged(product, || self.hi * other, raise)
    }
}

impl Div for Dd {
    type Output = Self;

    /// One step of Newton's from the quotient of the leading parts, relative error 10 u². Its reciprocal does not wait for the
    /// remainder, which is exact but for the low parts.
    #[inline]
    fn div(self, other: Self) -> Self {
        let (quotient, reciprocal) = (self.hi / other.hi, 1.0 / other.hi);
        if loses_its_error(self.hi, quotient) {
            return raised(self, |raised| raised / other);
        }
        let (back, error) = two_prod(quotient, other.hi);
        let rest = (self.hi - back) - error + (self.lo - quotient * other.lo);
        let result = Self::fast_sum(quotient, rest * reciprocal);
        let raise = || raised(self, |raised| raised / other);
        ranged(result, || quotient, raise)
    }
}

/// Whether the product of divisor and quotient is so small that the error of that product underflows,
/// although the quotient itself has all its digits.
#[inline]
fn loses_its_error(dividend: f64, quotient: f64) -> bool {
    dividend.abs() < 1e-290 && dividend != 0.0 && quotient.abs() > 1e-285
}

/// A product or quotient of a number that is raised by 2²⁰⁰, brought back.
#[cold]
fn raised(number: Dd, operation: impl FnOnce(Dd) -> Dd) -> Dd {
    let (up, down) = (
        2.0_f64.to_bits() + (199 << 52),
        2.0_f64.to_bits() - (201 << 52),
    );
    let scaled = |number: Dd, factor: u64| {
        let factor = f64::from_bits(factor);
        Dd {
            hi: number.hi * factor,
            lo: number.lo * factor,
        }
    };
    scaled(operation(scaled(number, up)), down)
}

impl Div<f64> for Dd {
    type Output = Self;

    /// As between double-double numbers, relative error 4 u².
    #[inline]
    fn div(self, other: f64) -> Self {
        self / Self::from(other)
    }
}

impl Sub for Dd {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Sub<f64> for Dd {
    type Output = Self;

    #[inline]
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

impl Add<Dd> for f64 {
    type Output = Dd;

    #[inline]
    fn add(self, other: Dd) -> Dd {
        other + self
    }
}

impl Sub<Dd> for f64 {
    type Output = Dd;

    #[inline]
    fn sub(self, other: Dd) -> Dd {
        -other + self
    }
}

impl Mul<Dd> for f64 {
    type Output = Dd;

    #[inline]
    fn mul(self, other: Dd) -> Dd {
        other * self
    }
}

impl Div<Dd> for f64 {
    type Output = Dd;

    #[inline]
    fn div(self, other: Dd) -> Dd {
        Dd::from(self) / other
    }
}

impl Sum for Dd {
    /// The roundings of the leading parts are added up beside them, error about n u² of the largest partial sum.
    #[inline]
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        let (rounded, rest) = terms.fold((0.0, 0.0), |(rounded, rest), term| {
            let (rounded, error) = two_sum(rounded, term.hi);
            (rounded, rest + (error + term.lo))
        });
        Self::sum(rounded, rest)
    }
}

impl<T> AddAssign<T> for Dd
where
    Dd: Add<T, Output = Dd>,
{
    #[inline]
    fn add_assign(&mut self, other: T) {
        *self = *self + other;
    }
}

impl<T> SubAssign<T> for Dd
where
    Dd: Sub<T, Output = Dd>,
{
    #[inline]
    fn sub_assign(&mut self, other: T) {
        *self = *self - other;
    }
}

impl<T> MulAssign<T> for Dd
where
    Dd: Mul<T, Output = Dd>,
{
    #[inline]
    fn mul_assign(&mut self, other: T) {
        *self = *self * other;
    }
}

impl<T> DivAssign<T> for Dd
where
    Dd: Div<T, Output = Dd>,
{
    #[inline]
    fn div_assign(&mut self, other: T) {
        *self = *self / other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn quotients_undo_products(a in 1e-9..1e9, b in 1e-3..1e3, c in -1e9..1e9) {
            let (x, y) = (Dd::sum(a, b * 1e-20), Dd::sum(c + 2e9, a * 1e-20));
            let error = (x * y / y - x).abs() / x;
            prop_assert!(error.hi() < 1e-30, "{error:?}");
        }

        #[test]
        fn no_operation_leaves_a_stray_low_part(a in any::<f64>(), b in any::<f64>()) {
            let (x, y) = (Dd::from(a), Dd::from(b));
            for (z, plain) in [(x + y, a + b), (x * y, a * b), (x / y, a / b), (x + b, a + b), (x * b, a * b), (x / b, a / b)] {
                prop_assert!(z.hi() == plain || plain.is_nan() && z.is_nan(), "{z:?} {plain}");
                prop_assert!(!z.lo().is_nan());
            }
        }
    }

    #[test]
    fn the_smallest_results_are_rounded_once() {
        // The low part is a little less than half a unit in the last place, and the smallest numbers are too coarse for it.
        let (a, b) = (-1.718_276_202_727_112e-77, -1.923_398_043_416_828_9e230);
        assert_eq!((Dd::from(a) / b).hi(), a / b);
        assert_eq!((Dd::from(a) / Dd::from(b)).hi(), a / b);
        for n in 1..1000 {
            let (a, b) = (1e-154 * f64::from(n), 1.1e-152 / f64::from(n).sqrt());
            assert_eq!((Dd::from(a) * b).hi(), a * b);
            assert_eq!((Dd::from(a) * Dd::from(b)).hi(), a * b);
        }
    }

    #[test]
    fn long_sums_keep_what_cancels() {
        let third = Dd::ONE / 3.0;
        let terms = [1e16, 1.0, -1e16, 1e-20];
        let sum: Dd = terms.iter().map(|term| third * *term).sum();
        assert!((sum - third - third * 1e-20).abs().hi() < 1e-15);
        let exact: Dd = terms.iter().copied().map(Dd::from).sum();
        assert_eq!(exact, Dd::sum(1.0, 1e-20));
    }

    #[test]
    fn sums_keep_what_a_single_number_drops() {
        let x = Dd::ONE + 1e-25 - 1.0;
        assert_eq!(x, Dd::from(1e-25));
    }
}
