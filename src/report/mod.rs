//! Item analysis over many grades: how hard the parts were, how well they tell students apart, how reliable
//! the sum is, and which mistakes were common.
//!
//! A [`Report`] takes one sheet after the other and keeps sums, so that its memory does not grow with the number
//! of responses but for one number a sheet; [`Report::summary`] says what came out.
//!
//! *Facility* is the mean share of the points. *Discrimination* is the correlation of a part's share with that of
//! the rest of the sheet (the part itself left out, or it would agree with itself). *Reliability* is Cronbach's
//! alpha, which needs the same parts on every sheet.

mod common;
mod marks;
mod part;
mod statistics;

use std::collections::BTreeMap;

use serde::Serialize;

pub use common::{Common, CommonMistake};
pub use marks::{GradeCount, GroupSummary, MarksSummary, Standing, Standings};
pub use part::PartSummary;

use self::part::PartTally;
use self::statistics::{Moments, alpha, quantile};
use crate::answer::Verdict;
use crate::bank::Template;

/// Where the letter of a part stands on a sheet: how long its letters are, these, and the same of its number.
pub type LetterOrder<'a> = (usize, &'a str, usize, &'a str);

/// By what the letters of parts are sorted as on a sheet: `b`, `c1`, `c2`, `c10`, `d`, `aa`.
pub fn order(letter: &str) -> LetterOrder<'_> {
    let end = letter
        .find(|sign: char| sign.is_ascii_digit())
        .unwrap_or(letter.len());
    let (own, blank) = letter.split_at(end);
    (own.len(), own, blank.len(), blank)
}

/// A marked response, as far as statistics need it.
#[derive(Clone, Copy, Debug)]
pub struct Observation<'a> {
    /// The identity of the item, `chapter/name`.
    pub item: &'a str,
    /// The part of the item.
    pub part: &'a str,
    /// Number of the question.
    pub question: usize,
    /// Letter of the part.
    pub letter: &'a str,
    /// Points reached.
    pub points: f64,
    /// Points of the part.
    pub max: f64,
    /// How it fared.
    pub verdict: Verdict,
    /// Codes of the reasons, the main one first.
    pub reasons: &'a [&'a str],
    /// What was answered, in a form that does not depend on the data, if it is wrong in another way.
    pub other: Option<&'a str>,
}

/// Statistics over sheets.
#[derive(Clone, Debug, Default)]
pub struct Report {
    parts: BTreeMap<(String, String), PartTally>,
    /// Share of the points of each sheet.
    shares: Vec<f64>,
    sheets: usize,
    /// Of sheets on which all is decided.
    points: Moments,
    max: Moments,
}

/// What came out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// The number of sheets that were marked.
    pub sheets: usize,
    /// How many of them have parts that nobody has decided yet.
    pub undecided: usize,
    /// Points of a sheet, if all have the same.
    pub max: Option<f64>,
    /// The shares of the points that were reached.
    pub shares: Option<Distribution>,
    /// Cronbach's alpha; `null` unless all sheets ask the same parts and marks differ.
    pub reliability: Option<f64>,
    /// Standard error of measurement in points, from the reliability.
    pub measurement_error: Option<f64>,
    /// The parts, in the order of the sheets.
    pub parts: Vec<PartSummary>,
}

/// How shares of points are distributed, each from 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Distribution {
    /// The mean of the points of all sheets.
    pub mean: f64,
    /// Standard deviation; `null` for one sheet.
    pub deviation: Option<f64>,
    /// The fewest points that a sheet has.
    pub lowest: f64,
    /// A quarter of the sheets lie below.
    pub lower_quartile: f64,
    /// Half of the sheets lie below.
    pub median: f64,
    /// Three quarters of the sheets lie below.
    pub upper_quartile: f64,
    /// The most points that a sheet has.
    pub highest: f64,
    /// Sheets in each tenth; the last one includes full marks.
    pub tenths: [u64; 10],
}

