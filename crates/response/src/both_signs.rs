//! Equations with both signs, `a = ±b`: two of them, of which one holds, as the product `(a - b)*(a + b) = 0`.

use super::parser::Parser;
use super::{Chain, Trouble, Typed, TypedError};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Expr, Operator, Relation};
use vibank_source::Span;

/// The upper and the lower sign, and those of plus and minus that take as much room.
const SIGNS: [(&str, [&str; 2]); 2] = [("±", ["+ ", "- "]), ("∓", ["-  ", "+  "])];

/// A value without the small uncertainty after it: `12.94 ± 0.02 N` is `12.94 N`.
pub(crate) fn without_spread(text: &str) -> Option<String> {
    // A wider one is no uncertainty of a calculation, and leaves the value open.
    const WIDEST: f64 = 0.01;
    let (before, behind) = text.split_once('±')?;
    let is_of_number = |char: char| char.is_ascii_digit() || ".,".contains(char);
    let (before, behind) = (before.trim_end(), behind.trim_start());
    let value = &before[before.trim_end_matches(is_of_number).len()..];
    let rest = behind.trim_start_matches(is_of_number);
    let spread = &behind[..behind.len() - rest.len()];
    let size =
        |number: &str| Rational::from_decimal(&number.replace(',', ".")).map(Rational::to_f64);
    let (spread, value) = (size(spread)?, size(value)?);
    let is_small = 0.0 < spread && spread <= WIDEST * value;
    (is_small && !rest.contains('±')).then(|| format!("{before}{rest}"))
}

/// A text with the upper ones of its signs alone, and with the lower ones; all places stay.
pub(crate) struct Two {
    upper: String,
    lower: String,
    /// Where the first of them stands.
    first: Span,
}

impl Two {
    /// The two texts that one is whose place holds such signs.
    pub(crate) fn of(text: &str, from: usize, place: &str) -> Option<Self> {
        let (at, sign) = place.match_indices(['±', '∓']).next()?;
        let with = |which: usize| {
            SIGNS.iter().fold(text.to_owned(), |text, (sign, plain)| {
                text.replace(sign, plain[which])
            })
        };
        Some(Self {
            upper: with(0),
            lower: with(1),
            first: Span::new(from + at, from + at + sign.len()),
        })
    }

    /// With the upper ones, and with the lower ones.
    pub(crate) fn texts(self) -> [String; 2] {
        [self.upper, self.lower]
    }

    /// The one equation that both are.
    ///
    /// # Errors
    ///
    /// What stands in the way of one of them, and anything but one equation.
    pub(crate) fn chain(
        &self,
        read: impl Fn(&str) -> Result<Typed<Chain>, TypedError>,
    ) -> Result<Typed<Chain>, TypedError> {
        let (upper, lower) = (read(&self.upper)?, read(&self.lower)?);
        let others = upper.others.iter().zip(&lower.others);
        let both = |(upper, lower): (&Chain, &Chain)| self.product(upper, lower);
        Ok(Typed {
            others: others.map(both).collect::<Result<_, _>>()?,
            value: both((&upper.value, &lower.value))?,
        })
    }

    fn product(&self, upper: &Chain, lower: &Chain) -> Result<Chain, TypedError> {
        let difference = |chain: &Chain| match (&chain.sides[..], &chain.relations[..]) {
            ([left, right], [Relation::Equal]) => {
                Parser::binary(Operator::Subtract, left.clone(), right.clone())
            }
            _ => Err(TypedError {
                trouble: Trouble::TwoValues,
                span: self.first,
            }),
        };
        let product = Parser::binary(Operator::Multiply, difference(upper)?, difference(lower)?)?;
        Ok(Chain {
            sides: vec![product, Expr::number(0)],
            relations: vec![Relation::Equal],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::without_spread;

    #[test]
    fn an_uncertainty_is_small() {
        for (typed, value) in [
            ("12.94 ± 0.02 N", Some("12.94 N")),
            ("(2,034 ± 0,004) rad", Some("(2,034) rad")),
            ("ω = 905±2", Some("ω = 905")),
            ("5 ± 3 rad/s", None),
            ("±5 m", None),
            ("5 ± x", None),
            ("5 ± 0.1 ± 0.1", None),
        ] {
            assert_eq!(without_spread(typed).as_deref(), value, "{typed}");
        }
    }
}
