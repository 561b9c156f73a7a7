//! What is wrong with a function, recognized by its values: a sign, degrees, a frequency in hertz, a power of ten.

use std::convert::Infallible;

use super::marker::{Prepared, Response};
use crate::answer::{Close, Decades, Negated, Slip, TwoPi};
use crate::expr::{Constant, Expr, Function, Kind, Operator, Substitution};
use crate::unit::Unit;

/// A difference of this many half-widths is near.
const NEAR: f64 = 3.0;
/// A value of so many half-widths is seen to be right.
const SEEN: f64 = 8.0;
/// Samples that a motion has to begin with to begin rightly.
const FIRST: usize = 3;

/// The slip that made a wrong function, if it can be diagnosed.
pub(crate) fn slip(key: &Prepared<'_>, response: &Response) -> Option<Slip> {
    let scaled = |factor: f64| {
        let all = response.values.iter();
        let scaled = all.map(|of| of.iter().map(|value| factor * value).collect());
        scaled.collect::<Vec<Vec<f64>>>()
    };
    let fits = |found: &[Vec<f64>]| key.fits(found, &key.values);
    let fits_with = |change: &dyn Fn(&Expr) -> Option<Expr>| {
        let changed = in_angles(&response.expr, change);
        let values = key.values_in(&changed, &response.units);
        values.is_some_and(|values| fits(&values))
    };
    let variable = &key.setup.variable;
    let at = |angle: &Expr, time: Expr| {
        let put = Substitution::new().with(variable.clone(), time);
        put.apply(angle).ok()
    };
    if fits(&scaled(-1.0)) {
        return Some(Slip::Sign(Negated::Whole));
    }
    let has_degrees = fits_with(&|angle| {
        let start = at(angle, Expr::number(0))?;
        let radians = start.clone() * Expr::constant(Constant::Pi) / Expr::number(180);
        Some(angle.clone() - start + radians)
    });
    if has_degrees {
        return Some(Slip::PhaseInDegrees);
    }
    let has_turns = fits_with(&|angle| {
        let turn = Expr::number(2) * Expr::constant(Constant::Pi);
        at(angle, turn * Expr::name(variable.clone()))
    });
    if has_turns {
        return Some(Slip::TwoPi(TwoPi::Wave));
    }
    let is_bare = !key.has_data(&response.expr);
    let ten = |power: i32| fits(&scaled(crate::numerics::powi(10.0, power)));
    if is_bare && (1..=6).any(|power| ten(power) || ten(-power)) {
        let unit = key.setup.unit.unwrap_or(Unit::ONE);
        return Some(Slip::PowerOfTen(Decades::Function(unit)));
    }
    let found = response.values.iter().map(|values| course(key, values));
    found
        .flatten()
        .min_by_key(|slip| *slip != Slip::Near(Close::Rounding))
}

/// What the differences from the key say.
fn course(key: &Prepared<'_>, values: &[f64]) -> Option<Slip> {
    let pairs = values.iter().zip(&key.values);
    let differences: Vec<f64> = pairs.map(|(typed, own)| (typed - own).abs()).collect();
    let is_within = |count: usize, times: f64| {
        let mut pairs = differences.iter().zip(&key.halves).take(count);
        pairs.all(|(difference, half)| *difference <= times * half)
    };
    let largest = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
    let grows = largest(&differences) > 2.0 * largest(&differences[..differences.len() / 3]);
    // What begins with nothing begins alike whatever follows.
    let mut first = key.values.iter().zip(&key.halves).take(FIRST);
    let is_seen = first.any(|(own, half)| own.abs() > SEEN * half);
    if is_within(differences.len(), NEAR) {
        Some(Slip::Near(Close::Rounding))
    } else if is_seen && is_within(FIRST, 2.0) && grows {
        Some(Slip::RunsAway)
    } else {
        None
    }
}

/// A function with the arguments of its sines and cosines changed.
fn in_angles(expr: &Expr, change: &dyn Fn(&Expr) -> Option<Expr>) -> Expr {
    if let Kind::Call(function @ (Function::Sin | Function::Cos), angles) = expr.kind() {
        let changed = angles.iter().map(change).collect::<Option<Vec<_>>>();
        return changed.map_or(expr.clone(), |angles| Expr::call(*function, angles));
    }
    mapped(expr, &mut |child| in_angles(child, change))
}

/// A function with 1 in place of its waves and exponentials: what their factors are measured in.
pub(crate) fn without_waves(expr: &Expr) -> Expr {
    match expr.kind() {
        Kind::Call(
            Function::Sin
            | Function::Cos
            | Function::Tan
            | Function::Exp
            | Function::Sinh
            | Function::Cosh
            | Function::Tanh,
            _,
        ) => Expr::number(1),
        Kind::Binary(Operator::Power, base, _) if *base.kind() == Kind::Constant(Constant::E) => {
            Expr::number(1)
        }
        _ => mapped(expr, &mut without_waves),
    }
}

fn mapped(expr: &Expr, change: &mut dyn FnMut(&Expr) -> Expr) -> Expr {
    match expr.try_map_children(&mut |child| Ok::<_, Infallible>(change(child))) {
        Ok(changed) => changed,
        Err(never) => match never {},
    }
}
