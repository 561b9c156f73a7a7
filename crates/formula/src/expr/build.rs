//! Formulas built in code, simplified lightly as they grow.
//!
//! The operators `+ - * /` on [`Expr`], [`Expr::power`] and [`Expr::call`] fold pure numbers exactly
//! and drop neutral and absorbing elements. They never rearrange what was written otherwise, so a
//! result has at most one node more than its operands. The shape of a formula is put in order by
//! the normal form, not here.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Expr, Kind, Operator};
use vibank_dynamics::numerics::Rational;

/// Powers of pure numbers are folded up to this exponent.
// 2^64 still leaves half of the 128 bits of a numerator free.
const MAX_FOLDED_EXPONENT: i128 = 64;

pub(crate) fn binary(operator: Operator, left: Expr, right: Expr) -> Expr {
    Expr::derived(Kind::Binary(operator, left, right))
}

pub(crate) fn folded_power(base: Rational, power: Rational) -> Option<Rational> {
    if !power.is_integer() || power.abs().numerator() > MAX_FOLDED_EXPONENT {
        return None;
    }
    base.checked_pow(i32::try_from(power.numerator()).ok()?)
}

/// The inside of a sign in front.
fn negated(expr: &Expr) -> Option<Expr> {
    match expr.kind() {
        Kind::Negate(inner) => Some(inner.clone()),
        Kind::Number(value) if value.is_negative() => Some(Expr::number(-*value)),
        _ => None,
    }
}

impl Neg for Expr {
    type Output = Self;

    fn neg(self) -> Self {
        match self.as_number() {
            Some(value) => Self::number(-value),
            None => negated(&self).unwrap_or_else(|| Self::derived(Kind::Negate(self))),
        }
    }
}

impl Add for Expr {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number())
            && let Some(sum) = a.checked_add(b)
        {
            return Self::number(sum);
        }
        match negated(&other) {
            Some(inner) => binary(Operator::Subtract, self, inner),
            None => binary(Operator::Add, self, other),
        }
    }
}

impl Sub for Expr {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        match negated(&other) {
            Some(inner) => self + inner,
            None if other.is_zero() => self,
            None if self.is_zero() => -other,
            None => match (self.as_number(), other.as_number()) {
                (Some(_), Some(_)) => self + -other,
                _ => binary(Operator::Subtract, self, other),
            },
        }
    }
}

impl Mul for Expr {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        match (self.as_number(), other.as_number()) {
            (Some(a), Some(b)) => match a.checked_mul(b) {
                Some(product) => Self::number(product),
                None => binary(Operator::Multiply, self, other),
            },
            (None, Some(_)) => other * self,
            (Some(a), None) => scaled(a, other),
            (None, None) => match (negated(&self), negated(&other)) {
                (Some(a), Some(b)) => a * b,
                (Some(a), None) => -(a * other),
                (None, Some(b)) => -(self * b),
                (None, None) => match leading_number(&other) {
                    Some((factor, rest)) => scaled(factor, self * rest),
                    None => binary(Operator::Multiply, self, other),
                },
            },
        }
    }
}

impl Mul for &Expr {
    type Output = Expr;

    fn mul(self, other: Self) -> Expr {
        self.clone() * other.clone()
    }
}

/// `2*x` as (2, x).
fn leading_number(expr: &Expr) -> Option<(Rational, Expr)> {
    match expr.kind() {
        Kind::Binary(Operator::Multiply, first, rest) => {
            first.as_number().map(|factor| (factor, rest.clone()))
        }
        _ => None,
    }
}

/// A product with a pure number in front.
fn scaled(factor: Rational, expr: Expr) -> Expr {
    if factor.is_zero() && !matches!(expr.kind(), Kind::Array(_)) {
        return Expr::number(0);
    }
    if factor == Rational::ONE {
        return expr;
    }
    if factor == -Rational::ONE {
        return -expr;
    }
    if let Some((inner, rest)) = leading_number(&expr)
        && let Some(product) = factor.checked_mul(inner)
    {
        return scaled(product, rest);
    }
    if let Some(inner) = negated(&expr) {
        return scaled(-factor, inner);
    }
    if factor.is_negative() {
        return -binary(Operator::Multiply, Expr::number(-factor), expr);
    }
    binary(Operator::Multiply, Expr::number(factor), expr)
}

impl Div for Expr {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.is_one() {
            return self;
        }
        if other.is_zero() {
            return binary(Operator::Divide, self, other);
        }
        if self.is_zero() {
            return self;
        }
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number())
            && let Some(quotient) = a.checked_div(b)
        {
            return Self::number(quotient);
        }
        match (negated(&self), negated(&other)) {
            (Some(a), Some(b)) => a / b,
            (Some(a), None) => -(a / other),
            (None, Some(b)) => -(self / b),
            (None, None) => binary(Operator::Divide, self, other),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn x() -> Expr {
        Expr::name("x")
    }

    #[test]
    fn neutral_elements_vanish() {
        let zero = || Expr::number(0);
        let one = || Expr::number(1);
        for same in [
            x() + zero(),
            zero() + x(),
            x() - zero(),
            x() * one(),
            one() * x(),
            x() / one(),
            x().power(one()),
            -(-x()),
            x().prime(0),
        ] {
            assert_eq!(same, x());
        }
        for nothing in [x() * zero(), zero() * x(), zero() / x()] {
            assert!(nothing.is_zero(), "{nothing:?}");
        }
        assert!(x().power(zero()).is_one());
    }

    #[test]
    fn numbers_fold_exactly_and_signs_move_out() {
        let third = || Expr::number(1) / Expr::number(3);
        assert!((third() + third() + third()).is_one());
        assert_eq!(
            Expr::number(2) * (Expr::number(3) * x()),
            Expr::number(6) * x()
        );
        assert_eq!(x() * Expr::number(2), Expr::number(2) * x());
        assert_eq!((-x()) * (-x()), x() * x());
        assert_eq!(x() + -x().squared(), x() - x().squared());
        assert_eq!(Expr::number(2) - Expr::number(5), Expr::number(-3));
        assert_eq!(x().prime(1).prime(1), x().prime(2));
    }

    #[test]
    fn what_does_not_fit_stays_a_formula() {
        let huge = || Expr::derived(Kind::Number(Rational::new(i128::MAX, 1).unwrap()));
        assert!((huge() * huge()).as_number().is_none());
        assert!((Expr::number(1) / Expr::number(0)).as_number().is_none());
        assert!(
            Expr::number(10)
                .power(Expr::number(60))
                .as_number()
                .is_none()
        );
    }
}
