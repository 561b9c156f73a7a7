//! Formulas read into sums of products.

use super::inner::Inner;
use super::term::{Atom, Opaque, Polynomial};
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
