//! Complex numbers over `f64`.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::elementary::{
    atan2, binary_exponent, cosh, exp, expm1, hypot, ln, ln_1p, scale_by_power_of_two, sin_cos,
    sinh,
};
use super::exact::{diff_of_products, sum_of_products};

/// A complex number re + i im.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::Complex;
///
/// let impedance = Complex::new(3.0, 4.0);
/// assert_eq!(impedance.abs(), 5.0);
/// assert_eq!(impedance * impedance.conjugate(), Complex::from(25.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// Zero.
    pub const ZERO: Self = Self { re: 0.0, im: 0.0 };
    /// 1 + 0i, the neutral element of products.
    pub const ONE: Self = Self { re: 1.0, im: 0.0 };
    /// The imaginary unit.
    pub const I: Self = Self { re: 0.0, im: 1.0 };

    /// The number re + i im.
    #[inline]
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// The number of this modulus and argument in radians.
    #[inline]
    pub fn from_polar(modulus: f64, argument: f64) -> Self {
        let (sine, cosine) = sin_cos(argument);
        Self::new(modulus * cosine, modulus * sine)
    }

    /// Modulus, without overflow of the squares.
    #[inline]
    pub fn abs(self) -> f64 {
        hypot(self.re, self.im)
    }

    /// Argument in [-π, π], the angle from the positive real axis in rad.
    #[inline]
    pub fn argument(self) -> f64 {
        atan2(self.im, self.re)
    }

    /// Complex conjugate.
    #[inline]
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self::new(self.re, -self.im)
    }

    /// Whether both parts are neither infinite nor NaN.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.re.is_finite() && self.im.is_finite()
    }

    /// Number times i.
    #[inline]
    #[must_use]
    pub fn times_i(self) -> Self {
        Self::new(-self.im, self.re)
    }

    /// Number times 2^n.
    #[inline]
    #[must_use]
    pub fn scale(self, n: i32) -> Self {
        Self::new(
            scale_by_power_of_two(self.re, n),
            scale_by_power_of_two(self.im, n),
        )
    }

    /// Reciprocal.
    #[inline]
    #[must_use]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// Exponential e^z.
    #[must_use]
    pub fn exp(self) -> Self {
        Self::from_polar(exp(self.re), self.im)
    }

    /// e^z - 1 without cancellation at small z, to a few units in the last place of its modulus.
    ///
    /// ```text
    /// e^(x+iy) - 1 = expm1(x) cos y - 2 sin²(y/2) + i e^x sin y
    /// ```
    #[must_use]
    pub fn expm1(self) -> Self {
        let (sine, cosine) = sin_cos(0.5 * self.im);
        let (growth, versine) = (expm1(self.re), 2.0 * sine * sine);
        Self::new(
            growth - growth * versine - versine,
            (growth + 1.0) * (2.0 * sine * cosine),
        )
    }

    /// Principal natural logarithm; the modulus near one keeps its digits.
    #[must_use]
    pub fn ln(self) -> Self {
        let modulus = self.abs();
        let real = if modulus > 0.5 && modulus < 2.0 {
            let (large, small) = (
                self.re.abs().max(self.im.abs()),
                self.re.abs().min(self.im.abs()),
            );
            0.5 * ln_1p(sum_of_products(large - 1.0, large + 1.0, small, small))
        } else {
            ln(modulus)
        };
        Self::new(real, self.argument())
    }

    /// Principal square root.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let modulus = self.abs();
        if modulus == 0.0 {
            return Self::ZERO;
        }
        // Halved first: the sum of both may overflow.
        let large = (0.5 * modulus + 0.5 * self.re.abs()).sqrt();
        let small = 0.5 * self.im / large;
        if self.re >= 0.0 {
            Self::new(large, small)
        } else {
            Self::new(small.abs(), large.copysign(self.im))
        }
    }

    /// Power z^w; zero to a power with positive real part is zero.
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        if exponent == Self::ZERO {
            Self::ONE
        } else if self == Self::ZERO && exponent.re > 0.0 {
            Self::ZERO
        } else {
            (self.ln() * exponent).exp()
        }
    }

    /// Power with an integer exponent, by repeated squaring.
    #[must_use]
    pub fn powi(self, n: i32) -> Self {
        let mut rest = n.unsigned_abs();
        let (mut square, mut product) = (self, Self::ONE);
        while rest > 0 {
            if rest & 1 == 1 {
                product = product * square;
            }
            square = square * square;
            rest >>= 1;
        }
        if n < 0 { product.recip() } else { product }
    }

    /// Sine.
    #[must_use]
    pub fn sin(self) -> Self {
        let (sine, cosine) = sin_cos(self.re);
        Self::new(sine * cosh(self.im), cosine * sinh(self.im))
    }

    /// Cosine.
    #[must_use]
    pub fn cos(self) -> Self {
        let (sine, cosine) = sin_cos(self.re);
        Self::new(cosine * cosh(self.im), -sine * sinh(self.im))
    }
}

