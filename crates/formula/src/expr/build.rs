//! Formulas built in code, simplified lightly as they grow.
//!
//! The operators `+ - * /` on [`Expr`], [`Expr::power`] and [`Expr::call`] fold pure numbers exactly
//! and drop neutral and absorbing elements. They never rearrange what was written otherwise, so a
//! result has at most one node more than its operands. The shape of a formula is put in order by
//! the normal form, not here.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Constant, Expr, Function, Kind, Name, Operator};
use vibank_dynamics::numerics::Rational;

/// Powers of pure numbers are folded up to this exponent.
// 2^64 still leaves half of the 128 bits of a numerator free.
const MAX_FOLDED_EXPONENT: i128 = 64;

impl Expr {
    /// An exact pure number.
    ///
    /// ```
    /// use vibank_formula::expr::Expr;
    /// let (half, x) = (Expr::number(1) / Expr::number(2), Expr::name("x"));
    /// assert_eq!(half.as_number().unwrap().to_string(), "1/2");
    /// assert_eq!(Expr::number(0) + x.clone() * Expr::number(1), x);
    /// ```
    pub fn number(value: impl Into<Rational>) -> Self {
        Self::derived(Kind::Number(value.into()))
    }

    /// A variable or parameter, by its name.
    pub fn name(name: impl Into<Name>) -> Self {
        Self::derived(Kind::Name(name.into()))
    }

    /// A reserved constant.
    pub fn constant(constant: Constant) -> Self {
        Self::derived(Kind::Constant(constant))
    }

    /// A function of arguments.
    pub fn call(function: Function, arguments: impl Into<Vec<Self>>) -> Self {
        Self::derived(Kind::Call(function, arguments.into()))
    }

    /// A vector, or a matrix as an array of rows.
    pub fn array(entries: impl Into<Vec<Self>>) -> Self {
        Self::derived(Kind::Array(entries.into()))
    }

    /// A time derivative of higher order: `x` becomes `x'`, `x'` becomes `x''`; the formula itself for order 0.
    #[must_use]
    pub fn prime(self, order: u8) -> Self {
        match self.kind() {
            _ if order == 0 => self,
            Kind::Prime(inner, lower) => {
                Self::derived(Kind::Prime(inner.clone(), lower.saturating_add(order)))
            }
            _ => Self::derived(Kind::Prime(self, order)),
        }
    }

    /// The power with this exponent.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        let (base, power) = (self.as_number(), exponent.as_number());
        match (base, power) {
            (_, Some(power)) if power == Rational::ONE => self,
            (_, Some(power)) if power.is_zero() => Self::number(1),
            (Some(base), _) if base == Rational::ONE => Self::number(1),
            (Some(base), Some(power)) => match folded_power(base, power) {
                Some(value) => Self::number(value),
                None => binary(Operator::Power, self, exponent),
            },
            _ => binary(Operator::Power, self, exponent),
        }
    }

    /// The square.
    #[must_use]
    pub fn squared(self) -> Self {
        self.power(Self::number(2))
    }

    /// Its value if it is a pure number, possibly with a sign in front.
    pub fn as_number(&self) -> Option<Rational> {
        match self.kind() {
            Kind::Number(value) => Some(*value),
            Kind::Negate(inner) => inner.as_number().map(Neg::neg),
            _ => None,
        }
    }

    /// Whether it is the pure number 0.
    pub fn is_zero(&self) -> bool {
        self.as_number().is_some_and(Rational::is_zero)
    }

    /// Whether it is the pure number 1.
    pub fn is_one(&self) -> bool {
        self.as_number() == Some(Rational::ONE)
    }

    /// The same node over other operands: each child is replaced by `change`'s answer, places are kept.
    ///
    /// # Errors
    ///
    /// The first one of `change`.
    pub fn try_map_children<E>(
        &self,
        change: &mut dyn FnMut(&Self) -> Result<Self, E>,
    ) -> Result<Self, E> {
        let mut unchanged = true;
        let mut apply = |child: &Self| {
            let changed = change(child)?;
            unchanged &= changed.is_same(child);
            Ok(changed)
        };
        let kind = self.kind().try_map_children(&mut apply)?;
        Ok(if unchanged {
            self.clone()
        } else {
            Self::new(kind, self.span())
        })
    }
}

impl Kind {
    fn try_map_children<E>(
        &self,
        change: &mut dyn FnMut(&Expr) -> Result<Expr, E>,
    ) -> Result<Self, E> {
        let mut all = |list: &[Expr]| list.iter().map(&mut *change).collect::<Result<Vec<_>, E>>();
        Ok(match self {
            Self::Index(a, list) => {
                let list = all(list)?;
                Self::Index(change(a)?, list)
            }
            Self::Compare(list, relations) => Self::Compare(all(list)?, relations.clone()),
            Self::Call(function, list) => Self::Call(*function, all(list)?),
            Self::Array(list) => Self::Array(all(list)?),
            Self::Prime(a, order) => Self::Prime(change(a)?, *order),
            Self::Negate(a) => Self::Negate(change(a)?),
            Self::Not(a) => Self::Not(change(a)?),
            Self::Diff(a, names) => Self::Diff(change(a)?, names.clone()),
            Self::Binary(operator, a, b) => Self::Binary(*operator, change(a)?, change(b)?),
            Self::And(a, b) => Self::And(change(a)?, change(b)?),
            Self::Or(a, b) => Self::Or(change(a)?, change(b)?),
            Self::If(a, b, c) => Self::If(change(a)?, change(b)?, change(c)?),
            Self::Root(a, name, b, c) => {
                Self::Root(change(a)?, name.clone(), change(b)?, change(c)?)
            }
            Self::Integral(a, name, b, c) => {
                Self::Integral(change(a)?, name.clone(), change(b)?, change(c)?)
            }
            Self::At(a, bound) => {
                let bound = bound
                    .iter()
                    .map(|(name, value)| Ok((name.clone(), change(value)?)))
                    .collect::<Result<_, E>>()?;
                Self::At(change(a)?, bound)
            }
            _ => self.clone(),
        })
    }
}

fn binary(operator: Operator, left: Expr, right: Expr) -> Expr {
    Expr::derived(Kind::Binary(operator, left, right))
}

fn folded_power(base: Rational, power: Rational) -> Option<Rational> {
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
