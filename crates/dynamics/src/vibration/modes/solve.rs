//! From a system to its modes: the choice of the method.

use nalgebra::DMatrix;

use super::chain::Chain;
use super::mass_root::MassRoot;
use super::system::{Inertia, Link, Stiffness, System};
use super::{Modes, ModesError, Refined, matrices, network};
use crate::numerics::Dd;
use crate::numerics::jacobi::{LeftSingular, dot};

/// Rates in ascending order and mass-weighted orthonormal shapes.
pub(crate) struct ModalBasis {
    pub(crate) rates: Vec<f64>,
    pub(crate) vectors: Vec<f64>,
}

pub(crate) fn modes(system: System) -> Result<Modes, ModesError> {
    let system = with_springs_recognized(system);
    let (root, solution) = match (&system.inertia, &system.stiffness) {
        (Inertia::Masses(masses), Stiffness::Springs(springs)) if are_attractive(springs) => (
            MassRoot::of_masses(masses),
            network::solve(masses, springs)?,
        ),
        _ => matrices::solve(&system)?,
    };
    if !(are_finite(&solution.rates) && are_finite(&solution.vectors)) {
        return Err(ModesError::OutOfRange);
    }
    let ModalBasis { rates, vectors } = solution;
    let mut modes = Modes {
        system,
        root,
        rates,
        vectors,
    };
    refine_spread(&mut modes);
    Ok(modes)
}

/// Whether all values are finite.
fn are_finite(values: &[f64]) -> bool {
    values.iter().all(|x| x.is_finite())
}

/// Takes refined modes for small systems where plain ones would lose digits: frequencies of networks too far apart for
/// plain Rayleigh quotients, and all of matrices whose frequencies are spread or whose motion grows.
///
/// Larger systems may lose more, and refining them takes longer.
fn refine_spread(modes: &mut Modes) {
    // A product of two matrices of double-doubles then has 4,096 terms, and a correction takes three of
    // them.
    const SMALL: usize = 16;
    // The eigenvalues, squares of these rates, then spread by 900: a matrix has lost three digits of the
    // smallest.
    const SPREAD: f64 = 30.0;
    if modes.count() > SMALL {
        return;
    }
    let is_network =
        matches!(&modes.system.stiffness, Stiffness::Springs(springs) if are_attractive(springs));
    // Two masses come from a closed form that was rounded once.
    if is_network && modes.count() > 2 && network::are_spread(&modes.rates) {
        let refined = modes.refined();
        take_rates(modes, &refined);
    }
    let magnitudes = || {
        modes
            .rates
            .iter()
            .map(|rate| rate.abs())
            .filter(|rate| *rate > 0.0)
    };
    let smallest = magnitudes().fold(f64::INFINITY, f64::min);
    let is_spread = magnitudes().fold(0.0, f64::max) > SPREAD * smallest;
    // Rotations leave each eigenvalue of a matrix off by the last digit of the largest; its entries,
    // taken as exact, determine more. A network is eliminated without that loss.
    if !is_network && (is_spread || modes.is_unstable()) {
        let refined = modes.fully_refined();
        if refined.is_finite() {
            take_all(modes, &refined);
        }
    }
}

fn take_rates(modes: &mut Modes, refined: &Refined) {
    for (mode, rate) in modes.rates.iter_mut().enumerate() {
        // Squares of extreme frequencies leave the range of numbers, and the refined ones with them.
        let refined = refined.rate(mode);
        if (refined - *rate).abs() <= 1e-12 * *rate {
            *rate = refined;
        }
    }
}

fn take_all(modes: &mut Modes, refined: &Refined) {
    modes.rates = (0..modes.count()).map(|mode| refined.rate(mode)).collect();
    modes.vectors = (0..modes.count())
        .flat_map(|mode| modes.root.weighted(&refined.mode_shape(mode)))
        .collect();
}

