//! Several coordinates: modes, and motions as sums over them.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::excitation::HarmonicLoad;
use super::{Motion, Numbers, Unavailable, matrices};
use crate::expr::{Field, Form, Shape, Value};
use crate::numerics::sin_cos;
use crate::vibration::State;
use crate::vibration::modal::{Damping, ForcedModalResponse, HarmonicForces, ModalResponse};
use crate::vibration::modes::Modes;

/// Two frequencies count as equal within this part of them.
// Frequencies that are equal by symmetry come out equal to some 1e-15.
const SAME_FREQUENCY: f64 = 1e-9;

/// Damping couples two modes if its entry between them exceeds this part of their own.
// Rounding leaves some 1e-15 of a damping that does not couple them.
const COUPLED: f64 = 1e-10;

/// Motions of many periods are answered up to this number of the slowest one.
// By then a phase has lost seven of its sixteen digits.
const MAX_PERIODS: f64 = 1e6;

/// The motion of one coordinate of several.
#[derive(Clone, Debug)]
pub(crate) struct ModalMotion {
    response: Arc<Response>,
    coordinate: usize,
}

/// The motion of all coordinates from the initial state.
#[derive(Debug)]
pub(crate) struct Response {
    position: Vec<f64>,
    free: Option<ModalResponse>,
    /// The harmonic forces and the motion under each; the first one bears the initial state.
    forced: Vec<(HarmonicLoad, ForcedModalResponse)>,
    damping: DMatrix<f64>,
    stiffness: DMatrix<f64>,
    inverse_mass: DMatrix<f64>,
}

impl ModalMotion {
    pub(crate) fn at(&self, order: u8, time: f64) -> Option<f64> {
        let (displacements, velocities) = self.response.state(time)?;
        match order {
            0 => Some(self.response.position[self.coordinate] + displacements[self.coordinate]),
            1 => Some(velocities[self.coordinate]),
            2 => {
                let forces = self.response.forces(&displacements, &velocities, time);
                Some((self.response.inverse_mass.row(self.coordinate) * forces)[0])
            }
            _ => None,
        }
    }
}

impl Response {
    /// Displacements from the equilibrium, and velocities.
    fn state(&self, time: f64) -> Option<(DVector<f64>, DVector<f64>)> {
        let size = self.position.len();
        let (mut x, mut v) = (DVector::zeros(size), DVector::zeros(size));
        let (mut part_x, mut part_v) = (vec![0.0; size], vec![0.0; size]);
        let mut add = |part_x: &[f64], part_v: &[f64]| {
            x += DVector::from_column_slice(part_x);
            v += DVector::from_column_slice(part_v);
        };
        if let Some(free) = &self.free {
            free.state(time, &mut part_x, &mut part_v).ok()?;
            add(&part_x, &part_v);
        }
        for (_, forced) in &self.forced {
            forced.state(time, &mut part_x, &mut part_v).ok()?;
            add(&part_x, &part_v);
        }
        Some((x, v))
    }

    /// What accelerates: the exciting forces less those of dampers and springs.
    fn forces(&self, x: &DVector<f64>, v: &DVector<f64>, time: f64) -> DVector<f64> {
        let mut forces = -(&self.damping * v) - &self.stiffness * x;
        for (harmonic, _) in &self.forced {
            let (sine, cosine) = sin_cos(harmonic.frequency * time);
            forces += DVector::from_column_slice(&harmonic.cosine) * cosine;
            forces += DVector::from_column_slice(&harmonic.sine) * sine;
        }
        forces
    }
}

/// The natural angular frequencies, ascending.
///
/// # Errors
///
/// [`Unavailable::Unstable`] if one does not exist, and those of [`Numbers::modes`].
pub(crate) fn natural_angular_frequencies(numbers: &Numbers) -> Result<Value, Unavailable> {
    let modes = numbers.modes()?;
    let frequencies: Vec<_> = (0..modes.count())
        .map(|mode| {
            modes
                .natural_angular_frequency(mode)
                .ok_or(Unavailable::Unstable)
        })
        .collect::<Result<_, _>>()?;
    vector(frequencies)
}

