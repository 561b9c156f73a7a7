//! Whether an instance is fit to hand out.
//!
//! A *draw* knows the constraints of its item only. *Choosing* takes the first seed whose items are
//! all suitable: each key exists, and no named mistake and no standard wrong method that differs from the key lies
//! within two half-widths of it. Honest work by a wrong method is itself off by up to one half-width; what lies two
//! of them away stays outside.

use std::cell::RefCell;

use crate::answer::{AnswerKind, Marker};
use crate::expr::Precise;
use crate::numerics::SortedMap;
use crate::quantity::{Evaluation, Function, Method, NodeId, Wrong};
use crate::solution::Solution;

/// Why an instance is not fit to hand out.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unfit {
    /// A part that is asked has no answer.
    #[error("part `{part}` has no answer: {reason}")]
    NoKey {
        /// The identifier of the part.
        part: String,
        /// Why the key does not exist.
        reason: String,
    },
    /// A key that is not known as closely as answers are marked.
    #[error(
        "the key of part `{part}` is lost in rounding for these data: its formula takes the difference of numbers that agree to all digits"
    )]
    UncertainKey {
        /// The identifier of the part.
        part: String,
    },
    /// A mistake that cannot be distinguished from the key.
    #[error("a mistake of part `{part}` lies {tolerances:.1} tolerances from its key")]
    NearMistake {
        /// The identifier of the part.
        part: String,
        /// The distance in tolerances.
        tolerances: f64,
    },
    /// A wrong method that cannot be distinguished from the right one.
    #[error("part `{part}`: {method} lies {tolerances:.1} tolerances from the key")]
    NearMethod {
        /// The identifier of the part.
        part: String,
        /// What is done wrongly.
        method: Wrong,
        /// The distance in tolerances.
        tolerances: f64,
    },
}

/// Mistakes and wrong methods keep this distance from the key, in tolerances.
pub(crate) const CLEARANCE: f64 = 2.0;

/// Whether the parts that are asked have keys from which their named mistakes can be distinguished.
///
/// # Errors
///
/// The first reason why they are not fit to hand out.
pub fn judge(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    let with_keys = parts.iter().filter(|place| {
        let part = &solution.template().parts[**place];
        solution.asks(**place) && !part.answer.kind().is_by_hand()
    });
    for place in with_keys {
        let part = || solution.template().parts[*place].id.clone();
        let clearance = solution.clearance(*place);
        let clearance = clearance.map_err(|absent| Unfit::NoKey {
            part: part(),
            reason: absent.to_string(),
        })?;
        let is_numeric = solution.template().parts[*place].answer.kind() == AnswerKind::Numeric;
        if is_numeric && solution.marker(*place).is_ok_and(|own| own.is_uncertain()) {
            return Err(Unfit::UncertainKey { part: part() });
        }
        if let Some(tolerances) = clearance.filter(|clearance| *clearance < CLEARANCE) {
            return Err(Unfit::NearMistake {
                part: part(),
                tolerances,
            });
        }
    }
    Ok(())
}

/// Whether the parts that are asked have keys from which the standard wrong methods can be distinguished, and which no named
/// mistake happens to give.
///
/// # Errors
///
/// The first method that cannot.
pub fn judge_methods(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    // Functions take the longest, and are not looked at where a number decides.
    judge_methods_of_numbers(solution, parts)?;
    judge_methods_of_functions(solution, parts)
}

/// [`judge_methods`] for the parts that ask for numbers.
///
/// # Errors
///
/// As there.
pub fn judge_methods_of_numbers(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    let is_number = |kind| matches!(kind, AnswerKind::Numeric | AnswerKind::Integer);
    judge_methods_of(solution, parts, is_number)
}

/// [`judge_methods`] for the parts that ask for functions.
///
/// # Errors
///
/// As there.
pub fn judge_methods_of_functions(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    judge_methods_of(solution, parts, |kind| kind == AnswerKind::Function)
}

