//! Numbers of 256 bits, for the few places where thirty digits do not tell a number from zero.
//!
//! Slow and small: a product is one loop over words, a quotient one over bits. An operation drops less than 2^-250 of its
//! result, and also where most of two numbers cancels, what is left is as good.

mod arithmetic;

use std::cmp::Ordering;

use super::{binary_exponent, scale_by_power_of_two};

/// Words of a number, the lowest first.
const WORDS: usize = 4;

/// Bits of a number.
const BITS: i32 = 64 * WORDS as i32;

const LN_2: Long = Long {
    is_negative: false,
    words: [
        0x8a0d_175b_8baa_fa2b,
        0x40f3_4326_7298_b62d,
        0xc9e3_b398_03f2_f6af,
        0xb172_17f7_d1cf_79ab,
    ],
    exponent: -256,
};

/// π/2 as a sum of three parts of 192 bits; products of the first with numbers of 53 bits are exact.
const HALF_PI: [Long; 3] = [
    Long {
        is_negative: false,
        words: [
            0,
            0x2902_4e08_8a67_cc74,
            0xc4c6_628b_80dc_1cd1,
            0xc90f_daa2_2168_c234,
        ],
        exponent: -255,
    },
    Long {
        is_negative: false,
        words: [
            0,
            0xe546_6cf3_4e90_c6cc,
            0x5282_1e63_8d01_377b,
            0x82ef_a98e_c4e6_c894,
        ],
        exponent: -453,
    },
    Long {
        is_negative: false,
        words: [
            0,
            0x16d5_d989_79fb_1bd1,
            0x84d5_b5b5_4709_1792,
            0xac29_b7c9_7c50_dd3f,
        ],
        exponent: -649,
    },
];

/// Halvings of the argument of an exponential before its series.
// An argument of at most ln 2/2 takes over forty terms to 256 bits, its 256th part some twenty.
const HALVINGS: i32 = 8;

