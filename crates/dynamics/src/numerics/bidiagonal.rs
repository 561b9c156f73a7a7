//! Singular values of bidiagonal matrices to high relative accuracy, in `O(n²)`.
//!
//! The differential quotient-difference algorithm with shifts works on the squares of the entries. Each pass lowers all
//! eigenvalues by a shift below the smallest of them, found by a Newton step from the trace of the inverse;
//! no pass subtracts anything but the shift.
//!
//! # References
//!
//! Fernando, Parlett, Numer. Math. 67 (1994) 191. Parlett, Marques, Linear Algebra Appl. 309 (2000) 121.

use super::exact::two_sum;

/// Unit roundoff.
const U: f64 = f64::EPSILON / 2.0;

/// Passes allowed for one singular value; about six are needed.
const MAX_PASSES: usize = 200;

/// Singular values, ascending, of the bidiagonal matrix whose squared entries are `diagonal` and `off_diagonal`;
/// none if they are not found, which no finite input is known to do.
pub(crate) fn singular_values(diagonal: Vec<f64>, off_diagonal: Vec<f64>) -> Option<Vec<f64>> {
    let mut eigenvalues = Vec::with_capacity(diagonal.len());
    let mut blocks = vec![UnreducedBlock {
        diagonal,
        off_diagonal,
        shift: Shift::default(),
    }];
    while let Some(block) = blocks.pop() {
        block.reduce(&mut blocks, &mut eigenvalues)?;
    }
    super::sort_by(&mut eigenvalues, f64::total_cmp);
    Some(eigenvalues.into_iter().map(f64::sqrt).collect())
}

/// An unreduced part of the matrix, and what has been taken off its eigenvalues.
struct UnreducedBlock {
    diagonal: Vec<f64>,
    off_diagonal: Vec<f64>,
    shift: Shift,
}

/// The sum of all shifts, with its rounding error.
#[derive(Clone, Copy, Default)]
struct Shift {
    high: f64,
    low: f64,
}

impl Shift {
    fn plus(self, step: f64) -> Self {
        // The shifts of later eigenvalues are ever smaller beside the sum: without the errors, roundings
        // would pile up in it.
        let (high, error) = two_sum(self.high, step);
        Self {
            high,
            low: self.low + error,
        }
    }

    fn value(self, rest: f64) -> f64 {
        self.high + (self.low + rest)
    }
}

impl UnreducedBlock {
    /// Takes eigenvalues off the lower end until none is left or the block falls apart; parts go to `blocks`.
    fn reduce(mut self, blocks: &mut Vec<Self>, eigenvalues: &mut Vec<f64>) -> Option<()> {
        self.put_small_end_last();
        let mut step = self.lower_bound();
        let mut passes = 0;
        while let Some(&last) = self.diagonal.last() {
            if self.is_last_separate(last) {
                eigenvalues.push(self.shift.value(last));
                self.diagonal.pop();
                self.off_diagonal.pop();
                step = self.lower_bound();
                passes = 0;
                continue;
            }
            if let Some(at) = self.separate_place() {
                let lower = Self {
                    diagonal: self.diagonal.split_off(at + 1),
                    off_diagonal: self.off_diagonal.split_off(at + 1),
                    shift: self.shift,
                };
                self.off_diagonal.pop();
                blocks.extend([self, lower]);
                return Some(());
            }
            if passes == MAX_PASSES {
                return None;
            }
            passes += 1;
            step = self.shifted_pass(step);
        }
        Some(())
    }

    /// The algorithm converges at the lower end, and fastest if the small entries are there.
    fn put_small_end_last(&mut self) {
        if self.diagonal.first() < self.diagonal.last() {
            self.diagonal.reverse();
            self.off_diagonal.reverse();
        }
    }

    /// Whether the last entry is an eigenvalue to rounding.
    fn is_last_separate(&self, last: f64) -> bool {
        let Some(&coupling) = self.off_diagonal.last() else {
            return true;
        };
        let small = U / 8.0 * self.shift.value(last);
        coupling <= small && (coupling * last).sqrt() <= small
    }

