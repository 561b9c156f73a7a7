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
        for (entries, column) in packed.iter_mut().zip(a.chunks_exact(rows)) {
            copy_tile(&column[first..], entries);
        }
        for (b, result) in b.chunks(TILE * inner).zip(result.chunks_mut(TILE * rows)) {
            // The first column stands in for those that are missing after the last: what comes of it is dropped.
            let columns = std::array::from_fn(|j| {
                let column = b.get(j * inner..(j + 1) * inner);
                column.unwrap_or(&b[..inner])
            });
            let sums = tile(&packed, columns);
            for (sums, column) in sums.iter().zip(result.chunks_exact_mut(rows)) {
                copy_tile(sums, &mut column[first..]);
            }
        }
    }
    result
}

/// Copies the first entries, as many as a tile has, or all that there are.
fn copy_tile(from: &[f64], to: &mut [f64]) {
    match (from.first_chunk::<TILE>(), to.first_chunk_mut::<TILE>()) {
        (Some(from), Some(to)) => *to = *from,
        _ => to.iter_mut().zip(from).for_each(|(to, from)| *to = *from),
    }
}

/// Rows of a product with four columns.
fn tile(packed: &[[f64; TILE]], columns: [&[f64]; TILE]) -> [[f64; TILE]; TILE] {
    let mut sums = [[0.0; TILE]; TILE];
    let [first, second, third, fourth] = columns.map(|column| &column[..packed.len()]);
    for (k, entries) in packed.iter().enumerate() {
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
