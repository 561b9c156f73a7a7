//! Units: products of table units with rational powers.

use std::fmt;
use std::sync::LazyLock;

use serde::{Deserialize, Serialize};
use vibank_notation::{Math, Voice};

use super::conversion::Conversion;
use super::dimension::Dimension;
use super::error::{DimensionMismatch, Error};
use super::factor::{Builder, Factor, MAX_FACTORS};
use super::rational::Rational;
use super::scale::Scale;
use super::table::Turning;
use super::{lenient, spoken, strict, text, typeset};

/// A unit as it was written, `N m/rad`: what it measures, its exact factor to SI, and how it counts angles.
///
/// A quantity declared in a unit *holds* SI values, with angles in radians. Only where the unit counts
/// cycles in time, as Hz, rev/s and rpm do, it holds cycles per second.
///
/// `Display` writes the language of files, which [`parse`](Self::parse) reads back; for people there are
/// [`text`](Self::text), [`math`](Self::math) and [`spoken`](Self::spoken).
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::{Dimension, Unit};
///
/// let unit = Unit::parse("kN mm/rad").unwrap();
/// assert_eq!(unit.dimension(), Dimension::ENERGY);
/// assert_eq!(unit.to_si(2.5), 2.5);
/// assert_eq!(unit.to_string(), "kN mm/rad");
/// assert_eq!(unit.text(), "kN·mm/rad");
/// assert_eq!(Unit::read("m s-2").unwrap().text(), "m·s⁻²");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Unit {
    factors: [Factor; MAX_FACTORS],
    length: u8,
    angle: Angle,
    dimension: Dimension,
    scale: Scale,
}

/// How a unit counts angles, after [`Unit::conversion`]'s rule.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Angle {
    /// Not at all: it is taken to count as its partner does.
    #[default]
    Bare,
    /// In radians, which the scale already leads to.
    Radians,
    /// In full cycles, with this power.
    Cycles(Rational),
}

impl Unit {
    /// The unit of pure numbers, `1`.
    pub const ONE: Self = Self {
        factors: [Factor::NONE; MAX_FACTORS],
        length: 0,
        angle: Angle::Bare,
        dimension: Dimension::PURE,
        scale: Scale::ONE,
    };

    /// The radian, which readers of angles ask for with each number.
    pub fn radian() -> Self {
        static RADIAN: LazyLock<Unit> = LazyLock::new(|| Unit::parse("rad").unwrap_or(Unit::ONE));
        *RADIAN
    }

    /// The degree of an angle.
    pub fn degree() -> Self {
        static DEGREE: LazyLock<Unit> = LazyLock::new(|| Unit::parse("deg").unwrap_or(Unit::ONE));
        *DEGREE
    }

    /// Reads a unit as it is written in files: `N m/rad`, `N*m/rad`, `kg m^2`, `kg^(-1/2)`, `1/s`, `1`.
    ///
    /// A slash divides by the one factor after it, which may be a product in parentheses.
    ///
    /// # Errors
    ///
    /// If a unit is unknown, or a slash is followed by a product or by another slash.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{ErrorKind, Unit};
    ///
    /// assert_eq!(Unit::parse("N s^2/m").unwrap().dimension(), Unit::parse("kg").unwrap().dimension());
    /// assert_eq!(Unit::parse("J/kg/K").unwrap_err().kind, ErrorKind::SecondSlash);
    /// ```
    pub fn parse(text: &str) -> Result<Self, Error> {
        strict::unit(text)
    }

    /// Reads a unit as people type it: `N·m/rad`, `kg m²`, `Ns/m`, `N/(m/s)`, `m s-2`, `newton metres per radian`,
    /// `\mathrm{N\,m}`; nothing at all is `1`. What was understood can be printed back.
    ///
    /// Letters without a space between them are one unit if there is one (`ms` is a millisecond), else a product
    /// (`Ns` is a newton second, `Nms` a newton metre second).
    ///
    /// # Errors
    ///
    /// If a unit is unknown or has several meanings, with the nearest known unit or the meanings.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    ///
    /// assert_eq!(Unit::read("Ns/m").unwrap().to_string(), "N s/m");
    /// assert_eq!(Unit::read("N/(m/s)").unwrap().to_string(), "N s/m");
    /// assert_eq!(Unit::read("newton metres per radian").unwrap().to_string(), "N m/rad");
    /// assert_eq!(Unit::read("newtn").unwrap_err().help().unwrap(), "write `N`");
    /// ```
    pub fn read(text: &str) -> Result<Self, Error> {
        lenient::unit(text)
    }

