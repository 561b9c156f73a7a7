//! What a run of a program takes and gives.

use thiserror::Error;

use super::Program;
use crate::expr::{Approx, Precise, Scalar, Undefined};
use vibank_dynamics::numerics::{Dd, Long};
use vibank_source::Span;

/// Gives a program its inputs, each when it is asked for.
pub trait Inputs<S> {
    /// The number in a slot.
    ///
    /// # Errors
    ///
    /// Usually [`Undefined::Missing`], where it has no value.
    fn input(&self, slot: u32) -> Result<S, Undefined>;

    /// A derivative (0 for the value) of a function of time that is computed elsewhere.
    ///
    /// # Errors
    ///
    /// Why it has no value at this time.
    fn motion(&self, index: u32, order: u8, time: &S) -> Result<S, Undefined> {
        let _ = (order, time);
        Err(Undefined::Missing { slot: index })
    }
}

/// Inputs that are known as such, one per slot.
impl<S: Scalar> Inputs<S> for [Precise] {
    #[inline]
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        self.get(slot as usize)
            .map(S::of)
            .ok_or(Undefined::Missing { slot })
    }
}

/// What is behind a reference, which can stand for it where a size is needed.
impl<S, I: Inputs<S> + ?Sized> Inputs<S> for &I {
    #[inline]
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        (**self).input(slot)
    }

    #[inline]
    fn motion(&self, index: u32, order: u8, time: &S) -> Result<S, Undefined> {
        (**self).motion(index, order, time)
    }
}

impl<S: Scalar, const N: usize> Inputs<S> for [Precise; N] {
    #[inline]
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        self.as_slice().input(slot)
    }
}

/// Why a formula has no value for these data, and the operation that has none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{reason}")]
pub struct Absence {
    /// What has no value, or is not a number.
    pub reason: Undefined,
    /// Where the operation stands in its formula.
    pub span: Span,
}

/// Room for a run, kept from one to the next.
#[derive(Clone, Debug)]
pub struct Registers<S>(Vec<S>);

impl<S> Default for Registers<S> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<S> Registers<S> {
    /// What is in them.
    pub(crate) fn all(&self) -> &[S] {
        &self.0
    }
}

impl<S: Scalar> Registers<S> {
    /// Those of a program.
    pub(crate) fn of(&mut self, program: &Program) -> &mut [S] {
        let size = program.registers as usize;
        // Never shorter: what a longer program left behind is written before it is read.
        if self.0.len() < size {
            self.0.resize(size, S::exact(0.0));
        }
        &mut self.0
    }
}

/// Room for evaluations, kept from one to the next so that nothing is allocated.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    pub(crate) double: Registers<Approx<f64>>,
    pub(crate) wide: Registers<Approx<Dd>>,
    pub(crate) long: Registers<Approx<Long>>,
}

/// What a run gave.
#[derive(Clone, Debug)]
pub struct Outcome<'a, S> {
    registers: &'a [S],
    results: &'a [u32],
    /// Whether a decision (a comparison, a rounding) was taken that more digits could change.
    pub is_open: bool,
}

impl<'a, S> Outcome<'a, S> {
    /// The entries by rows; of complex entries real and imaginary part.
    pub fn numbers(&self) -> impl ExactSizeIterator<Item = &'a S> + use<'a, S> {
        let registers = self.registers;
        self.results
            .iter()
            .map(move |register| &registers[*register as usize])
    }
}

impl<'a, S> Outcome<'a, S> {
    pub(crate) fn new(registers: &'a [S], results: &'a [u32], is_open: bool) -> Self {
        Self {
            registers,
            results,
            is_open,
        }
    }

    /// One number.
    pub(crate) fn of_one(number: &'a S, is_open: bool) -> Self {
        Self {
            registers: std::slice::from_ref(number),
            results: &[0],
            is_open,
        }
    }
}
