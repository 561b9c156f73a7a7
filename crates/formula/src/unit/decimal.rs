//! Exact decimals: the numbers that people write.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::error::{Error, ErrorKind};
use super::notation::DecimalMark;
use super::scale::{Scale, TENS};
use super::wide::Wide;

/// A decimal number, exact and as it was written: `2.50` has two decimals and stays so.
///
/// At most 38 significant digits, and a size from 10⁻³⁰⁰ to below 10³⁰¹ or zero, so that every decimal has a
/// binary64. Two decimals are equal if their values are: `2.5` equals `2.50`.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Decimal;
///
/// let value: Decimal = "2.50".parse().unwrap();
/// assert_eq!(value.to_string(), "2.50");
/// assert_eq!(value.decimals(), 2);
/// assert_eq!(value.to_f64(), 2.5);
/// assert_eq!(value, "2.5".parse().unwrap());
/// // Exact: three tenths are three times one tenth.
/// let tenth: Decimal = "0.1".parse().unwrap();
/// assert_eq!(tenth.checked_mul(3.into()), Some("0.3".parse().unwrap()));
/// ```
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Decimal {
    digits: u128,
    /// The power of ten of the last digit.
    exponent: i16,
    negative: bool,
    /// Whether it is printed with a power of ten.
    scientific: bool,
}

impl Decimal {
    /// How many significant digits are kept.
    // 10^38 is the largest power of ten below 2^127, the range of an `i128`.
    pub const MAX_DIGITS: u32 = 38;
    /// 0.
    pub const ZERO: Self = Self {
        digits: 0,
        exponent: 0,
        negative: false,
        scientific: false,
    };
    /// 1.
    pub const ONE: Self = Self {
        digits: 1,
        exponent: 0,
        negative: false,
        scientific: false,
    };

    /// The largest exponent of the first digit, up and down.
    const MAX_EXPONENT: i32 = 300;

    /// `±digits · 10^exponent`, if it is in range; without a sign for zero.
    pub(crate) fn of_parts(
        negative: bool,
        digits: u128,
        exponent: i32,
        scientific: bool,
    ) -> Option<Self> {
        let largest = exponent
            + if digits == 0 {
                0
            } else {
                digits.ilog10() as i32
            };
        let (exponent, scientific) = if digits == 0 {
            // A zero keeps as many decimals as a number can have digits, so that it prints within bounds.
            (exponent.clamp(-(Self::MAX_DIGITS as i32), 0), false)
        } else {
            (exponent, scientific)
        };
        let fits = digits < 10_u128.pow(Self::MAX_DIGITS) && largest.abs() <= Self::MAX_EXPONENT;
        let negative = negative && digits > 0;
        fits.then_some(Self {
            digits,
            exponent: exponent as i16,
            negative,
            scientific,
        })
    }

    /// Reads a decimal as it is written in files: digits, perhaps a point with digits on both sides, perhaps an exponent.
    ///
    /// # Errors
    ///
    /// If the text is something else, or has more than 38 significant digits, or is out of range.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// assert_eq!(Decimal::parse("-1.60e-2").unwrap().to_f64(), -0.016);
    /// assert!(Decimal::parse("1,5").is_err());
    /// assert!(Decimal::parse("1e400").is_err());
    /// ```
    pub fn parse(text: &str) -> Result<Self, Error> {
        let (decimal, length) = super::number::strict(text)?;
        if length < text.len() {
            return Err(Error::new(
                ErrorKind::NotANumber {
                    found: super::number::excerpt(text),
                },
                0..text.len(),
            ));
        }
        Ok(decimal)
    }

