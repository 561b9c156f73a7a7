//! Symmetric tridiagonal matrices: eigenvalues by the root-free QL algorithm, eigenvectors by twisted factorizations.
//!
//! An eigenvector takes `O(n)` operations, and several are worked out side by side. It is as accurate as its factorization
//! `L D Lᵀ` determines it: the relative distance of its eigenvalue to the others, not the absolute one, says how well.
//! Vectors of close pairs are made orthogonal to rounding; pairs so close that this would take more than a small step are
//! left to methods that rotate.
//!
//! # References
//!
//! Parlett, The Symmetric Eigenvalue Problem, SIAM 1998, section 8.15 (root-free QL). Dhillon, Parlett, SIAM J. Matrix Anal.
//! 25 (2004) 858 (twisted factorizations).

use super::jacobi::dot;

/// Unit roundoff.
const U: f64 = f64::EPSILON / 2.0;

/// Passes allowed for one eigenvalue; fewer than two are needed on average.
const MAX_PASSES: usize = 60;

/// Eigenvalues in ascending order of the symmetric matrix with this diagonal and these entries beside it, each with an error
/// of a few units in the last place of the largest; none if they are not found, which no finite input is known to do.
///
/// The largest entries should be near one in size: their squares are taken.
pub(crate) fn eigenvalues(diagonal: &[f64], off_diagonal: &[f64]) -> Option<Vec<f64>> {
    let mut diagonal = diagonal.to_vec();
    let mut squares: Vec<f64> = off_diagonal.iter().map(|e| e * e).collect();
    let (mut first, mut passes) = (0, 0);
    while first + 1 < diagonal.len() {
        let last = (first..squares.len())
            .find(|&i| {
                let product = (diagonal[i] * diagonal[i + 1]).abs();
                squares[i] <= U * U * product || squares[i] < f64::MIN_POSITIVE
            })
            .unwrap_or(squares.len());
        if let Some(square) = squares.get_mut(last) {
            *square = 0.0;
        }
        if last == first {
            first += 1;
            passes = 0;
        } else if passes == MAX_PASSES {
            return None;
        } else {
            passes += 1;
            pass(&mut diagonal[first..=last], &mut squares[first..last]);
        }
    }
    super::sort_by(&mut diagonal, f64::total_cmp);
    diagonal.iter().all(|x| x.is_finite()).then_some(diagonal)
}

/// Products of two pivots up to this are zero: one of them is too small to turn anything, and where they are larger, squares
/// of what they turn stay in range.
const TINY_PRODUCT: f64 = 1e-200;

/// One pass of the root-free QL algorithm, which makes the first square small.
fn pass(diagonal: &mut [f64], squares: &mut [f64]) {
    let last = squares.len();
    // Wilkinson's shift, the eigenvalue of the first corner next to its first entry; the sign is copied so
    // that nothing cancels in the denominator.
    let root = squares[0].sqrt();
    let ratio = (diagonal[1] - diagonal[0]) / (2.0 * root);
    let length = (ratio * ratio + 1.0).sqrt();
    let shift = diagonal[0] - root / (ratio + length.copysign(ratio));
    let (mut cosine, mut sine) = (1.0, 0.0);
    let mut gamma = diagonal[last] - shift;
    let mut p = gamma * gamma;
    for i in (0..last).rev() {
        let (square, alpha, old) = (squares[i], diagonal[i], gamma);
        let r = p + square;
        if i + 1 < last {
            squares[i + 1] = sine * r;
        }
        let product = p * r;
        if product > TINY_PRODUCT {
            // One quotient, of which the next p waits for no more than a product.
            let inverse = 1.0 / product;
            let difference = p * (alpha - shift) - square * old;
            let over_r = p * inverse;
            cosine = p * over_r;
            sine = square * over_r;
            gamma = difference * over_r;
            p = difference * difference * inverse;
        } else {
            // The limits where the pivot vanished.
            p = cosine * square;
            (cosine, sine) = (0.0, 1.0);
            gamma = -old;
        }
        diagonal[i + 1] = old + (alpha - gamma);
    }
    squares[0] = sine * p;
    diagonal[0] = shift + gamma;
}