impl From<f64> for Complex {
    #[inline]
    fn from(re: f64) -> Self {
        Self::new(re, 0.0)
    }
}

impl Neg for Complex {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

impl Add for Complex {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl Sub for Complex {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl Mul<f64> for Complex {
    type Output = Self;

    #[inline]
    fn mul(self, other: f64) -> Self {
        Self::new(self.re * other, self.im * other)
    }
}

impl Div for Complex {
    type Output = Self;

    /// Both parts to a few units in the last place: products are differenced exactly, and the divisor is scaled first.
    fn div(self, other: Self) -> Self {
        let exponent = binary_exponent(other.re).max(binary_exponent(other.im));
        if exponent == i32::MIN || exponent == i32::MAX {
            return Self::new(self.re / other.abs(), self.im / other.abs());
        }
        let divisor = other.scale(-exponent);
        let square = divisor.re * divisor.re + divisor.im * divisor.im;
        let dividend = self.scale(-exponent);
        Self::new(
            sum_of_products(dividend.re, divisor.re, dividend.im, divisor.im) / square,
            diff_of_products(dividend.im, divisor.re, dividend.re, divisor.im) / square,
        )
    }
}

impl Div<f64> for Complex {
    type Output = Self;

    #[inline]
    fn div(self, other: f64) -> Self {
        Self::new(self.re / other, self.im / other)
    }
}

#[cfg(test)]
mod tests {
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    use super::*;

    /// Two units in the last place of each part.
    const CLOSE: f64 = 4e-16;

    #[track_caller]
    fn assert_close(a: Complex, b: Complex) {
        assert_relative_eq!(a, b, epsilon = 0.0, max_relative = CLOSE);
    }

    #[test]
    fn exponentials_keep_small_values() {
        let z = Complex::new(1e-12, -2e-12);
        assert_close(z.expm1(), z + z * z * 0.5);
        let large = Complex::new(1.5, 2.5);
        assert_close(large.expm1(), large.exp() - Complex::ONE);
    }

    #[test]
    fn logarithms_of_the_unit_circle_keep_their_modulus() {
        let z = Complex::new(1e-9, 1.0);
        assert!((z.ln().re - 5e-19).abs() < 1e-33);
        assert_close(Complex::new(-3.0, 0.5).ln().exp(), Complex::new(-3.0, 0.5));
    }

    #[test]
    fn roots_lie_in_the_right_half_plane() {
        for z in [
            Complex::new(-4.0, 0.0),
            Complex::new(-4.0, -1e-3),
            Complex::new(3.0, 4.0),
            Complex::I,
        ] {
            let root = z.sqrt();
            assert!(root.re >= 0.0, "{z:?}");
            assert_close(root * root, z);
        }
    }

    #[test]
    fn quotients_hold_at_the_ends_of_the_exponent_range() {
        let (tiny, huge) = (Complex::new(3e-300, 4e-300), Complex::new(3e300, 4e300));
        assert_close(tiny / tiny, Complex::ONE);
        assert_close(huge / huge, Complex::ONE);
        assert_close(huge / Complex::I, Complex::new(4e300, -3e300));
    }

    #[test]
    fn powers_agree() {
        let z = Complex::new(0.6, -1.1);
        assert_abs_diff_eq!(z.powi(5), z.pow(Complex::from(5.0)), epsilon = 1e-14);
        assert_close(z.powi(-2) * z * z, Complex::ONE);
    }
}