    /// Reads the unit with which a text begins, as people type it, and the place where it ends.
    ///
    /// # Errors
    ///
    /// If the text begins with no unit, or with one that has more than one meaning.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    ///
    /// let (unit, end) = Unit::read_front("mm + 4i m").unwrap();
    /// assert_eq!((unit, end), (Unit::parse("mm").unwrap(), 2));
    /// assert!(Unit::read_front("and 5 m").is_err());
    /// ```
    pub fn read_front(text: &str) -> Result<(Self, usize), Error> {
        lenient::front(text)
    }

    pub(crate) fn of_factors(factors: &[Factor]) -> Option<Self> {
        let mut unit = Self {
            length: factors.len() as u8,
            ..Self::ONE
        };
        let (mut radians, mut cycles) = (false, Rational::ZERO);
        for (place, factor) in unit.factors.iter_mut().zip(factors) {
            *place = Factor {
                below: factor.below && factor.power.is_negative(),
                ..*factor
            };
            unit.dimension = unit.dimension * factor.row().dimension.pow(factor.power)?;
            unit.scale = unit.scale.times(factor.scale()?);
            match factor.row().turning {
                Turning::None => {}
                Turning::Radians => radians = true,
                Turning::Cycles => cycles = cycles.checked_add(factor.power)?,
            }
        }
        unit.angle = match (radians, cycles.is_zero()) {
            (false, true) => Angle::Bare,
            (true, true) => Angle::Radians,
            (false, false) if !unit.dimension.is_pure() => Angle::Cycles(cycles),
            (_, false) => {
                unit.scale = unit.scale.times(Scale::TURN.pow(cycles)?);
                Angle::Radians
            }
        };
        Some(unit)
    }

    pub(crate) fn factors(&self) -> &[Factor] {
        &self.factors[..usize::from(self.length)]
    }

    /// The factors above the slash.
    pub(crate) fn above(&self) -> impl Iterator<Item = &Factor> {
        self.factors().iter().filter(|factor| !factor.below)
    }

    /// The factors below the slash; their powers are negative.
    pub(crate) fn below(&self) -> impl Iterator<Item = &Factor> {
        self.factors().iter().filter(|factor| factor.below)
    }

    pub(crate) fn angle(&self) -> Angle {
        self.angle
    }

    /// The exact factor to the SI value that a quantity declared in this unit holds.
    pub(crate) fn scale(&self) -> Scale {
        self.scale
    }

    /// Whether the unit of this symbol, with any prefix, is one of its factors.
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    ///
    /// let rate = Unit::parse("mrad/s")?;
    /// assert!(rate.has_factor("rad") && rate.has_factor("s") && !rate.has_factor("Hz"));
    /// # Ok::<(), vibank_formula::unit::Error>(())
    /// ```
    pub fn has_factor(&self, symbol: &str) -> bool {
        let mut factors = self.factors().iter();
        factors.any(|factor| factor.row().symbols.contains(&symbol))
    }

    /// What it measures.
    pub const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Whether nothing is written: the unit of pure numbers.
    pub const fn is_one(&self) -> bool {
        self.length == 0
    }

    /// Whether it counts cycles, as Hz, rev/s and rpm do.
    pub const fn counts_cycles(&self) -> bool {
        matches!(self.angle, Angle::Cycles(_))
    }

    /// The unit without a factor in which a quantity declared in this unit holds its value: `N/m` for `kN/mm`,
    /// `rad` for `deg`, `Hz` for `rpm`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    /// let coherent = |unit| Unit::parse(unit).unwrap().coherent().to_string();
    /// assert_eq!(coherent("kN mm/deg"), "N m/rad");
    /// assert_eq!(coherent("g cm^2"), "kg m^2");
    /// assert_eq!(coherent("rpm"), "Hz");
    /// ```
    #[must_use]
    pub fn coherent(&self) -> Self {
        let mut coherent = Builder::new();
        for factor in self.factors() {
            let parts = Self::parse(self.coherent_name(*factor)).unwrap_or(Self::ONE);
            let start = coherent.len();
            if parts
                .factors()
                .iter()
                .try_for_each(|part| coherent.push(*part))
                .and_then(|()| coherent.raise(start, factor.power))
                .is_err()
            {
                return self.in_base_units();
            }
            for part in coherent.since(start) {
                part.below = part.power.is_negative() && (factor.below || part.below);
            }
        }
        coherent.finish().unwrap_or_else(|_| self.in_base_units())
    }

