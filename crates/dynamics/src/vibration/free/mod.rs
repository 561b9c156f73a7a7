//! Free response: the motion after a displacement and a push, without a force.
//!
//! [`FreeResponse`] holds what does not depend on time; a sample then costs one exponential and one pair of sine and
//! cosine, and a uniform grid about one complex product a sample. Phases and exponents are double-double, so the error
//! does not grow with time; the regimes join without a seam, since each is a divided difference of the exponential.

mod critical;
mod grid;
mod mode;
mod oscillating;
mod overdamped;

use critical::Critical;
use grid::{BlockFactors, FactorRow, TimeGrid};
use oscillating::Oscillating;
use overdamped::Overdamped;

use super::oscillator::{Oscillator, Regime};
use super::power_of_two::PowerOfTwo;
use super::state::State;
use crate::numerics::{Dd, binary_exponent, scale_by_power_of_two};

/// The free motion of an oscillator from an initial state,
///
/// ```text
/// m x'' + c x' + k x = 0,   x(0) = x0,   x'(0) = v0
/// ```
///
/// with times in s. Errors stay below 1e-15 of the local scale, the magnitude of the terms that sum up to the motion,
/// for any damping ratio and any time; products of time and natural frequency up to 1e300 are in the domain.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{FreeResponse, Oscillator, State};
///
/// let oscillator = Oscillator::new(1.0, 0.0, 4.0)?;
/// let motion = FreeResponse::of(&oscillator, State { position: 0.1, velocity: 0.0 });
/// assert!((motion.position(std::f64::consts::PI) - 0.1).abs() < 1e-16);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FreeResponse {
    initial: State,
    motion: ScaledMotion,
    units: MotionUnits,
}

/// The scaled motion, by regime.
#[derive(Clone, Copy, Debug)]
enum ScaledMotion {
    Oscillating(Oscillating),
    Critical(Critical),
    Overdamped(Overdamped),
}

/// Exact changes of scale between the caller's numbers and the scaled motion.
#[derive(Clone, Copy, Debug)]
struct MotionUnits {
    time: PowerOfTwo,
    position: PowerOfTwo,
    velocity: PowerOfTwo,
}

/// Exponents below this are lifted by [`LIFT`], so that a large amplitude can decay through the whole range of numbers.
// e^-600 is 3e-261: products with the factors of a motion still have all digits.
const LOWEST_EXPONENT: f64 = -600.0;
/// How far exponents are lifted: by 1024 factors of two.
const LIFT: i32 = 1024;
/// Scaled times are kept below this, that phases stay finite.
const MAX_SCALED_TIME: f64 = 1e300;

impl FreeResponse {
    /// The motion of an oscillator from an initial state in m and m/s.
    #[inline]
    pub fn of(oscillator: &Oscillator, initial: State) -> Self {
        let scaled = oscillator.scaled();
        let (units, state) = MotionUnits::of(initial, scaled.rate_exponent);
        let discriminant = scaled.discriminant();
        let root = scaled.root_of(discriminant);
        let motion = match scaled.regime(discriminant) {
            Regime::Undamped | Regime::Underdamped => {
                ScaledMotion::Oscillating(Oscillating::of(scaled, root, state))
            }
            Regime::Critical => ScaledMotion::Critical(Critical::of(scaled, state)),
            Regime::Overdamped => ScaledMotion::Overdamped(Overdamped::of(scaled, root, state)),
        };
        Self {
            initial,
            motion,
            units,
        }
    }

    /// The motion `q'' + c q' + k q = 0` for coefficients of any sign: also rigid motion, and motion that grows.
    pub(crate) fn of_mode(damping: Dd, stiffness: Dd, initial: State) -> Self {
        let rate_exponent = mode::rate_exponent(damping, stiffness);
        let (units, state) = MotionUnits::of(initial, rate_exponent);
        let motion = mode::motion(
            damping.scale(-rate_exponent),
            stiffness.scale(-2 * rate_exponent),
            state,
        );
        Self {
            initial,
            motion,
            units,
        }
    }

    /// State at time zero.
    pub const fn initial(&self) -> State {
        self.initial
    }

    /// Position in m at a time in s.
    pub fn position(&self, time: f64) -> f64 {
        if time == 0.0 {
            return self.initial.position;
        }
        let t = self.units.scaled_time(time);
        if self.motion.exponent(t) < LOWEST_EXPONENT {
            self.units
                .position
                .times(-LIFT)
                .apply(self.motion.position::<true>(t))
        } else {
            self.units.position.apply(self.motion.position::<false>(t))
        }
    }

    /// Position in m and velocity in m/s at a time in s.
    pub fn state(&self, time: f64) -> State {
        if time == 0.0 {
            return self.initial;
        }
        let t = self.units.scaled_time(time);
        if self.motion.exponent(t) < LOWEST_EXPONENT {
            self.units.lowered().state(self.motion.state::<true>(t))
        } else {
            self.units.state(self.motion.state::<false>(t))
        }
    }

    /// Envelope A e^(-λt) in m of an oscillating motion at a time in s.
    ///
    /// None if the motion does not oscillate.
    pub fn envelope(&self, time: f64) -> Option<f64> {
        match &self.motion {
            ScaledMotion::Oscillating(motion) => {
                let (amplitude, _) = motion.amplitude_and_phase();
                let decay = motion.envelope::<false>(self.units.scaled_time(time));
                Some(self.units.position.apply(amplitude * decay))
            }
            ScaledMotion::Critical(_) | ScaledMotion::Overdamped(_) => None,
        }
    }

