//! Puts the steps of a program together, each computation once.

use super::hash::NumberTable;
use super::instruction::{Instruction, ProgramStep, Register, RegisterPair, Target};
use super::{CompileError, EntryRegister};
use crate::expr::{Function, Precise};
use vibank_source::Span;

/// Most steps of a program.
const MAX_STEPS: usize = 200_000;

/// The steps so far, and what they have computed.
///
/// A computation that was already made is not made again, where it is certain to have been run: what was computed
/// between [`Assembler::open`] and [`Assembler::close`] is forgotten.
#[derive(Default)]
pub(crate) struct Assembler {
    pub(crate) code: Vec<Instruction>,
    pub(crate) spans: Vec<Span>,
    pub(crate) constants: Vec<Precise>,
    pub(crate) registers: u32,
    /// The indices of the constants, by their bits.
    indices: NumberTable<[u64; 3], u32>,
    known: NumberTable<ProgramStep, Register>,
    /// The known steps, in the order in which they became known.
    learned: Vec<ProgramStep>,
    /// Where the step at hand was written.
    span: Span,
}

/// A place in the list of known computations.
pub(crate) struct Scope(usize);

impl Assembler {
    /// Room for about this many steps; more are taken as they come.
    pub(crate) fn with_room(steps: usize) -> Self {
        Self {
            code: Vec::with_capacity(steps),
            spans: Vec::with_capacity(steps),
            known: NumberTable::with_capacity_and_hasher(steps, Default::default()),
            learned: Vec::with_capacity(steps),
            ..Self::default()
        }
    }

    /// Says where the steps that follow were written; what is derived keeps the place around it.
    pub(crate) fn place(&mut self, span: Span) -> Span {
        let before = self.span;
        if !span.is_none() {
            self.span = span;
        }
        before
    }

    pub(crate) fn return_to(&mut self, span: Span) {
        self.span = span;
    }

    /// Steps from here on may not be run.
    pub(crate) fn open(&mut self) -> Scope {
        Scope(self.learned.len())
    }

    pub(crate) fn close(&mut self, scope: Scope) {
        for step in self.learned.drain(scope.0..) {
            self.known.remove(&step);
        }
    }

    pub(crate) fn register(&mut self) -> Register {
        self.registers += 1;
        self.registers - 1
    }

    /// The register of a computation.
    pub(crate) fn compute(&mut self, step: ProgramStep) -> Result<Register, CompileError> {
        if let Some(&known) = self.known.get(&step) {
            return Ok(known);
        }
        let out = self.register();
        if step.width() == 2 {
            self.register();
        }
        self.push(step, out)?;
        self.known.insert(step, out);
        self.learned.push(step);
        Ok(out)
    }

    /// The two registers of a complex computation.
    pub(crate) fn compute_pair(
        &mut self,
        step: ProgramStep,
    ) -> Result<EntryRegister, CompileError> {
        let out = self.compute(step)?;
        Ok(EntryRegister::complex(out, out + 1))
    }

    /// Adds a step; its index.
    pub(crate) fn push(
        &mut self,
        step: ProgramStep,
        out: Register,
    ) -> Result<Target, CompileError> {
        if self.code.len() >= MAX_STEPS {
            return Err(CompileError::TooLarge);
        }
        self.code.push(Instruction { step, out });
        self.spans.push(self.span);
        Ok(self.code.len() as Target - 1)
    }

    /// The index of the next step.
    fn here(&self) -> Target {
        self.code.len() as Target
    }

    /// Lets the jump or search at `at` go on at the next step.
    pub(crate) fn land(&mut self, at: Target) {
        let here = self.here();
        match &mut self.code[at as usize].step {
            ProgramStep::Jump(target)
            | ProgramStep::JumpIf(_, target)
            | ProgramStep::JumpUnless(_, target) => {
                *target = here;
            }
            ProgramStep::Root(search) | ProgramStep::Integral(search) => search.end = here,
            _ => {}
        }
    }

    /// Says what the body of the search at `at` computes.
    pub(crate) fn set_value(&mut self, at: Target, value: Register) {
        if let ProgramStep::Root(search) | ProgramStep::Integral(search) =
            &mut self.code[at as usize].step
        {
            search.value = value;
        }
    }

    pub(crate) fn constant(&mut self, value: Precise) -> Result<Register, CompileError> {
        let bits = [value.high(), value.low(), value.rest()].map(f64::to_bits);
        let next = self.constants.len() as u32;
        let index = *self.indices.entry(bits).or_insert(next);
        if index == next {
            self.constants.push(value);
        }
        self.compute(ProgramStep::Constant(index))
    }

    pub(crate) fn exact(&mut self, value: f64) -> Result<Register, CompileError> {
        self.constant(Precise::exact(value))
    }

    pub(crate) fn unary(
        &mut self,
        function: Function,
        a: Register,
    ) -> Result<Register, CompileError> {
        self.compute(ProgramStep::Unary(function, a))
    }

    /// An entry as a pair of registers.
    pub(crate) fn pair(&mut self, entry: EntryRegister) -> Result<RegisterPair, CompileError> {
        Ok(match entry.imaginary {
            Some(imaginary) => [entry.real, imaginary],
            None => [entry.real, self.exact(0.0)?],
        })
    }
}
