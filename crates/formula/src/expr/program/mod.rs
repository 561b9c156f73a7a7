//! Formulas as flat programs: compiled once, run for many data.
//!
//! A program is a list of steps over numbered registers, with jumps for `if`, `and` and `or`; vectors, matrices and
//! complex numbers are taken apart when it is compiled, derivatives are formed, names are inputs or put in as
//! formulas. A computation that occurs twice is made once. It runs over any [`Scalar`](crate::expr::Scalar).

mod arithmetic;
mod array;
mod assembler;
mod binder;
mod compile;
mod derive;
mod entry;
mod error;
mod evaluate;
mod hash;
mod instruction;
mod integral;
mod lanes;
mod machine;
#[cfg(test)]
mod references;
mod search;
mod sweep;
mod value;

pub use binder::{Binder, Binding, Slots};
pub use error::CompileError;
pub use evaluate::{Absence, Inputs, Outcome, Registers, Workspace};
pub use sweep::Sweep;
pub use value::Value;

use self::entry::EntryRegister;
use self::instruction::{Instruction, ProgramStep, Register};
use super::{Expr, Form, Precise};
use crate::unit::{Decimal, Quantity, Unit};
use vibank_dynamics::numerics::{Dd, Rational};
use vibank_source::Span;

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
        let slot = |instruction: &Instruction| match instruction.step {
            ProgramStep::Input(slot) => Some(slot),
            _ => None,
        };
        let mut slots: Vec<u32> = self.code.iter().filter_map(slot).collect();
        vibank_dynamics::numerics::sort_by(&mut slots, Ord::cmp);
        slots.dedup();
        slots
    }

    /// The numbers of the functions of time that a run may ask for, in ascending order.
    pub fn motions(&self) -> Vec<u32> {
        let motion = |instruction: &Instruction| match instruction.step {
            ProgramStep::Motion(index, ..) => Some(index),
            _ => None,
        };
        let mut motions: Vec<u32> = self.code.iter().filter_map(motion).collect();
        vibank_dynamics::numerics::sort_by(&mut motions, Ord::cmp);
        motions.dedup();
        motions
    }

    /// The number of its steps.
    pub fn len(&self) -> usize {
        self.code.len()
    }

    /// Whether it has no step, as that of a bound name would; never for a formula that was read.
    pub fn is_empty(&self) -> bool {
        self.code.is_empty()
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
