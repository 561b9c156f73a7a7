//! Formulas read into sums of products, and what cancels in them.

use std::collections::BTreeSet;

use super::inner::Inner;
use super::term::{Atom, Monomial, Opaque, Polynomial, settle};
use super::{SymbolicError, Work, trigonometry};
use crate::expr::symbolic::derivative::resolve_diff;
use crate::expr::symbolic::{Substitution, Variable};
use crate::expr::{Constant, Expr, Function, Kind, Operator};
use vibank_dynamics::numerics::Rational;

/// Reads a formula.
pub(crate) fn polynomial(expr: &Expr, work: &mut Work) -> Result<Polynomial, SymbolicError> {
    work.spend(1)?;
    Ok(match expr.kind() {
        Kind::Number(value) => Polynomial::number(*value),
        Kind::Measure(value, unit) => {
            // The number apart from its unit, so that 2 kg and 3 kg are terms that add up.
            let one = Expr::derived(Kind::Measure(Rational::ONE, unit.clone()));
            opaque(&one).scaled(*value)?
        }
        Kind::Constant(constant) if *constant != Constant::Infinity => {
            Polynomial::atom(Atom::Constant(*constant))
        }
        Kind::Name(name) => Polynomial::atom(Atom::Variable(Variable::of(name, 0))),
        Kind::Prime(inner, order) => match inner.kind() {
            Kind::Name(name) => Polynomial::atom(Atom::Variable(Variable::of(name, *order))),
            _ => opaque(expr),
        },
        Kind::Negate(inner) => polynomial(inner, work)?.negated(),
        Kind::Binary(operator, a, b) => binary(*operator, a, b, work)?,
        Kind::Call(function, arguments) => call(expr, *function, arguments, work)?,
        Kind::Diff(inner, names) => polynomial(&resolve_diff(inner, names)?, work)?,
        Kind::At(inner, values) => {
            let mut put = Substitution::new();
            for (name, value) in values {
                put = put.with(name.clone(), value.clone());
            }
            polynomial(&put.apply(inner)?, work)?
        }
        _ => opaque(expr),
    })
}

fn opaque(expr: &Expr) -> Polynomial {
    Polynomial::atom(Atom::Opaque(Opaque::of(expr)))
}

fn binary(
    operator: Operator,
    a: &Expr,
    b: &Expr,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let left = polynomial(a, work)?;
    let right = polynomial(b, work)?;
    match operator {
        Operator::Add => left.plus(right),
        Operator::Subtract => left.plus(right.negated()),
        Operator::Multiply => left.times(&right, work),
        Operator::Divide => left.times(&right.power(-Rational::ONE, work)?, work),
        Operator::Power => match right.as_number() {
            Some(exponent) => left.power(exponent, work),
            // `e^x` and `exp(x)` are one function.
            None if matches!(a.kind(), Kind::Constant(Constant::E)) => {
                trigonometry::call(Function::Exp, right, work)
            }
            None => Ok(Polynomial::atom(Atom::Power(left.into(), right.into()))),
        },
    }
}

fn call(
    expr: &Expr,
    function: Function,
    arguments: &[Expr],
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let half = Rational::new(1, 2).unwrap_or(Rational::ONE);
    match (function, arguments) {
        (Function::Sqrt, [u]) => polynomial(u, work)?.power(half, work),
        // As the root that it is, so that both spellings are one function.
        (Function::Hypot, [u, v]) => {
            let two = Rational::from(2);
            let u = polynomial(u, work)?.power(two, work)?;
            let v = polynomial(v, work)?.power(two, work)?;
            u.plus(v)?.power(half, work)
        }
        (_, [u]) if is_scalar(function) => {
            let u = polynomial(u, work)?;
            trigonometry::call(function, u, work)
        }
        (Function::Atan2 | Function::Min | Function::Max | Function::Clamp | Function::Mod, _) => {
            let arguments = arguments
                .iter()
                .map(|argument| polynomial(argument, work).map(Inner::from))
                .collect::<Result<_, _>>()?;
            Ok(Polynomial::atom(Atom::Call(function, arguments)))
        }
        _ => Ok(opaque(expr)),
    }
}

/// Functions of one number.
fn is_scalar(function: Function) -> bool {
    !matches!(
        function,
        Function::Transpose | Function::Det | Function::Norm
    )
}

impl Polynomial {
    /// Each sum that stands in denominators is divided out of the terms over it where that is exact.
    pub(crate) fn cancelled(self, work: &mut Work) -> Result<Self, SymbolicError> {
        let mut sum = self;
        for base in sum.denominators() {
            sum = sum.cancelled_by(&base, work)?;
        }
        Ok(sum)
    }

    fn cancelled_by(self, base: &Inner, work: &mut Work) -> Result<Self, SymbolicError> {
        let atom = Atom::Base(base.clone());
        let (mut over, mut rest) = (Self::default(), Self::default());
        for (monomial, coefficient) in self.0 {
            let side = if monomial.exponent(&atom).is_negative() {
                &mut over
            } else {
                &mut rest
            };
            side.insert(monomial, coefficient)?;
        }
        // Terms over different powers are brought over the highest of them before they are divided.
        while let Some(least) = over.0.keys().map(|own| own.exponent(&atom)).min() {
            let up = Monomial::of(atom.clone(), -least);
            let numerator = over.times(&Self::term(up, Rational::ONE), work)?;
            let Some(quotient) = numerator.divided_by(base, work)? else {
                break;
            };
            let exponent = least
                .checked_add(Rational::ONE)
                .ok_or(SymbolicError::TooLarge)?;
            let below = if exponent.is_zero() {
                Self::one()
            } else {
                Self::term(Monomial::of(atom.clone(), exponent), Rational::ONE)
            };
            over = quotient.times(&below, work)?;
            if !exponent.is_negative() {
                break;
            }
        }
        over.plus(rest)
    }

    /// The sums that stand in denominators.
    fn denominators(&self) -> BTreeSet<Inner> {
        let factors = self.0.keys().flat_map(|monomial| &monomial.0);
        let bases = factors
            .filter(|(_, exponent)| exponent.is_negative())
            .filter_map(|(atom, _)| match atom {
                Atom::Base(base) if base.as_number().is_none() => Some(base.clone()),
                _ => None,
            });
        vibank_dynamics::numerics::gather(bases)
    }

    /// The form in which equal functions are the same: denominators cleared, angles taken apart, sin²
    /// replaced. Only whether it is zero has a meaning for the original.
    pub(crate) fn canonical(&self, work: &mut Work) -> Result<Self, SymbolicError> {
        let mut sum = self.with_angles_apart(work)?;
        // Clearing one denominator can bring up another that stood within it.
        for _ in 0..16 {
            let Some(base) = sum.denominators().into_iter().next() else {
                break;
            };
            let atom = Atom::Base(base);
            let exponents = sum.0.keys().map(|monomial| monomial.exponent(&atom));
            let least = exponents.min().unwrap_or(Rational::ZERO);
            let mut cleared = Self::default();
            for (monomial, coefficient) in sum.0 {
                work.spend(1 + monomial.0.len())?;
                let raised = monomial.times(&Monomial::of(atom.clone(), -least))?;
                settle(raised, coefficient, &mut cleared, work)?;
            }
            sum = cleared;
        }
        sum.with_sines_reduced(work)
    }
}
