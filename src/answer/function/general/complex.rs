//! Complex exponentials in a general solution: `C1 e^(iωt) + C2 e^(-iωt)`, `Re(A e^(iωt))`.
//!
//! A formula with the imaginary unit is taken apart into its real and its imaginary part, which are formulas of real
//! numbers and are marked as such. Constants that are factors are complex then, each with a second constant as its
//! imaginary part.

use crate::expr::{Constant, Expr, Function, Kind, Name, Operator};
use crate::numerics::SortedMap;

/// Nodes of all parts of a response. Motions of three coordinates have some hundred, in sums of products perhaps a
/// thousand; each is derived twice and compiled, in some microseconds a node. A product of sums has each factor in it four
/// times, so that a short response could have more nodes than memory holds.
pub(crate) const MAX_SIZE: u32 = 4_000;

/// A formula as its real part and, where it is not real, its imaginary part.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    pub(crate) real: Expr,
    pub(crate) imaginary: Option<Expr>,
}

/// Whether a formula is one of complex numbers.
pub(crate) fn is_complex(expr: &Expr) -> bool {
    let mut is_found = false;
    expr.walk(&mut |node| {
        is_found |= matches!(
            node.kind(),
            Kind::Constant(Constant::ImaginaryUnit)
                | Kind::Call(Function::Re | Function::Im | Function::Conj, _)
        );
    });
    is_found
}

/// The names within the arguments of functions and in exponents, where a constant is a phase and real.
pub(crate) fn phases(expr: &Expr) -> Vec<Name> {
    let mut found = Vec::new();
    let mut add = |inner: &Expr| found.extend(inner.names().free.into_iter().map(|own| own.name));
    expr.walk(&mut |node| match node.kind() {
        Kind::Call(Function::Re | Function::Im | Function::Conj, _) => {}
        Kind::Call(_, arguments) => arguments.iter().for_each(&mut add),
        Kind::Binary(Operator::Power, _, exponent) => add(exponent),
        _ => {}
    });
    found
}

impl Parts {
    /// The parts of a formula in which some names are complex, by the names of their imaginary parts; none where a
    /// function of a complex number has no such formula.
    pub(crate) fn of(expr: &Expr, complex: &SortedMap<Name, Name>) -> Option<Self> {
        let part = |inner: &Expr| Self::of(inner, complex);
        let parts = match expr.kind() {
            Kind::Constant(Constant::ImaginaryUnit) => {
                Self::new(Expr::number(0), Some(Expr::number(1)))
            }
            Kind::Name(name) => {
                let imaginary = complex.get(name).map(|own| Expr::name(own.clone()));
                Self::new(expr.clone(), imaginary)
            }
            Kind::Negate(inner) => part(inner)?.negated(),
            Kind::Binary(operator, left, right) => match operator {
                Operator::Add => part(left)?.plus(part(right)?),
                Operator::Subtract => part(left)?.plus(part(right)?.negated()),
                Operator::Multiply => part(left)?.times(&part(right)?),
                Operator::Divide => part(left)?.times(&part(right)?.inverse()),
                Operator::Power => Self::power(expr, left, part(left)?, &part(right)?)?,
            },
            Kind::Call(function, arguments) => {
                let parts: Vec<Self> = arguments.iter().map(part).collect::<Option<_>>()?;
                match (function, &parts[..]) {
                    (Function::Re, [one]) => Self::new(one.real.clone(), None),
                    (Function::Im, [one]) => {
                        let none = || Expr::number(0);
                        Self::new(one.imaginary.clone().unwrap_or_else(none), None)
                    }
                    (Function::Conj, [one]) => {
                        Self::new(one.real.clone(), one.imaginary.clone().map(|own| -own))
                    }
                    (Function::Exp, [one]) => one.exponential(),
                    _ if parts.iter().all(|own| own.imaginary.is_none()) => {
                        let arguments: Vec<Expr> = parts.into_iter().map(|own| own.real).collect();
                        Self::new(Expr::call(*function, arguments), None)
                    }
                    _ => return None,
                }
            }
            _ if is_complex(expr) => return None,
            _ => Self::new(expr.clone(), None),
        };
        let size = parts.imaginary.as_ref().map_or(0, Expr::size);
        (parts.real.size().max(size) <= MAX_SIZE).then_some(parts)
    }

    fn new(real: Expr, imaginary: Option<Expr>) -> Self {
        Self { real, imaginary }
    }

    fn negated(self) -> Self {
        Self::new(-self.real, self.imaginary.map(|own| -own))
    }

    fn plus(self, other: Self) -> Self {
        Self::new(self.real + other.real, sum(self.imaginary, other.imaginary))
    }

    fn times(&self, other: &Self) -> Self {
        let (own, others) = (self.imaginary.as_ref(), other.imaginary.as_ref());
        let imaginary = sum(
            own.map(|own| product(own, &other.real)),
            others.map(|others| product(others, &self.real)),
        );
        let real = product(&self.real, &other.real);
        match own.zip(others) {
            Some((own, others)) => Self::new(real - product(own, others), imaginary),
            None => Self::new(real, imaginary),
        }
    }

    fn inverse(self) -> Self {
        let Some(imaginary) = self.imaginary else {
            return Self::new(Expr::number(1) / self.real, None);
        };
        let square =
            self.real.clone().power(Expr::number(2)) + imaginary.clone().power(Expr::number(2));
        Self::new(self.real / square.clone(), Some(-(imaginary / square)))
    }

    /// `e^(a + ib) = e^a (cos b + i sin b)`.
    fn exponential(&self) -> Self {
        let size = Expr::call(Function::Exp, [self.real.clone()]);
        let Some(angle) = &self.imaginary else {
            return Self::new(size, None);
        };
        let of = |function| product(&size, &Expr::call(function, [angle.clone()]));
        Self::new(of(Function::Cos), Some(of(Function::Sin)))
    }

    /// A power of e, one of real numbers, or one with a small positive integer as its exponent.
    fn power(whole: &Expr, base: &Expr, value: Self, exponent: &Self) -> Option<Self> {
        // Nobody writes more in a motion, and each doubles the terms.
        const MAX_EXPONENT: i32 = 4;
        if *base.kind() == Kind::Constant(Constant::E) {
            return Some(exponent.exponential());
        }
        if value.imaginary.is_none() && exponent.imaginary.is_none() {
            return Some(Self::new(whole.clone(), None));
        }
        let count = (1..=MAX_EXPONENT).find(|count| exponent.real == Expr::number(*count))?;
        Some((1..count).fold(value.clone(), |power, _| power.times(&value)))
    }
}

/// The sum of imaginary parts, where there are any.
fn sum(one: Option<Expr>, other: Option<Expr>) -> Option<Expr> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one + other),
        (one, other) => one.or(other),
    }
}

/// A product that is zero where a factor is.
fn product(one: &Expr, other: &Expr) -> Expr {
    if one.is_zero() || other.is_zero() {
        return Expr::number(0);
    }
    one.clone() * other.clone()
}
