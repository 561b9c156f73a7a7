//! The phase of a function that is typed as one wave, `0.102 e^(-4.24 t) cos(8.94 t - 2.48)`, and how far its rounding may
//! have moved it.
//!
//! The tolerance of a function allows for rounding in the steps between the data and the answer. The phase is no such
//! step, since the answer has it only in this form; what its last figure hides is a shift of the wave and nothing else.
//! So a function is compared with all phases that are printed like the one that was typed: in no other way does it get
//! wider, and an amplitude, a frequency or a decay that is off stays so.

use crate::expr::{Expr, Function, Kind, Name, Operator};
use crate::numerics::Rational;
use crate::unit::Decimal;

/// Phases that are tried on each side of the one that was typed: neighbours differ by an eighth of the last figure, that
/// is by a thousandth of a wave at most.
const STEPS: i32 = 4;

/// Half a degree: more than the rounding of any angle below a turn to three figures.
const MAX_HALF: f64 = 0.01;

/// The same function with each of the phases that are rounded to its own, the nearest ones first; none where it is not
/// one wave with one phase that is a number.
pub(crate) fn rounded_alike(function: &Expr, variable: &Name, figures: u32) -> Vec<Expr> {
    let mut waves = 0;
    function.walk(&mut |node| waves += u32::from(is_wave(node)));
    let mut phase = None;
    function.walk(&mut |node| {
        phase = phase.take().or_else(|| phase_in(node, variable));
    });
    let Some(phase) = phase.filter(|_| waves == 1) else {
        return Vec::new();
    };
    let half = half_unit(number_of(&phase), figures);
    let Some(half) = half.filter(|half| half.to_f64() * radians(&phase) <= MAX_HALF) else {
        return Vec::new();
    };
    let steps = (1..=STEPS).flat_map(|step| [step, -step]);
    let shifted = |step: i32| {
        let shift = half.checked_mul(Rational::new(i128::from(step), i128::from(STEPS))?)?;
        let moved = number_of(&phase)?.checked_add(shift)?;
        Some(replaced(function, &phase, moved))
    };
    steps.filter_map(shifted).collect()
}

fn is_wave(expr: &Expr) -> bool {
    matches!(expr.kind(), Kind::Call(Function::Sin | Function::Cos, _))
}

/// The number that is added to what changes, within the argument of a wave that stands here.
fn phase_in(expr: &Expr, variable: &Name) -> Option<Expr> {
    if let Kind::Call(Function::Sin | Function::Cos, arguments) = expr.kind()
        && let [argument] = &arguments[..]
    {
        let Kind::Binary(Operator::Add | Operator::Subtract, left, right) = argument.kind() else {
            return None;
        };
        let changes = |own: &Expr| own.names().uses(variable);
        return match (changes(left), changes(right)) {
            (true, false) => number_in(right),
            (false, true) => number_in(left),
            _ => None,
        };
    }
    None
}

/// The number that a phase is, with a sign or not, in radians or degrees.
fn number_in(phase: &Expr) -> Option<Expr> {
    match phase.kind() {
        Kind::Negate(inner) => number_in(inner),
        Kind::Number(_) | Kind::Measure(..) => Some(phase.clone()),
        _ => None,
    }
}

fn number_of(phase: &Expr) -> Option<Rational> {
    match phase.kind() {
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
fn half_unit(number: Option<Rational>, figures: u32) -> Option<Rational> {
    let number = number.filter(|number| *number != Rational::ZERO)?;
    let rounded = Decimal::rounded(number.to_f64(), figures)?;
    let own = Decimal::shortest(number.to_f64())?;
    let place = rounded.last_place().to_f64().min(own.last_place().to_f64());
    Rational::from_decimal(&Decimal::shortest(0.5 * place)?.to_string())
}

/// A function with another number in place of its phase.
fn replaced(function: &Expr, phase: &Expr, value: Rational) -> Expr {
    if function.is_same(phase) {
        let kind = match phase.kind() {
            Kind::Measure(_, unit) => Kind::Measure(value, unit.clone()),
            _ => Kind::Number(value),
        };
        return Expr::new(kind, phase.span());
    }
    let mut put = |child: &Expr| Ok::<_, std::convert::Infallible>(replaced(child, phase, value));
    function
        .try_map_children(&mut put)
        .unwrap_or_else(|never| match never {})
}
