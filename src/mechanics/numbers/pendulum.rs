//! The pendulum at any amplitude: `I θ'' + A sin θ = 0`.

use super::{Motion, Numbers, Unavailable};
use crate::expr::{Precise, Value};
use crate::numerics::Dd;
use crate::vibration::Pendulum;

impl Numbers {
    /// The period of the swing from the initial state, at any amplitude.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NotPendulum`], or a number that is missing.
    pub fn exact_period(&self) -> Result<Value, Unavailable> {
        let (pendulum, _) = self.pendulum()?;
        let start = self.start()?[0];
        let period = if start.velocity == 0.0 {
            pendulum.period(start.position)?
        } else {
            let motion = pendulum.motion(start.position, start.velocity)?;
            motion.period().ok_or(Unavailable::NotOscillating)?
        };
        Ok(self.with_relative_bound(period))
    }

    /// The motion from the initial state, at any amplitude.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NotPendulum`], or a number that is missing.
    pub(crate) fn exact_motion(&self) -> Result<Motion, Unavailable> {
        let (pendulum, square_rate) = self.pendulum()?;
        let start = self.start()?[0];
        let motion = pendulum.motion(start.position, start.velocity)?;
        Ok(Motion::of_pendulum(Box::new(motion), square_rate))
    }

    /// The pendulum that the model is, and the square of its natural angular frequency.
    fn pendulum(&self) -> Result<(Pendulum, f64), Unavailable> {
        if !self.model.evaluation.is_pendulum {
            return Err(Unavailable::NotPendulum);
        }
        let quarter_turn = [Precise::of_dd(Dd::PI * 0.5, 0.0)];
        let moment = self
            .value(&self.model.evaluation.restoring, &quarter_turn)?
            .numbers()[0];
        let inertia = self.mass_matrix()?.numbers()[0];
        // Only the ratio counts: a string of length I in a gravity A.
        Ok((Pendulum::new(inertia, moment)?, moment / inertia))
    }
}
