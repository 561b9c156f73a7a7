//! The linear oscillator of one degree of freedom: mass, damping, stiffness.

use thiserror::Error;

use super::power_of_two::PowerOfTwo;
use super::state::State;
use crate::numerics::{Dd, binary_exponent, scale_by_power_of_two, two_sum};

/// How the free motion of an oscillator decays; decided by the exact sign of c² - 4 m k.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{Oscillator, Regime};
///
/// // In binary64 2 * 0.3 is exactly critical; one unit in the last place less is not.
/// let regime = |damping| Oscillator::new(0.3, damping, 0.3).unwrap().regime();
/// assert_eq!(regime(0.6), Regime::Critical);
/// assert_eq!(regime(0.6_f64.next_down()), Regime::Underdamped);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Regime {
    /// c = 0: the motion does not decay.
    Undamped,
    /// 0 < c² < 4 m k: decaying oscillation.
    Underdamped,
    /// c² = 4 m k: the fastest decay without oscillation.
    Critical,
    /// c² > 4 m k: sum of two decaying exponentials.
    Overdamped,
}

impl Regime {
    /// The regime's name in lower case.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Undamped => "undamped",
            Self::Underdamped => "underdamped",
            Self::Critical => "critical",
            Self::Overdamped => "overdamped",
        }
    }
}

/// Why three numbers are no oscillator.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum OscillatorError {
    /// The mass is not a positive number.
    #[error("the mass must be positive and finite, not {0}")]
    Mass(f64),
    /// The damping coefficient is negative or no number.
    #[error("the damping coefficient must be zero or positive and finite, not {0}")]
    Damping(f64),
    /// The stiffness is not a positive number.
    #[error("the stiffness must be positive and finite, not {0}")]
    Stiffness(f64),
    /// The damping ratio exceeds 1e300.
    #[error("the damping coefficient {0} is too large for this mass and stiffness")]
    DampingRatio(f64),
}

/// A mass on a spring and a damper,
///
/// ```text
/// m x'' + c x' + k x = 0
/// ```
///
/// with m in kg, c in N·s/m, k in N/m; or an electrical circuit with L, R and 1/C in their places.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{Oscillator, Regime};
///
/// let oscillator = Oscillator::new(2.0, 4.0, 200.0)?;
/// assert_eq!(oscillator.regime(), Regime::Underdamped);
/// assert_eq!(oscillator.natural_angular_frequency(), 10.0);
/// assert_eq!(oscillator.damping_ratio(), 0.1);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Oscillator {
    mass: f64,
    damping: f64,
    stiffness: f64,
    scaled: Scaled,
}

impl Oscillator {
    /// An oscillator from its mass in kg, damping coefficient in N·s/m and stiffness in N/m.
    ///
    /// # Errors
    ///
    /// Mass and stiffness must be positive, the damping coefficient not negative, all of them finite.
    #[inline]
    pub fn new(mass: f64, damping: f64, stiffness: f64) -> Result<Self, OscillatorError> {
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        if !is_positive(mass) {
            return Err(OscillatorError::Mass(mass));
        }
        if !(is_positive(damping) || damping == 0.0) {
            return Err(OscillatorError::Damping(damping));
        }
        if !is_positive(stiffness) {
            return Err(OscillatorError::Stiffness(stiffness));
        }
        let scaled = Scaled::of(mass, damping, stiffness, natural_exponent(mass, stiffness));
        if scaled.damping < MAX_DAMPING {
            Ok(Self {
                mass,
                // A negative zero is no negative damping, and must not turn a sign later on.
                damping: damping.abs(),
                stiffness,
                scaled,
            })
        } else {
            Err(OscillatorError::DampingRatio(damping))
        }
    }

    /// The charge of a series circuit, L q'' + R q' + q/C = 0, from its inductance L in H, resistance R in Ω and
    /// capacitance C in F.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::{FrequencyResponse, Oscillator};
    ///
    /// let circuit = Oscillator::series_circuit(0.5, 3.0, 0.125)?;
    /// let impedance = FrequencyResponse::at(&circuit, 16.0).impedance();
    /// assert_eq!((impedance.re, impedance.im), (3.0, 7.5));
    /// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Oscillator::new`] for L, R and 1/C.
    pub fn series_circuit(
        inductance: f64,
        resistance: f64,
        capacitance: f64,
    ) -> Result<Self, OscillatorError> {
        Self::new(inductance, resistance, 1.0 / capacitance)
    }

    /// Mechanical energy (m v² + k x²)/2 in J of a state in m and m/s.
    pub fn energy(&self, state: State) -> f64 {
        let kinetic = self.mass * state.velocity * state.velocity;
        let potential = self.stiffness * state.position * state.position;
        0.5 * (kinetic + potential)
    }

    /// Mass m in kg.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Damping coefficient c in N·s/m.
    pub const fn damping(&self) -> f64 {
        self.damping
    }

