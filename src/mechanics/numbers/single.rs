//! Quantities of one degree of freedom.

use std::f64::consts::TAU;

use super::{Lack, Numbers};
use crate::expr::Value;
use crate::vibration::DisplacementResonance;

/// A number that belongs to a model of one coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Single {
    /// m.
    Mass,
    /// c.
    Damping,
    /// k.
    Stiffness,
    /// ω₀ = √(k/m).
    NaturalAngularFrequency,
    /// f₀ = ω₀/2π.
    NaturalFrequency,
    /// T₀ = 2π/ω₀.
    Period,
    /// λ = c/(2m).
    DecayRate,
    /// ζ = c/(2√(km)).
    DampingRatio,
    /// 2√(km).
    CriticalDamping,
    /// ω_d = ω₀√(1 − ζ²).
    DampedAngularFrequency,
    /// T_d = 2π/ω_d.
    DampedPeriod,
    /// δ = λ T_d.
    LogarithmicDecrement,
    /// Q = 1/(2ζ).
    QualityFactor,
    /// ω_r = ω₀√(1 − 2ζ²).
    ResonanceAngularFrequency,
}

impl Numbers {
    /// A number of a model of one coordinate.
    ///
    /// # Errors
    ///
    /// Those of [`Self::oscillator`], and [`Lack::NotOscillating`], [`Lack::Undamped`] or
    /// [`Lack::NoResonance`] where the number does not exist.
    pub fn single(&self, quantity: Single) -> Result<Value, Lack> {
        if self.model.degrees_of_freedom() != 1 {
            return Err(Lack::SeveralCoordinates);
        }
        let matrices = self.matrices()?;
        match quantity {
            Single::Mass => Ok(entry(&matrices.mass)),
            Single::Damping => Ok(entry(&matrices.damping)),
            Single::Stiffness => Ok(entry(&matrices.stiffness)),
            Single::DecayRate if self.stiffness_matrix()?.numbers()[0] <= 0.0 => {
                let rate = matrices.damping.numbers()[0] / (2.0 * matrices.mass.numbers()[0]);
                Ok(self.with_relative_bound(rate))
            }
            _ => Ok(self.with_relative_bound(self.of_oscillator(quantity)?)),
        }
    }

    fn of_oscillator(&self, quantity: Single) -> Result<f64, Lack> {
        let oscillator = self.oscillator()?;
        let damped = || {
            oscillator
                .damped_angular_frequency()
                .ok_or(Lack::NotOscillating)
        };
        Ok(match quantity {
            Single::Mass => oscillator.mass(),
            Single::Damping => oscillator.damping(),
            Single::Stiffness => oscillator.stiffness(),
            Single::NaturalAngularFrequency => oscillator.natural_angular_frequency(),
            Single::NaturalFrequency => oscillator.natural_angular_frequency() / TAU,
            Single::Period => TAU / oscillator.natural_angular_frequency(),
            Single::DecayRate => oscillator.decay_rate(),
            Single::DampingRatio => oscillator.damping_ratio(),
            Single::CriticalDamping => oscillator.critical_damping(),
            Single::DampedAngularFrequency => damped()?,
            Single::DampedPeriod => TAU / damped()?,
            Single::LogarithmicDecrement => TAU * oscillator.decay_rate() / damped()?,
            Single::QualityFactor => oscillator.quality_factor().ok_or(Lack::Undamped)?,
            Single::ResonanceAngularFrequency => DisplacementResonance::of(&oscillator)
                .ok_or(Lack::NoResonance)?
                .angular_frequency(),
        })
    }

    /// A result whose relative error is that of the coefficients and a few roundings.
    pub(super) fn with_relative_bound(&self, number: f64) -> Value {
        let relative = |value: &Value| {
            let pairs = value.numbers().iter().zip(value.bounds());
            let errors = pairs.filter(|(number, _)| **number != 0.0);
            errors.fold(0.0, |worst: f64, (number, bound)| {
                worst.max(bound / number.abs())
            })
        };
        let relative = self.matrices().map_or(0.0, |all| {
            relative(&all.mass) + relative(&all.damping) + relative(&all.stiffness)
        });
        Value::real(number, (relative + 8.0 * f64::EPSILON) * number.abs())
    }
}

/// The only entry of a matrix of one row.
fn entry(matrix: &Value) -> Value {
    Value::real(matrix.numbers()[0], matrix.bounds()[0])
}
