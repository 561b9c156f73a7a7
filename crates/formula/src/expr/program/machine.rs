//! Runs the steps of a program.

use super::arithmetic::{self, truth};
use super::instruction::{Instruction, ProgramStep, Register, RegisterPair, SearchBody};
use super::integral::integral;
use super::search::{self, root};
use super::{Absence, Inputs, Program};
use crate::expr::number::complex::{self, ComplexPair};
use crate::expr::{Doubt, Scalar, Undefined};
use crate::work;

/// Units of work of a step in double-double, where one in binary64 is one: a sine costs a microsecond.
const WIDE_STEP: u64 = 20;

/// The same with 256 bits: a sine takes some ten microseconds.
const LONG_STEP: u64 = 400;

/// Steps that finding the next place of a search counts for: the nodes of an integral take two exponentials.
const STEPS_OF_A_PLACE: u64 = 4;

/// Units of work of a step.
pub(crate) fn weight<S: Scalar>() -> u64 {
    match S::ROUNDOFF {
        roundoff if roundoff < 1e-40 => LONG_STEP,
        roundoff if roundoff < 1e-20 => WIDE_STEP,
        _ => 1,
    }
}

/// The state of a run.
///
/// The inputs are behind a pointer, so that the interpreter is compiled once for each kind of number and not once more
/// for each source of inputs: the grader of the page would carry nine of them.
pub(crate) struct Machine<'a, S> {
    program: &'a Program,
    inputs: &'a dyn Inputs<S>,
    registers: &'a mut [S],
    pub(crate) doubt: Doubt,
}

impl<'a, S: Scalar> Machine<'a, S> {
    pub(crate) fn new(
        program: &'a Program,
        inputs: &'a dyn Inputs<S>,
        registers: &'a mut [S],
    ) -> Self {
        Self {
            program,
            inputs,
            registers,
            doubt: Doubt::default(),
        }
    }

    /// Runs the steps from `at` up to `end`; how many were taken, without those within searches.
    pub(crate) fn run(&mut self, at: u32, end: u32) -> Result<u64, Absence> {
        let code = &self.program.code;
        let mut at = at as usize;
        let mut steps = 0;
        while at < end as usize {
            steps += 1;
            let Instruction { step, out } = code[at];
            match self.step(&step, out, at) {
                Ok(None) => at += 1,
                Ok(Some(target)) => at = target as usize,
                Err(stop) => return Err(self.absence(stop, at)),
            }
        }
        Ok(steps)
    }

    /// Takes the step at a place; where to go on.
    pub(crate) fn take(&mut self, at: u32) -> Result<u32, Absence> {
        let Instruction { step, out } = self.program.code[at as usize];
        match self.step(&step, out, at as usize) {
            Ok(target) => Ok(target.unwrap_or(at + 1)),
            Err(stop) => Err(self.absence(stop, at as usize)),
        }
    }

    /// Takes steps of a run anew that go on at their next ones.
    pub(crate) fn repeat(&mut self, steps: &[u32]) -> Result<(), Absence> {
        steps.iter().try_for_each(|at| self.take(*at).map(drop))
    }

    #[cold]
    fn absence(&self, stop: Stop, at: usize) -> Absence {
        match stop {
            Stop::Here(reason) => Absence {
                reason,
                span: self.program.spans[at],
            },
            Stop::Inside(absence) => absence,
        }
    }

    /// Takes one step; where to go on, if not at the next one.
    #[inline]
    fn step(&mut self, step: &ProgramStep, out: Register, at: usize) -> Result<Option<u32>, Stop> {
        let value = match *step {
            ProgramStep::Input(slot) => self.inputs.input(slot)?,
            ProgramStep::Constant(index) => S::of(&self.program.constants[index as usize]),
            ProgramStep::Copy(a) => self.get(a).clone(),
            ProgramStep::Add(a, b) => arithmetic::add(self.get(a), self.get(b))?,
            ProgramStep::Subtract(a, b) => arithmetic::subtract(self.get(a), self.get(b))?,
            ProgramStep::Multiply(a, b) => arithmetic::multiply(self.get(a), self.get(b))?,
            ProgramStep::Divide(a, b) => arithmetic::divide(self.get(a), self.get(b))?,
            ProgramStep::Negate(a) => self.get(a).negate(),
            ProgramStep::Power(a, b) => {
                let (a, b) = (&self.registers[a as usize], &self.registers[b as usize]);
                arithmetic::power(a, b, &mut self.doubt)?
            }
            ProgramStep::PowerWhole(a, exponent) => arithmetic::power_whole(self.get(a), exponent)?,
            ProgramStep::Unary(function, a) => {
                arithmetic::unary(function, &self.registers[a as usize], &mut self.doubt)?
            }
            ProgramStep::Binary(function, a, b) => {
                let (a, b) = (&self.registers[a as usize], &self.registers[b as usize]);
                arithmetic::binary(function, a, b, &mut self.doubt)?
            }
            ProgramStep::Compare(relation, a, b) => {
                let (a, b) = (&self.registers[a as usize], &self.registers[b as usize]);
                arithmetic::compare(relation, a, b, &mut self.doubt)
            }
            ProgramStep::Not(a) => truth(!self.holds(a)),
            ProgramStep::Motion(index, order, time) => {
                self.inputs.motion(index, order, self.get(time))?
            }
            ProgramStep::Jump(target) => return Ok(Some(target)),
            ProgramStep::JumpUnless(a, target) => return Ok((!self.holds(a)).then_some(target)),
            ProgramStep::JumpIf(a, target) => return Ok(self.holds(a).then_some(target)),
            ProgramStep::Root(_) | ProgramStep::Integral(_) if !S::SEARCHES => {
                return Err(Undefined::TooLong.into());
            }
            ProgramStep::Root(search) => {
                let value = root(&mut self.body(search, at)?)?;
                self.set(out, value);
                return Ok(Some(search.end));
            }
            ProgramStep::Integral(search) => {
                let value = integral(&mut self.body(search, at)?)?;
                self.set(out, value);
                return Ok(Some(search.end));
            }
            ProgramStep::ComplexMultiply(..)
            | ProgramStep::ComplexDivide(..)
            | ProgramStep::ComplexPower(..)
            | ProgramStep::ComplexPowerWhole(..)
            | ProgramStep::ComplexUnary(..) => {
                let (real, imaginary) = self.complex(step)?;
                self.set(out + 1, imaginary);
                real
            }
        };
        self.set(out, value);
        Ok(None)
    }

