//! The whole motion under a harmonic force, from an initial state.

use nalgebra::{DMatrix, DVector};

use super::viscous::{generator, weights};
use super::{Damping, Initial, check_time, check_vectors, propagator, uncoupled};
use crate::numerics::Dd;
use crate::numerics::exponential::Propagator;
use crate::vibration::modes::{Modes, ModesError, Refined};
use crate::vibration::{ForcedResponse, HarmonicForce};

/// Forces `a cos Ωt + b sin Ωt` in N on all coordinates, with one angular frequency in rad/s.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::modal::HarmonicForces;
///
/// // 10 N on the first of two masses, at 3 rad/s.
/// let forces = HarmonicForces { cosine: &[10.0, 0.0], sine: &[0.0, 0.0], angular_frequency: 3.0 };
/// assert_eq!(forces.cosine.len(), 2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicForces<'a> {
    /// Factors of the cosine.
    pub cosine: &'a [f64],
    /// Factors of the sine.
    pub sine: &'a [f64],
    /// Angular frequency of the excitation in rad/s.
    pub angular_frequency: f64,
}

/// The motion of a system of several degrees of freedom under harmonic forces,
///
/// ```text
/// M x'' + C x' + K x = a cos Ωt + b sin Ωt,   x(0) = x0,   x'(0) = v0
/// ```
///
/// Modes that stay uncoupled are driven one by one, each by its part `φᵀ a`, `φᵀ b` of the force; otherwise, and where there
/// are rigid or growing modes, the force becomes two more components of the state that the matrix exponential moves.
///
/// # Examples
///
/// From rest at the lower resonance of two equal masses: the mode in phase grows linearly, the other one does not move.
///
/// ```
/// use vibank_dynamics::vibration::modal::{Damping, ForcedModalResponse, HarmonicForces};
/// use vibank_dynamics::vibration::modes::{Link, Modes};
///
/// let springs = [Link::to_ground(1, 4.0), Link::between(1, 2, 1.0), Link::to_ground(2, 4.0)];
/// let modes = Modes::of_network(&[1.0, 1.0], &springs)?;
/// let forces = HarmonicForces { cosine: &[1.0, 1.0], sine: &[0.0, 0.0], angular_frequency: 2.0 };
/// let motion = ForcedModalResponse::of(&modes, &Damping::none(), forces, &[0.0; 2], &[0.0; 2], 1e3)?;
/// let (mut x, mut v) = ([0.0; 2], [0.0; 2]);
/// let time = 100.25 * std::f64::consts::PI;
/// motion.state(time, &mut x, &mut v)?;
/// assert!((x[0] - time / 4.0).abs() < 1e-12 && (x[0] - x[1]).abs() < 1e-13);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
#[derive(Debug, Clone)]
pub struct ForcedModalResponse {
    /// Shapes as columns.
    shapes: DMatrix<f64>,
    horizon: f64,
    motion: ForcedMotion,
}

#[derive(Debug, Clone)]
enum ForcedMotion {
    Modes(Vec<ForcedResponse>),
    Coupled(Box<Coupled>),
}

/// Weighted modal displacements, modal velocities, and the force as two more components.
#[derive(Debug, Clone)]
struct Coupled {
    weights: Vec<f64>,
    propagator: Propagator,
    start: DVector<f64>,
}

impl ForcedModalResponse {
    /// The motion from displacements in m and velocities in m/s, for times from zero up to a horizon in s.
    ///
    /// # Errors
    ///
    /// Vectors that do not fit or are not finite, a negative horizon, damping that does not fit the system.
    pub fn of(
        modes: &Modes,
        damping: &Damping,
        forces: HarmonicForces<'_>,
        displacements: &[f64],
        velocities: &[f64],
        horizon: f64,
    ) -> Result<Self, ModesError> {
        check_vectors(
            modes,
            &[displacements, velocities, forces.cosine, forces.sine],
        )?;
        check_time(horizon, f64::INFINITY)?;
        if !forces.angular_frequency.is_finite() {
            return Err(ModesError::NotFinite);
        }
        damping.check(modes.count())?;
        let mut refined = modes.refined();
        let initial = Initial::of(modes, &refined, displacements, velocities);
        let driven = driven_modes(&initial, &damping.in_modes(&refined), &forces);
        let motion = if let Some(motions) = driven {
            ForcedMotion::Modes(motions)
        } else {
            refined = modes.fully_refined();
            let initial = Initial::of(modes, &refined, displacements, velocities);
            let damping = damping.in_modes(&refined);
            ForcedMotion::Coupled(Box::new(Coupled::of(&initial, &damping, &forces, horizon)?))
        };
        Ok(Self {
            shapes: refined.modal_matrix(),
            horizon,
            motion,
        })
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
        let size = self.shapes.nrows();
        for length in [displacements.len(), velocities.len()] {
            if length != size {
                return Err(ModesError::Length { length, size });
            }
        }
        check_time(time, self.horizon)?;
        displacements.fill(0.0);
        velocities.fill(0.0);
        let modal = self.modal_states(time);
        for (shape, (position, velocity)) in self.shapes.column_iter().zip(modal) {
            for ((x, v), component) in displacements
                .iter_mut()
                .zip(velocities.iter_mut())
                .zip(&shape)
            {
                *x += component * position;
                *v += component * velocity;
            }
        }
        Ok(())
    }

