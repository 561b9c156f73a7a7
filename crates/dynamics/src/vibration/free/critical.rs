//! Critically damped motion.
//!
//! ```text
//! x = e^(-λt) (x0 + (v0 + λ x0) t)
//! v = e^(-λt) (v0 - λ (v0 + λ x0) t)
//! ```

use super::decay;
use super::grid::{BlockFactors, FactorRow};
use crate::numerics::{Dd, sum_of_products};
use crate::vibration::oscillator::Scaled;
use crate::vibration::state::State;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Critical {
    pub(crate) initial: State,
    /// Factor of the time in the position, v0 + λ x0.
    pub(crate) position_slope: f64,
    /// Factor of the time in the velocity, -λ (v0 + λ x0).
    pub(crate) velocity_slope: f64,
    /// -λ.
    pub(crate) growth: Dd,
}

impl Critical {
    #[inline]
    pub(crate) fn of(scaled: &Scaled, initial: State) -> Self {
        let State { position, velocity } = initial;
        let growth = -scaled.decay_rate();
        let slope = sum_of_products(2.0 * scaled.mass, velocity, scaled.damping, position)
            / (2.0 * scaled.mass);
        Self {
            initial,
            position_slope: slope,
            velocity_slope: growth.hi() * slope,
            growth,
        }
    }

    #[inline]
    pub(crate) fn exponent(&self, t: f64) -> f64 {
        self.growth.hi() * t
    }

    #[inline]
    pub(crate) fn position<const LIFTED: bool>(&self, t: f64) -> f64 {
        decay::<LIFTED>(self.growth * t) * (self.initial.position + self.position_slope * t)
    }

    #[inline]
    pub(crate) fn state<const LIFTED: bool>(&self, t: f64) -> State {
        let envelope = decay::<LIFTED>(self.growth * t);
        State {
            position: envelope * (self.initial.position + self.position_slope * t),
            velocity: envelope * (self.initial.velocity + self.velocity_slope * t),
        }
    }

    /// Decay e^(-λτ), alone and times τ.
    pub(crate) fn row(&self, time: Dd) -> FactorRow {
        let envelope = (self.growth * time).exp_to_f64();
        FactorRow {
            position: envelope,
            shared: envelope * time.hi(),
            velocity: envelope,
        }
    }

    pub(crate) fn block(&self, time: Dd) -> BlockFactors {
        let envelope = (self.growth * time).exp_to_f64();
        let line =
            |value: f64, slope: f64| (envelope * (value + slope * time.hi()), envelope * slope);
        BlockFactors {
            position: line(self.initial.position, self.position_slope),
            velocity: line(self.initial.velocity, self.velocity_slope),
        }
    }
}
