//! The task `coulomb_stop`: when and where dry friction brings an oscillator to rest.
//!
//! `m k mu g x0` and, with their defaults, `c` 0, `v0` 0, `mu_s` (static) `mu`, `F` (constant force) 0 give `n_half t_stop
//! x_stop path x_stick`, and with `t` also `x_t v_t`. All numbers are taken as the decimals that they are written as.
//! `n_half` counts the slides between instants of rest; a start with a velocity begins the first. `x_stick` is the
//! distance from the equilibrium within which friction can hold the mass. Where it only creeps towards its rest `t_stop`
//! is `null`; where it swings for ever, so are `n_half`, and without damping `x_stop` and `path`.

use super::{Parameters, RequestError, ResultReply, Task};
use crate::numerics::{Dd, ExactNumber};
use crate::vibration::{DryFriction, FrictionMotion, FrictionOscillator};

pub(crate) struct CoulombStop;

impl Task for CoulombStop {
    fn name(&self) -> &'static str {
        "coulomb_stop"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["m", "k", "mu", "g", "x0", "c", "t", "v0", "mu_s", "F"]
    }

    fn solve(&self, parameters: &Parameters) -> Result<ResultReply, RequestError> {
        let system = system(parameters)?;
        let motion = system
            .motion(parameters.exact("x0")?, or_zero(parameters, "v0")?)
            .map_err(RequestError::domain)?;
        let reply = describe(&motion).number("x_stick", system.stick_half_width());
        if !parameters.has("t") {
            return Ok(reply);
        }
        let path = motion.path();
        Ok(
            reply.states(["x_t", "v_t"], &parameters.times("t")?, |time| {
                path.state(on_paper(time))
            }),
        )
    }
}

fn system(parameters: &Parameters) -> Result<FrictionOscillator, RequestError> {
    let kinetic = parameters.exact("mu")?;
    let fixed = if parameters.has("mu_s") {
        parameters.exact("mu_s")?
    } else {
        kinetic
    };
    let mass = parameters.exact("m")?;
    let friction = DryFriction::of_weight(kinetic, fixed, mass, parameters.exact("g")?);
    let (damping, stiffness) = (or_zero(parameters, "c")?, parameters.exact("k")?);
    let force = or_zero(parameters, "F")?;
    FrictionOscillator::new(mass, damping, stiffness, friction)
        .and_then(|system| system.with_force(force))
        .map_err(RequestError::domain)
}

fn describe(motion: &FrictionMotion) -> ResultReply {
    ResultReply::default()
        .count("n_half", motion.slides())
        .optional("t_stop", Some(motion.stop_time()))
        .optional("x_stop", motion.rest_position())
        .optional("path", Some(motion.path_length()))
}

fn or_zero(parameters: &Parameters, name: &'static str) -> Result<ExactNumber, RequestError> {
    if parameters.has(name) {
        parameters.exact(name)
    } else {
        Ok(ExactNumber::ZERO)
    }
}

/// The decimal that was read as this time.
fn on_paper(time: f64) -> Dd {
    ExactNumber::on_paper(time).map_or(Dd::from(time), ExactNumber::to_dd)
}
