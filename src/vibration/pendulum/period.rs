//! The period of a swing.

use super::{Pendulum, PendulumError};
use crate::numerics::{Dd, agm, cos, ln, sin};

/// Below this cosine of half the amplitude a period comes from the mean itself, above it from what that lacks of 1.
const STEEP: f64 = 0.5;

/// The same for the excess, which profits from the second form for longer.
const STEEP_FOR_EXCESS: f64 = 0.1;

/// Below this cosine two terms of the expansion next to the top are exact to the last digit, and rounded less often.
const NEXT_TO_THE_TOP: f64 = 1e-4;

impl Pendulum {
    /// Period of small swings, in s.
    ///
    /// ```text
    /// T0 = 2 pi sqrt(L/g)
    /// ```
    #[must_use]
    pub fn small_period(&self) -> f64 {
        self.small_period_dd().hi()
    }

    /// Period of a swing released from rest at the angle `amplitude`, in s, to two units in the last place.
    ///
    /// ```text
    /// T = T0/agm(1, cos(theta0/2))
    /// ```
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::vibration::Pendulum;
    ///
    /// // The largest number below π: it stays near the top for a long time.
    /// let period = Pendulum::new(9.81, 9.81).unwrap().period(std::f64::consts::PI).unwrap();
    /// assert!((period - 154.872_602_217_555_25).abs() < 6e-14);
    /// ```
    ///
    /// # Errors
    ///
    /// [`PendulumError::Amplitude`] from a half turn on: there it does not swing back.
    pub fn period(&self, amplitude: f64) -> Result<f64, PendulumError> {
        let half = half_amplitude(amplitude)?;
        let cosine = cos(half);
        let small = self.small_period_dd();
        let period = if cosine < STEEP {
            small * reciprocal_mean(cosine)
        } else {
            small * (Dd::ONE + excess_of_mean(mean_deficit(half)))
        };
        Ok(period.hi())
    }

    /// By which part the period of a swing exceeds that of small swings, `T/T0 - 1`, without cancellation.
    ///
    /// It begins as `theta0^2/16`.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::vibration::Pendulum;
    ///
    /// let excess = Pendulum::new(1.0, 9.81).unwrap().period_excess(1e-12).unwrap();
    /// assert_eq!(excess, 6.25e-26);
    /// ```
    ///
    /// # Errors
    ///
    /// [`PendulumError::Amplitude`] from a half turn on.
    pub fn period_excess(&self, amplitude: f64) -> Result<f64, PendulumError> {
        let half = half_amplitude(amplitude)?;
        let cosine = cos(half);
        if cosine < STEEP_FOR_EXCESS {
            Ok(reciprocal_mean(cosine) - 1.0)
        } else {
            Ok(excess_of_mean(mean_deficit(half)))
        }
    }

    fn small_period_dd(&self) -> Dd {
        (Dd::TAU / self.rate).scale(-self.exponent)
    }
}

fn half_amplitude(amplitude: f64) -> Result<f64, PendulumError> {
    let magnitude = amplitude.abs();
    // The double π lies below the number π, so it is an amplitude.
    if magnitude <= Dd::PI.hi() {
        Ok(0.5 * magnitude)
    } else {
        Err(PendulumError::Amplitude(amplitude))
    }
}

/// `1/agm(1, cosine) = (2/pi) K`, next to the top by the logarithm to which it tends (DLMF 19.12.1).
fn reciprocal_mean(cosine: f64) -> f64 {
    if cosine > NEXT_TO_THE_TOP {
        return 1.0 / agm(1.0, cosine);
    }
    let logarithm = ln(4.0 / cosine);
    let quarter_period = logarithm + 0.25 * cosine * cosine * (logarithm - 1.0);
    quarter_period / Dd::FRAC_PI_2.hi()
}

/// `1 - agm(1, cos(half))`, as the mean of 1 - p and 1 - q with every step a sum of positive terms.
fn mean_deficit(half: f64) -> f64 {
    const CLOSE: f64 = 1e-9;
    let sine = sin(0.5 * half);
    let (mut p, mut q) = (0.0, 2.0 * sine * sine);
    while (p - q).abs() > CLOSE * q {
        let rest = p + q * (1.0 - p);
        (p, q) = (0.5 * (p + q), rest / (1.0 + (1.0 - rest).sqrt()));
    }
    0.5 * (p + q)
}

fn excess_of_mean(deficit: f64) -> f64 {
    deficit / (1.0 - deficit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forms_meet() {
        let above = NEXT_TO_THE_TOP.next_up();
        assert!((reciprocal_mean(above) / reciprocal_mean(NEXT_TO_THE_TOP) - 1.0).abs() < 6e-16);
        for cosine in [STEEP, STEEP_FOR_EXCESS] {
            let deficit = mean_deficit(crate::numerics::acos(cosine));
            assert!((1.0 - agm(1.0, cosine) - deficit).abs() < 4e-16, "{cosine}");
        }
    }

    #[test]
    fn amplitudes_from_a_half_turn_on_are_refused() {
        let pendulum = Pendulum::new(1.0, 1.0).unwrap();
        for amplitude in [3.141_592_653_589_793_6, -4.0, f64::INFINITY, f64::NAN] {
            assert!(matches!(
                pendulum.period(amplitude),
                Err(PendulumError::Amplitude(_))
            ));
            assert!(pendulum.period_excess(amplitude).is_err());
        }
        assert_eq!(pendulum.period(-1.0), pendulum.period(1.0));
    }

    #[test]
    fn vanishing_amplitudes_keep_their_excess() {
        let pendulum = Pendulum::new(1.0, 1.0).unwrap();
        assert_eq!(pendulum.period_excess(0.0), Ok(0.0));
        assert_eq!(pendulum.period_excess(4e-150), Ok(1e-300));
    }
}
