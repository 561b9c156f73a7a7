//! Motion as a sum of modes that do not couple.

use nalgebra::DMatrix;

use super::Initial;
use crate::numerics::Dd;
use crate::vibration::{FreeResponse, State};

/// Modal motions `q_r(t)` and the shapes they carry: `x = Σ φ_r q_r(t)`.
#[derive(Debug, Clone)]
pub(crate) struct Classical {
    /// Shapes as columns.
    shapes: DMatrix<f64>,
    motions: Vec<FreeResponse>,
}

impl Classical {
    /// Modal damping coefficients are those of `q'' + c q' + ω² q = 0`.
    pub(crate) fn of(initial: &Initial<'_>, dampings: &[Dd]) -> Self {
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
    pub(crate) fn state(&self, time: f64, displacements: &mut [f64], velocities: &mut [f64]) {
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

    pub(crate) fn displacements(&self, time: f64, displacements: &mut [f64]) {
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
    /// Sums for a few times side by side stay in registers while the modes are added.
    pub(crate) fn grid(&self, start: f64, step: f64, displacements: &mut [f64]) {
        // Sixteen sums fill four registers of 256 bits.
        const LANES: usize = 16;
        let size = self.motions.len();
        let samples = displacements.len() / size;
        let stride = samples.next_multiple_of(LANES);
        let mut positions = vec![0.0; size * stride];
        for (mode, motion) in self.motions.iter().enumerate() {
            motion.positions(start, step, &mut positions[mode * stride..][..samples]);
        }
        for (block, displacements) in displacements.chunks_mut(LANES * size).enumerate() {
            for i in 0..size {
                let mut sums = [0.0; LANES];
                for (mode, component) in self.shapes.row(i).iter().enumerate() {
                    let positions = &positions[mode * stride + block * LANES..][..LANES];
                    for (sum, position) in sums.iter_mut().zip(positions) {
                        *sum += component * position;
                    }
                }
                for (sample, sum) in displacements.chunks_exact_mut(size).zip(sums) {
                    sample[i] = sum;
                }
            }
        }
    }

    /// The motion of one mode.
    pub(crate) fn modal_state(&self, mode: usize, time: f64) -> State {
        self.motions[mode].state(time)
    }
}
