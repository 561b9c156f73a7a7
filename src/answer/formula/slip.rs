//! What a wrong formula has in common with the key.

use crate::answer::Reason;
use crate::answer::equality::Comparison;
use crate::expr::{Expr, Kind};
use crate::unit::Dimension;

/// The reason why a formula is wrong, and what is said about it.
pub(super) fn slip(
    comparison: &Comparison,
    typed: &Expr,
    dimension: Option<Dimension>,
) -> (Reason, Option<&'static str>) {
    const TWO_PI: f64 = std::f64::consts::TAU;
    const NEAR: f64 = 5e-3;
    // A series that was cut off leaves less, and a ratio that only looks constant.
    const TRUNCATED: f64 = 1e-6;
    let is = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b;
    let (ratio, part) = match comparison {
        Comparison::Undefined => {
            let words = "This has no value for data for which there is an answer.";
            return (Reason::Other, Some(words));
        }
        Comparison::Different { ratio, part } => (*ratio, *part),
        _ => return (Reason::Other, None),
    };
    match ratio {
        Some(ratio) if is(-ratio, 1.0) => (Reason::Sign, Some("The sign is wrong.")),
        Some(ratio) if is(ratio, TWO_PI) || is(ratio, 1.0 / TWO_PI) => {
            let is_frequency = dimension.is_some_and(|own| {
                own == Dimension::TIME || own == Dimension::PURE / Dimension::TIME
            });
            let words = if is_frequency {
                "It is off by a factor of 2π: angular frequencies and frequencies in hertz differ by it."
            } else {
                "It is off by a factor of 2π."
            };
            (Reason::TwoPi, Some(words))
        }
        _ if part < NEAR && (has_decimals(typed) || ratio.is_some() && part > TRUNCATED) => (
            Reason::Near,
            Some(
                "It is nearly right: give the numbers in it exactly, as fractions, roots or multiples of π.",
            ),
        ),
        Some(0.0) => (Reason::Other, Some("This is zero.")),
        Some(_) => (
            Reason::Other,
            Some("The symbols fit, but not the number in front."),
        ),
        None => (Reason::Other, None),
    }
}

/// Whether a number in a formula has decimals.
fn has_decimals(expr: &Expr) -> bool {
    let mut found = false;
    expr.walk(&mut |node| {
        found |= matches!(node.kind(), Kind::Number(value) if !value.is_integer());
    });
    found
}
