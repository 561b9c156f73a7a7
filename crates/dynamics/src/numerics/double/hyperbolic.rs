//! Hyperbolic functions, their inverses, and the length of a vector.

use super::Dd;
use crate::numerics::elementary::binary_exponent;

/// Beyond this magnitude both exponentials no longer fit, and the falling one no longer counts.
// e^709 is the largest exponential of binary64.
const LARGE: f64 = 700.0;

impl Dd {
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
        // The square of 1.4e154 overflows; from here on asinh x is ln 2x to 1/(4 x²), far below 2^-106.
        const SQUARE_OVERFLOWS: f64 = 1e150;
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
        // As for asinh: acosh x is ln 2x to 1/(4 x²).
        const SQUARE_OVERFLOWS: f64 = 1e150;
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
            return Self::from(crate::numerics::elementary::hypot(self.hi, other.hi));
        }
        let exponent = binary_exponent(largest);
        let (x, y) = (self.scale(-exponent), other.scale(-exponent));
        (x.square() + y.square()).sqrt().scale(exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_those_of_single_numbers() {
        assert_eq!(Dd::from(-800.0).sinh().hi(), f64::NEG_INFINITY);
        assert!((Dd::from(710.0).cosh().hi() / 1.116_997_383_080_855_5e308 - 1.0).abs() < 1e-15);
        assert_eq!(Dd::from(-1e300).tanh(), -Dd::ONE);
        assert_eq!(Dd::ONE.atanh().hi(), f64::INFINITY);
        assert!(Dd::from(0.5).acosh().is_nan());
        assert_eq!(Dd::from(3e300).hypot(Dd::from(4e300)).hi(), 5e300);
        assert_eq!(Dd::from(3e-320).hypot(Dd::ZERO).hi(), 3e-320);
    }
}
