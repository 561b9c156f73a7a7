//! Binary floating-point numbers of 256 bits, for conversions that are rounded once, at the end.
//!
//! A unit's factor may hold powers of ten, of π and roots. Products are taken with 256 bits, of which each
//! operation loses less than one unit in the last place; a binary64 has 53 bits and a pair of them 106, so
//! results are correctly rounded except where the exact value lies within 2⁻²⁰⁰ of the middle between two
//! neighbours without being it. Exact middles are found, since short products and quotients are exact.

/// A positive number `mantissa · 2^exponent`, with the highest bit of the mantissa set.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide {
    /// Lowest first.
    mantissa: [u64; 4],
    exponent: i32,
    /// Whether something positive was cut off below the last bit.
    cut: bool,
}

impl Wide {
    pub(crate) const ONE: Self = Self::small(1);
    /// π, its first 256 bits.
    pub(crate) const PI: Self = Self {
        mantissa: [
            0x020B_BEA6_3B13_9B22,
            0x2902_4E08_8A67_CC74,
            0xC4C6_628B_80DC_1CD1,
            0xC90F_DAA2_2168_C234,
        ],
        exponent: -254,
        cut: true,
    };

    /// The power of a small integer; short results are exact.
    pub(crate) fn power(base: u64, power: u32) -> Self {
        base.checked_pow(power)
            .map_or_else(|| Self::small(base).pow(power), Self::small)
    }

    /// This number times a power of two.
    pub(crate) fn doubled(self, times: i32) -> Self {
        Self {
            exponent: self.exponent.saturating_add(times),
            ..self
        }
    }

    const fn small(value: u64) -> Self {
        let shift = value.leading_zeros();
        Self {
            mantissa: [0, 0, 0, value << shift],
            exponent: -192 - shift as i32,
            cut: false,
        }
    }

    /// A positive integer.
    pub(crate) fn integer(value: u128) -> Option<Self> {
        if value == 0 {
            return None;
        }
        let shift = value.leading_zeros();
        let value = value << shift;
        Some(Self {
            mantissa: [0, 0, value as u64, (value >> 64) as u64],
            exponent: -128 - shift as i32,
            cut: false,
        })
    }

    /// The size of a finite number that is not zero.
    pub(crate) fn of_f64(value: f64) -> Option<Self> {
        let bits = value.to_bits();
        let (field, fraction) = ((bits >> 52 & 0x7FF) as i32, bits & ((1 << 52) - 1));
        let significand = if field == 0 {
            fraction
        } else {
            fraction | 1 << 52
        };
        if field == 0x7FF {
            return None;
        }
        let mut wide = Self::integer(u128::from(significand))?;
        wide.exponent += field.max(1) - 1075;
        Some(wide)
    }

    pub(crate) fn times(self, other: Self) -> Self {
        let mut product = [0_u64; 8];
        for (i, &a) in self.mantissa.iter().enumerate().filter(|&(_, &a)| a != 0) {
            let mut carry = 0;
            for (j, &b) in other.mantissa.iter().enumerate() {
                let sum = u128::from(a) * u128::from(b) + u128::from(product[i + j]) + carry;
                product[i + j] = sum as u64;
                carry = sum >> 64;
            }
            product[i + 4] = carry as u64;
        }
        Self::normalized(
            product,
            self.exponent.saturating_add(other.exponent),
            self.cut | other.cut,
        )
    }

    /// The highest 256 bits of a number of 512, of which one of the two highest is set.
    fn normalized(mut bits: [u64; 8], exponent: i32, cut: bool) -> Self {
        let shift = bits[7].leading_zeros();
        if shift > 0 {
            for i in (1..8).rev() {
                bits[i] = bits[i] << shift | bits[i - 1] >> (64 - shift);
            }
            bits[0] <<= shift;
        }
        Self {
            mantissa: [bits[4], bits[5], bits[6], bits[7]],
            exponent: exponent.saturating_add(256 - shift as i32),
            cut: cut || bits[..4] != [0; 4],
        }
    }

    pub(crate) fn pow(self, power: u32) -> Self {
        let (mut result, mut square, mut power) = (Self::ONE, self, power);
        while power > 0 {
            if power & 1 == 1 {
                result = result.times(square);
            }
            power >>= 1;
            if power > 0 {
                square = square.times(square);
            }
        }
        result
    }

    /// The exponent of the highest bit.
    pub(crate) fn top(self) -> i32 {
        self.exponent.saturating_add(255)
    }

