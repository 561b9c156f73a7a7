//! The marks of a run by group: where they lie, how they spread, who passes.
//!
//! Sheets on which something is not decided yet are counted, and left out of all that is computed from points.

use std::collections::BTreeMap;

use serde::Serialize;

use super::statistics::{Moments, quantile};

/// What one sheet came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing<'a> {
    /// The group of its student; may be empty.
    pub group: &'a str,
    /// Its points; none while some are not decided.
    pub points: Option<f64>,
    /// Its grade; none without a scale, or while it is not decided.
    pub grade: Option<&'a str>,
    /// Whether it passes; none where nothing says so, or while it is not decided.
    pub passed: Option<bool>,
}

/// The marks of a run, gathered one sheet at a time.
#[derive(Clone, Debug, Default)]
pub struct Standings {
    all: MarksTally,
    groups: BTreeMap<String, MarksTally>,
    grades: BTreeMap<String, u64>,
}

#[derive(Clone, Debug, Default)]
struct MarksTally {
    sheets: u64,
    points: Vec<f64>,
    passed: [u64; 2],
}

/// What the marks of a run came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MarksSummary {
    /// All sheets.
    pub all: GroupSummary,
    /// By group, where there are several.
    pub groups: Vec<GroupSummary>,
    /// How often each grade was given, in the order of the scale.
    pub grades: Vec<GradeCount>,
    /// The points of the sheets on which all is decided, ascending.
    #[serde(skip)]
    pub points: Vec<f64>,
}

/// The marks of a group.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GroupSummary {
    /// Its name; empty for those without, and for all.
    pub group: String,
    /// Number of sheets that were marked.
    pub sheets: u64,
    /// On how many of them something is not decided.
    pub undecided: u64,
    /// Mean of the points.
    pub mean: Option<f64>,
    /// Half of the sheets have fewer points.
    pub median: Option<f64>,
    /// Standard deviation of the points.
    pub deviation: Option<f64>,
    /// Fewest points.
    pub lowest: Option<f64>,
    /// Most points.
    pub highest: Option<f64>,
    /// How many pass.
    pub passed: u64,
    /// How many do not.
    pub failed: u64,
    /// The share of those that pass, of those for which that is decided.
    pub pass_rate: Option<f64>,
}

/// How often a grade was given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GradeCount {
    /// Name of the grade in the scheme.
    pub grade: String,
    /// How often.
    pub count: u64,
}

impl Standings {
    /// Adds a sheet.
    pub fn add(&mut self, standing: &Standing<'_>) {
        self.all.add(standing);
        let group = self.groups.entry(standing.group.to_owned());
        group.or_default().add(standing);
        if let Some(grade) = standing.grade {
            *self.grades.entry(grade.to_owned()).or_default() += 1;
        }
    }

    /// What came out; `scale` are the grades, the best first.
    ///
    /// ```
    /// use vibank::report::{Standing, Standings};
    ///
    /// let mut standings = Standings::default();
    /// for (points, passed) in [(Some(12.0), Some(true)), (Some(4.0), Some(false)), (None, None)] {
    ///     standings.add(&Standing { group: "A", points, grade: None, passed });
    /// }
    /// let all = standings.summary(&[]).all;
    /// assert_eq!((all.mean, all.undecided, all.pass_rate), (Some(8.0), 1, Some(0.5)));
    /// ```
    pub fn summary(&self, scale: &[&str]) -> MarksSummary {
        let count = |grade: &&str| GradeCount {
            grade: (*grade).to_owned(),
            count: self.grades.get(*grade).copied().unwrap_or(0),
        };
        let groups = self.groups.iter();
        let groups: Vec<GroupSummary> = groups.map(|(name, tally)| tally.summary(name)).collect();
        MarksSummary {
            all: self.all.summary(""),
            groups: if groups.len() > 1 { groups } else { Vec::new() },
            grades: scale.iter().map(count).collect(),
            points: self.all.sorted(),
        }
    }
}

impl MarksTally {
    fn add(&mut self, standing: &Standing<'_>) {
        self.sheets += 1;
        self.points.extend(standing.points);
        if let Some(passed) = standing.passed {
            self.passed[usize::from(passed)] += 1;
        }
    }

    fn sorted(&self) -> Vec<f64> {
        let mut points = self.points.clone();
        points.sort_by(f64::total_cmp);
        points
    }

    fn summary(&self, group: &str) -> GroupSummary {
        let sorted = self.sorted();
        let mut moments = Moments::default();
        sorted.iter().for_each(|points| moments.add(*points));
        let [failed, passed] = self.passed;
        let settled = failed + passed;
        GroupSummary {
            group: group.to_owned(),
            sheets: self.sheets,
            undecided: self.sheets - sorted.len() as u64,
            mean: moments.mean(),
            median: quantile(&sorted, 0.5),
            deviation: moments.deviation(),
            lowest: sorted.first().copied(),
            highest: sorted.last().copied(),
            passed,
            failed,
            pass_rate: (settled > 0).then(|| passed as f64 / settled as f64),
        }
    }
}