/// A matrix `L D Lᵀ`: the diagonal of D, and the entries of L below its diagonal.
#[derive(Debug, Clone)]
pub(crate) struct Factored {
    diagonal: Vec<f64>,
    lower: Vec<f64>,
    /// `d l`.
    couplings: Vec<f64>,
    /// `d l²`.
    squares: Vec<f64>,
}

/// Eigenvalues, and vectors of length one, one after the other.
#[derive(Debug, Clone)]
pub(crate) struct Eigenpairs {
    pub(crate) values: Vec<f64>,
    pub(crate) vectors: Vec<f64>,
}

/// Eigenpairs worked out side by side.
const LANES: usize = 8;

type Lanes = [f64; LANES];

/// Steps allowed to an eigenpair; two or three are needed.
const MAX_STEPS: usize = 8;

/// A pivot that came out zero is this instead.
// Entries are about one, so that their quotients by it stay finite.
const TINY: f64 = 1e-280;

impl Factored {
    pub(crate) fn new(diagonal: Vec<f64>, lower: Vec<f64>) -> Self {
        let couplings: Vec<f64> = diagonal.iter().zip(&lower).map(|(d, l)| d * l).collect();
        let squares = couplings.iter().zip(&lower).map(|(c, l)| c * l).collect();
        Self {
            diagonal,
            lower,
            couplings,
            squares,
        }
    }

    /// The factorization of a tridiagonal matrix less a shift; none unless what is left is positive definite.
    pub(crate) fn of_shifted(diagonal: &[f64], off_diagonal: &[f64], shift: f64) -> Option<Self> {
        let mut pivots = Vec::with_capacity(diagonal.len());
        let mut lower = Vec::with_capacity(off_diagonal.len());
        let mut passed_on = 0.0;
        for (i, d) in diagonal.iter().enumerate() {
            let pivot = (d - shift) - passed_on;
            if pivot.is_nan() || pivot <= 0.0 {
                return None;
            }
            pivots.push(pivot);
            if let Some(e) = off_diagonal.get(i) {
                lower.push(e / pivot);
                passed_on = e * (e / pivot);
            }
        }
        Some(Self::new(pivots, lower))
    }

    /// The tridiagonal matrix: its diagonal, and the entries beside it.
    pub(crate) fn product(&self) -> [Vec<f64>; 2] {
        let passed_on = std::iter::once(&0.0).chain(&self.squares);
        let diagonal = self.diagonal.iter().zip(passed_on);
        [
            diagonal.map(|(d, s)| d + s).collect(),
            self.couplings.clone(),
        ]
    }

    /// The eigenpairs next to approximate eigenvalues, which ascend; none if two come out as one, or so close that their
    /// vectors are not told apart.
    pub(crate) fn eigenpairs(&self, approximate: &[f64]) -> Option<Eigenpairs> {
        let size = self.diagonal.len();
        let mut twisted = Twisted::new(size);
        let mut values = Vec::with_capacity(approximate.len());
        let mut residuals = Vec::with_capacity(approximate.len());
        let mut vectors = vec![0.0; approximate.len() * size];
        let columns = vectors.chunks_mut(LANES * size);
        for (batch, columns) in approximate.chunks(LANES).zip(columns) {
            let found = twisted.improve(self, batch, columns);
            values.extend(found.iter().map(|pair| pair.value));
            residuals.extend(found.iter().map(|pair| pair.residual));
        }
        // Each residual bounds how far its value is from an eigenvalue. Intervals that overlap may hold the
        // same one twice.
        let are_apart = (1..values.len()).all(|i| {
            let rounding = residuals[i] + residuals[i - 1] + 4.0 * U * values[i].abs();
            values[i] - values[i - 1] > rounding
        });
        let mut pairs = Eigenpairs { values, vectors };
        (are_apart && pairs.orthogonalize(size)).then_some(pairs)
    }
}

