//! The steps of a program.

use crate::expr::{Function, Relation};

/// A place for one number.
pub(super) type Register = u32;

/// Real and imaginary part.
pub(super) type RegisterPair = [Register; 2];

/// One step of a program; what it computes goes to the register `out`, a complex result to `out` and `out + 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Instruction {
    pub(super) step: Step,
    pub(super) out: Register,
}

/// What a step does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Step {
    /// An input.
    Input(u32),
    /// A number of the formula.
    Constant(u32),
    Copy(Register),
    Add(Register, Register),
    Subtract(Register, Register),
    Multiply(Register, Register),
    Divide(Register, Register),
    Negate(Register),
    Power(Register, Register),
    PowerWhole(Register, i32),
    Unary(Function, Register),
    Binary(Function, Register, Register),
    Compare(Relation, Register, Register),
    Not(Register),
    ComplexMultiply(RegisterPair, RegisterPair),
    ComplexDivide(RegisterPair, RegisterPair),
    ComplexPower(RegisterPair, RegisterPair),
    ComplexPowerWhole(RegisterPair, i32),
    ComplexUnary(Function, RegisterPair),
    /// A function of time that is computed elsewhere: which, its derivative, and the time.
    Motion(u32, u8, Register),
    Jump(Target),
    /// Goes on at the target if the register holds falsehood.
    JumpUnless(Register, Target),
    /// Goes on at the target if the register holds truth.
    JumpIf(Register, Target),
    /// The zero of a body that follows at once; goes on after it.
    Root(Search),
    /// The integral of a body that follows at once; goes on after it.
    Integral(Search),
}

/// The index of an instruction.
pub(super) type Target = u32;

/// A body that is evaluated for many values of one register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Search {
    /// The ends of the interval.
    pub(super) ends: RegisterPair,
    /// The bound name.
    pub(super) variable: Register,
    /// What the body computes.
    pub(super) value: Register,
    /// The end of the body.
    pub(super) end: Target,
}