impl Report {
    /// Statistics over these sheets, each a list of its marked responses.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::answer::Verdict;
    /// use vibank::report::{Observation, Report};
    ///
    /// let part = |part, points| Observation {
    ///     item: "ch1/e1", part, question: 1, letter: part, points, max: 1.0,
    ///     verdict: if points > 0.0 { Verdict::Right } else { Verdict::Wrong },
    ///     reasons: &[], other: None,
    /// };
    /// let sheets = [
    ///     vec![part("a", 1.0), part("b", 1.0)],
    ///     vec![part("a", 1.0), part("b", 0.0)],
    ///     vec![part("a", 0.0), part("b", 0.0)],
    /// ];
    /// let summary = Report::over(sheets.iter().map(Vec::as_slice)).summary(|_| None);
    /// let near = |a: Option<f64>, b: f64| (a.unwrap() - b).abs() < 1e-12;
    /// assert!(near(summary.parts[0].facility, 2.0 / 3.0));
    /// assert!(near(summary.parts[0].discrimination, 0.5));
    /// assert_eq!(summary.shares.unwrap().median, 0.5);
    /// ```
    pub fn over<'a>(sheets: impl IntoIterator<Item = &'a [Observation<'a>]>) -> Self {
        let mut report = Self::default();
        sheets.into_iter().for_each(|sheet| report.add(sheet));
        report
    }

    /// Adds a sheet. Parts that nobody has decided yet are left out of all that is computed: of the share of the
    /// points of the sheet, and of the rest of the sheet for other parts; the reliability is that of the sheets on
    /// which all is decided.
    pub fn add(&mut self, sheet: &[Observation<'_>]) {
        let is_decided = |seen: &&Observation<'_>| seen.verdict != Verdict::Unreadable;
        let decided = || sheet.iter().filter(is_decided);
        let points: f64 = decided().map(|seen| seen.points).sum();
        let max: f64 = decided().map(|seen| seen.max).sum();
        let is_settled = decided().count() == sheet.len();
        for seen in sheet {
            let (own_points, own_max) = if is_decided(&seen) {
                (seen.points, seen.max)
            } else {
                (0.0, 0.0)
            };
            let rest = max - own_max;
            let rest = (rest > 0.0).then(|| (points - own_points) / rest);
            let key = (seen.item.to_owned(), seen.part.to_owned());
            let part = self.parts.entry(key).or_default();
            part.add(seen, rest, is_settled);
        }
        self.sheets += 1;
        if is_settled {
            self.points.add(points);
        }
        self.max.add(sheet.iter().map(|seen| seen.max).sum());
        if max > 0.0 {
            self.shares.push(points / max);
        }
    }

    /// What came out; titles and texts of mistakes are those of the items that `template` finds by identity.
    pub fn summary<'t>(&self, template: impl Fn(&str) -> Option<&'t Template>) -> Summary {
        let mut parts: Vec<(&(String, String), &PartTally)> = self.parts.iter().collect();
        parts.sort_by_cached_key(|(_, tally)| tally.first_place());
        let reliability = self.reliability();
        let has_one_max = self.max.variance().is_none_or(|variance| variance < 1e-18);
        Summary {
            sheets: self.sheets,
            undecided: self.sheets - self.points.count() as usize,
            max: self.max.mean().filter(|_| has_one_max),
            shares: self.distribution(),
            reliability,
            measurement_error: reliability
                .and_then(|alpha| Some(self.points.deviation()? * (1.0 - alpha).max(0.0).sqrt())),
            parts: parts
                .into_iter()
                .map(|((item, part), tally)| tally.summary(item, part, template(item)))
                .collect(),
        }
    }

    fn reliability(&self) -> Option<f64> {
        let is_complete = self
            .parts
            .values()
            .all(|part| part.settled() == self.points.count());
        let variances: Option<Vec<f64>> = self.parts.values().map(PartTally::variance).collect();
        alpha(&variances.filter(|_| is_complete)?, self.points.variance()?)
    }

    fn distribution(&self) -> Option<Distribution> {
        let mut sorted = self.shares.clone();
        sorted.sort_by(f64::total_cmp);
        let mut moments = Moments::default();
        let mut tenths = [0; 10];
        for share in &sorted {
            moments.add(*share);
            // 0.3 of the points lies in the fourth tenth, however it was rounded.
            tenths[((share * 10.0 + 1e-9) as usize).min(9)] += 1;
        }
        Some(Distribution {
            mean: moments.mean()?,
            deviation: moments.deviation(),
            lowest: quantile(&sorted, 0.0)?,
            lower_quartile: quantile(&sorted, 0.25)?,
            median: quantile(&sorted, 0.5)?,
            upper_quartile: quantile(&sorted, 0.75)?,
            highest: quantile(&sorted, 1.0)?,
            tenths,
        })
    }
}
