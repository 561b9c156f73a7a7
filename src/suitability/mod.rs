//! Whether an instance is fit to hand out.
//!
//! A *draw* knows the constraints of its item only. *Choosing* takes the first seed whose items are
//! all suitable: each key exists, and no named mistake and no standard wrong method that differs from the key lies
//! within two half-widths of it. Honest work by a wrong method is itself off by up to one half-width; what lies two
//! of them away stays outside.

use crate::answer::Kind;
use crate::expr::Precise;
use crate::quantity::{Evaluation, Function, Method, NodeId, Wrong};
use crate::solution::Solution;

/// Why an instance is not fit to hand out.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unfit {
    /// A part that is asked has no answer.
    #[error("part `{part}` has no answer: {reason}")]
    NoKey {
        /// The part.
        part: String,
        /// Why.
        reason: String,
    },
    /// A mistake that cannot be told from the key.
    #[error("a mistake of part `{part}` lies {tolerances:.1} tolerances from its key")]
    NearMistake {
        /// The part.
        part: String,
        /// The distance in tolerances.
        tolerances: f64,
    },
    /// A wrong method that cannot be told from the right one.
    #[error("part `{part}`: {method} lies {tolerances:.1} tolerances from the key")]
    NearMethod {
        /// The part.
        part: String,
        /// What is done wrongly.
        method: Wrong,
        /// The distance in tolerances.
        tolerances: f64,
    },
}

/// Mistakes and wrong methods keep this distance from the key, in tolerances.
pub const CLEARANCE: f64 = 2.0;

/// Whether the parts that are asked have keys from which their named mistakes can be told.
///
/// # Errors
///
/// The first reason why they are not fit to hand out.
pub fn judge(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    for place in parts.iter().filter(|place| solution.asks(**place)) {
        let part = || solution.template().parts[*place].id.clone();
        let clearance = solution.clearance(*place);
        let clearance = clearance.map_err(|absent| Unfit::NoKey {
            part: part(),
            reason: absent.to_string(),
        })?;
        if let Some(tolerances) = clearance.filter(|clearance| *clearance < CLEARANCE) {
            return Err(Unfit::NearMistake {
                part: part(),
                tolerances,
            });
        }
    }
    Ok(())
}

/// Whether the parts that are asked have keys from which the standard wrong methods can be told, and which no named
/// mistake happens to give.
///
/// # Errors
///
/// The first method that cannot.
pub fn judge_methods(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    for place in parts.iter().filter(|place| solution.asks(**place)) {
        let part = &solution.template().parts[*place];
        if !matches!(
            part.answer.kind(),
            Kind::Numeric | Kind::Integer | Kind::Function
        ) {
            continue;
        }
        if solution
            .marker(*place)
            .is_ok_and(|marker| marker.is_mistaken_key())
        {
            return Err(Unfit::NearMistake {
                part: part.id.clone(),
                tolerances: 0.0,
            });
        }
        // Functions are prepared for this alone, which costs more than a key.
        let clearance = match part.answer.kind() {
            Kind::Function => solution.marker(*place).ok().and_then(|own| own.clearance()),
            _ => None,
        };
        if let Some(tolerances) = clearance.filter(|clearance| *clearance < CLEARANCE) {
            return Err(Unfit::NearMistake {
                part: part.id.clone(),
                tolerances,
            });
        }
        if let Some(tolerances) = half_away(solution, *place).filter(|own| *own < CLEARANCE) {
            return Err(Unfit::NearMethod {
                part: part.id.clone(),
                method: Wrong::Result("halved"),
                tolerances,
            });
        }
        for method in solution.template().methods(*place) {
            let tolerances = distance(solution, *place, method);
            if let Some(tolerances) = tolerances.filter(|distance| *distance < CLEARANCE) {
                return Err(Unfit::NearMethod {
                    part: part.id.clone(),
                    method: method.slip.clone(),
                    tolerances,
                });
            }
        }
    }
    Ok(())
}

/// How far what a wrong method gives lies from the key of a part that asks for numbers or a function, in tolerances; none
/// where the method gives nothing, or the very key.
pub fn distance(solution: &Solution<'_>, place: usize, method: &Method) -> Option<f64> {
    let answer = &solution.template().parts[place].answer;
    let key = *answer.keys().first()?;
    let marker = solution.marker(place).ok()?;
    let evaluation = solution.evaluation();
    let (wrong, right) = match answer.kind() {
        Kind::Numeric => {
            let wrong = evaluation.wrongly(method).ok()?;
            let wrong = wrong.value(key).ok()?.numbers().to_vec();
            (wrong, evaluation.value(key).ok()?.numbers().to_vec())
        }
        Kind::Function => {
            let times = marker.times();
            let right = samples(&evaluation.function(key).ok()?, times)?;
            (course(evaluation, key, method, times, &right)?, right)
        }
        _ => return None,
    };
    let size = largest(&right);
    let mut pairs = wrong.iter().zip(&right);
    let is_same = pairs.all(|(a, b)| (a - b).abs() <= SAME * size);
    let is_finite = wrong.iter().all(|number| number.is_finite());
    let distance = marker.distance(&wrong);
    distance.filter(|_| is_finite && !is_same)
}

/// How far half of the key lies from it, in tolerances: what is lost in a difference of nearly equal terms has a tolerance
/// as wide as itself, and then no factor shows.
fn half_away(solution: &Solution<'_>, place: usize) -> Option<f64> {
    let answer = &solution.template().parts[place].answer;
    let key = *answer.keys().first()?;
    let value = solution.evaluation().value(key).ok()?;
    let halved: Vec<f64> = value.numbers().iter().map(|own| own / 2.0).collect();
    let marker = solution.marker(place).ok()?;
    marker
        .distance(&halved)
        .filter(|_| answer.kind() == Kind::Numeric && largest(&halved) > 0.0)
}

/// The values of a function by a wrong method; `right` are those of the right one.
fn course(
    evaluation: &Evaluation<'_>,
    key: NodeId,
    method: &Method,
    times: &[Precise],
    right: &[f64],
) -> Option<Vec<f64>> {
    if times.is_empty() {
        return None;
    }
    if evaluation.graph().variables(method.step).is_empty() {
        return samples(&evaluation.wrongly(method).ok()?.function(key).ok()?, times);
    }
    // A function that is one of the cases of the key is wrong where it is the one in force.
    let own = samples(&evaluation.function(method.step).ok()?, times)?;
    let is_in_force = method.step == key || own == right;
    let wrong = evaluation
        .function_wrongly(method)
        .filter(|_| is_in_force)?;
    samples(&wrong, times)
}

/// The values of a function of time.
fn samples(function: &Function<'_, '_>, times: &[Precise]) -> Option<Vec<f64>> {
    let values = times
        .iter()
        .map(|time| function.at(&[*time]).ok()?.as_real());
    values.collect()
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, own| most.max(own.abs()))
}

/// Numbers that differ by less than this share are the same but for rounding in the machine.
const SAME: f64 = 1e-9;
