//! Equations with a root alone on one side, `sqrt(x^2 + y^2) = l`: the same without it.

use super::Setup;
use super::points::{Choices, value};
use crate::expr::{Equation, Expr, Function, Kind, Operator};
use crate::numerics::{Rational, SortedMap};

/// The equations with both sides squared where a root is said to be a positive datum; none if there is no such.
pub(crate) fn without_roots(
    setup: &Setup,
    choices: &Choices,
    equations: &[Equation],
) -> Option<Vec<Equation>> {
    let squared = |equation: &Equation| {
        let Equation { left, right } = equation;
        [(left, right), (right, left)]
            .into_iter()
            .find_map(|(root, length)| {
                Some(Equation {
                    left: radicand(root)?.clone(),
                    right: is_positive(setup, choices, length).then(|| length.clone().squared())?,
                })
            })
    };
    let found: Vec<_> = equations.iter().map(squared).collect();
    found.iter().any(Option::is_some).then(|| {
        let kept = equations.iter().zip(found);
        kept.map(|(own, squared)| squared.unwrap_or_else(|| own.clone()))
            .collect()
    })
}

/// Whether a side has no unknowns and is positive for all choices of data.
fn is_positive(setup: &Setup, choices: &Choices, side: &Expr) -> bool {
    let names = side.names();
    let is_datum = names
        .free
        .iter()
        .all(|variable| !setup.unknowns.contains(&variable.name) && variable.name.as_str() != "t");
    let program = setup.meaning.compile(side, &SortedMap::new());
    is_datum
        && program.is_ok_and(|program| {
            let mut points = choices.points.iter().flatten();
            points.all(|point| value(&program, point) > 0.0)
        })
}

/// What stands under the root that a side is.
fn radicand(side: &Expr) -> Option<&Expr> {
    match side.kind() {
        Kind::Call(Function::Sqrt, inner) => inner.first(),
        Kind::Binary(Operator::Power, inner, half) => {
            (half.as_number() == Rational::new(1, 2)).then_some(inner)
        }
        _ => None,
    }
}
