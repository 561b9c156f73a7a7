//! The tables of a grading run: `marks.csv`, `details.csv`, `results.json` and `unreadable.csv`.

use serde_json::json;
use vibank::answer::Verdict;
use vibank::grade;
use vibank::numerics::Rational;

use super::outcome::{Outcome, PartOutcome};
use crate::cli::Failure;
use crate::cli::folder::{Draft, Folder};
use crate::cli::table::Dialect;

/// A column of the marks: number of the question, letter of the part.
pub(super) type Column = (usize, String);

/// The tables, written as sheets are marked.
pub(super) struct Tables {
    marks: Draft,
    details: Draft,
    results: Draft,
    unreadable: Draft,
    columns: Vec<Column>,
    dialect: Dialect,
    is_first: bool,
}

/// The columns of the details.
const DETAILS: [&str; 14] = [
    "code", "student", "question", "part", "item", "id", "response", "reading", "verdict",
    "credit", "points", "max", "reasons", "feedback",
];

/// The columns of what could not be read; the last three are for the teacher, see `overrides`.
const UNREADABLE: [&str; 9] = [
    "code", "student", "question", "part", "given", "why", "response", "points", "feedback",
];

impl Tables {
    pub(super) fn begin(
        out: &Folder,
        columns: Vec<Column>,
        dialect: Dialect,
    ) -> Result<Self, Failure> {
        let draft = |name: &str, head: &[&str]| {
            let mut draft = out.begin(name)?;
            draft.write(&dialect.head(head)?)?;
            Ok::<_, Failure>(draft)
        };
        let names: Vec<String> = columns
            .iter()
            .map(|(question, letter)| format!("{question}{letter}"))
            .collect();
        let head = ["code", "student", "name", "group", "points", "max"];
        let head: Vec<&str> = head
            .into_iter()
            .chain(names.iter().map(String::as_str))
            .collect();
        let mut results = out.begin("results.json")?;
        results.write(b"[")?;
        Ok(Self {
            marks: draft("marks.csv", &head)?,
            details: draft("details.csv", &DETAILS)?,
            unreadable: draft("unreadable.csv", &UNREADABLE)?,
            results,
            columns,
            dialect,
            is_first: true,
        })
    }

    pub(super) fn add(&mut self, sheet: &Outcome) -> Result<(), Failure> {
        self.mark(sheet)?;
        for part in &sheet.parts {
            self.detail(sheet, part)?;
            self.result(sheet, part)?;
            if part.verdict == Verdict::Unreadable {
                self.could_not_be_read(sheet, part)?;
            }
        }
        Ok(())
    }

    fn mark(&mut self, sheet: &Outcome) -> Result<(), Failure> {
        let cell = |(question, letter): &Column| {
            let mut parts = sheet.parts.iter();
            let found = parts.find(|part| part.question == *question && part.letter == *letter);
            found.map_or_else(String::new, |part| self.points(part.points.0))
        };
        let (points, max) = (self.points(sheet.points()), self.points(sheet.max()));
        let cells: Vec<String> = self.columns.iter().map(cell).collect();
        let mut row = vec![
            sheet.code.as_str(),
            sheet.column("id"),
            sheet.column("name"),
            sheet.column("group"),
            &points,
            &max,
        ];
        row.extend(cells.iter().map(String::as_str));
        self.marks.write(&self.dialect.line(&row)?)
    }

    fn points(&self, points: Rational) -> String {
        self.dialect.number(&grade::rounded(points))
    }

    fn detail(&mut self, sheet: &Outcome, part: &PartOutcome) -> Result<(), Failure> {
        let (points, max) = (self.points(part.points.0), self.points(part.max.0));
        self.details.write(&self.dialect.line(&[
            &sheet.code,
            sheet.column("id"),
            &part.question.to_string(),
            &part.letter,
            &part.item,
            &part.id,
            &part.response,
            &part.reading,
            part.verdict.name(),
            &self.dialect.number(&part.credit.0.to_f64().to_string()),
            &points,
            &max,
            &part.reasons.join(" "),
            &part.feedback,
        ])?)
    }

    fn result(&mut self, sheet: &Outcome, part: &PartOutcome) -> Result<(), Failure> {
        let entry = json!({
            "code": sheet.code,
            "student": sheet.column("id"),
            "question": part.question,
            "part": part.letter,
            "item": part.item,
            "id": part.id,
            "response": part.response,
            "reading": if part.reading.is_empty() { None } else { Some(&part.reading) },
            "verdict": part.verdict,
            "credit": part.credit.0.to_f64(),
            "points": part.points.0.to_f64(),
            "max": part.max.0.to_f64(),
            "reasons": part.reasons,
            "feedback": part.feedback,
        });
        let before: &[u8] = if std::mem::take(&mut self.is_first) {
            b"\n"
        } else {
            b",\n"
        };
        self.results.write(before)?;
        self.results.write(entry.to_string().as_bytes())
    }

    fn could_not_be_read(&mut self, sheet: &Outcome, part: &PartOutcome) -> Result<(), Failure> {
        self.unreadable.write(&self.dialect.line(&[
            &sheet.code,
            sheet.column("id"),
            &part.question.to_string(),
            &part.letter,
            &part.response,
            &part.feedback,
            "",
            "",
            "",
        ])?)
    }

    /// Moves the tables to their places.
    pub(super) fn finish(mut self) -> Result<(), Failure> {
        self.results.write(b"\n]\n")?;
        for table in [self.marks, self.details, self.results, self.unreadable] {
            table.finish()?;
        }
        Ok(())
    }
}
