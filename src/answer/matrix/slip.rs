//! Slips that a whole matrix gives away: a common factor, another order of the coordinates, a dimension.

use std::sync::Arc;

use super::Setup;
use super::marker::Prepared;
use crate::answer::equality::{Comparable, Comparison, Points};
use crate::answer::{Decades, Misfit, Negated, Slip};
use crate::expr::Expr;

/// Largest number of coordinates whose order is looked at.
const MAX_COORDINATES: usize = 4;

/// What slipped in a matrix of numbers, of which not all are those of the key.
pub(crate) fn of_numbers(key: &Prepared, numbers: &[f64]) -> Option<Slip> {
    let keys = key.value.numbers();
    let largest = (0..keys.len()).max_by(|a, b| keys[*a].abs().total_cmp(&keys[*b].abs()))?;
    let is_off_by = |factor: f64| {
        let is_near = |place: usize| key.is_near(place, numbers[place] / factor, keys[place]);
        factor != 0.0 && factor.is_finite() && (0..keys.len()).all(is_near)
    };
    let powers = (-9..=9).map(|power| crate::numerics::powi(10.0, power));
    let plain = [-1.0]
        .into_iter()
        .chain(powers)
        .find(|power| is_off_by(*power));
    let factor = plain.or(Some(numbers[largest] / keys[largest]).filter(|own| is_off_by(*own)));
    let same = |own: usize, typed: usize| key.is_near(own, numbers[typed], keys[own]);
    factor
        .map(of_factor)
        .or_else(|| reordered(&key.setup, same))
}

/// The same for formulas, which compare with the key like this.
pub(crate) fn of_formulas(
    key: &Prepared,
    (keys, points): &(Arc<Vec<Comparable>>, Arc<Points>),
    typed: &[Comparable],
    comparisons: &[Comparison],
) -> Option<Slip> {
    let is_zero = |place: usize| key.value.numbers()[place] == 0.0;
    let ratio = |place: usize| match &comparisons[place] {
        Comparison::Different { ratio, .. } => *ratio,
        _ => None,
    };
    let mut others = (0..typed.len()).filter(|place| !is_zero(*place));
    let first = others.next().and_then(ratio);
    let is_common = |first: &f64| {
        let is_alike = |own: f64| (own - first).abs() <= 1e-9 * first.abs();
        others.all(|place| ratio(place).is_some_and(is_alike))
            && (0..typed.len())
                .all(|place| !is_zero(place) || comparisons[place] == Comparison::Same)
    };
    let same =
        |own: usize, place: usize| points.compare(&keys[own], &typed[place]) == Comparison::Same;
    let factor = first.filter(is_common).map(of_factor);
    factor.or_else(|| reordered(&key.setup, same))
}

/// Whether the entries are those for two coordinates in each other's place.
fn reordered(setup: &Setup, same: impl Fn(usize, usize) -> bool) -> Option<Slip> {
    let (rows, columns) = (setup.rows, setup.columns);
    let count = Some(rows).filter(|count| *count == columns && *count <= MAX_COORDINATES)?;
    let is_for = |first: usize, second: usize| {
        let other = |own: usize| match own {
            own if own == first => second,
            own if own == second => first,
            own => own,
        };
        let key = |place: usize| other(place / columns) * columns + other(place % columns);
        (0..rows * columns).all(|place| same(key(place), place))
    };
    let found = (0..count).any(|second| (0..second).any(|first| is_for(first, second)));
    found.then_some(Slip::OtherOrder)
}

/// The first of these entries that has another dimension than the key.
pub(crate) fn wrong_dimension(key: &Prepared, entries: &[Expr], wrong: &[usize]) -> Option<Misfit> {
    let setup = &key.setup;
    wrong.iter().find_map(|place| {
        let (entry, unit) = (&entries[*place], setup.units.get(*place)?);
        let at = Some(key.place(*place));
        Some(match entry.check(&setup.meaning) {
            _ if entry.is_zero() => return None,
            Err(errors) => Misfit::Step {
                entry: at,
                error: errors.first().cloned(),
            },
            Ok(found) => Misfit::Comes {
                entry: at,
                found: found.dimension().filter(|own| *own != unit.dimension())?,
                unit: Some(*unit).filter(|unit| !unit.text().is_empty()),
                asked: Some(unit.dimension()),
            },
        })
    })
}

fn of_factor(factor: f64) -> Slip {
    let is_near = |number: f64| (factor - number).abs() <= 1e-9 * number.abs();
    if is_near(-1.0) {
        return Slip::Sign(Negated::Entries);
    }
    if (-9..=9).any(|power| power != 0 && is_near(crate::numerics::powi(10.0, power))) {
        return Slip::PowerOfTen(Decades::Prefix);
    }
    Slip::CommonFactor
}