    /// Amplitude A and phase angle φ of an oscillating motion, x = A e^(-λt) cos(ω_d t - φ), in m and rad.
    ///
    /// None if the motion does not oscillate.
    pub fn amplitude_and_phase(&self) -> Option<(f64, f64)> {
        match &self.motion {
            ScaledMotion::Oscillating(motion) => {
                let (amplitude, phase) = motion.amplitude_and_phase();
                Some((self.units.position.apply(amplitude), phase))
            }
            ScaledMotion::Critical(_) | ScaledMotion::Overdamped(_) => None,
        }
    }

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

impl MotionUnits {
    /// The units for rates near 2^rate_exponent in 1/s, and the initial state in them.
    #[inline]
    fn of(initial: State, rate_exponent: i32) -> (Self, State) {
        let position_exponent = binary_exponent(initial.position);
        let velocity_exponent = binary_exponent(initial.velocity).saturating_sub(rate_exponent);
        let exponent = match position_exponent.max(velocity_exponent) {
            // What lies beyond are the marks of zero and of infinity, which have no exponent.
            exponent @ -4000..=4000 => exponent,
            _ => 0,
        };
        let units = Self {
            time: PowerOfTwo::new(rate_exponent),
            position: PowerOfTwo::new(exponent),
            velocity: PowerOfTwo::new(exponent + rate_exponent),
        };
        let state = State {
            position: scale_by_power_of_two(initial.position, -exponent),
            velocity: scale_by_power_of_two(initial.velocity, -exponent - rate_exponent),
        };
        (units, state)
    }

    fn scaled_time(&self, time: f64) -> f64 {
        self.time
            .apply(time)
            .clamp(-MAX_SCALED_TIME, MAX_SCALED_TIME)
    }

    fn state(&self, scaled: State) -> State {
        State {
            position: self.position.apply(scaled.position),
            velocity: self.velocity.apply(scaled.velocity),
        }
    }

    /// The units of a motion whose exponents were lifted.
    fn lowered(self) -> Self {
        Self {
            time: self.time,
            position: self.position.times(-LIFT),
            velocity: self.velocity.times(-LIFT),
        }
    }
}

impl ScaledMotion {
    /// Exponent of the term that decays slowest.
    #[inline]
    fn exponent(&self, t: f64) -> f64 {
        match self {
            Self::Oscillating(motion) => motion.exponent(t),
            Self::Critical(motion) => motion.exponent(t),
            Self::Overdamped(motion) => motion.exponent(t),
        }
    }

    #[inline]
    fn position<const LIFTED: bool>(&self, t: f64) -> f64 {
        match self {
            Self::Oscillating(motion) => motion.position::<LIFTED>(t),
            Self::Critical(motion) => motion.position::<LIFTED>(t),
            Self::Overdamped(motion) => motion.position::<LIFTED>(t),
        }
    }

    #[inline]
    fn state<const LIFTED: bool>(&self, t: f64) -> State {
        match self {
            Self::Oscillating(motion) => motion.state::<LIFTED>(t),
            Self::Critical(motion) => motion.state::<LIFTED>(t),
            Self::Overdamped(motion) => motion.state::<LIFTED>(t),
        }
    }

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

/// The exponential of a product of rate and time.
#[inline]
fn decay<const LIFTED: bool>(exponent: Dd) -> f64 {
    if LIFTED {
        (exponent + Dd::LN_2 * f64::from(LIFT)).exp_to_f64()
    } else {
        exponent.exp_to_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(m: f64, c: f64, k: f64, position: f64, velocity: f64) -> FreeResponse {
        FreeResponse::of(
            &Oscillator::new(m, c, k).unwrap(),
            State { position, velocity },
        )
    }

    #[test]
    fn amplitude_and_phase_describe_the_motion() {
        let response = motion(2.0, 0.5, 9.0, 0.3, -0.7);
        let (amplitude, phase) = response.amplitude_and_phase().unwrap();
        assert!((amplitude * crate::numerics::cos(phase) - 0.3).abs() < 1e-15);
        assert!(
            motion(1.0, 2.0, 1.0, 1.0, 0.0)
                .amplitude_and_phase()
                .is_none()
        );
    }

    #[test]
    fn a_large_amplitude_decays_through_the_whole_range() {
        let response = motion(0.5, 1.0, 1e-9, 1e300, -1e300);
        let fast = motion(0.5, 1.0, 0.5, 1e300, -1e300);
        assert!(response.position(1.0).is_finite());
        assert!(
            (fast.position(740.0)
                / crate::numerics::exp(-700.0)
                / crate::numerics::exp(-40.0)
                / 1e300
                - 1.0)
                .abs()
                < 1e-13
        );
        assert_eq!(fast.position(1e200), 0.0);
    }

    #[test]
    fn rest_stays_at_rest() {
        for c in [0.0, 1.0, 2.0, 3.0] {
            let response = motion(1.0, c, 1.0, 0.0, 0.0);
            assert_eq!(
                response.state(3.0),
                State {
                    position: 0.0,
                    velocity: 0.0
                }
            );
        }
    }

    #[test]
    fn time_zero_gives_the_initial_state() {
        let response = motion(1.0, 1e12, 1.0, 0.1, 1e-300);
        assert_eq!(
            response.state(0.0),
            State {
                position: 0.1,
                velocity: 1e-300
            }
        );
    }
}
