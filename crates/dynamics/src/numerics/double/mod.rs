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
mod reduction;

use std::cmp::Ordering;

use super::elementary::{self, binary_exponent, scale_by_power_of_two};
use super::exact::{fast_two_sum, ordinary_product, two_prod, two_sum};
use circular::{on_axis, small_angle, small_cos, small_sin};
use constants::{LN_2_PARTS, LN_2_REST};
use exponential::{exponent_out_of_range, halvings, small_expm1, small_ln_1p};
use reduction::quarter_turns;

/// Beyond this magnitude both exponentials of a hyperbolic function no longer fit, and the falling one no longer counts.
// e^709 is the largest exponential of binary64.
const LARGE: f64 = 700.0;

/// From here on asinh x and acosh x are ln 2x to 1/(4 x²), far below 2^-106.
// The square of 1.4e154 overflows.
const SQUARE_OVERFLOWS: f64 = 1e150;

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

    /// The circle constant π.
    pub const PI: Self = constants::PI;
    /// A full turn, 2π.
    pub const TAU: Self = constants::TAU;
    /// A right angle, π/2.
    pub const FRAC_PI_2: Self = constants::FRAC_PI_2;
    /// Half a right angle, π/4.
    pub const FRAC_PI_4: Self = constants::FRAC_PI_4;
    /// Euler's number e.
    pub const E: Self = constants::E;
    /// The natural logarithm of 2.
    pub const LN_2: Self = constants::LN_2;
    /// The natural logarithm of 10.
    pub const LN_10: Self = constants::LN_10;
    /// The square root of 2.
    pub const SQRT_2: Self = constants::SQRT_2;

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

    /// `self * factor + term` for a term that outweighs the product, as in the series of a small number: the error is a few
    /// u² of the term. Nothing is guarded against numbers out of range.
    #[inline]
    pub(crate) fn times_plus(self, factor: Self, term: Self) -> Self {
        let (product, error) = ordinary_product(self.hi, factor.hi);
        let cross = self.hi * factor.lo + self.lo * factor.hi;
        let (hi, rest) = fast_two_sum(term.hi, product);
        Self {
            hi,
            lo: rest + (error + cross + term.lo),
        }
    }

    /// `self * factor` for a product that stays below infinity, without a look at the range of numbers: where the product is
    /// so small that its low part falls below the smallest number, it has the digits of `f64`.
    #[inline]
    pub(crate) fn ordinary_times(self, factor: f64) -> Self {
        let (product, error) = ordinary_product(self.hi, factor);
        Self::fast_sum(product, error + self.lo * factor)
    }

    /// Exponential e^x.
    #[must_use]
    pub fn exp(self) -> Self {
        if let Some(limit) = exponent_out_of_range(self) {
            return limit;
        }
        let (n, rest) = halvings(self);
        (small_expm1(rest) + 1.0).scale(n)
    }

    /// e^x - 1 without cancellation at small x.
    #[must_use]
    pub fn expm1(self) -> Self {
        match exponent_out_of_range(self) {
            Some(limit) => limit - 1.0,
            None => match halvings(self) {
                (0, rest) => small_expm1(rest),
                (n, rest) => (small_expm1(rest) + 1.0).scale(n) - 1.0,
            },
        }
    }

    /// The exponential rounded to `f64`, for the price of one exponential of `f64`.
    #[inline]
    #[must_use]
    pub fn exp_to_f64(self) -> f64 {
        let leading = elementary::exp(self.hi);
        if leading.is_finite() {
            leading + leading * self.lo
        } else {
            leading
        }
    }

    /// Natural logarithm; NaN below zero.
    #[must_use]
    pub fn ln(self) -> Self {
        if self.hi <= 0.0 || !self.is_finite() {
            return Self::from(elementary::ln(self.hi));
        }
        let n = binary_exponent(self.hi);
        let mantissa = self.scale(-n);
        // So the rest is half of ln 2 at most: with a mantissa up to 2 it would cancel with n ln 2 just below
        // 1.
        let (n, mantissa) = if mantissa.hi > Self::SQRT_2.hi {
            (n + 1, mantissa.scale(-1))
        } else {
            (n, mantissa)
        };
        let part = small_ln_1p(mantissa - 1.0);
        if n == 0 {
            part
        } else {
            LN_2_REST * f64::from(n)
                + part
                + LN_2_PARTS[1] * f64::from(n)
                + LN_2_PARTS[0] * f64::from(n)
        }
    }

    /// ln(1 + x) without cancellation at small x.
    #[must_use]
    pub fn ln_1p(self) -> Self {
        if self.hi > -0.4 && self.hi < 0.7 {
            small_ln_1p(self)
        } else {
            (self + 1.0).ln()
        }
    }

    /// Power x^y, with a relative error of about (1 + |y ln x|) 1e-31.
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        // Up to here repeated squaring takes at most twenty products, and no logarithm.
        const REPEATED: f64 = 1024.0;
        if exponent.lo == 0.0 && exponent.hi.abs() <= REPEATED && exponent.hi == exponent.hi.trunc()
        {
            return self.powi(exponent.hi as i32);
        }
        let plain = elementary::pow(self.hi, exponent.hi);
        if self.hi <= 0.0
            || !self.is_finite()
            || !exponent.is_finite()
            || !plain.is_finite()
            || plain == 0.0
        {
            return Self::from(plain);
        }
        (self.ln() * exponent).exp()
    }

    /// Power with an integer exponent, by repeated squaring.
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        let mut rest = n.unsigned_abs();
        let mut square = self;
        let mut product = Self::ONE;
        while rest > 0 {
            if rest & 1 == 1 {
                product *= square;
            }
            square *= square;
            rest >>= 1;
        }
        if n >= 0 {
            product
        } else if product.is_finite() && product.hi != 0.0 {
            product.recip()
        } else {
            Self::from(elementary::powi(self.hi, n))
        }
    }

    /// Sine and cosine of an angle in radians, in this order.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let (quarters, rest) = quarter_turns(self);
        let (sine, cosine) = (small_sin(rest), small_cos(rest));
        match quarters {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    /// Sine of an angle in radians.
    #[must_use]
    pub fn sin(self) -> Self {
        let (quarters, rest) = quarter_turns(self);
        let magnitude = if quarters & 1 == 0 {
            small_sin(rest)
        } else {
            small_cos(rest)
        };
        if quarters & 2 == 0 {
            magnitude
        } else {
            -magnitude
        }
    }

    /// Cosine of an angle in radians.
    #[must_use]
    pub fn cos(self) -> Self {
        let (quarters, rest) = quarter_turns(self);
        let magnitude = if quarters & 1 == 0 {
            small_cos(rest)
        } else {
            small_sin(rest)
        };
        if matches!(quarters, 1 | 2) {
            -magnitude
        } else {
            magnitude
        }
    }

    /// Tangent of an angle in radians.
    #[must_use]
    pub fn tan(self) -> Self {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    /// Sine and cosine rounded to `f64`, for the price of those of the leading part.
    ///
    /// The error is one unit in the last place for phases of any size: the low part enters by the addition theorem.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::numerics::Dd;
    ///
    /// let (sine, cosine) = (Dd::TAU * 1e12).sin_cos_to_f64();
    /// assert!(sine.abs() < 1e-15);
    /// assert_eq!(cosine, 1.0);
    /// ```
    #[inline]
    #[must_use]
    pub fn sin_cos_to_f64(self) -> (f64, f64) {
        let (sine, cosine) = elementary::sin_cos(self.hi);
        let (small_sine, small_versine) = small_angle(self.lo);
        (
            sine + (cosine * small_sine - sine * small_versine),
            cosine - (sine * small_sine + cosine * small_versine),
        )
    }

    /// Angle in [-π/2, π/2] whose sine is x; NaN outside [-1, 1].
    #[must_use]
    pub fn asin(self) -> Self {
        // 1 - x² would lose its digits beside 1.
        Self::atan2(self, ((1.0 - self) * (1.0 + self)).sqrt())
    }

    /// Angle in [0, π] whose cosine is x; NaN outside [-1, 1].
    #[must_use]
    pub fn acos(self) -> Self {
        Self::atan2(((1.0 - self) * (1.0 + self)).sqrt(), self)
    }

    /// Angle in (-π/2, π/2) whose tangent is x.
    #[must_use]
    pub fn atan(self) -> Self {
        Self::atan2(self, Self::ONE)
    }

    /// Angle of the point (x, y), in [-π, π]: `Dd::atan2(y, x)`.
    ///
    /// One Newton step from the angle in `f64`, whose error is the cross product with its direction.
    #[must_use]
    pub fn atan2(y: Self, x: Self) -> Self {
        let start = elementary::atan2(y.hi, x.hi);
        let largest = binary_exponent(y.hi).max(binary_exponent(x.hi));
        if y.hi == 0.0 || x.hi == 0.0 || largest == i32::MAX {
            return on_axis(start);
        }
        // The quotient of the step is the same, and its products stay within the range of numbers.
        let (y, x) = (y.scale(-largest), x.scale(-largest));
        let (sine, cosine) = Self::from(start).sin_cos();
        let step = (y * cosine - x * sine) / (x * cosine + y * sine);
        if step.is_finite() {
            step + start
        } else {
            Self::from(start)
        }
    }

    /// Hyperbolic sine.
    #[must_use]
    pub fn sinh(self) -> Self {
        let x = self.abs();
        let magnitude = if x.hi > LARGE {
            let half = (x * 0.5).exp();
            half * 0.5 * half
        } else {
            // By e^x - 1: the difference of both exponentials would lose all digits of a small number.
            let growth = x.expm1();
            (growth + growth / (growth + 1.0)) * 0.5
        };
        self.signed(magnitude)
    }

    /// Hyperbolic cosine.
    #[must_use]
    pub fn cosh(self) -> Self {
        let half = (self.abs() * 0.5).exp();
        if self.hi.abs() > LARGE {
            return half * 0.5 * half;
        }
        let power = self.exp();
        (power + power.recip()) * 0.5
    }

    /// Hyperbolic tangent.
    #[must_use]
    pub fn tanh(self) -> Self {
        // 1 - tanh 40 = 2 e^-80 = 4e-35, less than 2^-106.
        const SATURATED: f64 = 40.0;
        if self.hi.abs() > SATURATED {
            return Self::from(1.0_f64.copysign(self.hi));
        }
        let growth = (self * 2.0).expm1();
        growth / (growth + 2.0)
    }

    /// Inverse hyperbolic sine.
    #[must_use]
    pub fn asinh(self) -> Self {
        let x = self.abs();
        let magnitude = if x.hi > SQUARE_OVERFLOWS {
            x.ln() + Self::LN_2
        } else {
            let square = x.square();
            (x + square / ((square + 1.0).sqrt() + 1.0)).ln_1p()
        };
        if self.is_negative() {
            -magnitude
        } else {
            magnitude
        }
    }

    /// Inverse hyperbolic cosine; NaN below 1.
    #[must_use]
    pub fn acosh(self) -> Self {
        if self.hi > SQUARE_OVERFLOWS {
            return self.ln() + Self::LN_2;
        }
        let excess = self - 1.0;
        (excess + (excess * (excess + 2.0)).sqrt()).ln_1p()
    }

    /// Inverse hyperbolic tangent; NaN outside [-1, 1].
    #[must_use]
    pub fn atanh(self) -> Self {
        let x = self.abs();
        self.signed((x * 2.0 / (1.0 - x)).ln_1p() * 0.5)
    }

    /// The magnitude with the sign of this number.
    fn signed(self, magnitude: Self) -> Self {
        if self.hi.is_sign_negative() {
            -magnitude
        } else {
            magnitude
        }
    }

    /// Length of the vector (x, y), without overflow of the squares.
    #[must_use]
    pub fn hypot(self, other: Self) -> Self {
        const ORDINARY: std::ops::RangeInclusive<f64> = 1e-120..=1e120;
        let largest = self.hi.abs().max(other.hi.abs());
        if ORDINARY.contains(&largest) {
            return (self.square() + other.square()).sqrt();
        }
        if largest == 0.0 || !self.is_finite() || !other.is_finite() {
            return Self::from(elementary::hypot(self.hi, other.hi));
        }
        let exponent = binary_exponent(largest);
        let (x, y) = (self.scale(-exponent), other.scale(-exponent));
        (x.square() + y.square()).sqrt().scale(exponent)
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
mod tests;
