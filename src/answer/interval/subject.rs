//! What an inequality bounds: the variable, or a distance such as `|x - a|`.

use super::bound::Ends;
use super::read::{Read, like_interval};
use super::set::{End, Set, SetPiece};
use crate::answer::Why;
use crate::expr::{Expr, Function, Kind, Operator, Substitution};
use crate::numerics::Rational;
use crate::response::Passage;
use crate::unit::Unit;

/// What an inequality bounds.
pub(crate) enum BoundedSubject {
    /// The bare variable, as in `x < 2`.
    Variable,
    /// Its distance from a place, times a slope.
    Distance { centre: f64, slope: f64 },
    /// Its square, `c^2 < 2 k m`: the root of its bounds bounds the distance from zero.
    Square,
}

impl BoundedSubject {
    /// What a side speaks of, if it is the variable or a distance on its axis; a number there that has no unit has the one
    /// at hand.
    pub(crate) fn of(ends: &Ends<'_>, side: Passage<'_>, unit: Option<Unit>) -> Option<Self> {
        if let Some(distance) = distance_from_number(ends, side, unit) {
            return Some(distance);
        }
        let expr = ends.formula(side).ok()?;
        match expr.kind() {
            Kind::Name(name) if *name == ends.setup.variable => Some(Self::Variable),
            Kind::Call(Function::Abs, arguments) => distance(ends, arguments.first()?),
            Kind::Binary(Operator::Power, base, exponent) => {
                let is_variable =
                    matches!(base.kind(), Kind::Name(name) if *name == ends.setup.variable);
                let is_two =
                    matches!(exponent.kind(), Kind::Number(two) if *two == Rational::from(2));
                (is_variable && is_two).then_some(Self::Square)
            }
            _ => None,
        }
    }

    /// The end of what is bounded by a side.
    pub(crate) fn end(
        &self,
        ends: &Ends<'_>,
        bound: Passage<'_>,
        is_open: bool,
        unit: &mut Option<Unit>,
    ) -> Read<End> {
        match self {
            // A root that has no value, or another dimension, was not typed.
            Self::Square => ends
                .end(bound.root().passage(), is_open, unit)
                .map_err(|_| like_interval(Why::SolveFor(ends.setup.symbol.plain())).into()),
            _ => ends.end(bound, is_open, unit),
        }
    }

    /// The values of the variable for which it lies in a piece.
    pub(crate) fn where_it_is_in(&self, piece: SetPiece) -> Set {
        let (centre, slope) = match self {
            Self::Variable => return Set::of(vec![piece]),
            Self::Distance { centre, slope } => (*centre, *slope),
            Self::Square => (0.0, 1.0),
        };
        let [low, high] = piece.0;
        let moved = |end: End, side: f64| End {
            value: centre + side * end.value / slope,
            ..end
        };
        let above = SetPiece([moved(low, 1.0), moved(high, 1.0)]);
        let below = SetPiece([moved(high, -1.0), moved(low, -1.0)]);
        // A distance is never negative.
        if low.value < 0.0 {
            return Set::of(vec![SetPiece([below.0[0], above.0[1]])]);
        }
        Set::of(vec![below, above])
    }
}

/// The distance `|x - 92.5 mm|` from a number.
fn distance_from_number(
    ends: &Ends<'_>,
    side: Passage<'_>,
    unit: Option<Unit>,
) -> Option<BoundedSubject> {
    let ([one, other], is_less) = side.distance()?;
    let is_variable = |term: Passage<'_>| {
        let formula = ends.formula(term);
        formula
            .is_ok_and(|own| matches!(own.kind(), Kind::Name(name) if *name == ends.setup.variable))
    };
    let number = if is_variable(one) {
        other
    } else {
        Some(one).filter(|_| is_variable(other))?
    };
    let centre = ends.number(number, &mut { unit }).ok().flatten()?;
    Some(BoundedSubject::Distance {
        centre: if is_less { centre } else { -centre },
        slope: 1.0,
    })
}

/// The place where a linear expression in the variable vanishes, and its slope.
fn distance(ends: &Ends<'_>, inner: &Expr) -> Option<BoundedSubject> {
    // Three values of one formula, with a few roundings each; a curvature that is meant shows far more.
    const ROUNDING: f64 = 1e-9;
    let variable = &ends.setup.variable;
    let at = |place: i32| {
        let unit = Box::new(ends.setup.unit.coherent());
        let place = Expr::derived(Kind::Measure(Rational::from(place), unit));
        let put = Substitution::new().with(variable.as_str(), place);
        ends.value(&put.apply(inner).ok()?)
    };
    if !inner.names().uses(variable) {
        return None;
    }
    let (start, slope) = (at(0)?, at(1)? - at(0)?);
    let is_linear = (at(2)? - at(1)? - slope).abs() <= ROUNDING * slope.abs();
    (is_linear && slope != 0.0).then_some(BoundedSubject::Distance {
        centre: -start / slope,
        slope: slope.abs(),
    })
}
