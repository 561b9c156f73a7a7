//! A unit after a zero that is one side of an equation, `m x'' + k x = 0 N`.

use super::token::{Item, Token};
use vibank_formula::expr::{Expr, Kind, Operator};
use vibank_formula::unit::Unit;

/// The unit that begins a text after the zero that was read last, where both are a whole side, and its length.
pub(crate) fn unit_of_nothing(text: &str, tokens: &[Token]) -> Option<(Unit, usize)> {
    let side = text.split('=').next().unwrap_or_default();
    let is_whole = match tokens {
        [_] => side.len() < text.len(),
        [.., before, _] => before.item == Item::Sign('='),
        [] => false,
    };
    let unit = side.trim_end_matches([' ', '.', ',', ';']);
    if !is_whole || !unit.starts_with([' ', '\\']) && !unit.starts_with(char::is_alphabetic) {
        return None;
    }
    let read = Unit::read(unit.trim()).ok()?;
    (!read.is_one()).then_some((read, unit.len()))
}

/// The unit of a side that is a zero with one, as a quantity.
pub fn unit_of_zero(side: &Expr) -> Option<&Expr> {
    match side.kind() {
        Kind::Binary(Operator::Multiply, zero, unit) if zero.is_zero() => {
            matches!(unit.kind(), Kind::Measure(..)).then_some(unit)
        }
        _ => None,
    }
}
