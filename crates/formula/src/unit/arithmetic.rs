//! Exact sums, products and comparisons of decimals.

use std::cmp::Ordering;
use std::hash::{Hash, Hasher};

use super::decimal::Decimal;

impl Decimal {
    /// The exact sum, with as many decimals as the longer one, if it fits.
    pub fn checked_add(self, other: Self) -> Option<Self> {
        let exponent = self.exponent().min(other.exponent());
        let signed = |number: Self| {
            let digits =
                i128::try_from(digits_at(number.digits(), number.exponent(), exponent)?).ok()?;
            Some(if number.is_negative() {
                -digits
            } else {
                digits
            })
        };
        let sum = signed(self)?.checked_add(signed(other)?)?;
        Self::of_parts(sum < 0, sum.unsigned_abs(), exponent, false)
    }

    /// The exact difference, if it fits.
    pub fn checked_sub(self, other: Self) -> Option<Self> {
        self.checked_add(other.negated())
    }

    /// The exact product, if it fits.
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        let digits = self.digits().checked_mul(other.digits())?;
        Self::of_parts(
            self.is_negative() != other.is_negative(),
            digits,
            self.exponent() + other.exponent(),
            false,
        )
    }

    /// The same number with this many decimals, if no digit other than 0 is lost.
    ///
    /// ```
    /// use vibank_formula::unit::Decimal;
    /// let value = Decimal::parse("2.5").unwrap();
    /// assert_eq!(value.with_decimals(2).unwrap().to_string(), "2.50");
    /// assert_eq!(value.with_decimals(0), None);
    /// ```
    pub fn with_decimals(self, decimals: u32) -> Option<Self> {
        let exponent = -i32::try_from(decimals).ok()?;
        let (digits, own) = self.trimmed();
        let digits = digits_at(digits, own, exponent)?;
        Self::of_parts(self.is_negative(), digits, exponent, false)
    }

    /// How often `step` goes into this number, if it does so an integer number of times.
    pub(crate) fn whole_ratio(self, step: Self) -> Option<u64> {
        let exponent = self.exponent().min(step.exponent());
        let (digits, step_digits) = (
            digits_at(self.digits(), self.exponent(), exponent)?,
            digits_at(step.digits(), step.exponent(), exponent)?,
        );
        let whole = step_digits > 0
            && digits % step_digits == 0
            && (digits == 0 || self.is_negative() == step.is_negative());
        whole
            .then(|| u64::try_from(digits / step_digits).ok())
            .flatten()
    }
}

/// The digits that a number has when the last one has the power `wanted`, which is not above the own one.
fn digits_at(digits: u128, own: i32, wanted: i32) -> Option<u128> {
    if digits == 0 {
        return Some(0);
    }
    let shift = u32::try_from(own - wanted).ok()?;
    digits.checked_mul(10_u128.checked_pow(shift)?)
}

impl Ord for Decimal {
    fn cmp(&self, other: &Self) -> Ordering {
        let sign = |number: &Self| {
            if number.is_zero() {
                0
            } else {
                1 - 2 * i8::from(number.is_negative())
            }
        };
        let by_sign = sign(self).cmp(&sign(other));
        if by_sign.is_ne() || self.is_zero() {
            return by_sign;
        }
        // Of equal magnitude, so the shorter one can be brought to the length of the longer.
        let exponent = self.exponent().min(other.exponent());
        let by_digits = || {
            digits_at(self.digits(), self.exponent(), exponent).cmp(&digits_at(
                other.digits(),
                other.exponent(),
                exponent,
            ))
        };
        let by_size = self
            .magnitude()
            .cmp(&other.magnitude())
            .then_with(by_digits);
        if self.is_negative() {
            by_size.reverse()
        } else {
            by_size
        }
    }
}

impl PartialOrd for Decimal {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Decimal {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Decimal {}

impl Hash for Decimal {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.is_negative(), self.trimmed()).hash(state);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn decimal(text: &str) -> Decimal {
        Decimal::parse(text).unwrap()
    }

    #[test]
    fn equal_values_are_equal() {
        use std::collections::HashSet;
        let set: HashSet<Decimal> = ["2.5", "2.50", "0.25e1", "25e-1"].map(decimal).into();
        assert_eq!(set.len(), 1);
        assert!(decimal("-1e300") < decimal("-1e-300"));
        assert!(decimal("0") > decimal("-1e-300") && decimal("0.0") == decimal("-0"));
        assert_eq!(
            decimal("0.1").checked_add(decimal("0.20")),
            Some(decimal("0.3"))
        );
        assert_eq!(decimal("1e300").checked_mul(decimal("10")), None);
        assert_eq!(decimal("1e300").checked_add(decimal("1")), None);
    }

    proptest! {
        #[test]
        fn order_is_that_of_the_values(a in "-?[0-9]{1,20}([.][0-9]{1,9})?(e-?[0-9]{1,2})?", b in "-?[0-9]{1,20}([.][0-9]{1,9})?") {
            let (a, b) = (decimal(&a), decimal(&b));
            match a.to_f64().total_cmp(&b.to_f64()) {
                Ordering::Equal => {}
                order if a.to_f64() != b.to_f64() => prop_assert_eq!(a.cmp(&b), order),
                _ => {}
            }
            prop_assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
        }

        #[test]
        fn sums_and_differences_undo_each_other(a in -1_000_000_i32.., b in -1_000_000_i32.., places in 0_u32..9) {
            let small = |number: i32| Decimal::from(number).checked_mul(decimal(&format!("1e-{places}"))).unwrap();
            let (a, b) = (small(a), small(b));
            prop_assert_eq!(a.checked_add(b).unwrap().checked_sub(b), Some(a));
        }
    }
}
