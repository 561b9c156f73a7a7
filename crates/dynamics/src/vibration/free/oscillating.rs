//! Undamped and underdamped motion; one formula up to the limit of critical damping.
//!
//! ```text
//! x = e^(-λt) (x0 cos ω_d t + (2 m v0 + c x0)/s sin ω_d t)
//! v = e^(-λt) (v0 cos ω_d t - (2 k x0 + c v0)/s sin ω_d t),   s = √(4 m k - c²)
//! ```

use super::decay;
use super::grid::{BlockFactors, FactorRow};
use crate::numerics::{Dd, atan2, hypot, sum_of_products};
use crate::vibration::oscillator::Scaled;
use crate::vibration::state::State;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Oscillating {
    pub(crate) initial: State,
    /// Factor of the sine in the position.
    pub(crate) position_sine: f64,
    /// Factor of the sine in the velocity.
    pub(crate) velocity_sine: f64,
    /// -λ.
    pub(crate) growth: Dd,
    /// ω_d.
    pub(crate) frequency: Dd,
    pub(crate) is_damped: bool,
}

impl Oscillating {
    #[inline]
    pub(crate) fn of(scaled: &Scaled, root: Dd, initial: State) -> Self {
        let Scaled {
            mass,
            damping,
            stiffness,
            ..
        } = *scaled;
        let State { position, velocity } = initial;
        let per_mass = Dd::quotient(0.5, mass);
        Self {
            initial,
            position_sine: sum_of_products(2.0 * mass, velocity, damping, position) / root.hi(),
            velocity_sine: -sum_of_products(2.0 * stiffness, position, damping, velocity)
                / root.hi(),
            growth: per_mass * -damping,
            frequency: root * per_mass,
            is_damped: damping > 0.0,
        }
    }

    #[inline]
    pub(crate) fn exponent(&self, t: f64) -> f64 {
        self.growth.hi() * t
    }

    #[inline]
    pub(crate) fn envelope<const LIFTED: bool>(&self, t: f64) -> f64 {
        if self.is_damped {
            decay::<LIFTED>(self.growth.ordinary_times(t))
        } else {
            1.0
        }
    }

    #[inline]
    pub(crate) fn position<const LIFTED: bool>(&self, t: f64) -> f64 {
        let (sine, cosine) = self.frequency.ordinary_times(t).sin_cos_to_f64();
        self.envelope::<LIFTED>(t) * (self.initial.position * cosine + self.position_sine * sine)
    }

    #[inline]
    pub(crate) fn state<const LIFTED: bool>(&self, t: f64) -> State {
        let (sine, cosine) = self.frequency.ordinary_times(t).sin_cos_to_f64();
        let envelope = self.envelope::<LIFTED>(t);
        State {
            position: envelope * (self.initial.position * cosine + self.position_sine * sine),
            velocity: envelope * (self.initial.velocity * cosine + self.velocity_sine * sine),
        }
    }

    pub(crate) fn amplitude_and_phase(&self) -> (f64, f64) {
        let (cosine, sine) = (self.initial.position, self.position_sine);
        (hypot(cosine, sine), atan2(sine, cosine))
    }

    /// Decay and rotation, e^(-λτ) cos ω_d τ and -e^(-λτ) sin ω_d τ.
    pub(crate) fn row(&self, time: Dd) -> FactorRow {
        let (sine, cosine) = (self.frequency * time).sin_cos_to_f64();
        let envelope = if self.is_damped {
            (self.growth * time).exp_to_f64()
        } else {
            1.0
        };
        FactorRow {
            position: envelope * cosine,
            shared: -envelope * sine,
            velocity: envelope * cosine,
        }
    }

    pub(crate) fn block(&self, time: Dd) -> BlockFactors {
        let FactorRow {
            position: cosine,
            shared: minus_sine,
            ..
        } = self.row(time);
        let turned = |even: f64, odd: f64| {
            (
                even * cosine - odd * minus_sine,
                -even * minus_sine - odd * cosine,
            )
        };
        BlockFactors {
            position: turned(self.initial.position, self.position_sine),
            velocity: turned(self.initial.velocity, self.velocity_sine),
        }
    }
}
