//! The task `forced_response`: the motion of an oscillator under the force F0 cos Ωt.
//!
//! `m c k F0 Omega x0 v0 t` give `x v`. Times are not negative.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::{self, HarmonicForce};

pub(crate) struct ForcedResponse;

impl Task for ForcedResponse {
    fn name(&self) -> &'static str {
        "forced_response"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["m", "c", "k", "F0", "Omega", "x0", "v0", "t"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let oscillator = parameters.oscillator()?;
        let force = HarmonicForce::cosine(parameters.number("F0")?, parameters.number("Omega")?);
        let times = parameters.times("t")?;
        if let Some(time) = times.as_slice().iter().find(|time| **time < 0.0) {
            return Err(RequestError::OutOfDomain {
                reason: format!("the time {time} is before the start"),
            });
        }
        let motion = vibration::ForcedResponse::of(&oscillator, force, parameters.initial_state()?);
        Ok(ResultReply::default().states(["x", "v"], &times, |time| motion.state(time)))
    }
}