    fn complex(&mut self, step: &ProgramStep) -> Result<ComplexPair<S>, Stop> {
        let value = match *step {
            ProgramStep::ComplexMultiply(a, b) => complex::multiply(&self.pair(a), &self.pair(b)),
            ProgramStep::ComplexDivide(a, b) => complex::divide(&self.pair(a), &self.pair(b))?,
            ProgramStep::ComplexPower(a, b) => {
                complex::power(&self.pair(a), &self.pair(b), &mut self.doubt)?
            }
            ProgramStep::ComplexPowerWhole(a, exponent) => {
                complex::power_whole(&self.pair(a), exponent)?
            }
            ProgramStep::ComplexUnary(function, a) => {
                complex::unary(function, &self.pair(a), &mut self.doubt)?
            }
            _ => unreachable!("the other steps are real"),
        };
        let parts = [&value.0, &value.1];
        if parts.iter().any(|part| !part.to_f64().is_finite()) {
            return Err(Stop::Here(Undefined::Overflow));
        }
        if parts.iter().any(|part| !part.bound().is_finite()) {
            return Err(Stop::Here(Undefined::Uncertain));
        }
        Ok(value)
    }

    #[inline]
    fn get(&self, register: Register) -> &S {
        &self.registers[register as usize]
    }

    #[inline]
    fn set(&mut self, register: Register, value: S) {
        self.registers[register as usize] = value;
    }

    fn pair(&self, [real, imaginary]: RegisterPair) -> ComplexPair<S> {
        (self.get(real).clone(), self.get(imaginary).clone())
    }

    #[inline]
    fn holds(&self, register: Register) -> bool {
        self.get(register).to_f64() != 0.0
    }

    /// The body of a search, with its interval.
    fn body<'b>(
        &'b mut self,
        search: SearchBody,
        at: usize,
    ) -> Result<SearchedBody<'b, 'a, S>, Stop> {
        let [low, high] = search.ends;
        let ends = [self.get(low).clone(), self.get(high).clone()];
        if ends.iter().any(|end| !end.to_f64().is_finite()) {
            return Err(Stop::Here(Undefined::Overflow));
        }
        Ok(SearchedBody {
            machine: self,
            search,
            start: at as u32 + 1,
            ends,
        })
    }
}

/// The body of a search as a function of the bound name.
struct SearchedBody<'b, 'a, S> {
    machine: &'b mut Machine<'a, S>,
    search: SearchBody,
    start: u32,
    ends: [S; 2],
}

impl<S: Scalar> search::SearchedFunction<S> for SearchedBody<'_, '_, S> {
    fn ends(&self) -> [S; 2] {
        self.ends.clone()
    }

    fn value(&mut self, x: &S) -> Result<S, Stop> {
        let steps = u64::from(self.search.end - self.start) + STEPS_OF_A_PLACE;
        work::spend(steps * weight::<S>()).map_err(|_| Stop::Here(Undefined::TooLong))?;
        self.machine.set(self.search.variable, x.clone());
        self.machine
            .run(self.start, self.search.end)
            .map_err(Stop::Inside)?;
        Ok(self.machine.get(self.search.value).clone())
    }
}

/// Why a run stops.
pub(crate) enum Stop {
    /// The step at hand has no value.
    Here(Undefined),
    /// A step of the body of a search has none.
    Inside(Absence),
}

impl From<Undefined> for Stop {
    #[inline]
    fn from(reason: Undefined) -> Self {
        Self::Here(reason)
    }
}
