//! The period of a swing.

use super::PendulumError;
use crate::numerics::{Dd, agm, cos, ln, sin};

/// Below this cosine of half the amplitude a period comes from the mean, above it from the series of its excess.
const STEEP: f64 = 0.5;

/// The same for the excess, which profits from the series for longer.
const STEEP_FOR_EXCESS: f64 = 0.1;

/// Below this cosine two terms of the expansion next to the top are exact to the last digit, and rounded less often.
const NEXT_TO_THE_TOP: f64 = 1e-4;

/// The period for an amplitude, by that of small swings.
pub(crate) fn of(small: Dd, amplitude: f64) -> Result<f64, PendulumError> {
    let half = half_amplitude(amplitude)?;
    let versine = versine(half);
    Ok(if !small.is_finite() {
        small.hi()
    } else if versine <= 1.0 - STEEP {
        // The rounding of the sum is the only one of its size: the series is the smaller part of the
        // period.
        small.hi() + (small.hi() * series(versine) + small.lo())
    } else {
        (small * reciprocal_mean(cos(half))).hi()
    })
}

/// By which part it exceeds that of small swings.
pub(crate) fn excess(amplitude: f64) -> Result<f64, PendulumError> {
    let half = half_amplitude(amplitude)?;
    let versine = versine(half);
    if versine <= 1.0 - STEEP_FOR_EXCESS {
        Ok(series(versine))
    } else {
        Ok(reciprocal_mean(cos(half)) - 1.0)
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

/// `((2n-1)!!/(2n)!!)²` for n = 1, 2, ..., 12, all of them exact.
const SQUARES: [f64; 12] = [
    1.0 / 4.0,
    9.0 / 64.0,
    25.0 / 256.0,
    1_225.0 / 16_384.0,
    3_969.0 / 65_536.0,
    53_361.0 / 1_048_576.0,
    184_041.0 / 4_194_304.0,
    41_409_225.0 / 1_073_741_824.0,
    147_744_025.0 / 4_294_967_296.0,
    2_133_423_721.0 / 68_719_476_736.0,
    7_775_536_041.0 / 274_877_906_944.0,
    457_028_729_521.0 / 17_592_186_044_416.0,
];

/// `1 - cos(half)`, without cancellation.
fn versine(half: f64) -> f64 {
    let sine = sin(0.5 * half);
    2.0 * sine * sine
}

/// `1/agm(1, 1 - versine) - 1`, every term positive, by two of Landen's steps at once and a short series,
///
/// ```text
/// y = (1 - √c)/(1 + √c),   1/agm(1, c) = (1 + y)² (1 + (1/2)² y⁴ + (1·3/(2·4))² y⁸ + ...)
/// ```
///
/// where y⁴ is below 1/1000 for a cosine c of 0.5 or more, and below 0.08 for one of 0.1 (DLMF 19.8.12, 19.5.1).
fn series(versine: f64) -> f64 {
    // The sixth power of y⁴ is less than 1e-18.
    const FEW: usize = 5;
    let sum = 1.0 + (1.0 - versine).sqrt();
    let y = versine / (sum * sum);
    let power = (y * y) * (y * y);
    let needed = if power < 1e-3 {
        &SQUARES[..FEW]
    } else {
        &SQUARES
    };
    let tail = power
        * needed
            .iter()
            .rev()
            .fold(0.0, |sum, term| sum * power + term);
    let square = y * (2.0 + y);
    square + tail * (1.0 + square)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::Pendulum;

    #[test]
    fn the_forms_meet() {
        let above = NEXT_TO_THE_TOP.next_up();
        assert!((reciprocal_mean(above) / reciprocal_mean(NEXT_TO_THE_TOP) - 1.0).abs() < 6e-16);
        for cosine in [STEEP_FOR_EXCESS, STEEP, 0.6, 0.9, 1.0] {
            let excess = series(1.0 - cosine);
            assert!(
                (1.0 / agm(1.0, cosine) - 1.0 - excess).abs() < 1e-15,
                "{cosine}"
            );
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
