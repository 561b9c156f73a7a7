//! The report of a run: what could not be read, and the item analysis, as a page, JSON and CSV.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::json;
use vibank::answer::Verdict;
use vibank::output::{Analysed, report_page};
use vibank::report::{Observation, PartSummary, Report};

use super::items::Items;
use super::outcome::SheetOutcome;
use super::{Findings, Layout};
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::sheet::PROGRAM;
use crate::cli::table::Dialect;

/// What the report is made of.
#[derive(Default)]
pub(crate) struct Analysis {
    report: Report,
    verdicts: BTreeMap<Verdict, u64>,
    sheets: usize,
    /// Spare sheets that nobody has used.
    unused: usize,
    /// Students on whose sheets nothing was answered, who were absent: the `id`, or the code where names are unknown.
    absent: Vec<String>,
    /// Those who have answered on some sheet: of several runs a student may have another one.
    present: BTreeSet<String>,
    /// Parts that nobody has marked by hand yet.
    open: u64,
}

/// The columns of `report.csv`.
const COLUMNS: [&str; 16] = [
    "question",
    "item",
    "part",
    "title",
    "asked",
    "right",
    "partial",
    "wrong",
    "unreadable",
    "missing",
    "follow_through",
    "facility",
    "discrimination",
    "commonest mistake",
    "times",
    "commonest other answer",
];

impl Analysis {
    pub(crate) fn add(&mut self, sheet: &SheetOutcome) {
        self.sheets += 1;
        self.present.insert(sheet.column("id").to_owned());
        let reasons: Vec<Vec<&str>> = sheet
            .parts
            .iter()
            .map(|part| part.reasons.iter().map(String::as_str).collect())
            .collect();
        let seen = sheet
            .parts
            .iter()
            .zip(&reasons)
            .map(|(part, reasons)| Observation {
                item: &part.item,
                part: &part.id,
                question: part.question,
                letter: &part.letter,
                points: part.points.0.to_f64(),
                max: part.max.0.to_f64(),
                verdict: part.verdict,
                reasons,
                other: part.other.as_deref(),
            });
        self.report.add(&seen.collect::<Vec<_>>());
        for part in &sheet.parts {
            *self.verdicts.entry(part.verdict).or_default() += 1;
            self.open += u64::from(part.by_hand && part.is_undecided());
        }
    }

    /// Counts a sheet that nobody has used, which no statistics are about.
    pub(crate) fn leave_out(&mut self) {
        self.unused += 1;
    }

    /// Counts a student who was absent, whom no statistics are about.
    pub(crate) fn leave_absent_out(&mut self, sheet: &SheetOutcome) {
        let id = sheet.column("id");
        let shown = if id.is_empty() { &sheet.code } else { id };
        self.absent.push(shown.to_owned());
    }

    /// How many sheets were marked, those of absent students among them.
    pub(crate) fn marked(&self) -> usize {
        self.sheets + self.absent.len()
    }

    /// Who was absent.
    pub(crate) fn absent(&self) -> Vec<&str> {
        let all = self.absent.iter().map(String::as_str);
        all.filter(|own| !self.present.contains(*own)).collect()
    }

    /// How many spare sheets nobody has used.
    pub(crate) fn unused(&self) -> usize {
        self.unused
    }

    /// How many parts wait for a person.
    pub(crate) fn open(&self) -> u64 {
        self.open
    }

    pub(crate) fn verdicts(&self) -> impl Iterator<Item = (Verdict, u64)> + '_ {
        self.verdicts
            .iter()
            .map(|(verdict, count)| (*verdict, *count))
    }

    pub(crate) fn count(&self, verdict: Verdict) -> u64 {
        self.verdicts.get(&verdict).copied().unwrap_or(0)
    }

    /// Writes `report.html`, `report.json` and `report.csv`.
    pub(crate) fn write(
        &self,
        out: &Folder,
        items: &Items<'_>,
        layout: &Layout,
        dialect: Dialect,
        findings: &Findings<'_>,
    ) -> Result<(), Failure> {
        let summary = self.report.summary(|item| items.named(item));
        let unreadable = self.count(Verdict::Unreadable);
        let json = json!({
            "program": PROGRAM,
            "unreadable": findings.lost,
            "rows_left_out": findings.faults,
            "decisions": findings.decided,
            "marks": findings.marks.map(|marks| &marks.summary),
            "unused_spares": self.unused,
            "absent": self.absent().len(),
            "summary": summary,
        });
        let text = serde_json::to_string_pretty(&json).expect("a report is plain data");
        out.write("report.json", format!("{text}\n").as_bytes())?;
        let mut table = dialect.head(&COLUMNS)?;
        for part in &summary.parts {
            table.extend(dialect.line(&row(part, dialect).each_ref().map(String::as_str))?);
        }
        out.write("report.csv", &table)?;
        let analysed = Analysed {
            summary: &summary,
            lost: findings.lost,
            unreadable,
            unused: self.unused,
            absent: self.absent().len(),
            faults: findings.faults,
            marks: findings.marks,
            decided: findings.decided,
        };
        let page = report_page(&layout.pages, &analysed).map_err(Failure::of)?;
        let begin = layout
            .pages
            .begin(layout.pages.report_subtitle())
            .map_err(Failure::of)?;
        let whole = format!("{begin}{page}{}", layout.end);
        out.write("report.html", whole.as_bytes()).map(drop)
    }
}

fn row(part: &PartSummary, dialect: Dialect) -> [String; 16] {
    let mistake = part.mistakes.first();
    [
        part.places.join(" "),
        part.item.clone(),
        part.part.clone(),
        part.title.clone(),
        part.asked.to_string(),
        part.right.to_string(),
        part.partial.to_string(),
        part.wrong.to_string(),
        part.unreadable.to_string(),
        part.missing.to_string(),
        part.follow_through.to_string(),
        dialect.thousandths(part.facility),
        dialect.thousandths(part.discrimination),
        mistake.map_or_else(String::new, |mistake| mistake.what.clone()),
        mistake.map_or_else(String::new, |mistake| mistake.count.to_string()),
        part.others.first().map_or_else(String::new, |other| {
            format!("{} ({} times)", other.what, other.count)
        }),
    ]
}
