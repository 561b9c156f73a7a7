//! The free motion of one mode, whose stiffness may be zero or negative and is known to thirty digits.

use super::ScaledMotion;
use super::critical::Critical;
use super::oscillating::Oscillating;
use super::overdamped::Overdamped;
use crate::numerics::{Dd, binary_exponent};
use crate::vibration::state::State;

/// Beyond this damping, in units of the natural frequency, the square of the damping coefficient is all that counts.
const LARGE_DAMPING: f64 = 1e30;

/// Exponent of the power of two next to the natural frequency, or to the damping if there is no stiffness.
pub(crate) fn rate_exponent(damping: Dd, stiffness: Dd) -> i32 {
    if stiffness != Dd::ZERO {
        binary_exponent(stiffness.hi()).div_euclid(2)
    } else if damping != Dd::ZERO {
        binary_exponent(damping.hi())
    } else {
        0
    }
}

/// The motion in units of the rate.
pub(crate) fn motion(damping: Dd, stiffness: Dd, initial: State) -> ScaledMotion {
    let State { position, velocity } = initial;
    let discriminant = damping.square() - stiffness * 4.0;
    let root = if damping.hi().abs() > LARGE_DAMPING {
        damping.abs()
    } else {
        discriminant.abs().sqrt()
    };
    let growth = damping * -0.5;
    if discriminant == Dd::ZERO {
        let slope = (velocity - growth * position).hi();
        return ScaledMotion::Critical(Critical {
            initial,
            position_slope: slope,
            velocity_slope: growth.hi() * slope,
            growth,
        });
    }
    if discriminant.is_negative() {
        return ScaledMotion::Oscillating(Oscillating {
            initial,
            position_sine: ((damping * position + 2.0 * velocity) / root).hi(),
            velocity_sine: (-(stiffness * 2.0 * position + damping * velocity) / root).hi(),
            growth,
            frequency: root * 0.5,
            is_damped: damping != Dd::ZERO,
        });
    }
    let (slow, fast) = roots(damping, stiffness, root);
    ScaledMotion::Overdamped(Overdamped {
        initial,
        slow,
        fast,
        gap: root.hi(),
        beyond_slow: (velocity - slow * position).hi(),
        beyond_fast: (velocity - fast * position).hi(),
    })
}

/// The larger and the smaller root of `r² + c r + k = 0`, without cancellation for either sign of c.
fn roots(damping: Dd, stiffness: Dd, root: Dd) -> (Dd, Dd) {
    if damping.is_negative() {
        let sum = root - damping;
        (sum * 0.5, stiffness * 2.0 / sum)
    } else {
        let sum = root + damping;
        (stiffness * -2.0 / sum, sum * -0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{cosh, exp, sinh};
    use crate::vibration::FreeResponse;
    use crate::vibration::Oscillator;

    const INITIAL: State = State {
        position: 0.3,
        velocity: -0.7,
    };

    #[test]
    fn plain_numbers_give_the_motion_of_the_oscillator() {
        for damping in [0.0, 0.1, 3.0, 4.0, 40.0] {
            let oscillator = Oscillator::new(1.0, damping, 4.0).unwrap();
            let expected = FreeResponse::of(&oscillator, INITIAL);
            let motion = FreeResponse::of_mode(Dd::from(damping), Dd::from(4.0), INITIAL);
            for time in [0.0, 0.25, 1.0, 7.5] {
                let (a, b) = (motion.state(time), expected.state(time));
                assert!((a.position - b.position).abs() < 1e-15, "{damping} {time}");
                assert!((a.velocity - b.velocity).abs() < 4e-15, "{damping} {time}");
            }
        }
    }

    #[test]
    fn rigid_motion_is_uniform_or_comes_to_rest() {
        let motion = FreeResponse::of_mode(Dd::ZERO, Dd::ZERO, INITIAL);
        assert_eq!(
            motion.state(10.0),
            State {
                position: 0.3 - 7.0,
                velocity: -0.7
            }
        );
        let motion = FreeResponse::of_mode(Dd::from(2.0), Dd::ZERO, INITIAL);
        assert!((motion.position(1e3) - (0.3 - 0.35)).abs() < 1e-16);
        assert!((motion.state(0.5).velocity + 0.7 * exp(-1.0)).abs() < 1e-16);
    }

    #[test]
    fn negative_stiffness_grows() {
        let motion = FreeResponse::of_mode(Dd::ZERO, Dd::from(-4.0), INITIAL);
        let expected = 0.3 * cosh(6.0) - 0.35 * sinh(6.0);
        assert!((motion.position(3.0) / expected - 1.0).abs() < 1e-13);
    }
}
