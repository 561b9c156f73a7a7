//! Equations with quotients of the unknowns, `x''/x = -k/m`: the same multiplied by what they divide by.

use crate::expr::{Equation, Expr, Kind, Name, Operator};
use crate::numerics::Rational;

/// Divisors in one equation; each of its terms is multiplied by all of them.
const MAX_DIVISORS: usize = 3;
/// Nodes of a side, since divisors may be long.
const MAX_SIZE: u32 = 4_000;

/// The equations without unknowns in their divisors: they say the same wherever these are not zero, which a motion
/// passes at moments only. None if nothing is divided by an unknown.
pub(crate) fn without_quotients(
    unknowns: &[Name],
    equations: &[Equation],
) -> Option<Vec<Equation>> {
    let mut is_found = false;
    let cleared = equations.iter().map(|equation| {
        let mut divisors = Vec::new();
        for side in [&equation.left, &equation.right] {
            add_divisors(unknowns, side, &mut divisors);
        }
        is_found |= !divisors.is_empty();
        let side = |side: &Expr| {
            let cleared = multiplied(unknowns, side, &divisors);
            (cleared.size() <= MAX_SIZE).then_some(cleared)
        };
        let is_short = divisors.len() <= MAX_DIVISORS;
        let (left, right) = is_short
            .then(|| side(&equation.left).zip(side(&equation.right)))
            .flatten()?;
        Some(Equation { left, right })
    });
    let cleared: Option<Vec<Equation>> = cleared.collect();
    cleared.filter(|_| is_found)
}

/// Adds what the terms of a sum are divided by, each as often as one term is.
fn add_divisors(unknowns: &[Name], sum: &Expr, found: &mut Vec<Expr>) {
    match sum.kind() {
        Kind::Negate(inner) => add_divisors(unknowns, inner, found),
        Kind::Binary(Operator::Add | Operator::Subtract, left, right) => {
            add_divisors(unknowns, left, found);
            add_divisors(unknowns, right, found);
        }
        _ => {
            let mut own: Vec<Expr> = Vec::new();
            undivided(unknowns, sum, &mut |divisor| {
                own.push(divisor.clone());
                true
            });
            let count = |list: &[Expr], one: &Expr| list.iter().filter(|own| *own == one).count();
            for divisor in &own {
                if found.len() <= MAX_DIVISORS && count(found, divisor) < count(&own, divisor) {
                    found.push(divisor.clone());
                }
            }
        }
    }
}

/// A sum, each term of it multiplied by all divisors or without those that it is divided by.
fn multiplied(unknowns: &[Name], sum: &Expr, divisors: &[Expr]) -> Expr {
    match sum.kind() {
        Kind::Negate(inner) => -multiplied(unknowns, inner, divisors),
        Kind::Binary(operator @ (Operator::Add | Operator::Subtract), left, right) => {
            let left = multiplied(unknowns, left, divisors);
            let right = multiplied(unknowns, right, divisors);
            match operator {
                Operator::Add => left + right,
                _ => left - right,
            }
        }
        _ => {
            let mut factors = divisors.to_vec();
            let term = undivided(unknowns, sum, &mut |divisor| {
                let place = factors.iter().position(|factor| factor == divisor);
                place.map(|place| factors.remove(place)).is_some()
            });
            factors.into_iter().fold(term, |term, factor| term * factor)
        }
    }
}

/// A product without the divisors with unknowns that `takes` takes.
fn undivided(unknowns: &[Name], product: &Expr, takes: &mut dyn FnMut(&Expr) -> bool) -> Expr {
    match product.kind() {
        Kind::Negate(inner) => -undivided(unknowns, inner, takes),
        Kind::Binary(Operator::Multiply, left, right) => {
            undivided(unknowns, left, takes) * undivided(unknowns, right, takes)
        }
        Kind::Binary(Operator::Divide, above, below) => {
            let above = undivided(unknowns, above, takes);
            match left_of_divisor(unknowns, below, takes) {
                Some(below) => above / below,
                None => above,
            }
        }
        Kind::Binary(Operator::Power, base, exponent)
            if exponent.as_number() == Some(-Rational::ONE)
                && has_unknown(unknowns, base)
                && takes(base) =>
        {
            Expr::number(1)
        }
        _ => product.clone(),
    }
}

/// What is left of a divisor; none if all of it is taken.
fn left_of_divisor(
    unknowns: &[Name],
    divisor: &Expr,
    takes: &mut dyn FnMut(&Expr) -> bool,
) -> Option<Expr> {
    if !has_unknown(unknowns, divisor) {
        return Some(divisor.clone());
    }
    match divisor.kind() {
        Kind::Negate(inner) => {
            let inner = left_of_divisor(unknowns, inner, takes);
            Some(-inner.unwrap_or_else(|| Expr::number(1)))
        }
        Kind::Binary(Operator::Multiply, left, right) => {
            let left = left_of_divisor(unknowns, left, takes);
            let right = left_of_divisor(unknowns, right, takes);
            match (left, right) {
                (Some(left), Some(right)) => Some(left * right),
                (left, right) => left.or(right),
            }
        }
        _ => (!takes(divisor)).then(|| divisor.clone()),
    }
}

fn has_unknown(unknowns: &[Name], expr: &Expr) -> bool {
    let names = expr.names();
    unknowns.iter().any(|unknown| names.uses(unknown))
}