    /// The unit without a factor of which `factor` is a multiple.
    fn coherent_name(&self, factor: Factor) -> &'static str {
        let row = factor.row();
        match (row.turning, self.angle) {
            (Turning::Cycles, Angle::Radians) if row.dimension.is_pure() => "rad",
            (Turning::Cycles, Angle::Radians) => "rad/s",
            _ if row.coherent.is_empty() => row.symbols[0],
            _ => row.coherent,
        }
    }

    fn in_base_units(&self) -> Self {
        Self::parse(&self.dimension.to_string()).unwrap_or(Self::ONE)
    }

    /// The power with which angles enter: 1 in rad/s, Hz and rpm, -1 in N m/rad, 0 in N m.
    ///
    /// ```
    /// use vibank_formula::unit::{Rational, Unit};
    ///
    /// assert_eq!(Unit::parse("rad^2/s").unwrap().angles(), Some(Rational::integer(2)));
    /// assert_eq!(Unit::parse("m/s").unwrap().angles(), Some(Rational::ZERO));
    /// ```
    pub fn angles(&self) -> Option<Rational> {
        self.factors()
            .iter()
            .filter(|factor| factor.row().turning != Turning::None)
            .map(|factor| factor.power)
            .try_fold(Rational::ZERO, Rational::checked_add)
    }

    /// The SI value (radians; cycles where the unit counts them) of `value` in this unit, rounded once.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    /// assert_eq!(Unit::parse("deg").unwrap().to_si(180.0), std::f64::consts::PI);
    /// assert_eq!(Unit::parse("rpm").unwrap().to_si(90.0), 1.5);
    /// ```
    pub fn to_si(&self, value: f64) -> f64 {
        self.scale.apply_f64(value)
    }

    /// The value in this unit of the SI value `si`, rounded once; the inverse of [`to_si`](Self::to_si).
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    /// assert_eq!(Unit::parse("mm").unwrap().of_si(0.0016), 1.6);
    /// ```
    pub fn of_si(&self, si: f64) -> f64 {
        self.scale.inverse().apply_f64(si)
    }

    /// The product, with equal factors merged, unless it has too many factors or too large exponents.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    ///
    /// let (n, m) = (Unit::parse("N/m").unwrap(), Unit::parse("m").unwrap());
    /// assert_eq!(n.times(&m).unwrap().to_string(), "N");
    /// ```
    pub fn times(&self, other: &Self) -> Option<Self> {
        let mut merged = Builder::new();
        for &factor in self.factors().iter().chain(other.factors()) {
            match merged
                .since(0)
                .iter_mut()
                .find(|known| (known.row, known.prefix) == (factor.row, factor.prefix))
            {
                Some(known) => known.power = known.power.checked_add(factor.power)?,
                None => merged.push(factor).ok()?,
            }
        }
        let mut kept = Builder::new();
        for factor in merged
            .since(0)
            .iter()
            .filter(|factor| !factor.power.is_zero())
        {
            kept.push(*factor).ok()?;
        }
        kept.finish().ok()
    }

    /// A rational power, unless an exponent gets too large or too odd.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Rational, Unit};
    ///
    /// let unit = Unit::parse("N/m").unwrap();
    /// assert_eq!(unit.pow(Rational::integer(-1)).unwrap().to_string(), "m/N");
    /// ```
    pub fn pow(&self, power: Rational) -> Option<Self> {
        if power.is_zero() {
            return Some(Self::ONE);
        }
        let mut raised = Builder::of(self.factors());
        raised.raise(0, power).ok()?;
        for factor in raised.since(0) {
            factor.below = factor.power.is_negative() && (factor.below != power.is_negative());
        }
        vibank_dynamics::numerics::sort_by_key(raised.since(0), |factor| {
            factor.power.is_negative()
        });
        raised.finish().ok()
    }

    /// As people write it, in Unicode: `N·m/rad`, `m/s²`, `s⁻¹`, `kΩ`, `°`; nothing for pure numbers.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    /// assert_eq!(Unit::parse("kg m^2").unwrap().text(), "kg·m²");
    /// assert_eq!(Unit::parse("uF").unwrap().text(), "µF");
    /// assert_eq!(Unit::parse("1/s^2").unwrap().text(), "s⁻²");
    /// assert_eq!(Unit::parse("kg^(-1/2)").unwrap().text(), "kg^(−1/2)");
    /// ```
    pub fn text(&self) -> String {
        text::unit(self)
    }

    /// Typeset upright, with thin spaces between factors.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    ///
    /// let latex = |unit| Unit::parse(unit).unwrap().math().latex();
    /// assert_eq!(latex("N m/rad"), r"\mathrm{N}\,\mathrm{m}/\mathrm{rad}");
    /// assert_eq!(latex("1/s"), r"\mathrm{s}^{-1}");
    /// ```
    pub fn math(&self) -> Math {
        typeset::unit(self)
    }

    /// In words, for one or for several: `newton metres per radian`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    /// use vibank_notation::Voice;
    ///
    /// let spoken = |unit| Unit::parse(unit).unwrap().spoken(true, Voice::ENGLISH);
    /// assert_eq!(spoken("N m/rad"), "newton metres per radian");
    /// assert_eq!(spoken("m/s^2"), "metres per second squared");
    /// assert_eq!(spoken("kHz"), "kilohertz");
    /// assert_eq!(spoken("1/s"), "per second");
    /// ```
    pub fn spoken(&self, several: bool, voice: &Voice) -> String {
        spoken::unit(self, several, voice)
    }

    /// How a value written in this unit becomes the SI value of a quantity declared in `declared`.
    ///
    /// # Errors
    ///
    /// If the dimensions differ.
    pub fn conversion(&self, declared: &Self) -> Result<Conversion, DimensionMismatch> {
        Conversion::between(self, declared)
    }
}

