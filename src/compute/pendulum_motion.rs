//! The task `pendulum_motion`: the motion of a pendulum from any start.
//!
//! `L g t` and, 0 if they are absent, the angle `theta0` and the angular velocity `omega0` at the start give `theta
//! omega`. The angle is unwrapped: a pendulum that turns over counts its turns.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::Pendulum;
use crate::vibration::State;

pub(crate) struct PendulumMotion;

impl Task for PendulumMotion {
    fn name(&self) -> &'static str {
        "pendulum_motion"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["L", "g", "theta0", "omega0", "t"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let pendulum = Pendulum::new(parameters.number("L")?, parameters.number("g")?)
            .map_err(RequestError::domain)?;
        let angle = parameters.optional_number("theta0")?.unwrap_or(0.0);
        let velocity = parameters.optional_number("omega0")?.unwrap_or(0.0);
        let motion = pendulum
            .motion(angle, velocity)
            .map_err(RequestError::domain)?;
        Ok(
            ResultReply::default().states(["theta", "omega"], &parameters.times("t")?, |time| {
                let (position, velocity) = motion.state(time);
                State { position, velocity }
            }),
        )
    }
}
