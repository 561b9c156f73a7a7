//! Vectors and the spaces that they span.

/// The rows of a matrix of this width, or the one vector.
pub(crate) fn vectors(numbers: &[f64], width: usize) -> Vec<Vec<f64>> {
    numbers.chunks(width.max(1)).map(<[f64]>::to_vec).collect()
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(crate) fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// What is left of a vector beside orthonormal ones; twice, so that what cancels leaves no rounding behind.
fn rest(vector: &[f64], basis: &[Vec<f64>]) -> Vec<f64> {
    let mut rest = vector.to_vec();
    for _ in 0..2 {
        for own in basis {
            let share = dot(own, &rest);
            rest.iter_mut()
                .zip(own)
                .for_each(|(value, own)| *value -= share * own);
        }
    }
    rest
}

/// Orthonormal vectors that span the same; those that add less than `least` of themselves are left out.
pub(crate) fn orthonormal(vectors: &[Vec<f64>], least: f64) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for vector in vectors {
        let mut rest = rest(vector, &basis);
        let (size, whole) = (length(&rest), length(vector));
        if size > least * whole && size > 0.0 {
            for value in &mut rest {
                *value /= size;
            }
            basis.push(rest);
        }
    }
    basis
}

/// Whether a vector lies in the space of others up to an angle.
pub(crate) fn lies_in(vector: &[f64], space: &[Vec<f64>], angle: f64) -> bool {
    let limit = crate::numerics::sin(angle.min(1.5)) + 1e-12;
    let basis = orthonormal(space, 1e-9);
    length(&rest(vector, &basis)) <= limit * length(vector)
}

/// A unit vector at right angles to a space, and as little as can be along each component of a vector; `None` where
/// the space is all there is.
pub(crate) fn away(vector: &[f64], space: &[Vec<f64>]) -> Option<Vec<f64>> {
    let basis = orthonormal(space, 1e-9);
    let axes = (0..vector.len()).map(|at| {
        let axis: Vec<f64> = (0..vector.len())
            .map(|own| f64::from(u8::from(own == at)))
            .collect();
        rest(&axis, &basis)
    });
    let largest = axes.max_by(|a, b| length(a).total_cmp(&length(b)))?;
    let size = length(&largest);
    (size > 1e-6).then(|| largest.iter().map(|value| value / size).collect())
}

/// How many of the vectors are independent by more than rounding of what was typed.
pub(crate) fn independent(vectors: &[Vec<f64>]) -> usize {
    orthonormal(vectors, 0.05).len()
}

/// Whether all of them are.
pub(crate) fn are_independent(vectors: &[Vec<f64>]) -> bool {
    independent(vectors) == vectors.len()
}

/// The numbers with which a vector is made of others; `None` where these are not independent.
pub(crate) fn coordinates(vector: &[f64], of: &[Vec<f64>]) -> Option<Vec<f64>> {
    let count = of.len();
    let mut rows: Vec<Vec<f64>> = of
        .iter()
        .map(|row| {
            let products = of.iter().map(|column| dot(row, column));
            products.chain([dot(row, vector)]).collect()
        })
        .collect();
    for step in 0..count {
        let pivot =
            (step..count).max_by(|a, b| rows[*a][step].abs().total_cmp(&rows[*b][step].abs()))?;
        rows.swap(step, pivot);
        if rows[step][step] == 0.0 {
            return None;
        }
        for below in 0..count {
            if below == step {
                continue;
            }
            let factor = rows[below][step] / rows[step][step];
            for column in step..=count {
                let take = factor * rows[step][column];
                rows[below][column] -= take;
            }
        }
    }
    Some(
        (0..count)
            .map(|at| rows[at][count] / rows[at][at])
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_put_a_vector_together() {
        let of = vec![vec![1.0, -1.0, 0.0], vec![0.0, 1.0, -1.0]];
        let found = coordinates(&[2.0, 1.0, -3.0], &of).expect("independent");
        assert!((found[0] - 2.0).abs() < 1e-14 && (found[1] - 3.0).abs() < 1e-14);
        assert_eq!(coordinates(&[1.0, 0.0], &[vec![0.0, 0.0]]), None);
    }

    #[test]
    fn a_multiple_adds_nothing() {
        let multiples = [vec![1.0, 2.0], vec![-2.0, -4.0]];
        assert!(!are_independent(&multiples));
        assert!(lies_in(&[3.0, 6.0], &multiples, 1e-3));
        assert!(!lies_in(&[3.0, -6.0], &multiples, 1e-3));
    }
}