/// How often each natural angular frequency occurs, in their order.
///
/// # Errors
///
/// Those of [`Numbers::modes`].
pub(crate) fn multiplicities(numbers: &Numbers) -> Result<Value, Unavailable> {
    let clusters = numbers.modes()?.clusters(SAME_FREQUENCY);
    let counts = clusters
        .into_iter()
        .flat_map(|own| vec![own.len() as f64; own.len()]);
    vector(counts.collect())
}

/// The mass-normalized mode shapes by rows, the first nonzero component of each positive.
///
/// # Errors
///
/// Those of [`Numbers::modes`].
pub(crate) fn mode_shapes(numbers: &Numbers) -> Result<Value, Unavailable> {
    let modes = numbers.modes()?;
    let size = modes.count();
    matrix(
        size,
        (0..size).flat_map(|mode| modes.mode_shape(mode)).collect(),
    )
}

/// The modal masses `uᵀ M u` of the shapes with their first nonzero component 1.
///
/// # Errors
///
/// Those of [`Numbers::modes`].
pub(crate) fn masses(numbers: &Numbers) -> Result<Value, Unavailable> {
    let modes = numbers.modes()?;
    vector(
        (0..modes.count())
            .map(|mode| {
                let shape = modes.mode_shape(mode);
                let largest = shape
                    .iter()
                    .fold(0.0, |largest: f64, own| largest.max(own.abs()));
                // A node that rounding has moved off zero must not become the unit of the shape.
                let first = shape.iter().find(|own| own.abs() > 1e-12 * largest);
                first.map_or(f64::NAN, |first| 1.0 / (first * first))
            })
            .collect(),
    )
}

/// The damping ratios of the modes.
///
/// # Errors
///
/// [`Unavailable::CoupledDamping`], [`Unavailable::Unstable`], and those of [`Numbers::modes`].
pub(crate) fn damping_ratios(numbers: &Numbers) -> Result<Value, Unavailable> {
    let modes = numbers.modes()?;
    let dampings = dampings(numbers)?.into_iter().enumerate();
    let ratios = dampings.map(|(mode, damping)| {
        let frequency = modes
            .natural_angular_frequency(mode)
            .ok_or(Unavailable::Unstable)?;
        match (damping == 0.0, frequency == 0.0) {
            (true, _) => Ok(0.0),
            (false, true) => Err(Unavailable::Singular),
            (false, false) => Ok(damping / (2.0 * frequency)),
        }
    });
    vector(ratios.collect::<Result<_, _>>()?)
}

/// The factors of cos ω_r t and sin ω_r t of each modal coordinate in the free motion, by rows.
///
/// # Errors
///
/// [`Unavailable::Unstable`], and those of [`Numbers::modes`].
pub(crate) fn amplitudes(numbers: &Numbers) -> Result<Value, Unavailable> {
    let modes = numbers.modes()?;
    let states = modal_start(numbers, modes)?.into_iter().enumerate();
    let rows: Vec<[f64; 2]> = states
        .map(|(mode, state)| {
            let frequency = modes
                .natural_angular_frequency(mode)
                .ok_or(Unavailable::Unstable)?;
            // A rigid motion has a velocity in place of the factor of the sine.
            let sine = if frequency == 0.0 {
                state.velocity
            } else {
                state.velocity / frequency
            };
            Ok([state.position, sine])
        })
        .collect::<Result<_, Unavailable>>()?;
    matrix(2, rows.into_flattened())
}

/// The motion of a coordinate among several.
pub(crate) fn motion(numbers: &Numbers, coordinate: usize) -> Result<Motion, Unavailable> {
    let response = numbers
        .response
        .get_or_init(|| response(numbers).map(Arc::new));
    Ok(Motion::of_modes(ModalMotion {
        response: response.clone()?,
        coordinate,
    }))
}

