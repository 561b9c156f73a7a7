//! The four operations, and the order of long numbers.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Long, WORDS};

impl Neg for Long {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            is_negative: !self.is_negative && !self.is_zero(),
            ..self
        }
    }
}

impl Add for Long {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (large, small) = match self.compare_size(other) {
            Ordering::Less => (other, self),
            _ => (self, other),
        };
        if small.is_zero() {
            return large;
        }
        // One word below the larger number takes what the smaller one reaches beyond it.
        let distance = large.exponent.abs_diff(small.exponent) as usize;
        let (skipped, shift) = (distance / 64, (distance % 64) as u32);
        let word = |place: usize| {
            let at = |place: usize| match place {
                0 => 0,
                _ => small.words.get(place - 1).copied().unwrap_or(0),
            };
            let above = if shift == 0 {
                0
            } else {
                at(place + skipped + 1) << (64 - shift)
            };
            at(place + skipped) >> shift | above
        };
        let mut words = [0; WORDS + 2];
        words[1..=WORDS].copy_from_slice(&large.words);
        let is_difference = large.is_negative != small.is_negative;
        let mut carried = false;
        for (place, sum) in words.iter_mut().enumerate() {
            let part = word(place);
            let (first, second) = if is_difference {
                let (first, borrowed) = sum.overflowing_sub(part);
                let (second, again) = first.overflowing_sub(u64::from(carried));
                (second, borrowed | again)
            } else {
                let (first, over) = sum.overflowing_add(part);
                let (second, again) = first.overflowing_add(u64::from(carried));
                (second, over | again)
            };
            (*sum, carried) = (first, second);
        }
        Self::of_words(large.is_negative, &words, large.exponent - 64)
    }
}

impl Sub for Long {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Long {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut words = [0_u64; 2 * WORDS];
        for (i, a) in self.words.iter().enumerate() {
            let mut carried = 0;
            for (j, b) in other.words.iter().enumerate() {
                let part = u128::from(*a) * u128::from(*b) + u128::from(words[i + j]) + carried;
                words[i + j] = part as u64;
                carried = part >> 64;
            }
            words[i + WORDS] = carried as u64;
        }
        let is_negative = self.is_negative != other.is_negative;
        Self::of_words(
            is_negative,
            &words,
            self.exponent.saturating_add(other.exponent),
        )
    }
}

impl Div for Long {
    type Output = Self;

    /// The divisor must not be zero.
    fn div(self, divisor: Self) -> Self {
        if self.is_zero() {
            return self;
        }
        // 1/d from sixteen digits; each step doubles them.
        let scaled = divisor.shifted(-divisor.magnitude());
        let one = Self::from(1.0);
        let reciprocal = (0..4).fold(Self::from(1.0 / scaled.to_f64()), |x, _| {
            x + x * (one - scaled * x)
        });
        (self * reciprocal).shifted(-divisor.magnitude())
    }
}

impl PartialEq for Long {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Long {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let by_size = self.compare_size(*other);
        Some(match (self.is_negative, other.is_negative) {
            (false, false) => by_size,
            (true, true) => by_size.reverse(),
            (false, true) => Ordering::Greater,
            (true, false) => Ordering::Less,
        })
    }
}
