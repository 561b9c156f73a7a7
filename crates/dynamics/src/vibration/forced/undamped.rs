//! The undamped oscillator from rest under F cos Ωt, at, near and far from resonance by one formula.
//!
//! ```text
//! σ = (ω0 + Ω)/2,   δ = (ω0 - Ω)/2 = (k - m Ω²)/(4 m σ)
//! x = (F/m) sin σt/σ sin δt/(2 δ)
//! v = (F/m) (cos σt sin δt/δ + sin σt/σ cos δt)/2
//! ```
//!
//! Far from resonance and once the motion has begun nothing cancels in the difference of the cosines, which then takes
//! fewer roundings:
//!
//! ```text
//! x = (F/m) (cos Ωt - cos ω0 t)/(4 σ δ)
//! ```

use super::frequency_response::residual_stiffness;
use crate::numerics::Dd;
use crate::vibration::oscillator::Scaled;
use crate::vibration::state::State;

/// Half the difference of the frequencies, as a part of half their sum, from which on they are far apart.
const FAR: f64 = 0.0625;

/// Half sum and half difference of the two angular frequencies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beat {
    carrier: Dd,
    detuning: Dd,
    /// Where the frequencies are far apart.
    apart: Option<Apart>,
}

/// Two frequencies that are far apart.
#[derive(Clone, Copy, Debug)]
struct Apart {
    natural: Dd,
    frequency: f64,
    /// ω0² - Ω².
    distance: f64,
}

impl Beat {
    pub(crate) fn of(scaled: &Scaled, frequency: f64) -> Self {
        let residual = residual_stiffness(scaled.mass, scaled.stiffness, frequency) / scaled.mass;
        Self::new(scaled.natural_frequency(), frequency, residual)
    }

    /// For a unit mass and a stiffness of thirty digits.
    pub(crate) fn of_mode(stiffness: Dd, frequency: f64) -> Self {
        let residual = stiffness - Dd::product(frequency, frequency);
        Self::new(stiffness.sqrt(), frequency, residual)
    }

    /// From both frequencies and ω0² - Ω².
    fn new(natural: Dd, frequency: f64, residual: Dd) -> Self {
        let carrier = (natural + frequency) * 0.5;
        let detuning = residual / (carrier * 4.0);
        let is_far = detuning.hi().abs() > FAR * carrier.hi();
        Self {
            carrier,
            detuning,
            apart: is_far.then(|| Apart {
                natural,
                frequency,
                distance: residual.hi(),
            }),
        }
    }

    /// The two frequencies where they are far apart and the motion has begun.
    fn apart(&self, t: f64) -> Option<&Apart> {
        self.apart.as_ref().filter(|_| self.carrier.hi() * t > 1.0)
    }

    /// Position under a unit force on a unit mass.
    pub(crate) fn position(&self, t: f64) -> f64 {
        if let Some(apart) = self.apart(t) {
            let (_, forced) = Dd::product(apart.frequency, t).sin_cos_to_f64();
            let (_, free) = (apart.natural * t).sin_cos_to_f64();
            return (forced - free) / apart.distance;
        }
        let (fast, _) = (self.carrier * t).sin_cos_to_f64();
        let (slow, _) = (self.detuning * t).sin_cos_to_f64();
        0.5 * over(fast, self.carrier, t) * over(slow, self.detuning, t)
    }

    /// State under a unit force on a unit mass.
    pub(crate) fn state(&self, t: f64) -> State {
        if let Some(apart) = self.apart(t) {
            let (forced_sine, forced) = Dd::product(apart.frequency, t).sin_cos_to_f64();
            let (free_sine, free) = (apart.natural * t).sin_cos_to_f64();
            return State {
                position: (forced - free) / apart.distance,
                velocity: (apart.natural.hi() * free_sine - apart.frequency * forced_sine)
                    / apart.distance,
            };
        }
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
    // At resonance the detuning is zero, and this is the limit of the quotient.
    if sine == 0.0 && frequency.hi().abs() * t < 1.0 {
        t
    } else {
        sine / frequency.hi()
    }
}
