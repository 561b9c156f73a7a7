//! A function that is typed as one wave with a phase, `0.102 e^(-4.24 t) cos(8.94 t - 2.48)`, and how far the rounding of its
//! numbers moves it.
//!
//! The tolerance of a function allows for rounding in the steps between the data and the answer. The amplitude and the
//! phase of one wave are no such steps: the answer has them in this form alone. So such a function is also right where it
//! differs from the key by no more than the rounding of the numbers that were typed, each by half a unit of its last
//! figure: that is what honest work loses at the end, and a number that is off by more stays wrong.

use crate::expr::{Expr, Function, Kind, Name, Operator};
use crate::numerics::Rational;
use crate::unit::Decimal;

/// Half a degree: more than the rounding of any angle below a turn to three figures.
const MAX_HALF: f64 = 0.01;

/// The same function with each of its numbers half a unit of its last figure lower and higher; none where it is not one
/// wave with a phase, a factor beside it at most: where terms cancel, their rounding would allow for anything.
pub(crate) fn with_rounded_numbers(
    function: &Expr,
    variable: &Name,
    figures: u32,
) -> Option<Vec<[Expr; 2]>> {
    let (mut waves, mut sums) = (0, 0);
    let (mut phase, mut numbers) = (None, Vec::new());
    function.walk(&mut |node| {
        waves += u32::from(is_wave(node));
        let is_sum = matches!(
            node.kind(),
            Kind::Binary(Operator::Add | Operator::Subtract, ..)
        );
        sums += u32::from(is_sum);
        phase = phase.take().or_else(|| phase_in(node, variable));
        if number_of(node).is_some() {
            numbers.push(node.clone());
        }
    });
    let phase = phase.filter(|_| waves == 1 && sums == 1)?;
    let half = half_unit(number_of(&phase)?, figures)?;
    if half.to_f64() * radians(&phase) > MAX_HALF {
        return None;
    }
    let moved = numbers.iter().filter_map(|number| {
        let value = number_of(number)?;
        let half = half_unit(value, figures)?;
        let lower = replaced(function, number, value.checked_sub(half)?);
        Some([lower, replaced(function, number, value.checked_add(half)?)])
    });
    Some(moved.collect())
}

fn is_wave(expr: &Expr) -> bool {
    matches!(expr.kind(), Kind::Call(Function::Sin | Function::Cos, _))
}

/// The number that is added to what changes, within the argument of a wave that stands here.
fn phase_in(expr: &Expr, variable: &Name) -> Option<Expr> {
    let Kind::Call(Function::Sin | Function::Cos, arguments) = expr.kind() else {
        return None;
    };
    let Kind::Binary(Operator::Add | Operator::Subtract, left, right) = arguments.first()?.kind()
    else {
        return None;
    };
    let changes = |own: &Expr| own.names().uses(variable);
    match (changes(left), changes(right)) {
        (true, false) => number_in(right),
        (false, true) => number_in(left),
        _ => None,
    }
}

/// The number that a phase is, with a sign or not, in radians or degrees.
fn number_in(phase: &Expr) -> Option<Expr> {
    match phase.kind() {
        Kind::Negate(inner) => number_in(inner),
        Kind::Number(_) | Kind::Measure(..) => Some(phase.clone()),
        _ => None,
    }
}

fn number_of(expr: &Expr) -> Option<Rational> {
    match expr.kind() {
        Kind::Number(value) | Kind::Measure(value, _) => Some(*value),
        _ => None,
    }
}

/// The size of the unit of a phase in radians.
fn radians(phase: &Expr) -> f64 {
    match phase.kind() {
        Kind::Measure(_, unit) => unit.to_si(1.0),
        _ => 1.0,
    }
}

/// Half a unit of the last of these figures of a number; of its own last place where it has more.
fn half_unit(number: Rational, figures: u32) -> Option<Rational> {
    if number == Rational::ZERO {
        return None;
    }
    let places = [
        Decimal::rounded(number.to_f64(), figures)?,
        Decimal::shortest(number.to_f64())?,
    ];
    let place = places.map(|own| own.last_place().to_f64());
    let half = 0.5 * place[0].min(place[1]);
    Rational::from_decimal(&Decimal::shortest(half)?.to_string())
}

/// A function with another number in place of one of its own.
fn replaced(function: &Expr, number: &Expr, value: Rational) -> Expr {
    if function.is_same(number) {
        let kind = match number.kind() {
            Kind::Measure(_, unit) => Kind::Measure(value, unit.clone()),
            _ => Kind::Number(value),
        };
        return Expr::new(kind, number.span());
    }
    let mut put = |child: &Expr| Ok::<_, std::convert::Infallible>(replaced(child, number, value));
    function
        .try_map_children(&mut put)
        .unwrap_or_else(|never| match never {})
}
