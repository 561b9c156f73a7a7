//! Dimensions: what can be added to what.

use std::fmt;
use std::ops::{Div, Mul};

use serde::{Deserialize, Serialize};

use super::error::Error;
use super::product::Unit;
use super::rational::{Rational, gcd};

/// Exponents are counted in this part of one, so that all fractions with a denominator up to 10 are exact.
pub(crate) const PARTS: i32 = 2520;

/// The largest exponent that a power may give.
// Times the parts it is 2.5 million, which leaves room for sums in 32 bits.
const MAX_EXPONENT: i32 = 1000;

/// The dimension of a quantity: rational exponents of the seven base quantities.
///
/// Angles have dimension 1, so `x = r*theta` and `N m/rad` agree with `m` and `N m`.
/// Products and quotients are exact as long as exponents stay below 800,000, which formulas cannot reach.
///
/// It prints in base units; [`describe`](Self::describe) knows the names of the textbooks.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Dimension;
///
/// let stiffness = Dimension::FORCE / Dimension::LENGTH;
/// let omega = (stiffness / Dimension::MASS).sqrt().unwrap();
/// assert_eq!(omega, Dimension::FREQUENCY);
/// assert_eq!(stiffness.to_string(), "kg/s^2");
/// assert_eq!(stiffness.describe(), "N/m");
/// ```
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(into = "String", try_from = "String")]
pub struct Dimension([i32; 7]);

/// The base units in which a dimension is printed, in the order of the exponents.
const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

impl Dimension {
    /// Of pure numbers and angles.
    pub const PURE: Self = Self::of([0; 7]);
    /// Of masses, kg.
    pub const MASS: Self = Self::of([1, 0, 0, 0, 0, 0, 0]);
    /// Of lengths, m.
    pub const LENGTH: Self = Self::of([0, 1, 0, 0, 0, 0, 0]);
    /// Of times, s.
    pub const TIME: Self = Self::of([0, 0, 1, 0, 0, 0, 0]);
    /// Of electric currents, A.
    pub const CURRENT: Self = Self::of([0, 0, 0, 1, 0, 0, 0]);
    /// Of temperatures, K.
    pub const TEMPERATURE: Self = Self::of([0, 0, 0, 0, 1, 0, 0]);
    /// Of amounts of substance, mol.
    pub const AMOUNT: Self = Self::of([0, 0, 0, 0, 0, 1, 0]);
    /// Of luminous intensities, cd.
    pub const LUMINOUS_INTENSITY: Self = Self::of([0, 0, 0, 0, 0, 0, 1]);
    /// Of frequencies, angular frequencies and decay rates, 1/s.
    pub const FREQUENCY: Self = Self::of([0, 0, -1, 0, 0, 0, 0]);
    /// Of velocities, m/s.
    pub const VELOCITY: Self = Self::of([0, 1, -1, 0, 0, 0, 0]);
    /// Of accelerations, m/s².
    pub const ACCELERATION: Self = Self::of([0, 1, -2, 0, 0, 0, 0]);
    /// Of forces, N.
    pub const FORCE: Self = Self::of([1, 1, -2, 0, 0, 0, 0]);
    /// Of energies and moments, J and N m.
    pub const ENERGY: Self = Self::of([1, 2, -2, 0, 0, 0, 0]);
    /// Of powers, W.
    pub const POWER: Self = Self::of([1, 2, -3, 0, 0, 0, 0]);

    /// The dimension with these whole exponents of mass, length, time, current, temperature, amount and
    /// luminous intensity.
    pub const fn of(exponents: [i8; 7]) -> Self {
        let mut parts = [0; 7];
        let mut i = 0;
        while i < 7 {
            parts[i] = exponents[i] as i32 * PARTS;
            i += 1;
        }
        Self(parts)
    }

    /// The dimension of a unit, in the language of files: `kg m/s^2` or `N`.
    ///
    /// # Errors
    ///
    /// As for [`Unit::parse`].
    pub fn parse(unit: &str) -> Result<Self, Error> {
        Unit::parse(unit).map(|unit| unit.dimension())
    }

    /// Whether it is that of pure numbers and angles.
    pub fn is_pure(self) -> bool {
        self == Self::PURE
    }

    /// The exponents of mass, length, time, current, temperature, amount and luminous intensity.
    pub fn exponents(self) -> [Rational; 7] {
        self.0
            .map(|parts| Rational::new(parts, PARTS).unwrap_or(Rational::ZERO))
    }

    /// The reciprocal.
    #[must_use]
    pub fn inverse(self) -> Self {
        Self(self.0.map(i32::saturating_neg))
    }

    /// A rational power, unless an exponent gets a denominator above 10 or a value above 1000.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Dimension, Rational};
    /// assert_eq!(Dimension::LENGTH.pow(Rational::integer(2)).unwrap().to_string(), "m^2");
    /// assert_eq!(Dimension::LENGTH.pow(Rational::new(1, 11).unwrap()), None);
    /// ```
    pub fn pow(self, power: Rational) -> Option<Self> {
        raise(self.0, power).map(Self)
    }

    /// The square root, unless an exponent gets a denominator above 10.
    pub fn sqrt(self) -> Option<Self> {
        self.pow(Rational::new(1, 2)?)
    }

