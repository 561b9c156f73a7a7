//! Carlson's symmetric elliptic integrals by duplication.

/// Where the seventh power of the distances of the arguments from their mean no longer counts; their sum.
const SPREAD: f64 = 0.006;

/// Symmetric elliptic integral of the first kind; at most one argument may be zero, none negative.
///
/// ```text
/// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z))
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::carlson_rf;
///
/// assert_eq!(carlson_rf(4.0, 4.0, 4.0), 0.5);
/// ```
///
/// # References
///
/// B. C. Carlson, Numer. Algorithms 10 (1995) 13. DLMF 19.36.1.
#[must_use]
pub fn carlson_rf(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    loop {
        let mean = (x + y + z) / 3.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -(dx + dy);
        if are_close(dx, dy, dz) {
            let e2 = dx * dy - dz * dz;
            let e3 = dx * dy * dz;
            let series = e2 * (-1.0 / 10.0 + e2 / 24.0 - 3.0 * e3 / 44.0 - 5.0 * e2 * e2 / 208.0)
                + e3 * (1.0 / 14.0 + 3.0 * e3 / 104.0);
            return (1.0 + series) / mean.sqrt();
        }
        let shift = duplication_shift(x, y, z);
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
    }
}

/// Symmetric elliptic integral of the second kind; z positive, at most one of x and y zero, none negative.
///
/// ```text
/// R_D(x, y, z) = 3/2 int_0^inf dt / ((t + z) sqrt((t + x)(t + y)(t + z)))
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::carlson_rd;
///
/// assert_eq!(carlson_rd(4.0, 4.0, 4.0), 0.125);
/// ```
///
/// # References
///
/// B. C. Carlson, Numer. Algorithms 10 (1995) 13. DLMF 19.36.2.
#[must_use]
pub fn carlson_rd(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    loop {
        let mean = (x + y + 3.0 * z) / 5.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -(dx + dy) / 3.0;
        if are_close(dx, dy, dz) {
            return 3.0 * sum + power * second_kind_series(dx, dy, dz) / (mean * mean.sqrt());
        }
        let shift = duplication_shift(x, y, z);
        sum += power / (z.sqrt() * (z + shift));
        power *= 0.25;
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
    }
}

/// Whether arguments are as close as the expansions ask, from their relative distances to the mean; NaN is.
fn are_close(dx: f64, dy: f64, dz: f64) -> bool {
    let spread = dx.abs() + dy.abs() + dz.abs();
    spread <= SPREAD || spread.is_nan()
}

/// The sum of the products of the roots, by which the duplication theorem moves the arguments.
fn duplication_shift(x: f64, y: f64, z: f64) -> f64 {
    let (x, y, z) = (x.sqrt(), y.sqrt(), z.sqrt());
    x * y + y * z + z * x
}

/// The expansion of R_D about equal arguments.
fn second_kind_series(dx: f64, dy: f64, dz: f64) -> f64 {
    let (xy, zz) = (dx * dy, dz * dz);
    let e2 = xy - 6.0 * zz;
    let e3 = (3.0 * xy - 8.0 * zz) * dz;
    let e4 = 3.0 * (xy - zz) * zz;
    let e5 = xy * zz * dz;
    1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0
        + 3.0 * e5 / 26.0
        - e2 * e2 * e2 / 16.0
        + 3.0 * e3 * e3 / 40.0
        + 3.0 * e2 * e4 / 20.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_values_are_met() {
        // Carlson 1995, section 3, to the digits printed there.
        let close = |value: f64, expected: f64| (value / expected - 1.0).abs() < 5e-14;
        assert!(close(carlson_rf(1.0, 2.0, 0.0), 1.311_028_777_146_1));
        assert!(close(carlson_rf(0.5, 1.0, 0.0), 1.854_074_677_301_4));
        assert!(close(carlson_rf(2.0, 3.0, 4.0), 0.584_082_841_677_15));
        assert!(close(carlson_rd(0.0, 2.0, 1.0), 1.797_210_352_103_4));
        assert!(close(carlson_rd(2.0, 3.0, 4.0), 0.165_105_272_942_61));
    }

    #[test]
    fn arguments_without_a_value_end() {
        assert!(carlson_rf(f64::NAN, 1.0, 1.0).is_nan());
        assert!(!carlson_rf(0.0, 0.0, 1.0).is_finite());
        assert!(carlson_rf(f64::INFINITY, 1.0, 1.0).is_nan());
    }
}
