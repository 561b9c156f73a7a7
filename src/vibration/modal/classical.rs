//! Motion as a sum of modes that do not couple.

use nalgebra::DMatrix;

use super::Initial;
use crate::numerics::Dd;
use crate::vibration::{FreeResponse, State};

/// Modal motions `q_r(t)` and the shapes they carry: `x = Σ φ_r q_r(t)`.
#[derive(Debug, Clone)]
pub(super) struct Classical {
    /// Shapes as columns.
    shapes: DMatrix<f64>,
    motions: Vec<FreeResponse>,
}

impl Classical {
    /// Modal damping coefficients are those of `q'' + c q' + ω² q = 0`.
    pub(super) fn of(initial: &Initial<'_>, dampings: &[Dd]) -> Self {
        let modes = initial.modes;
        let motions = (0..modes.count())
            .map(|mode| {
                FreeResponse::of_mode(
                    dampings[mode],
                    modes.eigenvalue(mode),
                    initial.modal_state(mode),
                )
            })
            .collect();
        Self {
            shapes: modes.modal_matrix(),
            motions,
        }
    }

    /// Adds displacements, and velocities where there is room for them.
    pub(super) fn state(&self, time: f64, displacements: &mut [f64], velocities: &mut [f64]) {
        displacements.fill(0.0);
        velocities.fill(0.0);
        for (shape, motion) in self.shapes.column_iter().zip(&self.motions) {
            let state = motion.state(time);
            let parts = displacements
                .iter_mut()
                .zip(velocities.iter_mut())
                .zip(&shape);
            for ((x, v), component) in parts {
                *x += component * state.position;
                *v += component * state.velocity;
            }
        }
    }

    pub(super) fn displacements(&self, time: f64, displacements: &mut [f64]) {
        displacements.fill(0.0);
        for (shape, motion) in self.shapes.column_iter().zip(&self.motions) {
            let position = motion.position(time);
            displacements
                .iter_mut()
                .zip(&shape)
                .for_each(|(x, component)| *x += component * position);
        }
    }

    /// Displacements at uniform times, one sample after the other.
    ///
    /// One coordinate is summed up for all times before the next, so that the sums run along memory.
    pub(super) fn grid(&self, start: f64, step: f64, displacements: &mut [f64]) {
        let size = self.motions.len();
        let samples = displacements.len() / size;
        if samples == 0 {
            return;
        }
        let mut positions = vec![0.0; size * samples];
        for (motion, positions) in self.motions.iter().zip(positions.chunks_exact_mut(samples)) {
            motion.positions(start, step, positions);
        }
        let mut sums = vec![0.0; samples];
        for i in 0..size {
            sums.fill(0.0);
            for (component, positions) in self
                .shapes
                .row(i)
                .iter()
                .zip(positions.chunks_exact(samples))
            {
                for (sum, position) in sums.iter_mut().zip(positions) {
                    *sum += component * position;
                }
            }
            for (sample, sum) in displacements.chunks_exact_mut(size).zip(&sums) {
                sample[i] = *sum;
            }
        }
    }

    /// The motion of one mode.
    pub(super) fn modal_state(&self, mode: usize, time: f64) -> State {
        self.motions[mode].state(time)
    }
}
