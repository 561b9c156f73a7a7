//! From the unit in which a value is written to the one in which it is wanted.

use super::decimal::Decimal;
use super::error::DimensionMismatch;
use super::product::{Angle, Unit};
use super::rational::Rational;
use super::scale::Scale;

/// How a value written in one unit becomes the SI value of a quantity declared in another.
///
/// This is the only place where angular and cyclic frequency meet:
///
/// ```text
/// written    declared   factor        written    declared   factor
/// Hz         rad/s      2π            rad/s      Hz         1/(2π)
/// rpm        rad/s      2π/60         rpm        Hz         1/60
/// 1/s        rad/s      1             1/s        Hz         1
/// ```
///
/// A unit that counts no angles, as 1/s or N m, is taken to count as its partner does.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::Unit;
///
/// let unit = |text| Unit::parse(text).unwrap();
/// let reading = unit("Hz").conversion(&unit("rad/s")).unwrap();
/// assert_eq!(reading.apply(2.0), 4.0 * std::f64::consts::PI);
/// assert!(reading.applies_two_pi());
/// assert_eq!(unit("1/s").conversion(&unit("Hz")).unwrap().apply(2.0), 2.0);
/// assert_eq!(unit("N cm").conversion(&unit("N m/rad")).unwrap().apply(150.0), 1.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conversion {
    scale: Scale,
    turns: Rational,
}

impl Conversion {
    pub(crate) fn between(written: &Unit, declared: &Unit) -> Result<Self, DimensionMismatch> {
        let (found, expected) = (written.dimension(), declared.dimension());
        let mismatch = DimensionMismatch { found, expected };
        if found != expected {
            return Err(mismatch);
        }
        let turns = match (written.angle(), declared.angle()) {
            (Angle::Bare, _) | (_, Angle::Bare) => Rational::ZERO,
            (written, declared) => cycles(written)
                .checked_add(cycles(declared).negated())
                .ok_or(mismatch)?,
        };
        if turns.is_zero() {
            return Ok(Self {
                scale: written.scale(),
                turns,
            });
        }
        let scale = written
            .scale()
            .times(Scale::TURN.pow(turns).ok_or(mismatch)?);
        Ok(Self { scale, turns })
    }

    /// Whether cycles became radians or the other way round.
    pub const fn applies_two_pi(&self) -> bool {
        !self.turns.is_zero()
    }

    /// The SI value, rounded once.
    pub fn apply(&self, value: f64) -> f64 {
        self.scale.apply_f64(value)
    }

    /// The SI value of a decimal, rounded once.
    pub fn apply_decimal(&self, value: &Decimal) -> f64 {
        value.scaled(self.scale)
    }

    /// The SI value of a decimal as the sum of two numbers, exact to at least 106 bits.
    pub fn apply_pair(&self, value: &Decimal) -> (f64, f64) {
        value.scaled_pair(self.scale)
    }
}

/// The power of a cycle in a unit.
fn cycles(angle: Angle) -> Rational {
    if let Angle::Cycles(power) = angle {
        power
    } else {
        Rational::ZERO
    }
}
