//! Motion of modes that damping couples.
//!
//! The state holds `w_r q_r` and the modal velocities, with `w_r = ω_r`: its length squared is twice the energy, which only
//! damping changes. So the matrix exponential neither grows nor needs balancing, however far the frequencies spread.

use nalgebra::{DMatrix, DVector};

use super::{Initial, propagator};
use crate::numerics::Dd;
use crate::numerics::exponential::Propagator;
use crate::vibration::modes::{ModesError, Refined};

/// A state at time zero and what moves it on.
#[derive(Debug, Clone)]
pub(crate) struct Viscous {
    shapes: DMatrix<f64>,
    /// Factors `w_r` of the modal displacements.
    weights: Vec<f64>,
    propagator: Propagator,
    start: DVector<f64>,
}

/// Samples of a grid between which the state is moved by one matrix.
const BLOCK: usize = 64;

impl Viscous {
    /// `damping` is `Uᵀ C U`; times may go up to the horizon.
    pub(crate) fn of(
        initial: &Initial<'_>,
        damping: &DMatrix<Dd>,
        horizon: f64,
    ) -> Result<Self, ModesError> {
        let weights = weights(initial.modes);
        let generator = generator(initial.modes, &weights, damping);
        let propagator = propagator(&generator, horizon)?;
        let size = weights.len();
        let mut start = DVector::zeros(2 * size);
        for mode in 0..size {
            let state = initial.modal_state(mode);
            start[mode] = weights[mode] * state.position;
            start[size + mode] = state.velocity;
        }
        Ok(Self {
            shapes: initial.modes.modal_matrix(),
            weights,
            propagator,
            start,
        })
    }

    pub(crate) fn state(&self, time: f64, displacements: &mut [f64], velocities: &mut [f64]) {
        let mut state = self.start.clone();
        self.propagator.advance(&mut state, time);
        self.read(&state, displacements, velocities);
    }

    /// Displacements at uniform times, one sample after the other.
    pub(crate) fn grid(&self, start: f64, step: f64, displacements: &mut [f64]) {
        let size = self.weights.len();
        let advance = self.propagator.step(step);
        for (block, samples) in displacements.chunks_mut(BLOCK * size).enumerate() {
            let mut state = self.start.clone();
            self.propagator
                .advance(&mut state, start + step * (block * BLOCK) as f64);
            for sample in samples.chunks_exact_mut(size) {
                self.read(&state, sample, &mut []);
                state = &advance * state;
            }
        }
    }

    fn read(&self, state: &DVector<f64>, displacements: &mut [f64], velocities: &mut [f64]) {
        displacements.fill(0.0);
        velocities.fill(0.0);
        let size = self.weights.len();
        for (mode, shape) in self.shapes.column_iter().enumerate() {
            let position = state[mode] / self.weights[mode];
            let velocity = state[size + mode];
            displacements
                .iter_mut()
                .zip(&shape)
                .for_each(|(x, component)| *x += component * position);
            velocities
                .iter_mut()
                .zip(&shape)
                .for_each(|(v, component)| *v += component * velocity);
        }
    }
}

/// The rates of the modes; for rigid ones the smallest of the others.
pub(crate) fn weights(modes: &Refined) -> Vec<f64> {
    let rate = |mode: usize| modes.eigenvalue(mode).hi().abs().sqrt();
    let smallest = (0..modes.count())
        .map(rate)
        .filter(|rate| *rate > 0.0)
        .fold(f64::INFINITY, f64::min);
    let of_rigid = if smallest.is_finite() { smallest } else { 1.0 };
    (0..modes.count())
        .map(|mode| {
            if rate(mode) > 0.0 {
                rate(mode)
            } else {
                of_rigid
            }
        })
        .collect()
}

/// The matrix `A` of `z' = A z`.
pub(crate) fn generator(modes: &Refined, weights: &[f64], damping: &DMatrix<Dd>) -> DMatrix<Dd> {
    let size = weights.len();
    let mut generator = DMatrix::from_element(2 * size, 2 * size, Dd::ZERO);
    for r in 0..size {
        generator[(r, size + r)] = Dd::from(weights[r]);
        generator[(size + r, r)] = -(modes.eigenvalue(r) / weights[r]);
        for s in 0..size {
            generator[(size + r, size + s)] = -damping[(r, s)];
        }
    }
    generator
}
