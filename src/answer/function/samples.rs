//! Values of a function at the times of a span, and how far rounding in the steps moves them.

use crate::expr::Precise;
use crate::quantity::{Absent, Evaluation, NodeId};

/// The values of a node at these times, with an absolute error of at most `accuracy`; exact to rounding for 0.
pub(crate) fn samples(
    evaluation: &Evaluation<'_>,
    node: NodeId,
    times: &[Precise],
    accuracy: f64,
) -> Result<Vec<f64>, Absent> {
    let function = evaluation.function(node)?;
    let is_constant = function.variables().next().is_none();
    let places = times.chunks(1);
    let places = places.map(|time| if is_constant { &[][..] } else { time });
    function.reals_at(places, accuracy)
}

/// The accuracy of values that are compared with others of this size: a million times finer than the steps of the
/// derivatives.
pub(crate) fn fine(largest: f64) -> f64 {
    1e-12 * largest
}

/// The share of a value by which rounding to this many figures moves it at most.
pub(crate) fn rounding(digits: u32) -> f64 {
    0.005 * crate::numerics::powi(10.0, 3 - digits as i32)
}

/// The rounding of one step widens a function by at most this share of its largest value: a phase that is lost altogether
/// is no tolerance.
const MAX_SHARE: f64 = 0.05;

/// How far rounding in the steps moves the function, time by time.
pub(crate) fn derived(
    evaluation: &Evaluation<'_>,
    key: NodeId,
    times: &[Precise],
    values: &[f64],
    largest: f64,
    digits: u32,
) -> Vec<f64> {
    // Above 1e-8, the root of the unit roundoff, at which a one-sided difference loses half its digits: two figures
    // of a spread suffice, and these are safe here.
    const STEP: f64 = 1e-6;
    let share = rounding(digits);
    let mut spread = vec![largest; values.len()];
    let mut add = |moved: &[f64]| {
        for ((sum, moved), value) in spread.iter_mut().zip(moved).zip(values) {
            let part = (moved - value).abs() / STEP;
            *sum += if part.is_finite() {
                part.min(MAX_SHARE / share * largest)
            } else {
                0.0
            };
        }
    };
    let graph = evaluation.graph();
    for step in graph
        .steps(key)
        .into_iter()
        .filter(|step| graph.variables(*step).is_empty())
    {
        let Ok(given) = evaluation.value(step) else {
            continue;
        };
        let other = evaluation.replacing(vec![(step, given.scaled(1.0 + STEP))]);
        if let Ok(moved) = samples(&other, key, times, fine(largest)) {
            add(&moved);
        }
    }
    // A frequency that stands in the formula without a name is rounded all the same.
    let later: Vec<Precise> = times
        .iter()
        .map(|time| Precise::exact(time.high() * (1.0 + STEP)))
        .collect();
    if let Ok(moved) = samples(evaluation, key, &later, fine(largest)) {
        add(&moved);
    }
    spread.into_iter().map(|sum| share * sum).collect()
}
