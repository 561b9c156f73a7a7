//! The domain of an item's formulas: where its constraints hold.
//!
//! A constraint that says that two things are equal holds nowhere near a point that is drawn: where one of its sides is
//! an input alone, this input is given the value of the other side.

use crate::answer::meaning::{Meaning, ORDERS};
use crate::expr::{Approx, Expr, Kind, Precise, Program, Registers, Relation};
use crate::numerics::SortedMap;

/// One condition of a constraint, over the inputs of a meaning.
#[derive(Debug)]
pub(crate) struct Condition {
    program: Program,
    /// The slot whose value the program is, where it says what something is equal to.
    solved: Option<usize>,
}

impl Condition {
    /// The conditions that constraints say together; those that cannot be computed from the inputs are passed over.
    pub(crate) fn of(meaning: &Meaning, constraints: &[Expr]) -> Vec<Self> {
        let mut conditions = Vec::new();
        let mut open: Vec<&Expr> = constraints.iter().rev().collect();
        while let Some(expr) = open.pop() {
            match expr.kind() {
                Kind::And(first, second) => open.extend([second, first]),
                Kind::Compare(sides, relations) if relations[..] == [Relation::Equal] => {
                    conditions.extend(Self::equal(meaning, &sides[0], &sides[1]));
                }
                _ => conditions.extend(Self::read(meaning, expr, None)),
            }
        }
        conditions
    }

    /// What gives an input the value that it has to have.
    fn equal(meaning: &Meaning, left: &Expr, right: &Expr) -> Option<Self> {
        let solved = |own: &Expr, other: &Expr| {
            let Kind::Name(name) = own.kind() else {
                return None;
            };
            let slot = meaning.place(name)? * ORDERS;
            let condition = Self::read(meaning, other, Some(slot))?;
            let depends = condition.program.slots().contains(&(slot as u32));
            (!depends).then_some(condition)
        };
        solved(left, right).or_else(|| solved(right, left))
    }

    fn read(meaning: &Meaning, expr: &Expr, solved: Option<usize>) -> Option<Self> {
        let program = meaning.compile(expr, &SortedMap::new()).ok()?;
        // What moves is not held by a constraint on the data.
        let is_of_data = program.slots().iter().all(|slot| {
            let input = meaning.inputs.get(*slot as usize / ORDERS);
            input.is_some_and(|input| !input.is_moving)
        });
        is_of_data.then_some(Self { program, solved })
    }

    /// Whether it says what an input is equal to.
    pub(crate) fn is_solved(&self) -> bool {
        self.solved.is_some()
    }

    /// Gives an input the value that the condition says; `None` where there is no such value.
    pub(crate) fn solve(
        &self,
        point: &mut [Precise],
        room: &mut Registers<Approx<f64>>,
    ) -> Option<()> {
        if let Some(slot) = self.solved {
            point[slot] = Precise::exact(self.value(point, room)?);
        }
        Some(())
    }

    /// Whether it holds at a point.
    pub(crate) fn holds(&self, point: &[Precise], room: &mut Registers<Approx<f64>>) -> bool {
        match (self.value(point, room), self.solved) {
            (Some(value), Some(slot)) => {
                // Some thousand units in the last place: more than the formula of a constraint loses,
                // and far less than two drawn values differ by.
                const ROUNDING: f64 = 1e-12;
                let own = point[slot].high();
                (value - own).abs() <= ROUNDING * value.abs()
            }
            (value, None) => value.is_some_and(|value| value != 0.0),
            (None, Some(_)) => false,
        }
    }

    fn value(&self, point: &[Precise], room: &mut Registers<Approx<f64>>) -> Option<f64> {
        let outcome = self.program.run(point, room).ok()?;
        Some(outcome.numbers().next()?.value)
    }
}
