//! The excitation of a model, as harmonics.

use super::equilibrium::Balance;
use super::programs::Compiled;
use crate::expr::{Name, SymbolicError};

/// All harmonics that excite a model: which equation each acts on, and its numbers.
#[derive(Clone, Debug)]
pub(crate) struct Excitation {
    pub(crate) terms: Vec<HarmonicTerm>,
    /// Factor, angular frequency and phase of each term, one after the other.
    pub(crate) numbers: Compiled,
}

/// One harmonic on the right side of one equation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HarmonicTerm {
    pub(crate) equation: usize,
    pub(crate) is_sine: bool,
}

impl Excitation {
    /// The terms of the balance that depend on time; nothing if one is no harmonic.
    pub(crate) fn of(balance: &Balance) -> Result<Option<Self>, SymbolicError> {
        let (mut terms, mut numbers) = (Vec::new(), Vec::new());
        for (equation, excitation) in balance.excitation.iter().enumerate() {
            let Some((_, harmonics)) = excitation.negated().harmonics(&Name::new("t"))? else {
                return Ok(None);
            };
            for harmonic in harmonics {
                terms.push(HarmonicTerm {
                    equation,
                    is_sine: harmonic.is_sine,
                });
                numbers.extend([harmonic.factor, harmonic.frequency, harmonic.phase]);
            }
        }
        Ok(Some(Self {
            terms,
            numbers: Compiled::sums(numbers),
        }))
    }
}
