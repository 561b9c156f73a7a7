//! Whether free constants can meet any initial state.

use super::marker::Prepared;
use super::solution::TypedSolution;
use crate::answer::equality::Draws;
use crate::expr::Workspace;

/// Differences below this part of the largest value are rounding.
const ROUNDING: f64 = 1e-9;

/// How a function depends on a constant.
#[derive(Clone, Copy, PartialEq)]
enum ConstantRole {
    /// In proportion, but for what stands without it: `A cos(5 t)`.
    Factor,
    /// As a sine or cosine: `cos(5 t + phi)`.
    Phase,
}

/// The number of initial states, of positions and velocities, that the constants can vary independently: those of
/// the real and of the imaginary part together.
pub(crate) fn rank(key: &Prepared, solutions: &[TypedSolution]) -> Option<usize> {
    // About the cube root of the unit roundoff, the best step of a central difference.
    const STEP: f64 = 1e-5;
    let (mut draws, mut room) = (Draws::new(), Workspace::default());
    let constants: Vec<f64> = key
        .setup
        .constants
        .iter()
        .map(|_| 1.0 + 0.5 * draws.signed())
        .collect();
    let rate = key
        .modes
        .last()
        .map_or(1.0, |(frequency, _)| frequency.max(f64::MIN_POSITIVE));
    let mut state = |constants: &[f64]| -> Option<Vec<f64>> {
        let point = key.point(constants, 0.0);
        solutions
            .iter()
            .flat_map(|solution| {
                let TypedSolution {
                    positions,
                    velocities,
                    ..
                } = solution;
                let positions = positions.iter().map(|program| (program, 1.0));
                positions.chain(velocities.iter().map(|program| (program, rate)))
            })
            .map(|(program, unit)| Some(program.evaluate_real(&point[..], &mut room).ok()? / unit))
            .collect()
    };
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let places = 0..constants.len();
    for place in places.filter(|at| solutions.iter().any(|own| own.used.contains(at))) {
        let mut moved = constants.clone();
        moved[place] += STEP;
        let after = state(&moved)?;
        moved[place] -= 2.0 * STEP;
        let before = state(&moved)?;
        let mut rest: Vec<f64> = after
            .iter()
            .zip(&before)
            .map(|(a, b)| (a - b) / (2.0 * STEP))
            .collect();
        let whole = length(&rest);
        for own in &basis {
            let share: f64 = own.iter().zip(&rest).map(|(a, b)| a * b).sum();
            rest.iter_mut()
                .zip(own)
                .for_each(|(value, own)| *value -= share * own);
        }
        let size = length(&rest);
        if whole > 1e-6 && size > 1e-3 * whole {
            for value in &mut rest {
                *value /= size;
            }
            basis.push(rest);
        }
    }
    Some(basis.len())
}

/// Whether each constant is a factor or a phase, and without the factors nothing depends on the phases.
/// Other functions of a constant, `e^A` or `sin(C)/100`, do not reach all values.
pub(crate) fn are_factors_and_phases(key: &Prepared, solution: &TypedSolution) -> bool {
    let mut draws = Draws::new();
    let mut draw = || -> Vec<f64> {
        let constants = key.setup.constants.iter();
        constants.map(|_| 1.0 + 0.5 * draws.signed()).collect()
    };
    let (constants, others) = (draw(), draw());
    let roles = (0..constants.len()).map(|place| {
        if solution.used.contains(&place) {
            role_of(key, solution, &constants, place)
        } else {
            Some(ConstantRole::Factor)
        }
    });
    let Some(roles) = roles.collect::<Option<Vec<ConstantRole>>>() else {
        return false;
    };
    let state = |phases: &[f64], size: f64| {
        let places = roles.iter().zip(phases).zip(&constants);
        let mixed = places.map(|((role, phase), own)| match role {
            ConstantRole::Factor => size * own,
            ConstantRole::Phase => *phase,
        });
        positions(key, solution, &mixed.collect::<Vec<_>>())
    };
    let states = [
        state(&constants, 0.0),
        state(&others, 0.0),
        state(&constants, 1.0),
        state(&constants, 2.0),
    ];
    let [Some(rest), Some(other), Some(once), Some(twice)] = states else {
        return false;
    };
    let is_same = |a: f64, b: f64, size: f64| (a - b).abs() <= ROUNDING * (1.0 + size.abs());
    (0..rest.len()).all(|at| {
        let (first, second) = (once[at] - rest[at], twice[at] - rest[at]);
        is_same(rest[at], other[at], once[at]) && is_same(second, 2.0 * first, second)
    })
}

/// How positions depend on the constant at a place; none if in no such way.
fn role_of(
    key: &Prepared,
    solution: &TypedSolution,
    constants: &[f64],
    place: usize,
) -> Option<ConstantRole> {
    // No simple part of a turn: five states at this distance tell proportion from a sine.
    const STEP: f64 = 0.7;
    let states = (-2..=2).map(|step| {
        let mut moved = constants.to_vec();
        moved[place] += STEP * f64::from(step);
        positions(key, solution, &moved)
    });
    let states = states.collect::<Option<Vec<_>>>()?;
    let largest = states
        .iter()
        .flatten()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    let is_same = |a: f64, b: f64| (a - b).abs() <= ROUNDING * largest;
    let slope = |step: usize, at: usize| states[step + 1][at] - states[step][at];
    let places = 0..states[0].len();
    if places
        .clone()
        .all(|at| (1..4).all(|step| is_same(slope(step, at), slope(0, at))))
    {
        return Some(ConstantRole::Factor);
    }
    // Of three equidistant values of a sine the outer ones add up to 2 cos(step) times the middle one.
    let size = |of: &(usize, usize)| slope(of.0, of.1).abs();
    let pairs = places.flat_map(|at| [(1, at), (2, at)]).collect::<Vec<_>>();
    let &(step, at) = pairs.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let double = (slope(step - 1, at) + slope(step + 1, at)) / slope(step, at);
    let is_sine = pairs.iter().all(|&(step, at)| {
        is_same(
            slope(step - 1, at) + slope(step + 1, at),
            double * slope(step, at),
        )
    });
    (is_sine && double.abs() < 2.0 - ROUNDING).then_some(ConstantRole::Phase)
}

/// Whether a part is nothing beside another.
pub(crate) fn vanishes(key: &Prepared, part: &TypedSolution, beside: &TypedSolution) -> bool {
    let mut draws = Draws::new();
    let constants = key.setup.constants.iter();
    let constants: Vec<f64> = constants.map(|_| 1.0 + 0.5 * draws.signed()).collect();
    let largest = |solution| {
        let positions = positions(key, solution, &constants)?;
        Some(
            positions
                .iter()
                .fold(0.0_f64, |most, own| most.max(own.abs())),
        )
    };
    let sizes = largest(part).zip(largest(beside));
    sizes.is_some_and(|(part, whole)| part <= ROUNDING * whole)
}

/// The positions at some times.
fn positions(key: &Prepared, solution: &TypedSolution, constants: &[f64]) -> Option<Vec<f64>> {
    let mut room = Workspace::default();
    let mut found = Vec::new();
    for time in key.times().into_iter().take(3) {
        let point = key.point(constants, time);
        for program in &solution.positions {
            found.push(program.evaluate_real(&point[..], &mut room).ok()?);
        }
    }
    Some(found)
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}
