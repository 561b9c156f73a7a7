//! What the slots of a program hold while a quantity is evaluated.

use super::evaluate::Evaluation;
use super::graph::{Computation, NodeId};
use crate::expr::{Approx, Inputs, Precise, Scalar, Undefined};
use crate::numerics::Dd;

/// What the slots of a program hold.
pub(crate) struct SlotValues<'a, 'g> {
    pub(crate) evaluation: &'a Evaluation<'g>,
    pub(crate) computation: &'a Computation,
    pub(crate) variables: &'a [Precise],
}

/// What stands in a slot.
enum Slot {
    Node(NodeId, usize),
    Variable(usize),
}

impl SlotValues<'_, '_> {
    fn slot(&self, slot: u32) -> Result<Slot, Undefined> {
        let variables = &self.computation.variables;
        if let Some(position) = variables.iter().position(|(own, _)| *own == slot) {
            return Ok(Slot::Variable(position));
        }
        let inputs = &self.computation.inputs;
        let after = inputs.partition_point(|(first, _)| *first <= slot);
        let (first, node) = inputs
            .get(after.wrapping_sub(1))
            .ok_or(Undefined::Missing { slot })?;
        Ok(Slot::Node(*node, (slot - first) as usize))
    }

    fn variable<S: Scalar>(&self, position: usize, slot: u32) -> Result<S, Undefined> {
        let variable = self.variables.get(position).map(Scalar::of);
        variable.ok_or(Undefined::Missing { slot })
    }

    /// A derivative of a motion of a model at a time.
    fn moved(&self, index: u32, order: u8, time: f64) -> Result<f64, Undefined> {
        let missing = Undefined::Missing { slot: index };
        let id = *self
            .computation
            .motions
            .get(index as usize)
            .ok_or(missing)?;
        self.evaluation
            .motion(id)
            .map_err(|_| missing)?
            .at(order, time)
    }
}

/// Bound on the relative error of a motion of a model.
const MOTION_ERROR: f64 = 1e-14;

impl Inputs<Approx<f64>> for SlotValues<'_, '_> {
    fn motion(&self, index: u32, order: u8, time: &Approx<f64>) -> Result<Approx<f64>, Undefined> {
        let value = self.moved(index, order, time.value)?;
        Ok(Approx::new(value, MOTION_ERROR * value.abs()))
    }

    fn input(&self, slot: u32) -> Result<Approx<f64>, Undefined> {
        match self.slot(slot)? {
            Slot::Variable(position) => self.variable(position, slot),
            Slot::Node(node, entry) => {
                let value = self.evaluation.value(node);
                let value = value.map_err(|_| Undefined::Missing { slot })?;
                Ok(Approx::new(value.numbers()[entry], value.bounds()[entry]))
            }
        }
    }
}

impl Inputs<Approx<Dd>> for SlotValues<'_, '_> {
    fn motion(&self, index: u32, order: u8, time: &Approx<Dd>) -> Result<Approx<Dd>, Undefined> {
        let value = self.moved(index, order, time.value.hi())?;
        Ok(Approx::new(Dd::from(value), MOTION_ERROR * value.abs()))
    }

    fn input(&self, slot: u32) -> Result<Approx<Dd>, Undefined> {
        match self.slot(slot)? {
            Slot::Variable(position) => self.variable(position, slot),
            Slot::Node(node, entry) => {
                let numbers = self.evaluation.precise(node);
                let numbers = numbers.map_err(|_| Undefined::Missing { slot })?;
                Ok(numbers[entry])
            }
        }
    }
}