impl Eigenpairs {
    /// Shares what vectors of close pairs have in common; says whether that took small steps only.
    fn orthogonalize(&mut self, size: usize) -> bool {
        // Two vectors have about u over the relative distance of their eigenvalues in common.
        let close = 4.0 / size as f64;
        /// The square of a step is an error that stays.
        const MAX_STEP: f64 = 1e-8;
        for i in 0..self.values.len() {
            let value = self.values[i];
            let nearest = (0..i)
                .rev()
                .take_while(|&j| value - self.values[j] <= close * value);
            for j in nearest {
                let (before, from) = self.vectors.split_at_mut(i * size);
                let (x, y) = (&mut from[..size], &mut before[j * size..(j + 1) * size]);
                let step = dot(x, y) / 2.0;
                if step.is_nan() || step.abs() > MAX_STEP {
                    return false;
                }
                for (x, y) in x.iter_mut().zip(y) {
                    (*x, *y) = (*x - step * *y, *y - step * *x);
                }
            }
        }
        true
    }
}

/// An eigenvalue, and the length of the residual of its vector.
#[derive(Debug, Clone, Copy, Default)]
struct FoundEigenvalue {
    value: f64,
    residual: f64,
}

/// The factorizations of `L D Lᵀ - λ` from both ends, for several λ.
struct Twisted {
    /// Entries below the diagonal of the factor from the first row on.
    down: Vec<Lanes>,
    /// Entries above the diagonal of the factor from the last row on.
    up: Vec<Lanes>,
    /// What the factorization from the first row adds to each entry of D, but for λ.
    rest: Vec<Lanes>,
    /// For each λ the row where both meet with the smallest pivot, and that pivot.
    row: [usize; LANES],
    pivot: Lanes,
}

impl Twisted {
    fn new(size: usize) -> Self {
        Self {
            down: vec![[0.0; LANES]; size],
            up: vec![[0.0; LANES]; size],
            rest: vec![[0.0; LANES]; size],
            row: [0; LANES],
            pivot: [0.0; LANES],
        }
    }

    /// Steps to the Rayleigh quotient until it stays; as many columns are written as there are values.
    fn improve(
        &mut self,
        matrix: &Factored,
        values: &[f64],
        columns: &mut [f64],
    ) -> Vec<FoundEigenvalue> {
        let size = matrix.diagonal.len();
        let mut lanes: Lanes = std::array::from_fn(|l| *values.get(l).unwrap_or(&values[0]));
        let mut found = vec![FoundEigenvalue::default(); values.len()];
        for _ in 0..MAX_STEPS {
            self.factor(matrix, &lanes);
            let mut is_settled = true;
            for (l, column) in columns.chunks_exact_mut(size).enumerate() {
                let (residual, step) = self.vector(l, column);
                is_settled &= step.abs() <= 4.0 * U * lanes[l].abs();
                lanes[l] += step;
                found[l] = FoundEigenvalue {
                    value: lanes[l],
                    residual,
                };
            }
            if is_settled {
                break;
            }
        }
        found
    }

    /// The stationary transformation from the first row on, the progressive one from the last.
    fn factor(&mut self, matrix: &Factored, values: &Lanes) {
        let last = matrix.diagonal.len() - 1;
        let mut rest: Lanes = [0.0; LANES];
        for i in 0..last {
            let (d, l, coupling) = (matrix.diagonal[i], matrix.lower[i], matrix.couplings[i]);
            self.rest[i] = rest;
            let down = &mut self.down[i];
            for lane in 0..LANES {
                let shifted = rest[lane] - values[lane];
                down[lane] = coupling / not_zero(d + shifted);
                rest[lane] = down[lane] * l * shifted;
            }
        }
        let mut p: Lanes = std::array::from_fn(|lane| matrix.diagonal[last] - values[lane]);
        // An index as a number, so that it is selected as the pivots are, without a branch in each lane.
        let mut row = [last as f64; LANES];
        let mut smallest: Lanes = std::array::from_fn(|lane| rest[lane] + p[lane]);
        for i in (0..last).rev() {
            let (d, l, square) = (matrix.diagonal[i], matrix.lower[i], matrix.squares[i]);
            let (up, rest, index) = (&mut self.up[i], &self.rest[i], i as f64);
            for lane in 0..LANES {
                let share = d / not_zero(square + p[lane]);
                up[lane] = l * share;
                p[lane] = p[lane] * share - values[lane];
                let pivot = rest[lane] + p[lane];
                let is_smaller = pivot.abs() < smallest[lane].abs();
                smallest[lane] = if is_smaller { pivot } else { smallest[lane] };
                row[lane] = if is_smaller { index } else { row[lane] };
            }
        }
        self.row = row.map(|row| row as usize);
        self.pivot = smallest;
    }

