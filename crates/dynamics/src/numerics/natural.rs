//! Natural numbers of any size, as far as exact comparisons need them.

use std::cmp::Ordering;
use std::ops::{Add, Mul};

/// A natural number; its digits to the base `2^32`, the lowest first, without leading zeros.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Natural {
    digits: Vec<u32>,
}

impl Natural {
    pub(crate) const ZERO: Self = Self { digits: Vec::new() };

    pub(crate) fn one() -> Self {
        Self { digits: vec![1] }
    }

    /// Multiplies it by `base^exponent`.
    pub(crate) fn scale(&mut self, base: u32, exponent: u32) {
        // The powers of a small base are gathered as long as they fit into one digit.
        let (mut left, mut factor) = (exponent, 1_u32);
        while left > 0 {
            factor = factor.checked_mul(base).unwrap_or_else(|| {
                self.multiply_by(factor);
                base
            });
            left -= 1;
        }
        self.multiply_by(factor);
    }

    fn multiply_by(&mut self, factor: u32) {
        let mut carry = 0_u64;
        for digit in &mut self.digits {
            carry += u64::from(*digit) * u64::from(factor);
            *digit = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.digits.push(carry as u32);
        }
    }

    fn without_leading_zeros(mut digits: Vec<u32>) -> Self {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        Self { digits }
    }
}

impl From<u128> for Natural {
    fn from(value: u128) -> Self {
        Self::without_leading_zeros((0..4).map(|at| (value >> (32 * at)) as u32).collect())
    }
}

impl Add for &Natural {
    type Output = Natural;

    #[expect(clippy::suspicious_arithmetic_impl, reason = "carries are shifted out")]
    fn add(self, other: Self) -> Natural {
        let length = self.digits.len().max(other.digits.len()) + 1;
        let mut carry = 0;
        let digits = (0..length).map(|at| {
            carry += digit(self, at) + digit(other, at);
            let low = carry as u32;
            carry >>= 32;
            low
        });
        Natural::without_leading_zeros(digits.collect())
    }
}

/// A digit of a number, zero above its last.
fn digit(number: &Natural, at: usize) -> u64 {
    number.digits.get(at).map_or(0, |digit| u64::from(*digit))
}

impl Mul for &Natural {
    type Output = Natural;

    fn mul(self, other: Self) -> Natural {
        let mut digits = vec![0_u32; self.digits.len() + other.digits.len()];
        for (shift, left) in self.digits.iter().enumerate() {
            let mut carry = 0_u64;
            for (at, right) in other.digits.iter().enumerate() {
                carry += u64::from(digits[shift + at]) + u64::from(*left) * u64::from(*right);
                digits[shift + at] = carry as u32;
                carry >>= 32;
            }
            digits[shift + other.digits.len()] = carry as u32;
        }
        Natural::without_leading_zeros(digits)
    }
}

impl PartialOrd for Natural {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Natural {
    fn cmp(&self, other: &Self) -> Ordering {
        let by_length = self.digits.len().cmp(&other.digits.len());
        by_length.then_with(|| self.digits.iter().rev().cmp(other.digits.iter().rev()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn natural(value: u128) -> Natural {
        Natural::from(value)
    }

    #[test]
    fn sums_and_products_carry() {
        let (a, b) = (u128::from(u64::MAX), u128::from(u64::MAX) - 12_345);
        assert_eq!(&natural(a) + &natural(b), natural(a + b));
        assert_eq!(&natural(a) * &natural(b), natural(a * b));
        assert_eq!(&natural(0) * &natural(b), Natural::ZERO);
    }

    #[test]
    fn powers_scale() {
        let mut scaled = natural(7);
        scaled.scale(5, 50);
        assert_eq!(scaled, natural(7 * 5_u128.pow(50)));
        scaled.scale(2, 0);
        assert_eq!(scaled, natural(7 * 5_u128.pow(50)));
    }

    #[test]
    fn order_is_that_of_the_numbers() {
        assert!(natural(1 << 40) > natural((1 << 40) - 1));
        assert!(natural(1 << 100) > natural(u128::from(u64::MAX)));
        assert!(Natural::ZERO < Natural::one());
    }
}