    fn modal_states(&self, time: f64) -> Vec<(f64, f64)> {
        match &self.motion {
            ForcedMotion::Modes(motions) => motions
                .iter()
                .map(|motion| motion.state(time))
                .map(|state| (state.position, state.velocity))
                .collect(),
            ForcedMotion::Coupled(coupled) => {
                let mut state = coupled.start.clone();
                coupled.propagator.advance(&mut state, time);
                let size = coupled.weights.len();
                (0..size)
                    .map(|mode| (state[mode] / coupled.weights[mode], state[size + mode]))
                    .collect()
            }
        }
    }
}

/// `φᵀ f`.
fn modal_force(modes: &Refined, mode: usize, forces: &[f64]) -> Dd {
    modes
        .shape(mode)
        .iter()
        .zip(forces)
        .fold(Dd::ZERO, |sum, (x, force)| sum + *x * *force)
}

/// One forced oscillator a mode, if no two are coupled and all of them are oscillators.
fn driven_modes(
    initial: &Initial<'_>,
    damping: &DMatrix<Dd>,
    forces: &HarmonicForces<'_>,
) -> Option<Vec<ForcedResponse>> {
    let dampings = uncoupled(damping)?;
    let modes = initial.modes;
    (0..modes.count())
        .map(|mode| {
            let force = HarmonicForce {
                cosine: modal_force(modes, mode, forces.cosine).hi(),
                sine: modal_force(modes, mode, forces.sine).hi(),
                angular_frequency: forces.angular_frequency,
            };
            ForcedResponse::of_mode(
                dampings[mode],
                modes.eigenvalue(mode),
                force,
                initial.modal_state(mode),
            )
        })
        .collect()
}

impl Coupled {
    fn of(
        initial: &Initial<'_>,
        damping: &DMatrix<Dd>,
        forces: &HarmonicForces<'_>,
        horizon: f64,
    ) -> Result<Self, ModesError> {
        let weights = weights(initial.modes);
        let size = weights.len();
        let mut matrix = generator(initial.modes, &weights, damping).resize(
            2 * size + 2,
            2 * size + 2,
            Dd::ZERO,
        );
        let parts: Vec<[Dd; 2]> = (0..size)
            .map(|mode| {
                [forces.cosine, forces.sine].map(|side| modal_force(initial.modes, mode, side))
            })
            .collect();
        // In units in which the largest force is as large as the rest of the matrix, the exponential costs no more with it.
        let rate = weights
            .iter()
            .copied()
            .fold(forces.angular_frequency.abs(), f64::max);
        let largest = parts
            .iter()
            .flatten()
            .map(|part| part.hi().abs())
            .fold(0.0, f64::max);
        let unit = if largest > 0.0 { largest / rate } else { 1.0 };
        for (mode, part) in parts.iter().enumerate() {
            matrix[(size + mode, 2 * size)] = part[0] / unit;
            matrix[(size + mode, 2 * size + 1)] = part[1] / unit;
        }
        // A cosine and a sine are the state of an oscillator of their own, so that the exponential moves the
        // force along.
        matrix[(2 * size, 2 * size + 1)] = Dd::from(-forces.angular_frequency);
        matrix[(2 * size + 1, 2 * size)] = Dd::from(forces.angular_frequency);
        let propagator = propagator(&matrix, horizon)?;
        let mut start = DVector::zeros(2 * size + 2);
        for mode in 0..size {
            let state = initial.modal_state(mode);
            start[mode] = weights[mode] * state.position;
            start[size + mode] = state.velocity;
        }
        start[2 * size] = unit;
        Ok(Self {
            weights,
            propagator,
            start,
        })
    }
}
