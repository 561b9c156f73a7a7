//! Quantities: a decimal and a unit, as they are written.

use std::fmt;

use serde::{Deserialize, Serialize};
use vibank_notation::Math;

use super::conversion::Conversion;
use super::decimal::Decimal;
use super::error::{DimensionMismatch, Error, ErrorKind};
use super::notation::DecimalMark;
use super::product::Unit;
use super::scanner::Scanner;
use super::{lenient, number, spoken, strict, text, typeset};

/// A value with its unit, `12.5 cm`, kept as it was written; a pure number has the unit [`Unit::ONE`].
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Quantity;
///
/// let radius = Quantity::parse("12.50 cm").unwrap();
/// assert_eq!(radius.si(), 0.125);
/// assert_eq!(radius.to_string(), "12.50 cm");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Quantity {
    /// The number before the unit.
    pub value: Decimal,
    /// The unit after the number, [`Unit::ONE`] where there is none.
    pub unit: Unit,
}

impl Quantity {
    /// A value in a unit.
    pub const fn new(value: Decimal, unit: Unit) -> Self {
        Self { value, unit }
    }

    /// A pure number.
    pub const fn pure(value: Decimal) -> Self {
        Self {
            value,
            unit: Unit::ONE,
        }
    }

    /// Reads a quantity as it is written in files: `12.5 cm`, `2kg`, `0.3`.
    ///
    /// # Errors
    ///
    /// If the number or the unit cannot be read, or the SI value is no finite number.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Quantity;
    ///
    /// assert_eq!(Quantity::parse("1.2 kN/m").unwrap().si(), 1200.0);
    /// let error = Quantity::parse("12.5 inch").unwrap_err();
    /// assert_eq!(error.span, 5..9);
    /// assert_eq!(error.to_string(), "`inch` is not a known unit");
    /// ```
    pub fn parse(text: &str) -> Result<Self, Error> {
        let mut scanner = Scanner::new(text)?;
        scanner.space();
        let value = strict_number(&mut scanner)?;
        scanner.space();
        let unit = if scanner.is_at_end() {
            Unit::ONE
        } else {
            strict::rest(scanner)?
        };
        Self::new(value, unit).checked(text)
    }

    /// Reads a quantity as people type it: `2,52 Hz`, `3×10^-4 m`, `5 Ns/m`, `180°`, `0.5/s`.
    ///
    /// # Errors
    ///
    /// As for [`Decimal::read`] and [`Unit::read`].
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{DecimalMark, Quantity};
    ///
    /// let read = |text| Quantity::read(text, DecimalMark::Point).unwrap().to_string();
    /// assert_eq!(read("2,52 Hz"), "2.52 Hz");
    /// assert_eq!(read("5Ns/m"), "5 N s/m");
    /// assert_eq!(read("0.25 N/(m/s)"), "0.25 N s/m");
    /// assert_eq!(read("−3·10⁻⁴ kg·m²"), "-3e-4 kg m^2");
    /// ```
    pub fn read(text: &str, mark: DecimalMark) -> Result<Self, Error> {
        let trimmed = text.trim();
        let offset = text.len() - text.trim_start().len();
        let (value, length) =
            number::lenient(trimmed, mark).map_err(|error| error.shifted(offset))?;
        let unit = lenient::after_number(&trimmed[length..])
            .map_err(|error| error.shifted(offset + length))?;
        Self::new(value, unit).checked(text)
    }

    /// This quantity, if its SI value is a finite number, and zero only if it is.
    pub(crate) fn checked(self, text: &str) -> Result<Self, Error> {
        // Four bits for each decimal digit: most quantities are seen to be in range without being converted.
        let is_moderate =
            || self.unit.scale().most_bits() + 4 * i64::from(self.value.magnitude().abs()) < 1000;
        let is_in_range = |si: f64| si.is_finite() && (si != 0.0 || self.value.is_zero());
        if is_moderate() || is_in_range(self.si()) {
            return Ok(self);
        }
        Err(Error::new(ErrorKind::OutOfRange, 0..text.len()))
    }

