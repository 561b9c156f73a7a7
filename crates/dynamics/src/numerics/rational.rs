//! Exact fractions.

use std::cmp::Ordering;
use std::fmt;

use super::decimal;

/// A fraction of 128-bit integers in lowest terms, with a positive denominator.
///
/// Every operation is exact; one whose result does not fit returns `None`, so that a caller bounds
/// what it computes instead of rounding in silence.
///
/// ```
/// use vibank_dynamics::numerics::Rational;
/// let third = Rational::new(1, 3).unwrap();
/// let sum = third.checked_add(Rational::new(1, 6).unwrap()).unwrap();
/// assert_eq!(sum.to_string(), "1/2");
/// assert_eq!(Rational::from_decimal("12.50").unwrap(), Rational::new(25, 2).unwrap());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: i128,
    denominator: i128,
}

impl Rational {
    /// Zero.
    pub const ZERO: Self = Self {
        numerator: 0,
        denominator: 1,
    };
    /// 1/1, the neutral element of products.
    pub const ONE: Self = Self {
        numerator: 1,
        denominator: 1,
    };

    /// `numerator / denominator` in lowest terms; `None` for a zero denominator or where it does not fit.
    pub fn new(numerator: i128, denominator: i128) -> Option<Self> {
        if denominator == 0 || numerator == i128::MIN || denominator == i128::MIN {
            return None;
        }
        let sign = denominator.signum();
        let (numerator, denominator) = (sign * numerator, sign * denominator);
        let divisor =
            greatest_common_divisor(numerator.unsigned_abs(), denominator.unsigned_abs()) as i128;
        if divisor == 1 {
            return Some(Self {
                numerator,
                denominator,
            });
        }
        Some(Self {
            numerator: numerator / divisor,
            denominator: denominator / divisor,
        })
    }

    /// Reads a decimal such as `12.50`, `3`, `1e-4`; `None` where it is not a decimal or does not fit.
    pub fn from_decimal(text: &str) -> Option<Self> {
        let (signed, scale) = decimal::read(text)?;
        if signed == 0 {
            return Some(Self::ZERO);
        }
        let power = 10_i128.checked_pow(scale.unsigned_abs())?;
        if scale < 0 {
            Self::new(signed, power)
        } else {
            Self::new(signed.checked_mul(power)?, 1)
        }
    }

    /// The numerator; it bears the sign.
    pub fn numerator(self) -> i128 {
        self.numerator
    }

    /// The denominator, at least 1.
    pub fn denominator(self) -> i128 {
        self.denominator
    }

    /// Whether it is 0.
    pub fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Whether it is an integer.
    pub fn is_integer(self) -> bool {
        self.denominator == 1
    }

    /// Whether it is below 0.
    pub fn is_negative(self) -> bool {
        self.numerator < 0
    }

