//! Products with their brackets kept.

use crate::expr::{Expr, Kind, Normal, Operator, Order};
use crate::mechanics::energy::terms;

/// A product as one writes it: numbers and names, brackets as they are, the derivative that they multiply, functions last. Whether a sign stands in front,
/// and the rest.
pub(crate) fn in_order(term: &Expr, order: &Order) -> (bool, Expr) {
    if let Ok(normal) = Normal::of(term)
        && normal.terms() <= 1
    {
        return signed(&normal, order);
    }
    let mut product = OrderedProduct {
        is_negative: false,
        names: Expr::number(1),
        brackets: Vec::new(),
        rates: Expr::number(1),
        functions: Expr::number(1),
        order,
    };
    product.take(term, false);
    product.finish()
}

/// The terms of a sum, each with whether it is subtracted; a sign at the first factor counts.
pub(crate) fn signed_terms(sum: &Expr, is_subtracted: bool) -> Vec<(bool, Expr)> {
    let terms = terms(sum, is_subtracted).into_iter();
    terms
        .map(|(is_subtracted, term)| {
            let (sign, term) = without_sign(&term);
            (is_subtracted != sign, term)
        })
        .collect()
}

/// Takes the sign off the first factor.
fn without_sign(term: &Expr) -> (bool, Expr) {
    match term.kind() {
        Kind::Negate(inner) => {
            let (sign, inner) = without_sign(inner);
            (!sign, inner)
        }
        Kind::Binary(operator @ (Operator::Multiply | Operator::Divide), first, rest) => {
            let (sign, first) = without_sign(first);
            let product = Kind::Binary(*operator, first, rest.clone());
            (
                sign,
                if sign {
                    Expr::derived(product)
                } else {
                    term.clone()
                },
            )
        }
        _ => (false, term.clone()),
    }
}

fn signed(normal: &Normal, order: &Order) -> (bool, Expr) {
    let is_negative = normal.has_negative_coefficients_alone();
    if is_negative {
        (true, normal.negated().to_expr(order))
    } else {
        (false, normal.to_expr(order))
    }
}

struct OrderedProduct<'o> {
    is_negative: bool,
    names: Expr,
    brackets: Vec<Expr>,
    /// Time derivatives.
    rates: Expr,
    functions: Expr,
    order: &'o Order,
}

impl OrderedProduct<'_> {
    fn take(&mut self, factor: &Expr, is_below: bool) {
        match factor.kind() {
            Kind::Binary(Operator::Multiply, a, b) => {
                self.take(a, is_below);
                self.take(b, is_below);
            }
            Kind::Binary(Operator::Divide, a, b) => {
                self.take(a, is_below);
                self.take(b, !is_below);
            }
            Kind::Negate(inner) => {
                self.is_negative = !self.is_negative;
                self.take(inner, is_below);
            }
            _ => self.take_single(factor, is_below),
        }
    }

    fn take_single(&mut self, factor: &Expr, is_below: bool) {
        let normal = Normal::of(factor).ok();
        let has_call = {
            let mut found = false;
            factor.walk(&mut |node| found |= matches!(node.kind(), Kind::Call(..)));
            found
        };
        match normal {
            Some(normal) if normal.terms() > 1 && !is_below => {
                let is_bracket = matches!(
                    factor.kind(),
                    Kind::Binary(Operator::Add | Operator::Subtract, ..)
                );
                // Powers of sums stay powers.
                let bracket = if is_bracket {
                    let is_negative = normal.has_negative_coefficients_alone();
                    self.is_negative ^= is_negative;
                    let own = if is_negative {
                        normal.negated()
                    } else {
                        normal
                    };
                    own.to_bracket(self.order)
                } else {
                    factor.clone()
                };
                self.brackets.push(bracket);
            }
            _ => {
                let place = if has_call && !is_below {
                    &mut self.functions
                } else if matches!(factor.kind(), Kind::Prime(..)) && !is_below {
                    &mut self.rates
                } else {
                    &mut self.names
                };
                let before = place.clone();
                *place = if is_below {
                    before / factor.clone()
                } else {
                    before * factor.clone()
                };
            }
        }
    }

    fn finish(self) -> (bool, Expr) {
        let ordered = |expr: &Expr| match Normal::of(expr) {
            Ok(normal) if normal.terms() <= 1 => signed(&normal, self.order),
            _ => (false, expr.clone()),
        };
        let (before, after) = if self.brackets.is_empty() {
            (self.names * self.rates, Expr::number(1))
        } else {
            (self.names, self.rates)
        };
        let (first, names) = ordered(&before);
        let (second, functions) = ordered(&self.functions);
        let product = self.brackets.into_iter().fold(names, |all, one| all * one);
        (
            self.is_negative ^ first ^ second,
            product * after * functions,
        )
    }
}
