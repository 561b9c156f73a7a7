//! The exact sign of a sum of products of given numbers.
//!
//! Some answers are integers that depend on a comparison: a block rests where `k |x| <= mu m g`.
//! Rounded arithmetic cannot decide a tie, and ties are ordinary classroom data (`0.3` and `3 * 0.1`).
//! [`ExactNumber`] keeps a number as it was written, and [`sign_of_sum`] compares without rounding.

use std::cmp::Ordering;

use super::natural::Natural;
use super::{Dd, Rational, decimal};

/// A number exactly as it was given: a decimal, a binary64 or a fraction.
///
/// It is small and `Copy`; long arithmetic happens in [`sign_of_sum`] alone.
///
/// ```
/// use vibank_dynamics::numerics::{ExactNumber, sign_of_sum};
/// use std::cmp::Ordering;
/// let decimal = |text| ExactNumber::from_decimal(text).unwrap();
/// // As decimals 0.3 is three times 0.1; as binary64 it is not.
/// let three = ExactNumber::from(3_u64);
/// assert_eq!(sign_of_sum(&[&[decimal("0.3")], &[-three, decimal("0.1")]]), Ordering::Equal);
/// let binary = |value| ExactNumber::from_f64(value).unwrap();
/// assert_eq!(sign_of_sum(&[&[binary(0.3)], &[-three, binary(0.1)]]), Ordering::Less);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ExactNumber {
    /// The value is `numerator / denominator * 2^two * 5^five`.
    numerator: i128,
    denominator: i128,
    two: i32,
    five: i32,
    /// The value to about 105 bits.
    rounded: Dd,
}

/// The decimal exponents of the finite binary64, with room for the digits.
const EXPONENTS: std::ops::RangeInclusive<i32> = -400..=400;

impl ExactNumber {
    /// Zero.
    pub const ZERO: Self = Self {
        numerator: 0,
        denominator: 1,
        two: 0,
        five: 0,
        rounded: Dd::ZERO,
    };

    fn new(numerator: i128, denominator: i128, two: i32, five: i32) -> Self {
        let quotient = if denominator == 1 {
            dd_of(numerator)
        } else {
            dd_of(numerator) / dd_of(denominator)
        };
        Self {
            numerator,
            denominator,
            two,
            five,
            rounded: scale_by_ten(quotient, five).scale(two - five),
        }
    }

    /// The value of a binary64 to its last bit; `None` for an infinity or no number.
    pub fn from_f64(value: f64) -> Option<Self> {
        // The leading bit of a normal number is not stored.
        const FRACTION_BITS: u32 = f64::MANTISSA_DIGITS - 1;
        if !value.is_finite() {
            return None;
        }
        let bits = value.to_bits();
        let exponent = (bits >> FRACTION_BITS) as i32 & 0x7ff;
        let fraction = i128::from(bits & ((1 << FRACTION_BITS) - 1));
        let (magnitude, exponent) = match exponent {
            0 => (fraction, 1),
            _ => (fraction | 1 << FRACTION_BITS, exponent),
        };
        Some(Self {
            numerator: if value.is_sign_negative() {
                -magnitude
            } else {
                magnitude
            },
            denominator: 1,
            two: exponent - 1075,
            five: 0,
            rounded: Dd::from(value),
        })
    }

    /// Reads a decimal such as `-12.50`, `3` or `1e-4`; `None` where it is not a decimal, where it has more than
    /// 38 digits, or where it lies far outside of the range of binary64.
    pub fn from_decimal(text: &str) -> Option<Self> {
        let (signed, ten) = decimal::read(text)?;
        if signed == 0 {
            return Some(Self::ZERO);
        }
        EXPONENTS
            .contains(&ten)
            .then(|| Self::new(signed, 1, ten, ten))
    }

    /// The number that a binary64 stands for on paper: the shortest decimal that reads back to it.
    ///
    /// ```
    /// use vibank_dynamics::numerics::{ExactNumber, sign_of_sum};
    /// let sum = sign_of_sum(&[&[ExactNumber::on_paper(0.1).unwrap()], &[-ExactNumber::from_decimal("0.1").unwrap()]]);
    /// assert!(sum.is_eq());
    /// ```
    pub fn on_paper(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        Self::from_decimal(&format!("{value:e}"))
    }

    /// Whether it is 0.
    pub fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Its sign, as `-1`, `0` or `1`.
    pub fn signum(self) -> i32 {
        self.numerator.signum() as i32
    }

