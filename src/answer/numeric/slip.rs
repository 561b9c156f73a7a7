//! Slips that a number alone gives away: 2π, a sign, degrees, a power of ten.

use std::f64::consts::TAU;

use super::marker::Numbers;
use super::read::TypedNumber;
use super::target::{Typed, pair};
use crate::answer::{Close, Decades, Negated, Slip, TwoPi, Why};
use crate::numerics::{Dd, powi};
use crate::unit::{Dimension, Quantity, Unit};

/// A degree in radians.
const DEGREE: f64 = TAU / 360.0;

/// A slip that the numbers alone give away; `unit` is what was typed.
pub(crate) fn slip(key: &Numbers, typed: &[Typed], unit: &Unit) -> Option<Slip> {
    let is_zero = key.targets.iter().all(|target| target.value == 0.0);
    let fits = |factor: f64| {
        let scaled: Vec<Typed> = typed
            .iter()
            .map(|typed| *typed * Dd::from(factor))
            .collect();
        let found = pair(&key.targets, &scaled, key.modulo, key.is_ordered);
        !is_zero && typed.len() == key.targets.len() && found == typed.len()
    };
    // Of a large number little is left within a turn, and that fits by chance.
    let fits_within_turn = |factor: f64| {
        let mut sizes = typed.iter().map(|typed| (typed.hi() * factor).abs());
        let turn = key.modulo;
        sizes.all(|size| turn.is_none_or(|turn| size <= turn)) && fits(factor)
    };
    let counts = key.unit.dimension() == Dimension::TIME.inverse();
    if counts && (fits(TAU) || fits(1.0 / TAU)) {
        return Some(Slip::TwoPi(two_pi(&key.unit, unit)));
    }
    if fits(-1.0) {
        return Some(Slip::Sign(match key.modulo {
            None => Negated::Number,
            Some(_) => Negated::Angle,
        }));
    }
    let is_angle = ["rad", "deg"]
        .iter()
        .any(|angle| key.unit.has_factor(angle));
    if is_angle && (fits_within_turn(DEGREE) || fits_within_turn(1.0 / DEGREE)) {
        let shown = if unit.is_one() { key.unit } else { *unit };
        return Some(Slip::AngleUnit(shown));
    }
    let is_percent = key.unit.is_one() && unit.is_one() && fits(0.01);
    if is_percent {
        return Some(Slip::PowerOfTen(Decades::Percent));
    }
    let mut factors = (1..=9).flat_map(|power| [powi(10.0, power), powi(10.0, -power)]);
    if key.modulo.is_none() && factors.any(fits) {
        return Some(Slip::PowerOfTen(Decades::Prefix));
    }
    if let ([target], [typed]) = (&key.targets[..], typed)
        && target.distance(*typed, key.modulo) <= 3.0 * target.half
    {
        return Some(Slip::Near(Close::Rounding));
    }
    None
}

/// What is said of a number that is the key, rounded to fewer figures than are asked for.
pub(crate) fn rounded_too_far(key: &Numbers, typed: Typed, number: &TypedNumber) -> Option<Why> {
    let decimal = &number.quantity.value;
    let (asked, has) = (key.figures, decimal.significant_figures());
    // To one figure much is rounded to the same.
    if !(2..asked).contains(&has) || number.arithmetic.is_some() {
        return None;
    }
    let (target, place) = (&key.targets[0], decimal.last_place());
    let place = key.si(&Quantity::new(place, number.quantity.unit)).ok()?;
    let is_near = target.distance(typed, key.modulo) <= 0.5 * place.hi().abs() + target.slack();
    let number = decimal.to_string();
    is_near.then_some(Why::Figures { asked, number, has })
}

/// Where a factor 2π slipped.
fn two_pi(asked: &Unit, typed: &Unit) -> TwoPi {
    let is_frequency = |unit: &Unit| unit.has_factor("rad") || unit.counts_cycles();
    if is_frequency(asked) || !is_frequency(typed) {
        return TwoPi::Number;
    }
    TwoPi::Cycles {
        typed: Box::new(*typed),
        asked: Box::new(*asked),
    }
}

/// Whether a joule was typed for a moment.
pub(crate) fn mixes_energy_and_moment(typed: &Unit, asked: &Unit) -> bool {
    let is_moment = asked.has_factor("N") && !asked.has_factor("J");
    typed.dimension() == asked.dimension() && typed.has_factor("J") && is_moment
}
