//! The task `steady_amplitude_phase`: the steady state under the force F0 cos Ωt.
//!
//! `m c k F0 Omega` give `X phi power transmissibility`, all of them `null` where an undamped oscillator resonates.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::FrequencyResponse;

pub(crate) struct SteadyAmplitudePhase;

impl Task for SteadyAmplitudePhase {
    fn name(&self) -> &'static str {
        "steady_amplitude_phase"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["m", "c", "k", "F0", "Omega"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let response =
            FrequencyResponse::at(&parameters.oscillator()?, parameters.number("Omega")?);
        let force = parameters.number("F0")?;
        let steady = |value: f64| (!response.is_unbounded()).then_some(value);
        Ok(ResultReply::default()
            .optional("X", steady(response.amplitude(force)))
            .optional("phi", steady(response.phase_lag()))
            .optional("power", steady(response.mean_power(force)))
            .optional("transmissibility", steady(response.transmissibility())))
    }
}