    /// Its magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.numerator < 0 { -self } else { self }
    }

    /// The value to about 105 bits.
    pub fn to_dd(self) -> Dd {
        self.rounded
    }

    /// The value in one binary64.
    pub fn to_f64(self) -> f64 {
        self.rounded.hi()
    }

    /// Whether both were given in the same way, which is sufficient to be equal, but not necessary.
    fn is_same(self, other: Self) -> bool {
        let parts = |number: Self| {
            (
                number.numerator,
                number.denominator,
                number.two,
                number.five,
            )
        };
        parts(self) == parts(other)
    }
}

impl From<u64> for ExactNumber {
    fn from(value: u64) -> Self {
        Self::new(i128::from(value), 1, 0, 0)
    }
}

impl From<Rational> for ExactNumber {
    fn from(value: Rational) -> Self {
        Self::new(value.numerator(), value.denominator(), 0, 0)
    }
}

impl std::ops::Neg for ExactNumber {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            numerator: -self.numerator,
            rounded: -self.rounded,
            ..self
        }
    }
}

/// Two numbers are equal if their values are, however they were given.
impl PartialEq for ExactNumber {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for ExactNumber {}

impl PartialOrd for ExactNumber {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for ExactNumber {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.is_same(*other) {
            Ordering::Equal
        } else {
            sign_of_sum(&[&[*self], &[-*other]])
        }
    }
}

/// The sign of a sum of products, without rounding. Where double-double arithmetic suffices, it decides.
pub fn sign_of_sum(terms: &[&[ExactNumber]]) -> Ordering {
    rounded_sign(terms).unwrap_or_else(|| exact_sign(terms))
}

/// The sign, if rounding cannot have changed it.
fn rounded_sign(terms: &[&[ExactNumber]]) -> Option<Ordering> {
    // Products of a dozen factors are right to 1e-29; the smallest and the largest lose their low parts.
    const RESOLUTION: f64 = 1e-26;
    const SAFE: std::ops::Range<f64> = 1e-250..1e290;
    let (mut sum, mut size) = (Dd::ZERO, 0.0);
    for factors in terms {
        // A zero is below the range that is safe, and would send the sum to long arithmetic for nothing.
        if factors.iter().any(|factor| factor.is_zero()) {
            continue;
        }
        let mut product = Dd::ONE;
        for factor in *factors {
            product *= factor.rounded;
            if !SAFE.contains(&factor.rounded.hi().abs()) || !SAFE.contains(&product.hi().abs()) {
                return None;
            }
        }
        sum += product;
        size += product.hi().abs();
    }
    (sum.hi().abs() > RESOLUTION * size).then(|| sum.hi().total_cmp(&0.0))
}

fn exact_sign(terms: &[&[ExactNumber]]) -> Ordering {
    let products: Vec<ExactProduct> = terms
        .iter()
        .map(|factors| ExactProduct::of(factors))
        .collect();
    let lowest = |power: fn(&ExactProduct) -> i32| products.iter().map(power).min().unwrap_or(0);
    let (two, five) = (
        lowest(|product| product.two),
        lowest(|product| product.five),
    );
    // Long numbers have no sign here; both sides are collected apart and compared at the end.
    let mut positive = Natural::ZERO;
    let mut negative = Natural::ZERO;
    for (at, product) in products.iter().enumerate() {
        let mut magnitude = product.numerator.clone();
        for other in products
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != at)
        {
            magnitude = &magnitude * &other.1.denominator;
        }
        magnitude.scale(2, product.two.abs_diff(two));
        magnitude.scale(5, product.five.abs_diff(five));
        let side = if product.is_negative {
            &mut negative
        } else {
            &mut positive
        };
        *side = &*side + &magnitude;
    }
    positive.cmp(&negative)
}

/// A product of given numbers, with its factors 2 and 5 apart.
struct ExactProduct {
    is_negative: bool,
    numerator: Natural,
    denominator: Natural,
    two: i32,
    five: i32,
}

impl ExactProduct {
    fn of(factors: &[ExactNumber]) -> Self {
        let mut product = Self {
            is_negative: false,
            numerator: Natural::one(),
            denominator: Natural::one(),
            two: 0,
            five: 0,
        };
        if factors.iter().any(|factor| factor.is_zero()) {
            product.numerator = Natural::ZERO;
            return product;
        }
        for factor in factors {
            product.is_negative ^= factor.numerator < 0;
            product.numerator = &product.numerator * &factor.numerator.unsigned_abs().into();
            product.denominator = &product.denominator * &factor.denominator.unsigned_abs().into();
            product.two += factor.two;
            product.five += factor.five;
        }
        product
    }
}

