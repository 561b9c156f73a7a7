//! The steps of a program.

use crate::expr::{Function, Relation};

/// A place for one number.
pub(crate) type Register = u32;

/// Real and imaginary part.
pub(crate) type RegisterPair = [Register; 2];

/// One step of a program; what it computes goes to the register `out`, a complex result to `out` and `out + 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Instruction {
    pub(crate) step: ProgramStep,
    pub(crate) out: Register,
}

/// What a step does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ProgramStep {
    /// Loads the value of a name, by its slot.
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
    Root(SearchBody),
    /// The integral of a body that follows at once; goes on after it.
    Integral(SearchBody),
}

/// The index of an instruction.
pub(crate) type Target = u32;

/// A body that is evaluated for many values of one register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct SearchBody {
    /// The ends of the interval.
    pub(crate) ends: RegisterPair,
    /// The bound name.
    pub(crate) variable: Register,
    /// What the body computes.
    pub(crate) value: Register,
    /// The end of the body.
    pub(crate) end: Target,
}

impl ProgramStep {
    /// The registers that it reads; not those that the body of a search reads.
    pub(crate) fn reads(&self) -> impl Iterator<Item = Register> {
        let (count, registers) = match *self {
            Self::Input(_) | Self::Constant(_) | Self::Jump(_) => (0, [0; 4]),
            Self::Copy(a)
            | Self::Negate(a)
            | Self::PowerWhole(a, _)
            | Self::Unary(_, a)
            | Self::Not(a)
            | Self::Motion(_, _, a)
            | Self::JumpUnless(a, _)
            | Self::JumpIf(a, _) => (1, [a, 0, 0, 0]),
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Power(a, b)
            | Self::Binary(_, a, b)
            | Self::Compare(_, a, b) => (2, [a, b, 0, 0]),
            Self::ComplexPowerWhole([a, b], _) | Self::ComplexUnary(_, [a, b]) => (2, [a, b, 0, 0]),
            Self::Root(SearchBody { ends: [a, b], .. })
            | Self::Integral(SearchBody { ends: [a, b], .. }) => (2, [a, b, 0, 0]),
            Self::ComplexMultiply([a, b], [c, d])
            | Self::ComplexDivide([a, b], [c, d])
            | Self::ComplexPower([a, b], [c, d]) => (4, [a, b, c, d]),
        };
        registers.into_iter().take(count)
    }

    /// How many registers it writes, from `out` on, if it is not a jump.
    pub(crate) fn width(&self) -> u32 {
        match self {
            Self::ComplexMultiply(..)
            | Self::ComplexDivide(..)
            | Self::ComplexPower(..)
            | Self::ComplexPowerWhole(..)
            | Self::ComplexUnary(..) => 2,
            _ => 1,
        }
    }

    /// Whether it only says where to go on.
    pub(crate) fn is_jump(&self) -> bool {
        matches!(
            self,
            Self::Jump(_) | Self::JumpUnless(..) | Self::JumpIf(..)
        )
    }
}
