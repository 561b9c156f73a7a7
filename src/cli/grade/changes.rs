//! Marks that differ from those of an earlier run.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::path::Path;

use serde::Deserialize;
use vibank::grade;

use super::outcome::{PartOutcome, SheetOutcome};
use crate::cli::folder::Folder;
use crate::cli::table::Dialect;
use crate::cli::{Failure, files};

/// The marks of an earlier run, and those that have changed since.
pub(crate) struct Changes {
    earlier: BTreeMap<(String, usize, String), (Option<f64>, String)>,
    changed: Vec<[String; 8]>,
    /// The program and version that marked the earlier run.
    pub(crate) program: Option<String>,
}

#[derive(Deserialize)]
struct MarkEntry {
    code: String,
    question: usize,
    part: String,
    /// Nothing where it was not decided.
    points: Option<f64>,
    verdict: String,
}

/// The columns of the table.
const COLUMNS: [&str; 8] = [
    "code",
    "student",
    "question",
    "part",
    "verdict before",
    "points before",
    "verdict",
    "points",
];

impl Changes {
    /// The marks in a `results.json`, or in that of a folder.
    pub(crate) fn since(path: &Path) -> Result<Self, Failure> {
        let path = &if path.is_dir() {
            path.join("results.json")
        } else {
            path.to_owned()
        };
        let file = files::open(path)?;
        let report = path.with_file_name("report.json");
        let report = report.is_file().then(|| files::read(&report)).transpose()?;
        let program = report
            .and_then(|report| serde_json::from_str::<serde_json::Value>(&report).ok())
            .and_then(|report| Some(report.get("program")?.as_str()?.to_owned()));
        let mut earlier = BTreeMap::new();
        for line in BufReader::new(file).lines() {
            let fail = |why: &dyn std::fmt::Display| {
                Failure::new(format!(
                    "`{}` has no marks of an earlier run: {why}",
                    path.display()
                ))
                .help("give the `results.json` of that run, or remove it")
            };
            let line = line.map_err(|error| fail(&error))?;
            let line = line.trim().trim_end_matches(',');
            if line.len() > 1 {
                let entry: MarkEntry = serde_json::from_str(line).map_err(|error| fail(&error))?;
                let place = (entry.code, entry.question, entry.part);
                earlier.insert(place, (entry.points, entry.verdict));
            }
        }
        Ok(Self {
            earlier,
            changed: Vec::new(),
            program,
        })
    }

    pub(crate) fn add(&mut self, sheet: &SheetOutcome) {
        for part in &sheet.parts {
            let place = (sheet.code.clone(), part.question, part.letter.clone());
            let Some((points, verdict)) = self.earlier.remove(&place) else {
                continue;
            };
            let now = (!part.is_undecided()).then(|| part.points.0.to_f64());
            let is_same = match (points, now) {
                (Some(before), Some(now)) => (before - now).abs() < 1e-9,
                (before, now) => before.is_none() && now.is_none(),
            } && verdict == part.verdict.name();
            if !is_same {
                self.changed.push(row(sheet, part, points, verdict));
            }
        }
    }

    /// Writes the changed marks; a line for each.
    pub(crate) fn finish(self, out: &Folder, dialect: Dialect) -> Result<Vec<String>, Failure> {
        let mut table = dialect.head(&COLUMNS)?;
        for row in &self.changed {
            let mut row = row.clone();
            [5, 7]
                .into_iter()
                .for_each(|at| row[at] = dialect.number(&row[at]));
            table.extend(dialect.line(&row.each_ref().map(String::as_str))?);
        }
        out.write("changes.csv", &table)?;
        let lines = self.changed.iter().map(|row| {
            let [code, student, question, part, before, points, verdict, now] = row;
            let student = if student.is_empty() {
                ""
            } else {
                &format!(" ({student})")
            };
            let before = format!("{before} {points}");
            let now = format!("{verdict} {now}");
            format!(
                "{code}{student} {question}{part}: {} → {}",
                before.trim_end(),
                now.trim_end()
            )
        });
        Ok(lines.collect())
    }
}

fn row(
    sheet: &SheetOutcome,
    part: &PartOutcome,
    points: Option<f64>,
    verdict: String,
) -> [String; 8] {
    [
        sheet.code.clone(),
        sheet.column("id").to_owned(),
        part.question.to_string(),
        part.letter.clone(),
        verdict,
        points.map_or_else(String::new, |points| {
            ((points * 100.0).round() / 100.0).to_string()
        }),
        part.verdict.name().to_owned(),
        if part.is_undecided() {
            String::new()
        } else {
            grade::rounded(part.points.0)
        },
    ]
}
