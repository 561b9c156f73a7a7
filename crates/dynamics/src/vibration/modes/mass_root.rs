//! The root of the mass matrix: coordinates in which the kinetic energy is `1/2 |y'|²`.

use nalgebra::DMatrix;

use crate::numerics::cholesky::solve_lower_transposed;

/// `R` with `M = R Rᵀ`: mass-weighted coordinates are `y = Rᵀ q`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum MassRoot {
    /// Square roots of point masses.
    Diagonal(Vec<f64>),
    /// The Cholesky factor of a mass matrix.
    Lower(DMatrix<f64>),
}

impl MassRoot {
    pub(crate) fn of_masses(masses: &[f64]) -> Self {
        Self::Diagonal(masses.iter().map(|m| m.sqrt()).collect())
    }

    /// `y = Rᵀ q`.
    pub(crate) fn weighted(&self, shape: &[f64]) -> Vec<f64> {
        match self {
            Self::Diagonal(roots) => shape.iter().zip(roots).map(|(x, root)| x * root).collect(),
            Self::Lower(lower) => (0..shape.len())
                .map(|j| (j..shape.len()).map(|i| lower[(i, j)] * shape[i]).sum())
                .collect(),
        }
    }

    /// `q = R⁻ᵀ y`.
    pub(crate) fn unweighted(&self, weighted: &[f64]) -> Vec<f64> {
        let mut shape = weighted.to_vec();
        match self {
            Self::Diagonal(roots) => shape.iter_mut().zip(roots).for_each(|(x, root)| *x /= root),
            Self::Lower(lower) => solve_lower_transposed(lower, &mut shape),
        }
        shape
    }
}
