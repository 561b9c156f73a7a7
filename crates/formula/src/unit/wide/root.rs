//! Roots.

use super::{Wide, shift_up};

impl Wide {
    /// The root of a degree of which all prime factors are small.
    pub(crate) fn root(self, degree: u32) -> Self {
        let (mut result, mut degree) = (self, degree);
        for prime in [2, 3, 5, 7] {
            while degree % prime == 0 {
                result = result.prime_root(prime);
                degree /= prime;
            }
        }
        result
    }

    /// Newton's iteration `y = ((q - 1) y + x/y^(q-1))/q`, which doubles the digits each time.
    fn prime_root(self, q: u32) -> Self {
        let degree = q as i32;
        let (scale, rest) = (self.top().div_euclid(degree), self.top().rem_euclid(degree));
        let reduced = Self {
            exponent: rest - 255,
            ..self
        };
        let mut root = Self::of_f64(first_root(reduced.to_f64(), q)).unwrap_or(Self::ONE);
        for _ in 0..3 {
            let others = Self::small(u64::from(q - 1)).times(root);
            root = others
                .plus(reduced.over(root.pow(q - 1)))
                .over(Self::small(u64::from(q)));
        }
        Self {
            exponent: root.exponent.saturating_add(scale),
            cut: true,
            ..root
        }
    }

    fn plus(self, other: Self) -> Self {
        let (large, small) = if self.exponent >= other.exponent {
            (self, other)
        } else {
            (other, self)
        };
        let mut sum = [0_u64; 8];
        sum[3..7].copy_from_slice(&large.mantissa);
        let distance = large.exponent.abs_diff(small.exponent);
        let (limbs, bits) = ((distance / 64) as usize, distance % 64);
        let mut shifted = [0_u64; 8];
        for (i, &limb) in small
            .mantissa
            .iter()
            .enumerate()
            .filter(|&(i, _)| i + 3 >= limbs)
        {
            shifted[i + 3 - limbs] |= limb >> bits;
            if bits > 0 && i + 2 >= limbs {
                shifted[i + 2 - limbs] |= limb << (64 - bits);
            }
        }
        let mut carry = 0;
        for (a, b) in sum.iter_mut().zip(shifted) {
            let total = u128::from(*a) + u128::from(b) + carry;
            *a = total as u64;
            carry = total >> 64;
        }
        // The sum stands one limb below the top, which leaves room for the carry, and is moved up to it.
        let gap = sum[7].leading_zeros();
        let exponent = large.exponent.saturating_sub(192 + gap as i32);
        Self::normalized(
            shift_up(sum, gap),
            exponent,
            large.cut || small.cut || distance > 192,
        )
    }
}

/// A root of a number from 1 up to `2^q`, to about 50 bits: Newton's iteration from above.
fn first_root(value: f64, q: u32) -> f64 {
    let mut root = 2.0_f64;
    for _ in 0..24 {
        let power = (1..q).fold(1.0, |power, _| power * root);
        root -= (power * root - value) / (f64::from(q) * power);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_square_back() {
        for (value, degree) in [(10, 2), (10, 3), (7, 7), (980_665, 10), (3, 2520)] {
            let back = Wide::integer(value).unwrap().root(degree).pow(degree);
            let (high, low) = back.to_pair();
            assert!(
                (high - (value as f64)).abs() == 0.0 && low.abs() < 1e-60 * (value as f64),
                "{value} {degree}"
            );
        }
    }
}
