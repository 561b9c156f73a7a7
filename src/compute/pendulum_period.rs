//! The task `pendulum_period`: the period of a pendulum released from rest.
//!
//! `L g theta0` give `T T_small excess`, the period, that of small swings and `T/T_small - 1`.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::Pendulum;

pub(crate) struct PendulumPeriod;

impl Task for PendulumPeriod {
    fn name(&self) -> &'static str {
        "pendulum_period"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["L", "g", "theta0"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let pendulum = Pendulum::new(parameters.number("L")?, parameters.number("g")?)
            .map_err(RequestError::domain)?;
        let amplitude = parameters.number("theta0")?;
        let period = pendulum.period(amplitude).map_err(RequestError::domain)?;
        let excess = pendulum
            .period_excess(amplitude)
            .map_err(RequestError::domain)?;
        Ok(ResultReply::default()
            .number("T", period)
            .number("T_small", pendulum.small_period())
            .number("excess", excess))
    }
}