    /// Reads the decimal at the beginning of a text as people type it, `2,52`, `−1.6`, `1 200`, `3×10^-4`;
    /// returns also how many bytes it takes. Digits beyond the 38th are rounded away.
    ///
    /// # Errors
    ///
    /// If there is no number, or it is out of range, or its comma may separate decimals or thousands.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Decimal, DecimalMark};
    ///
    /// let (value, length) = Decimal::read("3×10^-4 m", DecimalMark::Point).unwrap();
    /// assert_eq!((value.to_f64(), &"3×10^-4 m"[length..]), (3e-4, " m"));
    /// assert_eq!(Decimal::read("2,52", DecimalMark::Point).unwrap().0.to_f64(), 2.52);
    /// assert!(Decimal::read("1,250", DecimalMark::Point).is_err());
    /// assert_eq!(Decimal::read("1,250", DecimalMark::Comma).unwrap().0.to_f64(), 1.25);
    /// ```
    pub fn read(text: &str, mark: DecimalMark) -> Result<(Self, usize), Error> {
        super::number::lenient(text, mark)
    }

    /// A computed number with this many significant figures, correctly rounded, ready to be printed:
    /// trailing zeros are kept, a power of ten is used where figures would not show or zeros be many,
    /// and zero is 0.
    /// Nothing for what is not finite or below 10⁻³⁰⁰ or above 10³⁰⁰.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// for (value, text) in [(15.0, "15.0"), (0.00123456, "0.00123"), (1234.5, "1.23e3"), (0.0, "0")] {
    ///     assert_eq!(Decimal::rounded(value, 3).unwrap().to_string(), text);
    /// }
    /// ```
    pub fn rounded(value: f64, figures: u32) -> Option<Self> {
        super::figures::rounded(value, figures)
    }

    /// The shortest decimal that reads back to the same binary64.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// assert_eq!(Decimal::shortest(0.1 + 0.2).unwrap().to_string(), "0.30000000000000004");
    /// ```
    pub fn shortest(value: f64) -> Option<Self> {
        super::figures::shortest(value)
    }

    /// Whether it is 0.
    pub const fn is_zero(&self) -> bool {
        self.digits == 0
    }

    /// Whether it is below 0.
    pub const fn is_negative(&self) -> bool {
        self.negative
    }

    /// Whether it is an integer.
    pub fn is_integer(&self) -> bool {
        self.trimmed().1 >= 0
    }

    /// Whether it is printed with a power of ten.
    pub(crate) const fn is_scientific(&self) -> bool {
        self.scientific
    }

    pub(crate) const fn digits(&self) -> u128 {
        self.digits
    }

    pub(crate) const fn exponent(&self) -> i32 {
        self.exponent as i32
    }

    /// The power of ten of the first digit; of the last one for zero.
    pub(crate) fn magnitude(&self) -> i32 {
        self.exponent()
            + if self.digits == 0 {
                0
            } else {
                self.digits.ilog10() as i32
            }
    }

    /// How many digits stand after the decimal point when it is written without a power of ten.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// assert_eq!(Decimal::parse("1.60e-2").unwrap().decimals(), 4);
    /// assert_eq!(Decimal::parse("1600").unwrap().decimals(), 0);
    /// ```
    pub fn decimals(&self) -> u32 {
        (-self.exponent()).max(0) as u32
    }

    /// How many of its digits are significant: trailing zeros count after a decimal point or before a power of ten.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// for (text, figures) in [("0.0160", 3), ("1600", 2), ("1.600e3", 4), ("0", 1)] {
    ///     assert_eq!(Decimal::parse(text).unwrap().significant_figures(), figures);
    /// }
    /// ```
    pub fn significant_figures(&self) -> u32 {
        let digits = if self.exponent < 0 || self.scientific {
            self.digits
        } else {
            self.trimmed().0
        };
        if digits == 0 { 1 } else { digits.ilog10() + 1 }
    }

    /// One unit of its last written digit: half of it is how well the number is known.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// assert_eq!(Decimal::parse("15.80").unwrap().last_place().to_f64(), 0.01);
    /// ```
    #[must_use]
    pub fn last_place(&self) -> Self {
        Self {
            digits: 1,
            negative: false,
            ..*self
        }
    }

    /// The digits and the exponent without trailing zeros.
    pub(crate) fn trimmed(&self) -> (u128, i32) {
        let (mut digits, mut exponent) = (self.digits, self.exponent());
        if digits == 0 {
            return (0, 0);
        }
        while digits % 10 == 0 {
            digits /= 10;
            exponent += 1;
        }
        (digits, exponent)
    }

