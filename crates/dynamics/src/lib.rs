//! Vibrations in closed form: oscillators, dry friction, pendulums, modes, and the portable numerics below them.
//!
//! What the textbooks name is computed from numbers to numbers, without time stepping: free, forced and
//! friction-damped response, resonance, identification from measurements, modes of several degrees of freedom and
//! motion by superposition of modes. Formulas are arranged so that no small difference is lost, near critical damping,
//! at resonance or after many periods, and give the same bits on every platform. Units are those of SI.
//!
//! One degree of freedom, here 2 kg on a spring of 50 N/m with a dashpot of 3 N·s/m, released 10 cm from equilibrium:
//!
//! ```
//! use vibank_dynamics::{FreeResponse, Oscillator, Regime, State};
//!
//! let oscillator = Oscillator::new(2.0, 3.0, 50.0)?;
//! assert_eq!(oscillator.regime(), Regime::Underdamped);
//! assert_eq!(oscillator.natural_angular_frequency(), 5.0);
//!
//! let released = State { position: 0.1, velocity: 0.0 };
//! let motion = FreeResponse::of(&oscillator, released);
//! let one_period = std::f64::consts::TAU / oscillator.damped_angular_frequency().unwrap();
//! let decay = (-oscillator.decay_rate() * one_period).exp();
//! assert!((motion.position(one_period) - 0.1 * decay).abs() < 1e-15);
//! # Ok::<(), vibank_dynamics::OscillatorError>(())
//! ```
//!
//! Several degrees of freedom, as masses and springs, as energies or as matrices of `nalgebra`:
//!
//! ```
//! use vibank_dynamics::modes::{Link, Modes};
//!
//! let springs = [Link::to_ground(1, 100.0), Link::between(1, 2, 62.5), Link::to_ground(2, 100.0)];
//! let modes = Modes::of_network(&[1.0, 1.0], &springs)?;
//! assert_eq!(modes.natural_angular_frequency(0), Some(10.0));
//! assert_eq!(modes.natural_angular_frequency(1), Some(15.0));
//! # Ok::<(), vibank_dynamics::modes::ModesError>(())
//! ```
//!
//! - [`vibration`] has all of it, one type a subject; the names at the root are the usual ones.
//! - [`numerics`] has what is below: elementary functions, double-double numbers, exact fractions, elliptic integrals,
//!   roots, quadrature.

pub mod numerics;
pub mod vibration;

pub use vibration::{
    DisplacementResonance, ForcedResponse, FreeResponse, FrequencyResponse, FrictionOscillator,
    HarmonicForce, LogarithmicDecrement, Oscillator, OscillatorError, Pendulum, PeriodicForce,
    PeriodicResponse, Regime, State, VelocityResonance, modal, modes,
};
