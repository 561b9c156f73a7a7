//! The task `log_decrement`: damping from two amplitudes that are n damped periods apart.
//!
//! `x1 xn1 n Td [m]` give `delta zeta lambda omega0`, and with the mass `c k`, else `null`.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::vibration::LogarithmicDecrement;

pub(crate) struct LogDecrement;

impl Task for LogDecrement {
    fn name(&self) -> &'static str {
        "log_decrement"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["x1", "xn1", "n", "Td", "m"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let (first, last) = (parameters.number("x1")?, parameters.number("xn1")?);
        let decrement = LogarithmicDecrement::of(first, last, parameters.count("n")?)
            .map_err(RequestError::domain)?;
        let period = positive("period", parameters.number("Td")?)?;
        let mass = parameters
            .optional_number("m")?
            .map(|mass| positive("mass", mass))
            .transpose()?;
        Ok(ResultReply::default()
            .number("delta", decrement.value())
            .number("zeta", decrement.damping_ratio())
            .optional("lambda", Some(decrement.decay_rate(period)))
            .optional("omega0", Some(decrement.natural_angular_frequency(period)))
            .optional("c", mass.map(|mass| decrement.damping(mass, period)))
            .optional("k", mass.map(|mass| decrement.stiffness(mass, period))))
    }
}

fn positive(name: &str, value: f64) -> Result<f64, RequestError> {
    if value > 0.0 {
        Ok(value)
    } else {
        Err(RequestError::OutOfDomain {
            reason: format!("the {name} must be positive, not {value}"),
        })
    }
}