    /// The nearest binary64, ties to even.
    pub fn to_f64(&self) -> f64 {
        self.scaled(Scale::ONE)
    }

    /// The nearest binary64 and the nearest to what it leaves, together at least 106 bits.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// let (high, low) = Decimal::parse("0.1").unwrap().to_pair();
    /// assert_eq!((high, low), (0.1, -5.551115123125783e-18));
    /// ```
    pub fn to_pair(&self) -> (f64, f64) {
        self.scaled_pair(Scale::ONE)
    }

    /// The product with a factor, rounded once.
    pub(crate) fn scaled(&self, scale: Scale) -> f64 {
        let size = match scale.as_power_of_ten().map(|power| power + self.exponent()) {
            // Both are exact in binary64, so their quotient or product is rounded once.
            Some(power @ -22..=-1) if self.digits < 1 << 53 => {
                self.digits as f64 / TENS[power.unsigned_abs() as usize]
            }
            Some(power @ 0..=22) if self.digits < 1 << 53 => {
                self.digits as f64 * TENS[power as usize]
            }
            _ => self.wide(scale).map_or(0.0, Wide::to_f64),
        };
        if self.negative { -size } else { size }
    }

    pub(crate) fn scaled_pair(&self, scale: Scale) -> (f64, f64) {
        let (high, low) = self.wide(scale).map_or((0.0, 0.0), Wide::to_pair);
        if self.negative {
            (-high, -low)
        } else {
            (high, low)
        }
    }

    fn wide(&self, scale: Scale) -> Option<Wide> {
        Some(
            scale
                .times(Scale::ten(self.exponent()))
                .apply(Wide::integer(self.digits)?),
        )
    }

    /// The opposite.
    #[must_use]
    pub const fn negated(self) -> Self {
        Self {
            negative: !self.negative && self.digits > 0,
            ..self
        }
    }

    /// The size without the sign.
    #[must_use]
    pub const fn abs(self) -> Self {
        Self {
            negative: false,
            ..self
        }
    }
}

impl From<u32> for Decimal {
    fn from(value: u32) -> Self {
        Self {
            digits: value.into(),
            ..Self::ZERO
        }
    }
}

impl From<u64> for Decimal {
    fn from(value: u64) -> Self {
        Self {
            digits: value.into(),
            ..Self::ZERO
        }
    }
}

impl From<i32> for Decimal {
    fn from(value: i32) -> Self {
        Self {
            digits: value.unsigned_abs().into(),
            negative: value < 0,
            ..Self::ZERO
        }
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        super::figures::write(f, self)
    }
}

