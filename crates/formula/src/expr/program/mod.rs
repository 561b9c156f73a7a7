//! Formulas as flat programs: compiled once, run for many data.
//!
//! A program is a list of steps over numbered registers, with jumps for `if`, `and` and `or`; vectors, matrices and
//! complex numbers are taken apart when it is compiled, derivatives are formed, names are inputs or put in as
//! formulas. A computation that occurs twice is made once. It runs over any [`Scalar`]: in binary64, again in
//! double-double where that leaves too much open, and with 256 bits where even that cannot tell a result from zero.

mod arithmetic;
mod array;
mod assembler;
mod binder;
mod compile;
mod derive;
mod entry;
mod error;
mod hash;
mod instruction;
mod integral;
mod lanes;
mod machine;
#[cfg(test)]
mod references;
mod run;
mod search;
mod sweep;
#[cfg(test)]
mod tests;
mod value;

pub use binder::{Binder, Binding, Slots};
pub use error::CompileError;
pub use run::{Absence, Inputs, Outcome, Registers, Workspace};
pub use sweep::Sweep;
pub use value::Value;

use self::entry::EntryRegister;
use self::instruction::{Instruction, ProgramStep, Register};
use self::machine::{Machine, weight};
use super::{Approx, Expr, Field, Form, Precise, Real, Scalar, Undefined};
use crate::unit::{Decimal, Quantity, Unit};
use crate::work;
use vibank_dynamics::numerics::{Dd, Long, Rational};
use vibank_source::Span;

/// Most work of one run: what two integrals take that stand in each other, some tenths of a second.
const MAX_WORK: u64 = 20_000_000;

/// A result whose error may exceed this part of it is computed again with more digits.
// Twelve figures are then certain, which is more than any sheet prints.
const WIDEST: f64 = 1e-13;

/// A formula that can be run.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Expr, Slots, Precise, Program, Workspace};
/// use vibank_dynamics::numerics::Rational;
///
/// let formula = Expr::read("if k >= 4*m then sqrt(k/m) else 0")?;
/// let program = Program::compile(&formula, &Slots(&["k", "m"]))?;
/// let data = [Precise::exact(0.4), Precise::from(Rational::from_decimal("0.1").unwrap())];
/// let value = program.evaluate(&data[..], &mut Workspace::default())?;
/// assert_eq!(value.as_real(), Some(2.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Program {
    code: Vec<Instruction>,
    /// Where each step was written.
    spans: Vec<Span>,
    constants: Vec<Precise>,
    registers: u32,
    form: Form,
    results: Vec<Register>,
}

impl Program {
    /// Translates a formula whose names `binder` explains.
    ///
    /// # Errors
    ///
    /// [`CompileError::UnknownName`] and [`CompileError::UnknownPath`] for what is bound to nothing,
    /// [`CompileError::Form`] where forms do not fit (a formula that was checked has none of these), and
    /// [`CompileError::Symbolic`], [`CompileError::TooLarge`], [`CompileError::TooDeep`] for derivatives and bounds.
    pub fn compile(expr: &Expr, binder: &dyn Binder) -> Result<Self, CompileError> {
        compile::compile(expr, binder)
    }

    /// Field and shape of what it computes.
    pub fn form(&self) -> Form {
        self.form
    }

    /// The slots of the inputs that a run may ask for, in ascending order.
    pub fn slots(&self) -> Vec<u32> {
        let mut slots: Vec<u32> = self.code.iter().filter_map(slot).collect();
        vibank_dynamics::numerics::sort_by(&mut slots, Ord::cmp);
        slots.dedup();
        slots
    }

    /// The numbers of the functions of time that a run may ask for, in ascending order.
    pub fn motions(&self) -> Vec<u32> {
        let mut motions: Vec<u32> = self.code.iter().filter_map(motion).collect();
        vibank_dynamics::numerics::sort_by(&mut motions, Ord::cmp);
        motions.dedup();
        motions
    }

    /// The program for runs between which only the inputs in these slots change.
    pub fn sweep(&self, varied: Vec<u32>) -> Sweep<'_> {
        Sweep::new(self, varied)
    }

    /// The number of its steps.
    pub fn len(&self) -> usize {
        self.code.len()
    }

    /// Whether it has no step, as that of a bound name would; never for a formula that was read.
    pub fn is_empty(&self) -> bool {
        self.code.is_empty()
    }

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
        Outcome::new(room.all(), &self.results, is_open)
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
            // A divisor that thirty digits do not distinguish from zero may be distinguished by more; what else has no value
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
        self.form.field != Field::Boolean
            && self.code.iter().all(|instruction| {
                !matches!(
                    instruction.step,
                    ProgramStep::Root(_) | ProgramStep::Integral(_) | ProgramStep::Motion(..)
                )
            })
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
        value
            .filter(|value| value.numbers().iter().all(|number| number.is_finite()))
            .ok_or_else(|| Absence {
                reason: Undefined::Overflow,
                span: self.span(),
            })
    }

    /// Where the whole formula was written.
    fn span(&self) -> Span {
        self.spans.last().copied().unwrap_or(Span::NONE)
    }
}

/// The motion that an instruction takes.
fn motion(instruction: &Instruction) -> Option<u32> {
    match instruction.step {
        ProgramStep::Motion(index, ..) => Some(index),
        _ => None,
    }
}

/// The input that an instruction takes.
fn slot(instruction: &Instruction) -> Option<u32> {
    match instruction.step {
        ProgramStep::Input(slot) => Some(slot),
        _ => None,
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

/// Inputs of thirty digits for a run with more.
struct Lengthened<'a, I: ?Sized>(&'a I);

impl<I: Inputs<Approx<Dd>> + ?Sized> Inputs<Approx<Long>> for Lengthened<'_, I> {
    fn input(&self, slot: u32) -> Result<Approx<Long>, Undefined> {
        let Approx { value, bound } = self.0.input(slot)?;
        let value = Long::from(value.hi()) + Long::from(value.lo());
        Ok(Approx::new(value, bound))
    }
}

/// A number with a unit in SI units.
fn measure(value: Rational, unit: &Unit) -> Precise {
    let (high, low) = Quantity::new(Decimal::from(1_u32), *unit).si_pair();
    if (high, low) == (1.0, 0.0) {
        return Precise::from(value);
    }
    let (number_high, number_low) = value.to_pair();
    let product = Dd::sum(high, low) * Dd::sum(number_high, number_low);
    Precise::of_dd(product, 1e-31 * product.hi().abs())
}
