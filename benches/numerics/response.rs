//! Time response of a chain of ten masses.

use differential_equations::prelude::*;
use nalgebra::{DMatrix, DVector};
use vibank::numerics::{Dd, cos};
use vibank::vibration::modal::{Damping, ModalResponse};
use vibank::vibration::modes::Modes;

use crate::integrate::{Place, ladder};
use crate::measure::time;
use crate::modes::{exact_frequencies, uniform_chain};
use crate::record::{Error, Record};

const SIZE: usize = 10;
const SAMPLES: usize = 201;

/// The chain as a first-order system: displacements, then velocities.
struct Chain;

impl ODE<f64, [f64; 2 * SIZE]> for Chain {
    fn diff(&self, _time: f64, state: &[f64; 2 * SIZE], rate: &mut [f64; 2 * SIZE]) {
        for i in 0..SIZE {
            let left = if i == 0 { 0.0 } else { state[i - 1] };
            let right = if i + 1 == SIZE {
                state[i]
            } else {
                state[i + 1]
            };
            rate[i] = state[SIZE + i];
            rate[SIZE + i] = left - 2.0 * state[i] + right;
        }
    }
}

/// The last mass is pulled by 1 m and released.
fn start() -> [f64; SIZE] {
    let mut start = [0.0; SIZE];
    start[SIZE - 1] = 1.0;
    start
}

/// Displacements by the closed form of the uniform chain, `φ_i = sin(i (2r-1) π/(2n+1))`.
fn exact(time: f64) -> Vec<f64> {
    let frequencies = exact_frequencies(SIZE);
    let turn = Dd::PI / (2 * SIZE + 1) as f64;
    let shape = |mode: usize, mass: usize| (turn * ((2 * mode + 1) * (mass + 1)) as f64).sin();
    let factor = Dd::from(4.0) / (2 * SIZE + 1) as f64;
    (0..SIZE)
        .map(|mass| {
            let terms = (0..SIZE).map(|mode| {
                shape(mode, mass) * shape(mode, SIZE - 1) * (frequencies[mode] * time).cos()
            });
            (terms.fold(Dd::ZERO, |sum, term| sum + term) * factor).hi()
        })
        .collect()
}

/// Largest difference of any displacement, in m; the amplitudes are about 1 m.
fn error<'a>(displacements: impl Iterator<Item = &'a [f64]>, exact: &[Vec<f64>]) -> f64 {
    displacements
        .zip(exact)
        .flat_map(|(x, y)| x.iter().zip(y).map(|(x, y)| (x - y).abs()))
        .fold(0.0, f64::max)
}

/// The modal sum as it stands in textbooks, over a dense symmetric eigenproblem.
struct Textbook {
    frequencies: DVector<f64>,
    shapes: DMatrix<f64>,
    start: DVector<f64>,
}

impl Textbook {
    fn new() -> Self {
        let stiffness = DMatrix::from_fn(SIZE, SIZE, |i, j| match i.abs_diff(j) {
            0 if i + 1 == SIZE => 1.0,
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        });
        let eigen = stiffness.symmetric_eigen();
        let start = eigen.eigenvectors.transpose() * DVector::from_column_slice(&start());
        Self {
            frequencies: eigen.eigenvalues.map(f64::sqrt),
            shapes: eigen.eigenvectors,
            start,
        }
    }

    fn displacements(&self, time: f64) -> DVector<f64> {
        let modal = self
            .frequencies
            .map(|frequency| cos(frequency * time))
            .component_mul(&self.start);
        &self.shapes * modal
    }
}

/// Measures displacements at uniform times; an item is the whole motion, set-up included.
fn measure(records: &mut Vec<Record>, task: &str, case: &str, last: f64, with_integrators: bool) {
    let step = last / (SAMPLES - 1) as f64;
    let times: Vec<f64> = (0..SAMPLES).map(|i| step * i as f64).collect();
    let reference: Vec<Vec<f64>> = times.iter().map(|&time| exact(time)).collect();
    let (masses, springs) = uniform_chain(SIZE);
    let ours = || {
        let modes = Modes::of_network(&masses, &springs).expect("the chain is sound");
        let horizon = last * (1.0 + 1e-15);
        let motion = ModalResponse::of(&modes, &Damping::none(), &start(), &[0.0; SIZE], horizon);
        let motion = motion.expect("the chain is sound");
        let mut displacements = vec![0.0; SIZE * SAMPLES];
        motion
            .grid(0.0, step, &mut displacements)
            .expect("the times are in the horizon");
        displacements
    };
    let modes = Modes::of_network(&masses, &springs).expect("the chain is sound");
    let prepared = ModalResponse::of(
        &modes,
        &Damping::none(),
        &start(),
        &[0.0; SIZE],
        last * (1.0 + 1e-15),
    )
    .expect("the chain is sound");
    let sampled = || {
        let mut displacements = vec![0.0; SIZE * SAMPLES];
        prepared
            .grid(0.0, step, &mut displacements)
            .expect("the times are in the horizon");
        displacements
    };
    let textbook = || {
        let textbook = Textbook::new();
        times
            .iter()
            .flat_map(|&time| textbook.displacements(time).as_slice().to_vec())
            .collect::<Vec<f64>>()
    };
    let mut add = |method, solve: &dyn Fn() -> Vec<f64>| {
        let error = error(solve().chunks_exact(SIZE), &reference);
        records.push(Record {
            task: task.to_owned(),
            case: case.to_owned(),
            parameter: None,
            method,
            tolerance: None,
            timing: time(|_| solve()),
            error: Error::computed(error),
        });
    };
    add("vibank", &ours);
    add("vibank (prepared)", &sampled);
    add("dense modes", &textbook);
    if with_integrators {
        let mut state = [0.0; 2 * SIZE];
        state[..SIZE].copy_from_slice(&start());
        let place = Place {
            task,
            case,
            parts: 1,
        };
        records.extend(ladder(place, &Chain, state, &times, |states| {
            // At the last time, where no interpolation enters.
            let last = states.iter().skip(SAMPLES - 1).map(|state| &state[..SIZE]);
            Error::computed(error(last, &reference[SAMPLES - 1..]))
        }));
    }
}

/// Ten masses, 201 samples over about three periods of the lowest mode.
pub(crate) fn of_ten_masses(records: &mut Vec<Record>) {
    measure(records, "response-of-ten-masses", "t=125", 125.0, true);
}

/// The same after longer and longer times.
pub(crate) fn against_time(records: &mut Vec<Record>) {
    for power in [2, 4, 6, 8, 9] {
        // A step that is a whole number of eighths, so that the times on the grid are exact.
        let last = (vibank::numerics::powi(10.0, power) / 25.0).ceil() * 25.0;
        measure(
            records,
            "response-against-time",
            &format!("t=1e{power}"),
            last,
            power <= 2,
        );
    }
}
