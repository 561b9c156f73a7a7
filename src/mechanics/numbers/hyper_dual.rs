//! M, C and K from second derivatives of the energies by hyper-dual numbers: the route that knows nothing of the
//! symbolic one.

use super::{Numbers, Unavailable};
use crate::expr::{HyperDual, Inputs, Precise, Program, Registers, Undefined};
use crate::mechanics::programs::{Compiled, ModelData};

/// M, C and K by rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearization {
    /// M.
    pub mass: Vec<f64>,
    /// C.
    pub damping: Vec<f64>,
    /// K.
    pub stiffness: Vec<f64>,
}

/// Inputs of which two bear an infinitesimal.
struct Seeded<'a> {
    data: ModelData<'a>,
    first: u32,
    second: u32,
}

impl Inputs<HyperDual> for Seeded<'_> {
    fn input(&self, slot: u32) -> Result<HyperDual, Undefined> {
        Ok(HyperDual {
            value: self.data.precise(slot)?.high(),
            first: f64::from(u8::from(self.first == slot)),
            second: f64::from(u8::from(self.second == slot)),
            both: 0.0,
        })
    }
}

pub(crate) fn linearization(numbers: &Numbers) -> Result<Linearization, Unavailable> {
    let size = numbers.model.degrees_of_freedom();
    let position: Vec<_> = numbers
        .equilibrium()?
        .iter()
        .copied()
        .map(Precise::exact)
        .collect();
    let mut kernel = Kernel {
        numbers,
        position: &position,
        room: Registers::default(),
    };
    let entries = || vec![0.0; size * size];
    let (mut mass, mut damping, mut stiffness) = (entries(), entries(), entries());
    let written = &numbers.model.evaluation.written;
    for row in 0..size {
        for column in 0..size {
            let (at, mirrored) = (row * size + column, column * size + row);
            let [q, v] = [row, row + size].map(|own| slot(numbers, own));
            let [other_q, other_v] = [column, column + size].map(|own| slot(numbers, own));
            // What is gyroscopic enters once with each sign.
            let mixed = kernel.second(&written.kinetic, v, other_q)?;
            damping[at] += mixed;
            damping[mirrored] -= mixed;
            if let Some(force) = &written.forces[row] {
                let slopes = kernel.first(force, other_q, other_v)?;
                stiffness[at] -= slopes[0];
                damping[at] -= slopes[1];
            }
            if column < row {
                continue;
            }
            let inertia = kernel.second(&written.kinetic, v, other_v)?;
            let viscous = kernel.second(&written.dissipation, v, other_v)?;
            let elastic = kernel.second(&written.potential, q, other_q)?
                - kernel.second(&written.kinetic, q, other_q)?;
            // Second derivatives are symmetric; on the diagonal both places are the same.
            let places = if column == row { 1 } else { 2 };
            for place in [at, mirrored].into_iter().take(places) {
                mass[place] += inertia;
                damping[place] += viscous;
                stiffness[place] += elastic;
            }
        }
    }
    Ok(Linearization {
        mass,
        damping,
        stiffness,
    })
}

/// The slot of a coordinate, or of a velocity after them.
fn slot(numbers: &Numbers, at: usize) -> u32 {
    (numbers.constants.len() + at) as u32
}

struct Kernel<'a> {
    numbers: &'a Numbers,
    position: &'a [Precise],
    room: Registers<HyperDual>,
}

impl Kernel<'_> {
    /// The second derivative of a formula by two inputs.
    fn second(&mut self, formula: &Compiled, first: u32, second: u32) -> Result<f64, Unavailable> {
        let ready = formula.ready(&self.numbers.model.evaluation.slots)?;
        if !(ready.reads(first) && ready.reads(second)) {
            return Ok(0.0);
        }
        Ok(self.run(&ready.program, first, second)?.both)
    }

    /// The first derivatives of a formula by two inputs.
    fn first(
        &mut self,
        formula: &Compiled,
        first: u32,
        second: u32,
    ) -> Result<[f64; 2], Unavailable> {
        let ready = formula.ready(&self.numbers.model.evaluation.slots)?;
        let result = self.run(&ready.program, first, second)?;
        Ok([result.first, result.second])
    }

    fn run(
        &mut self,
        program: &Program,
        first: u32,
        second: u32,
    ) -> Result<HyperDual, Unavailable> {
        let inputs = Seeded {
            data: ModelData {
                constants: &self.numbers.constants,
                position: self.position,
            },
            first,
            second,
        };
        let outcome = program.run(&inputs, &mut self.room)?;
        outcome
            .numbers()
            .next()
            .copied()
            .ok_or(Unavailable::NoNumber)
    }
}
