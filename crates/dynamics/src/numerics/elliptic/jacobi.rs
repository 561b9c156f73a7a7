//! Jacobi's elliptic functions by descending Landen transformations.

use super::agm_dd;
use crate::numerics::{Dd, atan2};

/// The means of a complementary parameter of any binary64 agree after fewer steps than this.
const MAX_STEPS: usize = 16;

/// Jacobi's functions of one complementary parameter k'^2 in (0, 1], prepared for many arguments.
///
/// The argument is a *phase*: the angle psi = pi u/(2 K) that makes one turn while u makes a period 4 K. A phase can be
/// kept in double-double and reduced exactly, so the functions hold after any number of periods.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::{Dd, JacobiFunctions, sin_cos};
///
/// let functions = JacobiFunctions::of(Dd::from(0.5));
/// let at = functions.at(sin_cos(0.3));
/// assert!((at.sn * at.sn + at.cn * at.cn - 1.0).abs() < 1e-15);
/// assert!((at.dn * at.dn + 0.5 * at.sn * at.sn - 1.0).abs() < 1e-15);
/// ```
///
/// # References
///
/// R. Bulirsch, Numer. Math. 7 (1965) 78. DLMF 22.20(ii).
#[derive(Clone, Copy, Debug)]
pub struct JacobiFunctions {
    /// The arithmetic and geometric means, from (1, k') on, and the reciprocals of the first.
    means: [(f64, f64, f64); MAX_STEPS],
    steps: usize,
    /// The limit of the means, agm(1, k').
    limit: Dd,
}

/// Jacobi's functions at one argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JacobiValues {
    /// The sine of the amplitude.
    pub sn: f64,
    /// The cosine of the amplitude.
    pub cn: f64,
    /// The delta of the amplitude, `sqrt(1 - k^2 sn^2)`, never below k'.
    pub dn: f64,
}

impl JacobiFunctions {
    /// Prepares the functions of a complementary parameter.
    #[must_use]
    pub fn of(complementary_parameter: Dd) -> Self {
        // Means that differ by less than this agree to the last digit after one step more.
        const CLOSE: f64 = 1e-8;
        let modulus = complementary_parameter.sqrt();
        let mut means = [(1.0, modulus.hi(), 1.0); MAX_STEPS];
        let mut steps = 0;
        while steps + 1 < MAX_STEPS {
            let (a, b, _) = means[steps];
            steps += 1;
            if (a - b).abs() <= CLOSE * a {
                break;
            }
            let mean = 0.5 * (a + b);
            means[steps] = (mean, (a * b).sqrt(), 1.0 / mean);
        }
        Self {
            means,
            steps,
            limit: agm_dd(Dd::ONE, modulus),
        }
    }

    /// By how much the phase is slower than the argument: `psi = agm(1, k') u`.
    #[must_use]
    pub fn phase_rate(&self) -> Dd {
        self.limit
    }

    /// The quarter period K.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        (Dd::FRAC_PI_2 / self.limit).hi()
    }

    /// sn, cn and dn at the phase whose sine and cosine are given.
    #[must_use]
    pub fn at(&self, (sine, cosine): (f64, f64)) -> JacobiValues {
        // So small an angle is its sine, and the cotangent would leave the exponent range.
        const TINY: f64 = 1e-100;
        if sine.abs() < TINY {
            return JacobiValues {
                sn: sine / self.limit.hi(),
                cn: 1.0_f64.copysign(cosine),
                dn: 1.0,
            };
        }
        let (cotangent, dn) = self.ascend(cosine / sine);
        let sn = (1.0 / (cotangent * cotangent + 1.0).sqrt()).copysign(sine);
        JacobiValues {
            sn,
            cn: cotangent * sn,
            dn,
        }
    }

    /// The amplitude am, unwrapped: it keeps within a right angle of the phase, however many turns that has made.
    #[must_use]
    pub fn amplitude(&self, phase: Dd) -> Dd {
        Self::amplitude_of(&self.at(phase.sin_cos_to_f64()), phase)
    }

    /// The amplitude from the functions at a phase.
    #[must_use]
    pub fn amplitude_of(values: &JacobiValues, phase: Dd) -> Dd {
        let angle = atan2(values.sn, values.cn);
        // The phase is within a quarter turn of the amplitude, so rounded numbers suffice to count the turns.
        let turns = ((phase.hi() - angle) / Dd::TAU.hi()).round();
        if turns == 0.0 {
            return Dd::from(angle);
        }
        Dd::TAU * turns + angle
    }

    /// From the cotangent of the phase to cn/sn and dn: the Landen transformations, all of positive terms.
    fn ascend(&self, cotangent: f64) -> (f64, f64) {
        let mut dn = 1.0;
        let mut ratio = cotangent;
        let mut scaled = self.limit.hi() * cotangent;
        for &(a, b, reciprocal) in self.means[..self.steps].iter().rev() {
            ratio *= scaled;
            scaled *= dn;
            dn = (b + ratio) / (a + ratio);
            ratio = scaled * reciprocal;
        }
        (scaled, dn)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{elliptic_first, sin_cos};

    #[test]
    fn squares_add_to_one_for_every_parameter() {
        for complement in [1e-300, 1e-32, 1e-12, 1e-3, 0.5, 1.0 - 1e-12, 1.0] {
            let functions = JacobiFunctions::of(Dd::from(complement));
            for n in -400..400 {
                let at = functions.at(sin_cos(f64::from(n) * 0.01));
                assert!((at.sn * at.sn + at.cn * at.cn - 1.0).abs() < 1e-15);
                // dn^2 = cn^2 + k'^2 sn^2
                let square = at.cn * at.cn + complement * at.sn * at.sn;
                assert!(
                    (at.dn * at.dn / square - 1.0).abs() < 1e-13,
                    "{complement} {n} {at:?}"
                );
            }
        }
    }

    #[test]
    fn the_amplitude_inverts_the_integral() {
        for complement in [1e-8, 0.2, 0.9] {
            let functions = JacobiFunctions::of(Dd::from(complement));
            for n in 1..50 {
                let amplitude = f64::from(n) * 0.03;
                let phase = functions.phase_rate() * elliptic_first(amplitude, complement);
                let error = (functions.amplitude(phase) - amplitude).hi();
                assert!(error.abs() < 3e-15, "{complement} {amplitude} {error:e}");
            }
        }
    }

    #[test]
    fn the_amplitude_counts_turns() {
        let functions = JacobiFunctions::of(Dd::from(1e-6));
        let turns = Dd::TAU * 1e9;
        let expected = (functions.amplitude(Dd::from(0.7)) + turns).hi();
        assert_eq!(functions.amplitude(turns + 0.7).hi(), expected);
        assert_eq!(functions.amplitude(-turns - 0.7).hi(), -expected);
    }

    #[test]
    fn a_vanishing_modulus_gives_the_circular_functions() {
        let functions = JacobiFunctions::of(Dd::ONE);
        for phase in [0.0, 1e-200, 1e-9, 0.4, 1.9, -3.0] {
            let (sine, cosine) = sin_cos(phase);
            let at = functions.at((sine, cosine));
            assert!((at.sn - sine).abs() <= 1.2e-16 && (at.cn - cosine).abs() <= 1.2e-16);
            assert_eq!(at.dn, 1.0);
        }
    }
}
