//! Binary floating-point numbers of 256 bits, for conversions that are rounded once, at the end.
//!
//! A unit's factor may hold powers of ten, of π and roots. Products are taken with 256 bits, of which each
//! operation loses less than one unit in the last place; a binary64 has 53 bits and a pair of them 106, so
//! results are correctly rounded except where the exact value lies within 2⁻²⁰⁰ of the middle between two
//! neighbours without being it. Exact middles are found, since short products and quotients are exact.

mod divide;
mod root;
mod round;

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