    /// Stiffness k in N/m.
    pub const fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Regime of the free motion, by the exact sign of c² - 4 m k.
    #[inline]
    pub fn regime(&self) -> Regime {
        self.scaled.regime(self.scaled.discriminant())
    }

    /// Natural angular frequency ω₀ = √(k/m) in rad/s.
    pub fn natural_angular_frequency(&self) -> f64 {
        self.scaled.rate(self.scaled.natural_frequency().hi())
    }

    /// Damping ratio ζ = c/(2 √(m k)).
    pub fn damping_ratio(&self) -> f64 {
        (self.scaled.damping / (Dd::product(self.scaled.mass, self.scaled.stiffness).sqrt() * 2.0))
            .hi()
    }

    /// Damping coefficient at the limit of oscillation, 2 √(m k), in N·s/m.
    pub fn critical_damping(&self) -> f64 {
        let critical = Dd::product(self.scaled.mass, self.scaled.stiffness).sqrt() * 2.0;
        let exponent = self.scaled.mass_exponent + self.scaled.rate_exponent;
        scale_by_power_of_two(critical.hi(), exponent)
    }

    /// Quality factor √(m k)/c = 1/(2 ζ); none without damping.
    pub fn quality_factor(&self) -> Option<f64> {
        (self.damping > 0.0).then(|| {
            let mantissa = scale_by_power_of_two(self.damping, -binary_exponent(self.damping));
            let exponent = binary_exponent(self.damping)
                - self.scaled.mass_exponent
                - self.scaled.rate_exponent;
            let root = Dd::product(self.scaled.mass, self.scaled.stiffness).sqrt();
            scale_by_power_of_two((root / mantissa).hi(), -exponent)
        })
    }

    /// Decay rate λ = c/(2 m) in 1/s.
    pub fn decay_rate(&self) -> f64 {
        self.scaled.rate(self.scaled.decay_rate().hi())
    }

    /// Damped angular frequency ω_d = √(4 m k - c²)/(2 m) in rad/s; none if the motion does not oscillate.
    pub fn damped_angular_frequency(&self) -> Option<f64> {
        matches!(self.regime(), Regime::Undamped | Regime::Underdamped).then(|| {
            self.scaled
                .rate((self.scaled.root() / (2.0 * self.scaled.mass)).hi())
        })
    }

    /// Rates of the two decaying exponentials in 1/s, the slow one first, both negative; none unless overdamped.
    pub fn decay_roots(&self) -> Option<(f64, f64)> {
        (self.regime() == Regime::Overdamped).then(|| {
            let (slow, fast) = self.scaled.real_roots(self.scaled.root());
            (self.scaled.rate(slow.hi()), self.scaled.rate(fast.hi()))
        })
    }

    /// The oscillator in units in which its natural frequency is near one.
    pub(crate) const fn scaled(&self) -> &Scaled {
        &self.scaled
    }
}

/// An oscillator in units of mass and time that are powers of two, so that no product leaves the exponent range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scaled {
    /// Mass in the scaled unit, in [1, 2).
    pub(crate) mass: f64,
    /// Damping coefficient.
    pub(crate) damping: f64,
    /// Whether there is damping, also where the scaled coefficient is too small for a number.
    is_damped: bool,
    /// Stiffness, in [1, 4) if time is in units of the natural frequency.
    pub(crate) stiffness: f64,
    /// The unit of mass is 2 to this power.
    pub(crate) mass_exponent: i32,
    /// The unit of rates is 2 to this power, that of time its reciprocal.
    pub(crate) rate_exponent: i32,
}

/// Exponent of the power of two next to the natural frequency.
#[inline]
fn natural_exponent(mass: f64, stiffness: f64) -> i32 {
    (binary_exponent(stiffness) - binary_exponent(mass)).div_euclid(2)
}

impl Scaled {
    #[inline]
    fn of(mass: f64, damping: f64, stiffness: f64, rate_exponent: i32) -> Self {
        let mass_exponent = binary_exponent(mass);
        Self {
            mass: scale_by_power_of_two(mass, -mass_exponent),
            damping: scale_by_power_of_two(damping.abs(), -mass_exponent - rate_exponent),
            is_damped: damping != 0.0,
            stiffness: scale_by_power_of_two(stiffness, -mass_exponent - 2 * rate_exponent),
            mass_exponent,
            rate_exponent,
        }
    }

    /// The oscillator with time in units of the higher one of its natural frequency and this angular frequency.
    pub(crate) fn driven(oscillator: &Oscillator, angular_frequency: f64) -> Self {
        let exponent = binary_exponent(angular_frequency);
        if exponent <= oscillator.scaled.rate_exponent {
            return oscillator.scaled;
        }
        Self::of(
            oscillator.mass,
            oscillator.damping,
            oscillator.stiffness,
            exponent,
        )
    }

