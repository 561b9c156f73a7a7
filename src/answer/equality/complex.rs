//! Formulas near the real points, at complex values of all data.
//!
//! What is equal for real data is equal for complex data nearby, as long as no root or logarithm changes its
//! branch. The data are turned by a little, so that quantities that are positive stay in the right half-plane;
//! a pair that differs at two points is different.

use std::sync::Arc;

use crate::answer::meaning::{Meaning, ORDERS};
use crate::expr::{Approx, Expr, Name, Precise, Program, Registers};
use crate::numerics::SortedMap;

/// Points that are turned.
// Two of them have to differ, so that one point at which digits are lost decides nothing.
const POINTS: usize = 4;
/// Angles in radians by which data are turned, in turn.
// Less than a degree or so, that no branch cut is crossed on the way; unequal and of both signs, that the angles of a
// product do not cancel.
const ANGLES: [f64; 5] = [0.011, -0.007, 0.017, -0.019, 0.005];
/// Values that differ by more than this part are different: a branch leaves more, rounding less.
const DIFFERENT: f64 = 1e-6;

/// A formula over complex data, if it keeps its meaning there.
pub(crate) fn program(
    meaning: &Meaning,
    expr: &Expr,
    replaced: &SortedMap<Name, Expr>,
) -> Option<Program> {
    meaning
        .is_analytic(expr, replaced)
        .then(|| meaning.compile_complex(expr, replaced).ok())?
}

/// Whether two formulas differ at complex points near these; integers stay what they are.
pub(crate) fn differ(
    key: &Program,
    other: &Program,
    points: &[Arc<[Precise]>],
    are_integers: &[bool],
) -> bool {
    let mut room = Registers::<Approx<f64>>::default();
    let directions = ANGLES.map(|angle| [crate::numerics::cos(angle), crate::numerics::sin(angle)]);
    let mut differing = 0;
    for point in points.iter().take(POINTS) {
        let turned = turned(point, are_integers, &directions);
        let mut value = |program: &Program| {
            let outcome = program.run(&turned[..], &mut room).ok()?;
            let mut numbers = outcome.numbers();
            let (re, im) = (numbers.next()?, numbers.next());
            let (value, bound) = im.map_or((0.0, 0.0), |im| (im.value, im.bound));
            Some((re.value, value, re.bound + bound))
        };
        let (Some(a), Some(b)) = (value(key), value(other)) else {
            continue;
        };
        let size = a.0.abs() + a.1.abs();
        let distance = (a.0 - b.0).abs() + (a.1 - b.1).abs();
        let opposite = (a.0 + b.0).abs() + (a.1 + b.1).abs();
        let limit = DIFFERENT * size + 4.0 * (a.2 + b.2);
        differing += usize::from(distance > limit && opposite > limit);
    }
    differing >= 2
}

/// A point with each value turned in the complex plane; two numbers for each.
fn turned(point: &[Precise], are_integers: &[bool], directions: &[[f64; 2]]) -> Vec<Precise> {
    let values = point.iter().enumerate();
    values
        .flat_map(|(place, value)| {
            let size = value.high();
            if are_integers.get(place / ORDERS) == Some(&true) {
                return [Precise::exact(size), Precise::exact(0.0)];
            }
            directions[place % directions.len()].map(|share| Precise::exact(size * share))
        })
        .collect()
}
