//! Reduction of a symmetric matrix to tridiagonal form by reflections.
//!
//! Each reflection takes one pass over what is left of the matrix: it subtracts what the reflection before it has left to
//! subtract, and multiplies the next vector, while an entry is at hand. Back from there, four reflections are applied at once
//! to four vectors side by side. All sums run in a fixed number of partial sums, so that the width of a processor's
//! registers changes no bit.
//!
//! # References
//!
//! Golub, Van Loan, Matrix Computations, 4th ed., section 8.3.1. Schreiber, Van Loan, SIAM J. Sci. Stat. Comput. 10 (1989) 53.

use std::ops::Range;

use super::jacobi::dot;

/// `A = Q T Qᵀ` with `Q = H₀ H₁ …`, `H = I - τ v vᵀ`.
#[derive(Debug, Clone)]
pub(crate) struct Reduction {
    size: usize,
    /// The vector `v` of each reflection in its column, below the diagonal.
    reflectors: Vec<f64>,
    factors: Vec<f64>,
    /// The diagonal of T.
    pub(crate) diagonal: Vec<f64>,
    /// The entries of T beside its diagonal.
    pub(crate) off_diagonal: Vec<f64>,
}

/// Partial sums of an inner product, and vectors that are reflected side by side.
const LANES: usize = 4;

/// Reflections that are applied at once.
const BLOCK: usize = 4;

impl Reduction {
    /// Reduces a symmetric matrix, column after column; what is above the diagonal is not read.
    pub(crate) fn of(mut matrix: Vec<f64>, size: usize) -> Self {
        let mut diagonal = vec![0.0; size];
        let mut off_diagonal = vec![0.0; size.saturating_sub(1)];
        let mut factors = vec![0.0; size];
        // Of the reflection before: v and w, with which A - v wᵀ - w vᵀ is left.
        let (mut v, mut w) = (vec![0.0; size], vec![0.0; size]);
        let mut image = vec![0.0; size];
        let mut next = vec![0.0; size];
        for k in 0..size {
            let column = &mut matrix[k * size..(k + 1) * size];
            subtract(&mut column[k..], [&v[k..], &w[k..]], [w[k], v[k]]);
            diagonal[k] = column[k];
            if k + 1 == size {
                break;
            }
            let (factor, entry) = reflection(&mut column[k + 1..]);
            (factors[k], off_diagonal[k]) = (factor, entry);
            next[k + 1..].copy_from_slice(&column[k + 1..]);
            image[k + 1..].fill(0.0);
            pass(&mut matrix, size, k + 1, [&v, &w, &next], &mut image);
            let half = factor / 2.0 * (factor * dot(&image[k + 1..], &next[k + 1..]));
            for i in k + 1..size {
                w[i] = factor * image[i] - half * next[i];
            }
            std::mem::swap(&mut v, &mut next);
        }
        Self {
            size,
            reflectors: matrix,
            factors,
            diagonal,
            off_diagonal,
        }
    }

    /// Replaces vectors, one after the other, by `Q` times them.
    pub(crate) fn back(&self, vectors: &mut [f64]) {
        let blocks = self.blocks();
        let mut panel = vec![[0.0; LANES]; self.size];
        for columns in vectors.chunks_mut(LANES * self.size) {
            for (lane, column) in columns.chunks_exact(self.size).enumerate() {
                for (row, entry) in panel.iter_mut().zip(column) {
                    row[lane] = *entry;
                }
            }
            let (mut before, mut shares) = (&[][..], [[0.0; LANES]; BLOCK]);
            for block in &blocks {
                let first = self.size - block.rows.len();
                let sums = turn(before, &shares, &block.rows, &mut panel[first..]);
                shares = block.shares(&sums);
                before = &block.rows;
            }
            for (v, x) in before.iter().rev().zip(panel.iter_mut().rev()) {
                subtract_shares(v, &shares, x);
            }
            for (lane, column) in columns.chunks_exact_mut(self.size).enumerate() {
                for (row, entry) in panel.iter().zip(column) {
                    *entry = row[lane];
                }
            }
        }
    }

    /// The reflections by blocks, the last ones first.
    fn blocks(&self) -> Vec<ReflectorBlock> {
        let count = self.size.saturating_sub(1);
        let starts = (0..count).step_by(BLOCK).rev();
        starts
            .map(|start| ReflectorBlock::of(self, start..count.min(start + BLOCK)))
            .collect()
    }
}

/// Reflections that are applied at once, `H_start ⋯ H_(end-1) = I - V S Vᵀ`.
struct ReflectorBlock {
    /// The rows of V, from the first that is not zero.
    rows: Vec<[f64; BLOCK]>,
    /// The upper triangle S.
    triangle: [[f64; BLOCK]; BLOCK],
}

