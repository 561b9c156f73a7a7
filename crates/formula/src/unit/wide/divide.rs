//! Quotients.

use super::Wide;

impl Wide {
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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn quotients_undo_products(a in 1_u128.., b in 1_u128..) {
            let (a, b) = (Wide::integer(a).unwrap(), Wide::integer(b).unwrap());
            let back = a.times(b).over(b);
            prop_assert_eq!(back.mantissa, a.mantissa);
            prop_assert!(!back.cut);
        }
    }
}
