//! Samples on a uniform grid of times.
//!
//! The grid is cut into blocks. A block starts from phases of its own, and inside it a sample is a sum of two products of
//! the block's factors with tabulated ones, so that errors do not add up along the grid. In each regime
//!
//! ```text
//! x(t_b + τ_j) = a_b α_j + b_b β_j,   v(t_b + τ_j) = c_b γ_j + d_b β_j
//! ```

use super::{FreeResponse, LOWEST_EXPONENT, MAX_SCALED_TIME, ScaledMotion};
use crate::numerics::Dd;

/// Longest block; shorter grids take blocks of about the square root of their length.
const MAX_BLOCK_LENGTH: usize = 64;

/// The tabulated factors α, β, γ for one time within a block.
#[derive(Clone, Copy, Default)]
pub(crate) struct FactorRow {
    pub(crate) position: f64,
    pub(crate) shared: f64,
    pub(crate) velocity: f64,
}

/// The factors a, b and c, d of one block.
#[derive(Clone, Copy)]
pub(crate) struct BlockFactors {
    pub(crate) position: (f64, f64),
    pub(crate) velocity: (f64, f64),
}

/// A grid in scaled time, with the table for its blocks.
pub(crate) struct TimeGrid<'a> {
    motion: &'a ScaledMotion,
    start: f64,
    step: f64,
    /// Samples in a block.
    pub(crate) block: usize,
    pub(crate) rows: [FactorRow; MAX_BLOCK_LENGTH],
    is_within_range: bool,
}

impl<'a> TimeGrid<'a> {
    pub(crate) fn of(response: &'a FreeResponse, start: f64, step: f64, samples: usize) -> Self {
        let motion = &response.motion;
        let (start, step) = (
            response.units.time.apply(start),
            response.units.time.apply(step),
        );
        let block = block_length(samples);
        let mut rows = [FactorRow::default(); MAX_BLOCK_LENGTH];
        let is_within_range = motion.exponent(step * block as f64).abs() < -LOWEST_EXPONENT
            && start.abs() + step.abs() * (samples as f64) < MAX_SCALED_TIME;
        if is_within_range {
            for (j, row) in rows.iter_mut().enumerate().take(block.min(samples)) {
                *row = motion.row(Dd::product(step, j as f64));
            }
        }
        Self {
            motion,
            start,
            step,
            block,
            rows,
            is_within_range,
        }
    }

    /// The factors of the block that starts at a sample; none if the motion leaves the range of numbers in it.
    pub(crate) fn block(&self, first: usize, samples: usize) -> Option<BlockFactors> {
        let time = Dd::product(self.step, first as f64) + self.start;
        let last = time.hi() + self.step * samples as f64;
        let is_ordinary = |t: f64| self.motion.exponent(t).abs() < -LOWEST_EXPONENT;
        (self.is_within_range && is_ordinary(time.hi()) && is_ordinary(last))
            .then(|| self.motion.block(time))
    }
}

/// The power of two next to the square root of the number of samples, at most [`MAX_BLOCK_LENGTH`].
fn block_length(samples: usize) -> usize {
    let mut length = 4;
    while length < MAX_BLOCK_LENGTH && length * length < samples {
        length *= 2;
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::oscillator::Oscillator;
    use crate::vibration::state::State;

    #[test]
    fn grids_agree_with_single_samples() {
        for damping in [0.0, 1e-3, 0.7, 2.0 - 1e-9, 2.0, 2.0 + 1e-9, 3.0, 1e3] {
            let oscillator = Oscillator::new(1.0, damping, 1.0).unwrap();
            let response = FreeResponse::of(
                &oscillator,
                State {
                    position: 0.4,
                    velocity: -1.3,
                },
            );
            for count in [1, 5, 70, 4100] {
                let (mut alone, mut positions, mut velocities) =
                    (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
                response.positions(0.5, 0.25, &mut alone);
                response.states(0.5, 0.25, &mut positions, &mut velocities);
                assert_eq!(alone, positions);
                for (i, (x, v)) in positions.iter().zip(&velocities).enumerate() {
                    let t = 0.5 + 0.25 * i as f64;
                    let state = response.state(t);
                    let scale = (1.0 + t.min(1e3))
                        * crate::numerics::exp((response.motion.exponent(t)).max(-700.0));
                    assert!(
                        (x - state.position).abs() <= 1.5e-15 * scale,
                        "{damping} {i}"
                    );
                    assert!(
                        (v - state.velocity).abs() <= 1.5e-15 * scale,
                        "{damping} {i}"
                    );
                }
            }
        }
    }

    #[test]
    fn extreme_grids_fall_back_to_single_samples() {
        let oscillator = Oscillator::new(1.0, 1.0, 1.0).unwrap();
        let response = FreeResponse::of(
            &oscillator,
            State {
                position: 1e300,
                velocity: 0.0,
            },
        );
        let mut positions = [0.0; 100];
        response.positions(0.0, 30.0, &mut positions);
        assert_eq!(positions[40], response.position(1200.0));
        response.positions(0.0, 1e307, &mut positions);
        assert!(positions.iter().all(|x| x.is_finite()));
    }
}