/// Natural angular frequencies alone, ascending, in rad/s.
///
/// Chains of masses take `O(n²)` operations.
///
/// # Errors
///
/// Those of [`Modes::of`]; [`ModesError::OutOfRange`] for an unstable system, which has growth rates instead.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::modes::{Link, System, natural_angular_frequencies};
///
/// let springs = [Link::to_ground(1, 2.0), Link::between(1, 2, 2.0)];
/// let frequencies = natural_angular_frequencies(&System::of_network(&[2.0, 1.0], &springs)?)?;
/// assert!((frequencies[0] * frequencies[1] - 2.0_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
pub fn natural_angular_frequencies(system: &System) -> Result<Vec<f64>, ModesError> {
    if let (Inertia::Masses(masses), Stiffness::Springs(springs)) =
        (&system.inertia, &system.stiffness)
        && are_attractive(springs)
        && let Some(chain) = Chain::of(masses, springs)
        && let Some(frequencies) = chain.natural_angular_frequencies()
    {
        return Ok(frequencies);
    }
    let modes = modes(system.clone())?;
    (0..modes.count())
        .map(|mode| {
            modes
                .natural_angular_frequency(mode)
                .ok_or(ModesError::OutOfRange)
        })
        .collect()
}

fn are_attractive(springs: &[Link]) -> bool {
    springs.iter().all(|spring| spring.coefficient >= 0.0)
}

/// Squares that are those of springs between point masses become springs.
fn with_springs_recognized(system: System) -> System {
    let System { inertia, stiffness } = system;
    let stiffness = match (&inertia, stiffness) {
        (Inertia::Masses(_), Stiffness::Squares { stiffnesses, rows }) => {
            match springs_of(&stiffnesses, &rows) {
                Some(springs) => Stiffness::Springs(springs),
                None => Stiffness::Squares { stiffnesses, rows },
            }
        }
        (_, other) => other,
    };
    System { inertia, stiffness }
}

/// The springs of squares whose rows are those of elongations, times a factor that changes no digit.
fn springs_of(stiffnesses: &[f64], rows: &DMatrix<f64>) -> Option<Vec<Link>> {
    stiffnesses
        .iter()
        .enumerate()
        .map(|(s, &stiffness)| {
            let row = rows.row(s);
            let mut occupied = row.iter().enumerate().filter(|(_, b)| **b != 0.0);
            let (first, &factor) = occupied.next()?;
            let ends = match (occupied.next(), occupied.next()) {
                (None, _) => [first + 1, 0],
                (Some((second, &other)), None) if other == -factor => [first + 1, second + 1],
                _ => return None,
            };
            let coefficient = Dd::product(factor, factor) * stiffness;
            // A coefficient that had to be rounded would make another system of it.
            (coefficient.lo() == 0.0).then(|| Link {
                ends,
                coefficient: coefficient.hi(),
            })
        })
        .collect()
}

/// Puts rigid motions before the elastic ones: those given, or else whatever is orthogonal to the elastic ones.
pub(crate) fn completed(
    size: usize,
    elastic: LeftSingular,
    rigid: impl FnOnce() -> Vec<Vec<f64>>,
) -> ModalBasis {
    let LeftSingular {
        mut values,
        mut vectors,
    } = elastic;
    let missing = size - values.len();
    if missing > 0 {
        let rigid = rigid();
        // An underflow may leave more motions without stiffness than there are free parts.
        let first = if rigid.len() == missing {
            rigid.concat()
        } else {
            complement(size, &vectors)
        };
        vectors.splice(0..0, first);
        values.splice(0..0, std::iter::repeat_n(0.0, missing));
    }
    ModalBasis {
        rates: values,
        vectors,
    }
}

/// Unit vectors that complete orthonormal ones to a basis, by repeated Gram-Schmidt steps on the coordinate axes.
fn complement(size: usize, given: &[f64]) -> Vec<f64> {
    let mut basis = given.to_vec();
    while basis.len() < size * size {
        let reach = |axis: usize| {
            basis
                .chunks_exact(size)
                .map(|v| v[axis] * v[axis])
                .sum::<f64>()
        };
        // The axis that is farthest from what is spanned: least of it is taken away, so that what is left is
        // no rounding.
        let axis = (0..size)
            .min_by(|&i, &j| reach(i).total_cmp(&reach(j)))
            .unwrap_or_default();
        let mut vector = vec![0.0; size];
        vector[axis] = 1.0;
        // The second pass takes out what the rounding of the first one left; a third finds nothing.
        for _ in 0..2 {
            for other in basis.chunks_exact(size) {
                let overlap = dot(&vector, other);
                vector
                    .iter_mut()
                    .zip(other)
                    .for_each(|(x, y)| *x -= overlap * y);
            }
        }
        let length = dot(&vector, &vector).sqrt();
        basis.extend(vector.iter().map(|x| x / length));
    }
    basis.split_off(given.len())
}
