//! A unit after a zero that is one side of an equation, `m x'' + k x = 0 N`.

use super::lexer::Lexer;
use super::token::Item;
use vibank_formula::expr::{Expr, Kind, Operator};
use vibank_formula::unit::Unit;

impl Lexer<'_> {
    /// Takes the unit after the zero that was read, where both are a whole side.
    pub(crate) fn unit_of_nothing(&mut self) {
        let side = self.rest().split('=').next().unwrap_or_default();
        let is_whole = match &self.tokens[..] {
            [_] => side.len() < self.rest().len(),
            [.., before, _] => before.item == Item::Sign('='),
            [] => false,
        };
        let unit = side.trim_end_matches([' ', '.', ',', ';']);
        if !is_whole || !unit.starts_with([' ', '\\']) && !unit.starts_with(char::is_alphabetic) {
            return;
        }
        if let Ok(read) = Unit::read(unit.trim())
            && !read.is_one()
        {
            self.take(unit.len(), Item::Unit(Box::new(read)));
        }
    }
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
