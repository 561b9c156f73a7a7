//! Formulas written in their own language.

use std::fmt::{self, Display, Formatter, Write as _};

use crate::expr::{Constant, Expr, Kind, Operator, Relation};
use vibank_dynamics::numerics::Rational;

/// How tightly a written formula binds; an operand that binds less tightly than its place asks for
/// stands in parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Formula,
    Condition,
    Conjunction,
    Negation,
    Comparison,
    Sum,
    Term,
    Factor,
    Power,
    Postfix,
}

/// A formula in the language in which it is read, with as few parentheses as it needs.
///
/// Reading the text gives the same tree, but for two things: a negative number is read as a sign and a
/// number, and a fraction without finite decimals as a quotient.
///
/// ```
/// use vibank_formula::expr::Expr;
/// let [k, x] = [Expr::name("k"), Expr::name("x")];
/// let force = -(k * (x.clone() - Expr::name("u").prime(1)));
/// assert_eq!(force.to_string(), "-(k*(x - u'))");
/// ```
impl Display for Expr {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        formula(out, self)
    }
}

fn strength(expr: &Expr) -> Strength {
    match expr.kind() {
        Kind::Number(value) if value.is_negative() => Strength::Factor,
        Kind::Number(value) if decimal(*value).is_none() => Strength::Term,
        Kind::Negate(_) => Strength::Factor,
        Kind::Binary(Operator::Add | Operator::Subtract, ..) => Strength::Sum,
        Kind::Binary(Operator::Multiply | Operator::Divide, ..) => Strength::Term,
        Kind::Binary(Operator::Power, ..) => Strength::Power,
        Kind::Compare(..) => Strength::Comparison,
        Kind::Not(_) => Strength::Negation,
        Kind::And(..) => Strength::Conjunction,
        Kind::Or(..) => Strength::Condition,
        Kind::If(..) => Strength::Formula,
        _ => Strength::Postfix,
    }
}

/// The formula, in parentheses if it binds less tightly than its place asks for.
fn at_least(out: &mut Formatter<'_>, expr: &Expr, least: Strength) -> fmt::Result {
    if strength(expr) >= least {
        return formula(out, expr);
    }
    out.write_char('(')?;
    formula(out, expr)?;
    out.write_char(')')
}

fn formula(out: &mut Formatter<'_>, expr: &Expr) -> fmt::Result {
    match expr.kind() {
        Kind::Number(value) => number(out, *value),
        Kind::Measure(value, unit) => {
            number(out, *value)?;
            write!(out, "[{unit}]")
        }
        Kind::Constant(constant) => out.write_str(constant_name(*constant)),
        Kind::Name(name) => name.fmt(out),
        Kind::Path(path) => path.fmt(out),
        Kind::Prime(inner, order) => {
            at_least(out, inner, Strength::Postfix)?;
            (0..*order).try_for_each(|_| out.write_char('\''))
        }
        Kind::Index(inner, indices) => {
            // A bracket after a number would be read as a unit.
            match inner.kind() {
                Kind::Number(_) => write!(out, "({inner})")?,
                _ => at_least(out, inner, Strength::Postfix)?,
            }
            list(out, "[", indices, "]")
        }
        Kind::Negate(inner) => {
            out.write_char('-')?;
            at_least(out, inner, Strength::Factor)
        }
        Kind::Binary(operator, a, b) => binary(out, *operator, a, b),
        Kind::Compare(operands, relations) => {
            at_least(out, &operands[0], Strength::Sum)?;
            for (relation, operand) in relations.iter().zip(&operands[1..]) {
                write!(out, " {} ", relation_sign(*relation))?;
                at_least(out, operand, Strength::Sum)?;
            }
            Ok(())
        }
        Kind::And(a, b) => {
            at_least(out, a, Strength::Conjunction)?;
            out.write_str(" and ")?;
            at_least(out, b, Strength::Negation)
        }
        Kind::Or(a, b) => {
            at_least(out, a, Strength::Condition)?;
            out.write_str(" or ")?;
            at_least(out, b, Strength::Conjunction)
        }
        Kind::Not(inner) => {
            out.write_str("not ")?;
            at_least(out, inner, Strength::Negation)
        }
        Kind::If(condition, first, second) => {
            out.write_str("if ")?;
            at_least(out, condition, Strength::Condition)?;
            write!(out, " then {first} else {second}")
        }
        Kind::Call(function, arguments) => {
            out.write_str(function.name())?;
            list(out, "(", arguments, ")")
        }
        Kind::At(inner, values) => {
            write!(out, "at({inner}")?;
            for (name, value) in values {
                write!(out, ", {name} = {value}")?;
            }
            out.write_char(')')
        }
        Kind::Diff(inner, names) => {
            write!(out, "diff({inner}")?;
            for name in names {
                write!(out, ", {name}")?;
            }
            out.write_char(')')
        }
        Kind::Root(inner, name, low, high) => write!(out, "root({inner}, {name}, {low}, {high})"),
        Kind::Integral(inner, name, from, to) => {
            write!(out, "integral({inner}, {name}, {from}, {to})")
        }
        Kind::Array(entries) => list(out, "[", entries, "]"),
    }
}

