//! Complex linear systems by elimination with row pivoting, refined by residuals in double-double arithmetic.
//!
//! # References
//!
//! Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., chapter 12.

use nalgebra::DMatrix;

use super::{Complex, Dd};

/// A matrix `R + i I` with exact entries, and its factors.
#[derive(Debug, Clone)]
pub(crate) struct ComplexSystem {
    real: DMatrix<Dd>,
    imaginary: DMatrix<Dd>,
    /// Unit lower and upper triangle of the matrix with permuted rows.
    factors: DMatrix<Complex>,
    rows: Vec<usize>,
}

impl ComplexSystem {
    /// Factors the matrix; none if a pivot is zero.
    pub(crate) fn of(real: DMatrix<Dd>, imaginary: DMatrix<Dd>) -> Option<Self> {
        let size = real.nrows();
        let mut factors = real.zip_map(&imaginary, |re, im| Complex::new(re.hi(), im.hi()));
        let scales: Vec<f64> = (0..size)
            .map(|i| {
                factors
                    .row(i)
                    .iter()
                    .map(|z| magnitude(*z))
                    .fold(0.0, f64::max)
            })
            .collect();
        let mut rows: Vec<usize> = (0..size).collect();
        for k in 0..size {
            // Rows may be equations in different units: an entry is large beside the others of its row.
            let weight = |i: usize| magnitude(factors[(i, k)]) / scales[rows[i]];
            let pivot =
                (k..size).max_by(|&i, &j| weight(i).total_cmp(&weight(j)).then(j.cmp(&i)))?;
            factors.swap_rows(k, pivot);
            rows.swap(k, pivot);
            if factors[(k, k)] == Complex::ZERO || !factors[(k, k)].is_finite() {
                return None;
            }
            for i in k + 1..size {
                let share = factors[(i, k)] / factors[(k, k)];
                factors[(i, k)] = share;
                for j in k + 1..size {
                    factors[(i, j)] = factors[(i, j)] - share * factors[(k, j)];
                }
            }
        }
        Some(Self {
            real,
            imaginary,
            factors,
            rows,
        })
    }

    /// The solution, refined until its last digits stand; entries that are not finite mean that the matrix is singular.
    pub(crate) fn solve(&self, right: &[Complex]) -> Vec<Complex> {
        // Where a dozen steps do not settle the digits, a step gains hardly one, and more of them would not
        // help.
        const MAX_STEPS: usize = 12;
        let exact = |z: &Complex| (Dd::from(z.re), Dd::from(z.im));
        let mut solution: Vec<(Dd, Dd)> = self.substituted(right).iter().map(exact).collect();
        for _ in 0..MAX_STEPS {
            let steps = self.substituted(&self.residual(right, &solution));
            let is_last = steps.iter().zip(&solution).all(|(step, (re, im))| {
                magnitude(*step) <= f64::EPSILON / 64.0 * (re.hi().abs() + im.hi().abs())
            });
            for ((re, im), step) in solution.iter_mut().zip(steps) {
                *re += step.re;
                *im += step.im;
            }
            if is_last {
                break;
            }
        }
        solution
            .into_iter()
            .map(|(re, im)| Complex::new(re.hi(), im.hi()))
            .collect()
    }

    fn substituted(&self, right: &[Complex]) -> Vec<Complex> {
        let size = right.len();
        let mut x: Vec<Complex> = self.rows.iter().map(|&row| right[row]).collect();
        for i in 0..size {
            x[i] = (0..i).fold(x[i], |sum, k| sum - self.factors[(i, k)] * x[k]);
        }
        for i in (0..size).rev() {
            let rest = (i + 1..size).fold(x[i], |sum, k| sum - self.factors[(i, k)] * x[k]);
            x[i] = rest / self.factors[(i, i)];
        }
        x
    }

    fn residual(&self, right: &[Complex], solution: &[(Dd, Dd)]) -> Vec<Complex> {
        right
            .iter()
            .enumerate()
            .map(|(i, right)| {
                let start = (Dd::from(right.re), Dd::from(right.im));
                let (re, im) = solution
                    .iter()
                    .enumerate()
                    .fold(start, |(re, im), (j, (x, y))| {
                        let (a, b) = (self.real[(i, j)], self.imaginary[(i, j)]);
                        (re - (a * *x - b * *y), im - (a * *y + b * *x))
                    });
                Complex::new(re.hi(), im.hi())
            })
            .collect()
    }
}

/// Sum of the magnitudes of both parts.
fn magnitude(z: Complex) -> f64 {
    z.re.abs() + z.im.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refinement_solves_an_ill_conditioned_system() {
        // The Hilbert matrix of order 8 times 1 + i has a condition number of 1.5e10.
        let hilbert = DMatrix::from_fn(8, 8, |i, j| 360_360.0 / (i + j + 1) as f64).map(Dd::from);
        let system = ComplexSystem::of(hilbert.clone(), hilbert.clone()).unwrap();
        let right: Vec<Complex> = (0..8)
            .map(|i| {
                Complex::new(
                    0.0,
                    2.0 * (0..8).fold(Dd::ZERO, |sum, j| sum + hilbert[(i, j)]).hi(),
                )
            })
            .collect();
        for entry in system.solve(&right) {
            assert!((entry - Complex::new(1.0, 1.0)).abs() < 1e-15, "{entry:?}");
        }
    }

    #[test]
    fn singular_matrices_are_refused() {
        let one = DMatrix::from_element(2, 2, Dd::ONE);
        assert!(ComplexSystem::of(one.clone(), one).is_none());
    }
}
