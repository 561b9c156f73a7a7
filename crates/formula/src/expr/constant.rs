//! Constant formulas, computed exactly.

use super::{Expr, Kind, Operator};
use vibank_dynamics::numerics::Rational;

/// Deepest formula that is looked at.
const MAX_DEPTH: u32 = 20;

/// The exact value of a formula of pure numbers alone, such as the exponent `1/3`; `None` for any other.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Expr, fold};
///
/// let value = fold(&Expr::read("-(1/3 + 1)/2")?).unwrap();
/// assert_eq!(value.to_string(), "-2/3");
/// assert_eq!(fold(&Expr::read("2*x")?), None);
/// # Ok::<(), vibank_formula::expr::ReadError>(())
/// ```
pub fn fold(expr: &Expr) -> Option<Rational> {
    if expr.depth() > MAX_DEPTH {
        return None;
    }
    match expr.kind() {
        Kind::Number(value) => Some(*value),
        Kind::Negate(inner) => fold(inner).map(|value| -value),
        Kind::Binary(operator, a, b) => {
            let (a, b) = (fold(a)?, fold(b)?);
            match operator {
                Operator::Add => a.checked_add(b),
                Operator::Subtract => a.checked_sub(b),
                Operator::Multiply => a.checked_mul(b),
                Operator::Divide => a.checked_div(b),
                Operator::Power => {
                    let exponent = b
                        .is_integer()
                        .then(|| i32::try_from(b.numerator()).ok())??;
                    (exponent.abs() <= 64).then(|| a.checked_pow(exponent))?
                }
            }
        }
        _ => None,
    }
}
