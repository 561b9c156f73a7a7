//! Evaluation: in binary64, again in double-double where that leaves too much open, and with 256 bits where even that cannot
//! tell a result from zero.

use thiserror::Error;

use super::instruction::ProgramStep;
use super::machine::{Machine, weight};
use super::{Program, Value};
use crate::expr::{Approx, Field, Precise, Real, Scalar, Undefined};
use crate::work;
use vibank_dynamics::numerics::{Dd, Long};
use vibank_source::Span;

/// Most work of one run: what two integrals take that stand in each other, some tenths of a second.
const MAX_WORK: u64 = 20_000_000;

/// A result whose error may exceed this part of it is computed again with more digits.
// Twelve figures are then certain, which is more than any sheet prints.
const WIDEST: f64 = 1e-13;

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

impl<S: Scalar> Registers<S> {
    /// What is in them.
    pub(crate) fn all(&self) -> &[S] {
        &self.0
    }

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
    double: Registers<Approx<f64>>,
    wide: Registers<Approx<Dd>>,
    long: Registers<Approx<Long>>,
}

/// Inputs of thirty digits for a run with more.
struct Lengthened<'a, I: ?Sized>(&'a I);

impl<I: Inputs<Approx<Dd>> + ?Sized> Inputs<Approx<Long>> for Lengthened<'_, I> {
    fn input(&self, slot: u32) -> Result<Approx<Long>, Undefined> {
        let Approx { value, bound } = self.0.input(slot)?;
        let value = Long::from(value.hi()) + Long::from(value.lo());
        Ok(Approx::new(value, bound))
    }
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
    /// One number.
    pub(crate) fn of_one(number: &'a S, is_open: bool) -> Self {
        Self {
            registers: std::slice::from_ref(number),
            results: &[0],
            is_open,
        }
    }
}

