//! A variant that can be taken: what has to be known of it, as digests that are compared with those of others.

use std::collections::{BTreeMap, BTreeSet};

use sha2::{Digest, Sha256};

use super::manifest::QuestionEntry;
use super::sheet::{Sheet, SheetQuestion};
use crate::seed::Variant;
use crate::solution::Solution;

/// A sheet that a student has already.
#[derive(Clone, Debug, PartialEq)]
pub struct Fixed {
    pub(crate) variant: Variant,
    /// Digests of its questions, which are not judged again.
    pub(crate) questions: BTreeSet<u64>,
    /// Whether the student has another seat now, and so other neighbours.
    pub(crate) has_moved: bool,
    /// Whether it is not the first variant, since that repeats what another student has.
    pub(crate) gave_way: bool,
}

impl Fixed {
    /// The sheet of this variant with these questions; it is looked at again if the student has another seat now.
    pub fn new(variant: Variant, questions: &[QuestionEntry], has_moved: bool) -> Self {
        Self {
            variant,
            questions: questions.iter().map(entry_mark).collect(),
            has_moved,
            gave_way: false,
        }
    }

    /// The same, where the first variant may repeat what another student has.
    #[must_use]
    pub fn giving_way(self, gave_way: bool) -> Self {
        Self { gave_way, ..self }
    }
}

/// A variant that can be taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    pub(crate) index: u64,
    pub(crate) attempt: u64,
    /// How many attempts were looked at for fairness before it.
    pub(crate) tries: u64,
    pub(crate) variant: Variant,
    /// Whether it was there before, so that nothing speaks against it.
    pub(crate) is_fixed: bool,
    /// Whether an earlier attempt repeated what another has.
    pub(crate) gave_way: bool,
    /// The items whose data were not suitable in earlier attempts.
    pub(crate) unsuitable: Vec<String>,
    /// By place in the plan.
    pub(crate) questions: Vec<AskedQuestion>,
}

/// What has to be known of a question of a candidate.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct AskedQuestion {
    /// Which of the items that can be picked.
    pub(crate) item: usize,
    /// Digest of its data.
    pub(crate) data: u64,
    /// The parts that are asked, with the sizes of their answers.
    pub(crate) parts: Vec<(usize, Option<f64>)>,
    pub(crate) is_unusual: bool,
    /// Digests of what neighbours must not share: the data, and the answers that differ between instances.
    pub(crate) marks: Vec<u64>,
}

impl Candidate {
    /// A candidate of which nothing is known but its data.
    pub(crate) fn of(index: u64, attempt: u64, sheet: &Sheet<'_>) -> Self {
        let mut candidate = Self {
            index,
            attempt,
            tries: attempt,
            variant: sheet.variant,
            is_fixed: false,
            gave_way: false,
            unsuitable: Vec::new(),
            questions: vec![AskedQuestion::default(); sheet.questions.len()],
        };
        for question in &sheet.questions {
            candidate.questions[question.place].data = digest(&question.solution);
        }
        candidate
    }

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

    /// The questions, from 1, in which it shares something with what another has.
    ///
    /// The same item may be asked by different questions, so each is compared with all.
    pub(crate) fn shared(&self, marks: &[BTreeSet<u64>]) -> Vec<usize> {
        let questions = (1..).zip(&self.questions);
        questions
            .filter(|(_, asked)| {
                let mut own = asked.marks.iter();
                own.any(|mark| marks.iter().any(|other| other.contains(mark)))
            })
            .map(|(number, _)| number)
            .collect()
    }
}

/// A digest of a question that was handed out: its item and its data.
fn entry_mark(entry: &QuestionEntry) -> u64 {
    let values = entry.values.iter();
    let values = values.map(|(name, value)| (name.clone(), value.clone()));
    item_mark(
        &format!("{} @ {}", entry.item, entry.revision),
        values.collect(),
    )
}

/// The same of a question of a sheet.
pub(crate) fn question_mark(question: &SheetQuestion<'_>) -> u64 {
    let instance = question.solution.instance();
    let values = instance.template().parameters.iter().zip(instance.values());
    let values = values.map(|(parameter, value)| (parameter.name.to_string(), value.to_string()));
    item_mark(&instance.origin(), values.collect())
}

fn item_mark(origin: &str, values: BTreeMap<String, String>) -> u64 {
    let mut hash = Sha256::new();
    hash.update(origin);
    for (name, value) in values {
        hash.update(format!(";{name}={value}"));
    }
    first_word(hash)
}

/// A digest of something that neighbours must not share.
pub(crate) fn mark(place: &[u64], text: &str) -> u64 {
    let mut hash = Sha256::new();
    for number in place {
        hash.update(number.to_be_bytes());
    }
    hash.update(text);
    first_word(hash)
}

// Sixty-four bits: among a million digests two are alike by chance with a probability of 3e-8.
fn first_word(hash: Sha256) -> u64 {
    let bytes = hash.finalize();
    u64::from_be_bytes([
        bytes[0], bytes[1], bytes[2], bytes[3], bytes[4], bytes[5], bytes[6], bytes[7],
    ])
}

/// A digest of the item and data of a question.
fn digest(solution: &Solution<'_>) -> u64 {
    let mut hash = Sha256::new();
    hash.update(solution.template().id.as_str());
    for value in solution.instance().values() {
        hash.update(format!(";{value}"));
    }
    first_word(hash)
}
