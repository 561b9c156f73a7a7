//! Elliptic integrals and functions, from the arithmetic-geometric mean and Carlson's symmetric forms.
//!
//! Every function takes the *complementary* modulus k' or parameter k'^2 = 1 - k^2 where the usual form takes k: near
//! k = 1, where everything interesting happens, k' carries the digits and 1 - k^2 would lose them.
//!
//! - [`agm`], [`agm_dd`]: the arithmetic-geometric mean of two numbers.
//! - [`complete_elliptic_first`], [`complete_elliptic_second`]: K and E.
//! - [`elliptic_first`], [`elliptic_second`]: F and E of an amplitude up to a right angle.
//! - [`carlson_rf`], [`carlson_rd`]: the symmetric integrals behind them.
//! - [`JacobiFunctions`]: sn, cn, dn and the amplitude.
//!
//! # References
//!
//! NIST Digital Library of Mathematical Functions, chapters 19 and 22.

mod carlson;
mod jacobi;

pub use carlson::{carlson_rd, carlson_rf};
pub use jacobi::{JacobiFunctions, JacobiValues};

use super::{Dd, sin_cos};

/// Arithmetic-geometric mean of two positive numbers.
///
/// ```text
/// a' = (a + b)/2,  b' = sqrt(a b),  again until they agree
/// ```
///
/// # Examples
///
/// Gauss's constant is the reciprocal of a mean:
///
/// ```
/// use vibank_dynamics::numerics::agm;
///
/// assert!((1.0 / agm(1.0, 2_f64.sqrt()) - 0.834_626_841_674_073_2).abs() < 2e-16);
/// ```
#[must_use]
pub fn agm(mut a: f64, mut b: f64) -> f64 {
    // Means that differ by less than this agree to the last digit after one step more.
    const CLOSE: f64 = 1e-8;
    while (a - b).abs() > CLOSE * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    0.5 * (a + b)
}

/// [`agm`] of double-double numbers.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::{Dd, agm_dd};
///
/// let mean = agm_dd(Dd::ONE, Dd::SQRT_2);
/// assert!((mean * 0.834_626_841_674_073_2 - 1.0).abs() < Dd::from(1e-15));
/// ```
#[must_use]
pub fn agm_dd(mut a: Dd, mut b: Dd) -> Dd {
    // The step that is left out after the correction below is of fourth order, 1e-60.
    const CLOSE: f64 = 1e-15;
    while (a - b).hi().abs() > CLOSE * a.hi() {
        (a, b) = ((a + b) * 0.5, (a * b).sqrt());
    }
    let difference = (a - b).hi();
    // Gauss's next step, (a + b)/2 - (a - b)^2/(16 a) to this order.
    (a + b) * 0.5 - difference * difference / (16.0 * a.hi())
}

/// Complete elliptic integral of the first kind, K, of the complementary modulus k' in (0, 1].
///
/// ```text
/// K = pi/(2 agm(1, k'))
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::complete_elliptic_first;
///
/// assert_eq!(complete_elliptic_first(1.0), std::f64::consts::FRAC_PI_2);
/// ```
#[must_use]
pub fn complete_elliptic_first(complementary_modulus: f64) -> f64 {
    Dd::FRAC_PI_2.hi() / agm(1.0, complementary_modulus)
}

/// Complete elliptic integral of the second kind, E, of the complementary modulus k' in [0, 1].
///
/// ```text
/// E = k'^2 (R_D(0, k'^2, 1) + R_D(0, 1, k'^2))/3        no difference
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::complete_elliptic_second;
///
/// // The quarter of an ellipse with half-axes 1 and 1/2.
/// assert!((complete_elliptic_second(0.5) - 1.211_056_027_568_459_5).abs() < 4e-16);
/// ```
///
/// # References
///
/// DLMF 19.25.1.
#[must_use]
pub fn complete_elliptic_second(complementary_modulus: f64) -> f64 {
    let complement = complementary_modulus * complementary_modulus;
    if complement == 0.0 {
        return 1.0;
    }
    complement * (carlson_rd(0.0, complement, 1.0) + carlson_rd(0.0, 1.0, complement)) / 3.0
}

