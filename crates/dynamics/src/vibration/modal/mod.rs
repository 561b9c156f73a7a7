//! Time response of several degrees of freedom.
//!
//! [`ModalResponse`] is the free motion `M x'' + C x' + K x = 0` from an initial state. Where damping leaves the modes
//! uncoupled, each of them moves by the closed form of one degree of freedom with frequencies of thirty digits, so that the
//! error does not grow with time; where it does not, the matrix exponential moves the modal state.
//! [`ForcedModalResponse`] is the motion under a harmonic force from an initial state, [`HarmonicResponse`] its steady state.
//!
//! Absent on purpose: complex modes, which do not exist for every damping matrix.

mod classical;
mod damping;
mod forced;
mod steady;
mod viscous;

pub use damping::Damping;
pub use forced::{ForcedModalResponse, HarmonicForces};
pub use steady::HarmonicResponse;

use nalgebra::DMatrix;

use super::modes::{Modes, ModesError, Refined, momenta};
use super::state::State;
use crate::numerics::Dd;
use crate::numerics::exponential::{Propagator, PropagatorError};
use classical::Classical;
use viscous::Viscous;

/// The free motion of a system of several degrees of freedom from an initial state.
///
/// # Examples
///
/// Two equal masses between walls, weakly coupled; the motion has gone over to the second one after half a beat.
///
/// ```
/// use vibank_dynamics::vibration::modal::{Damping, ModalResponse};
/// use vibank_dynamics::vibration::modes::{Link, Modes};
///
/// let springs = [Link::to_ground(1, 1.0), Link::between(1, 2, 0.01), Link::to_ground(2, 1.0)];
/// let modes = Modes::of_network(&[1.0, 1.0], &springs)?;
/// let half_beat = std::f64::consts::PI / modes.refined().angular_frequency_difference(0, 1);
/// let motion = ModalResponse::of(&modes, &Damping::none(), &[1.0, 0.0], &[0.0, 0.0], half_beat)?;
/// let mut displacements = [0.0; 2];
/// motion.displacements(half_beat, &mut displacements)?;
/// assert!(displacements[0].abs() < 1e-13);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
#[derive(Debug, Clone)]
pub struct ModalResponse {
    displacements: Vec<f64>,
    velocities: Vec<f64>,
    horizon: f64,
    motion: ModalMotion,
}

#[derive(Debug, Clone)]
enum ModalMotion {
    Classical(Classical),
    Viscous(Box<Viscous>),
}

/// Modes and initial values, these times the mass matrix.
struct Initial<'a> {
    modes: &'a Refined,
    displacements: Vec<Dd>,
    velocities: Vec<Dd>,
}

impl<'a> Initial<'a> {
    fn of(
        modes: &'a Modes,
        refined: &'a Refined,
        displacements: &[f64],
        velocities: &[f64],
    ) -> Self {
        let weighted = |vector: &[f64]| {
            let vector: Vec<Dd> = vector.iter().copied().map(Dd::from).collect();
            momenta(modes.system(), &vector)
        };
        Self {
            modes: refined,
            displacements: weighted(displacements),
            velocities: weighted(velocities),
        }
    }

    /// `q_r = φ_rᵀ M x` and its velocity; most coordinates start from rest.
    fn modal_state(&self, mode: usize) -> State {
        let part = |vector: &[Dd]| {
            let pairs = self.modes.shape(mode).iter().zip(vector);
            // Most textbook systems are displaced at one mass, and a product of double-doubles takes twenty
            // operations.
            let moved = pairs.filter(|(_, y)| y.hi() != 0.0);
            moved.map(|(x, y)| *x * *y).sum::<Dd>().hi()
        };
        State {
            position: part(&self.displacements),
            velocity: part(&self.velocities),
        }
    }
}

impl ModalResponse {
    /// The motion from displacements in m and velocities in m/s, for times from zero up to a horizon in s.
    ///
    /// # Errors
    ///
    /// Vectors that do not fit or are not finite, a negative horizon, damping that does not fit the system.
    pub fn of(
        modes: &Modes,
        damping: &Damping,
        displacements: &[f64],
        velocities: &[f64],
        horizon: f64,
    ) -> Result<Self, ModesError> {
        check_vectors(modes, &[displacements, velocities])?;
        check_time(horizon, f64::INFINITY)?;
        damping.check(modes.count())?;
        let refined = modes.refined();
        let motion = if let Some(dampings) = uncoupled(&damping.in_modes(&refined)) {
            let initial = Initial::of(modes, &refined, displacements, velocities);
            ModalMotion::Classical(Classical::of(&initial, &dampings))
        } else {
            let refined = modes.fully_refined();
            let initial = Initial::of(modes, &refined, displacements, velocities);
            let damping = damping.in_modes(&refined);
            ModalMotion::Viscous(Box::new(Viscous::of(&initial, &damping, horizon)?))
        };
        Ok(Self {
            displacements: displacements.to_vec(),
            velocities: velocities.to_vec(),
            horizon,
            motion,
        })
    }

    /// Whether damping leaves the modes uncoupled, `C M⁻¹ K = K M⁻¹ C`.
    pub fn is_classically_damped(&self) -> bool {
        matches!(self.motion, ModalMotion::Classical(_))
    }