impl Program {
    /// Runs the program once over one kind of number.
    ///
    /// # Errors
    ///
    /// The operation that has no value for these inputs.
    pub fn run<'a, S: Scalar>(
        &'a self,
        inputs: &(impl Inputs<S> + ?Sized),
        room: &'a mut Registers<S>,
    ) -> Result<Outcome<'a, S>, Absence> {
        let mut machine = Machine::new(self, &inputs, room.of(self));
        let length = self.code.len() as u32;
        let run = work::within(MAX_WORK, || {
            let run = machine.run(0, length);
            // The branches that are not taken cost nothing. What runs out in a search was found there.
            let steps = *run.as_ref().unwrap_or(&u64::from(length));
            let _ = work::spend(steps * weight::<S>());
            run
        });
        run.value?;
        let is_open = machine.doubt.is_open;
        Ok(self.outcome(room, is_open))
    }

    /// What a run has left in its registers.
    pub(crate) fn outcome<'a, S>(
        &'a self,
        room: &'a Registers<S>,
        is_open: bool,
    ) -> Outcome<'a, S> {
        Outcome {
            registers: &room.0,
            results: &self.results,
            is_open,
        }
    }

    /// The value for these inputs, rounded to binary64.
    ///
    /// Runs in binary64 first. If that leaves a decision open, or a result uncertain by more than 1e-13 of it, or has
    /// no value, the program runs again in double-double, and a third time with 256 bits if that does not leave a part
    /// in 1e13 of a result certain either. What cannot be told from zero even then is zero; its bound says how little is
    /// known of it.
    ///
    /// # Errors
    ///
    /// The operation that has no value for these inputs, or a result that is infinite.
    pub fn evaluate<I>(&self, inputs: &I, room: &mut Workspace) -> Result<Value, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        let first = match self.run(inputs, &mut room.double) {
            Ok(outcome) => {
                let value = self.value(outcome.numbers().map(|x| (x.value, x.bound)));
                if is_settled(&outcome) {
                    return value;
                }
                value
            }
            Err(absence) => Err(absence),
        };
        let second = match self.run(inputs, &mut room.wide) {
            Ok(outcome) => {
                let value = self.value(outcome.numbers().map(rounded));
                if outcome.numbers().all(is_certain) {
                    return value;
                }
                value
            }
            Err(absence) if absence.reason == Undefined::TooLong => return first,
            // A divisor that thirty digits do not tell from zero may be told by more; what else has no value
            // has none.
            Err(absence) if absence.reason != Undefined::DivisionByZero => return Err(absence),
            Err(absence) => Err(absence),
        };
        if !self.is_explicit() {
            return second;
        }
        match self.run(&Lengthened(inputs), &mut room.long) {
            Ok(outcome) => self.value(outcome.numbers().map(rounded)),
            Err(_) => second,
        }
    }

    /// Whether it computes numbers, step by step: searches and motions are as good as their methods, which more digits do not
    /// change.
    fn is_explicit(&self) -> bool {
        let is_step = |step: &ProgramStep| {
            !matches!(
                step,
                ProgramStep::Root(_) | ProgramStep::Integral(_) | ProgramStep::Motion(..)
            )
        };
        self.form.field != Field::Boolean
            && self
                .code
                .iter()
                .all(|instruction| is_step(&instruction.step))
            && self
                .constants
                .iter()
                .all(|constant| constant.high().is_finite())
    }

    /// The real number (or truth) that the program computes, as [`Self::evaluate`] does with at most thirty digits, without
    /// allocation.
    ///
    /// # Errors
    ///
    /// As [`Self::evaluate`]; a program that computes anything but one real number or truth is
    /// [`Undefined::NotReal`].
    pub fn evaluate_real<I>(&self, inputs: &I, room: &mut Workspace) -> Result<f64, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        self.evaluate_within(0.0, inputs, room)
    }

    /// The same where an error of `accuracy` is good enough, in SI units: near a zero of a function, more digits than
    /// its size asks for cost ten times as long.
    ///
    /// # Errors
    ///
    /// Those of [`Self::evaluate_real`].
    pub fn evaluate_within<I>(
        &self,
        accuracy: f64,
        inputs: &I,
        room: &mut Workspace,
    ) -> Result<f64, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        let double = self.run(inputs, &mut room.double);
        self.real(accuracy, double, || self.run(inputs, &mut room.wide))
    }

    /// The number that a run in binary64 gave, or where that is not good enough, one in double-double.
    pub(crate) fn real<'w>(
        &self,
        accuracy: f64,
        double: Result<Outcome<'_, Approx<f64>>, Absence>,
        wide: impl FnOnce() -> Result<Outcome<'w, Approx<Dd>>, Absence>,
    ) -> Result<f64, Absence> {
        if self.form.width() != 1 {
            let (reason, span) = (Undefined::NotReal, self.span());
            return Err(Absence { reason, span });
        }
        let first = match double {
            Ok(outcome) => {
                let number = self.single(outcome.numbers().map(|x| (x.value, x.bound)));
                let is_near = |(_, bound): (f64, f64)| !outcome.is_open && bound <= accuracy;
                if is_settled(&outcome) || number.as_ref().is_ok_and(|own| is_near(*own)) {
                    return Ok(number?.0);
                }
                number
            }
            Err(absence) => Err(absence),
        };
        let number = match wide() {
            Ok(outcome) => self.single(outcome.numbers().map(rounded)),
            Err(absence) if absence.reason == Undefined::TooLong => first,
            Err(absence) => Err(absence),
        };
        Ok(number?.0)
    }

    /// A finite number with its bound.
    fn single(&self, mut numbers: impl Iterator<Item = (f64, f64)>) -> Result<(f64, f64), Absence> {
        let number = numbers.next().filter(|(number, _)| number.is_finite());
        number.ok_or_else(|| Absence {
            reason: Undefined::Overflow,
            span: self.span(),
        })
    }

    /// A value of finite numbers.
    fn value(
        &self,
        mut numbers: impl ExactSizeIterator<Item = (f64, f64)>,
    ) -> Result<Value, Absence> {
        let value = if numbers.len() == 1 {
            let one = numbers.next();
            one.and_then(|(number, bound)| Value::of_one(self.form, number, bound))
        } else {
            let (numbers, bounds) = numbers.unzip();
            Value::new(self.form, numbers, bounds)
        };
        let is_finite = |value: &Value| value.numbers().iter().all(|number| number.is_finite());
        value.filter(is_finite).ok_or_else(|| Absence {
            reason: Undefined::Overflow,
            span: self.span(),
        })
    }

    /// Where the whole formula was written.
    fn span(&self) -> Span {
        self.spans.last().copied().unwrap_or(Span::NONE)
    }
}

/// Whether more digits would change nothing that matters.
fn is_settled(outcome: &Outcome<'_, Approx<f64>>) -> bool {
    !outcome.is_open && outcome.numbers().all(is_certain)
}

/// Whether the error of a result is a small part of it.
fn is_certain<T: Real>(x: &Approx<T>) -> bool {
    x.bound <= WIDEST * x.value.to_f64().abs()
}

/// A result with more digits in binary64, with its bound.
fn rounded<T: Real>(x: &Approx<T>) -> (f64, f64) {
    let (high, low) = (x.value.to_f64(), x.value.low());
    if high.abs() <= x.bound {
        return (0.0, x.bound + high.abs());
    }
    (high, x.bound + low.abs())
}

#[cfg(test)]
mod tests;