/// Elliptic integral of the first kind, F, of an amplitude in [-π/2, π/2] and the complementary parameter k'^2.
///
/// ```text
/// F = sin(phi) R_F(cos^2(phi), cos^2(phi) + k'^2 sin^2(phi), 1)
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::elliptic_first;
///
/// // Without a modulus the integral is the amplitude.
/// assert!((elliptic_first(0.7, 1.0) - 0.7).abs() < 4e-16);
/// ```
///
/// # References
///
/// DLMF 19.25.5.
#[must_use]
pub fn elliptic_first(amplitude: f64, complementary_parameter: f64) -> f64 {
    let (sine, cosine) = sin_cos(amplitude);
    let square = cosine * cosine;
    sine * carlson_rf(square, square + complementary_parameter * sine * sine, 1.0)
}

/// Elliptic integral of the second kind, E, of an amplitude in [-π/2, π/2] and the complementary parameter k'^2.
///
/// ```text
/// E = k'^2 (F + k^2 sin^3(phi) R_D(cos^2(phi), 1, 1 - k^2 sin^2(phi))/3) + k^2 sin(phi) cos(phi)/sqrt(1 - k^2 sin^2(phi))
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::elliptic_second;
///
/// assert!((elliptic_second(0.7, 1.0) - 0.7).abs() < 4e-16);
/// assert!((elliptic_second(0.7, 0.0) - vibank_dynamics::numerics::sin(0.7)).abs() < 4e-16);
/// ```
///
/// # References
///
/// DLMF 19.25.10.
#[must_use]
pub fn elliptic_second(amplitude: f64, complementary_parameter: f64) -> f64 {
    let (sine, cosine) = sin_cos(amplitude);
    let square = cosine * cosine;
    let parameter = 1.0 - complementary_parameter;
    let delta_square = square + complementary_parameter * sine * sine;
    let first = sine * carlson_rf(square, delta_square, 1.0);
    let cubic = sine * sine * sine * carlson_rd(square, 1.0, delta_square) / 3.0;
    complementary_parameter * (first + parameter * cubic)
        + parameter * sine * cosine / delta_square.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn complete_integrals_satisfy_legendre() {
        // E(k) K(k') + E(k') K(k) - K(k) K(k') = pi/2
        for i in 1..200 {
            let modulus = f64::from(i) / 200.0;
            let complement = ((1.0 - modulus) * (1.0 + modulus)).sqrt();
            let (k, k_other) = (
                complete_elliptic_first(complement),
                complete_elliptic_first(modulus),
            );
            let (e, e_other) = (
                complete_elliptic_second(complement),
                complete_elliptic_second(modulus),
            );
            let sum = e * k_other + e_other * k - k * k_other;
            assert!((sum - Dd::FRAC_PI_2.hi()).abs() < 3e-15, "{modulus} {sum}");
        }
    }

    #[test]
    fn complete_integrals_have_their_limits() {
        assert_eq!(complete_elliptic_second(0.0), 1.0);
        assert!((complete_elliptic_second(1.0) - Dd::FRAC_PI_2.hi()).abs() < 4e-16);
        let small = 1e-150;
        // K = ln(4/k') + O(k'^2 ln k')
        assert!(
            (complete_elliptic_first(small) / crate::numerics::ln(4.0 / small) - 1.0).abs() < 4e-16
        );
    }

    #[test]
    fn incomplete_integrals_end_in_the_complete_ones() {
        for complement in [1e-2_f64, 0.3, 1.0] {
            let right = Dd::FRAC_PI_2.hi();
            let (first, second) = (
                elliptic_first(right, complement),
                elliptic_second(right, complement),
            );
            assert!(
                (first / complete_elliptic_first(complement.sqrt()) - 1.0).abs() < 2e-15,
                "{complement}"
            );
            assert!(
                (second / complete_elliptic_second(complement.sqrt()) - 1.0).abs() < 2e-15,
                "{complement}"
            );
        }
    }

    #[test]
    fn both_means_agree() {
        for b in [1e-200, 1e-17, 1e-3, 0.5, 0.999_999, 1.0, 3.0] {
            let precise = agm_dd(Dd::ONE, Dd::from(b));
            assert!((agm(1.0, b) / precise.hi() - 1.0).abs() < 5e-16, "{b}");
        }
    }
}
