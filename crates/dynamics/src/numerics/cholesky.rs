//! Cholesky factors and triangular systems, in `f64` or double-double arithmetic.

use std::ops::{Add, Div, Mul, Sub};

use nalgebra::DMatrix;

use super::Dd;

/// The arithmetic of a factorization.
pub(crate) trait Real:
    nalgebra::Scalar
    + Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// Square root.
    fn root(self) -> Self;
    /// The nearest `f64`.
    fn rounded(self) -> f64;
}

impl Real for f64 {
    fn root(self) -> Self {
        self.sqrt()
    }

    fn rounded(self) -> f64 {
        self
    }
}

impl Real for Dd {
    fn root(self) -> Self {
        self.sqrt()
    }

    fn rounded(self) -> f64 {
        self.hi()
    }
}

/// The lower triangular `L` with `L Lᵀ = matrix`; none unless the matrix is positive definite to rounding.
///
/// The matrix counts as singular where a pivot is below `floor` times the entry of the diagonal it comes from.
pub(crate) fn cholesky<T: Real>(matrix: &DMatrix<T>, floor: f64) -> Option<DMatrix<T>> {
    let size = matrix.nrows();
    let mut lower = DMatrix::from_element(size, size, T::from(0.0));
    for j in 0..size {
        let (before, from) = lower.as_mut_slice().split_at_mut(j * size);
        let column = &mut from[j..size];
        column.copy_from_slice(&matrix.as_slice()[j * size + j..(j + 1) * size]);
        for earlier in before.chunks_exact(size) {
            subtract_multiple(column, &earlier[j..], earlier[j]);
        }
        let pivot = column[0];
        let threshold = floor * matrix[(j, j)].rounded();
        if !(pivot.rounded() > threshold && pivot.rounded().is_finite()) {
            return None;
        }
        let root = pivot.root();
        column[0] = root;
        for entry in &mut column[1..] {
            *entry = *entry / root;
        }
    }
    Some(lower)
}

/// `x <- x - factor y`.
fn subtract_multiple<T: Real>(x: &mut [T], y: &[T], factor: T) {
    for (x, y) in x.iter_mut().zip(y) {
        *x = *x - *y * factor;
    }
}

/// Replaces `x` by the solution of `L y = x`.
pub(crate) fn solve_lower<T: Real>(lower: &DMatrix<T>, x: &mut [T]) {
    let size = x.len();
    for (i, column) in lower.as_slice().chunks_exact(size).enumerate() {
        x[i] = x[i] / column[i];
        let factor = x[i];
        subtract_multiple(&mut x[i + 1..], &column[i + 1..], factor);
    }
}

/// Replaces `x` by the solution of `Lᵀ y = x`.
pub(crate) fn solve_lower_transposed<T: Real>(lower: &DMatrix<T>, x: &mut [T]) {
    for i in (0..x.len()).rev() {
        let rest = (i + 1..x.len()).fold(x[i], |sum, k| sum - lower[(k, i)] * x[k]);
        x[i] = rest / lower[(i, i)];
    }
}

/// `L⁻¹ A L⁻ᵀ` of a symmetric matrix.
pub(crate) fn congruent<T: Real>(lower: &DMatrix<T>, matrix: &DMatrix<T>) -> DMatrix<T> {
    let half = solved_columns(lower, matrix).transpose();
    let full = solved_columns(lower, &half);
    // Rounding leaves both halves of the result different; rotations rely on their being the same.
    let two = T::from(2.0);
    DMatrix::from_fn(full.nrows(), full.ncols(), |i, j| {
        (full[(i, j)] + full[(j, i)]) / two
    })
}

fn solved_columns<T: Real>(lower: &DMatrix<T>, matrix: &DMatrix<T>) -> DMatrix<T> {
    let mut solved = matrix.clone();
    for column in solved.as_mut_slice().chunks_exact_mut(matrix.nrows()) {
        solve_lower(lower, column);
    }
    solved
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factor_times_transpose_is_the_matrix() {
        let matrix = DMatrix::from_row_slice(3, 3, &[4.0, 2.0, 2.0, 2.0, 5.0, 3.0, 2.0, 3.0, 6.0]);
        let lower = cholesky(&matrix, 0.0).expect("the matrix is positive definite");
        assert!((&lower * lower.transpose() - matrix).abs().max() < 1e-15);
    }

    #[test]
    fn indefinite_and_singular_matrices_have_no_factor() {
        for entries in [
            [1.0, 2.0, 2.0, 1.0],
            [1.0, 1.0, 1.0, 1.0],
            [-1.0, 0.0, 0.0, 1.0],
        ] {
            assert!(cholesky(&DMatrix::from_row_slice(2, 2, &entries), 1e-15).is_none());
        }
    }

    #[test]
    fn congruence_divides_by_both_factors() {
        let lower = DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 1.0, 4.0]);
        let inner = DMatrix::from_row_slice(2, 2, &[3.0, -1.0, -1.0, 2.0]);
        let outer = &lower * &inner * lower.transpose();
        assert!((congruent(&lower, &outer) - inner).abs().max() < 1e-15);
    }
}
