//! The task `resonance_bandwidth`: resonance, cut-offs and bandwidth of displacement and velocity.
//!
//! `m c k` give `omega_r gain_peak omega1 omega2 bandwidth` of the displacement, `null` where there are none, and
//! `Q vel_omega1 vel_omega2 vel_bandwidth`.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::{DisplacementResonance, VelocityResonance};

pub(crate) struct ResonanceBandwidth;

impl Task for ResonanceBandwidth {
    fn name(&self) -> &'static str {
        "resonance_bandwidth"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["m", "c", "k"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let oscillator = parameters.oscillator()?;
        let displacement = DisplacementResonance::of(&oscillator);
        let velocity = VelocityResonance::of(&oscillator);
        let of = |quantity: fn(&DisplacementResonance) -> Option<f64>| {
            displacement.as_ref().and_then(quantity)
        };
        Ok(ResultReply::default()
            .optional(
                "omega_r",
                of(|resonance| Some(resonance.angular_frequency())),
            )
            .optional("gain_peak", of(DisplacementResonance::peak_gain))
            .optional("omega1", of(DisplacementResonance::lower_cut_off))
            .optional("omega2", of(|resonance| Some(resonance.upper_cut_off())))
            .optional("bandwidth", of(DisplacementResonance::bandwidth))
            .optional("Q", oscillator.quality_factor())
            .optional("vel_omega1", Some(velocity.lower_cut_off()))
            .optional("vel_omega2", Some(velocity.upper_cut_off()))
            .optional("vel_bandwidth", Some(velocity.bandwidth())))
    }
}
