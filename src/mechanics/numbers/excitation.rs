//! The excitation of a model as numbers: harmonic forces.

use super::{Numbers, Unavailable};
use crate::numerics::sin_cos;

/// Harmonic forces of one angular frequency, `a cos Ωt + b sin Ωt` on each coordinate.
#[derive(Clone, Debug)]
pub(crate) struct HarmonicLoad {
    /// Ω, not negative.
    pub(crate) frequency: f64,
    pub(crate) cosine: Vec<f64>,
    pub(crate) sine: Vec<f64>,
}

/// The forces of the only angular frequency.
pub(crate) fn only(numbers: &Numbers) -> Result<&HarmonicLoad, Unavailable> {
    match numbers.excitation()? {
        [] => Err(Unavailable::NoForce),
        [only] => Ok(only),
        _ => Err(Unavailable::SeveralFrequencies),
    }
}

/// The forces of each angular frequency, in the order of the terms.
pub(crate) fn all(numbers: &Numbers) -> Result<Vec<HarmonicLoad>, Unavailable> {
    let excitation = numbers.model.evaluation.excitation()?;
    let mut harmonics: Vec<HarmonicLoad> = Vec::new();
    if excitation.terms.is_empty() {
        return Ok(harmonics);
    }
    let values = numbers.value(&excitation.numbers, &[])?;
    let size = numbers.model.degrees_of_freedom();
    for (term, own) in excitation
        .terms
        .iter()
        .zip(values.numbers().chunks_exact(3))
    {
        let [factor, frequency, phase] = [own[0], own[1], own[2]];
        let (cosine, sine) = cosine_and_sine(factor, frequency, phase, term.is_sine);
        let frequency = frequency.abs();
        let known = harmonics.iter().position(|own| own.frequency == frequency);
        let at = known.unwrap_or_else(|| {
            harmonics.push(HarmonicLoad {
                frequency,
                cosine: vec![0.0; size],
                sine: vec![0.0; size],
            });
            harmonics.len() - 1
        });
        harmonics[at].cosine[term.equation] += cosine;
        harmonics[at].sine[term.equation] += sine;
    }
    Ok(harmonics)
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