/// Beyond this an exponential leaves the range of binary64 by far, and is taken there.
const MAX_EXPONENT: f64 = 1e5;

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

    /// Exponential.
    #[must_use]
    pub fn exp(self) -> Self {
        let rounded = self.to_f64().clamp(-MAX_EXPONENT, MAX_EXPONENT);
        let turns = (rounded / std::f64::consts::LN_2).round();
        if self.abs() > Self::from(MAX_EXPONENT) {
            return one().shifted(turns as i32);
        }
        let rest = self - LN_2 * Self::from(turns);
        let mut power = rest.shifted(-HALVINGS).short_expm1();
        // (1 + p)² - 1 keeps the digits of small powers.
        for _ in 0..HALVINGS {
            power = power.shifted(1) + power * power;
        }
        (one() + power).shifted(turns as i32)
    }

    /// e^x − 1 by its series.
    fn short_expm1(self) -> Self {
        series(self, |term, n| (term * self).over(n + 1))
    }

    /// The natural logarithm of a positive number.
    #[must_use]
    pub fn ln(self) -> Self {
        let mut exponent = self.magnitude();
        let mut mantissa = self.shifted(-exponent);
        if mantissa.to_f64() > std::f64::consts::SQRT_2 {
            mantissa = mantissa.shifted(-1);
            exponent += 1;
        }
        let fraction = ((mantissa - one()) / (mantissa + one()))
            .short_atanh()
            .shifted(1);
        LN_2 * Self::from(f64::from(exponent)) + fraction
    }

    /// Decimal logarithm of a positive number.
    #[must_use]
    pub fn log10(self) -> Self {
        self.ln() / Self::from(10.0).ln()
    }

    /// Its series, for numbers up to 1/2.
    fn short_atanh(self) -> Self {
        self.odd_series(self * self)
    }

    /// `x + x q/3 + x q²/5 + …`.
    fn odd_series(self, q: Self) -> Self {
        let mut sum = self;
        let mut power = self;
        for n in 1.. {
            power = power * q;
            let term = power.over(2 * n + 1);
            if term.is_zero() || term.magnitude() < sum.magnitude() - BITS {
                break;
            }
            sum = sum + term;
        }
        sum
    }

    /// What is left of an angle without the nearest multiple of a right angle, and that multiple modulo four. A step takes
    /// the 53 bits that a number of turns can have, exactly by the first part of π/2; the others follow at the end, where
    /// they cancel nothing.
    fn reduced(self) -> (Self, i32) {
        let [first, others @ ..] = HALF_PI;
        let (mut rest, mut total, mut quarter) = (self, Self::ZERO, 0);
        if self.abs() > Self::from(Self::MAX_ANGLE) {
            return (Self::ZERO, 0);
        }
        loop {
            let turns = (rest.to_f64() / std::f64::consts::FRAC_PI_2).round();
            rest = rest - first * Self::from(turns);
            total = total + Self::from(turns);
            quarter = (quarter + turns.rem_euclid(4.0) as i32) % 4;
            if turns.abs() <= 1.0 {
                break;
            }
        }
        let rest = others
            .into_iter()
            .fold(rest, |rest, part| rest - part * total);
        (rest, quarter)
    }

    /// The largest angle of which π/2 has enough digits for the sine to be known to all of its own.
    pub const MAX_ANGLE: f64 = 1.5e54;

    /// Sine; of angles beyond [`Self::MAX_ANGLE`] any number between −1 and 1.
    #[must_use]
    pub fn sin(self) -> Self {
        let (rest, quarter) = self.reduced();
        let value = if quarter % 2 == 0 {
            rest.short_sin()
        } else {
            rest.short_cos()
        };
        if quarter < 2 { value } else { -value }
    }

    /// Cosine; of angles beyond [`Self::MAX_ANGLE`] any number between −1 and 1.
    #[must_use]
    pub fn cos(self) -> Self {
        let (rest, quarter) = self.reduced();
        let value = if quarter % 2 == 0 {
            rest.short_cos()
        } else {
            rest.short_sin()
        };
        if quarter == 0 || quarter == 3 {
            value
        } else {
            -value
        }
    }

    /// Tangent.
    #[must_use]
    pub fn tan(self) -> Self {
        self.sin() / self.cos()
    }

    fn short_sin(self) -> Self {
        let square = -(self * self);
        series(self, |term, n| (term * square).over(2 * n * (2 * n + 1)))
    }

    fn short_cos(self) -> Self {
        let square = -(self * self);
        series(one(), |term, n| (term * square).over(2 * n * (2 * n - 1)))
    }

    /// Inverse tangent.
    #[must_use]
    pub fn atan(self) -> Self {
        if self.abs() > one() {
            let right_angle = Self::PI.shifted(-1);
            let right_angle = if self.is_negative {
                -right_angle
            } else {
                right_angle
            };
            return right_angle - (one() / self).atan();
        }
        // At 1 the series hardly converges; at the tangent of an eighth of the angle each term adds 6.7 bits.
        const HALVINGS: i32 = 3;
        let halved = (0..HALVINGS).fold(self, |x, _| x / (one() + (one() + x * x).sqrt()));
        halved.odd_series(-(halved * halved)).shifted(HALVINGS)
    }

    /// Angle of the point (x, y), called on y.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let right_angle = Self::PI.shifted(-1);
        if self.abs() > x.abs() {
            let angle = right_angle - (x / self.abs()).atan();
            return if self.is_negative { -angle } else { angle };
        }
        if x.is_zero() {
            return Self::ZERO;
        }
        let angle = (self / x).atan();
        match (x.is_negative, self.is_negative) {
            (false, _) => angle,
            (true, false) => angle + Self::PI,
            (true, true) => angle - Self::PI,
        }
    }

    /// `√(1 − x²)`.
    fn leg(self) -> Self {
        ((one() - self) * (one() + self)).sqrt()
    }

    /// Inverse sine, of numbers up to one in size.
    #[must_use]
    pub fn asin(self) -> Self {
        self.atan2(self.leg())
    }

    /// Inverse cosine, of numbers up to one in size.
    #[must_use]
    pub fn acos(self) -> Self {
        self.leg().atan2(self)
    }

    /// Hyperbolic sine.
    #[must_use]
    pub fn sinh(self) -> Self {
        if self.abs() < one() {
            let square = self * self;
            return series(self, |term, n| (term * square).over(2 * n * (2 * n + 1)));
        }
        let power = self.exp();
        (power - one() / power).shifted(-1)
    }

    /// Hyperbolic cosine.
    #[must_use]
    pub fn cosh(self) -> Self {
        let power = self.exp();
        (power + one() / power).shifted(-1)
    }

    /// Hyperbolic tangent.
    #[must_use]
    pub fn tanh(self) -> Self {
        // Beyond, it is ±1 to the last bit.
        const FLAT: f64 = 100.0;
        let rounded = self.to_f64();
        if rounded.abs() > FLAT {
            return Self::from(rounded.signum());
        }
        self.sinh() / self.cosh()
    }

    /// Inverse hyperbolic sine.
    #[must_use]
    pub fn asinh(self) -> Self {
        let root = (one() + self * self).sqrt();
        if self.abs() < Self::from(0.5) {
            return (self / root).short_atanh();
        }
        let size = (self.abs() + root).ln();
        if self.is_negative { -size } else { size }
    }

    /// Inverse hyperbolic cosine, of numbers from one up.
    #[must_use]
    pub fn acosh(self) -> Self {
        let root = ((self - one()) * (self + one())).sqrt();
        // Near 1 the sum is near 1, and its logarithm would lose digits.
        if self < Self::from(1.5) {
            return (root / self).atanh();
        }
        (self + root).ln()
    }

    /// Inverse hyperbolic tangent, of numbers below one in size.
    #[must_use]
    pub fn atanh(self) -> Self {
        if self.abs() < Self::from(0.5) {
            return self.short_atanh();
        }
        ((one() + self) / (one() - self)).ln().shifted(-1)
    }

    /// Length of a vector.
    #[must_use]
    pub fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }

    /// The power of a positive number.
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        (self.ln() * exponent).exp()
    }
}

fn one() -> Long {
    Long::from(1.0)
}

/// Sums `first · (1 + f₁ (1 + f₂ (…)))`, `factor(term, n)` giving the term after, until terms no longer count.
fn series(first: Long, factor: impl Fn(Long, u64) -> Long) -> Long {
    let (mut sum, mut term) = (first, first);
    for n in 1.. {
        term = factor(term, n);
        if term.is_zero() || term.magnitude() < sum.magnitude() - BITS {
            break;
        }
        sum = sum + term;
    }
    sum
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

#[cfg(test)]
mod tests;
