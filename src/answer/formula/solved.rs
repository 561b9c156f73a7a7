//! Statements that are true of what is asked without being solved for it: `ω² = k/m`, `1/k = 1/k1 + 1/k2`, `2λ = c/m`.

use crate::expr::{Expr, Function, Kind, Name, Operator};
use crate::numerics::Rational;

/// A product with a power of what is asked: the other factors, and the exponent.
struct Power {
    factor: Expr,
    exponent: Rational,
}

/// The formula for the symbol `is_asked` where `left`, a product of it, is `right`; none where it is more than a product.
///
/// It takes the positive root of a power.
pub(crate) fn solved(left: &Expr, right: &Expr, is_asked: &dyn Fn(&Name) -> bool) -> Option<Expr> {
    let Power { factor, exponent } = power(left, is_asked)?;
    let inverse = Rational::ONE.checked_div(exponent)?;
    let alone = binary(Operator::Divide, right.clone(), factor);
    Some(if inverse == Rational::ONE {
        alone
    } else if inverse == Rational::new(1, 2)? {
        Expr::derived(Kind::Call(Function::Sqrt, vec![alone]))
    } else {
        let exponent = Expr::derived(Kind::Number(inverse));
        binary(Operator::Power, alone, exponent)
    })
}

fn power(expr: &Expr, is_asked: &dyn Fn(&Name) -> bool) -> Option<Power> {
    let own = |inner: &Expr| power(inner, is_asked);
    let zero = Rational::new(0, 1)?;
    match expr.kind() {
        Kind::Name(name) if is_asked(name) => Some(Power {
            factor: Expr::number(1),
            exponent: Rational::ONE,
        }),
        Kind::Binary(operator @ (Operator::Multiply | Operator::Divide), left, right) => {
            let (left, right) = (own(left)?, own(right)?);
            let exponent = match operator {
                Operator::Multiply => left.exponent.checked_add(right.exponent)?,
                _ => left.exponent.checked_sub(right.exponent)?,
            };
            Some(Power {
                factor: binary(*operator, left.factor, right.factor),
                exponent,
            })
        }
        Kind::Binary(Operator::Power, base, exponent) => {
            let (base, raised) = (own(base)?, exponent.as_number()?);
            Some(Power {
                factor: binary(Operator::Power, base.factor, exponent.clone()),
                exponent: base.exponent.checked_mul(raised)?,
            })
        }
        Kind::Call(Function::Sqrt, inner) => {
            let [inner] = &inner[..] else { return None };
            let inner = own(inner)?;
            Some(Power {
                factor: Expr::derived(Kind::Call(Function::Sqrt, vec![inner.factor])),
                exponent: inner.exponent.checked_mul(Rational::new(1, 2)?)?,
            })
        }
        _ => {
            let names = expr.names();
            let is_free = names.free.iter().all(|own| !is_asked(&own.name));
            is_free.then(|| Power {
                factor: expr.clone(),
                exponent: zero,
            })
        }
    }
}

fn binary(operator: Operator, left: Expr, right: Expr) -> Expr {
    Expr::derived(Kind::Binary(operator, left, right))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(left: &str, right: &str) -> Option<String> {
        let read = |text: &str| Expr::read(text).expect("it is a formula");
        let found = solved(&read(left), &read(right), &|name| name.as_str() == "w");
        found.map(|found| found.to_string())
    }

    #[test]
    fn a_product_of_what_is_asked_is_solved_for_it() {
        for (left, right, due) in [
            ("w^2", "k/m", "sqrt(k/m/1^2)"),
            ("2*w", "c/m", "c/m/(2*1)"),
            ("1/w", "1/a + 1/b", "((1/a + 1/b)/(1/1))^(-1)"),
            ("m*w^2", "k", "sqrt(k/(m*1^2))"),
        ] {
            assert_eq!(of(left, right).as_deref(), Some(due), "{left}");
        }
        for left in ["w + 1", "2*k", "sin(w)", "w/w"] {
            assert_eq!(of(left, "k"), None, "{left}");
        }
    }
}
