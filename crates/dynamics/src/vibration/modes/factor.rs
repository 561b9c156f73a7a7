//! Factors `F` with `F Fᵀ = M^(-1/2) K M^(-1/2)`, whose singular values are the natural angular frequencies.
//!
//! For a network, `K` is eliminated by additions alone (Grassmann, Taksar and Heyman): it is kept as its off-diagonal
//! couplings and the springs to the ground, and its diagonal is their sum. No digit is ever lost,
//! so the factor knows the smallest frequency as well as the largest.
//!
//! # References
//!
//! Alfa, Xue, Ye, Math. Comp. 71 (2002) 217. O'Cinneide, Numer. Math. 65 (1993) 109. Ye, Math. Comp. 77 (2008) 2195.

use nalgebra::DMatrix;

use super::system::Link;
use crate::numerics::cholesky::Real;
use crate::numerics::jacobi::ScaledColumns;
use crate::numerics::{binary_exponent, scale_by_power_of_two};

/// The factor of a network of springs that are not negative. Columns are missing where a part is free: rigid modes.
pub(crate) fn of_network(masses: &[f64], springs: &[Link]) -> ScaledColumns {
    let mut elimination = Elimination::of(masses, springs);
    let mut entries = Vec::with_capacity(masses.len() * masses.len());
    let mut scales = Vec::with_capacity(masses.len());
    while let Some(pivot) = elimination.take_pivot() {
        elimination.eliminate(&pivot, &mut entries);
        scales.push(elimination.scale(&pivot));
    }
    ScaledColumns::new(masses.len(), entries, scales)
}

/// A network from which nodes are taken one after the other.
struct Elimination<'a> {
    masses: &'a [f64],
    /// Couplings between the nodes that are left, a symmetric matrix with an unused diagonal.
    couplings: Vec<f64>,
    ground: Vec<f64>,
    left: Vec<usize>,
    /// Stiffnesses are kept times 2^-exponent, so that their sums stay finite.
    exponent: i32,
}

struct Pivot {
    node: usize,
    diagonal: f64,
}

impl<'a> Elimination<'a> {
    fn of(masses: &'a [f64], springs: &[Link]) -> Self {
        let size = masses.len();
        let exponent = excess_exponent(springs);
        let mut couplings = vec![0.0; size * size];
        let mut ground = vec![0.0; size];
        for spring in springs {
            let stiffness = if exponent == 0 {
                spring.coefficient
            } else {
                scale_by_power_of_two(spring.coefficient, -exponent)
            };
            match spring.ends {
                [0, node] | [node, 0] => ground[node - 1] += stiffness,
                [first, second] => {
                    couplings[(first - 1) * size + second - 1] += stiffness;
                    couplings[(second - 1) * size + first - 1] += stiffness;
                }
            }
        }
        let left = (0..size).collect();
        Self {
            masses,
            couplings,
            ground,
            left,
            exponent,
        }
    }

    /// Takes out the node with the largest ratio of stiffness to mass; none if all that are left are free and alone.
    fn take_pivot(&mut self) -> Option<Pivot> {
        let mut best: Option<(usize, f64, f64)> = None;
        for (position, &node) in self.left.iter().enumerate() {
            let row = &self.couplings[node * self.masses.len()..][..self.masses.len()];
            // Summed anew for each pivot: keeping it up to date would subtract.
            let diagonal = self.ground[node] + self.left.iter().map(|&j| row[j]).sum::<f64>();
            let ratio = diagonal / self.masses[node];
            // The largest first leaves columns that are well conditioned once they are scaled, on which the
            // relative accuracy of the rotations depends.
            if diagonal > 0.0 && best.is_none_or(|(_, _, largest)| ratio > largest) {
                best = Some((position, diagonal, ratio));
            }
        }
        let (position, diagonal, _) = best?;
        let node = self.left.remove(position);
        Some(Pivot { node, diagonal })
    }

