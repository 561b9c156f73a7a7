//! Factors between units, exact: products of rational powers of 2, 3, 5, standard gravity and π.

use super::dimension::{PARTS, raise};
use super::rational::{Rational, gcd};
use super::wide::Wide;

/// An exact factor: exponents of the generators 2, 3, 5, 980665 (standard gravity in 10⁻⁵ m/s²) and π,
/// counted in parts of 1/2520 as in [`Dimension`](super::Dimension).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct Scale([i32; 5]);

/// Standard gravity in 10⁻⁵ m/s², exact by definition (3rd General Conference on Weights and Measures, 1901).
const GRAVITY: u64 = 980_665;

/// Powers of ten that are exact in binary64, so that a product or quotient with one of them is rounded once.
pub(crate) const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

impl Scale {
    pub(crate) const ONE: Self = Self([0; 5]);
    /// A full turn in radians, 2π.
    pub(crate) const TURN: Self = Self::of([1, 0, 0, 0, 1]);

    /// With whole exponents.
    pub(crate) const fn of(exponents: [i8; 5]) -> Self {
        let mut parts = [0; 5];
        let mut i = 0;
        while i < 5 {
            parts[i] = exponents[i] as i32 * PARTS;
            i += 1;
        }
        Self(parts)
    }

    /// A power of ten.
    pub(crate) const fn ten(power: i32) -> Self {
        Self([power * PARTS, 0, power * PARTS, 0, 0])
    }

    pub(crate) fn times(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].saturating_add(other.0[i])
        }))
    }

    pub(crate) fn inverse(self) -> Self {
        Self(self.0.map(i32::saturating_neg))
    }

    pub(crate) fn pow(self, power: Rational) -> Option<Self> {
        raise(self.0, power).map(Self)
    }

    /// The exponent, if it is a power of ten.
    pub(crate) fn as_power_of_ten(self) -> Option<i32> {
        let [two, three, five, gravity, pi] = self.0;
        let rest = three | gravity | pi;
        (rest == 0 && two == five && two % PARTS == 0).then_some(two / PARTS)
    }

    /// The product with a wide number, with all digits.
    pub(crate) fn apply(self, value: Wide) -> Wide {
        let divisor = self.0.iter().fold(i64::from(PARTS), |divisor, &exponent| {
            gcd(divisor, i64::from(exponent))
        });
        let degree = PARTS / divisor as i32;
        if degree == 1 {
            return self.product(value, PARTS);
        }
        value.times(
            self.product(Wide::ONE, divisor as i32)
                .root(degree.unsigned_abs()),
        )
    }

    /// The value times all generators with their exponents divided by `parts`; the divisions come last, as one.
    fn product(self, value: Wide, parts: i32) -> Wide {
        let [two, three, five, gravity, pi] = self.0.map(|exponent| exponent / parts);
        let (mut above, mut below) = (value.doubled(two), Wide::ONE);
        for (generator, exponent) in [(3, three), (5, five), (GRAVITY, gravity)] {
            match exponent.signum() {
                1 => above = above.times(Wide::power(generator, exponent.unsigned_abs())),
                -1 => below = below.times(Wide::power(generator, exponent.unsigned_abs())),
                _ => {}
            }
        }
        match pi.signum() {
            1 => above = above.times(Wide::PI.pow(pi.unsigned_abs())),
            -1 => below = below.times(Wide::PI.pow(pi.unsigned_abs())),
            _ => {}
        }
        above.over(below)
    }

    /// The product with a binary64, rounded once; zero, infinity and NaN stay what they are.
    pub(crate) fn apply_f64(self, value: f64) -> f64 {
        match self.as_power_of_ten() {
            Some(0) => value,
            Some(power @ 1..=22) => value * TENS[power as usize],
            Some(power @ -22..=-1) => value / TENS[power.unsigned_abs() as usize],
            _ => {
                Wide::of_f64(value).map_or(value, |wide| self.apply(wide).to_f64().copysign(value))
            }
        }
    }

    /// A bound on how many bits it moves the binary point, up or down.
    pub(crate) fn most_bits(self) -> i64 {
        let bits = [1, 2, 3, 20, 2];
        self.0
            .iter()
            .zip(bits)
            .map(|(exponent, bits)| {
                i64::from(exponent.unsigned_abs()) * bits / i64::from(PARTS) + 1
            })
            .sum()
    }
}
