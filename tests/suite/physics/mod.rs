//! The physics against references of many digits, known results and conservation laws.

#![expect(clippy::unwrap_used, reason = "a test fails where a value is missing")]

mod accuracy;
mod bits;
mod friction;
mod linearisation;
mod modal;
mod modes;
mod oscillator;
mod oscillator_laws;
mod pendulum;
mod reference;
mod requests;

pub(crate) use reference::Accuracy;
