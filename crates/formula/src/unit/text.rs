//! Units and quantities as text: the language of files, and Unicode for people.

use std::fmt;

use super::decimal::Decimal;
use super::factor::Factor;
use super::figures;
use super::notation::DecimalMark;
use super::product::Unit;
use super::quantity::Quantity;
use super::rational::Rational;
use super::scanner::SUPERSCRIPTS;

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = written(self, ' ', |text, factor, power| {
            text.push_str(factor.prefix().map_or("", |prefix| prefix.symbols[0]));
            text.push_str(factor.row().symbols[0]);
            match power {
                Rational::ONE => {}
                power if power.is_integer() => text.extend(["^", &power.to_string()]),
                power => text.extend(["^(", &power.to_string(), ")"]),
            }
        });
        f.pad(&text)
    }
}

/// A unit with a sign between its factors, each written with the power that it has on its side of the slash.
fn written(unit: &Unit, between: char, write: impl Fn(&mut String, &Factor, Rational)) -> String {
    let mut text = String::with_capacity(16);
    for (i, factor) in unit.above().enumerate() {
        if i > 0 {
            text.push(between);
        }
        write(&mut text, factor, factor.power);
    }
    if text.is_empty() {
        text.push('1');
    }
    let several = unit.below().count() > 1;
    for (i, factor) in unit.below().enumerate() {
        match i {
            0 if several => text.push_str("/("),
            0 => text.push('/'),
            _ => text.push(between),
        }
        write(&mut text, factor, factor.power.negated());
    }
    if several {
        text.push(')');
    }
    text
}

pub(crate) fn unit(unit: &Unit) -> String {
    if unit.above().next().is_some() {
        return written(unit, '·', push_factor);
    }
    let mut text = String::new();
    for factor in unit.below() {
        if !text.is_empty() {
            text.push('·');
        }
        push_factor(&mut text, factor, factor.power);
    }
    text
}

fn push_factor(text: &mut String, factor: &Factor, power: Rational) {
    text.push_str(factor.prefix().map_or("", |prefix| prefix.print));
    text.push_str(factor.row().print);
    match power {
        Rational::ONE => {}
        power if power.is_integer() => push_raised(text, power.numerator()),
        power => {
            let sign = if power.is_negative() { "−" } else { "" };
            text.extend(["^(", sign, &power.abs().to_string(), ")"]);
        }
    }
}

fn push_raised(text: &mut String, power: i32) {
    if power < 0 {
        text.push('⁻');
    }
    for digit in power.unsigned_abs().to_string().bytes() {
        text.push(SUPERSCRIPTS[usize::from(digit - b'0')]);
    }
}

pub(crate) fn decimal(decimal: &Decimal, mark: DecimalMark) -> String {
    let (mut text, power) = figures::size(decimal, mark);
    if decimal.is_negative() {
        text.insert(0, '−');
    }
    if let Some(power) = power {
        text.push_str("×10");
        push_raised(&mut text, power);
    }
    text
}

pub(crate) fn quantity(quantity: &Quantity, mark: DecimalMark) -> String {
    let (number, unit) = (quantity.value.text(mark), quantity.unit.text());
    let space = if unit.is_empty() || touches(&quantity.unit) {
        ""
    } else {
        " "
    };
    format!("{number}{space}{unit}")
}

/// Whether a unit stands right after its number, as the signs of degree, minute and second do.
pub(crate) fn touches(unit: &Unit) -> bool {
    unit.factors()
        .first()
        .is_some_and(|factor| !factor.below && ["°", "′", "″"].contains(&factor.row().print))
}
