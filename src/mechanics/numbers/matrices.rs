//! Matrices about the equilibrium, and the modes they give.

use nalgebra::{DMatrix, DVector};

use super::{Numbers, Unavailable};
use crate::expr::Value;
use crate::vibration::modes::System;

/// M, C and K as numbers.
#[derive(Clone, Debug)]
pub(crate) struct Matrices {
    pub(crate) mass: Value,
    pub(crate) damping: Value,
    pub(crate) stiffness: Value,
}

/// Stiffnesses, and the rows of what they are squares of.
type Squares = (Vec<f64>, DMatrix<f64>);

pub(crate) fn evaluated(numbers: &Numbers) -> Result<Matrices, Unavailable> {
    let tangent = numbers.model.evaluation.tangent()?;
    Ok(Matrices {
        mass: numbers.value_at_rest(&tangent.mass)?,
        damping: numbers.value_at_rest(&tangent.damping)?,
        stiffness: numbers.value_at_rest(&tangent.stiffness)?,
    })
}

pub(crate) fn system(numbers: &Numbers) -> Result<System, Unavailable> {
    let matrices = numbers.matrices()?;
    let mass = square(numbers, &matrices.mass);
    if let Some((stiffnesses, rows)) = squares(numbers)? {
        return Ok(System::of_squares(&mass, &rows, &stiffnesses)?);
    }
    Ok(System::of_matrices(
        &mass,
        &square(numbers, &matrices.stiffness),
    )?)
}

/// A matrix of the size of the model.
pub(crate) fn square(numbers: &Numbers, value: &Value) -> DMatrix<f64> {
    let size = numbers.model.degrees_of_freedom();
    DMatrix::from_row_slice(size, size, value.numbers())
}

/// The stiffnesses and rows of the squares of V, if it is written so and none is negative.
fn squares(numbers: &Numbers) -> Result<Option<Squares>, Unavailable> {
    let Some(squares) = numbers.model.squares() else {
        return Ok(None);
    };
    let size = numbers.model.degrees_of_freedom();
    let value = numbers.value(squares, &[])?;
    let rows = value.numbers().chunks_exact(size + 1);
    let stiffnesses: Vec<f64> = rows.clone().map(|row| 2.0 * row[0]).collect();
    if stiffnesses.iter().any(|stiffness| *stiffness < 0.0) {
        return Ok(None);
    }
    let entries = rows.flat_map(|row| row[1..].iter().copied());
    let rows = DMatrix::from_row_iterator(stiffnesses.len(), size, entries);
    let weights = DMatrix::from_diagonal(&DVector::from_column_slice(&stiffnesses));
    let sum = rows.transpose() * weights * &rows;
    let given = square(numbers, numbers.stiffness_matrix()?);
    // Moving frames and forces that depend on position add to the stiffness what is not in V.
    let is_all = (sum - &given).amax() <= 1e-12 * given.amax();
    Ok(is_all.then_some((stiffnesses, rows)))
}
