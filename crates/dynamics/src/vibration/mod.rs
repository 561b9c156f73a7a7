//! What the textbooks on vibrations name, from numbers to numbers.
//!
//! Every closed form is written so that no small difference is lost: near critical damping, at resonance, for tiny and
//! for huge ratios of masses and stiffnesses, after any number of periods. A prepared system holds what does not depend
//! on time or frequency; samples from it allocate nothing and compute nothing that was not asked for.
//!
//! - [`Oscillator`]: mass, damping, stiffness; its [`Regime`], natural frequency, damping ratio.
//! - [`FreeResponse`]: motion from an initial [`State`].
//! - [`FrequencyResponse`], [`ForcedResponse`], [`PeriodicResponse`]: motion under a force.
//! - [`FrictionOscillator`]: dry friction, with and without viscous damping.
//! - [`Pendulum`]: period and motion at any amplitude.
//! - [`DisplacementResonance`], [`VelocityResonance`]: resonance, cut-offs, bandwidth.
//! - [`LogarithmicDecrement`], [`ResonanceCurve`]: from measurements back to the oscillator.
//! - [`modes`]: natural frequencies and shapes of several degrees of freedom; [`modal`]: their motion.
//!
//! Absent on purpose: time stepping. Linear motions, Coulomb friction and the pendulum have closed forms.

mod decrement;
mod forced;
mod free;
mod friction;
pub mod modal;
pub mod modes;
mod oscillator;
mod pendulum;
mod power_of_two;
mod resonance;
mod state;
mod tolerance;

pub use decrement::{IdentificationError, Identified, LogarithmicDecrement, ResonanceCurve};
pub use forced::{
    ForcedResponse, FrequencyResponse, Harmonic, HarmonicForce, PeriodicForce, PeriodicResponse,
};
pub use free::FreeResponse;
pub use friction::{
    DryFriction, FrictionError, FrictionMotion, FrictionOscillator, FrictionPath, TurningPoint,
};
pub use oscillator::{Oscillator, OscillatorError, Regime};
pub use pendulum::{Pendulum, PendulumError, PendulumMotion, PendulumRegime};
pub use resonance::{DisplacementResonance, VelocityResonance};
pub use state::State;
