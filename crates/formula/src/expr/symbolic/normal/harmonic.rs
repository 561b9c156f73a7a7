//! Functions of time taken apart into constants and harmonics.

use super::term::{Atom, Monomial, Polynomial};
use super::{Normal, SymbolicError};
use crate::expr::{Function, Name, Variable};
use vibank_dynamics::numerics::{Rational, SortedSet};

/// A term `factor * cos(frequency*t + phase)` or the same with a sine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Harmonic {
    /// Whether it is a sine.
    pub is_sine: bool,
    /// What stands before it.
    pub factor: Normal,
    /// What stands before the time.
    pub frequency: Normal,
    /// What is added in its angle.
    pub phase: Normal,
}

pub(crate) fn apart(
    function: &Normal,
    time: &Name,
) -> Result<Option<(Normal, Vec<Harmonic>)>, SymbolicError> {
    let (moving, constant) = function.split_by(&SortedSet::from([time.clone()]));
    let mut harmonics: Vec<Harmonic> = Vec::new();
    for (monomial, coefficient) in &moving.0.0 {
        let Some(harmonic) = harmonic(monomial, *coefficient, time) else {
            return Ok(None);
        };
        let same = harmonics.iter_mut().find(|own| own.is_alike(&harmonic));
        match same {
            Some(own) => own.factor = own.factor.plus(&harmonic.factor)?,
            None => harmonics.push(harmonic),
        }
    }
    Ok(Some((constant, harmonics)))
}

impl Harmonic {
    fn is_alike(&self, other: &Self) -> bool {
        self.is_sine == other.is_sine
            && self.frequency == other.frequency
            && self.phase == other.phase
    }
}

/// A term as a harmonic, if its only factor with time is a sine or cosine of an angle linear in time.
fn harmonic(monomial: &Monomial, coefficient: Rational, time: &Name) -> Option<Harmonic> {
    let names = SortedSet::from([time.clone()]);
    let mut with_time = monomial.0.iter().filter(|(atom, _)| atom.mentions(&names));
    let (atom, exponent) = with_time.next()?;
    let is_only = with_time.next().is_none() && *exponent == Rational::ONE;
    let Atom::Call(function @ (Function::Sin | Function::Cos), arguments) = atom else {
        return None;
    };
    let angle = Normal((**arguments.first()?).clone());
    let (frequency, phase) = angle.linear_in(&Variable::of(time, 0))?;
    let is_linear = !frequency.mentions(time) && !phase.mentions(time);
    (is_only && is_linear).then(|| Harmonic {
        is_sine: *function == Function::Sin,
        factor: Normal(Polynomial::term(monomial.without(atom), coefficient)),
        frequency,
        phase,
    })
}
