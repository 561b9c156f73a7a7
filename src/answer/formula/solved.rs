//! Equations that are solved for what is asked.

use crate::expr::{Expr, Function, Kind, Operator};

/// What is asked by an equation whose left side is a multiple of it by a number, of its square or of its reciprocal.
///
/// Of two roots the one that is not negative: a key of either sign is neither.
pub(crate) fn solved(left: &Expr, right: Expr, is_asked: &dyn Fn(&Expr) -> bool) -> Option<Expr> {
    let is_number = |side: &Expr| side.names().free.is_empty();
    match left.kind() {
        _ if is_asked(left) => Some(right),
        Kind::Binary(Operator::Multiply, factor, rest) if is_number(factor) => {
            solved(rest, right / factor.clone(), is_asked)
        }
        Kind::Binary(Operator::Divide, rest, divisor) if is_number(divisor) => {
            solved(rest, right * divisor.clone(), is_asked)
        }
        Kind::Binary(Operator::Divide, above, rest) if is_number(above) => {
            solved(rest, above.clone() / right, is_asked)
        }
        Kind::Binary(Operator::Power, base, exponent) if *exponent == Expr::number(2) => {
            solved(base, Expr::call(Function::Sqrt, [right]), is_asked)
        }
        _ => None,
    }
}
