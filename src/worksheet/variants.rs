//! Choosing the variants of a run: the first seeds whose items are all suitable and not repeated.

use std::collections::BTreeSet;

use sha2::{Digest, Sha256};

use super::plan::{Plan, Planned};
use super::sheet::{Sheet, SheetQuestion, Student};
use crate::bank::Template;
use crate::instance::{Instance, InstanceError};
use crate::numerics::Rational;
use crate::seed::{Seed, Streams, Variant};
use crate::solution::Solution;
use crate::suitability;
use crate::unit::DecimalMark;

/// Chooses one variant after the other.
pub struct Chooser<'p, 'c> {
    plan: &'p Plan<'c>,
    next: u64,
    /// Digests of the data of earlier variants, question by question.
    seen: Vec<BTreeSet<u64>>,
    codes: BTreeSet<Variant>,
    /// Seeds that were tried and not taken.
    rejected: u64,
}

/// A variant that was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chosen {
    /// Its place in the run, from 0.
    pub index: u64,
    /// Its seed.
    pub variant: Variant,
}

/// Why a run cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SheetError {
    /// An item has no data that meet its constraints.
    #[error(transparent)]
    Instance(#[from] InstanceError),
    /// No suitable variant was found.
    #[error("no suitable variant was found in {attempts} tries; the last: {reason}")]
    NoVariant {
        /// How many seeds were tried.
        attempts: u64,
        /// Why the last one is not suitable.
        reason: String,
    },
}

/// Seeds tried for one variant before a repetition is accepted, and before giving up.
const TRIES_AGAINST_REPETITION: u64 = 60;
const MOST_TRIES: u64 = 400;

impl<'p, 'c> Chooser<'p, 'c> {
    /// A chooser at the first variant of a plan.
    pub fn new(plan: &'p Plan<'c>) -> Self {
        let seen = plan.questions.iter().map(|_| BTreeSet::new()).collect();
        Self {
            plan,
            next: 0,
            seen,
            codes: BTreeSet::new(),
            rejected: 0,
        }
    }

    /// How many seeds were tried and not taken so far.
    pub fn rejected(&self) -> u64 {
        self.rejected
    }

    /// The next variant.
    ///
    /// # Errors
    ///
    /// [`SheetError`].
    pub fn choose(&mut self) -> Result<Chosen, SheetError> {
        let index = self.next;
        let mut last = String::new();
        for attempt in 0..MOST_TRIES {
            let variant = self.plan.variant(index, attempt);
            let sheet = Sheet::draw(self.plan, variant, None)?;
            let digests: Vec<u64> = sheet
                .questions
                .iter()
                .map(|question| digest(&question.solution))
                .collect();
            let repeats = digests
                .iter()
                .zip(&self.seen)
                .any(|(digest, seen)| seen.contains(digest));
            let is_fresh =
                !self.codes.contains(&variant) && (!repeats || attempt >= TRIES_AGAINST_REPETITION);
            let unfit = sheet
                .questions
                .iter()
                .find_map(|question| suitability::judge(&question.solution, &question.parts).err());
            match unfit {
                None if is_fresh => {
                    self.next += 1;
                    self.codes.insert(variant);
                    self.seen
                        .iter_mut()
                        .zip(digests)
                        .for_each(|(seen, digest)| {
                            seen.insert(digest);
                        });
                    return Ok(Chosen { index, variant });
                }
                None => "its data repeat an earlier variant".clone_into(&mut last),
                Some(unfit) => last = unfit.to_string(),
            }
            self.rejected += 1;
        }
        Err(SheetError::NoVariant {
            attempts: MOST_TRIES,
            reason: last,
        })
    }
}

/// A digest of the item and data of a question.
fn digest(solution: &Solution<'_>) -> u64 {
    let mut hash = Sha256::new();
    hash.update(solution.template().id.as_str());
    for value in solution.instance().values() {
        hash.update(format!(";{value}"));
    }
    let bytes = hash.finalize();
    u64::from_be_bytes([
        bytes[0], bytes[1], bytes[2], bytes[3], bytes[4], bytes[5], bytes[6], bytes[7],
    ])
}

impl<'c> Sheet<'c> {
    /// The sheet of a variant: a pure function of plan and variant.
    ///
    /// # Errors
    ///
    /// [`SheetError::Instance`].
    pub fn draw(
        plan: &Plan<'c>,
        variant: Variant,
        student: Option<Student>,
    ) -> Result<Self, SheetError> {
        let mark = if plan.blueprint.decimal == ',' {
            DecimalMark::Comma
        } else {
            DecimalMark::Point
        };
        let order = order(plan, variant);
        let mut taken: Vec<&Template> = Vec::new();
        let mut questions = Vec::new();
        for place in order {
            let planned = &plan.questions[place];
            let template = pick(planned, place, variant, &taken);
            taken.push(template);
            let seed = variant.item(template.id.as_str(), plan.secret.as_ref());
            let set: Vec<(&str, &str)> = planned
                .set
                .iter()
                .map(|(name, value)| (name.as_str(), value.as_str()))
                .collect();
            let instance = Instance::of(template, Some(seed), &set)?;
            let number = questions.len() + 1;
            questions.push(question(
                number,
                planned,
                Solution::with_mark(instance, mark),
            ));
        }
        Ok(Self {
            variant,
            student,
            questions,
        })
    }
}

/// The order of the questions, as places in the plan.
fn order(plan: &Plan<'_>, variant: Variant) -> Vec<usize> {
    let count = plan.questions.len();
    if plan.blueprint.shuffle {
        return Streams::of(Seed::new(variant.number()), "order")
            .named("questions")
            .permutation(count);
    }
    (0..count).collect()
}

/// The item of a question; of several candidates one that the sheet does not have yet.
fn pick<'c>(
    planned: &Planned<'c>,
    place: usize,
    variant: Variant,
    taken: &[&Template],
) -> &'c Template {
    if let [one] = planned.candidates[..] {
        return one;
    }
    let streams = Streams::of(Seed::new(variant.number()), "order");
    let order = streams
        .named(&format!("pick {place}"))
        .permutation(planned.candidates.len());
    let is_free = |at: &&usize| {
        taken
            .iter()
            .all(|item| item.id != planned.candidates[**at].id)
    };
    planned.candidates[*order.iter().find(is_free).unwrap_or(&order[0])]
}

/// A question with its parts and their points.
fn question<'c>(number: usize, planned: &Planned<'c>, solution: Solution<'c>) -> SheetQuestion<'c> {
    let all = &solution.template().parts;
    let is_asked = |place: &usize| {
        let wanted = planned.parts.is_empty() || planned.parts.contains(&all[*place].id);
        wanted && solution.asks(*place)
    };
    let parts: Vec<usize> = (0..all.len()).filter(is_asked).collect();
    let weight = |place: &usize| all[*place].points;
    let total = parts
        .iter()
        .map(weight)
        .try_fold(Rational::ZERO, Rational::checked_add)
        .unwrap_or(Rational::ONE);
    let share = |place: &usize| {
        let points = planned
            .points
            .and_then(|points| points.checked_mul(weight(place))?.checked_div(total));
        points.unwrap_or(weight(place))
    };
    let points = parts.iter().map(share).collect();
    SheetQuestion {
        number,
        solution,
        parts,
        points,
    }
}
