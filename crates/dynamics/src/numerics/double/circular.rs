//! Circular functions and their inverses.

use super::Dd;
use super::constants::INVERSE_FACTORIALS;
use crate::numerics::elementary::{atan2, binary_exponent, sin, sin_cos};

impl Dd {
    /// Sine and cosine of an angle in radians, in this order.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let (quarters, rest) = self.quarter_turns();
        let (sine, cosine) = (rest.small_sin(), rest.small_cos());
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
        let (quarters, rest) = self.quarter_turns();
        let magnitude = if quarters & 1 == 0 {
            rest.small_sin()
        } else {
            rest.small_cos()
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
        let (quarters, rest) = self.quarter_turns();
        let magnitude = if quarters & 1 == 0 {
            rest.small_cos()
        } else {
            rest.small_sin()
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
        let (sine, cosine) = sin_cos(self.hi);
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
        let start = atan2(y.hi, x.hi);
        let largest = binary_exponent(y.hi).max(binary_exponent(x.hi));
        if y.hi == 0.0 || x.hi == 0.0 || largest == i32::MAX {
            return Self::on_axis(start);
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

    /// The multiple of π/4 that was rounded to this angle, or the angle itself.
    fn on_axis(angle: f64) -> Self {
        // On an axis the angle is known: a rounded π would be carried on with 53 bits.
        let eighths = angle / Self::FRAC_PI_4.hi;
        if eighths == eighths.trunc() {
            Self::FRAC_PI_4 * eighths
        } else {
            Self::from(angle)
        }
    }

    /// Taylor series of the sine for |x| <= π/4.
    fn small_sin(self) -> Self {
        self + self * self.square() * self.square().alternating::<3>()
    }

    /// Taylor series of the cosine for |x| <= π/4.
    fn small_cos(self) -> Self {
        let square = self.square();
        square * square.alternating::<2>() + 1.0
    }

    /// -1/n! + x/(n+2)! - x²/(n+4)! + ... to 1/29!. Terms below u of the sum are formed in `f64`.
    fn alternating<const FIRST: usize>(self) -> Self {
        // At π/4 the term of 1/17! is 6e-17 of the sine, less than 2^-53; that of 1/18! is 2e-18 of the
        // cosine.
        const SHORT: usize = 17;
        let odd = FIRST & 1;
        let sign = |n: usize| if (n - odd) & 2 == 0 { 1.0 } else { -1.0 };
        let orders = |from: usize, to: usize| (from..to).filter(move |n| n & 1 == odd).rev();
        let tail = orders(SHORT, 30).fold(0.0, |sum, n| {
            sum * self.hi + sign(n) * INVERSE_FACTORIALS[n].hi
        });
        orders(FIRST, SHORT).fold(Self::from(tail), |sum, n| {
            let term = INVERSE_FACTORIALS[n];
            sum.times_plus(self, if sign(n) < 0.0 { -term } else { term })
        })
    }
}

/// sin x and 1 - cos x: three terms of their series below 2^-9, where the next are below u.
#[inline]
fn small_angle(x: f64) -> (f64, f64) {
    if x.abs() < 0.002 {
        let square = x * x;
        let sine = x - x * square * (1.0 / 6.0 - square / 120.0);
        (
            sine,
            square * (0.5 - square * (1.0 / 24.0 - square / 720.0)),
        )
    } else {
        let half = sin(0.5 * x);
        (sin(x), 2.0 * half * half)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_have_exact_angles() {
        assert_eq!(Dd::atan2(Dd::ONE, Dd::ZERO), Dd::FRAC_PI_2);
        assert_eq!(Dd::atan2(Dd::ZERO, -Dd::ONE), Dd::PI);
        assert_eq!(Dd::ONE.acos(), Dd::ZERO);
        assert_eq!((-Dd::ONE).asin(), -Dd::FRAC_PI_2);
        assert_eq!(Dd::from(f64::INFINITY).atan(), Dd::FRAC_PI_2);
        assert!(Dd::from(1.5).asin().is_nan());
        assert!(Dd::from(f64::INFINITY).sin().is_nan());
    }

    #[test]
    fn rounded_phases_agree_with_the_full_ones() {
        for n in 0..2000 {
            let phase = Dd::PI * Dd::from(f64::from(n)).square() * 1e7 + 0.1 * f64::from(n);
            let (sine, cosine) = phase.sin_cos();
            let (rounded_sine, rounded_cosine) = phase.sin_cos_to_f64();
            assert!((sine - rounded_sine).abs().hi() < 1.5e-16, "{phase:?}");
            assert!((cosine - rounded_cosine).abs().hi() < 1.5e-16, "{phase:?}");
        }
    }
}
