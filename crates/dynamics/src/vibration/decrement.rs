//! From measured motion back to the oscillator: logarithmic decrement and resonance curve, with their condition numbers.

use thiserror::Error;

use crate::numerics::{Dd, binary_exponent};

/// Why measurements do not describe an oscillator.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum IdentificationError {
    /// Two amplitudes have different signs, or one is zero or not finite.
    #[error("the amplitudes {first} and {last} must be finite, of the same sign and not zero")]
    Amplitudes {
        /// The first amplitude.
        first: f64,
        /// The last amplitude.
        last: f64,
    },
    /// There is no period between the amplitudes.
    #[error("there must be at least one period between the amplitudes")]
    Periods,
    /// A quantity that must be positive is not.
    #[error("the {name} must be positive and finite, not {value}")]
    NotPositive {
        /// The name of the argument.
        name: &'static str,
        /// The value that was given for it.
        value: f64,
    },
    /// The quality factor belongs to an oscillator whose displacement has no resonance.
    #[error("a resonance needs a quality factor above 1/√2, not {0}")]
    NoResonance(f64),
}

/// The logarithmic decrement of a decaying oscillation, and what follows from it.
///
/// ```text
/// δ = ln(x_1/x_(n+1))/n,   ζ = δ/√(4π² + δ²),   λ = δ/T_d,   ω0 = √(4π² + δ²)/T_d
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::LogarithmicDecrement;
///
/// let decrement = LogarithmicDecrement::of(8.0, 1.0, 3)?;
/// assert_eq!(decrement.value(), std::f64::consts::LN_2);
/// # Ok::<(), vibank_dynamics::vibration::IdentificationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogarithmicDecrement {
    decrement: Dd,
    periods: u64,
}

impl LogarithmicDecrement {
    /// The decrement from two amplitudes that are `periods` damped periods apart.
    ///
    /// # Errors
    ///
    /// The amplitudes must have the same sign, and there must be a period between them.
    pub fn of(first: f64, last: f64, periods: u64) -> Result<Self, IdentificationError> {
        let is_measurable = first.is_finite() && last.is_finite() && first != 0.0 && last != 0.0;
        if !is_measurable || (first < 0.0) != (last < 0.0) {
            return Err(IdentificationError::Amplitudes { first, last });
        }
        if periods == 0 {
            return Err(IdentificationError::Periods);
        }
        Ok(Self {
            decrement: ln_of_ratio(first, last) / Dd::from_integer(periods as i64),
            periods,
        })
    }

    /// Logarithmic decrement δ.
    pub fn value(&self) -> f64 {
        self.decrement.hi()
    }

    /// Damping ratio ζ = δ/√(4π² + δ²) of the underdamped oscillator with this decrement.
    pub fn damping_ratio(&self) -> f64 {
        (self.decrement / self.hypotenuse()).hi()
    }

    /// Decay rate λ = δ/T_d in 1/s, from the damped period in s.
    pub fn decay_rate(&self, period: f64) -> f64 {
        (self.decrement / period).hi()
    }

    /// Natural angular frequency ω0 = √(4π² + δ²)/T_d in rad/s, from the damped period in s.
    pub fn natural_angular_frequency(&self, period: f64) -> f64 {
        (self.hypotenuse() / period).hi()
    }

    /// Damping coefficient c = 2 m λ in N·s/m, from the mass in kg and the damped period in s.
    pub fn damping(&self, mass: f64, period: f64) -> f64 {
        (self.decrement / period * (2.0 * mass)).hi()
    }

    /// Stiffness k = m ω0² in N/m, from the mass in kg and the damped period in s.
    pub fn stiffness(&self, mass: f64, period: f64) -> f64 {
        ((self.hypotenuse() / period).square() * mass).hi()
    }

    /// Condition number of the damping ratio: its relative error over that of each amplitude, both added up,
    /// 2/(n δ) · 4π²/(4π² + δ²).
    pub fn condition(&self) -> f64 {
        let share = Dd::TAU.hi() / self.hypotenuse().hi();
        (2.0 / (self.periods as f64 * self.value()) * share * share).abs()
    }

    fn hypotenuse(&self) -> Dd {
        Dd::TAU.hypot(self.decrement)
    }
}

/// ln(a/b) for numbers of the same sign, also where the quotient leaves the exponent range.
fn ln_of_ratio(a: f64, b: f64) -> Dd {
    // A quotient of 2^-900 still has its low part, 2^-106 of it, above the smallest normal number, 2^-1022.
    const FAR: i32 = 900;
    let shift = binary_exponent(a) - binary_exponent(b);
    if shift.abs() < FAR && binary_exponent(b).abs() < FAR {
        return Dd::quotient(a, b).ln();
    }
    let (a, b) = (
        Dd::from(a.abs()).scale(-binary_exponent(a)),
        Dd::from(b.abs()).scale(-binary_exponent(b)),
    );
    (a / b).ln() + Dd::LN_2 * f64::from(shift)
}

