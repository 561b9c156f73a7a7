//! Reduction of a symmetric matrix to tridiagonal form by reflections.
//!
//! Each reflection takes one pass over what is left of the matrix: it subtracts what the reflection before it has left to
//! subtract, and multiplies the next vector, while an entry is at hand. All sums run in a fixed number of partial sums,
//! so that the width of a processor's registers changes no bit.
//!
//! # References
//!
//! Golub, Van Loan, Matrix Computations, 4th ed., section 8.3.1. Schreiber, Van Loan, SIAM J. Sci. Stat. Comput. 10 (1989) 53.

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

/// Partial sums of an inner product.
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
        let size = self.size;
        let count = size.saturating_sub(1);
        let mut end = count;
        let mut block = vec![[0.0; BLOCK]; size];
        while end > 0 {
            let start = end.saturating_sub(BLOCK);
            // Rows from the first that any of them touches.
            let rows = start + 1..size;
            for (row, entries) in rows.clone().zip(&mut block) {
                *entries = std::array::from_fn(|b| {
                    let k = start + b;
                    if k < end && row > k {
                        self.reflectors[k * size + row]
                    } else {
                        0.0
                    }
                });
            }
            let block = &block[..rows.len()];
            let triangle = self.triangle(start, end, block);
            let mut columns = vectors.chunks_exact_mut(2 * size);
            for pair in &mut columns {
                let (first, second) = pair.split_at_mut(size);
                apply(
                    block,
                    &triangle,
                    [&mut first[rows.clone()], &mut second[rows.clone()]],
                );
            }
            let last = columns.into_remainder();
            if !last.is_empty() {
                let mut unused = vec![0.0; rows.len()];
                apply(block, &triangle, [&mut last[rows.clone()], &mut unused]);
            }
            end = start;
        }
    }

    /// The upper triangle with `H_start ⋯ H_(end-1) = I - V S Vᵀ`.
    fn triangle(&self, start: usize, end: usize, block: &[[f64; BLOCK]]) -> [[f64; BLOCK]; BLOCK] {
        let mut products = [[0.0; BLOCK]; BLOCK];
        for entries in block {
            for (x, row) in entries.iter().zip(&mut products) {
                for (y, product) in entries.iter().zip(row) {
                    *product += x * y;
                }
            }
        }
        let mut triangle = [[0.0; BLOCK]; BLOCK];
        for j in 0..end - start {
            let factor = self.factors[start + j];
            triangle[j][j] = factor;
            for i in 0..j {
                let sum: f64 = (i..j).map(|k| triangle[i][k] * products[k][j]).sum();
                triangle[i][j] = -factor * sum;
            }
        }
        triangle
    }
}

/// `X <- X - V S Vᵀ X` for two columns.
fn apply(block: &[[f64; BLOCK]], triangle: &[[f64; BLOCK]; BLOCK], [x, y]: [&mut [f64]; 2]) {
    let (x, y) = (&mut x[..block.len()], &mut y[..block.len()]);
    // Even and odd rows apart, so that a sum does not wait for itself.
    let mut sums = [[[0.0; BLOCK]; 2]; 2];
    let mut add = |parity: usize, v: &[f64; BLOCK], x: f64, y: f64| {
        for b in 0..BLOCK {
            sums[parity][0][b] += v[b] * x;
            sums[parity][1][b] += v[b] * y;
        }
    };
    let pairs = block.chunks_exact(2);
    let rest = pairs.remainder();
    let (xs, ys) = (x.chunks_exact(2), y.chunks_exact(2));
    for ((v, x), y) in pairs.zip(xs).zip(ys) {
        add(0, &v[0], x[0], y[0]);
        add(1, &v[1], x[1], y[1]);
    }
    if let [v] = rest {
        add(0, v, x[x.len() - 1], y[y.len() - 1]);
    }
    let [even, odd] = sums;
    let shares: [[f64; BLOCK]; 2] = std::array::from_fn(|c| {
        let sums: [f64; BLOCK] = std::array::from_fn(|b| even[c][b] + odd[c][b]);
        std::array::from_fn(|b| (0..BLOCK).map(|a| triangle[b][a] * sums[a]).sum())
    });
    let [first, second] = shares;
    for ((v, x), y) in block.iter().zip(x).zip(y) {
        *x -= (v[0] * first[0] + v[1] * first[1]) + (v[2] * first[2] + v[3] * first[3]);
        *y -= (v[0] * second[0] + v[1] * second[1]) + (v[2] * second[2] + v[3] * second[3]);
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
    let length = a.len();
    let (b, v, w, next, image) = (
        &mut b[..length],
        &v[..length],
        &w[..length],
        &next[..length],
        &mut image[..length],
    );
    let (mut sum_a, mut sum_b) = ([0.0; LANES], [0.0; LANES]);
    let mut start = 0;
    while start + LANES <= length {
        let range = start..start + LANES;
        let (a, b, image) = (
            &mut a[range.clone()],
            &mut b[range.clone()],
            &mut image[range.clone()],
        );
        let (v, w, next) = (&v[range.clone()], &w[range.clone()], &next[range]);
        for l in 0..LANES {
            let x = a[l] - (v[l] * wa + w[l] * va);
            let y = b[l] - (v[l] * wb + w[l] * vb);
            a[l] = x;
            b[l] = y;
            image[l] += x * na + y * nb;
            sum_a[l] += x * next[l];
            sum_b[l] += y * next[l];
        }
        start += LANES;
    }
    let (mut rest_a, mut rest_b) = (0.0, 0.0);
    for i in start..length {
        let x = a[i] - (v[i] * wa + w[i] * va);
        let y = b[i] - (v[i] * wb + w[i] * vb);
        a[i] = x;
        b[i] = y;
        image[i] += x * na + y * nb;
        rest_a += x * next[i];
        rest_b += y * next[i];
    }
    let total = |[p, q, r, s]: [f64; LANES]| (p + r) + (q + s);
    [total(sum_a) + rest_a, total(sum_b) + rest_b]
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
