//! The floating-point numbers under an [`Approx`](super::Approx).

use std::ops::{Add, Div, Mul, Neg, Sub};

use vibank_dynamics::numerics::{self, Dd, Long};

/// A floating-point number whose rounding errors are known: binary64, double-double, or of 256 bits.
pub trait Real:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Bound on the relative error of one of the four operations and of a square root.
    const ROUNDOFF: f64;
    /// Bound on the relative error of an elementary function.
    const FUNCTION: f64;
    /// π to working precision.
    const PI: Self;
    /// The largest angle whose sine is known to the relative error of functions.
    const MAX_ANGLE: f64 = f64::MAX;
    /// Whether roots and integrals are searched with it: with most digits they would take too long.
    const SEARCHES: bool = true;

    /// The number nearest to a pair.
    fn of_pair(high: f64, low: f64) -> Self;
    /// What [`Self::of_pair`] drops of a pair.
    fn dropped(low: f64) -> f64;
    /// Rounded to binary64.
    fn to_f64(self) -> f64;
    /// What rounding to binary64 drops.
    fn low(self) -> f64;
    /// Bound on the relative error of a power of this size, beyond that of a function.
    fn power_rounding(size: f64) -> f64;
    /// The sum, and whether it is known to be exact.
    fn exact_sum(self, other: Self) -> (Self, bool);
    /// The product, and whether it is known to be exact.
    fn exact_product(self, other: Self) -> (Self, bool);

    /// Largest integer below.
    #[must_use]
    fn floor(self) -> Self;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;
    /// Decimal logarithm.
    #[must_use]
    fn log10(self) -> Self;
    /// Sine.
    #[must_use]
    fn sin(self) -> Self;
    /// Cosine.
    #[must_use]
    fn cos(self) -> Self;
    /// Tangent.
    #[must_use]
    fn tan(self) -> Self;
    /// Inverse sine.
    #[must_use]
    fn asin(self) -> Self;
    /// Inverse cosine.
    #[must_use]
    fn acos(self) -> Self;
    /// Inverse tangent.
    #[must_use]
    fn atan(self) -> Self;
    /// Hyperbolic sine.
    #[must_use]
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    #[must_use]
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;
    /// Inverse hyperbolic sine.
    #[must_use]
    fn asinh(self) -> Self;
    /// Inverse hyperbolic cosine.
    #[must_use]
    fn acosh(self) -> Self;
    /// Inverse hyperbolic tangent.
    #[must_use]
    fn atanh(self) -> Self;
    /// Angle of the point (x, y), called on y.
    #[must_use]
    fn atan2(self, x: Self) -> Self;
    /// Length of a vector.
    #[must_use]
    fn hypot(self, other: Self) -> Self;
    /// Power.
    #[must_use]
    fn pow(self, exponent: Self) -> Self;
    /// Power with a whole exponent.
    #[must_use]
    fn powi(self, exponent: i32) -> Self;

    /// Magnitude.
    #[must_use]
    fn abs(self) -> Self {
        if self < Self::of_pair(0.0, 0.0) {
            -self
        } else {
            self
        }
    }
}

/// Passes functions on to those of another module or type.
macro_rules! forward {
    ($($name:ident),*; $path:path) => {
        $(
            #[inline]
            fn $name(self) -> Self {
                use $path as source;
                source::$name(self)
            }
        )*
    };
}

impl Real for f64 {
    // Rounding to nearest leaves half a unit in the last place.
    const ROUNDOFF: f64 = f64::EPSILON / 2.0;
    /// One unit in the last place.
    const FUNCTION: f64 = f64::EPSILON;
    const PI: Self = std::f64::consts::PI;

    #[inline]
    fn of_pair(high: f64, _low: f64) -> Self {
        high
    }

    #[inline]
    fn dropped(low: f64) -> f64 {
        low.abs()
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline]
    fn low(self) -> f64 {
        0.0
    }

    #[inline]
    fn power_rounding(_size: f64) -> f64 {
        0.0
    }

    #[inline]
    fn exact_sum(self, other: Self) -> (Self, bool) {
        let (sum, error) = numerics::two_sum(self, other);
        (sum, error == 0.0)
    }

