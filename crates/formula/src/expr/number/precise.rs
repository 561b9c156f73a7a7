//! Numbers as they are given: to more digits than binary64 holds.

use vibank_dynamics::numerics::{Dd, Rational, two_prod};

/// A number given to about 106 bits: the sum `high + low` and a bound on what it still lacks.
///
/// Data are decimals; in binary64 they are off by half a unit in the last place, which is `low`.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::Precise;
/// use vibank_dynamics::numerics::Rational;
///
/// let tenth = Precise::from(Rational::new(1, 10).unwrap());
/// assert_eq!(tenth.high(), 0.1);
/// assert!(tenth.low() != 0.0);
/// assert_eq!(Precise::exact(0.5), Precise::from(Rational::new(1, 2).unwrap()));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precise {
    high: f64,
    low: f64,
    rest: f64,
}

/// Relative error of the conversion of a fraction to a pair.
// About three times 2^-106.
const PAIR_ERROR: f64 = 4e-32;

impl Precise {
    /// A number that is exactly a binary64.
    pub fn exact(value: f64) -> Self {
        Self::new(value, 0.0, 0.0)
    }

    /// The number `high + low`, to an error of at most `rest`; `high` is that sum rounded.
    pub fn new(high: f64, low: f64, rest: f64) -> Self {
        Self { high, low, rest }
    }

    /// A double-double number, to an error of at most `rest`.
    pub fn of_dd(value: Dd, rest: f64) -> Self {
        Self::new(value.hi(), value.lo(), rest)
    }

    /// The nearest binary64.
    pub fn high(&self) -> f64 {
        self.high
    }

    /// What the nearest binary64 leaves.
    pub fn low(&self) -> f64 {
        self.low
    }

    /// Bound on what both leave.
    pub fn rest(&self) -> f64 {
        self.rest
    }
}

impl From<Rational> for Precise {
    fn from(value: Rational) -> Self {
        let (high, low) = value.to_pair();
        let rest = if is_exact(value, high, low) {
            0.0
        } else {
            PAIR_ERROR * high.abs()
        };
        Self::new(high, low, rest)
    }
}

/// Whether a pair is a fraction without error; may miss it for long numerators and denominators.
fn is_exact(value: Rational, high: f64, low: f64) -> bool {
    let (numerator, denominator) = (value.numerator() as f64, value.denominator() as f64);
    let are_short = numerator as i128 == value.numerator()
        && denominator as i128 == value.denominator()
        && denominator < 1e15;
    are_short && low == 0.0 && two_prod(high, denominator) == (numerator, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_keeps_what_binary_drops() {
        let of = |text| Precise::from(Rational::from_decimal(text).unwrap());
        assert_eq!(of("12.5"), Precise::exact(12.5));
        assert_eq!(of("1e22"), Precise::exact(1e22));
        let third = Precise::from(Rational::new(1, 3).unwrap());
        assert!(third.low() != 0.0 && third.rest() > 0.0);
        assert!((Dd::sum(third.high(), third.low()) * 3.0 - 1.0).abs().hi() < 1e-31);
    }
}
