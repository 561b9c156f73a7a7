//! The undamped oscillator from rest under F cos Ωt, at, near and far from resonance by one formula.
//!
//! ```text
//! σ = (ω0 + Ω)/2,   δ = (ω0 - Ω)/2 = (k - m Ω²)/(4 m σ)
//! x = (F/m) sin σt/σ sin δt/(2 δ)
//! v = (F/m) (cos σt sin δt/δ + sin σt/σ cos δt)/2
//! ```

use super::super::oscillator::Scaled;
use super::super::state::State;
use super::frequency_response::residual_stiffness;
use crate::numerics::Dd;

/// Half the difference of the frequencies, as a part of half their sum, below which 1/δ may be large.
const NEAR: f64 = 0.0625;

/// Half sum and half difference of the two angular frequencies.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beat {
    carrier: Dd,
    detuning: Dd,
    /// 1/(2 σ δ) where the two are far apart: one rounding instead of two quotients for each position.
    apart: Option<f64>,
}

impl Beat {
    pub(super) fn of(scaled: &Scaled, frequency: f64) -> Self {
        let carrier = (scaled.natural_frequency() + frequency) * 0.5;
        let residual = residual_stiffness(scaled.mass, scaled.stiffness, frequency);
        Self::new(carrier, residual / scaled.mass / (carrier * 4.0))
    }

    /// For a unit mass and a stiffness of thirty digits.
    pub(super) fn of_mode(stiffness: Dd, frequency: f64) -> Self {
        let carrier = (stiffness.sqrt() + frequency) * 0.5;
        let residual = stiffness - Dd::product(frequency, frequency);
        Self::new(carrier, residual / (carrier * 4.0))
    }

    fn new(carrier: Dd, detuning: Dd) -> Self {
        let is_far = detuning.hi().abs() > NEAR * carrier.hi();
        Self {
            carrier,
            detuning,
            apart: is_far.then(|| (Dd::from(0.5) / (carrier * detuning)).hi()),
        }
    }

    /// Position under a unit force on a unit mass.
    pub(super) fn position(&self, t: f64) -> f64 {
        let (fast, _) = (self.carrier * t).sin_cos_to_f64();
        let (slow, _) = (self.detuning * t).sin_cos_to_f64();
        if let Some(factor) = self.apart {
            return factor * (fast * slow);
        }
        0.5 * over(fast, self.carrier, t) * over(slow, self.detuning, t)
    }

    /// State under a unit force on a unit mass.
    pub(super) fn state(&self, t: f64) -> State {
        let (fast, fast_cosine) = (self.carrier * t).sin_cos_to_f64();
        let (slow, slow_cosine) = (self.detuning * t).sin_cos_to_f64();
        let (fast, slow) = (over(fast, self.carrier, t), over(slow, self.detuning, t));
        State {
            position: 0.5 * fast * slow,
            velocity: 0.5 * (fast_cosine * slow + fast * slow_cosine),
        }
    }
}

/// sin(ω t)/ω from the sine.
fn over(sine: f64, frequency: Dd, t: f64) -> f64 {
    if sine == 0.0 && frequency.hi().abs() * t < 1.0 {
        t
    } else {
        sine / frequency.hi()
    }
}