fn response(numbers: &Numbers) -> Result<Response, Unavailable> {
    let modes = numbers.modes()?;
    let slowest = (0..modes.count()).filter_map(|mode| modes.natural_angular_frequency(mode));
    let slowest = slowest
        .filter(|rate| *rate > 0.0)
        .fold(f64::INFINITY, f64::min);
    let horizon = if slowest.is_finite() {
        MAX_PERIODS * TAU / slowest
    } else {
        MAX_PERIODS
    };
    let (displacements, velocities) = displaced_start(numbers)?;
    let damping = damping(numbers)?;
    let still = vec![0.0; displacements.len()];
    let mut forced = Vec::new();
    for (at, harmonic) in numbers.excitation()?.iter().enumerate() {
        let forces = HarmonicForces {
            cosine: &harmonic.cosine,
            sine: &harmonic.sine,
            angular_frequency: harmonic.frequency,
        };
        let start = if at == 0 {
            [&displacements, &velocities]
        } else {
            [&still, &still]
        };
        let [x, v] = start;
        let motion = ForcedModalResponse::of(modes, &damping, forces, x, v, horizon)?;
        forced.push((harmonic.clone(), motion));
    }
    let free = if forced.is_empty() {
        Some(ModalResponse::of(
            modes,
            &damping,
            &displacements,
            &velocities,
            horizon,
        )?)
    } else {
        None
    };
    let matrices = numbers.matrices()?;
    let mass = matrices::square(numbers, &matrices.mass);
    Ok(Response {
        position: numbers.equilibrium()?.to_vec(),
        free,
        forced,
        damping: matrices::square(numbers, &matrices.damping),
        stiffness: matrices::square(numbers, &matrices.stiffness),
        inverse_mass: mass.try_inverse().ok_or(Unavailable::Singular)?,
    })
}

/// The damping for the solver.
pub(crate) fn damping(numbers: &Numbers) -> Result<Damping, Unavailable> {
    let value = numbers.damping_matrix()?;
    Ok(if value.numbers().iter().all(|own| *own == 0.0) {
        Damping::none()
    } else {
        Damping::of_matrix(&matrices::square(numbers, value))
    })
}

/// Displacements from the equilibrium, and velocities, at the start.
fn displaced_start(numbers: &Numbers) -> Result<(Vec<f64>, Vec<f64>), Unavailable> {
    let start = numbers.start()?;
    let displaced = start.iter().zip(numbers.equilibrium()?);
    let displacements = displaced.map(|(own, rest)| own.position - rest).collect();
    Ok((
        displacements,
        start.iter().map(|own| own.velocity).collect(),
    ))
}

/// Modal positions and velocities at the start.
fn modal_start(numbers: &Numbers, modes: &Modes) -> Result<Vec<State>, Unavailable> {
    let (positions, velocities) = displaced_start(numbers)?;
    let positions = modes.modal_coordinates(&positions)?;
    let velocities = modes.modal_coordinates(&velocities)?;
    let pairs = positions.into_iter().zip(velocities);
    Ok(pairs
        .map(|(position, velocity)| State { position, velocity })
        .collect())
}

/// The diagonal of `Φᵀ C Φ`, if that is diagonal.
pub(crate) fn dampings(numbers: &Numbers) -> Result<Vec<f64>, Unavailable> {
    let modes = numbers.modes()?;
    let size = modes.count();
    let damping =
        nalgebra::DMatrix::from_row_slice(size, size, numbers.damping_matrix()?.numbers());
    let shapes = modes.modal_matrix();
    let modal = shapes.transpose() * damping * shapes;
    for row in 0..size {
        for column in 0..row {
            let own = modal[(row, row)].abs().max(modal[(column, column)].abs());
            if modal[(row, column)].abs() > COUPLED * own {
                return Err(Unavailable::CoupledDamping);
            }
        }
    }
    Ok(modal.diagonal().as_slice().to_vec())
}

/// A list of numbers that are good to a few units in the last place.
fn vector(numbers: Vec<f64>) -> Result<Value, Unavailable> {
    let shape = Shape::Vector(numbers.len());
    real(shape, numbers)
}

/// Rows of numbers that are good to a few units in the last place of the largest.
fn matrix(columns: usize, numbers: Vec<f64>) -> Result<Value, Unavailable> {
    let shape = Shape::Matrix(numbers.len() / columns.max(1), columns);
    real(shape, numbers)
}

fn real(shape: Shape, numbers: Vec<f64>) -> Result<Value, Unavailable> {
    let largest = numbers
        .iter()
        .fold(0.0, |largest: f64, own| largest.max(own.abs()));
    let bounds = vec![16.0 * f64::EPSILON * largest; numbers.len()];
    let form = Form {
        field: Field::Real,
        shape,
    };
    Value::new(form, numbers, bounds).ok_or(Unavailable::Singular)
}
