//! Two-sided Jacobi eigenvalues of symmetric matrices, also indefinite ones.
//!
//! # References
//!
//! Golub, Van Loan, Matrix Computations, 4th ed., section 8.5. Demmel, Veselić, SIAM J. Matrix Anal. 13 (1992) 1204.

use nalgebra::DMatrix;

use super::ascending;

/// Eigenvalues in ascending order and orthonormal eigenvectors as columns in the same order.
#[derive(Debug, Clone)]
pub(crate) struct Symmetric {
    /// Eigenvalues in ascending order.
    pub(crate) values: Vec<f64>,
    /// Eigenvectors, one column each.
    pub(crate) vectors: DMatrix<f64>,
}

// More sweeps than any matrix needs: convergence is quadratic from about the fifth on.
const MAX_SWEEPS: usize = 60;

impl Symmetric {
    /// Decomposes a symmetric matrix; the lower triangle is not read.
    pub(crate) fn of(mut matrix: DMatrix<f64>) -> Self {
        let size = matrix.nrows();
        matrix.fill_lower_triangle_with_upper_triangle();
        let mut vectors = DMatrix::identity(size, size);
        for _ in 0..MAX_SWEEPS {
            if !sweep(&mut matrix, &mut vectors) {
                break;
            }
        }
        let order = ascending(size, &|i| matrix[(i, i)]);
        Self {
            values: order.iter().map(|&i| matrix[(i, i)]).collect(),
            vectors: DMatrix::from_fn(size, size, |i, j| vectors[(i, order[j])]),
        }
    }
}

/// Visits each pair once; says whether any was rotated.
fn sweep(matrix: &mut DMatrix<f64>, vectors: &mut DMatrix<f64>) -> bool {
    let mut rotated = false;
    for p in 0..matrix.nrows() {
        for q in p + 1..matrix.nrows() {
            let (first, second, coupling) = (matrix[(p, p)], matrix[(q, q)], matrix[(p, q)]);
            // Beside both, so that a small eigenvalue keeps the digits that its entries determine.
            let negligible = f64::EPSILON / 8.0 * (first.abs() * second.abs()).sqrt();
            if coupling.abs() <= negligible || is_swallowed(coupling, first, second) {
                continue;
            }
            rotated = true;
            let half = (second - first) / 2.0;
            let root = (half * half + coupling * coupling).sqrt();
            let tangent = coupling / (half + if half < 0.0 { -root } else { root });
            let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
            let sine = cosine * tangent;
            mix_columns(matrix, p, q, cosine, sine);
            mix_rows(matrix, p, q, cosine, sine);
            mix_columns(vectors, p, q, cosine, sine);
            matrix[(p, p)] = first - tangent * coupling;
            matrix[(q, q)] = second + tangent * coupling;
            matrix[(p, q)] = 0.0;
            matrix[(q, p)] = 0.0;
        }
    }
    rotated
}

/// Whether the rotation would change neither entry of the diagonal: one of them is zero or nearly so.
fn is_swallowed(coupling: f64, first: f64, second: f64) -> bool {
    let larger = first.abs().max(second.abs());
    coupling.abs() <= f64::MIN_POSITIVE || coupling.abs() <= f64::EPSILON * f64::EPSILON * larger
}

fn mix_columns(matrix: &mut DMatrix<f64>, p: usize, q: usize, cosine: f64, sine: f64) {
    for i in 0..matrix.nrows() {
        let (x, y) = (matrix[(i, p)], matrix[(i, q)]);
        matrix[(i, p)] = cosine * x - sine * y;
        matrix[(i, q)] = cosine * y + sine * x;
    }
}

fn mix_rows(matrix: &mut DMatrix<f64>, p: usize, q: usize, cosine: f64, sine: f64) {
    for i in 0..matrix.ncols() {
        let (x, y) = (matrix[(p, i)], matrix[(q, i)]);
        matrix[(p, i)] = cosine * x - sine * y;
        matrix[(q, i)] = cosine * y + sine * x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indefinite_matrices_are_restored_from_their_decomposition() {
        let matrix = DMatrix::from_fn(5, 5, |i, j| {
            1.0 / (1.0 + i as f64 + j as f64) - if i == j { 0.4 } else { 0.0 }
        });
        let Symmetric { values, vectors } = Symmetric::of(matrix.clone());
        let diagonal = DMatrix::from_diagonal(&nalgebra::DVector::from_vec(values.clone()));
        assert!(
            (&vectors * diagonal * vectors.transpose() - &matrix)
                .abs()
                .max()
                < 1e-15
        );
        assert!(values.is_sorted() && values[0] < 0.0 && values[4] > 0.0);
    }

    #[test]
    fn zeros_stay_zeros() {
        assert_eq!(Symmetric::of(DMatrix::zeros(3, 3)).values, [0.0; 3]);
        assert_eq!(
            Symmetric::of(DMatrix::from_row_slice(2, 2, &[0.0, 2.0, 2.0, 0.0])).values,
            [-2.0, 2.0]
        );
    }
}
