//! Numbers of 256 bits, for the few places where thirty digits do not tell a number from zero.
//!
//! Slow and small: a product is one loop over words, a quotient one over bits. An operation drops less than 2^-250 of its
//! result, and also where most of two numbers cancels, what is left is as good.

mod functions;

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{binary_exponent, scale_by_power_of_two};

/// Words of a number, the lowest first.
const WORDS: usize = 4;

/// Bits of a number.
const BITS: i32 = 64 * WORDS as i32;

/// A number of 256 bits.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::Long;
///
/// let x = Long::from(1e-9);
/// let rest = (Long::from(1.0) - x * x / Long::from(2.0)) / x.cos() - Long::from(1.0);
/// assert!((rest.to_f64() / -4.166_666_666_666_667e-38 - 1.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Long {
    // ± words · 2^exponent; the highest bit of the words is set, or all are zero.
    is_negative: bool,
    words: [u64; WORDS],
    exponent: i32,
}

impl Long {
    /// 0.
    pub const ZERO: Self = Self {
        is_negative: false,
        words: [0; WORDS],
        exponent: 0,
    };

    /// π.
    pub const PI: Self = Self {
        is_negative: false,
        words: [
            0x020b_bea6_3b13_9b22,
            0x2902_4e08_8a67_cc74,
            0xc4c6_628b_80dc_1cd1,
            0xc90f_daa2_2168_c234,
        ],
        exponent: -254,
    };

    /// The number of these words, of any count; what does not fit is dropped.
    fn of_words(is_negative: bool, words: &[u64], exponent: i32) -> Self {
        let Some(top) = words.iter().rposition(|word| *word != 0) else {
            return Self::ZERO;
        };
        let shift = words[top].leading_zeros();
        let word = |place: Option<usize>| place.map_or(0, |place| words[place]);
        let from_below = |place: usize| {
            let below = word(place.checked_sub(1));
            if shift == 0 { 0 } else { below >> (64 - shift) }
        };
        let lowest = top as i32 + 1 - WORDS as i32;
        let words = std::array::from_fn(|i| {
            usize::try_from(lowest + i as i32)
                .map_or(0, |place| word(Some(place)) << shift | from_below(place))
        });
        Self {
            is_negative,
            words,
            exponent: exponent + 64 * lowest - shift as i32,
        }
    }

    /// Whether it is 0.
    pub fn is_zero(self) -> bool {
        self.words[WORDS - 1] == 0
    }

    /// Magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        Self {
            is_negative: false,
            ..self
        }
    }

    /// This number times a power of two.
    #[must_use]
    fn shifted(self, by: i32) -> Self {
        if self.is_zero() {
            return self;
        }
        Self {
            exponent: self.exponent.saturating_add(by),
            ..self
        }
    }

    /// The place of its highest bit: 0 for numbers from 1 to 2.
    fn magnitude(self) -> i32 {
        self.exponent + BITS - 1
    }

    /// The nearest binary64.
    pub fn to_f64(self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        // The lower word only decides how the upper one is rounded.
        let odd = u64::from(self.words[..WORDS - 1].iter().any(|word| *word != 0));
        let high = (self.words[WORDS - 1] | odd) as f64;
        let exponent = self.exponent.saturating_add(64 * (WORDS as i32 - 1));
        let value = scale_by_power_of_two(high, exponent.clamp(-3000, 3000));
        if self.is_negative { -value } else { value }
    }

    /// The magnitudes' order.
    fn compare_size(self, other: Self) -> Ordering {
        if self.is_zero() || other.is_zero() {
            return other.is_zero().cmp(&self.is_zero());
        }
        let by_exponent = self.exponent.cmp(&other.exponent);
        by_exponent.then_with(|| self.words.iter().rev().cmp(other.words.iter().rev()))
    }

    /// Largest integer that is not above.
    #[must_use]
    pub fn floor(self) -> Self {
        let below = -self.exponent;
        if below <= 0 || self.is_zero() {
            return self;
        }
        let mut words = self.words;
        for (i, word) in words.iter_mut().enumerate() {
            let dropped = (below - 64 * i as i32).clamp(0, 64);
            *word = if dropped == 64 {
                0
            } else {
                *word >> dropped << dropped
            };
        }
        let whole = Self::of_words(self.is_negative, &words, self.exponent);
        let is_whole = whole.compare_size(self) == Ordering::Equal;
        if self.is_negative && !is_whole {
            whole - Self::from(1.0)
        } else {
            whole
        }
    }

    /// The quotient by a small integer.
    #[must_use]
    fn over(self, divisor: u64) -> Self {
        let mut words = [0; WORDS + 1];
        let mut rest = 0;
        for (place, quotient) in words.iter_mut().enumerate().rev() {
            let word = place.checked_sub(1).map_or(0, |place| self.words[place]);
            let part = u128::from(rest) << 64 | u128::from(word);
            *quotient = (part / u128::from(divisor)) as u64;
            rest = (part % u128::from(divisor)) as u64;
        }
        Self::of_words(self.is_negative, &words, self.exponent - 64)
    }

    /// The square root of a number that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.is_zero() {
            return self;
        }
        let half = self.magnitude().div_euclid(2);
        let scaled = self.shifted(-2 * half);
        // Each step doubles the digits.
        let root = (0..4).fold(Self::from(scaled.to_f64().sqrt()), |root, _| {
            (root + scaled / root).shifted(-1)
        });
        root.shifted(half)
    }

    /// The power with a whole exponent.
    #[must_use]
    pub fn powi(self, exponent: i32) -> Self {
        let (mut power, mut square) = (Self::from(1.0), self);
        let mut left = exponent.unsigned_abs();
        while left > 0 {
            if left & 1 == 1 {
                power = power * square;
            }
            square = square * square;
            left >>= 1;
        }
        if exponent < 0 {
            Self::from(1.0) / power
        } else {
            power
        }
    }
}

impl From<f64> for Long {
    /// A finite number, exactly.
    fn from(value: f64) -> Self {
        let exponent = binary_exponent(value).max(-1022) - 52;
        let half = -exponent / 2;
        let whole = scale_by_power_of_two(value.abs(), half);
        let whole = scale_by_power_of_two(whole, -exponent - half);
        Self::of_words(value < 0.0, &[whole as u64], exponent)
    }
}

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
