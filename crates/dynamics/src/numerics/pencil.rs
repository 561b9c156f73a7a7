//! Eigenvalues of a pair of small matrices that need not be symmetric.

use nalgebra::DMatrix;

/// An eigenvalue of `K u = λ M u`, and its vector of length 1.
#[derive(Clone, Debug, PartialEq)]
pub struct EigenPair {
    /// λ.
    pub value: f64,
    /// u.
    pub vector: Vec<f64>,
}

/// Parts of the largest eigenvalue below which two are one, or the imaginary part is rounding.
const ROUNDING: f64 = 1e-9;

/// The eigenvalues of `K u = λ M u`, ascending, with their vectors; entries by rows.
///
/// Nothing where M is singular, an eigenvalue is complex, or two are one.
///
/// ```
/// use vibank_dynamics::numerics::pencil;
///
/// let pairs = pencil(&[4.0, 0.0, 0.0, 2.0], &[3.0, -1.0, -1.0, 1.0]).unwrap();
/// assert!((pairs[0].value - 0.25).abs() < 1e-15 && (pairs[1].value - 1.0).abs() < 1e-15);
/// assert!((pairs[0].vector[1] / pairs[0].vector[0] - 2.0).abs() < 1e-14);
/// ```
pub fn pencil(mass: &[f64], stiffness: &[f64]) -> Option<Vec<EigenPair>> {
    let size = (1..=mass.len()).find(|size| size * size == mass.len())?;
    let is_usable = mass.len() == stiffness.len()
        && mass.iter().chain(stiffness).all(|entry| entry.is_finite());
    if !is_usable {
        return None;
    }
    let mass = DMatrix::from_row_slice(size, size, mass);
    let stiffness = DMatrix::from_row_slice(size, size, stiffness);
    let quotient = mass.clone().lu().solve(&stiffness)?;
    if quotient.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let values = quotient.complex_eigenvalues();
    let largest = values
        .iter()
        .map(|value| value.re.abs())
        .fold(0.0, f64::max);
    let is_rounding = |part: f64| part.abs() <= ROUNDING * largest;
    if values.iter().any(|value| !is_rounding(value.im)) {
        return None;
    }
    let mut values: Vec<f64> = values.iter().map(|value| value.re).collect();
    super::sort_by(&mut values, f64::total_cmp);
    if values.windows(2).any(|pair| is_rounding(pair[1] - pair[0])) {
        return None;
    }
    values
        .into_iter()
        .map(|value| {
            let parts = (&stiffness - &mass * value).svd_unordered(false, true);
            let vector = parts
                .v_t?
                .row(parts.singular_values.imin())
                .iter()
                .copied()
                .collect();
            Some(EigenPair { value, vector })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matrices_need_not_be_symmetric() {
        // λ² − 5λ + 4 = 0.
        let pairs = pencil(&[1.0, 0.0, 0.0, 1.0], &[2.0, 2.0, 1.0, 3.0]).expect("real");
        assert!((pairs[0].value - 1.0).abs() < 1e-14 && (pairs[1].value - 4.0).abs() < 1e-14);
        let [a, b] = pairs[1].vector[..] else {
            panic!("two components");
        };
        assert!((b / a - 1.0).abs() < 1e-14);
    }

    #[test]
    fn what_is_no_oscillation_has_none() {
        assert_eq!(pencil(&[1.0, 0.0, 0.0, 1.0], &[0.0, 1.0, -1.0, 0.0]), None);
        assert_eq!(pencil(&[0.0; 4], &[1.0; 4]), None);
        assert_eq!(pencil(&[1.0, 0.0, 0.0, 1.0], &[1.0, 0.0, 0.0, 1.0]), None);
        assert_eq!(pencil(&[1.0; 3], &[1.0; 3]), None);
        assert_eq!(pencil(&[], &[]), None);
    }
}