fn judge_methods_of(
    solution: &Solution<'_>,
    parts: &[usize],
    is_meant: impl Fn(AnswerKind) -> bool,
) -> Result<(), Unfit> {
    let meant = parts.iter().filter(|place| {
        solution.asks(**place) && is_meant(solution.template().parts[**place].answer.kind())
    });
    for place in meant {
        let part = &solution.template().parts[*place];
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
        let nearest = match part.answer.kind() {
            AnswerKind::Function => {
                let marker = solution.marker(*place).ok();
                marker.and_then(|own| own.clearance(CLEARANCE))
            }
            _ => None,
        };
        if let Some(tolerances) = nearest {
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
        let beside = Beside::of(solution, *place);
        for method in solution.template().methods(*place) {
            let tolerances = beside.as_ref().and_then(|beside| beside.near(method));
            if let Some(tolerances) = tolerances {
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
    let beside = Beside::of(solution, place)?;
    if beside.marker.looks_later() {
        return None;
    }
    beside.distance(method)
}

/// The key of a part, with which what wrong methods give is compared.
struct Beside<'s> {
    evaluation: &'s Evaluation<'s>,
    marker: &'s dyn Marker,
    key: NodeId,
    /// The times at which it is compared, if it is a function.
    times: Option<&'s [Precise]>,
    /// Its numbers, or its values at these times.
    right: &'s [f64],
    /// Which functions are the key for these data.
    in_force: RefCell<SortedMap<NodeId, bool>>,
}

impl<'s> Beside<'s> {
    /// None where the part asks for something else, or has no key.
    fn of(solution: &'s Solution<'_>, place: usize) -> Option<Self> {
        let answer = &solution.template().parts[place].answer;
        let key = *answer.keys().first()?;
        let marker = solution.marker(place).ok()?;
        let evaluation = solution.evaluation();
        let (times, right) = match answer.kind() {
            AnswerKind::Numeric => (None, evaluation.value(key).ok()?.numbers()),
            AnswerKind::Function => {
                let (times, values) = marker.samples();
                (Some(times).filter(|times| !times.is_empty()), values)
            }
            _ => return None,
        };
        if right.is_empty() {
            return None;
        }
        Some(Self {
            evaluation,
            marker,
            key,
            times,
            right,
            in_force: RefCell::default(),
        })
    }

    /// How far what a method gives lies from the key; none where it gives nothing, or the very key.
    fn distance(&self, method: &Method) -> Option<f64> {
        let wrong = match self.times {
            None => self.numbers(&method.evaluation(self.evaluation).ok()?)?,
            Some(times) => self.course(method, |wrong| samples(wrong, times, self.fine()))?,
        };
        let size = largest(self.right);
        let mut pairs = wrong.iter().zip(self.right);
        let is_same = pairs.all(|(a, b)| (a - b).abs() <= SAME * size);
        let is_finite = wrong.iter().all(|number| number.is_finite());
        let distance = self.marker.distance(&wrong);
        distance.filter(|_| is_finite && !is_same)
    }

    /// The numbers that the key is among these values.
    fn numbers(&self, wrong: &Evaluation<'_>) -> Option<Vec<f64>> {
        if self.right.len() > 1 {
            return Some(wrong.value(self.key).ok()?.numbers().to_vec());
        }
        // A step that is taken wrongly may leave next to nothing, which takes many digits to tell from zero.
        Some(vec![wrong.real_within(self.fine(), self.key).ok()?])
    }

    /// The distance of what a method gives, where it is too near.
    fn near(&self, method: &Method) -> Option<f64> {
        if self.is_seen_apart(method) {
            return None;
        }
        let near = self.distance(method).filter(|own| *own < CLEARANCE);
        // Asked last: it costs as much as all methods.
        near.filter(|_| !self.marker.looks_later())
    }

    /// Whether one time already shows that a function by a wrong method is far from the key, since the farthest decides.
    fn is_seen_apart(&self, method: &Method) -> bool {
        let Some(times) = self.times else {
            return false;
        };
        let apart = self.course(method, |wrong| {
            // Late, where a wrong frequency or a wrong decay shows; early, where a wrong start does; and between.
            let last = times.len() - 1;
            let is_apart = [last, last / 2, last / 5, 0].into_iter().any(|place| {
                let Some(value) = value(wrong, times[place], self.fine()) else {
                    return false;
                };
                let mut values = self.right.to_vec();
                values[place] = value;
                let distance = self.marker.distance(&values);
                distance.is_some_and(|distance| distance >= CLEARANCE)
            });
            Some(is_apart)
        });
        apart.unwrap_or(false)
    }

    /// What becomes of the function by a wrong method.
    fn course<T>(
        &self,
        method: &Method,
        look: impl Fn(&Function<'_, '_>) -> Option<T>,
    ) -> Option<T> {
        let evaluation = self.evaluation;
        if evaluation.graph().variables(method.step).is_empty() {
            return look(
                &method
                    .evaluation(evaluation)
                    .ok()?
                    .function(self.key)
                    .ok()?,
            );
        }
        // A function that is one of the cases of the key is wrong where it is the one in force.
        if !self.is_in_force(method.step) {
            return None;
        }
        look(&method.function(evaluation)?)
    }

    /// The accuracy of what is compared with the key: far below [`SAME`].
    fn fine(&self) -> f64 {
        1e-12 * largest(self.right)
    }

    fn is_in_force(&self, step: NodeId) -> bool {
        let is_in_force = || {
            let (own, times) = (self.evaluation.function(step).ok()?, self.times?);
            // Another function mostly differs at the end already.
            let last = value(&own, *times.last()?, 0.0)?;
            Some(last == *self.right.last()? && samples(&own, times, 0.0)? == self.right)
        };
        let mut known = self.in_force.borrow_mut();
        let holds = || step == self.key || is_in_force() == Some(true);
        *known.get_or_insert_with(step, holds)
    }
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
        .filter(|_| answer.kind() == AnswerKind::Numeric && largest(&halved) > 0.0)
}

/// The values of a function of time, with an absolute error of at most `accuracy`.
fn samples(function: &Function<'_, '_>, times: &[Precise], accuracy: f64) -> Option<Vec<f64>> {
    function.reals_at(times.chunks(1), accuracy).ok()
}

fn value(function: &Function<'_, '_>, time: Precise, accuracy: f64) -> Option<f64> {
    function.real_at(&[time], accuracy).ok()
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, own| most.max(own.abs()))
}

/// Numbers that differ by less than this share are the same but for rounding in the machine.
const SAME: f64 = 1e-9;