    /// Displacements in m and velocities in m/s at a time in s.
    ///
    /// # Errors
    ///
    /// Slices that do not fit; a time that is negative or beyond the horizon.
    pub fn state(
        &self,
        time: f64,
        displacements: &mut [f64],
        velocities: &mut [f64],
    ) -> Result<(), ModesError> {
        self.check_length(displacements.len())?;
        self.check_length(velocities.len())?;
        check_time(time, self.horizon)?;
        if time == 0.0 {
            // The sum over the modes would give the start back with a rounding.
            displacements.copy_from_slice(&self.displacements);
            velocities.copy_from_slice(&self.velocities);
            return Ok(());
        }
        match &self.motion {
            ModalMotion::Classical(motion) => motion.state(time, displacements, velocities),
            ModalMotion::Viscous(motion) => motion.state(time, displacements, velocities),
        }
        Ok(())
    }

    /// Displacements in m at a time in s.
    ///
    /// # Errors
    ///
    /// As [`ModalResponse::state`].
    pub fn displacements(&self, time: f64, displacements: &mut [f64]) -> Result<(), ModesError> {
        self.check_length(displacements.len())?;
        check_time(time, self.horizon)?;
        if time == 0.0 {
            displacements.copy_from_slice(&self.displacements);
            return Ok(());
        }
        match &self.motion {
            ModalMotion::Classical(motion) => motion.displacements(time, displacements),
            ModalMotion::Viscous(motion) => motion.state(time, displacements, &mut []),
        }
        Ok(())
    }

    /// Displacements in m at the times start, start + step, ... in s: all of the first time, then all of the second, ....
    ///
    /// # Errors
    ///
    /// A slice whose length is no multiple of the degrees of freedom; times that are negative or beyond the horizon.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::modal::{Damping, ModalResponse};
    /// use vibank_dynamics::vibration::modes::{Link, Modes};
    ///
    /// let modes = Modes::of_network(&[1.0, 1.0], &[Link::to_ground(1, 4.0), Link::between(1, 2, 2.0)])?;
    /// let motion = ModalResponse::of(&modes, &Damping::rayleigh(0.1, 0.0), &[0.0, 1.0], &[0.0, 0.0], 10.0)?;
    /// let (mut grid, mut sample) = ([0.0; 202], [0.0; 2]);
    /// motion.grid(0.0, 0.1, &mut grid)?;
    /// motion.displacements(10.0, &mut sample)?;
    /// assert!((grid[200] - sample[0]).abs() < 1e-14 && (grid[201] - sample[1]).abs() < 1e-14);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn grid(&self, start: f64, step: f64, displacements: &mut [f64]) -> Result<(), ModesError> {
        let size = self.displacements.len();
        if !displacements.len().is_multiple_of(size) {
            return Err(ModesError::Length {
                length: displacements.len(),
                size,
            });
        }
        let intervals = (displacements.len() / size).saturating_sub(1) as f64;
        // A step that is the horizon over a number of intervals may come out a rounding beyond it at the end.
        let rounding = 1.0 + 4.0 * f64::EPSILON;
        check_time(start, self.horizon)?;
        check_time(step, self.horizon * rounding)?;
        check_time(start + step * intervals, self.horizon * rounding)?;
        match &self.motion {
            ModalMotion::Classical(motion) => motion.grid(start, step, displacements),
            ModalMotion::Viscous(motion) => motion.grid(start, step, displacements),
        }
        Ok(())
    }

    /// Modal displacement and velocity of one mode at a time in s; none if damping couples the modes, or there is no such mode.
    pub fn modal_state(&self, mode: usize, time: f64) -> Option<State> {
        match &self.motion {
            ModalMotion::Classical(motion) if mode < self.displacements.len() => {
                Some(motion.modal_state(mode, time))
            }
            _ => None,
        }
    }

    fn check_length(&self, length: usize) -> Result<(), ModesError> {
        let size = self.displacements.len();
        if length == size {
            Ok(())
        } else {
            Err(ModesError::Length { length, size })
        }
    }
}

fn check_vectors(modes: &Modes, vectors: &[&[f64]]) -> Result<(), ModesError> {
    for vector in vectors {
        modes.check_length(vector)?;
        if vector.iter().any(|x| !x.is_finite()) {
            return Err(ModesError::NotFinite);
        }
    }
    Ok(())
}

fn check_time(time: f64, horizon: f64) -> Result<(), ModesError> {
    if time.is_finite() && (0.0..=horizon).contains(&time) {
        Ok(())
    } else {
        Err(ModesError::Time { time, horizon })
    }
}

/// The modal damping coefficients, if no pair of modes is coupled by more than the rounding of the data.
fn uncoupled(damping: &DMatrix<Dd>) -> Option<Vec<Dd>> {
    // What shapes of thirty digits leave of the largest coefficient between modes that are hardly damped at
    // all: there the unit of the pair is next to nothing.
    const ROUNDING: f64 = 1e-28;
    let size = damping.nrows();
    let diagonal: Vec<Dd> = damping.diagonal().iter().copied().collect();
    let largest = diagonal.iter().map(|c| c.hi().abs()).fold(0.0, f64::max);
    let unit = 4.0 * size as f64 * f64::EPSILON;
    let all = (0..size).all(|s| {
        (0..s).all(|r| {
            let pair = (diagonal[r].hi() * diagonal[s].hi()).abs().sqrt();
            damping[(r, s)].hi().abs() <= unit * pair + ROUNDING * largest
        })
    });
    all.then_some(diagonal)
}

/// What moves the states of coupled modes on, up to a horizon in s.
fn propagator(generator: &DMatrix<Dd>, horizon: f64) -> Result<Propagator, ModesError> {
    Propagator::of(generator, horizon).map_err(|error| match error {
        PropagatorError::OutOfRange => ModesError::OutOfRange,
        PropagatorError::TooLong => ModesError::TooLong { horizon },
    })
}