    /// Writes the vector of one λ; returns the length of its residual and the step to the Rayleigh quotient.
    fn vector(&self, lane: usize, vector: &mut [f64]) -> (f64, f64) {
        let row = self.row[lane];
        let (above, below) = vector.split_at_mut(row);
        let (mut x, mut square) = (1.0, 1.0);
        for (entry, factor) in above.iter_mut().zip(&self.down).rev() {
            x *= -factor[lane];
            *entry = x;
            square += x * x;
        }
        below[0] = 1.0;
        x = 1.0;
        for (entry, factor) in below[1..].iter_mut().zip(&self.up[row..]) {
            x *= -factor[lane];
            *entry = x;
            square += x * x;
        }
        let inverse = 1.0 / square.sqrt();
        for entry in vector.iter_mut() {
            *entry *= inverse;
        }
        let pivot = self.pivot[lane];
        (pivot.abs() * inverse, pivot * inverse * inverse)
    }
}

fn not_zero(pivot: f64) -> f64 {
    if pivot == 0.0 { TINY } else { pivot }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::sin;

    /// 2 on the diagonal, -1 beside it: eigenvalues `2 - 2 cos(k π/(n+1))`, vectors of sines.
    #[test]
    fn the_second_difference_has_its_closed_form() {
        for size in [1, 2, 3, 7, 8, 9, 60] {
            let (d, e) = (vec![2.0; size], vec![-1.0; size - 1]);
            let turn = std::f64::consts::PI / (size + 1) as f64;
            let approximate = eigenvalues(&d, &e).expect("the passes converge");
            let factored =
                Factored::of_shifted(&d, &e, 0.0).expect("the matrix is positive definite");
            let pairs = factored.eigenpairs(&approximate).expect("no two are close");
            for (k, value) in pairs.values.iter().enumerate() {
                let angle = (k + 1) as f64 * turn;
                let expected = 4.0 * sin(angle / 2.0) * sin(angle / 2.0);
                assert!((approximate[k] - expected).abs() < 4e-15, "{size} {k}");
                assert!((value / expected - 1.0).abs() < 1e-13, "{size} {k}");
                let vector = &pairs.vectors[k * size..][..size];
                let sines: Vec<f64> = (0..size).map(|i| sin((i + 1) as f64 * angle)).collect();
                let overlap = dot(vector, &sines) / dot(&sines, &sines).sqrt();
                assert!((overlap.abs() - 1.0).abs() < 1e-14, "{size} {k}: {overlap}");
            }
            for i in 0..size {
                for j in 0..size {
                    let product = dot(
                        &pairs.vectors[i * size..][..size],
                        &pairs.vectors[j * size..][..size],
                    );
                    let expected = f64::from(u8::from(i == j));
                    assert!((product - expected).abs() < 1e-14, "{size}: {i} {j}");
                }
            }
        }
    }

    #[test]
    fn two_eigenvalues_that_are_one_are_left_to_others() {
        let factored = Factored::of_shifted(&[2.0, 2.0], &[0.0], 1.0).expect("positive definite");
        assert!(factored.eigenpairs(&[1.0, 1.0]).is_none());
        assert!(Factored::of_shifted(&[1.0, 1.0], &[2.0], 0.0).is_none());
    }

    #[test]
    fn parts_and_zeros() {
        assert_eq!(
            eigenvalues(&[3.0, 1.0, 2.0], &[0.0, 0.0]),
            Some(vec![1.0, 2.0, 3.0])
        );
        assert_eq!(eigenvalues(&[0.0, 0.0], &[1.0]), Some(vec![-1.0, 1.0]));
        assert_eq!(eigenvalues(&[], &[]), Some(Vec::new()));
    }
}
