//! Quantities of one degree of freedom.

use std::f64::consts::TAU;

use super::{Numbers, Unavailable};
use crate::expr::Value;
use crate::vibration::DisplacementResonance;

/// A number that belongs to a model of one coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sdof {
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

/// A number of a model of one coordinate.
///
/// # Errors
///
/// Those of [`Numbers::oscillator`], and [`Unavailable::NotOscillating`], [`Unavailable::Undamped`] or
/// [`Unavailable::NoResonance`] where the number does not exist.
pub(crate) fn number(numbers: &Numbers, quantity: Sdof) -> Result<Value, Unavailable> {
    if numbers.model.degrees_of_freedom() != 1 {
        return Err(Unavailable::SeveralCoordinates);
    }
    let matrices = numbers.matrices()?;
    match quantity {
        Sdof::Mass => Ok(entry(&matrices.mass)),
        Sdof::Damping => Ok(entry(&matrices.damping)),
        Sdof::Stiffness => Ok(entry(&matrices.stiffness)),
        // A damped mass without a spring is no oscillator, and its motion decays all the same.
        Sdof::DecayRate if numbers.stiffness_matrix()?.numbers()[0] <= 0.0 => {
            let rate = matrices.damping.numbers()[0] / (2.0 * matrices.mass.numbers()[0]);
            Ok(with_relative_bound(numbers, rate))
        }
        _ => Ok(with_relative_bound(
            numbers,
            of_oscillator(numbers, quantity)?,
        )),
    }
}

fn of_oscillator(numbers: &Numbers, quantity: Sdof) -> Result<f64, Unavailable> {
    let oscillator = numbers.oscillator()?;
    let damped = || {
        oscillator
            .damped_angular_frequency()
            .ok_or(Unavailable::NotOscillating)
    };
    Ok(match quantity {
        Sdof::Mass => oscillator.mass(),
        Sdof::Damping => oscillator.damping(),
        Sdof::Stiffness => oscillator.stiffness(),
        Sdof::NaturalAngularFrequency => oscillator.natural_angular_frequency(),
        Sdof::NaturalFrequency => oscillator.natural_angular_frequency() / TAU,
        Sdof::Period => TAU / oscillator.natural_angular_frequency(),
        Sdof::DecayRate => oscillator.decay_rate(),
        Sdof::DampingRatio => oscillator.damping_ratio(),
        Sdof::CriticalDamping => oscillator.critical_damping(),
        Sdof::DampedAngularFrequency => damped()?,
        Sdof::DampedPeriod => TAU / damped()?,
        Sdof::LogarithmicDecrement => TAU * oscillator.decay_rate() / damped()?,
        Sdof::QualityFactor => oscillator.quality_factor().ok_or(Unavailable::Undamped)?,
        Sdof::ResonanceAngularFrequency => DisplacementResonance::of(&oscillator)
            .ok_or(Unavailable::NoResonance)?
            .angular_frequency(),
    })
}

/// A result whose relative error is that of the coefficients and a few roundings.
pub(crate) fn with_relative_bound(numbers: &Numbers, number: f64) -> Value {
    let relative = numbers.matrices().map_or(0.0, |all| {
        relative_error(&all.mass) + relative_error(&all.damping) + relative_error(&all.stiffness)
    });
    Value::real(number, (relative + 8.0 * f64::EPSILON) * number.abs())
}

/// The largest relative error of some numbers.
fn relative_error(value: &Value) -> f64 {
    let pairs = value.numbers().iter().zip(value.bounds());
    let errors = pairs.filter(|(number, _)| **number != 0.0);
    errors.fold(0.0, |worst: f64, (number, bound)| {
        worst.max(bound / number.abs())
    })
}

/// The only entry of a matrix of one row.
fn entry(matrix: &Value) -> Value {
    Value::real(matrix.numbers()[0], matrix.bounds()[0])
}