    /// Its magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        Self {
            numerator: self.numerator.abs(),
            ..self
        }
    }

    /// A sum, if it can be held.
    ///
    /// ```
    /// use vibank_dynamics::numerics::Rational;
    /// let half = Rational::new(1, 2).unwrap();
    /// assert_eq!(Rational::sum(&[half, half]), Some(Rational::ONE));
    /// ```
    pub fn sum(terms: &[Self]) -> Option<Self> {
        let mut terms = terms.iter();
        terms.try_fold(Self::ZERO, |sum, term| sum.checked_add(*term))
    }

    /// The sum.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        if self.is_integer() && other.is_integer() {
            return Self::new(self.numerator.checked_add(other.numerator)?, 1);
        }
        let left = self.numerator.checked_mul(other.denominator)?;
        let right = other.numerator.checked_mul(self.denominator)?;
        Self::new(
            left.checked_add(right)?,
            self.denominator.checked_mul(other.denominator)?,
        )
    }

    /// The difference.
    pub fn checked_sub(self, other: Self) -> Option<Self> {
        self.checked_add(-other)
    }

    /// The product.
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        // Dividing crosswise first keeps the factors as small as the result allows.
        let left = Self::new(self.numerator, other.denominator)?;
        let right = Self::new(other.numerator, self.denominator)?;
        Self::new(
            left.numerator.checked_mul(right.numerator)?,
            left.denominator.checked_mul(right.denominator)?,
        )
    }

    /// The quotient; `None` also for a zero divisor.
    pub fn checked_div(self, other: Self) -> Option<Self> {
        self.checked_mul(Self::new(other.denominator, other.numerator)?)
    }

    /// The power with a whole exponent; `None` also for a negative power of 0.
    pub fn checked_pow(self, exponent: i32) -> Option<Self> {
        let size = exponent.unsigned_abs();
        let (numerator, denominator) = (
            self.numerator.checked_pow(size)?,
            self.denominator.checked_pow(size)?,
        );
        if exponent < 0 {
            Self::new(denominator, numerator)
        } else {
            Self::new(numerator, denominator)
        }
    }

    /// The nearest binary64.
    pub fn to_f64(self) -> f64 {
        // Integers below 2⁵³ are binary64 numbers, whose quotient is rounded once.
        const EXACT: u64 = 1 << 53;
        let short = |own: i128| {
            i64::try_from(own)
                .ok()
                .filter(|own| own.unsigned_abs() < EXACT)
        };
        if let Some((above, below)) = short(self.numerator).zip(short(self.denominator)) {
            return above as f64 / below as f64;
        }
        let (high, low) = self.to_pair();
        high + low
    }

    /// The value as an unevaluated sum of two binary64, to about 106 bits.
    pub fn to_pair(self) -> (f64, f64) {
        divide_to_pair(self.numerator, self.denominator)
    }
}

/// The quotient of two integers as a double-double, by one step of long division in binary64.
fn divide_to_pair(numerator: i128, denominator: i128) -> (f64, f64) {
    let (high, low) = split(numerator);
    let (divisor_high, divisor_low) = split(denominator);
    let first = high / divisor_high;
    let remainder = (-first).mul_add(divisor_high, high) + (low - first * divisor_low);
    let second = remainder / divisor_high;
    let sum = first + second;
    (sum, second - (sum - first))
}

/// An integer as an unevaluated sum of two binary64.
fn split(value: i128) -> (f64, f64) {
    let high = value as f64;
    // The conversion back saturates at the far end of the range only, where the rest is still exact.
    (high, value.saturating_sub(high as i128) as f64)
}

fn greatest_common_divisor(mut a: u128, mut b: u128) -> u128 {
    if a == 1 || b == 1 {
        return 1;
    }
    while b != 0 {
        // Numbers of 64 bits, as nearly all are, divide many times quicker.
        (a, b) = match (u64::try_from(a), u64::try_from(b)) {
            (Ok(short), Ok(divisor)) => (b, u128::from(short % divisor)),
            _ => (b, a % b),
        };
    }
    a.max(1)
}

impl std::ops::Neg for Rational {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            numerator: -self.numerator,
            ..self
        }
    }
}

impl From<i32> for Rational {
    fn from(value: i32) -> Self {
        Self {
            numerator: i128::from(value),
            denominator: 1,
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    /// Exact: by whole parts first, then by the reciprocals of what is left.
    fn cmp(&self, other: &Self) -> Ordering {
        if self.denominator == other.denominator {
            return self.numerator.cmp(&other.numerator);
        }
        let rest = |r: &Self| (r.numerator.rem_euclid(r.denominator), r.denominator);
        self.numerator
            .div_euclid(self.denominator)
            .cmp(&other.numerator.div_euclid(other.denominator))
            .then_with(|| match (rest(self), rest(other)) {
                ((0, _), (0, _)) => Ordering::Equal,
                ((0, _), _) => Ordering::Less,
                (_, (0, _)) => Ordering::Greater,
                ((a, b), (c, d)) => Self {
                    numerator: d,
                    denominator: c,
                }
                .cmp(&Self {
                    numerator: b,
                    denominator: a,
                }),
            })
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator == 1 {
            return write!(formatter, "{}", self.numerator);
        }
        write!(formatter, "{}/{}", self.numerator, self.denominator)
    }
}
