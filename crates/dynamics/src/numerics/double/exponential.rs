//! Exponentials, logarithms and powers.

use super::Dd;
use super::constants::{
    EXPM1_OF_32NDS, EXPM1_OF_32NDS_CENTRE, INVERSE_FACTORIALS, LN_2_PARTS, LN_2_REST,
};
use crate::numerics::elementary::{exp, ln_1p};
use crate::numerics::exact::two_sum;

/// The integer next to a number below 2^51: the sum rounds to its unit.
#[inline]
fn nearest_integer(x: f64) -> f64 {
    // Halfway up the numbers whose unit is one, so that a negative number does not leave them either.
    const UNIT_ONE: f64 = 6_755_399_441_055_744.0; // 3/2 2^52
    (x + UNIT_ONE) - UNIT_ONE
}

/// Beyond this magnitude the exponential leaves the range of `f64`.
// e^750 is 5e325 and e^-750 is 2e-326: both are out of range, also for the smallest subnormal number.
const EXPONENT_LIMIT: f64 = 750.0;

impl Dd {
    /// Exponential e^x.
    #[must_use]
    pub fn exp(self) -> Self {
        if let Some(limit) = self.exponent_out_of_range() {
            return limit;
        }
        let (n, rest) = self.halvings();
        (rest.small_expm1() + 1.0).scale(n)
    }

    /// e^x - 1 without cancellation at small x.
    #[must_use]
    pub fn expm1(self) -> Self {
        match self.exponent_out_of_range() {
            Some(limit) => limit - 1.0,
            None => match self.halvings() {
                (0, rest) => rest.small_expm1(),
                (n, rest) => (rest.small_expm1() + 1.0).scale(n) - 1.0,
            },
        }
    }

    /// The exponential rounded to `f64`, for the price of one exponential of `f64`.
    #[inline]
    #[must_use]
    pub fn exp_to_f64(self) -> f64 {
        let leading = exp(self.hi);
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
            return Self::from(crate::numerics::elementary::ln(self.hi));
        }
        let n = crate::numerics::elementary::binary_exponent(self.hi);
        let mantissa = self.scale(-n);
        // So the rest is half of ln 2 at most: with a mantissa up to 2 it would cancel with n ln 2 just below
        // 1.
        let (n, mantissa) = if mantissa.hi > Self::SQRT_2.hi {
            (n + 1, mantissa.scale(-1))
        } else {
            (n, mantissa)
        };
        let part = (mantissa - 1.0).small_ln_1p();
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
            self.small_ln_1p()
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
        let plain = crate::numerics::elementary::pow(self.hi, exponent.hi);
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
            Self::from(crate::numerics::elementary::powi(self.hi, n))
        }
    }

    /// The limit of the exponential where the argument is out of its range or no number.
    fn exponent_out_of_range(self) -> Option<Self> {
        (self.hi.abs() >= EXPONENT_LIMIT || self.is_nan()).then(|| Self::from(exp(self.hi)))
    }

    /// The nearest n to x/ln 2, and x - n ln 2. The products that count are exact, and so is the first difference.
    fn halvings(self) -> (i32, Self) {
        let n = nearest_integer(self.hi * std::f64::consts::LOG2_E);
        if n == 0.0 {
            return (0, self);
        }
        let (high, low) = two_sum(self.hi - n * LN_2_PARTS[0], self.lo);
        let (high, error) = two_sum(high, -n * LN_2_PARTS[1]);
        let rest = Self::sum(high, error + (low - n * LN_2_REST.hi));
        (n as i32, rest)
    }

    /// e^x - 1 for |x| <= 0.35: from that of the nearest 32nd, which is tabulated, and of what is left.
    fn small_expm1(self) -> Self {
        let nearest = nearest_integer(self.hi * 32.0);
        let rest = (self - nearest / 32.0).tiny_expm1();
        let sum = if nearest == 0.0 {
            rest
        } else {
            let tabulated = EXPM1_OF_32NDS[(nearest + EXPM1_OF_32NDS_CENTRE) as usize];
            rest.times_plus(tabulated + 1.0, tabulated)
        };
        Self::normalized(sum.hi, sum.lo)
    }

    /// Taylor series of e^x - 1 for |x| <= 1/64. Terms below u of the sum are formed in `f64`, even and odd ones side by side.
    fn tiny_expm1(self) -> Self {
        // The next term is (1/64)^13/14! = 4e-35 of the sum, less than 2^-106.
        const LAST: usize = 13;
        // (1/64)^7/8! = 6e-18 of the sum, less than 2^-53.
        const FIRST_SHORT: usize = 8;
        let square = self.square();
        let every_other = |last: usize| {
            (FIRST_SHORT..=last)
                .rev()
                .step_by(2)
                .fold(0.0, |sum, n| sum * square.hi + INVERSE_FACTORIALS[n].hi)
        };
        let tail = every_other(LAST - 1) + self.hi * every_other(LAST);
        let last = FIRST_SHORT - 1;
        let start = INVERSE_FACTORIALS[last] + tail * self.hi;
        let sum = (2..last)
            .rev()
            .fold(start, |sum, n| sum.times_plus(self, INVERSE_FACTORIALS[n]));
        sum.times_plus(square, self)
    }

    /// ln(1 + x) for |x| < 0.75: one Newton step of third order from the value in `f64`.
    fn small_ln_1p(self) -> Self {
        let start = ln_1p(self.hi);
        let power = Self::from(start).expm1();
        let step = (self - power) / (power + 1.0);
        step - step.square() * 0.5 + start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_those_of_single_numbers() {
        assert_eq!(Dd::from(1e3).exp().hi(), f64::INFINITY);
        assert_eq!(Dd::from(-1e3).exp().hi(), 0.0);
        assert_eq!(Dd::from(-1e3).expm1().hi(), -1.0);
        assert!(Dd::NAN.exp().is_nan());
        assert_eq!(Dd::ZERO.ln().hi(), f64::NEG_INFINITY);
        assert!(Dd::from(-1.0).ln().is_nan());
        assert_eq!(Dd::from(0.0).pow(Dd::from(-0.5)).hi(), f64::INFINITY);
        assert_eq!(Dd::from(2.0).powi(-1074).hi(), 5e-324);
    }

    #[test]
    fn subnormal_arguments_have_logarithms() {
        let x = Dd::from(5e-324).ln();
        assert!((x + Dd::LN_2 * 1074.0).abs().hi() < 1e-28);
    }
}
