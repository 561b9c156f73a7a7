//! Mass, damping and stiffness to 105 bits, in units that keep their products within the exponent range.

use crate::numerics::{Dd, ExactNumber, binary_exponent, sign_of_sum};
use crate::vibration::oscillator::Regime;

/// An oscillator in units of mass and time that are powers of two.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    pub(crate) regime: Regime,
    pub(crate) mass: Dd,
    pub(crate) damping: Dd,
    pub(crate) stiffness: Dd,
    /// The square root of `|c^2 - 4 m k|`.
    pub(crate) root: Dd,
    /// The unit of time is 2 to the negative of this power.
    pub(crate) rate_exponent: i32,
}

impl Scale {
    pub(crate) fn of(mass: ExactNumber, damping: ExactNumber, stiffness: ExactNumber) -> Self {
        let of_mass = binary_exponent(mass.to_f64());
        let rate_exponent = (binary_exponent(stiffness.to_f64()) - of_mass).div_euclid(2);
        let scale = Self {
            regime: Regime::Undamped,
            mass: mass.to_dd().scale(-of_mass),
            damping: damping.to_dd().scale(-of_mass - rate_exponent),
            stiffness: stiffness.to_dd().scale(-of_mass - 2 * rate_exponent),
            root: Dd::ZERO,
            rate_exponent,
        };
        let (regime, root) = scale.regime_and_root([mass, damping, stiffness]);
        Self {
            regime,
            root,
            ..scale
        }
    }

    /// The regime by the exact sign of `c^2 - 4 m k`, and the root of its magnitude.
    fn regime_and_root(&self, [mass, damping, stiffness]: [ExactNumber; 3]) -> (Regime, Dd) {
        let product = (self.mass * self.stiffness).scale(2);
        if damping.is_zero() {
            return (Regime::Undamped, product.sqrt());
        }
        if self.damping.hi() > LARGE_DAMPING {
            return (Regime::Overdamped, self.damping);
        }
        let square = self.damping.square();
        let difference = square - product;
        let sign = if is_decided(difference, square.hi()) {
            difference.hi().total_cmp(&0.0)
        } else {
            sign_of_sum(&[
                &[damping, damping],
                &[-ExactNumber::from(4), mass, stiffness],
            ])
        };
        match sign {
            std::cmp::Ordering::Less => (Regime::Underdamped, difference.abs().sqrt()),
            std::cmp::Ordering::Equal => (Regime::Critical, Dd::ZERO),
            std::cmp::Ordering::Greater => (Regime::Overdamped, difference.abs().sqrt()),
        }
    }

    /// Whether the squares of all rates are within the exponent range.
    pub(crate) fn is_moderate(&self) -> bool {
        // Its square, 1e300, is still within the range of binary64.
        const MAX_DAMPING: f64 = 1e150;
        self.damping.hi() < MAX_DAMPING
    }

    pub(crate) fn oscillates(&self) -> bool {
        matches!(self.regime, Regime::Undamped | Regime::Underdamped)
    }

    /// The time between two turning points, `pi/omega_d`, in units of the scale.
    pub(crate) fn half_period(&self) -> Dd {
        Dd::TAU * self.mass / self.root
    }

    /// What decays in a half-cycle, `theta = lambda pi/omega_d`: amplitudes shrink by `e^-theta`; 0 if there is none.
    pub(crate) fn decay_in_half_period(&self) -> Dd {
        if self.regime == Regime::Underdamped {
            Dd::PI * self.damping / self.root
        } else {
            Dd::ZERO
        }
    }
}

/// Beyond this `4 m k` is below the last digit of `c^2`.
const LARGE_DAMPING: f64 = 1e30;

/// Whether a difference of numbers of this size has a sign that rounding cannot have changed.
pub(crate) fn is_decided(difference: Dd, size: f64) -> bool {
    // Five digits above 2^-106: what the products and sums of a difference lose together is less.
    const RESOLUTION: f64 = 1e-27;
    difference.hi().abs() > RESOLUTION * size.abs()
}

/// A product over a number, without leaving the exponent range on the way.
pub(crate) fn ratio(factors: &[ExactNumber], divisor: ExactNumber) -> Dd {
    // Three of these over a fourth stay within 1e±240.
    const ORDINARY: std::ops::Range<f64> = 1e-60..1e60;
    let is_ordinary = |number: &ExactNumber| ORDINARY.contains(&number.to_f64().abs());
    if factors.iter().all(is_ordinary) && is_ordinary(&divisor) {
        return product(factors, |factor| factor.to_dd()) / divisor.to_dd();
    }
    // A zero has the smallest integer for an exponent, and sums of these would overflow.
    let exponent = |number: &ExactNumber| binary_exponent(number.to_f64()).clamp(-1100, 1100);
    let mantissa = |number: &ExactNumber| number.to_dd().scale(-exponent(number));
    let total: i32 = factors.iter().map(exponent).sum();
    (product(factors, mantissa) / mantissa(&divisor)).scale(total - exponent(&divisor))
}

/// The product of a part of each number.
fn product(numbers: &[ExactNumber], part: impl Fn(&ExactNumber) -> Dd) -> Dd {
    let parts = numbers.iter().map(part);
    parts
        .reduce(|product, part| product * part)
        .unwrap_or(Dd::ONE)
}
