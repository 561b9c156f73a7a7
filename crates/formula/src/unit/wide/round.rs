//! To binary64.

use super::{Wide, shift_up};

impl Wide {
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

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
    }
}