impl ReflectorBlock {
    fn of(reduction: &Reduction, range: Range<usize>) -> Self {
        let rows: Vec<[f64; BLOCK]> = (range.start + 1..reduction.size)
            .map(|row| {
                std::array::from_fn(|b| {
                    let k = range.start + b;
                    if k < range.end && row > k {
                        reduction.reflectors[k * reduction.size + row]
                    } else {
                        0.0
                    }
                })
            })
            .collect();
        let mut products = [[0.0; BLOCK]; BLOCK];
        for entries in &rows {
            for (x, row) in entries.iter().zip(&mut products) {
                for (y, product) in entries.iter().zip(row) {
                    *product += x * y;
                }
            }
        }
        let mut triangle = [[0.0; BLOCK]; BLOCK];
        for j in 0..range.len() {
            let factor = reduction.factors[range.start + j];
            triangle[j][j] = factor;
            for i in 0..j {
                let sum: f64 = (i..j).map(|k| triangle[i][k] * products[k][j]).sum();
                triangle[i][j] = -factor * sum;
            }
        }
        Self { rows, triangle }
    }

    /// `S` times `Vᵀ X`.
    fn shares(&self, sums: &BlockSums) -> BlockSums {
        let mut shares = [[0.0; LANES]; BLOCK];
        for (share, factors) in shares.iter_mut().zip(&self.triangle) {
            for (factor, sums) in factors.iter().zip(sums) {
                for lane in 0..LANES {
                    share[lane] += factor * sums[lane];
                }
            }
        }
        shares
    }
}

/// What each reflection of a block has of each vector.
type BlockSums = [[f64; LANES]; BLOCK];

/// Subtracts the shares of one block from vectors, and multiplies them by the rows of the next, in one pass.
fn turn(
    before: &[[f64; BLOCK]],
    shares: &BlockSums,
    rows: &[[f64; BLOCK]],
    vectors: &mut [[f64; LANES]],
) -> BlockSums {
    let mut sums = [[0.0; LANES]; BLOCK];
    let mut add = |v: &[f64; BLOCK], x: &[f64; LANES]| {
        for b in 0..BLOCK {
            for lane in 0..LANES {
                sums[b][lane] += v[b] * x[lane];
            }
        }
    };
    // The block before begins some rows farther down.
    let (first_rows, rows) = rows.split_at(rows.len() - before.len());
    let (first_vectors, vectors) = vectors.split_at_mut(first_rows.len());
    for (v, x) in first_rows.iter().zip(first_vectors) {
        add(v, x);
    }
    for ((v, next), x) in before.iter().zip(rows).zip(vectors) {
        subtract_shares(v, shares, x);
        add(next, x);
    }
    sums
}

fn subtract_shares(v: &[f64; BLOCK], [a, b, c, d]: &BlockSums, x: &mut [f64; LANES]) {
    for lane in 0..LANES {
        x[lane] -= (v[0] * a[lane] + v[1] * b[lane]) + (v[2] * c[lane] + v[3] * d[lane]);
    }
}

/// Replaces `x` by the vector `v` with `v₀ = 1` whose reflection takes `x` to the first axis; returns τ and what is there.
fn reflection(x: &mut [f64]) -> (f64, f64) {
    let Some((first, rest)) = x.split_first_mut() else {
        return (0.0, 0.0);
    };
    let square = dot(rest, rest);
    let alpha = std::mem::replace(first, 1.0);
    if square == 0.0 {
        return (0.0, alpha);
    }
    let length = (alpha * alpha + square).sqrt();
    // Of the opposite sign, so that `alpha - beta` does not cancel.
    let beta = if alpha < 0.0 { length } else { -length };
    let scale = 1.0 / (alpha - beta);
    for entry in rest {
        *entry *= scale;
    }
    ((beta - alpha) / beta, beta)
}

/// `x <- x - a v - b w`.
fn subtract(x: &mut [f64], [v, w]: [&[f64]; 2], [a, b]: [f64; 2]) {
    for ((x, v), w) in x.iter_mut().zip(v).zip(w) {
        *x -= v * a + w * b;
    }
}

/// Subtracts `v wᵀ + w vᵀ` from the square that begins at `first`, and adds its product with `next` to `image`.
fn pass(
    matrix: &mut [f64],
    size: usize,
    first: usize,
    [v, w, next]: [&[f64]; 3],
    image: &mut [f64],
) {
    let mut j = first;
    while j + 1 < size {
        let (left, right) = matrix.split_at_mut((j + 1) * size);
        let (a, b) = (&mut left[j * size..], &mut right[..size]);
        // The corner of both columns.
        a[j] -= 2.0 * (v[j] * w[j]);
        let i = j + 1;
        a[i] -= v[i] * w[j] + w[i] * v[j];
        b[i] -= 2.0 * (v[i] * w[i]);
        let (n0, n1) = (next[j], next[i]);
        image[j] += a[j] * n0 + a[i] * n1;
        image[i] += a[i] * n0 + b[i] * n1;
        let from = j + 2;
        let sums = two_columns(
            [&mut a[from..], &mut b[from..]],
            [&v[from..], &w[from..], &next[from..]],
            &mut image[from..],
            [[v[j], w[j], n0], [v[i], w[i], n1]],
        );
        image[j] += sums[0];
        image[i] += sums[1];
        j += 2;
    }
    if j < size {
        let entry = &mut matrix[j * size + j];
        *entry -= 2.0 * (v[j] * w[j]);
        image[j] += *entry * next[j];
    }
}

