//! Formulas with rounded numbers, and the exact ones that these may stand for: `0.0833 m l²` for `m l²/12`.

use super::{Credit, Doubt, Marking, Note, Remark, Why};
use crate::expr::{Expr, Kind};
use crate::numerics::Rational;

/// Figures from which on a decimal may stand for a number that has no end: with two, 0.33, it is a third to one percent only.
const MIN_FIGURES: u32 = 3;
/// Part by which four figures or more may be off: nobody comes to them in another way.
const SURE: f64 = 5e-4;
/// Divisions until the simplest fraction between two bounds is found; of decimals with six figures it takes at most nine.
const MAX_DIVISIONS: u32 = 16;

/// What formulas may be rounded forms of, with each of their decimals as the simplest fraction that is rounded to it; none
/// where they have no decimal of three figures.
pub(crate) fn with_fractions(formulas: &[Expr]) -> Option<Vec<Expr>> {
    let mut is_any = false;
    let all: Option<Vec<Expr>> = formulas
        .iter()
        .map(|formula| replaced(formula, &mut is_any).ok())
        .collect();
    all.filter(|_| is_any)
}

/// The part by which a formula may be off from the exact one for the rounding of its decimals; none where it has none of
/// three figures.
pub(crate) fn rounding(formula: &Expr) -> Option<f64> {
    largest(formula, Decimal::of)
}

/// The same of values in place of letters, where integers of three figures are rounded, too.
pub(crate) fn rounding_of_values(formula: &Expr) -> Option<f64> {
    largest(formula, |number| {
        Decimal::of(number).or_else(|| Decimal::integer(number))
    })
}

fn largest(formula: &Expr, decimal: fn(Rational) -> Option<Decimal>) -> Option<f64> {
    let mut largest: f64 = 0.0;
    formula.walk(&mut |node| {
        if let Kind::Number(value) = node.kind()
            && let Some(decimal) = decimal(*value)
        {
            largest = largest.max(decimal.half / decimal.value);
        }
    });
    Some(largest).filter(|largest| *largest > 0.0)
}

/// The marking of an answer that is right but for the rounding of numbers, by such a part at most: with four figures it is
/// right; with three it is right on paper, and handed back where one can ask.
pub(crate) fn settle_rounded(doubt: Doubt, rounding: f64, right: Marking) -> Marking {
    match right.reading {
        Some(reading) if doubt == Doubt::Benefit || rounding <= SURE => {
            Marking::read(reading, Credit::FULL, Remark::from(Note::RoundedNumbers))
        }
        _ => Marking::unreadable(Why::RoundedNumbers),
    }
}

/// A formula with its decimals replaced; an error where one is rounded of no simple fraction.
fn replaced(node: &Expr, is_any: &mut bool) -> Result<Expr, ()> {
    let Kind::Number(value) = node.kind() else {
        return node.try_map_children(&mut |child| replaced(child, is_any));
    };
    let Some(decimal) = Decimal::of(*value) else {
        return Ok(node.clone());
    };
    *is_any = true;
    decimal.fraction().map(Expr::number).ok_or(())
}

/// A positive decimal that may be rounded.
#[derive(Clone, Copy)]
struct Decimal {
    value: f64,
    /// Half a unit of its last place.
    half: f64,
}

impl Decimal {
    /// A number with decimals and three figures or more.
    fn of(number: Rational) -> Option<Self> {
        let (mut places, mut denominator) = (0, number.denominator());
        // Only decimals end: their denominators divide a power of ten.
        for factor in [2, 5] {
            let mut count = 0;
            while denominator % factor == 0 {
                (denominator, count) = (denominator / factor, count + 1);
            }
            places = places.max(count);
        }
        let unit = Rational::new(1, 10_i128.checked_pow(places)?)?;
        let scaled = number.checked_div(unit)?;
        let figures = scaled.numerator().checked_ilog10()? + 1;
        let is_decimal = places > 0 && denominator == 1 && figures >= MIN_FIGURES;
        is_decimal.then(|| Self {
            value: number.to_f64(),
            half: unit.to_f64() / 2.0,
        })
    }

    /// An integer of three figures or more.
    fn integer(number: Rational) -> Option<Self> {
        let is_long = number.is_integer() && number.numerator() >= 10_i128.pow(MIN_FIGURES - 1);
        is_long.then(|| Self {
            value: number.to_f64(),
            half: 0.5,
        })
    }

    /// The simplest fraction that is rounded to it.
    fn fraction(self) -> Option<Rational> {
        simplest_between(
            self.value - self.half,
            self.value + self.half,
            MAX_DIVISIONS,
        )
    }
}

/// The fraction with the smallest denominator between two positive numbers, by continued fractions.
fn simplest_between(low: f64, high: f64, divisions: u32) -> Option<Rational> {
    let whole = low.ceil();
    if whole <= high {
        return Rational::new(whole as i128, 1);
    }
    let floor = low.floor();
    let rest = simplest_between(
        1.0 / (high - floor),
        1.0 / (low - floor),
        divisions.checked_sub(1)?,
    )?;
    Rational::ONE
        .checked_div(rest)?
        .checked_add(Rational::new(floor as i128, 1)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_stands_for_what_is_rounded_to_it() {
        let form = |text: &str| {
            let exact = with_fractions(&[Expr::read(text).unwrap()]);
            exact.map(|exact| exact[0].to_string())
        };
        for (rounded, exact) in [
            ("0.0833*m", "1/12*m"),
            ("1.667*m", "5/3*m"),
            ("sqrt(1.4286*g*h)", "sqrt(10/7*g*h)"),
            ("0.667*m + 0.0833*n", "2/3*m + 1/12*n"),
        ] {
            assert_eq!(form(rounded).as_deref(), Some(exact), "{rounded}");
        }
        // The last figure counts: these are rounded of other numbers.
        for (other, exact) in [
            ("0.0834*m", "1/12*m"),
            ("0.6666*m", "2/3*m"),
            ("1.000001*m", "m"),
        ] {
            assert_ne!(form(other).as_deref(), Some(exact), "{other}");
        }
        for text in ["0.33*m", "0.5*m", "12*m", "m/12", "m"] {
            assert_eq!(form(text), None, "{text}");
        }
    }
}