    /// The last place where the block falls apart, the end aside.
    fn separate_place(&self) -> Option<usize> {
        let size = self.off_diagonal.len();
        let small = U * U / 64.0 * self.shift.high;
        (0..size)
            .rev()
            .find(|&i| self.off_diagonal[i] <= small || self.off_diagonal[i] == 0.0)
    }

    /// One pass with the shift, or with a smaller one if it was too large; returns the next shift.
    fn shifted_pass(&mut self, step: f64) -> f64 {
        let mut step = step;
        loop {
            if let Some((diagonal, off_diagonal)) = self.transformed(step) {
                self.diagonal = diagonal;
                self.off_diagonal = off_diagonal;
                self.shift = self.shift.plus(step);
                return self.lower_bound();
            }
            // A bound that rounding has pushed above the eigenvalue is cut down; a shift of zero always
            // passes, as it subtracts nothing.
            step = if step > f64::MIN_POSITIVE {
                step / 4.0
            } else {
                0.0
            };
        }
    }

    /// The quotient-difference step in differential form; none if a square came out negative.
    fn transformed(&self, step: f64) -> Option<(Vec<f64>, Vec<f64>)> {
        let mut diagonal = Vec::with_capacity(self.diagonal.len());
        let mut off_diagonal = Vec::with_capacity(self.off_diagonal.len());
        let mut rest = self.diagonal[0] - step;
        for (coupling, next) in self.off_diagonal.iter().zip(&self.diagonal[1..]) {
            if rest < 0.0 {
                return None;
            }
            let sum = rest + coupling;
            let ratio = next / sum;
            diagonal.push(sum);
            off_diagonal.push(coupling * ratio);
            rest = rest * ratio - step;
        }
        diagonal.push(rest);
        (rest >= 0.0 || step == 0.0).then_some((diagonal, off_diagonal))
    }

    /// A number just below the smallest eigenvalue: the reciprocal of the trace of the inverse.
    fn lower_bound(&self) -> f64 {
        let Some(first) = self.diagonal.first() else {
            return 0.0;
        };
        let mut entry = 1.0 / first;
        let mut trace = entry;
        for (coupling, next) in self.off_diagonal.iter().zip(&self.diagonal[1..]) {
            entry = (1.0 + coupling * entry) / next;
            trace += entry;
        }
        // The sum of positive terms is off by a few u a term, and must not come out above the eigenvalue.
        let bound = (1.0 - 1e-14 * self.diagonal.len() as f64) / trace;
        if bound.is_finite() { bound } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::sin;

    /// A chain of equal masses and springs, one end fixed: `2 sin((2i-1) π / (4n+2))`.
    #[test]
    fn uniform_chains_have_their_closed_form() {
        for size in [1, 2, 3, 10, 200] {
            let mut squares = vec![2.0];
            let mut off = Vec::new();
            // Pivots (i+1)/i of the matrix with 2 on the diagonal and a last entry of 1.
            for i in 1..size {
                let pivot = squares[i - 1];
                off.push(1.0 / pivot);
                squares.push(if i + 1 < size {
                    2.0 - 1.0 / pivot
                } else {
                    1.0 - 1.0 / pivot
                });
            }
            if size == 1 {
                squares = vec![1.0];
            }
            let values = singular_values(squares, off).expect("the passes converge");
            let turn = std::f64::consts::PI / (4 * size + 2) as f64;
            for (i, value) in values.iter().enumerate() {
                let expected = 2.0 * sin((2 * i + 1) as f64 * turn);
                assert!(
                    (value / expected - 1.0).abs() < 2e-13,
                    "{size} {i}: {value} {expected}"
                );
            }
        }
    }

    #[test]
    fn zeros_and_separate_parts() {
        let values =
            singular_values(vec![4.0, 0.0, 9.0], vec![0.0, 0.0]).expect("nothing is coupled");
        assert_eq!(values, [0.0, 2.0, 3.0]);
        let values = singular_values(vec![1.0, 0.0], vec![1.0]).expect("one pass");
        assert_eq!(values[0], 0.0);
        assert!((values[1] - 2.0_f64.sqrt()).abs() < 1e-15);
    }
}
