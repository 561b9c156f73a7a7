//! The task `free_response`: the motion of an oscillator from an initial state.
//!
//! `m c k x0 v0 t` give `x v omega0 zeta regime omega_d r_slow r_fast`.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::{self, Oscillator};

pub(crate) struct FreeResponse;

impl Task for FreeResponse {
    fn name(&self) -> &'static str {
        "free_response"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["m", "c", "k", "x0", "v0", "t"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let oscillator = parameters.oscillator()?;
        let motion = vibration::FreeResponse::of(&oscillator, parameters.initial_state()?);
        let reply = ResultReply::default().states(["x", "v"], &parameters.times("t")?, |time| {
            motion.state(time)
        });
        Ok(describe(reply, &oscillator))
    }
}

/// Adds what belongs to the oscillator alone.
fn describe(reply: ResultReply, oscillator: &Oscillator) -> ResultReply {
    let (slow, fast) = oscillator.decay_roots().unzip();
    reply
        .optional("omega0", Some(oscillator.natural_angular_frequency()))
        .optional("zeta", Some(oscillator.damping_ratio()))
        .word("regime", oscillator.regime().name())
        .optional("omega_d", oscillator.damped_angular_frequency())
        .optional("r_slow", slow)
        .optional("r_fast", fast)
}