    /// Appends the pivot's column and adds what its node passed on to its neighbours.
    fn eliminate(&mut self, pivot: &Pivot, entries: &mut Vec<f64>) {
        let size = self.masses.len();
        let start = entries.len();
        entries.resize(start + size, 0.0);
        let column = &mut entries[start..];
        column[pivot.node] = 1.0;
        let row_of = |node: usize| node * size..(node + 1) * size;
        for &j in &self.left {
            let [row, target] = self
                .couplings
                .get_disjoint_mut([row_of(pivot.node), row_of(j)])
                .expect("the rows of two nodes do not overlap");
            let share = row[j] / pivot.diagonal;
            if share == 0.0 {
                continue;
            }
            column[j] = -share * root_of_ratio(self.masses[pivot.node], self.masses[j]);
            self.ground[j] += share * self.ground[pivot.node];
            for &i in &self.left {
                target[i] += share * row[i];
            }
            target[j] = 0.0;
        }
    }

    fn scale(&self, pivot: &Pivot) -> f64 {
        let half = self.exponent / 2;
        scale_by_power_of_two(root_of_ratio(pivot.diagonal, self.masses[pivot.node]), half)
    }
}

/// An even power of two that brings large stiffnesses down to where sums of them are finite.
fn excess_exponent(springs: &[Link]) -> i32 {
    let largest = springs
        .iter()
        .map(|spring| spring.coefficient)
        .fold(0.0, f64::max);
    // Sums of a hundred thousand smaller ones are finite.
    if largest > 1e280 {
        // Even, so that its root is a power of two, which rounds nothing.
        binary_exponent(largest) / 2 * 2
    } else {
        0
    }
}

/// `sqrt(a/b)`, also where the quotient leaves the range. Common factors and squares of powers of two change no bit.
pub(crate) fn root_of_ratio(a: f64, b: f64) -> f64 {
    let quotient = a / b;
    if quotient == 0.0 || (1e-290..1e290).contains(&quotient) {
        return quotient.sqrt();
    }
    let shift = (binary_exponent(a) - binary_exponent(b)) / 2 * 2;
    let half = shift / 2;
    let quotient = scale_by_power_of_two(a, -half) / scale_by_power_of_two(b, shift - half);
    scale_by_power_of_two(quotient.sqrt(), half)
}

/// The pivoted Cholesky factor of a positive semi-definite matrix; none if it is indefinite.
///
/// A remainder of the diagonal below `floor` is rounding, and zero.
///
/// # References
///
/// Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 10.3.
pub(crate) fn of_matrix<T: Real>(mut rest: DMatrix<T>, floor: &[f64]) -> Option<ScaledColumns> {
    let size = rest.nrows();
    let mut left: Vec<usize> = (0..size).collect();
    let (mut entries, mut scales) = (Vec::new(), Vec::new());
    while let Some(pivot) = largest_above(&rest, &left, floor) {
        left.retain(|&j| j != pivot);
        let diagonal = rest[(pivot, pivot)];
        let start = entries.len();
        entries.resize(start + size, 0.0);
        entries[start + pivot] = 1.0;
        for &j in &left {
            let share = rest[(j, pivot)] / diagonal;
            entries[start + j] = share.rounded();
            for &i in &left {
                let passed_on = share * rest[(i, pivot)];
                rest[(i, j)] = rest[(i, j)] - passed_on;
            }
        }
        scales.push(diagonal.rounded().sqrt());
    }
    // Beside a zero of the diagonal every entry has to vanish, or the matrix is indefinite.
    let vanishes =
        |i: usize, j: usize| rest[(i, j)].rounded().abs() <= (floor[i] * floor[j]).sqrt();
    let semidefinite = left.iter().all(|&i| left.iter().all(|&j| vanishes(i, j)));
    semidefinite.then(|| ScaledColumns::new(size, entries, scales))
}

/// The position of the largest diagonal entry that is more than rounding.
fn largest_above<T: Real>(rest: &DMatrix<T>, left: &[usize], floor: &[f64]) -> Option<usize> {
    let diagonal = |j: usize| rest[(j, j)].rounded();
    left.iter()
        .copied()
        .filter(|&j| diagonal(j) > floor[j])
        // Of equal pivots the first, where the maximum alone would take the last.
        .max_by(|&i, &j| diagonal(i).total_cmp(&diagonal(j)).then(j.cmp(&i)))
}
