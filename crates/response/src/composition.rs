//! What a formula is made of: numbers, units, the time.

use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Expr, Kind, Name};

/// Whether the time stands in a formula.
pub(crate) fn uses_time(expr: &Expr) -> bool {
    expr.names().uses(&Name::new("t"))
}

/// An integer.
pub(crate) fn number(value: i128) -> Kind {
    Kind::Number(Rational::new(value, 1).unwrap_or(Rational::ZERO))
}

/// Whether a unit stands in a formula.
pub(crate) fn has_unit(expr: &Expr) -> bool {
    let mut is_there = false;
    expr.walk(&mut |node| is_there |= matches!(node.kind(), Kind::Measure(..)));
    is_there
}

/// Whether a formula is a number.
pub(crate) fn is_number(expr: &Expr) -> bool {
    expr.as_number().is_some()
}

/// Whether a factor is a number, π, e or the imaginary unit, or arithmetic with such.
pub(crate) fn is_constant(expr: &Expr) -> bool {
    match expr.kind() {
        Kind::Constant(_) => true,
        Kind::Call(_, arguments) => arguments.iter().all(is_constant),
        Kind::Negate(inner) => is_constant(inner),
        Kind::Binary(_, left, right) => is_constant(left) && is_constant(right),
        _ => is_number(expr),
    }
}