impl fmt::Debug for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Decimal({self})")
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn decimal(text: &str) -> Decimal {
        Decimal::parse(text).unwrap_or_else(|error| panic!("`{text}`: {error}"))
    }

    #[test]
    fn numbers_stay_as_they_are_written() {
        for text in [
            "0",
            "0.00",
            "2.50",
            "-0.125",
            "1200",
            "1.60e-2",
            "3e4",
            "-1e-300",
            "12345678901234567890123456789012345678",
        ] {
            assert_eq!(decimal(text).to_string(), text);
        }
        for (text, printed) in [
            ("+5", "5"),
            ("-0", "0"),
            ("05.10", "5.10"),
            ("12.5e3", "1.25e4"),
            ("0e7", "0"),
            ("0.0e-240", "0.00000000000000000000000000000000000000"),
        ] {
            assert_eq!(decimal(text).to_string(), printed);
        }
    }

    #[test]
    fn bounds_are_refused_with_a_message() {
        for (text, message) in [
            ("", "a number is missing"),
            ("1e400", "the value is out of range"),
            ("1e-301", "the value is out of range"),
            ("1e99999999999999999999", "the value is out of range"),
            (
                "123456789012345678901234567890123456789",
                "more than 38 significant digits",
            ),
            ("NaN", "`NaN` is not a number"),
            ("inf", "`inf` is not a number"),
            ("1.", "`1.` is not a number"),
            (".5", "`.5` is not a number"),
            ("1e", "`1e` is not a number"),
            ("0x10", "`0x10` is not a number"),
        ] {
            assert_eq!(
                Decimal::parse(text).unwrap_err().to_string(),
                message,
                "`{text}`"
            );
        }
        assert!(Decimal::parse(&"1".repeat(10_000_000)).is_err());
    }

    /// Digits from the exact binary values, by Python's `decimal`.
    #[test]
    fn computed_numbers_are_rounded_from_their_exact_value() {
        for (value, figures, printed) in [
            (2.5, 1, "2"),
            (0.125, 2, "0.12"),
            (1.005, 3, "1.00"),
            (9.995, 3, "9.99"),
            (0.1, 20, "0.10000000000000000555"),
            (123_456.0, 4, "1.235e5"),
            (2.675, 3, "2.67"),
            (999.6, 3, "1.00e3"),
            (0.000_999_6, 3, "0.00100"),
            (0.000_999_4, 3, "9.99e-4"),
            (-158.0, 2, "-160"),
            (1e22, 5, "1.0000e22"),
        ] {
            assert_eq!(
                Decimal::rounded(value, figures).unwrap().to_string(),
                printed
            );
        }
        for value in [f64::NAN, f64::INFINITY, 5e-324, 1e305] {
            assert_eq!(Decimal::rounded(value, 3), None);
        }
    }

    prop_compose! {
        fn written()(sign in "-?", whole in "[0-9]{1,17}", tenths in "([.][0-9]{1,17})?", power in prop::option::of(-250_i32..250)) -> String {
            format!("{sign}{whole}{tenths}{}", power.map(|power| format!("e{power}")).unwrap_or_default())
        }
    }

    proptest! {
        #[test]
        fn values_agree_with_the_library(text in written()) {
            prop_assert_eq!(decimal(&text).to_f64(), text.parse::<f64>().unwrap());
        }

        #[test]
        fn reading_inverts_printing(text in written()) {
            let value = decimal(&text);
            prop_assert_eq!(value.to_string(), decimal(&value.to_string()).to_string());
            prop_assert_eq!(value, decimal(&value.to_string()));
            for mark in [DecimalMark::Point, DecimalMark::Comma] {
                let people = value.text(mark);
                match Decimal::read(&people, mark) {
                    Ok(read) => prop_assert_eq!(read, (value, people.len())),
                    Err(error) => prop_assert!(false, "{}: {}", people, error),
                }
            }
        }

        #[test]
        fn pairs_hold_what_is_left(text in written()) {
            let value = decimal(&text);
            let (high, low) = value.to_pair();
            prop_assert_eq!(high, value.to_f64());
            prop_assert_eq!(high + low, high);
            // With the exact value of the first number, the decimal leaves the second, to 30 digits and more.
            let (Some(exact), Some(rest)) = (Decimal::rounded(high, 30), Decimal::rounded(low, 15)) else { return Ok(()) };
            if let Some(left) = value.checked_sub(exact).filter(|_| exact.to_pair().1 == 0.0 && low != 0.0) {
                let difference = (left.to_f64() - rest.to_f64()).abs();
                prop_assert!(difference <= 1e-14 * low.abs(), "{} {}", left, rest);
            }
        }

        #[test]
        fn shortest_reads_back(value in any::<f64>()) {
            if let Some(shortest) = Decimal::shortest(value) {
                prop_assert_eq!(shortest.to_f64(), value);
                prop_assert_eq!(Decimal::rounded(value, 17).unwrap().to_f64(), value);
            }
        }

        #[test]
        fn any_text_is_read_or_refused_in_place(text in any::<String>()) {
            for error in [Decimal::parse(&text).err(), Decimal::read(&text, DecimalMark::Point).err()].into_iter().flatten() {
                prop_assert!(text.get(error.span).is_some());
            }
        }
    }
}
