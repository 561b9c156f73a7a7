//! Harmonic forces as numbers.

use super::{Numbers, Unavailable};
use crate::numerics::sin_cos;

/// Harmonic forces of one angular frequency, `a cos Ωt + b sin Ωt` on each coordinate.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    /// Ω, not negative.
    pub(crate) frequency: f64,
    pub(crate) cosine: Vec<f64>,
    pub(crate) sine: Vec<f64>,
}

/// The forces of the only angular frequency.
pub(crate) fn only(numbers: &Numbers) -> Result<&Drive, Unavailable> {
    match numbers.drives()? {
        [] => Err(Unavailable::NoForce),
        [only] => Ok(only),
        _ => Err(Unavailable::SeveralFrequencies),
    }
}

pub(crate) fn all(numbers: &Numbers) -> Result<Vec<Drive>, Unavailable> {
    let driving = numbers.model.evaluation.driving()?;
    let mut drives: Vec<Drive> = Vec::new();
    if driving.terms.is_empty() {
        return Ok(drives);
    }
    let values = numbers.value(&driving.numbers, &[])?;
    let size = numbers.model.degrees_of_freedom();
    for (term, own) in driving.terms.iter().zip(values.numbers().chunks_exact(3)) {
        let [factor, frequency, phase] = [own[0], own[1], own[2]];
        let (cosine, sine) = cosine_and_sine(factor, frequency, phase, term.is_sine);
        let frequency = frequency.abs();
        let known = drives.iter().position(|own| own.frequency == frequency);
        let at = known.unwrap_or_else(|| {
            drives.push(Drive {
                frequency,
                cosine: vec![0.0; size],
                sine: vec![0.0; size],
            });
            drives.len() - 1
        });
        drives[at].cosine[term.equation] += cosine;
        drives[at].sine[term.equation] += sine;
    }
    Ok(drives)
}

/// The factors of cos Ωt and sin Ωt in a harmonic with a phase; Ω is taken positive.
fn cosine_and_sine(factor: f64, frequency: f64, phase: f64, is_sine: bool) -> (f64, f64) {
    let (phase_sine, phase_cosine) = sin_cos(phase);
    // cos(Ωt + φ) = cos φ cos Ωt − sin φ sin Ωt, and sin(Ωt + φ) = sin φ cos Ωt + cos φ sin Ωt.
    let (cosine, sine) = if is_sine {
        (factor * phase_sine, factor * phase_cosine)
    } else {
        (factor * phase_cosine, -factor * phase_sine)
    };
    (cosine, if frequency < 0.0 { -sine } else { sine })
}
