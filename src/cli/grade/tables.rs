//! The tables of a grading run: `marks.csv`, `details.csv` and `results.json`.

use serde_json::json;
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
    columns: Vec<Column>,
    dialect: Dialect,
    is_first: bool,
}

/// The columns of the details.
const DETAILS: [&str; 14] = [
    "code", "student", "question", "part", "item", "id", "response", "reading", "verdict",
    "credit", "points", "max", "reasons", "feedback",
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
        let head = [
            "code",
            "student",
            "name",
            "group",
            "points",
            "max",
            "undecided",
            "undecided points",
        ];
        let head: Vec<&str> = head
            .into_iter()
            .chain(names.iter().map(String::as_str))
            .collect();
        let mut results = out.begin("results.json")?;
        results.write(b"[")?;
        Ok(Self {
            marks: draft("marks.csv", &head)?,
            details: draft("details.csv", &DETAILS)?,
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
        }
        Ok(())
    }

    fn mark(&mut self, sheet: &Outcome) -> Result<(), Failure> {
        let cell = |(question, letter): &Column| {
            let mut parts = sheet.parts.iter();
            let found = parts.find(|part| part.question == *question && part.letter == *letter);
            found.map_or_else(String::new, |part| self.part(part))
        };
        let (undecided, open) = sheet.undecided();
        let (points, max) = (
            self.dialect.number(&grade::standing(sheet.points(), open)),
            self.points(sheet.max()),
        );
        let (undecided, open) = (undecided.to_string(), self.points(open));
        let cells: Vec<String> = self.columns.iter().map(cell).collect();
        let mut row = vec![
            sheet.code.as_str(),
            sheet.column("id"),
            sheet.column("name"),
            sheet.column("group"),
            &points,
            &max,
            &undecided,
            &open,
        ];
        row.extend(cells.iter().map(String::as_str));
        self.marks.write(&self.dialect.line(&row)?)
    }

    /// The points of a part; with a question mark those that are not decided.
    fn part(&self, part: &PartOutcome) -> String {
        if part.is_undecided() {
            format!("?{}", self.points(part.max.0))
        } else {
            self.points(part.points.0)
        }
    }

    fn points(&self, points: Rational) -> String {
        self.dialect.number(&grade::rounded(points))
    }

    fn detail(&mut self, sheet: &Outcome, part: &PartOutcome) -> Result<(), Failure> {
        let (points, max) = (self.part(part), self.points(part.max.0));
        let credit = part.credit.0.to_f64().to_string();
        let credit = if part.is_undecided() {
            String::new()
        } else {
            self.dialect.number(&credit)
        };
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
            &credit,
            &points,
            &max,
            &part.reasons.join(" "),
            &part.feedback,
        ])?)
    }

    fn result(&mut self, sheet: &Outcome, part: &PartOutcome) -> Result<(), Failure> {
        let settled = |number: f64| (!part.is_undecided()).then_some(number);
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
            "credit": settled(part.credit.0.to_f64()),
            "points": settled(part.points.0.to_f64()),
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

    /// Moves the tables to their places.
    pub(super) fn finish(mut self) -> Result<(), Failure> {
        self.results.write(b"\n]\n")?;
        for table in [self.marks, self.details, self.results] {
            table.finish()?;
        }
        Ok(())
    }
}
