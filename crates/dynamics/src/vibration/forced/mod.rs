//! Forced response: an oscillator under harmonic and periodic forces.
//!
//! [`FrequencyResponse`] is the steady state at one angular frequency: amplitude, lag, power, transmissibility, impedance.
//! [`ForcedResponse`] is the whole motion from an initial state, accurate before, at and far from resonance.
//! [`PeriodicResponse`] adds up the steady states of a Fourier series.

mod divided_difference;
mod driven;
mod frequency_response;
mod periodic;
mod response;
mod undamped;

pub use frequency_response::FrequencyResponse;
pub use periodic::{Harmonic, PeriodicForce, PeriodicResponse};
pub use response::{ForcedResponse, HarmonicForce};