    /// A rate in 1/s.
    pub(crate) fn rate(&self, scaled: f64) -> f64 {
        PowerOfTwo::new(self.rate_exponent).apply(scaled)
    }

    /// A rate or time with the other one's unit taken off: what is in 1/s comes scaled.
    pub(crate) fn scaled_rate(&self, rate: f64) -> f64 {
        PowerOfTwo::new(-self.rate_exponent).apply(rate)
    }

    pub(crate) fn natural_frequency(&self) -> Dd {
        Dd::quotient(self.stiffness, self.mass).sqrt()
    }

    pub(crate) fn decay_rate(&self) -> Dd {
        Dd::quotient(self.damping, 2.0 * self.mass)
    }

    /// c² - 4 m k with its exact sign.
    ///
    /// Beyond a damping ratio of 1e30 the second term is below the last digit of the first, whose square may overflow.
    #[inline]
    pub(crate) fn discriminant(&self) -> Dd {
        // Where fewer than three digits cancel, low parts that are rounded to binary64 leave 29 of 32 digits.
        const CANCELLED: f64 = 1e-3;
        let square = if self.damping < LARGE_DAMPING {
            Dd::product(self.damping, self.damping)
        } else {
            // The square of the limit, of which 4 m k is below the last digit as well.
            Dd::from(1e60)
        };
        let product = Dd::product(4.0 * self.mass, self.stiffness);
        let (high, low) = two_sum(square.hi(), -product.hi());
        if high.abs() > CANCELLED * product.hi() {
            Dd::sum(high, low + (square.lo() - product.lo()))
        } else {
            square - product
        }
    }

    /// √|c² - 4 m k|.
    pub(crate) fn root(&self) -> Dd {
        self.root_of(self.discriminant())
    }

    /// √|c² - 4 m k| from the discriminant.
    #[inline]
    pub(crate) fn root_of(&self, discriminant: Dd) -> Dd {
        if self.damping < LARGE_DAMPING {
            discriminant.abs().sqrt()
        } else {
            Dd::from(self.damping)
        }
    }

    /// The regime by the sign of the discriminant.
    pub(crate) fn regime(&self, discriminant: Dd) -> Regime {
        if !self.is_damped {
            Regime::Undamped
        } else if discriminant.is_negative() {
            Regime::Underdamped
        } else if discriminant == Dd::ZERO {
            Regime::Critical
        } else {
            Regime::Overdamped
        }
    }

    /// Slow and fast root of m r² + c r + k = 0, from √(c² - 4 m k).
    pub(crate) fn real_roots(&self, root: Dd) -> (Dd, Dd) {
        let sum = root + self.damping;
        (-(2.0 * self.stiffness) / sum, -sum / (2.0 * self.mass))
    }
}

/// Scaled damping coefficients from here on leave no trace of mass and stiffness in the discriminant.
const LARGE_DAMPING: f64 = 1e30;
/// Scaled damping coefficients from here on are refused.
const MAX_DAMPING: f64 = 1e300;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_regime_is_exact_where_the_rounded_difference_is_not() {
        let (m, k) = (0.1_f64, 0.1_f64);
        let c = 0.2_f64;
        assert_eq!(Oscillator::new(m, c, k).unwrap().regime(), Regime::Critical);
        assert_eq!(
            Oscillator::new(m, c.next_up(), k).unwrap().regime(),
            Regime::Overdamped
        );
        assert_eq!(
            Oscillator::new(m, c.next_down(), k).unwrap().regime(),
            Regime::Underdamped
        );
        assert_eq!(
            Oscillator::new(m, 0.0, k).unwrap().regime(),
            Regime::Undamped
        );
    }

    #[test]
    fn extreme_magnitudes_leave_the_ratios_alone() {
        for scale in [5e-324, 1e-300, 1e-10, 1e300] {
            let oscillator = Oscillator::new(scale, 4.0 * scale, scale).unwrap();
            assert_eq!(oscillator.damping_ratio(), 2.0);
            assert_eq!(oscillator.natural_angular_frequency(), 1.0);
            assert_eq!(oscillator.quality_factor(), Some(0.25));
        }
        let fast = Oscillator::new(1e-300, 0.0, 1e300).unwrap();
        assert!((fast.natural_angular_frequency() / 1e300 - 1.0).abs() < 2e-16);
    }

    #[test]
    fn what_is_no_oscillator_is_refused() {
        assert!(Oscillator::new(0.0, 1.0, 1.0).is_err());
        assert!(Oscillator::new(1.0, -1.0, 1.0).is_err());
        assert!(Oscillator::new(1.0, f64::NAN, 1.0).is_err());
        assert!(Oscillator::new(1.0, 1.0, f64::INFINITY).is_err());
        assert!(matches!(
            Oscillator::new(1e-300, 1e300, 1e-300),
            Err(OscillatorError::DampingRatio(_))
        ));
    }
}
