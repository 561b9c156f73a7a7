//! Numbers, units and quantities in words, for readers of screens.

use super::decimal::Decimal;
use super::factor::Factor;
use super::figures;
use super::notation::DecimalMark;
use super::product::Unit;
use super::quantity::Quantity;
use super::rational::Rational;
use vibank_notation::{UnitName, Voice};

pub(crate) fn decimal(decimal: &Decimal, mark: DecimalMark) -> String {
    let (mut text, power) = figures::size(decimal, mark);
    if decimal.is_negative() {
        text.insert_str(0, "minus ");
    }
    if let Some(power) = power {
        text.push_str(" times 10 to the ");
        text.push_str(&signed(Rational::integer(power), Voice::ENGLISH));
    }
    text
}

pub(crate) fn unit(unit: &Unit, several: bool, voice: &Voice) -> String {
    let last = unit.above().count().saturating_sub(1);
    let above = unit
        .above()
        .enumerate()
        .map(|(i, factor)| name(factor, factor.power, several && i == last, voice));
    let below = unit.below().map(|factor| {
        let name = name(factor, factor.power.negated(), false, voice);
        format!("{} {name}", voice.per)
    });
    let words: Vec<String> = above.chain(below).collect();
    words.join(" ")
}

pub(crate) fn quantity(quantity: &Quantity, mark: DecimalMark) -> String {
    let number = quantity.value.spoken(mark);
    if quantity.unit.is_one() {
        return number;
    }
    let one = number == "1" || number == "minus 1";
    format!("{number} {}", quantity.unit.spoken(!one, Voice::ENGLISH))
}

fn name(factor: &Factor, power: Rational, several: bool, voice: &Voice) -> String {
    let row = factor.row();
    let named = |english, french| (voice.unit)(UnitName { english, french });
    let word = named(row.words[usize::from(several)], row.french);
    let prefix = factor.prefix();
    let prefix = prefix.map_or("", |prefix| named(prefix.word, prefix.french));
    let power = match power {
        Rational::ONE => String::new(),
        power if power == Rational::integer(2) => format!(" {}", voice.squared),
        power if power == Rational::integer(3) => format!(" {}", voice.cubed),
        power => format!(" {} {}", voice.power[0], signed(power, voice)),
    };
    format!("{prefix}{word}{power}")
}

fn signed(power: Rational, voice: &Voice) -> String {
    let sign = if power.is_negative() {
        format!("{} ", voice.minus)
    } else {
        String::new()
    };
    let size = power.abs();
    let half = size.numerator() == 1 && size.denominator() == 2;
    if half {
        format!("{sign}{}", voice.half)
    } else {
        let over = format!(" {} ", voice.over);
        format!("{sign}{}", size.to_string().replace('/', &over))
    }
}