    /// The SI value, rounded once: angles in radians, cycles where the unit counts them.
    pub fn si(&self) -> f64 {
        self.value.scaled(self.unit.scale())
    }

    /// The SI value as the sum of two numbers, exact to at least 106 bits.
    pub fn si_pair(&self) -> (f64, f64) {
        self.value.scaled_pair(self.unit.scale())
    }

    /// How it becomes the SI value of a quantity declared in `declared`. Zero without a unit fits everywhere.
    ///
    /// # Errors
    ///
    /// If the dimensions differ.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Quantity, Unit};
    ///
    /// let (typed, declared) = (Quantity::parse("90 rpm").unwrap(), Unit::parse("Hz").unwrap());
    /// assert_eq!(typed.conversion(&declared).unwrap().apply_decimal(&typed.value), 1.5);
    /// assert!(Quantity::parse("0").unwrap().conversion(&declared).is_ok());
    /// assert!(Quantity::parse("1").unwrap().conversion(&declared).is_err());
    /// ```
    pub fn conversion(&self, declared: &Unit) -> Result<Conversion, DimensionMismatch> {
        let unit = if self.value.is_zero() && self.unit.is_one() {
            declared
        } else {
            &self.unit
        };
        unit.conversion(declared)
    }

    /// The SI value that a quantity declared in `declared` holds if this is read for it.
    ///
    /// # Errors
    ///
    /// If the dimensions differ.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Quantity, Unit};
    ///
    /// let declared = Unit::parse("rad/s").unwrap();
    /// assert_eq!(Quantity::parse("0.5 Hz").unwrap().si_for(&declared), Ok(std::f64::consts::PI));
    /// ```
    pub fn si_for(&self, declared: &Unit) -> Result<f64, DimensionMismatch> {
        Ok(self.conversion(declared)?.apply_decimal(&self.value))
    }

    /// As people write it, in Unicode: `2.0 kg`, `3×10⁻⁴ m/s²`, `30°`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{DecimalMark, Quantity};
    /// let text = |quantity| Quantity::parse(quantity).unwrap().text(DecimalMark::Point);
    /// assert_eq!(text("3e-4 N m/rad"), "3×10⁻⁴ N·m/rad");
    /// assert_eq!(text("30 deg"), "30°");
    /// ```
    pub fn text(&self, mark: DecimalMark) -> String {
        text::quantity(self, mark)
    }

    /// Typeset: the number, a thin space and the unit; the sign of degrees is raised right after the number.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{DecimalMark, Quantity};
    ///
    /// let latex = |text| Quantity::parse(text).unwrap().math(DecimalMark::Point).latex();
    /// assert_eq!(latex("-2.50 kg m^2"), r"-2.50\,\mathrm{kg}\,\mathrm{m}^2");
    /// assert_eq!(latex("30 deg"), r"30^\circ");
    /// ```
    pub fn math(&self, mark: DecimalMark) -> Math {
        typeset::quantity(self, mark)
    }

    /// In English words: `2.0 kilograms`, `1 newton metre`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{DecimalMark, Quantity};
    ///
    /// let spoken = |text| Quantity::parse(text).unwrap().spoken(DecimalMark::Point);
    /// assert_eq!(spoken("2.0 kg"), "2.0 kilograms");
    /// assert_eq!(spoken("1 kN m"), "1 kilonewton metre");
    /// assert_eq!(spoken("-3e-4 m"), "minus 3 times 10 to the minus 4 metres");
    /// ```
    pub fn spoken(&self, mark: DecimalMark) -> String {
        spoken::quantity(self, mark)
    }
}

