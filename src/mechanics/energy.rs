//! Energies as they are shown: in the coordinates, as the author grouped them.

use crate::expr::{Expr, Kind, Normal, Operator, Order, sum_of_signed_terms};

/// An energy as written where nothing had to be substituted, else term by term in order.
pub(crate) fn written(energy: &Expr, written: &Expr, order: &Order) -> Expr {
    if energy == written {
        return written.clone();
    }
    let order = order.clone().descending();
    let terms = terms(energy, false).into_iter();
    sum_of_signed_terms(terms.map(|(is_negative, term)| {
        let (sign, term) = tidied(&term, &order);
        (is_negative != sign, term)
    }))
}

/// A term in order without multiplying out its brackets; whether it is subtracted, and the rest.
fn tidied(term: &Expr, order: &Order) -> (bool, Expr) {
    let normal = Normal::of(term);
    if let Ok(normal) = &normal
        && normal.terms() <= 1
    {
        let is_negative = normal.has_negative_coefficients_alone();
        let magnitude = if is_negative {
            normal.negated()
        } else {
            normal.clone()
        };
        return (is_negative, magnitude.to_expr(order));
    }
    let binary = |operator, a, b| Expr::derived(Kind::Binary(operator, a, b));
    match (term.kind(), normal) {
        (Kind::Binary(operator @ (Operator::Multiply | Operator::Divide), a, b), _) => {
            let ((first, a), (second, b)) = (tidied(a, order), tidied(b, order));
            (first != second, binary(*operator, a, b))
        }
        (Kind::Binary(Operator::Power, base, exponent), _) => {
            let is_even = exponent.as_number() == Some(2.into());
            let bracket = Normal::of(base).map(|own| {
                let is_reversed = is_even && own.has_negative_coefficients_alone();
                let own = if is_reversed { own.negated() } else { own };
                own.to_bracket(order)
            });
            let shorter = bracket.ok().filter(|own| own.size() <= base.size());
            let base = shorter.unwrap_or_else(|| base.clone());
            (false, binary(Operator::Power, base, exponent.clone()))
        }
        (Kind::Negate(inner), _) => {
            let (is_negative, inner) = tidied(inner, order);
            (!is_negative, inner)
        }
        (_, Ok(normal)) => (false, normal.to_bracket(order)),
        (_, Err(_)) => (false, term.clone()),
    }
}

/// The terms of a sum, with whether they are subtracted.
pub(crate) fn terms(expr: &Expr, is_negative: bool) -> Vec<(bool, Expr)> {
    match expr.kind() {
        Kind::Binary(Operator::Add, a, b) => {
            [terms(a, is_negative), terms(b, is_negative)].concat()
        }
        Kind::Binary(Operator::Subtract, a, b) => {
            [terms(a, is_negative), terms(b, !is_negative)].concat()
        }
        Kind::Negate(a) => terms(a, !is_negative),
        _ => vec![(is_negative, expr.clone())],
    }
}
