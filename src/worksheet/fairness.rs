//! How alike the variants of a run are: what the teacher sees.

use std::collections::BTreeMap;

use serde::Serialize;

#[cfg(feature = "render")]
use super::candidate::AskedQuestion;
#[cfg(feature = "render")]
use crate::bank::Template;
use crate::bank::{ItemId, Revision};
#[cfg(feature = "render")]
use crate::unit::Unit;

/// How alike the variants of a run are.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Fairness {
    /// How many variants there are.
    pub variants: u64,
    /// By question of the plan.
    pub questions: Vec<QuestionFairness>,
    /// How many pairs of students sit beside each other.
    pub neighbours: u64,
    /// How many of these pairs share the data or an answer of a question.
    pub alike_neighbours: u64,
    /// These pairs, by identity, with the numbers of the questions in the blueprint; the first of them if there are many.
    pub alike: Vec<Alike>,
    /// Who has another variant than the first of their own, since it repeats what another has: these may move when
    /// students come or go.
    pub gave_way: Vec<String>,
}

/// Two students in neighbouring seats who share something.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Alike {
    /// Who they are.
    pub students: [String; 2],
    /// The questions, from 1 in the order of the blueprint.
    pub questions: Vec<usize>,
}

impl Fairness {
    /// Pairs of neighbours that are listed.
    #[cfg(feature = "render")]
    // The page names the first ones; how many there are is counted beside.
    pub(crate) const MAX_LISTED: usize = 500;
}

/// How alike the variants of one question are.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct QuestionFairness {
    /// Variants whose data an earlier variant has, too.
    pub repeats: u64,
    /// Variants that ask other parts than most, or whose answers are of another size.
    pub unusual: u64,
    /// By item; several where one is picked for each variant.
    pub items: BTreeMap<ItemId, ItemFairness>,
}

/// How alike the variants of one item are.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ItemFairness {
    /// The title of the item.
    pub title: String,
    /// The text of the item that was used.
    pub revision: Revision,
    /// Difficulty, from 1 to 3.
    pub level: u8,
    /// Expected working time in minutes.
    pub minutes: u32,
    /// How many variants have it.
    pub variants: u64,
    /// The fewest and the most parts that are asked.
    pub parts: [usize; 2],
    /// The range of each answer that is one number, by part.
    pub answers: BTreeMap<String, Range>,
}

/// The range of the sizes of an answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Range {
    /// The unit in which both ends are given; empty for a bare number.
    pub unit: String,
    /// The smallest.
    pub least: f64,
    /// The largest.
    pub most: f64,
}

impl Fairness {
    /// Whether there is nothing that a teacher should look at.
    pub fn is_fair(&self) -> bool {
        self.alike_neighbours == 0
            && self.questions.iter().all(|question| {
                question.repeats == 0 && question.unusual == 0 && question.is_alike()
            })
    }
}

impl QuestionFairness {
    /// Counts a variant.
    #[cfg(feature = "render")]
    pub(crate) fn add(&mut self, item: &Template, asked: &AskedQuestion, is_new: bool) {
        self.repeats += u64::from(!is_new);
        self.unusual += u64::from(asked.is_unusual);
        let count = asked.parts.len();
        let entry = self.items.entry(item.id.clone());
        let counted = entry.or_insert_with(|| ItemFairness {
            title: item.about.title.clone(),
            revision: item.revision,
            level: item.about.level,
            minutes: item.minutes(),
            variants: 0,
            parts: [count; 2],
            answers: BTreeMap::new(),
        });
        counted.variants += 1;
        counted.parts = [counted.parts[0].min(count), counted.parts[1].max(count)];
        for (part, size) in &asked.parts {
            let part = &item.parts[*part];
            let Some(size) = size else { continue };
            let unit = part.answer.unit().unwrap_or(Unit::ONE);
            let size = unit.of_si(*size);
            let range = counted
                .answers
                .entry(part.id.clone())
                .or_insert_with(|| Range {
                    unit: unit.to_string(),
                    least: size,
                    most: size,
                });
            (range.least, range.most) = (range.least.min(size), range.most.max(size));
        }
    }

    /// Whether its items have one level and ask for as many steps.
    pub fn is_alike(&self) -> bool {
        let mut all = self.items.values().map(|item| (item.level, item.parts));
        let first = all.next();
        first.is_none_or(|(_, parts)| parts[0] == parts[1]) && all.all(|item| Some(item) == first)
    }
}
