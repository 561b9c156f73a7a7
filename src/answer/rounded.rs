//! Formulas with rounded numbers, and the exact ones that these may stand for: `0.0833 m l²` for `m l²/12`.

use std::f64::consts::PI;

use super::{Credit, Doubt, Marking, Note, Remark, Why};
use crate::expr::{Constant, Expr, Function, Kind};
use crate::numerics::Rational;

/// Figures from which on a decimal may stand for a number that has no end: with two, 0.33, it is a third to one percent only.
const MIN_FIGURES: u32 = 3;
/// Divisions until the simplest fraction between two bounds is found; of decimals with six figures it takes at most nine.
const MAX_DIVISIONS: u32 = 16;

/// What formulas may be rounded forms of: each of their decimals as the simplest fraction, the root of one, or the multiple
/// of π, that is rounded to it. None where they have no decimal of three figures.
pub(crate) fn exact_forms(formulas: &[Expr]) -> impl Iterator<Item = Vec<Expr>> {
    let exact: [Exact; 3] = [Decimal::fraction, Decimal::root, Decimal::multiple_of_pi];
    exact.into_iter().filter_map(|exact| {
        let mut is_any = false;
        let all: Result<Vec<Expr>, ()> = formulas
            .iter()
            .map(|formula| replaced(formula, exact, &mut is_any))
            .collect();
        all.ok().filter(|_| is_any)
    })
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

/// The marking of an answer that is right but for the rounding of numbers: right on paper, handed back where one can ask.
pub(crate) fn settle_rounded(doubt: Doubt, right: Marking) -> Marking {
    match (doubt, right.reading) {
        (Doubt::Benefit, Some(reading)) => {
            Marking::read(reading, Credit::FULL, Remark::from(Note::RoundedNumbers))
        }
        _ => Marking::unreadable(Why::RoundedNumbers),
    }
}

/// The exact number of which a decimal is rounded.
type Exact = fn(Decimal) -> Option<Expr>;

/// A formula with its decimals replaced; an error where one is rounded of no such number.
fn replaced(node: &Expr, exact: Exact, is_any: &mut bool) -> Result<Expr, ()> {
    let Kind::Number(value) = node.kind() else {
        return node.try_map_children(&mut |child| replaced(child, exact, is_any));
    };
    let Some(decimal) = Decimal::of(*value) else {
        return Ok(node.clone());
    };
    *is_any = true;
    exact(decimal).ok_or(())
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

    /// The simplest fraction of which a function is rounded to this decimal, by the inverse of that function.
    fn simplest(self, inverse: fn(f64) -> f64) -> Option<Expr> {
        let [low, high] = [self.value - self.half, self.value + self.half].map(inverse);
        simplest_between(low, high, MAX_DIVISIONS).map(Expr::number)
    }

    fn fraction(self) -> Option<Expr> {
        self.simplest(|value| value)
    }

    fn root(self) -> Option<Expr> {
        let square = self.simplest(|value| value * value)?;
        Some(Expr::call(Function::Sqrt, [square]))
    }

    fn multiple_of_pi(self) -> Option<Expr> {
        let multiple = self.simplest(|value| value / PI)?;
        Some(multiple * Expr::constant(Constant::Pi))
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
        let forms = |text: &str| {
            let formula = [Expr::read(text).unwrap()];
            let forms = exact_forms(&formula);
            forms.map(|form| form[0].to_string()).collect::<Vec<_>>()
        };
        assert_eq!(forms("0.0833*m")[0], "1/12*m");
        assert_eq!(forms("1.667*m")[0], "5/3*m");
        assert_eq!(forms("1.414*x")[1], "sqrt(2)*x");
        assert_eq!(forms("sqrt(1.4286*g*h)")[0], "sqrt(10/7*g*h)");
        assert_eq!(forms("6.28*x")[2], "2*pi*x");
        assert_eq!(forms("0.667*m + 0.0833*n")[0], "2/3*m + 1/12*n");
        // The last figure counts: these are rounded to other decimals.
        assert_ne!(forms("0.0834*m")[0], "1/12*m");
        assert_ne!(forms("0.6666*m")[0], "2/3*m");
        assert_ne!(forms("1.000001*m")[0], "m");
        for text in ["0.33*m", "0.5*m", "12*m", "m/12", "m"] {
            assert!(forms(text).is_empty(), "{text}");
        }
    }
}
