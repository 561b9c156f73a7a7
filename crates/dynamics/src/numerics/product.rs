//! Products of matrices, stored column after column.

/// Rows and columns of the result that are worked out at once: as many sums as fit the registers of any processor.
const TILE: usize = 4;

/// `A B`, where A has `rows` rows. Each entry is summed from the first column of A to the last.
pub(crate) fn product(a: &[f64], b: &[f64], rows: usize) -> Vec<f64> {
    let inner = a.len() / rows.max(1);
    let columns = b.len() / inner.max(1);
    let mut result = vec![0.0; rows * columns];
    let mut packed = vec![[0.0; TILE]; inner];
    for first in (0..rows).step_by(TILE) {
        let height = TILE.min(rows - first);
        for (entries, column) in packed.iter_mut().zip(a.chunks_exact(rows)) {
            entries[..height].copy_from_slice(&column[first..first + height]);
        }
        for (b, result) in b.chunks(TILE * inner).zip(result.chunks_mut(TILE * rows)) {
            let sums = tile(&packed, b);
            for (sums, column) in sums.iter().zip(result.chunks_exact_mut(rows)) {
                column[first..first + height].copy_from_slice(&sums[..height]);
            }
        }
    }
    result
}

/// Rows of a product with up to four columns.
fn tile(packed: &[[f64; TILE]], b: &[f64]) -> [[f64; TILE]; TILE] {
    let inner = packed.len();
    let mut sums = [[0.0; TILE]; TILE];
    if b.len() < TILE * inner {
        for (sums, column) in sums.iter_mut().zip(b.chunks_exact(inner)) {
            for (entries, factor) in packed.iter().zip(column) {
                for (sum, entry) in sums.iter_mut().zip(entries) {
                    *sum += entry * factor;
                }
            }
        }
        return sums;
    }
    let (first, rest) = b.split_at(inner);
    let (second, rest) = rest.split_at(inner);
    let (third, fourth) = rest.split_at(inner);
    let fourth = &fourth[..inner];
    for k in 0..inner {
        let entries = packed[k];
        let factors = [first[k], second[k], third[k], fourth[k]];
        for (sums, factor) in sums.iter_mut().zip(factors) {
            for (sum, entry) in sums.iter_mut().zip(entries) {
                *sum += entry * factor;
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_inner_products() {
        for (rows, inner, columns) in [(1, 1, 1), (3, 2, 5), (4, 4, 4), (9, 7, 6), (8, 3, 11)] {
            let a: Vec<f64> = (0..rows * inner).map(|i| (i % 17) as f64).collect();
            let b: Vec<f64> = (0..inner * columns).map(|i| (i % 13) as f64).collect();
            let c = product(&a, &b, rows);
            for i in 0..rows {
                for j in 0..columns {
                    let entry: f64 = (0..inner).map(|k| a[k * rows + i] * b[j * inner + k]).sum();
                    assert_eq!(c[j * rows + i], entry, "{rows} {inner} {columns}: {i} {j}");
                }
            }
        }
    }
}
