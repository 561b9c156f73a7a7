//! Derivatives of functions, from their arguments and the rates of these.

use super::SymbolicError;
use super::derivative::not_differentiable;
use crate::expr::{Constant, Expr, Function, Kind, Relation};
use vibank_dynamics::numerics::Rational;

/// f(u)' = f'(u) u'.
pub(crate) fn of_one_argument(
    call: &Expr,
    function: Function,
    u: &Expr,
    du: &Expr,
) -> Result<Expr, SymbolicError> {
    let one = || Expr::number(1);
    let of = |function| Expr::call(function, [u.clone()]);
    let (u, du) = (u.clone(), du.clone());
    Ok(match function {
        Function::Sqrt => du / (Expr::number(2) * call.clone()),
        Function::Exp => du * call.clone(),
        Function::Ln => du / u,
        Function::Log10 => du / (u * Expr::call(Function::Ln, [Expr::number(10)])),
        Function::Sin => du * of(Function::Cos),
        Function::Cos => -(du * of(Function::Sin)),
        Function::Tan => du / of(Function::Cos).squared(),
        Function::Asin => du / square_root(one() - u.squared()),
        Function::Acos => -(du / square_root(one() - u.squared())),
        Function::Atan => du / (one() + u.squared()),
        Function::Sinh => du * of(Function::Cosh),
        Function::Cosh => du * of(Function::Sinh),
        Function::Tanh => du / of(Function::Cosh).squared(),
        Function::Asinh => du / square_root(u.squared() + one()),
        // Not √(u² - 1), which is real below -1 as well, where acosh has no value.
        Function::Acosh => du / (square_root(u.clone() - one()) * square_root(u + one())),
        Function::Atanh => du / (one() - u.squared()),
        Function::Abs if is_complex(&u) => {
            let conjugate = Expr::call(Function::Conj, [u]);
            Expr::call(Function::Re, [conjugate * du]) / call.clone()
        }
        Function::Abs => du * of(Function::Sign),
        Function::Sign => Expr::number(0),
        Function::Min | Function::Max => du,
        Function::Re | Function::Im | Function::Conj | Function::Transpose => {
            Expr::call(function, [du])
        }
        Function::Arg => Expr::call(Function::Im, [du / u]),
        Function::Norm => Expr::call(Function::Dot, [u, du]) / call.clone(),
        _ => return Err(not_differentiable(function.name(), call)),
    })
}

pub(crate) fn of_two_arguments(
    call: &Expr,
    function: Function,
    [u, v]: [&Expr; 2],
    [du, dv]: [&Expr; 2],
) -> Result<Expr, SymbolicError> {
    Ok(match function {
        Function::Atan2 => (v * du - u * dv) / (u.clone().squared() + v.clone().squared()),
        Function::Hypot => (u * du + v * dv) / call.clone(),
        // mod(u, v) = u - v floor(u/v), where the floor is constant by pieces.
        Function::Mod => {
            let whole = Expr::call(Function::Floor, [u.clone() / v.clone()]);
            du.clone() - whole * dv.clone()
        }
        Function::Dot => dot(du, v) + dot(u, dv),
        _ => return Err(not_differentiable(function.name(), call)),
    })
}

/// The dot product of two vectors, of which one may be zero.
fn dot(a: &Expr, b: &Expr) -> Expr {
    if a.is_zero() || b.is_zero() {
        Expr::number(0)
    } else {
        Expr::call(Function::Dot, [a.clone(), b.clone()])
    }
}

pub(crate) fn of_many_arguments(
    call: &Expr,
    function: Function,
    arguments: &[Expr],
    rates: &[Expr],
) -> Result<Expr, SymbolicError> {
    match (function, arguments, rates) {
        (Function::Min, ..) => Ok(extreme(function, Relation::LessOrEqual, arguments, rates)),
        (Function::Max, ..) => Ok(extreme(
            function,
            Relation::GreaterOrEqual,
            arguments,
            rates,
        )),
        (Function::Clamp, [x, low, high], [dx, dlow, dhigh]) => {
            let upper = choice(
                compare(x, Relation::Greater, high),
                dhigh.clone(),
                dx.clone(),
            );
            Ok(choice(compare(x, Relation::Less, low), dlow.clone(), upper))
        }
        _ => Err(not_differentiable(function.name(), call)),
    }
}

/// The derivative of the least or greatest argument: that of the first one which wins against the rest.
fn extreme(function: Function, wins: Relation, arguments: &[Expr], rates: &[Expr]) -> Expr {
    let last = rates.len() - 1;
    (0..last).rev().fold(rates[last].clone(), |rest, index| {
        let others = &arguments[index + 1..];
        let rival = match others {
            [only] => only.clone(),
            _ => Expr::call(function, others),
        };
        choice(
            compare(&arguments[index], wins, &rival),
            rates[index].clone(),
            rest,
        )
    })
}

fn square_root(expr: Expr) -> Expr {
    match expr.as_number() {
        Some(value) if value == Rational::ONE => expr,
        _ => Expr::call(Function::Sqrt, [expr]),
    }
}

fn is_complex(expr: &Expr) -> bool {
    let mut found = false;
    expr.walk(&mut |node| {
        found |= matches!(node.kind(), Kind::Constant(Constant::ImaginaryUnit));
    });
    found
}

/// `if condition then first else second`, or the one value if both are equal.
pub(crate) fn choice(condition: Expr, first: Expr, second: Expr) -> Expr {
    if first == second {
        return first;
    }
    Expr::derived(Kind::If(condition, first, second))
}

pub(crate) fn compare(left: &Expr, relation: Relation, right: &Expr) -> Expr {
    Expr::derived(Kind::Compare(
        vec![left.clone(), right.clone()],
        vec![relation],
    ))
}
