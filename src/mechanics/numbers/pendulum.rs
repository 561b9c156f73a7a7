//! The pendulum at any amplitude: `I θ'' + A sin θ = 0`.

use super::{Motion, Numbers, Unavailable, single};
use crate::expr::{Precise, Value};
use crate::numerics::Dd;
use crate::vibration::Pendulum;

/// The period of the swing from the initial state, at any amplitude.
///
/// # Errors
///
/// [`Unavailable::NotPendulum`], or a number that is missing.
pub(crate) fn period(numbers: &Numbers) -> Result<Value, Unavailable> {
    let (pendulum, _) = pendulum(numbers)?;
    let start = numbers.start()?[0];
    let period = if start.velocity == 0.0 {
        pendulum.period(start.position)?
    } else {
        let motion = pendulum.motion(start.position, start.velocity)?;
        motion.period().ok_or(Unavailable::NotOscillating)?
    };
    Ok(single::with_relative_bound(numbers, period))
}

/// The motion from the initial state, at any amplitude.
///
/// # Errors
///
/// [`Unavailable::NotPendulum`], or a number that is missing.
pub(crate) fn motion(numbers: &Numbers) -> Result<Motion, Unavailable> {
    let (pendulum, square_rate) = pendulum(numbers)?;
    let start = numbers.start()?[0];
    let motion = pendulum.motion(start.position, start.velocity)?;
    Ok(Motion::of_pendulum(Box::new(motion), square_rate))
}

/// The pendulum that the model is, and the square of its natural angular frequency.
fn pendulum(numbers: &Numbers) -> Result<(Pendulum, f64), Unavailable> {
    if !numbers.model.evaluation.is_pendulum {
        return Err(Unavailable::NotPendulum);
    }
    let quarter_turn = [Precise::of_dd(Dd::PI * 0.5, 0.0)];
    let moment = numbers
        .value(&numbers.model.evaluation.restoring, &quarter_turn)?
        .numbers()[0];
    let inertia = numbers.mass_matrix()?.numbers()[0];
    // Only the ratio counts: a string of length I in a gravity A.
    Ok((Pendulum::new(inertia, moment)?, moment / inertia))
}
