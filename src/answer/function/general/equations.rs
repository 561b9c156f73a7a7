//! Whether the equations of a model hold for what was typed.

use super::marker::Prepared;
use super::solution::TypedSolution;
use crate::answer::equality::Draws;
use crate::expr::{Precise, Program, Workspace};

/// Whether the equations hold for constants at random, and for each of them that is large beside the others: so
/// each mode shows alone, and what no constant multiplies does.
pub(crate) fn satisfies(key: &Prepared, solution: &TypedSolution) -> Option<bool> {
    const SMALL: f64 = 1e-3;
    let mut draws = Draws::new();
    let mut random = || -> Vec<f64> {
        let constants = key.setup.constants.iter();
        constants.map(|_| 1.0 + 0.9 * draws.signed()).collect()
    };
    let mut all: Vec<Vec<f64>> = (0..3).map(|_| random()).collect();
    for large in &solution.used {
        let mut constants = random();
        for (place, value) in constants.iter_mut().enumerate() {
            *value *= if place == *large { 1.0 } else { SMALL };
        }
        all.push(constants);
    }
    for constants in &all {
        if !satisfies_with(key, solution, constants)? {
            return Some(false);
        }
    }
    Some(lasts(key, solution, &all[0]))
}

/// Whether the equations hold for these constants.
fn satisfies_with(key: &Prepared, solution: &TypedSolution, constants: &[f64]) -> Option<bool> {
    // Of a formula without decimals nothing is rounded but by the machine.
    const EXACT: f64 = 1e-7;
    let mut room = Workspace::default();
    let times = key.times();
    let mut largest = |programs: &[Program]| -> Option<Vec<f64>> {
        let mut largest = vec![0.0_f64; programs.len()];
        for time in &times {
            let point = key.point(constants, *time);
            for (largest, program) in largest.iter_mut().zip(programs) {
                let value = program.evaluate_real(&point[..], &mut room).ok()?;
                *largest = largest.max(value.abs());
            }
        }
        Some(largest)
    };
    let positions = largest(&solution.positions)?;
    let accelerations = largest(&solution.accelerations)?;
    let residuals = largest(&solution.residuals)?;
    for (residual, program) in residuals.iter().zip(&solution.bare) {
        let mut scale = |order: usize, largest: &[f64]| {
            let mut sum = 0.0;
            for (name, largest) in key.setup.coordinates.iter().zip(largest) {
                let mut point = key.point(constants, times[0]);
                point[key.setup.slot(name)? + order] = Precise::exact(*largest);
                sum += program.evaluate_real(&point[..], &mut room).ok()?.abs();
            }
            Some(sum)
        };
        // Rounding a shape moves all terms by its share, and rounding a frequency those of inertia by twice its
        // share.
        let (of_shape, of_inertia) = match solution.rounding {
            0.0 => (EXACT, EXACT),
            rounding => (rounding, 3.0 * rounding),
        };
        if *residual > of_shape * scale(0, &positions)? + of_inertia * scale(2, &accelerations)? {
            return Some(false);
        }
    }
    Some(true)
}

/// Whether a solution is as large after thousands of periods as in the first ones, where the equations have no
/// terms of velocities and each mode oscillates: a damping that hardly shows in the equations shows there.
fn lasts(key: &Prepared, solution: &TypedSolution, constants: &[f64]) -> bool {
    const PERIODS: f64 = 2_000.0;
    const SAMPLES: u32 = 32;
    let mut room = Workspace::default();
    let is_undamped = solution.bare.iter().all(|program| {
        key.setup.coordinates.iter().all(|name| {
            let mut point = key.point(constants, 0.0);
            let slot = key.setup.slot(name);
            if let Some(slot) = slot {
                point[slot + 1] = Precise::exact(1.0);
            }
            let value = program.evaluate_real(&point[..], &mut room);
            value.is_ok_and(|value| value == 0.0)
        })
    });
    let slowest = key.modes.iter().map(|(frequency, _)| *frequency);
    let slowest = slowest.fold(f64::INFINITY, f64::min);
    if !is_undamped || slowest <= 0.0 || slowest.is_infinite() {
        return true;
    }
    let period = std::f64::consts::TAU / slowest;
    // Times that are not in step with any mode.
    let size = |from: f64, room: &mut Workspace| -> Option<f64> {
        let mut sum = 0.0;
        for place in 0..SAMPLES {
            let share = (f64::from(place) + 0.37) / f64::from(SAMPLES);
            let point = key.point(constants, from + 14.0 * period * share * share);
            for program in &solution.positions {
                let value = program.evaluate_real(&point[..], room).ok()?;
                sum += value * value;
            }
        }
        Some(sum.sqrt())
    };
    let (first, late) = (size(0.0, &mut room), size(PERIODS * period, &mut room));
    first
        .zip(late)
        .is_some_and(|(first, late)| late <= 2.0 * first && first <= 2.0 * late)
}
