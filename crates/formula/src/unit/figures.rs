//! Rounding computed numbers to decimals, and the figures that are printed.

use std::fmt;

use super::decimal::Decimal;
use super::notation::DecimalMark;
use super::number::strict;

/// The decimal nearest to a number with this many significant figures (1 to 30), ties to even.
///
/// Exact: the digits are those of the number's full decimal expansion. Zero has no figures and is 0.
pub(crate) fn rounded(value: f64, figures: u32) -> Option<Decimal> {
    if value == 0.0 {
        return Some(Decimal::ZERO);
    }
    let figures = figures.clamp(1, 30);
    let decimal = of_exponential(&format!("{value:.*e}", figures as usize - 1))?;
    // Zeros that say nothing are avoided from 1000 on.
    let plain = (-3..figures.max(3) as i32).contains(&decimal.magnitude());
    Decimal::of_parts(value < 0.0, decimal.digits(), decimal.exponent(), !plain)
}

/// The shortest decimal that reads back to the same number.
pub(crate) fn shortest(value: f64) -> Option<Decimal> {
    let decimal = of_exponential(&format!("{value:e}"))?;
    let plain = (-5..16).contains(&decimal.magnitude());
    Decimal::of_parts(value < 0.0, decimal.digits(), decimal.exponent(), !plain)
}

/// Reads what the compiler's library prints; nothing for what is not finite or out of range.
fn of_exponential(text: &str) -> Option<Decimal> {
    strict(text)
        .ok()
        .filter(|(_, length)| *length == text.len())
        .map(|(decimal, _)| decimal)
}

/// What is printed of the size of a decimal: the digits, and the power of ten if there is one.
pub(crate) fn size(decimal: &Decimal, mark: DecimalMark) -> (String, Option<i32>) {
    let mut digits = decimal.digits().to_string();
    if decimal.is_scientific() {
        if digits.len() > 1 {
            digits.insert(1, mark.char());
        }
        return (digits, Some(decimal.magnitude()));
    }
    let decimals = decimal.decimals() as usize;
    if decimals > 0 {
        let missing = (decimals + 1).saturating_sub(digits.len());
        digits.insert_str(0, &"0".repeat(missing));
        digits.insert(digits.len() - decimals, mark.char());
    } else if !decimal.is_zero() {
        digits.push_str(&"0".repeat(decimal.exponent() as usize));
    }
    (digits, None)
}

/// Writes a decimal as files have it.
pub(crate) fn write(f: &mut fmt::Formatter<'_>, decimal: &Decimal) -> fmt::Result {
    let (digits, power) = size(decimal, DecimalMark::Point);
    let power = power.map(|power| format!("e{power}")).unwrap_or_default();
    f.pad(&format!(
        "{}{digits}{power}",
        if decimal.is_negative() { "-" } else { "" }
    ))
}
