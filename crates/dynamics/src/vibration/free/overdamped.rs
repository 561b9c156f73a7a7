//! Overdamped motion: two decaying exponentials, written as divided differences while they are close.
//!
//! ```text
//! q = v0 - r_s x0,   p = v0 - r_f x0,   P = -expm1(-(s/m) t) m/s
//! x = e^(r_s t) (x0 + q P)                          v = v0 e^(r_f t) + r_s p P e^(r_s t)
//!   = (p e^(r_s t) - q e^(r_f t)) m/s                 = (r_s p e^(r_s t) - r_f q e^(r_f t)) m/s
//! ```

use super::decay;
use super::grid::{BlockFactors, FactorRow};
use crate::numerics::{Dd, expm1};
use crate::vibration::oscillator::Scaled;
use crate::vibration::state::State;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Overdamped {
    pub(crate) initial: State,
    /// r_s.
    pub(crate) slow: Dd,
    /// r_f.
    pub(crate) fast: Dd,
    /// s/m, the distance of the roots.
    pub(crate) gap: f64,
    /// q, what remains of the motion when the slow exponential is taken off.
    pub(crate) beyond_slow: f64,
    /// p, likewise for the fast one.
    pub(crate) beyond_fast: f64,
}

impl Overdamped {
    #[inline]
    pub(crate) fn of(scaled: &Scaled, root: Dd, initial: State) -> Self {
        let (slow, fast) = scaled.real_roots(root);
        Self {
            initial,
            slow,
            fast,
            gap: root.hi() / scaled.mass,
            beyond_slow: (initial.velocity - slow * initial.position).hi(),
            beyond_fast: (initial.velocity - fast * initial.position).hi(),
        }
    }

    #[inline]
    pub(crate) fn exponent(&self, t: f64) -> f64 {
        self.slow.hi() * t
    }

    /// Whether the exponentials are far enough apart to be added.
    #[inline]
    fn is_separated(&self, t: f64) -> bool {
        self.gap * t > 1.0
    }

    /// P, the divided difference of the exponential over that of the slow root.
    #[inline]
    fn ramp(&self, t: f64) -> f64 {
        -expm1(-self.gap * t) / self.gap
    }

    /// Terms of the position that follow the slow and the fast exponential.
    #[inline]
    fn terms<const LIFTED: bool>(&self, t: f64) -> (f64, f64) {
        (
            decay::<LIFTED>(self.slow * t) * (self.beyond_fast / self.gap),
            decay::<LIFTED>(self.fast * t) * (-self.beyond_slow / self.gap),
        )
    }

    #[inline]
    pub(crate) fn position<const LIFTED: bool>(&self, t: f64) -> f64 {
        if self.is_separated(t) {
            let (slow, fast) = self.terms::<LIFTED>(t);
            slow + fast
        } else {
            decay::<LIFTED>(self.slow * t)
                * (self.initial.position + self.beyond_slow * self.ramp(t))
        }
    }

    #[inline]
    pub(crate) fn state<const LIFTED: bool>(&self, t: f64) -> State {
        if self.is_separated(t) {
            let (slow, fast) = self.terms::<LIFTED>(t);
            return State {
                position: slow + fast,
                velocity: self.slow.hi() * slow + self.fast.hi() * fast,
            };
        }
        let (envelope, ramp) = (decay::<LIFTED>(self.slow * t), self.ramp(t));
        State {
            position: envelope * (self.initial.position + self.beyond_slow * ramp),
            velocity: self.initial.velocity * decay::<LIFTED>(self.fast * t)
                + self.slow.hi() * self.beyond_fast * ramp * envelope,
        }
    }

    /// Decay e^(r_s τ), alone and times P(τ), and e^(r_f τ).
    pub(crate) fn row(&self, time: Dd) -> FactorRow {
        let envelope = (self.slow * time).exp_to_f64();
        let ramp = -expm1(-self.gap * time.hi()) / self.gap;
        FactorRow {
            position: envelope,
            shared: envelope * ramp,
            velocity: (self.fast * time).exp_to_f64(),
        }
    }

    /// The state at the block's start, and q and p of the motion from there, which decay with one root each.
    pub(crate) fn block(&self, time: Dd) -> BlockFactors {
        let state = self.state::<false>(time.hi());
        let beyond_slow = self.beyond_slow * (self.fast * time).exp_to_f64();
        let beyond_fast = self.beyond_fast * (self.slow * time).exp_to_f64();
        BlockFactors {
            position: (state.position, beyond_slow),
            velocity: (state.velocity, self.slow.hi() * beyond_fast),
        }
    }
}
