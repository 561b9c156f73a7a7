//! The marks of a run: by group, as a table and for the report.

use vibank::numerics::Rational;
use vibank::output::MarkedRun;
use vibank::report::{GroupSummary, Standing, Standings};
use vibank::worksheet::Marks;

use super::outcome::SheetOutcome;
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::table::Dialect;

/// The marks of a run while sheets are marked.
pub(crate) struct Class {
    marks: Marks,
    standings: Standings,
    /// The points that can be reached on a sheet, at most.
    max: Rational,
    has_groups: bool,
}

/// The columns of `groups.csv`.
const COLUMNS: [&str; 11] = [
    "group",
    "sheets",
    "undecided",
    "mean",
    "median",
    "standard deviation",
    "lowest",
    "highest",
    "passed",
    "failed",
    "pass rate",
];

/// The table of groups.
pub(crate) const FILE: &str = "groups.csv";

impl Class {
    pub(crate) fn new(marks: Marks) -> Self {
        Self {
            marks,
            standings: Standings::default(),
            max: Rational::ZERO,
            has_groups: false,
        }
    }

    pub(crate) fn add(&mut self, sheet: &SheetOutcome) {
        let total = sheet.total.total();
        let worth = self.marks.worth(&total);
        let group = sheet.column("group");
        self.has_groups |= !group.is_empty();
        self.max = self.max.max(total.max);
        self.standings.add(&Standing {
            group,
            points: (sheet.undecided().0 == 0 || total.open.is_zero())
                .then(|| total.points.to_f64()),
            grade: match worth.grades[..] {
                [grade] => Some(grade),
                _ => None,
            },
            passed: worth.passed,
        });
    }

    /// What there is to say of the marks; nothing where they are points alone and of one group.
    pub(crate) fn marked(&self) -> Option<MarkedRun> {
        if !self.has_groups && self.marks == Marks::default() {
            return None;
        }
        let full = self.marks.full(self.max);
        let scale = self.marks.scale.iter();
        let scale: Vec<(String, f64)> = scale
            .map(|step| (step.grade.clone(), step.from.points(full).to_f64()))
            .collect();
        let grades: Vec<&str> = scale.iter().map(|(grade, _)| grade.as_str()).collect();
        Some(MarkedRun {
            summary: self.standings.summary(&grades),
            max: self.max.to_f64(),
            pass: self.marks.pass.map(|pass| pass.points(full).to_f64()),
            rules: self.marks.clone(),
            scale,
        })
    }

    /// Writes the table of groups.
    pub(crate) fn write(marked: &MarkedRun, out: &Folder, dialect: Dialect) -> Result<(), Failure> {
        let mut table = dialect.head(&COLUMNS)?;
        let all = GroupSummary {
            group: "*".to_owned(),
            ..marked.summary.all.clone()
        };
        for group in std::iter::once(&all).chain(&marked.summary.groups) {
            let row = [
                group.group.clone(),
                group.sheets.to_string(),
                group.undecided.to_string(),
                dialect.thousandths(group.mean),
                dialect.thousandths(group.median),
                dialect.thousandths(group.deviation),
                dialect.thousandths(group.lowest),
                dialect.thousandths(group.highest),
                group.passed.to_string(),
                group.failed.to_string(),
                dialect.thousandths(group.pass_rate),
            ];
            table.extend(dialect.line(&row.each_ref().map(String::as_str))?);
        }
        out.write(FILE, &table).map(drop)
    }
}
