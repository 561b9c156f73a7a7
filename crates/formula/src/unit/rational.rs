//! Small rational numbers: the exponents of units.

use std::cmp::Ordering;
use std::fmt;

/// An exact fraction in lowest terms, the exponent of a unit or a power.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Rational;
///
/// let half = Rational::new(-2, -4).unwrap();
/// assert_eq!(half.to_string(), "1/2");
/// assert_eq!(half.checked_add(half), Some(Rational::ONE));
/// assert_eq!(Rational::new(1, 0), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: i32,
    denominator: i32,
}

impl Rational {
    /// 0.
    pub const ZERO: Self = Self::integer(0);
    /// 1.
    pub const ONE: Self = Self::integer(1);

    /// The integer `n`.
    pub const fn integer(n: i32) -> Self {
        Self {
            numerator: n,
            denominator: 1,
        }
    }

    /// The fraction of two integers, unless the lower one is zero or the result does not fit.
    pub fn new(numerator: i32, denominator: i32) -> Option<Self> {
        Self::reduced(i64::from(numerator), i64::from(denominator))
    }

    fn reduced(numerator: i64, denominator: i64) -> Option<Self> {
        if denominator == 0 {
            return None;
        }
        let divisor = gcd(numerator, denominator) * denominator.signum();
        Some(Self {
            numerator: i32::try_from(numerator / divisor).ok()?,
            denominator: i32::try_from(denominator / divisor).ok()?,
        })
    }

    /// The number above the bar.
    pub const fn numerator(self) -> i32 {
        self.numerator
    }

    /// The number below the bar, positive.
    pub const fn denominator(self) -> i32 {
        self.denominator
    }

    /// Whether it is 0.
    pub const fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Whether it is below 0.
    pub const fn is_negative(self) -> bool {
        self.numerator < 0
    }

    /// Whether it is an integer.
    pub const fn is_integer(self) -> bool {
        self.denominator == 1
    }

    /// The sum, if it fits.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        let (a, b) = (i64::from(self.numerator), i64::from(self.denominator));
        let (c, d) = (i64::from(other.numerator), i64::from(other.denominator));
        Self::reduced((a * d).checked_add(c * b)?, b * d)
    }

    /// The product, if it fits.
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        Self::reduced(
            i64::from(self.numerator) * i64::from(other.numerator),
            i64::from(self.denominator) * i64::from(other.denominator),
        )
    }

    /// The opposite.
    #[must_use]
    pub const fn negated(self) -> Self {
        Self {
            numerator: self.numerator.saturating_neg(),
            denominator: self.denominator,
        }
    }

    /// The size without the sign.
    #[must_use]
    pub const fn abs(self) -> Self {
        if self.is_negative() {
            self.negated()
        } else {
            self
        }
    }
}

/// The greatest common divisor, at least 1.
pub(crate) fn gcd(a: i64, b: i64) -> i64 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    i64::try_from(a).unwrap_or(1).max(1)
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        let cross = |a: &Self, b: &Self| i64::from(a.numerator) * i64::from(b.denominator);
        cross(self, other).cmp(&cross(other, self))
    }
}

impl From<i32> for Rational {
    fn from(n: i32) -> Self {
        Self::integer(n)
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.denominator {
            1 => write!(f, "{}", self.numerator),
            denominator => write!(f, "{}/{denominator}", self.numerator),
        }
    }
}
