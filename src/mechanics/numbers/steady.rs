//! The steady state under harmonic forces.

use super::excitation::HarmonicLoad;
use super::{Numbers, Unavailable, excitation, matrices, modal};
use crate::expr::{Field, Form, Shape, Value};
use crate::numerics::Complex;
use crate::vibration::FrequencyResponse;
use crate::vibration::modal::HarmonicResponse;
use crate::vibration::modes::ModesError;

/// X of a coordinate with `x = Re(X e^(iΩt))`, for the only angular frequency that excites the model.
///
/// # Errors
///
/// [`Unavailable::NoForce`], [`Unavailable::SeveralFrequencies`], [`Unavailable::NotHarmonic`], [`Unavailable::Resonance`].
pub(crate) fn complex_amplitude(
    numbers: &Numbers,
    coordinate: usize,
) -> Result<Complex, Unavailable> {
    Ok(amplitudes(numbers, excitation::only(numbers)?)?[coordinate])
}

/// The complex amplitude as a value.
///
/// # Errors
///
/// As for [`complex_amplitude`].
pub(crate) fn complex_amplitude_value(
    numbers: &Numbers,
    coordinate: usize,
) -> Result<Value, Unavailable> {
    let amplitude = complex_amplitude(numbers, coordinate)?;
    let form = Form {
        field: Field::Complex,
        shape: Shape::Scalar,
    };
    let bound = 16.0 * f64::EPSILON * amplitude.abs();
    Value::new(form, vec![amplitude.re, amplitude.im], vec![bound; 2]).ok_or(Unavailable::Singular)
}

/// The solution of `(K − Ω² M + iΩ C) X = F`.
pub(crate) fn amplitudes(
    numbers: &Numbers,
    harmonic: &HarmonicLoad,
) -> Result<Vec<Complex>, Unavailable> {
    let forces = harmonic.cosine.iter().zip(&harmonic.sine);
    let forces: Vec<_> = forces.map(|(a, b)| Complex::new(*a, -*b)).collect();
    // One coordinate has a closed form, which keeps its digits beside resonance.
    if let ([force], Ok(oscillator)) = (forces.as_slice(), numbers.oscillator()) {
        let response = FrequencyResponse::at(&oscillator, harmonic.frequency);
        if response.is_unbounded() {
            return Err(Unavailable::Resonance);
        }
        return Ok(vec![*force * response.receptance()]);
    }
    let response = HarmonicResponse::of(
        &matrices::system(numbers)?,
        &modal::damping(numbers)?,
        harmonic.frequency,
    );
    let amplitudes = response.and_then(|own| own.amplitudes(&forces));
    amplitudes.map_err(|error| match error {
        ModesError::Resonance => Unavailable::Resonance,
        other => Unavailable::Modes(other),
    })
}