    /// The unit that a textbook would write: `N/m` for `kg/s^2`; base units where there is no better one.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::unit::{Dimension, Unit};
    /// assert_eq!(Dimension::ENERGY.describe(), "J");
    /// assert_eq!(Unit::parse("kg/s").unwrap().dimension().describe(), "N s/m");
    /// ```
    pub fn describe(self) -> String {
        match NAMED
            .iter()
            .find(|(exponents, _)| Self::of(*exponents) == self)
        {
            Some((_, name)) => (*name).to_owned(),
            None => self.to_string(),
        }
    }
}

/// Exponents times a power, unless a result is not a whole number of parts or too large.
pub(crate) fn raise<const N: usize>(exponents: [i32; N], power: Rational) -> Option<[i32; N]> {
    if power == Rational::ONE {
        return Some(exponents);
    }
    let mut raised = exponents;
    for exponent in raised.iter_mut().filter(|exponent| **exponent != 0) {
        let product = i64::from(*exponent) * i64::from(power.numerator());
        let denominator = i64::from(power.denominator());
        if product % denominator != 0
            || (product / denominator).abs() > i64::from(MAX_EXPONENT) * i64::from(PARTS)
        {
            return None;
        }
        *exponent = (product / denominator) as i32;
    }
    Some(raised)
}

impl Mul for Dimension {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].saturating_add(other.0[i])
        }))
    }
}

impl Div for Dimension {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].saturating_sub(other.0[i])
        }))
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let below = |&exponent: &i32| exponent < 0 && exponent % PARTS == 0;
        let slash = self.0.iter().filter(|&exponent| *exponent < 0).count() == 1
            && self.0.iter().any(below);
        let mut first = true;
        for (&exponent, unit) in self.0.iter().zip(BASE) {
            if exponent != 0 && !(slash && exponent < 0) {
                write!(f, "{}{unit}", if first { "" } else { " " })?;
                write_power(f, exponent)?;
                first = false;
            }
        }
        if first {
            f.write_str("1")?;
        }
        if let Some(i) = self.0.iter().position(|e| slash && below(e)) {
            write!(f, "/{}", BASE[i])?;
            write_power(f, -self.0[i])?;
        }
        Ok(())
    }
}

fn write_power(f: &mut fmt::Formatter<'_>, exponent: i32) -> fmt::Result {
    match gcd(i64::from(exponent), i64::from(PARTS)) as i32 {
        _ if exponent == PARTS => Ok(()),
        PARTS => write!(f, "^{}", exponent / PARTS),
        divisor => write!(f, "^({}/{})", exponent / divisor, PARTS / divisor),
    }
}

/// Derived units that say more than their base units, with their exponents of kg, m, s, A, K, mol, cd.
#[rustfmt::skip]
const NAMED: [([i8; 7], &str); 35] = [
    ([ 1,  1, -2,  0,  0, 0, 0], "N"),
    ([ 1,  2, -2,  0,  0, 0, 0], "J"),
    ([ 1,  2, -3,  0,  0, 0, 0], "W"),
    ([ 1,  0, -2,  0,  0, 0, 0], "N/m"),
    ([ 1,  0, -1,  0,  0, 0, 0], "N s/m"),
    ([ 1,  2, -1,  0,  0, 0, 0], "N m s"),
    ([ 1,  1, -1,  0,  0, 0, 0], "N s"),
    ([ 1, -1, -2,  0,  0, 0, 0], "Pa"),
    ([ 1, -1, -1,  0,  0, 0, 0], "Pa s"),
    ([ 1, -2, -2,  0,  0, 0, 0], "N/m^3"),
    ([ 1,  3, -2,  0,  0, 0, 0], "N m^2"),
    ([ 1,  1, -3,  0,  0, 0, 0], "N/s"),
    ([-1,  0,  2,  0,  0, 0, 0], "m/N"),
    ([-1,  0,  1,  0,  0, 0, 0], "m/(N s)"),
    ([-1, -1,  2,  0,  0, 0, 0], "1/N"),
    ([-1, -2,  2,  0,  0, 0, 0], "1/J"),
    ([-1,  1,  2,  0,  0, 0, 0], "1/Pa"),
    ([ 0,  1, -2,  0,  0, 0, 0], "m/s^2"),
    ([ 0,  0,  1,  1,  0, 0, 0], "C"),
    ([ 1,  2, -3, -1,  0, 0, 0], "V"),
    ([ 1,  1, -3, -1,  0, 0, 0], "V/m"),
    ([ 1,  2, -4, -1,  0, 0, 0], "V/s"),
    ([ 1,  2, -3, -2,  0, 0, 0], "ohm"),
    ([-1, -2,  3,  2,  0, 0, 0], "S"),
    ([-1, -2,  4,  2,  0, 0, 0], "F"),
    ([ 1,  2, -4, -2,  0, 0, 0], "1/F"),
    ([ 1,  2, -2, -2,  0, 0, 0], "H"),
    ([ 1,  2, -2, -1,  0, 0, 0], "Wb"),
    ([ 1,  0, -2, -1,  0, 0, 0], "T"),
    ([ 1,  1, -2, -1,  0, 0, 0], "N/A"),
    ([ 1,  2, -2,  0, -1, 0, 0], "J/K"),
    ([ 0,  2, -2,  0, -1, 0, 0], "J/(kg K)"),
    ([ 1,  1, -3,  0, -1, 0, 0], "W/(m K)"),
    ([ 2,  2, -4,  0,  0, 0, 0], "N^2"),
    ([ 2,  0, -4,  0,  0, 0, 0], "N^2/m^2"),
];