/// Reads a number as files have it.
pub(crate) fn strict_number(scanner: &mut Scanner<'_>) -> Result<Decimal, Error> {
    let offset = scanner.at();
    let (value, length) = number::strict(scanner.rest()).map_err(|error| error.shifted(offset))?;
    scanner.takes_text(&scanner.rest()[..length]);
    Ok(value)
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)?;
        if self.unit.is_one() {
            Ok(())
        } else {
            write!(f, " {}", self.unit)
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Exact values rounded to binary64 and to a pair, by mpmath with 500 bits.
    #[test]
    fn si_values_are_rounded_once() {
        for (text, high, low) in [
            (
                "12.5 deg",
                0.218_166_156_499_291_2,
                5.420_538_814_564_518e-18,
            ),
            (
                "0.7 g^(1/2)",
                0.022_135_943_621_178_655,
                -3.249_558_399_974_289e-21,
            ),
            (
                "7 m/h",
                0.001_944_444_444_444_444_4,
                5.589_664_533_703_045e-20,
            ),
            ("1500 rpm", 25.0, 0.0),
        ] {
            let quantity = Quantity::parse(text).unwrap();
            assert_eq!(
                (quantity.si(), quantity.si_pair()),
                (high, (high, low)),
                "{text}"
            );
        }
        assert_eq!(Quantity::parse("1.37 g0").unwrap().si(), 13.435_110_5);
        assert_eq!(
            Quantity::parse("30 deg").unwrap().si(),
            std::f64::consts::FRAC_PI_6
        );
    }

    /// The rule of angular and cyclic frequency, by mpmath.
    #[test]
    fn only_reading_converts_by_two_pi() {
        for (typed, declared, si, applies) in [
            ("2.52 Hz", "rad/s", 15.833_626_974_092_558, true),
            ("1500 rpm", "rad/s", 157.079_632_679_489_66, true),
            ("10 rad/s", "Hz", 1.591_549_430_918_953_3, true),
            ("10 rad/s", "rev/s", 1.591_549_430_918_953_3, true),
            ("10 rad/s", "rad/s", 10.0, false),
            ("90 rpm", "Hz", 1.5, false),
            ("90 rpm", "rev/s", 1.5, false),
            ("2 rev/s", "Hz", 2.0, false),
            ("10 1/s", "rad/s", 10.0, false),
            ("10 1/s", "Hz", 10.0, false),
            ("10 s^-1", "rpm", 10.0, false),
            ("10 rad/s", "1/s", 10.0, false),
            ("10 Hz", "1/s", 10.0, false),
            ("2 rev", "rad", 4.0 * std::f64::consts::PI, false),
            ("180 deg", "rad", std::f64::consts::PI, false),
            ("180 deg", "1", std::f64::consts::PI, false),
            ("45 N m/deg", "N m/rad", 2_578.310_078_088_704_4, false),
            ("45 N m", "N m/rad", 45.0, false),
            ("45 N m/rad", "J", 45.0, false),
            ("0", "kg", 0.0, false),
            ("5 %", "1", 0.05, false),
        ] {
            let (typed_quantity, unit) = (
                Quantity::parse(typed).unwrap(),
                Unit::parse(declared).unwrap(),
            );
            let conversion = typed_quantity
                .conversion(&unit)
                .unwrap_or_else(|error| panic!("{typed}: {error}"));
            let found = (
                conversion.apply_decimal(&typed_quantity.value),
                conversion.applies_two_pi(),
            );
            assert_eq!(found, (si, applies), "{typed} for {declared}");
        }
    }

    #[test]
    fn a_quantity_declared_in_turns_holds_radians() {
        assert_eq!(
            Quantity::parse("2 rev").unwrap().si(),
            4.0 * std::f64::consts::PI
        );
        assert!(!Unit::parse("rev").unwrap().counts_cycles());
        assert!(Unit::parse("rev/s").unwrap().counts_cycles());
    }

    #[test]
    fn reads_answers_as_they_are_typed() {
        for (typed, meant) in [
            ("15.8 rad/s", "15.8 rad/s"),
            ("2,52 Hz", "2.52 Hz"),
            ("1.6e-2 m", "1.6e-2 m"),
            ("3×10^-4", "3e-4"),
            ("180°", "180 deg"),
            ("180 ^\\circ", "180 deg"),
            ("5 %", "5 %"),
            ("0.5/s", "0.5 1/s"),
            ("5 1/s", "5 1/s"),
            ("12 per second", "12 1/s"),
            ("1.5 kg m²", "1.5 kg m^2"),
            ("2·10³·N/m", "2e3 N/m"),
            ("  7 mm  ", "7 mm"),
            ("2 \\,\\mathrm{kg}", "2 kg"),
            ("5 m.", "5 m"),
        ] {
            let read = Quantity::read(typed, DecimalMark::Point)
                .unwrap_or_else(|error| panic!("`{typed}`: {error}"));
            assert_eq!(read.to_string(), meant, "`{typed}`");
        }
    }

    #[test]
    fn places_of_errors_are_those_in_the_whole_text() {
        for (typed, place) in [
            ("  5 furlong ", "furlong"),
            ("5 N/m s", "s"),
            (" x", "x"),
            ("1,250 m", "1,250"),
        ] {
            let error = Quantity::read(typed, DecimalMark::Point).unwrap_err();
            assert_eq!(&typed[error.span], place, "`{typed}`");
        }
        assert_eq!(
            Quantity::parse("1e300 Tm^64").unwrap_err().kind,
            ErrorKind::OutOfRange
        );
    }

    #[test]
    fn printing_for_people() {
        for (text, people, spoken) in [
            ("2.0 kg", "2.0 kg", "2.0 kilograms"),
            (
                "-3e-4 m",
                "−3×10⁻⁴ m",
                "minus 3 times 10 to the minus 4 metres",
            ),
            ("90 deg", "90°", "90 degrees"),
            ("5 kohm", "5 kΩ", "5 kiloohms"),
            ("1 H", "1 H", "1 henry"),
            ("2 1/s", "2 s⁻¹", "2 per second"),
            (
                "3 kg^(-1/2)",
                "3 kg^(−1/2)",
                "3 kilograms to the power minus one half",
            ),
            (
                "4 J/(kg K)",
                "4 J/(kg·K)",
                "4 joules per kilogram per kelvin",
            ),
            ("1.5 uF", "1.5 µF", "1.5 microfarads"),
            ("0.25", "0.25", "0.25"),
        ] {
            let quantity = Quantity::parse(text).unwrap();
            assert_eq!(
                (
                    quantity.text(DecimalMark::Point),
                    quantity.spoken(DecimalMark::Point)
                ),
                (people.into(), spoken.into())
            );
        }
    }

    proptest! {
        #[test]
        fn reading_inverts_printing(digits in -99_999_i32..99_999, places in 0_u32..6, unit in "(mm|kg m\\^2|N m/rad|1/s|rpm|deg|kg\\^\\(-1/2\\)|uF)") {
            let value = Decimal::from(digits).checked_mul(Decimal::parse(&format!("1e-{places}")).unwrap()).unwrap();
            let quantity = Quantity::new(value, Unit::parse(&unit).unwrap());
            prop_assert_eq!(Quantity::parse(&quantity.to_string()), Ok(quantity));
            for mark in [DecimalMark::Point, DecimalMark::Comma] {
                let read = Quantity::read(&quantity.text(mark), mark);
                prop_assert_eq!(read.map(|read| (read.value, read.si_for(&quantity.unit))), Ok((quantity.value, Ok(quantity.si()))));
            }
        }

        #[test]
        fn any_text_is_read_or_refused_in_place(number in "-?[0-9]{0,4}[.,]?[0-9]{0,4}(e-?[0-9])?", unit in any::<String>()) {
            let text = format!("{number}{unit}");
            for error in [Quantity::parse(&text).err(), Quantity::read(&text, DecimalMark::Point).err()].into_iter().flatten() {
                prop_assert!(text.get(error.span).is_some());
            }
        }
    }
}
