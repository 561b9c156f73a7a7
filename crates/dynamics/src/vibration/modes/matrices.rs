//! Systems given by matrices, or by springs and squares that do not form a network of attractive springs.

use nalgebra::DMatrix;

use super::mass_root::MassRoot;
use super::solve::{ModalBasis, completed};
use super::system::{Inertia, Stiffness, System};
use super::{ModesError, factor, reduced};
use crate::numerics::cholesky::{Real, cholesky, congruent};
use crate::numerics::symmetric::Symmetric;

/// Largest size whose matrices are factored in double-double arithmetic.
const MAX_EXACT: usize = 64;

pub(crate) fn solve(system: &System) -> Result<(MassRoot, ModalBasis), ModesError> {
    if let Some(solved) = proven(system) {
        return Ok(solved);
    }
    ModesError::refuse_unproven(system.degrees_of_freedom())?;
    if system.degrees_of_freedom() <= MAX_EXACT {
        factored(system, &system.exact_stiffness_matrix())
    } else {
        factored(system, &system.stiffness_matrix())
    }
}

/// By reduction to tridiagonal form, if all frequencies are real, not far apart, and proven.
fn proven(system: &System) -> Option<(MassRoot, ModalBasis)> {
    let size = system.degrees_of_freedom();
    let (root, weighted) = weighted(system, &system.stiffness_matrix()).ok()?;
    let solution = reduced::of_weighted(weighted.data.into(), size)?;
    Some((root, solution))
}

/// Matrices: Cholesky of M, then pivoted Cholesky of `L⁻¹ K L⁻ᵀ` and its singular values;
/// two-sided rotations if that is indefinite.
fn factored<T: Real>(
    system: &System,
    stiffness: &DMatrix<T>,
) -> Result<(MassRoot, ModalBasis), ModesError> {
    let size = system.degrees_of_freedom();
    let (root, weighted) = weighted(system, stiffness)?;
    let floor = rounding_floor(system, &weighted);
    let solution = match factor::of_matrix(weighted.clone(), &floor) {
        Some(factor) => completed(size, factor.left_singular(), Vec::new),
        None => indefinite(weighted.map(Real::rounded)),
    };
    Ok((root, solution))
}

/// The root `R` of the mass matrix, and `R⁻¹ K R⁻ᵀ`.
fn weighted<T: Real>(
    system: &System,
    stiffness: &DMatrix<T>,
) -> Result<(MassRoot, DMatrix<T>), ModesError> {
    let size = system.degrees_of_freedom();
    let (root, weighted) = match &system.inertia {
        Inertia::Masses(masses) => (MassRoot::of_masses(masses), divided(stiffness, masses)),
        Inertia::Matrix(mass) => {
            let lower = cholesky(&mass.map(T::from), size as f64 * f64::EPSILON / 2.0)
                .ok_or(ModesError::MassNotPositiveDefinite)?;
            let weighted = congruent(&lower, stiffness);
            (MassRoot::Lower(lower.map(Real::rounded)), weighted)
        }
    };
    if weighted.iter().any(|x| !x.rounded().is_finite()) {
        return Err(ModesError::OutOfRange);
    }
    Ok((root, weighted))
}

/// `K_ij / sqrt(m_i m_j)`.
fn divided<T: Real>(stiffness: &DMatrix<T>, masses: &[f64]) -> DMatrix<T> {
    let mut divided = stiffness.clone();
    for (j, second) in masses.iter().enumerate() {
        divided[(j, j)] = stiffness[(j, j)] / T::from(*second);
        for (i, first) in masses.iter().enumerate().skip(j + 1) {
            let entry = stiffness[(i, j)] / (T::from(*first) * T::from(*second)).root();
            divided[(i, j)] = entry;
            divided[(j, i)] = entry;
        }
    }
    divided
}

/// What rounding may leave of a pivot: `n u` of the diagonal for matrices, which come rounded, and nearly nothing for
/// squares, which determine their matrix.
fn rounding_floor<T: Real>(system: &System, weighted: &DMatrix<T>) -> Vec<f64> {
    let size = system.degrees_of_freedom() as f64;
    let diagonal: Vec<f64> = weighted
        .diagonal()
        .iter()
        .map(|x| x.rounded().abs())
        .collect();
    let largest = diagonal.iter().copied().fold(0.0, f64::max);
    let is_exact = !matches!(system.stiffness, Stiffness::Matrix(_))
        && system.degrees_of_freedom() <= MAX_EXACT;
    let unit = if is_exact { 1e-29 } else { f64::EPSILON / 2.0 };
    let coupled = matches!(system.inertia, Inertia::Matrix(_));
    diagonal
        .into_iter()
        // A mass matrix mixes the entries, so that each bears the rounding of the largest; masses only scale
        // them.
        .map(|entry| size * unit * if coupled { largest } else { entry })
        .collect()
}

/// Eigenvalues of either sign; those that rounding could have made are zero.
fn indefinite(weighted: DMatrix<f64>) -> ModalBasis {
    let size = weighted.nrows() as f64;
    let zero = weighted.amax() * size * f64::EPSILON / 2.0;
    let Symmetric { values, vectors } = Symmetric::of(weighted);
    let rates = values
        .into_iter()
        .map(|value| {
            if value.abs() <= zero {
                0.0
            } else {
                value.abs().sqrt().copysign(value)
            }
        })
        .collect();
    ModalBasis {
        rates,
        vectors: vectors.as_slice().to_vec(),
    }
}
