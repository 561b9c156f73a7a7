//! Numbers, units and quantities as typeset mathematics.

use super::decimal::Decimal;
use super::factor::Factor;
use super::figures;
use super::notation::DecimalMark;
use super::product::Unit;
use super::quantity::Quantity;
use super::rational::Rational;
use super::text::touches;
use vibank_notation::{Class, Math, Style};

/// A thin space, in eighteenths of an em.
const THIN: Math = Math::Space(3);

pub(crate) fn decimal(decimal: &Decimal, mark: DecimalMark) -> Math {
    row_of(pieces(decimal, mark))
}

fn pieces(decimal: &Decimal, mark: DecimalMark) -> Vec<Math> {
    let (digits, power) = figures::size(decimal, mark);
    let mut row = if decimal.is_negative() {
        vec![minus()]
    } else {
        Vec::new()
    };
    row.push(Math::Number(digits));
    if let Some(power) = power {
        row.push(operator("×", Class::Binary));
        row.push(raised(
            Math::Number("10".to_owned()),
            Rational::integer(power),
        ));
    }
    row
}

pub(crate) fn unit(unit: &Unit) -> Math {
    let mut row = product(unit.above(), false);
    if row.is_empty() {
        return row_of(product(unit.below(), false));
    }
    let below = product(unit.below(), true);
    if !below.is_empty() {
        row.push(operator("/", Class::Ordinary));
    }
    match unit.below().count() {
        0 | 1 => row.extend(below),
        _ => row.push(parentheses(row_of(below))),
    }
    row_of(row)
}

pub(crate) fn quantity(quantity: &Quantity, mark: DecimalMark) -> Math {
    let mut row = pieces(&quantity.value, mark);
    let mut unit = match quantity.unit.math() {
        Math::Row(unit) => unit,
        single => vec![single],
    };
    if unit.first() == Some(&operator(DEGREE, Class::Ordinary)) {
        unit[0] = script(
            row.pop().unwrap_or(Math::Row(Vec::new())),
            operator("∘", Class::Ordinary),
        );
    } else if !quantity.unit.is_one() && !touches(&quantity.unit) {
        row.push(THIN);
    }
    row.extend(unit);
    row_of(row)
}

fn product<'a>(factors: impl Iterator<Item = &'a Factor>, below: bool) -> Vec<Math> {
    let mut row = Vec::new();
    for factor in factors {
        if !row.is_empty() {
            row.push(THIN);
        }
        let power = if below {
            factor.power.negated()
        } else {
            factor.power
        };
        row.push(raised(symbol(factor), power));
    }
    row
}

const DEGREE: &str = "°";

/// The symbol of a unit: letters upright, signs as signs.
fn symbol(factor: &Factor) -> Math {
    let print = factor.row().print;
    match print {
        DEGREE | "′" | "″" | "%" | "‰" => operator(print, Class::Ordinary),
        "g₀" => Math::Script {
            base: Box::new(upright("g".to_owned())),
            sub: Some(Box::new(Math::Number("0".to_owned()))),
            sup: None,
        },
        _ => upright(format!(
            "{}{print}",
            factor.prefix().map_or("", |prefix| prefix.print)
        )),
    }
}

/// Letters set upright.
fn upright(text: String) -> Math {
    Math::Identifier {
        text,
        style: Style::Upright,
    }
}

fn raised(base: Math, power: Rational) -> Math {
    if power == Rational::ONE {
        return base;
    }
    let mut sup = if power.is_negative() {
        vec![minus()]
    } else {
        Vec::new()
    };
    sup.push(Math::Number(power.abs().numerator().to_string()));
    if !power.is_integer() {
        sup.push(operator("/", Class::Ordinary));
        sup.push(Math::Number(power.denominator().to_string()));
    }
    script(base, row_of(sup))
}

fn script(base: Math, sup: Math) -> Math {
    Math::Script {
        base: Box::new(base),
        sub: None,
        sup: Some(Box::new(sup)),
    }
}

fn minus() -> Math {
    operator("−", Class::Prefix)
}

fn operator(text: &str, class: Class) -> Math {
    Math::Operator {
        text: text.to_owned(),
        class,
    }
}

fn parentheses(body: Math) -> Math {
    Math::Fence {
        open: "(".to_owned(),
        close: ")".to_owned(),
        body: Box::new(body),
        stretchy: false,
    }
}

fn row_of(mut row: Vec<Math>) -> Math {
    if row.len() == 1 {
        row.remove(0)
    } else {
        Math::Row(row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latex() {
        for (text, latex) in [
            (
                "3e-4 N m/rad",
                r"3\times10^{-4}\,\mathrm{N}\,\mathrm{m}/\mathrm{rad}",
            ),
            ("0.25", "0{,}25"),
            ("4 J/(kg K)", r"4\,\mathrm{J}/(\mathrm{kg}\,\mathrm{K})"),
            ("2 1/s^2", r"2\,\mathrm{s}^{-2}"),
            ("3 kg^(-1/2)", r"3\,\mathrm{kg}^{-1/2}"),
            ("-90 deg", r"-90^\circ"),
            ("12 deg/s", r"12^\circ/\mathrm{s}"),
            ("5 %", r"5\,\%"),
            ("2 g0", r"2\,\mathrm{g}_0"),
            ("5 uF", r"5\,\mathrm{\mu F}"),
        ] {
            let quantity = Quantity::parse(text).unwrap();
            assert_eq!(quantity.math(DecimalMark::Comma).latex(), latex, "{text}");
        }
    }

    #[test]
    fn a_pure_number_is_a_number() {
        let math = Quantity::parse("7").unwrap().math(DecimalMark::Point);
        assert_eq!(math, Math::Number("7".to_owned()));
    }
}
