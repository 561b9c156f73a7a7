//! The simple pendulum at any amplitude: period and motion in closed form, by elliptic functions.
//!
//! ```text
//! theta'' + (g/L) sin(theta) = 0
//! ```
//!
//! A [`Pendulum`] is a length and a gravity. It knows its [period](Pendulum::period) for an amplitude, and it starts a
//! [`PendulumMotion`]: released at an angle, thrown from the bottom, or both. The motion swings, runs up towards the top
//! for ever, or turns over; which of these is decided on the exact energy.
//!
//! A compound pendulum is a simple one of length `I/(m d)`. Absent: damping, which has no closed form at large angles.
//!
//! # References
//!
//! NIST Digital Library of Mathematical Functions, 19.8, 22.19(i), 22.20.

mod motion;
mod period;

pub use motion::{PendulumMotion, PendulumRegime};

use thiserror::Error;

use crate::numerics::{Dd, binary_exponent};

/// A point mass on a massless rod.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::Pendulum;
///
/// let pendulum = Pendulum::new(1.0, 9.81).unwrap();
/// assert_eq!(pendulum.period(0.0).unwrap(), pendulum.small_period());
/// // At a right angle the period is longer by 18 %.
/// let excess = pendulum.period_excess(std::f64::consts::FRAC_PI_2).unwrap();
/// assert!((excess - 0.180_340_599_016_096_2).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    length: f64,
    gravity: f64,
    /// The square root of g/L in units of `2^exponent`.
    rate: Dd,
    exponent: i32,
    /// The period of small swings.
    small_period: Dd,
}

/// Why there is no such pendulum or motion.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PendulumError {
    /// The length or the gravity is not a positive number.
    #[error("the {name} is {value}, not a positive number")]
    NotPositive {
        /// Which of them.
        name: &'static str,
        /// The value that was given for it.
        value: f64,
    },
    /// A swing from rest has no period at this angle.
    #[error("an amplitude of {0} rad is not below a half turn")]
    Amplitude(f64),
    /// The start is no number, or so fast that the motion leaves the range of numbers.
    #[error(
        "the motion from {angle} rad with {angular_velocity} rad/s leaves the range of numbers"
    )]
    Start {
        /// Angle at the start, in rad.
        angle: f64,
        /// Angular velocity at the start, in rad/s.
        angular_velocity: f64,
    },
}

impl Pendulum {
    /// A pendulum of length L in m under a gravity g in m/s².
    ///
    /// # Errors
    ///
    /// [`PendulumError::NotPositive`] unless both are positive and finite.
    pub fn new(length: f64, gravity: f64) -> Result<Self, PendulumError> {
        for (name, value) in [("length", length), ("gravity", gravity)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(PendulumError::NotPositive { name, value });
            }
        }
        // Powers of two are taken off, an even number in all, so that the quotient cannot leave the exponent range.
        let (of_gravity, of_length) = (binary_exponent(gravity), binary_exponent(length));
        let exponent = (of_gravity - of_length).div_euclid(2);
        let square = Dd::from(gravity).scale(-of_gravity) / Dd::from(length).scale(-of_length);
        let odd = of_gravity - of_length - 2 * exponent;
        let rate = square.scale(odd).sqrt();
        Ok(Self {
            length,
            gravity,
            rate,
            exponent,
            small_period: (Dd::TAU / rate).scale(-exponent),
        })
    }

    /// Angular frequency of small swings, `sqrt(g/L)`, in rad/s.
    #[must_use]
    pub fn natural_angular_frequency(&self) -> f64 {
        self.rate().hi()
    }

    /// Period of small swings, in s.
    ///
    /// ```text
    /// T0 = 2 pi sqrt(L/g)
    /// ```
    #[must_use]
    pub fn small_period(&self) -> f64 {
        self.small_period.hi()
    }

    /// Period of a swing released from rest at the angle `amplitude`, in s, to two units in the last place.
    ///
    /// ```text
    /// T = T0/agm(1, cos(theta0/2))
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::Pendulum;
    ///
    /// // The largest number below π: it stays near the top for a long time.
    /// let period = Pendulum::new(9.81, 9.81).unwrap().period(std::f64::consts::PI).unwrap();
    /// assert!((period - 154.872_602_217_555_25).abs() < 6e-14);
    /// ```
    ///
    /// # Errors
    ///
    /// [`PendulumError::Amplitude`] from a half turn on: there it does not swing back.
    pub fn period(&self, amplitude: f64) -> Result<f64, PendulumError> {
        period::of(self.small_period, amplitude)
    }

    /// By which part the period of a swing exceeds that of small swings, `T/T0 - 1`, without cancellation.
    ///
    /// It begins as `theta0^2/16`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::Pendulum;
    ///
    /// let excess = Pendulum::new(1.0, 9.81).unwrap().period_excess(1e-12).unwrap();
    /// assert_eq!(excess, 6.25e-26);
    /// ```
    ///
    /// # Errors
    ///
    /// [`PendulumError::Amplitude`] from a half turn on.
    pub fn period_excess(&self, amplitude: f64) -> Result<f64, PendulumError> {
        period::excess(amplitude)
    }

    /// The motion from an angle in rad and an angular velocity in rad/s, both of any sign and size.
    ///
    /// # Errors
    ///
    /// [`PendulumError::Start`] if one is not finite, if the velocity exceeds 1e100 times the natural angular frequency,
    /// or if twice that frequency is beyond the range of numbers.
    pub fn motion(
        &self,
        angle: f64,
        angular_velocity: f64,
    ) -> Result<PendulumMotion, PendulumError> {
        PendulumMotion::of(self, angle, angular_velocity)
    }

    fn rate(&self) -> Dd {
        self.rate.scale(self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frequencies_hold_at_the_ends_of_the_exponent_range() {
        for (length, gravity, expected) in [
            (1e300, 1e-300, 1e-300),
            (1e-300, 1e300, 1e300),
            (4.0, 1.0, 0.5),
        ] {
            let pendulum = Pendulum::new(length, gravity).unwrap();
            assert!((pendulum.natural_angular_frequency() / expected - 1.0).abs() < 3e-16);
        }
    }

    #[test]
    fn impossible_pendulums_are_refused() {
        for (length, gravity) in [
            (0.0, 9.81),
            (1.0, -9.81),
            (f64::NAN, 1.0),
            (1.0, f64::INFINITY),
        ] {
            assert!(matches!(
                Pendulum::new(length, gravity),
                Err(PendulumError::NotPositive { .. })
            ));
        }
    }
}
