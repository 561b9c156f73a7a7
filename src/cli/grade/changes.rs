//! Marks that differ from those of an earlier run.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use serde::Deserialize;
use vibank::grade;

use super::outcome::{Outcome, PartOutcome};
use crate::cli::table::Dialect;
use crate::cli::{Failure, files};

/// The marks of an earlier run, and those that have changed since.
pub(super) struct Changes {
    earlier: BTreeMap<(String, usize, String), (f64, String)>,
    changed: Vec<[String; 8]>,
}

#[derive(Deserialize)]
struct Entry {
    code: String,
    question: usize,
    part: String,
    points: f64,
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
    /// The marks in a `results.json`; none if there is no such file.
    pub(super) fn since(path: &Path) -> Result<Option<Self>, Failure> {
        let Ok(file) = File::open(path) else {
            return Ok(None);
        };
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
                let entry: Entry = serde_json::from_str(line).map_err(|error| fail(&error))?;
                let place = (entry.code, entry.question, entry.part);
                earlier.insert(place, (entry.points, entry.verdict));
            }
        }
        Ok(Some(Self {
            earlier,
            changed: Vec::new(),
        }))
    }

    pub(super) fn add(&mut self, sheet: &Outcome) {
        for part in &sheet.parts {
            let place = (sheet.code.clone(), part.question, part.letter.clone());
            let Some((points, verdict)) = self.earlier.remove(&place) else {
                continue;
            };
            let is_same =
                (points - part.points.0.to_f64()).abs() < 1e-9 && verdict == part.verdict.name();
            if !is_same {
                self.changed.push(row(sheet, part, points, verdict));
            }
        }
    }

    /// Writes the changed marks; says how many they are.
    pub(super) fn finish(self, path: &Path, dialect: Dialect) -> Result<usize, Failure> {
        let mut table = dialect.head(&COLUMNS)?;
        for row in &self.changed {
            let mut row = row.clone();
            [5, 7]
                .into_iter()
                .for_each(|at| row[at] = dialect.number(&row[at]));
            table.extend(dialect.line(&row.each_ref().map(String::as_str))?);
        }
        files::write(path, &table)?;
        Ok(self.changed.len())
    }
}

fn row(sheet: &Outcome, part: &PartOutcome, points: f64, verdict: String) -> [String; 8] {
    [
        sheet.code.clone(),
        sheet.column("id").to_owned(),
        part.question.to_string(),
        part.letter.clone(),
        verdict,
        ((points * 100.0).round() / 100.0).to_string(),
        part.verdict.name().to_owned(),
        grade::rounded(part.points.0),
    ]
}