/// The part of two columns below their corner; returns their inner products with `next`.
fn two_columns(
    [a, b]: [&mut [f64]; 2],
    [v, w, next]: [&[f64]; 3],
    image: &mut [f64],
    [[va, wa, na], [vb, wb, nb]]: [[f64; 3]; 2],
) -> [f64; 2] {
    let (a, a_rest) = a.as_chunks_mut::<LANES>();
    let (b, b_rest) = b.as_chunks_mut::<LANES>();
    let (v, v_rest) = v.as_chunks::<LANES>();
    let (w, w_rest) = w.as_chunks::<LANES>();
    let (next, next_rest) = next.as_chunks::<LANES>();
    let (image, image_rest) = image.as_chunks_mut::<LANES>();
    let (mut sum_a, mut sum_b) = ([0.0; LANES], [0.0; LANES]);
    let columns = a.iter_mut().zip(b).zip(image);
    for (((a, b), image), ((v, w), next)) in columns.zip(v.iter().zip(w).zip(next)) {
        let x = column_step(a, [v, w], [va, wa]);
        let y = column_step(b, [v, w], [vb, wb]);
        // A loop for each result: the compiler then keeps lanes side by side.
        for lane in 0..LANES {
            image[lane] += x[lane] * na + y[lane] * nb;
        }
        for lane in 0..LANES {
            sum_a[lane] += x[lane] * next[lane];
        }
        for lane in 0..LANES {
            sum_b[lane] += y[lane] * next[lane];
        }
    }
    let (mut rest_a, mut rest_b) = (0.0, 0.0);
    let columns = a_rest.iter_mut().zip(b_rest).zip(image_rest);
    for (((a, b), image), ((v, w), next)) in columns.zip(v_rest.iter().zip(w_rest).zip(next_rest)) {
        *a -= v * wa + w * va;
        *b -= v * wb + w * vb;
        *image += *a * na + *b * nb;
        rest_a += *a * next;
        rest_b += *b * next;
    }
    let total = |[p, q, r, s]: [f64; LANES]| (p + r) + (q + s);
    [total(sum_a) + rest_a, total(sum_b) + rest_b]
}

/// `a <- a - v w_j - w v_j` in some rows of column j; returns them.
fn column_step(
    a: &mut [f64; LANES],
    [v, w]: [&[f64; LANES]; 2],
    [vj, wj]: [f64; 2],
) -> [f64; LANES] {
    for lane in 0..LANES {
        a[lane] -= v[lane] * wj + w[lane] * vj;
    }
    *a
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A symmetric matrix, column after column.
    fn matrix(size: usize) -> Vec<f64> {
        let entry = |i: usize, j: usize| 1.0 / (1 + i + j) as f64 + f64::from(u8::from(i == j));
        (0..size * size)
            .map(|at| entry(at % size, at / size))
            .collect()
    }

    #[test]
    fn the_matrix_is_restored_from_its_reduction() {
        for size in [1, 2, 3, 4, 5, 9, 24] {
            let matrix = matrix(size);
            let reduction = Reduction::of(matrix.clone(), size);
            let mut q = vec![0.0; size * size];
            for i in 0..size {
                q[i * size + i] = 1.0;
            }
            reduction.back(&mut q);
            let (d, e) = (&reduction.diagonal, &reduction.off_diagonal);
            let column = |k: usize| &q[k * size..(k + 1) * size];
            for i in 0..size {
                for j in 0..size {
                    let restored: f64 = (0..size)
                        .map(|k| {
                            let mut entry = d[k] * column(k)[j];
                            if k > 0 {
                                entry += e[k - 1] * column(k - 1)[j];
                            }
                            if k + 1 < size {
                                entry += e[k] * column(k + 1)[j];
                            }
                            column(k)[i] * entry
                        })
                        .sum();
                    let expected = matrix[j * size + i];
                    assert!((restored - expected).abs() < 1e-14, "{size}: {i} {j}");
                }
            }
        }
    }

    #[test]
    fn a_diagonal_matrix_stays_as_it_is() {
        let mut diagonal = vec![0.0; 25];
        for i in 0..5 {
            diagonal[i * 6] = i as f64;
        }
        let reduction = Reduction::of(diagonal, 5);
        assert_eq!(reduction.diagonal, [0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(reduction.off_diagonal, [0.0; 4]);
    }
}