/// An integer as a double-double.
fn dd_of(value: i128) -> Dd {
    let high = value as f64;
    // The conversion back saturates at the far end of the range only, where the rest is still exact.
    Dd::sum(high, value.saturating_sub(high as i128) as f64)
}

/// `value * 10^exponent`, in steps by powers of ten that are exact.
fn scale_by_ten(mut value: Dd, exponent: i32) -> Dd {
    // 10^22 is the largest power of ten that binary64 holds exactly, as 5^22 is less than 2^53.
    const STEP: u32 = 22;
    // Spares the power of 128-bit integers in all steps but the last.
    const EXACT_POWER: f64 = 1e22;
    let mut left = exponent.unsigned_abs();
    while left > 0 {
        let step = left.min(STEP);
        let power = if step == STEP {
            EXACT_POWER
        } else {
            10_u128.pow(step) as f64
        };
        value = if exponent < 0 {
            value / power
        } else {
            value * power
        };
        left -= step;
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decimal(text: &str) -> ExactNumber {
        ExactNumber::from_decimal(text).unwrap()
    }

    fn compare(left: &[ExactNumber], right: &[ExactNumber]) -> Ordering {
        let mut negated = right.to_vec();
        negated[0] = -negated[0];
        sign_of_sum(&[left, &negated])
    }

    #[test]
    fn decimals_are_read_as_written() {
        for (text, other) in [
            ("12.50", "125e-1"),
            ("-.5", "-0.50"),
            ("+3.", "3"),
            ("0.000", "-0e99"),
            ("1e-320", "0.1E-319"),
        ] {
            assert_eq!(
                compare(&[decimal(text)], &[decimal(other)]),
                Ordering::Equal,
                "{text}"
            );
            assert_eq!(decimal(text).to_f64(), text.parse::<f64>().unwrap());
        }
    }

    #[test]
    fn what_is_no_decimal_is_refused() {
        for text in [
            "", ".", "-", "1e", "1e1e1", "0x1", "1_000", "nan", "1e999", "1e-999", "--1", "1.2.3",
            "٣",
        ] {
            assert!(ExactNumber::from_decimal(text).is_none(), "{text}");
        }
        assert!(ExactNumber::from_decimal(&"9".repeat(39)).is_none());
        assert!(ExactNumber::from_f64(f64::NAN).is_none());
        assert!(ExactNumber::on_paper(f64::INFINITY).is_none());
    }

    #[test]
    fn binary_numbers_keep_every_bit() {
        for value in [0.1, -3.5, 5e-324, f64::MAX, f64::MIN_POSITIVE, 0.0] {
            let exact = ExactNumber::from_f64(value).unwrap();
            assert_eq!(exact.to_f64(), value);
            assert_eq!(exact.to_dd(), Dd::from(value));
        }
        // 0.1 is not a binary64, and lies below the one that stands for it.
        let binary = ExactNumber::from_f64(0.1).unwrap();
        assert_eq!(compare(&[decimal("0.1")], &[binary]), Ordering::Less);
    }

    #[test]
    fn values_have_a_hundred_bits() {
        let error =
            |text: &str, expected: Dd| ((decimal(text).to_dd() - expected) / expected).hi().abs();
        assert!(error("0.1", Dd::ONE / 10.0) < 1e-31);
        assert!(error("3.14159265358979323846264338327950288", Dd::PI) < 1e-31);
        assert!(error("1e-200", Dd::from(10.0).powi(-200)) < 1e-29);
    }

    #[test]
    fn products_tie_exactly() {
        let five = ExactNumber::from(5_u64);
        let third = ExactNumber::from(Rational::new(1, 3).unwrap());
        assert_eq!(
            compare(
                &[five, decimal("0.1"), decimal("9.81")],
                &[decimal("4.905")]
            ),
            Ordering::Equal
        );
        assert_eq!(
            compare(&[third, decimal("0.3")], &[decimal("0.1")]),
            Ordering::Equal
        );
        assert_eq!(
            compare(
                &[third, decimal("0.3")],
                &[decimal("0.10000000000000000000000000000000001")]
            ),
            Ordering::Less
        );
        assert_eq!(sign_of_sum(&[]), Ordering::Equal);
        assert_eq!(
            sign_of_sum(&[&[ExactNumber::ZERO, five], &[-third]]),
            Ordering::Less
        );
    }
}
