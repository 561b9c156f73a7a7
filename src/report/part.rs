//! How one part of an item fared on all sheets that asked it.

use std::collections::BTreeSet;

use serde::Serialize;

use super::Observation;
use super::common::{Common, CommonMistake, Counts};
use super::statistics::{Moments, Pairs};
use crate::answer::Verdict;
use crate::bank::Template;

/// What is gathered of a part.
#[derive(Clone, Debug, Default)]
pub(crate) struct PartTally {
    places: BTreeSet<(usize, String)>,
    verdicts: [u64; 5],
    follow_through: u64,
    /// Share of the points, of responses that are settled.
    shares: Moments,
    /// The same against the rest of the sheet.
    against_rest: Pairs,
    asked: u64,
    /// Points, on sheets on which all is decided.
    points: Moments,
    mistakes: Counts,
    others: Counts,
}

/// How a part fared.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartSummary {
    /// The identity of the item, `chapter/name`.
    pub item: String,
    /// The title of the item.
    pub title: String,
    /// The part of the item.
    pub part: String,
    /// Where it stands on the sheets: `1a`, or several places.
    pub places: Vec<String>,
    /// How many sheets ask it.
    pub asked: u64,
    /// How many got all points.
    pub right: u64,
    /// How many got some.
    pub partial: u64,
    /// How many got none.
    pub wrong: u64,
    /// How many could not be read.
    pub unreadable: u64,
    /// How many left it out.
    pub missing: u64,
    /// How many were counted as follow-through.
    pub follow_through: u64,
    /// Mean share of the points; what could not be read is left out.
    pub facility: Option<f64>,
    /// Correlation of the share of the points with that of the rest of the sheet.
    pub discrimination: Option<f64>,
    /// The commonest named mistakes.
    pub mistakes: Vec<CommonMistake>,
    /// The commonest other wrong answers: numbers by their ratio to the key, others as they were read.
    pub others: Vec<Common>,
}

/// How many of the commonest are reported.
const TOLD: usize = 5;

impl PartTally {
    /// Adds a marked response; `rest` is the share of points of the other decided parts of the sheet, if there are any,
    /// and `is_settled` says whether all parts of it are decided.
    pub(crate) fn add(&mut self, seen: &Observation<'_>, rest: Option<f64>, is_settled: bool) {
        self.places.insert((seen.question, seen.letter.to_owned()));
        self.verdicts[seen.verdict as usize] += 1;
        self.asked += 1;
        if is_settled {
            self.points.add(seen.points);
        }
        if seen.verdict != Verdict::Unreadable && seen.max > 0.0 {
            let share = seen.points / seen.max;
            self.shares.add(share);
            if let Some(rest) = rest {
                self.against_rest.add(share, rest);
            }
        }
        if seen.reasons.contains(&"follow-through") {
            self.follow_through += 1;
            return;
        }
        match seen.reasons.first() {
            Some(&("other" | "override")) => {
                let other = seen.other.filter(|_| seen.verdict == Verdict::Wrong);
                other.into_iter().for_each(|other| self.others.add(other));
            }
            // What was decided says nothing of what was answered.
            Some(&("matches" | "unreadable" | "open" | "missing" | "accepted" | "void")) | None => {
            }
            Some(mistake) => self.mistakes.add(mistake),
        }
    }

    pub(crate) fn variance(&self) -> Option<f64> {
        self.points.variance()
    }

    /// How many sheets that ask it are decided.
    pub(crate) fn settled(&self) -> u64 {
        self.points.count()
    }

    pub(crate) fn summary(
        &self,
        item: &str,
        part: &str,
        template: Option<&Template>,
    ) -> PartSummary {
        let found = template.and_then(|template| template.part(part));
        let mistakes = self.mistakes.commonest(1, TOLD).into_iter();
        let mut places: Vec<&(usize, String)> = self.places.iter().collect();
        places.sort_by_key(|(question, letter)| (*question, super::order(letter)));
        let of = |verdict: Verdict| self.verdicts[verdict as usize];
        PartSummary {
            item: item.to_owned(),
            title: template.map_or_else(String::new, |template| template.about.title.clone()),
            part: part.to_owned(),
            places: places
                .into_iter()
                .map(|(question, letter)| format!("{question}{letter}"))
                .collect(),
            asked: self.asked,
            right: of(Verdict::Right),
            partial: of(Verdict::Partial),
            wrong: of(Verdict::Wrong),
            unreadable: of(Verdict::Unreadable),
            missing: of(Verdict::Missing),
            follow_through: self.follow_through,
            facility: self.shares.mean(),
            discrimination: self.against_rest.correlation(),
            mistakes: mistakes
                .map(|common| CommonMistake::of(common, found))
                .collect(),
            // What one student alone wrote is no pattern.
            others: self.others.commonest(2, TOLD),
        }
    }

    /// Where it first stands on a sheet, for the order of the report.
    pub(crate) fn first_place(&self) -> Option<(usize, super::LetterOrder<'_>)> {
        let places = self.places.iter();
        let places = places.map(|(question, letter)| (*question, super::order(letter)));
        places.min()
    }
}