    /// The nearest binary64, ties to even; infinite or zero where there is none.
    pub(crate) fn to_f64(self) -> f64 {
        let top = self.top();
        match top {
            1024.. => f64::INFINITY,
            -1022..=1023 => f64::from_bits((((top + 1022) as u64) << 52) + self.rounded(53)),
            -1074..=-1023 => f64::from_bits(self.rounded((1075 + top) as u32)),
            -1075 if self.mantissa != [0, 0, 0, 1 << 63] || self.cut => f64::from_bits(1),
            _ => 0.0,
        }
    }

    /// The first `bits` bits as an integer, rounded to nearest, ties to even; `bits` is from 1 to 53.
    fn rounded(self, bits: u32) -> u64 {
        let [a, b, c, high] = self.mantissa;
        let kept = high >> (64 - bits);
        let rest = high << bits;
        let beyond = (a | b | c) != 0 || self.cut;
        let half = 1 << 63;
        let up = rest > half || rest == half && (beyond || kept & 1 == 1);
        kept + u64::from(up)
    }

    /// The nearest binary64 and the nearest to what it leaves: together 106 bits or more.
    pub(crate) fn to_pair(self) -> (f64, f64) {
        let high = self.to_f64();
        let top = self.top();
        if !(-1022..=1023).contains(&top) || high.is_infinite() {
            return (high, 0.0);
        }
        let kept = self.mantissa[3] >> 11;
        let mut rest = self.mantissa;
        rest[3] &= (1 << 11) - 1;
        let up = self.rounded(53) > kept;
        if up {
            rest = complement(rest);
        }
        let low = Self::of_limbs(rest, self.exponent, self.cut).map_or(0.0, Self::to_f64);
        (high, if up { -low } else { low })
    }

    /// An integer of 256 bits times a power of two, unless it is zero.
    fn of_limbs(limbs: [u64; 4], exponent: i32, cut: bool) -> Option<Self> {
        let highest = limbs.iter().rposition(|&limb| limb != 0)?;
        let shift = (3 - highest) as u32 * 64 + limbs[highest].leading_zeros();
        let mut bits = [0; 8];
        bits[4..].copy_from_slice(&limbs);
        let [.., a, b, c, d] = shift_up(bits, shift);
        Some(Self {
            mantissa: [a, b, c, d],
            exponent: exponent.saturating_sub(shift as i32),
            cut,
        })
    }

