//! Choosing the variants of a run: the first seeds whose items are all suitable and not repeated.
//!
//! Looking at a seed is pure and costs most, so [`Chooser::propose`] can be called from many threads;
//! [`Chooser::take`] then decides in the order of the run. What is taken does not depend on how many
//! were proposed at once.

use std::collections::BTreeSet;

use sha2::{Digest, Sha256};

use super::plan::{Plan, Planned};
use super::sheet::{Sheet, SheetQuestion, Student};
use crate::bank::Template;
use crate::instance::{Instance, InstanceError};
use crate::numerics::Rational;
use crate::seed::{Seed, Streams, Variant};
use crate::solution::Solution;
use crate::suitability::{self, Unfit};
use crate::unit::DecimalMark;

/// Chooses the variants of a run.
pub struct Chooser<'p, 'c> {
    plan: &'p Plan<'c>,
    /// By place in the plan.
    questions: Vec<Taken>,
    codes: BTreeSet<Variant>,
    /// Seeds that were tried and not taken.
    rejected: u64,
}

/// What was taken for one question of the plan.
struct Taken {
    /// How many different data there are, constraints aside.
    instances: u64,
    /// Digests of those that were taken.
    data: BTreeSet<u64>,
}

/// A variant that can be taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    index: u64,
    attempt: u64,
    variant: Variant,
    /// Digests of the data, by place in the plan.
    data: Vec<u64>,
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

/// Why a seed is not taken.
#[derive(Debug, thiserror::Error)]
enum Objection {
    #[error("its data repeat an earlier variant")]
    Repeats,
    #[error(transparent)]
    Unfit(#[from] Unfit),
}

/// Seeds tried for one variant before a repetition is accepted, and before giving up.
const TRIES_AGAINST_REPETITION: u64 = 60;
const MOST_TRIES: u64 = 400;

impl<'p, 'c> Chooser<'p, 'c> {
    /// A chooser at the first variant of a plan.
    pub fn new(plan: &'p Plan<'c>) -> Self {
        let taken = |planned: &Planned<'_>| Taken {
            instances: planned.instances(),
            data: BTreeSet::new(),
        };
        Self {
            plan,
            questions: plan.questions.iter().map(taken).collect(),
            codes: BTreeSet::new(),
            rejected: 0,
        }
    }

    /// How many seeds were tried and not taken so far.
    pub fn rejected(&self) -> u64 {
        self.rejected
    }

    /// The first attempt at the variant `index`, not before `from`, that is suitable and repeats nothing that was
    /// taken so far.
    ///
    /// # Errors
    ///
    /// [`SheetError`].
    pub fn propose(&self, index: u64, from: u64) -> Result<(Candidate, Sheet<'c>), SheetError> {
        let mut last = None;
        for attempt in from..MOST_TRIES {
            let variant = self.plan.variant(index, attempt);
            let sheet = Sheet::draw(self.plan, variant, None)?;
            let mut data = vec![0; sheet.questions.len()];
            for question in &sheet.questions {
                data[question.place] = digest(&question.solution);
            }
            let candidate = Candidate {
                index,
                attempt,
                variant,
                data,
            };
            match self.accepts(&candidate).and_then(|()| judge(&sheet)) {
                Ok(()) => return Ok((candidate, sheet)),
                Err(objection) => last = Some(objection),
            }
        }
        Err(SheetError::NoVariant {
            attempts: MOST_TRIES,
            reason: last.map_or_else(String::new, |objection| objection.to_string()),
        })
    }

    /// Takes a candidate, unless it repeats what was taken since it was proposed; then another has to be proposed,
    /// from its [next attempt](Candidate::next_attempt).
    pub fn take(&mut self, candidate: &Candidate) -> bool {
        if self.accepts(candidate).is_err() {
            return false;
        }
        for (question, data) in self.questions.iter_mut().zip(&candidate.data) {
            question.data.insert(*data);
        }
        self.codes.insert(candidate.variant);
        self.rejected += candidate.attempt;
        true
    }

    fn accepts(&self, candidate: &Candidate) -> Result<(), Objection> {
        let mut pairs = self.questions.iter().zip(&candidate.data);
        let repeats = pairs.any(|(question, data)| question.repeats(*data));
        if self.codes.contains(&candidate.variant)
            || (repeats && candidate.attempt < TRIES_AGAINST_REPETITION)
        {
            return Err(Objection::Repeats);
        }
        Ok(())
    }
}

impl Taken {
    /// Whether data were taken before, while there are others.
    fn repeats(&self, data: u64) -> bool {
        self.data.contains(&data) && (self.data.len() as u64) < self.instances
    }
}

impl Candidate {
    /// Its place in the run, from 0.
    pub fn index(&self) -> u64 {
        self.index
    }

    /// Its seed.
    pub fn variant(&self) -> Variant {
        self.variant
    }

    /// The attempt after this one.
    pub fn next_attempt(&self) -> u64 {
        self.attempt + 1
    }
}

/// Whether all questions of a sheet are fit to hand out.
fn judge(sheet: &Sheet<'_>) -> Result<(), Objection> {
    for question in &sheet.questions {
        suitability::judge(&question.solution, &question.parts)?;
    }
    Ok(())
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
                place,
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
fn question<'c>(
    number: usize,
    place: usize,
    planned: &Planned<'c>,
    solution: Solution<'c>,
) -> SheetQuestion<'c> {
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
        place,
        solution,
        parts,
        points,
    }
}