fn list(out: &mut Formatter<'_>, open: &str, entries: &[Expr], close: &str) -> fmt::Result {
    out.write_str(open)?;
    for (position, entry) in entries.iter().enumerate() {
        let separator = if position == 0 { "" } else { ", " };
        write!(out, "{separator}{entry}")?;
    }
    out.write_str(close)
}

fn binary(out: &mut Formatter<'_>, operator: Operator, a: &Expr, b: &Expr) -> fmt::Result {
    let (left, sign, right) = match operator {
        Operator::Add => (Strength::Sum, " + ", Strength::Term),
        Operator::Subtract => (Strength::Sum, " - ", Strength::Term),
        Operator::Multiply => (Strength::Term, "*", Strength::Factor),
        Operator::Divide => (Strength::Term, "/", Strength::Factor),
        Operator::Power => (Strength::Postfix, "^", Strength::Factor),
    };
    at_least(out, a, left)?;
    out.write_str(sign)?;
    at_least(out, b, right)
}

fn number(out: &mut Formatter<'_>, value: Rational) -> fmt::Result {
    if value.is_negative() {
        out.write_char('-')?;
    }
    match decimal(value.abs()) {
        Some(digits) => out.write_str(&digits),
        None => write!(out, "{}", value.abs()),
    }
}

/// A fraction as a decimal, if it ends.
pub(crate) fn decimal(value: Rational) -> Option<String> {
    if value.is_integer() {
        return Some(value.to_string());
    }
    let (mut rest, mut twos, mut fives) = (value.denominator(), 0_u32, 0_u32);
    while rest % 2 == 0 {
        (rest, twos) = (rest / 2, twos + 1);
    }
    while rest % 5 == 0 {
        (rest, fives) = (rest / 5, fives + 1);
    }
    let places = twos.max(fives);
    if rest != 1 {
        return None;
    }
    let scale = 10_i128.checked_pow(places)?;
    let digits = value.numerator().checked_mul(scale / value.denominator())?;
    let sign = if digits < 0 { "-" } else { "" };
    let (whole, part) = (digits.abs() / scale, digits.abs() % scale);
    Some(format!(
        "{sign}{whole}.{part:0width$}",
        width = places as usize
    ))
}

fn constant_name(constant: Constant) -> &'static str {
    match constant {
        Constant::Pi => "pi",
        Constant::E => "e",
        Constant::ImaginaryUnit => "i",
        Constant::Infinity => "inf",
    }
}

fn relation_sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Less => "<",
        Relation::LessOrEqual => "<=",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => ">=",
        Relation::Equal => "==",
        Relation::NotEqual => "!=",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_that_end_are_written_as_such() {
        let of = |a, b| decimal(Rational::new(a, b).unwrap());
        assert_eq!(of(1, 2).unwrap(), "0.5");
        assert_eq!(of(1, 80).unwrap(), "0.0125");
        assert_eq!(of(7, 1).unwrap(), "7");
        assert_eq!(of(1, 3), None);
    }
}