    /// The quotient: long division in base 2⁶⁴.
    ///
    /// # References
    ///
    /// D. Knuth, The Art of Computer Programming 2, section 4.3.1, algorithm D.
    pub(crate) fn over(self, other: Self) -> Self {
        let exponent = self.exponent.saturating_sub(other.exponent);
        let cut = self.cut | other.cut;
        if other.mantissa == [0, 0, 0, 1 << 63] {
            // A power of two, the most frequent divisor.
            return Self {
                exponent: exponent.saturating_sub(255),
                cut,
                ..self
            };
        }
        // Half the dividend is below the divisor, so that all digits of the quotient fit.
        let mut rest = [0_u64; 9];
        for i in 0..4 {
            rest[i + 5] |= self.mantissa[i] >> 1;
            rest[i + 4] |= self.mantissa[i] << 63;
        }
        let mut quotient = match other.mantissa {
            [0, 0, 0, divisor] => divide_by_limb(&mut rest, divisor),
            divisor => divide(&mut rest, &divisor),
        };
        if rest != [0; 9] {
            quotient[0] = 1;
        }
        Self::normalized(quotient, exponent.saturating_sub(511), cut)
    }

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

fn shift_up(limbs: [u64; 8], shift: u32) -> [u64; 8] {
    let (whole, bits) = ((shift / 64) as usize, shift % 64);
    std::array::from_fn(|i| {
        let high = if i >= whole {
            limbs[i - whole] << bits
        } else {
            0
        };
        let low = if bits > 0 && i > whole {
            limbs[i - whole - 1] >> (64 - bits)
        } else {
            0
        };
        high | low
    })
}

/// `2^203 - limbs`, for `limbs` below that.
fn complement(limbs: [u64; 4]) -> [u64; 4] {
    let mut result = limbs.map(|limb| !limb);
    result[3] &= (1 << 11) - 1;
    for limb in &mut result {
        let (sum, overflow) = limb.overflowing_add(1);
        *limb = sum;
        if !overflow {
            break;
        }
    }
    result
}

/// The digits of a quotient, from the fourth limb on; the rest stays in the dividend.
fn divide(rest: &mut [u64; 9], divisor: &[u64; 4]) -> [u64; 8] {
    let mut quotient = [0; 8];
    for place in (0..5).rev() {
        quotient[place + 3] = divide_digit(&mut rest[place..place + 5], divisor);
    }
    quotient
}

/// The same for a divisor of which only the highest limb is not zero.
fn divide_by_limb(rest: &mut [u64; 9], divisor: u64) -> [u64; 8] {
    let mut quotient = [0; 8];
    for place in (3..8).rev() {
        let head = u128::from(rest[place + 1]) << 64 | u128::from(rest[place]);
        quotient[place] = (head / u128::from(divisor)) as u64;
        rest[place + 1] = 0;
        rest[place] = (head % u128::from(divisor)) as u64;
    }
    quotient
}

/// One digit of a long division: the first limb of `window / divisor`, which leaves the rest in the window.
fn divide_digit(window: &mut [u64], divisor: &[u64; 4]) -> u64 {
    let head = u128::from(window[4]) << 64 | u128::from(window[3]);
    let lead = u128::from(divisor[3]);
    let mut digit = (head / lead).min(u128::from(u64::MAX));
    let mut rest = head - digit * lead;
    while rest >> 64 == 0 && digit * u128::from(divisor[2]) > (rest << 64 | u128::from(window[2])) {
        digit -= 1;
        rest += lead;
    }
    let (mut borrow, mut carry) = (false, 0_u128);
    for (place, limb) in window.iter_mut().enumerate() {
        let product = digit * u128::from(divisor.get(place).copied().unwrap_or(0)) + carry;
        carry = product >> 64;
        let (less, first) = limb.overflowing_sub(product as u64);
        let (less, second) = less.overflowing_sub(u64::from(borrow));
        *limb = less;
        borrow = first | second;
    }
    if borrow {
        digit -= 1;
        let mut carry = 0;
        for (place, limb) in window.iter_mut().enumerate() {
            let sum =
                u128::from(*limb) + u128::from(divisor.get(place).copied().unwrap_or(0)) + carry;
            *limb = sum as u64;
            carry = sum >> 64;
        }
    }
    digit as u64
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
    use proptest::prelude::*;

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

    fn limbs(text: &str) -> Wide {
        Wide::integer(text.parse().unwrap()).unwrap()
    }

    #[test]
    fn pi_is_the_nearest_binary64_and_its_rest() {
        // The tail of pi beyond binary64: 1.2246467991473532e-16 (fdlibm, `pio2` tables, times 2).
        assert_eq!(
            Wide::PI.to_pair(),
            (std::f64::consts::PI, 1.224_646_799_147_353_2e-16)
        );
    }

    #[test]
    fn ties_go_to_even() {
        assert_eq!(limbs("9007199254740993").to_f64(), 9_007_199_254_740_992.0);
        assert_eq!(limbs("9007199254740995").to_f64(), 9_007_199_254_740_996.0);
        assert_eq!(
            limbs("9007199254740993").to_pair(),
            (9_007_199_254_740_992.0, 1.0)
        );
        assert_eq!(
            limbs("9007199254740995").to_pair(),
            (9_007_199_254_740_996.0, -1.0)
        );
    }

    /// All finite numbers but zero.
    fn finite() -> impl Strategy<Value = f64> {
        use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL};
        POSITIVE | NEGATIVE | NORMAL | SUBNORMAL
    }

    proptest! {
        #[test]
        fn conversions_agree_with_the_compiler(value in any::<u128>()) {
            prop_assume!(value > 0);
            prop_assert_eq!(Wide::integer(value).unwrap().to_f64(), value as f64);
        }

        #[test]
        fn numbers_come_back(value in finite()) {
            prop_assert_eq!(Wide::of_f64(value).unwrap().to_f64(), value.abs());
        }

        #[test]
        fn decimal_quotients_are_correctly_rounded(digits in 1_u128..10_u128.pow(38), power in 0_u32..400) {
            let ten = Wide::power(10, power);
            let digits_wide = Wide::integer(digits).unwrap();
            prop_assert_eq!(digits_wide.over(ten).to_f64(), format!("{digits}e-{power}").parse::<f64>().unwrap());
            prop_assert_eq!(digits_wide.times(ten).to_f64(), format!("{digits}e{power}").parse::<f64>().unwrap());
        }

        #[test]
        fn quotients_undo_products(a in 1_u128.., b in 1_u128..) {
            let (a, b) = (Wide::integer(a).unwrap(), Wide::integer(b).unwrap());
            let back = a.times(b).over(b);
            prop_assert_eq!(back.mantissa, a.mantissa);
            prop_assert!(!back.cut);
        }
    }
}
