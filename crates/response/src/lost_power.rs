//! Powers of ten whose exponent lost its place above the line: `162·10-3`, `1.25×103`, `162.10^-3`.

use super::amount::Amount;
use super::token::{Item, Token};
use vibank_formula::unit::{Decimal, Unit};

/// A power of ten whose exponent is not raised, `162·10-3` and `1.25×103`, or one after a point, `162.10^-3`.
pub(crate) fn lost_power(tokens: &[Token], text: &str) -> Option<Amount> {
    let typed = |token: &Token| &text[token.span.range()];
    let whole = |token: &Token| typed(token).parse::<u32>().ok();
    let unit = |rest: &[Token]| match rest {
        [] => Some(Unit::ONE),
        [
            Token {
                item: Item::Unit(unit),
                ..
            },
        ] => Some(**unit),
        _ => None,
    };
    let (factor, power, rest) = match tokens {
        [factor, times, ten, minus, power, rest @ ..]
            if times.item == Item::Sign('*')
                && typed(ten) == "10"
                && minus.item == Item::Sign('-')
                && !power.is_spaced =>
        {
            (
                factor,
                -(whole(power).filter(|power| *power < 100)? as i32),
                rest,
            )
        }
        [ten, raised, minus, power, rest @ ..]
            if raised.item == Item::Sign('^')
                && minus.item == Item::Sign('-')
                && typed(ten).ends_with(".10") =>
        {
            let factor = typed(ten)
                .strip_suffix(".10")
                .filter(|whole| *whole != "0")?;
            let power = -(whole(power).filter(|power| *power < 100)? as i32);
            let value = Decimal::parse(&format!("{factor}e{power}")).ok()?;
            return Some(Amount::decimal(value, unit(rest)?));
        }
        [
            ten,
            Token {
                item: Item::Power(power),
                ..
            },
            rest @ ..,
        ] if typed(ten).ends_with(".10") => {
            let factor = typed(ten)
                .strip_suffix(".10")
                .filter(|whole| *whole != "0")?;
            let value = Decimal::parse(&format!("{factor}e{power}")).ok()?;
            return Some(Amount::decimal(value, unit(rest)?));
        }
        [factor, times, ten, rest @ ..] if times.item == Item::Sign('*') => {
            let digit = whole(ten).filter(|ten| (101..=109).contains(ten))? - 100;
            (factor, digit as i32, rest)
        }
        _ => return None,
    };
    let factor = factor.literal.as_ref()?.value;
    let ten = Decimal::parse(&format!("1e{power}")).ok()?;
    Some(Amount::decimal(factor.checked_mul(ten)?, unit(rest)?))
}