/// Mass, damping and stiffness from a measured resonance curve of the displacement.
///
/// ```text
/// ζ = 1/(2 Q),  ω0 = ω_r/√(1 - 2ζ²),  k = F/(2 ζ √(1 - ζ²) X),  m = k/ω0²,  c = 2 ζ m ω0
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::ResonanceCurve;
///
/// let curve = ResonanceCurve { force: 1.0, angular_frequency: 10.0, amplitude: 0.05, quality_factor: 20.0 };
/// let identified = curve.identify()?;
/// assert!((identified.stiffness - 400.0).abs() < 1.0);
/// assert!(identified.condition < 5.1);
/// # Ok::<(), vibank_dynamics::vibration::IdentificationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResonanceCurve {
    /// Amplitude F of the force in N.
    pub force: f64,
    /// Angular frequency ω_r of the largest amplitude in rad/s.
    pub angular_frequency: f64,
    /// Largest amplitude X in m.
    pub amplitude: f64,
    /// Quality factor Q = 1/(2 ζ).
    pub quality_factor: f64,
}

/// An oscillator that was found from measurements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Identified {
    /// Mass in kg.
    pub mass: f64,
    /// Damping coefficient in N·s/m.
    pub damping: f64,
    /// Stiffness in N/m.
    pub stiffness: f64,
    /// Condition number: the largest relative error of a result over the relative errors of the data, all added up.
    pub condition: f64,
}

impl ResonanceCurve {
    /// The oscillator with this resonance curve.
    ///
    /// # Errors
    ///
    /// All data must be positive, and the quality factor above 1/√2.
    pub fn identify(&self) -> Result<Identified, IdentificationError> {
        for (name, value) in [
            ("force", self.force),
            ("angular frequency", self.angular_frequency),
            ("amplitude", self.amplitude),
            ("quality factor", self.quality_factor),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(IdentificationError::NotPositive { name, value });
            }
        }
        let ratio = Dd::quotient(0.5, self.quality_factor);
        let square = ratio.square();
        let resonance = 1.0 - square * 2.0;
        if resonance <= Dd::ZERO {
            return Err(IdentificationError::NoResonance(self.quality_factor));
        }
        let natural = Dd::from(self.angular_frequency) / resonance.sqrt();
        let gain = (ratio * (1.0 - square).sqrt() * 2.0).recip();
        let stiffness = gain * self.force / self.amplitude;
        let mass = stiffness / natural / natural;
        Ok(Identified {
            mass: mass.hi(),
            damping: (mass * natural * ratio * 2.0).hi(),
            stiffness: stiffness.hi(),
            condition: Self::condition(square.hi()),
        })
    }

    /// Sums of the magnitudes of the logarithmic derivatives by force, amplitude, frequency and damping ratio.
    fn condition(square: f64) -> f64 {
        let natural = 2.0 * square / (1.0 - 2.0 * square);
        let stiffness = -1.0 + square / (1.0 - square);
        let of_stiffness = 2.0 + stiffness.abs();
        let of_mass = 4.0 + (stiffness - 2.0 * natural).abs();
        let of_damping = 3.0 + (1.0 + stiffness - natural).abs();
        of_stiffness.max(of_mass).max(of_damping)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::{DisplacementResonance, Oscillator};

    #[test]
    fn nearly_equal_amplitudes_keep_their_digits() {
        let decrement = LogarithmicDecrement::of(1.0 + f64::EPSILON, 1.0, 1).unwrap();
        assert_eq!(
            decrement.value(),
            f64::EPSILON - 0.5 * f64::EPSILON * f64::EPSILON
        );
        assert!(decrement.condition() > 1e15);
    }

    #[test]
    fn quotients_may_leave_the_exponent_range() {
        let decrement = LogarithmicDecrement::of(1e308, 1e-308, 2).unwrap();
        assert!((decrement.value() / (308.0 * std::f64::consts::LN_10) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_resonance_curve_gives_its_oscillator_back() {
        let (m, c, k) = (2.0, 0.9, 70.0);
        let oscillator = Oscillator::new(m, c, k).unwrap();
        let resonance = DisplacementResonance::of(&oscillator).unwrap();
        let curve = ResonanceCurve {
            force: 5.0,
            angular_frequency: resonance.angular_frequency(),
            amplitude: 5.0 / k * resonance.peak_gain().unwrap(),
            quality_factor: oscillator.quality_factor().unwrap(),
        };
        let found = curve.identify().unwrap();
        for (found, expected) in [(found.mass, m), (found.damping, c), (found.stiffness, k)] {
            assert!((found / expected - 1.0).abs() < 2e-15);
        }
    }

    #[test]
    fn what_cannot_be_measured_is_refused() {
        assert!(LogarithmicDecrement::of(1.0, -0.5, 1).is_err());
        assert!(LogarithmicDecrement::of(1.0, 0.0, 1).is_err());
        assert!(LogarithmicDecrement::of(1.0, 0.5, 0).is_err());
        let curve = ResonanceCurve {
            force: 1.0,
            angular_frequency: 1.0,
            amplitude: 1.0,
            quality_factor: 0.7,
        };
        assert!(matches!(
            curve.identify(),
            Err(IdentificationError::NoResonance(_))
        ));
    }
}
