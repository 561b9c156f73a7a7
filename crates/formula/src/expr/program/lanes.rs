//! Steps of a program at many places at once: each step is looked up once, and then taken at all places.

use super::arithmetic::{add, binary, compare, divide, multiply, power, power_whole, subtract};
use super::arithmetic::{truth, unary};
use super::instruction::{Instruction, ProgramStep, Register};
use super::{Inputs, Program};
use crate::expr::{Doubt, Scalar, Undefined};

/// What steps have computed at all places.
pub(crate) struct ProgramLanes<'a, S> {
    /// What is the same at all places.
    registers: &'a [S],
    /// By register, its column; none where it is the same at all places.
    columns: Vec<Option<Vec<S>>>,
    doubts: Vec<Doubt>,
}

/// What a step reads.
struct Operand<'a, S> {
    numbers: &'a [S],
    /// From one place to the next: 0 where the number is the same at all places, else 1.
    stride: usize,
}

impl<'a, S> Operand<'a, S> {
    #[inline]
    fn at(&self, place: usize) -> &'a S {
        &self.numbers[place * self.stride]
    }
}

impl<'a, S: Scalar> ProgramLanes<'a, S> {
    /// Takes these steps with each of these inputs; `None` where one has no value, or computes what is not a real number.
    pub(crate) fn run(
        program: &Program,
        steps: &[u32],
        registers: &'a [S],
        inputs: &[impl Inputs<S>],
        doubt: Doubt,
    ) -> Option<Self> {
        let mut lanes = Self {
            registers,
            columns: (0..program.registers).map(|_| None).collect(),
            doubts: vec![doubt; inputs.len()],
        };
        for at in steps {
            let Instruction { step, out } = program.code[*at as usize];
            let column = lanes.column(step, inputs)?;
            lanes.columns[out as usize] = Some(column);
        }
        Some(lanes)
    }

    /// What a register holds at a place, and whether more digits could change a decision there.
    pub(crate) fn at(&self, register: Register, place: usize) -> (&S, bool) {
        let number = self.get(register).at(place);
        (number, self.doubts[place].is_open)
    }

    fn get(&self, register: Register) -> Operand<'_, S> {
        match &self.columns[register as usize] {
            Some(column) => Operand {
                numbers: column,
                stride: 1,
            },
            None => Operand {
                numbers: &self.registers[register as usize..],
                stride: 0,
            },
        }
    }

    fn column(&mut self, step: ProgramStep, inputs: &[impl Inputs<S>]) -> Option<Vec<S>> {
        let mut doubts = std::mem::take(&mut self.doubts);
        let count = doubts.len();
        let found = match step {
            ProgramStep::Input(slot) => filled(count, |place| inputs[place].input(slot)),
            ProgramStep::Motion(index, order, time) => {
                let time = self.get(time);
                filled(count, |place| {
                    inputs[place].motion(index, order, time.at(place))
                })
            }
            ProgramStep::Copy(a) => self.one(a, count, |a| Ok(a.clone())),
            ProgramStep::Negate(a) => self.one(a, count, |a| Ok(a.negate())),
            ProgramStep::Not(a) => self.one(a, count, |a| Ok(truth(a.to_f64() == 0.0))),
            ProgramStep::PowerWhole(a, exponent) => {
                self.one(a, count, |a| power_whole(a, exponent))
            }
            ProgramStep::Add(a, b) => self.two([a, b], count, add),
            ProgramStep::Subtract(a, b) => self.two([a, b], count, subtract),
            ProgramStep::Multiply(a, b) => self.two([a, b], count, multiply),
            ProgramStep::Divide(a, b) => self.two([a, b], count, divide),
            ProgramStep::Unary(function, a) => {
                self.each([a, a], &mut doubts, |a, _, doubt| unary(function, a, doubt))
            }
            ProgramStep::Power(a, b) => self.each([a, b], &mut doubts, power),
            ProgramStep::Binary(function, a, b) => self.each([a, b], &mut doubts, |a, b, doubt| {
                binary(function, a, b, doubt)
            }),
            ProgramStep::Compare(relation, a, b) => {
                self.each([a, b], &mut doubts, |a, b, doubt| {
                    Ok(compare(relation, a, b, doubt))
                })
            }
            // A constant does not vary, and nothing is gone on with elsewhere.
            ProgramStep::Constant(_)
            | ProgramStep::Jump(_)
            | ProgramStep::JumpUnless(..)
            | ProgramStep::JumpIf(..) => {
                return None;
            }
            ProgramStep::Root(_) | ProgramStep::Integral(_) => return None,
            ProgramStep::ComplexMultiply(..)
            | ProgramStep::ComplexDivide(..)
            | ProgramStep::ComplexPower(..)
            | ProgramStep::ComplexPowerWhole(..)
            | ProgramStep::ComplexUnary(..) => return None,
        };
        self.doubts = doubts;
        found.ok()
    }

    #[inline]
    fn one(
        &self,
        a: Register,
        count: usize,
        step: impl Fn(&S) -> Result<S, Undefined>,
    ) -> Result<Vec<S>, Undefined> {
        let a = self.get(a);
        filled(count, |place| step(a.at(place)))
    }

    #[inline]
    fn two(
        &self,
        [a, b]: [Register; 2],
        count: usize,
        step: impl Fn(&S, &S) -> Result<S, Undefined>,
    ) -> Result<Vec<S>, Undefined> {
        let (a, b) = (self.get(a), self.get(b));
        filled(count, |place| step(a.at(place), b.at(place)))
    }

    #[inline]
    fn each(
        &self,
        [a, b]: [Register; 2],
        doubts: &mut [Doubt],
        step: impl Fn(&S, &S, &mut Doubt) -> Result<S, Undefined>,
    ) -> Result<Vec<S>, Undefined> {
        let (a, b) = (self.get(a), self.get(b));
        filled(doubts.len(), |place| {
            step(a.at(place), b.at(place), &mut doubts[place])
        })
    }
}

/// What a step gives at so many places.
// Collected with its errors, a column would not know how long it becomes, and would move five times while it grows;
// with a place taken for each number, each would ask whether there is room.
#[inline]
fn filled<S: Scalar>(
    count: usize,
    mut step: impl FnMut(usize) -> Result<S, Undefined>,
) -> Result<Vec<S>, Undefined> {
    let mut stop = None;
    let number = |place| {
        step(place).unwrap_or_else(|reason| {
            stop = Some(reason);
            S::exact(0.0)
        })
    };
    let column = (0..count).map(number).collect();
    stop.map_or(Ok(column), Err)
}