    #[inline]
    fn exact_product(self, other: Self) -> (Self, bool) {
        let (product, error) = numerics::two_prod(self, other);
        (product, error == 0.0)
    }

    #[inline]
    fn floor(self) -> Self {
        self.floor()
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline]
    fn abs(self) -> Self {
        self.abs()
    }

    forward!(exp, ln, log10, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh; vibank_dynamics::numerics);

    #[inline]
    fn atan2(self, x: Self) -> Self {
        numerics::atan2(self, x)
    }

    #[inline]
    fn hypot(self, other: Self) -> Self {
        numerics::hypot(self, other)
    }

    #[inline]
    fn pow(self, exponent: Self) -> Self {
        numerics::pow(self, exponent)
    }

    #[inline]
    fn powi(self, exponent: i32) -> Self {
        numerics::powi(self, exponent)
    }
}

impl Real for Dd {
    /// Sixteen times u² covers the division, the worst of the four.
    const ROUNDOFF: f64 = 4.0 * f64::EPSILON * f64::EPSILON;
    // Functions of a double-double are right to about 1e-31; one digit is in reserve.
    const FUNCTION: f64 = 1e-30;
    const PI: Self = Dd::PI;

    fn of_pair(high: f64, low: f64) -> Self {
        Dd::sum(high, low)
    }

    fn dropped(_low: f64) -> f64 {
        0.0
    }

    fn to_f64(self) -> f64 {
        self.hi()
    }

    fn low(self) -> f64 {
        self.lo()
    }

    /// The power is the exponential of a logarithm, whose error it multiplies.
    fn power_rounding(size: f64) -> f64 {
        Self::FUNCTION * numerics::ln(size.max(f64::MIN_POSITIVE)).abs()
    }

    fn exact_sum(self, other: Self) -> (Self, bool) {
        (self + other, self.lo() == 0.0 && other.lo() == 0.0)
    }

    fn exact_product(self, other: Self) -> (Self, bool) {
        (self * other, self.lo() == 0.0 && other.lo() == 0.0)
    }

    fn floor(self) -> Self {
        self.floor()
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn log10(self) -> Self {
        self.ln() / Dd::LN_10
    }

    forward!(exp, ln, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh; Dd);

    fn atan2(self, x: Self) -> Self {
        Dd::atan2(self, x)
    }

    fn hypot(self, other: Self) -> Self {
        Dd::hypot(self, other)
    }

    fn pow(self, exponent: Self) -> Self {
        Dd::pow(self, exponent)
    }

    fn powi(self, exponent: i32) -> Self {
        Dd::powi(self, exponent)
    }
}

impl Real for Long {
    /// 2^-250.
    const ROUNDOFF: f64 = 6e-76;
    // 2^-256 is 9e-78: seven digits are in reserve for what the functions lose.
    const FUNCTION: f64 = 1e-70;
    const PI: Self = Long::PI;
    const MAX_ANGLE: f64 = Long::MAX_ANGLE;
    const SEARCHES: bool = false;

    fn of_pair(high: f64, low: f64) -> Self {
        Self::from(high) + Self::from(low)
    }

    fn dropped(_low: f64) -> f64 {
        0.0
    }

    fn to_f64(self) -> f64 {
        Self::to_f64(self)
    }

    fn low(self) -> f64 {
        (self - Self::from(Self::to_f64(self))).to_f64()
    }

    /// The power is the exponential of a logarithm, whose error it multiplies.
    fn power_rounding(size: f64) -> f64 {
        Self::FUNCTION * numerics::ln(size.max(f64::MIN_POSITIVE)).abs()
    }

    fn exact_sum(self, other: Self) -> (Self, bool) {
        (self + other, false)
    }

    fn exact_product(self, other: Self) -> (Self, bool) {
        (self * other, false)
    }

    fn atan2(self, x: Self) -> Self {
        Long::atan2(self, x)
    }

    fn hypot(self, other: Self) -> Self {
        Long::hypot(self, other)
    }

    fn pow(self, exponent: Self) -> Self {
        Long::pow(self, exponent)
    }

    fn powi(self, exponent: i32) -> Self {
        Long::powi(self, exponent)
    }

    forward!(floor, sqrt, exp, ln, log10, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, asinh, acosh, atanh; Long);
}
