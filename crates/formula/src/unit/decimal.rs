//! Exact decimals: the numbers that people write.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

use serde::{Deserialize, Serialize};
use vibank_notation::Math;

use super::error::{Error, ErrorKind};
use super::notation::DecimalMark;
use super::scale::{Scale, TENS};
use super::wide::Wide;
use super::{spoken, text, typeset};

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

    /// As people write it, in Unicode: `−2.50`, `3×10⁻⁴`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Decimal, DecimalMark};
    /// assert_eq!(Decimal::parse("-1.6e-4").unwrap().text(DecimalMark::Comma), "−1,6×10⁻⁴");
    /// ```
    pub fn text(&self, mark: DecimalMark) -> String {
        text::decimal(self, mark)
    }

    /// Typeset: `3 × 10⁻⁴` with a minus sign before it if need be.
    pub fn math(&self, mark: DecimalMark) -> Math {
        typeset::decimal(self, mark)
    }

    /// In English words where signs are not spoken: `minus 1.6 times 10 to the minus 4`.
    pub fn spoken(&self, mark: DecimalMark) -> String {
        spoken::decimal(self, mark)
    }

    /// The exact sum, with as many decimals as the longer one, if it fits.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        let exponent = self.exponent().min(other.exponent());
        let signed = |number: Self| {
            let digits =
                i128::try_from(digits_at(number.digits(), number.exponent(), exponent)?).ok()?;
            Some(if number.is_negative() {
                -digits
            } else {
                digits
            })
        };
        let sum = signed(self)?.checked_add(signed(other)?)?;
        Self::of_parts(sum < 0, sum.unsigned_abs(), exponent, false)
    }

    /// The exact difference, if it fits.
    pub fn checked_sub(self, other: Self) -> Option<Self> {
        self.checked_add(other.negated())
    }

    /// The exact product, if it fits.
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        let digits = self.digits().checked_mul(other.digits())?;
        Self::of_parts(
            self.is_negative() != other.is_negative(),
            digits,
            self.exponent() + other.exponent(),
            false,
        )
    }

    /// The same number with this many decimals, if no digit other than 0 is lost.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// let value = Decimal::parse("2.5").unwrap();
    /// assert_eq!(value.with_decimals(2).unwrap().to_string(), "2.50");
    /// assert_eq!(value.with_decimals(0), None);
    /// ```
    pub fn with_decimals(self, decimals: u32) -> Option<Self> {
        let exponent = -i32::try_from(decimals).ok()?;
        let (digits, own) = self.trimmed();
        let digits = digits_at(digits, own, exponent)?;
        Self::of_parts(self.is_negative(), digits, exponent, false)
    }

    /// How often `step` goes into this number, if it does so an integer number of times.
    pub(crate) fn whole_ratio(self, step: Self) -> Option<u64> {
        let exponent = self.exponent().min(step.exponent());
        let (digits, step_digits) = (
            digits_at(self.digits(), self.exponent(), exponent)?,
            digits_at(step.digits(), step.exponent(), exponent)?,
        );
        let whole = step_digits > 0
            && digits % step_digits == 0
            && (digits == 0 || self.is_negative() == step.is_negative());
        whole
            .then(|| u64::try_from(digits / step_digits).ok())
            .flatten()
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

/// The digits that a number has when the last one has the power `wanted`, which is not above the own one.
fn digits_at(digits: u128, own: i32, wanted: i32) -> Option<u128> {
    if digits == 0 {
        return Some(0);
    }
    let shift = u32::try_from(own - wanted).ok()?;
    digits.checked_mul(10_u128.checked_pow(shift)?)
}

impl Ord for Decimal {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_sign = sign(self).cmp(&sign(other));
        if by_sign.is_ne() || self.is_zero() {
            return by_sign;
        }
        // Of equal magnitude, so the shorter one can be brought to the length of the longer.
        let exponent = self.exponent().min(other.exponent());
        let by_size = self.magnitude().cmp(&other.magnitude()).then_with(|| {
            digits_at(self.digits(), self.exponent(), exponent).cmp(&digits_at(
                other.digits(),
                other.exponent(),
                exponent,
            ))
        });
        if self.is_negative() {
            by_size.reverse()
        } else {
            by_size
        }
    }
}

/// 1, 0 or −1.
fn sign(number: &Decimal) -> i8 {
    if number.is_zero() {
        0
    } else {
        1 - 2 * i8::from(number.is_negative())
    }
}

impl PartialOrd for Decimal {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Decimal {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Decimal {}

impl Hash for Decimal {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.is_negative(), self.trimmed()).hash(state);
    }
}

#[cfg(test)]
mod tests;
