//! Matrices about the equilibrium, and the modes they give.

use nalgebra::{DMatrix, DVector};

use super::{Numbers, Unavailable};
use crate::expr::Value;
use crate::vibration::modes::{Modes, System};

/// M, C and K as numbers.
#[derive(Clone, Debug)]
pub(crate) struct Matrices {
    pub(crate) mass: Value,
    pub(crate) damping: Value,
    pub(crate) stiffness: Value,
}

/// Stiffnesses, and the rows of what they are squares of.
type Squares = (Vec<f64>, DMatrix<f64>);

impl Numbers {
    /// The mass matrix, by rows.
    ///
    /// # Errors
    ///
    /// [`Unavailable::TimeVarying`], [`Unavailable::NoEquilibrium`], or a number that is missing.
    pub fn mass_matrix(&self) -> Result<&Value, Unavailable> {
        Ok(&self.matrices()?.mass)
    }

    /// The damping matrix, by rows.
    ///
    /// # Errors
    ///
    /// As for [`Self::mass_matrix`].
    pub fn damping_matrix(&self) -> Result<&Value, Unavailable> {
        Ok(&self.matrices()?.damping)
    }

    /// The stiffness matrix, by rows.
    ///
    /// # Errors
    ///
    /// As for [`Self::mass_matrix`].
    pub fn stiffness_matrix(&self) -> Result<&Value, Unavailable> {
        Ok(&self.matrices()?.stiffness)
    }

    /// The modes of the undamped model. Where the potential energy is written as a sum of squares, the
    /// solver gets those.
    ///
    /// # Errors
    ///
    /// As for [`Self::mass_matrix`], and [`Unavailable::Modes`].
    pub fn modes(&self) -> Result<&Modes, Unavailable> {
        let modes = self.modes.get_or_init(|| Ok(Modes::of(self.system()?)?));
        modes.as_ref().map_err(Clone::clone)
    }

    pub(crate) fn matrices(&self) -> Result<&Matrices, Unavailable> {
        let matrices = self.matrices.get_or_init(|| self.evaluated_matrices());
        matrices.as_ref().map_err(Clone::clone)
    }

    fn evaluated_matrices(&self) -> Result<Matrices, Unavailable> {
        let tangent = self.model.evaluation.tangent()?;
        Ok(Matrices {
            mass: self.value_at_rest(&tangent.mass)?,
            damping: self.value_at_rest(&tangent.damping)?,
            stiffness: self.value_at_rest(&tangent.stiffness)?,
        })
    }

    pub(crate) fn system(&self) -> Result<System, Unavailable> {
        let matrices = self.matrices()?;
        let mass = self.square(&matrices.mass);
        if let Some((stiffnesses, rows)) = self.squares()? {
            return Ok(System::of_squares(&mass, &rows, &stiffnesses)?);
        }
        Ok(System::of_matrices(
            &mass,
            &self.square(&matrices.stiffness),
        )?)
    }

    /// A matrix of the size of the model.
    pub(crate) fn square(&self, value: &Value) -> DMatrix<f64> {
        let size = self.model.degrees_of_freedom();
        DMatrix::from_row_slice(size, size, value.numbers())
    }

    /// The stiffnesses and rows of the squares of V, if it is written so and none is negative.
    fn squares(&self) -> Result<Option<Squares>, Unavailable> {
        let Some(squares) = self.model.squares() else {
            return Ok(None);
        };
        let size = self.model.degrees_of_freedom();
        let value = self.value(squares, &[])?;
        let rows = value.numbers().chunks_exact(size + 1);
        let stiffnesses: Vec<f64> = rows.clone().map(|row| 2.0 * row[0]).collect();
        if stiffnesses.iter().any(|stiffness| *stiffness < 0.0) {
            return Ok(None);
        }
        let entries = rows.flat_map(|row| row[1..].iter().copied());
        let rows = DMatrix::from_row_iterator(stiffnesses.len(), size, entries);
        let weights = DMatrix::from_diagonal(&DVector::from_column_slice(&stiffnesses));
        let sum = rows.transpose() * weights * &rows;
        let given = self.square(self.stiffness_matrix()?);
        // Moving frames and forces that depend on position add to the stiffness what is not in V.
        let is_all = (sum - &given).amax() <= 1e-12 * given.amax();
        Ok(is_all.then_some((stiffnesses, rows)))
    }
}
