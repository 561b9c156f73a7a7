//! What a wrong formula has in common with the key.

use crate::answer::equality::Comparison;
use crate::answer::{Close, Negated, Slip, TwoPi};
use crate::expr::{Expr, Kind};
use crate::unit::Dimension;

/// In what a formula differs from the key, where that can be diagnosed.
pub(crate) fn slip(
    comparison: &Comparison,
    typed: &Expr,
    dimension: Option<Dimension>,
) -> Option<Slip> {
    // The commonest factor of all: ω for f, or f for ω.
    const TWO_PI: f64 = std::f64::consts::TAU;
    // A constant of three figures is off by at most half a percent; 9.8 for 9.81 is nearer.
    const NEAR: f64 = 5e-3;
    // A series that was cut off leaves less, and a ratio that only looks constant.
    const TRUNCATED: f64 = 1e-6;
    let is = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    let (ratio, part) = match comparison {
        Comparison::Undefined => return Some(Slip::NoValueForData),
        Comparison::Different { ratio, part } => (*ratio, *part),
        _ => return None,
    };
    Some(match ratio {
        Some(ratio) if is(-ratio, 1.0) => Slip::Sign(Negated::Whole),
        Some(ratio) if is(ratio, TWO_PI) || is(ratio, 1.0 / TWO_PI) => {
            let is_frequency = dimension.is_some_and(|own| {
                own == Dimension::TIME || own == Dimension::PURE / Dimension::TIME
            });
            Slip::TwoPi(if is_frequency {
                TwoPi::Frequency
            } else {
                TwoPi::Formula
            })
        }
        _ if part < NEAR && (has_decimals(typed) || ratio.is_some() && part > TRUNCATED) => {
            Slip::Near(Close::RoundedFormula)
        }
        Some(0.0) => Slip::Zero,
        Some(_) => Slip::Factor,
        None => return None,
    })
}

/// Whether a number in a formula has decimals.
fn has_decimals(expr: &Expr) -> bool {
    let mut found = false;
    expr.walk(&mut |node| {
        found |= matches!(node.kind(), Kind::Number(value) if !value.is_integer());
    });
    found
}
