//! Samples on a uniform grid of times.
//!
//! The grid is cut into blocks. A block starts from phases of its own, and inside it a sample is a sum of two products of
//! the block's factors with tabulated ones, so that errors do not add up along the grid. In each regime
//!
//! ```text
//! x(t_b + τ_j) = a_b α_j + b_b β_j,   v(t_b + τ_j) = c_b γ_j + d_b β_j
//! ```

use super::critical::Critical;
use super::oscillating::Oscillating;
use super::overdamped::Overdamped;
use super::{FreeResponse, LOWEST_EXPONENT, MAX_SCALED_TIME, ScaledMotion};
use crate::numerics::{Dd, expm1};

/// Longest block; shorter grids take blocks of about the square root of their length.
const MAX_BLOCK_LENGTH: usize = 64;

/// The tabulated factors α, β, γ for one time within a block.
#[derive(Clone, Copy, Default)]
struct FactorRow {
    position: f64,
    shared: f64,
    velocity: f64,
}

/// The factors a, b and c, d of one block.
#[derive(Clone, Copy)]
struct BlockFactors {
    position: (f64, f64),
    velocity: (f64, f64),
}

impl FreeResponse {
    /// Positions in m at the times start, start + step, start + 2 step, ... in s.
    ///
    /// The times are the exact ones, not their rounded values.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::{FreeResponse, Oscillator, State};
    ///
    /// let oscillator = Oscillator::new(1.0, 0.2, 4.0)?;
    /// let motion = FreeResponse::of(&oscillator, State { position: 1.0, velocity: 0.0 });
    /// let mut positions = [0.0; 201];
    /// motion.positions(0.0, 0.125, &mut positions);
    /// assert!((positions[200] - motion.position(25.0)).abs() < 1e-15);
    /// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
    /// ```
    pub fn positions(&self, start: f64, step: f64, positions: &mut [f64]) {
        let grid = TimeGrid::of(self, start, step, positions.len());
        for (index, chunk) in positions.chunks_mut(grid.block).enumerate() {
            let first = index * grid.block;
            let Some(block) = grid.block(first, chunk.len()) else {
                for (i, x) in chunk.iter_mut().enumerate() {
                    *x = self.position(start + step * (first + i) as f64);
                }
                continue;
            };
            let (a, b) = block.position;
            for (x, row) in chunk.iter_mut().zip(&grid.rows) {
                *x = self.units.position.apply(a * row.position + b * row.shared);
            }
        }
    }

    /// Positions in m and velocities in m/s at the times start, start + step, start + 2 step, ... in s.
    ///
    /// As many samples as both slices have room for.
    pub fn states(&self, start: f64, step: f64, positions: &mut [f64], velocities: &mut [f64]) {
        let grid = TimeGrid::of(self, start, step, positions.len().min(velocities.len()));
        let chunks = positions
            .chunks_mut(grid.block)
            .zip(velocities.chunks_mut(grid.block));
        for (index, (positions, velocities)) in chunks.enumerate() {
            let first = index * grid.block;
            let samples = positions.iter_mut().zip(velocities.iter_mut());
            let Some(block) = grid.block(first, samples.len()) else {
                for (i, (x, v)) in samples.enumerate() {
                    let state = self.state(start + step * (first + i) as f64);
                    (*x, *v) = (state.position, state.velocity);
                }
                continue;
            };
            let ((a, b), (c, d)) = (block.position, block.velocity);
            for ((x, v), row) in samples.zip(&grid.rows) {
                *x = self.units.position.apply(a * row.position + b * row.shared);
                *v = self.units.velocity.apply(c * row.velocity + d * row.shared);
            }
        }
    }
}

/// A grid in scaled time, with the table for its blocks.
struct TimeGrid<'a> {
    motion: &'a ScaledMotion,
    start: f64,
    step: f64,
    /// Samples in a block.
    block: usize,
    rows: [FactorRow; MAX_BLOCK_LENGTH],
    is_within_range: bool,
}

impl<'a> TimeGrid<'a> {
    fn of(response: &'a FreeResponse, start: f64, step: f64, samples: usize) -> Self {
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
    fn block(&self, first: usize, samples: usize) -> Option<BlockFactors> {
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

impl ScaledMotion {
    fn row(&self, time: Dd) -> FactorRow {
        match self {
            Self::Oscillating(motion) => motion.row(time),
            Self::Critical(motion) => motion.row(time),
            Self::Overdamped(motion) => motion.row(time),
        }
    }

    fn block(&self, time: Dd) -> BlockFactors {
        match self {
            Self::Oscillating(motion) => motion.block(time),
            Self::Critical(motion) => motion.block(time),
            Self::Overdamped(motion) => motion.block(time),
        }
    }
}

impl Oscillating {
    /// Decay and rotation, e^(-λτ) cos ω_d τ and -e^(-λτ) sin ω_d τ.
    fn row(&self, time: Dd) -> FactorRow {
        let (sine, cosine) = (self.frequency * time).sin_cos_to_f64();
        let envelope = if self.is_damped {
            (self.growth * time).exp_to_f64()
        } else {
            1.0
        };
        FactorRow {
            position: envelope * cosine,
            shared: -envelope * sine,
            velocity: envelope * cosine,
        }
    }

    fn block(&self, time: Dd) -> BlockFactors {
        let FactorRow {
            position: cosine,
            shared: minus_sine,
            ..
        } = self.row(time);
        let turned = |even: f64, odd: f64| {
            (
                even * cosine - odd * minus_sine,
                -even * minus_sine - odd * cosine,
            )
        };
        BlockFactors {
            position: turned(self.initial.position, self.position_sine),
            velocity: turned(self.initial.velocity, self.velocity_sine),
        }
    }
}

impl Critical {
    /// Decay e^(-λτ), alone and times τ.
    fn row(&self, time: Dd) -> FactorRow {
        let envelope = (self.growth * time).exp_to_f64();
        FactorRow {
            position: envelope,
            shared: envelope * time.hi(),
            velocity: envelope,
        }
    }

    fn block(&self, time: Dd) -> BlockFactors {
        let envelope = (self.growth * time).exp_to_f64();
        let line =
            |value: f64, slope: f64| (envelope * (value + slope * time.hi()), envelope * slope);
        BlockFactors {
            position: line(self.initial.position, self.position_slope),
            velocity: line(self.initial.velocity, self.velocity_slope),
        }
    }
}

impl Overdamped {
    /// Decay e^(r_s τ), alone and times P(τ), and e^(r_f τ).
    fn row(&self, time: Dd) -> FactorRow {
        let envelope = (self.slow * time).exp_to_f64();
        let ramp = -expm1(-self.gap * time.hi()) / self.gap;
        FactorRow {
            position: envelope,
            shared: envelope * ramp,
            velocity: (self.fast * time).exp_to_f64(),
        }
    }

    /// The state at the block's start, and q and p of the motion from there, which decay with one root each.
    fn block(&self, time: Dd) -> BlockFactors {
        let state = self.state::<false>(time.hi());
        let beyond_slow = self.beyond_slow * (self.fast * time).exp_to_f64();
        let beyond_fast = self.beyond_fast * (self.slow * time).exp_to_f64();
        BlockFactors {
            position: (state.position, beyond_slow),
            velocity: (state.velocity, self.slow.hi() * beyond_fast),
        }
    }
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