impl fmt::Debug for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Unit({self})")
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn units() -> impl Strategy<Value = Unit> {
        let factor = "(kg|mm|s|N|rad|deg|Hz|kohm|min|g)(\\^(2|-1|-2|\\(1/2\\)|\\(-1/2\\)))?";
        prop::collection::vec(factor, 1..3)
            .prop_filter_map("a unit", |factors| Unit::parse(&factors.join(" ")).ok())
    }

    proptest! {
        #[test]
        fn units_form_a_group(a in units(), b in units(), c in units()) {
            let same = |x: &Unit, y: &Unit| (x.dimension, x.scale) == (y.dimension, y.scale);
            let (ab, ba) = (a.times(&b).unwrap(), b.times(&a).unwrap());
            prop_assert!(same(&ab, &ba));
            prop_assert!(same(&ab.times(&c).unwrap(), &a.times(&b.times(&c).unwrap()).unwrap()));
            prop_assert_eq!(a.times(&Unit::ONE).map(|unit| unit.dimension), Some(a.dimension));
            let inverse = a.pow(Rational::integer(-1)).unwrap();
            prop_assert!(a.times(&inverse).unwrap().is_one());
            prop_assert_eq!(ab.dimension, a.dimension * b.dimension);
        }

        #[test]
        fn conversions_come_back(unit in units(), value in -1e12_f64..1e12) {
            let back = unit.of_si(unit.to_si(value));
            // Two roundings.
            prop_assert!((back - value).abs() <= 2.0 * f64::EPSILON * value.abs(), "{} {}", value, back);
        }

        #[test]
        fn coherent_units_hold_the_same(unit in units()) {
            let coherent = unit.coherent();
            prop_assert_eq!((coherent.dimension, coherent.angle), (unit.dimension, unit.angle));
            prop_assert_eq!(coherent.scale, Scale::ONE, "{} {}", unit, coherent);
        }

        #[test]
        fn conversions_chain(a in units(), value in 1e-3_f64..1e3) {
            let si = Unit::parse("rad/s").unwrap();
            for text in ["Hz", "rpm", "rev/s", "deg/s", "1/s"] {
                let unit = Unit::parse(text).unwrap();
                let there = unit.conversion(&si).unwrap();
                let back = si.conversion(&unit).unwrap();
                let round = unit.of_si(back.apply(there.apply(value)));
                prop_assert!((round - value).abs() <= 4.0 * f64::EPSILON * value, "{}: {} {}", text, value, round);
            }
            prop_assert_eq!(a.conversion(&a).unwrap().apply(value), a.to_si(value));
        }
    }

    #[test]
    fn bounds_do_not_panic() {
        let large = Unit::parse("m^999 kg^999").unwrap();
        assert_eq!(large.times(&large), None);
        assert_eq!(large.pow(Rational::integer(1000)), None);
        let huge = Unit::parse("km^300").unwrap();
        assert_eq!((huge.to_si(1.0), huge.of_si(1.0)), (f64::INFINITY, 0.0));
        assert!(Unit::parse("m^(1/7) kg^(1/9) g^(1/8)").is_ok());
        assert!(Unit::parse("m^(1/11)").is_err());
    }

    #[test]
    fn every_row_has_its_coherent_unit() {
        for row in crate::unit::table::ROWS {
            let unit = Unit::parse(row.symbols[0]).unwrap();
            let coherent = unit.coherent();
            assert_eq!(
                (coherent.dimension, coherent.angle, coherent.scale),
                (unit.dimension, unit.angle, Scale::ONE)
            );
            assert_eq!(coherent.coherent(), coherent);
        }
    }

    #[test]
    fn factors_may_be_odd_roots() {
        // 10^(-3/7 - 3/9) by mpmath.
        let unit = Unit::parse("g^(1/7) L^(1/9)").unwrap();
        assert_eq!(unit.to_si(1.0), 0.173_019_573_884_589_4);
    }
}
