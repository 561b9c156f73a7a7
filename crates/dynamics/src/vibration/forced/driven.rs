//! What a force drives: an oscillator, or a mode of several degrees of freedom.

use super::divided_difference::Nodes;
use super::frequency_response::FrequencyResponse;
use super::undamped::Beat;
use crate::numerics::Dd;
use crate::vibration::free::FreeResponse;
use crate::vibration::oscillator::{Oscillator, Scaled};
use crate::vibration::state::State;

/// An oscillator whose numbers are binary64, or a mode of unit mass whose damping and stiffness have thirty digits.
#[derive(Clone, Copy)]
pub(crate) struct DrivenSystem<'a> {
    /// The oscillator, or the mode with rounded numbers.
    pub(crate) oscillator: &'a Oscillator,
    /// Damping and stiffness of a mode.
    pub(crate) mode: Option<(Dd, Dd)>,
}

impl DrivenSystem<'_> {
    pub(crate) fn free(&self, initial: State) -> FreeResponse {
        match self.mode {
            None => FreeResponse::of(self.oscillator, initial),
            Some((damping, stiffness)) => FreeResponse::of_mode(damping, stiffness, initial),
        }
    }

    /// The motion from rest without damping, in scaled units.
    pub(crate) fn beat(&self, scaled: &Scaled, frequency: f64) -> Beat {
        match self.in_units_of(scaled) {
            None => Beat::of(scaled, frequency),
            Some((_, stiffness)) => Beat::of_mode(stiffness, frequency),
        }
    }

    /// The nodes of the motion from rest, in scaled units.
    pub(crate) fn nodes(&self, scaled: &Scaled, frequency: f64) -> Nodes {
        match self.in_units_of(scaled) {
            None => Nodes::of(scaled, frequency),
            Some((damping, stiffness)) => Nodes::of_mode(damping, stiffness, frequency),
        }
    }

    pub(crate) fn steady(&self, angular_frequency: f64) -> FrequencyResponse {
        let response = FrequencyResponse::at(self.oscillator, angular_frequency);
        let scaled = Scaled::driven(self.oscillator, angular_frequency);
        match self.in_units_of(&scaled) {
            None => response,
            Some((damping, stiffness)) => response.of_mode(damping, stiffness),
        }
    }

    /// Damping and stiffness of a mode, whose mass is the unit.
    fn in_units_of(&self, scaled: &Scaled) -> Option<(Dd, Dd)> {
        self.mode.map(|(damping, stiffness)| {
            (
                damping.scale(-scaled.rate_exponent),
                stiffness.scale(-2 * scaled.rate_exponent),
            )
        })
    }
}
