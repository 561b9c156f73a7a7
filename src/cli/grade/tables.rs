//! The tables of a grading run: `marks.csv`, `details.csv` and `results.json`, and `marks.xlsx` where it is asked for.

use serde::Serialize;
use vibank::answer::Verdict;
use vibank::grade;
use vibank::numerics::Rational;
use vibank::worksheet::{Csv, Marks};

use super::outcome::{PartOutcome, SheetOutcome};
use crate::cli::Failure;
use crate::cli::folder::{Draft, Folder};
use crate::cli::table::Dialect;
use crate::cli::table::workbook::{self, Cell};

/// A column of the marks: number of the question, letter of the part; the question as a whole has none.
pub(crate) type Column = (usize, String);

/// The columns of the marks before those of the parts; the first four are never numbers.
const MARKS: [&str; 8] = [
    "code",
    "student",
    "name",
    "group",
    "points",
    "max",
    "undecided",
    "undecided points",
];

/// What stands in place of the points of a student on whose sheet nothing was answered.
const ABSENT: &str = "absent";

/// Those for the points that the program gave, and those that a person gave, where there are such.
const APART: [&str; 2] = ["auto", "hand"];

/// What a sheet is worth, where `[marks]` says it.
const WORTH: [&str; 3] = ["percent", "grade", "passed"];

/// The columns of the marks before those of questions and parts.
fn marks(has_hand: bool, has_worth: bool) -> impl Iterator<Item = &'static str> {
    let apart = APART.into_iter().filter(move |_| has_hand);
    let worth = WORTH.into_iter().filter(move |_| has_worth);
    MARKS.into_iter().chain(apart).chain(worth)
}

/// The tables, written as sheets are marked.
pub(crate) struct Tables {
    marks: Draft,
    details: Draft,
    results: Draft,
    columns: Vec<Column>,
    /// Whether a person marks some parts, so that their points stand apart.
    has_hand: bool,
    /// What becomes of the points of a sheet.
    rules: Marks,
    dialect: Dialect,
    is_first: bool,
    /// The rows of the marks for a workbook, where the run has one.
    book: Option<Vec<Vec<Cell>>>,
}

/// The columns of the details.
const DETAILS: [&str; 14] = [
    "code", "student", "question", "part", "item", "id", "response", "reading", "verdict",
    "credit", "points", "max", "reasons", "feedback",
];

impl Tables {
    pub(crate) fn begin(
        out: &Folder,
        columns: Vec<Column>,
        has_hand: bool,
        rules: Marks,
        dialect: Dialect,
        has_book: bool,
    ) -> Result<Self, Failure> {
        let draft = |name: &str, head: &[&str]| {
            let mut draft = out.begin(name)?.without_digest();
            draft.write(&dialect.head(head)?)?;
            Ok::<_, Failure>(draft)
        };
        let names: Vec<String> = columns
            .iter()
            .map(|(question, letter)| format!("{question}{letter}"))
            .collect();
        let fixed: Vec<&str> = marks(has_hand, is_worth(&rules)).collect();
        let head: Vec<&str> = fixed
            .into_iter()
            .chain(names.iter().map(String::as_str))
            .collect();
        let mut results = out.begin("results.json")?.without_digest();
        results.write(b"[")?;
        Ok(Self {
            marks: draft("marks.csv", &head)?,
            details: draft("details.csv", &DETAILS)?,
            results,
            columns,
            has_hand,
            rules,
            dialect,
            is_first: true,
            book: has_book.then(Vec::new),
        })
    }

    /// Adds a sheet; of an absent student there is no mark.
    pub(crate) fn add(&mut self, sheet: &SheetOutcome, is_absent: bool) -> Result<(), Failure> {
        self.mark(sheet, is_absent)?;
        for part in &sheet.parts {
            self.detail(sheet, part)?;
            self.result(sheet, part)?;
        }
        Ok(())
    }

    /// A row of the marks, its numbers written in a dialect.
    fn row(&self, sheet: &SheetOutcome, is_absent: bool, dialect: Dialect) -> Vec<String> {
        if is_absent {
            return self.absent_row(sheet, dialect);
        }
        let cell = |(question, letter): &Column| {
            if letter.is_empty() {
                let standing = sheet.question(*question);
                return standing.map_or_else(String::new, |own| {
                    dialect.number(&grade::standing(own.points.0, own.open.0))
                });
            }
            let mut parts = sheet.parts.iter();
            let found = parts.find(|part| part.question == *question && part.letter == *letter);
            found.map_or_else(String::new, |part| part_points(part, dialect))
        };
        let (undecided, open) = sheet.undecided();
        let standing = dialect.number(&grade::standing(sheet.points(), open));
        let own = ["id", "name", "group"].map(|name| sheet.column(name).to_owned());
        let sums = [
            standing,
            dialect.number(&grade::rounded(sheet.max())),
            undecided.to_string(),
            dialect.number(&grade::rounded(open)),
        ];
        let row = std::iter::once(sheet.code.clone()).chain(own).chain(sums);
        let apart = [false, true].into_iter().filter(|_| self.has_hand);
        let apart = apart.map(|by_hand| {
            let (reached, open) = sheet.points_of(by_hand);
            dialect.number(&grade::standing(reached, open))
        });
        row.chain(apart)
            .chain(self.worth(sheet, dialect))
            .chain(self.columns.iter().map(cell))
            .collect()
    }

    /// The row of a student who was absent: a word in place of the points, which a spreadsheet leaves out of a mean.
    fn absent_row(&self, sheet: &SheetOutcome, dialect: Dialect) -> Vec<String> {
        let own = ["id", "name", "group"].map(|name| sheet.column(name).to_owned());
        let max = dialect.number(&grade::rounded(sheet.max()));
        let mut row = vec![sheet.code.clone()];
        row.extend(own);
        row.extend([ABSENT.to_owned(), max]);
        let width = marks(self.has_hand, is_worth(&self.rules)).count() + self.columns.len();
        row.resize(width, String::new());
        row
    }

    /// Percent, grade and whether it passes, where `[marks]` says it.
    fn worth(&self, sheet: &SheetOutcome, dialect: Dialect) -> Vec<String> {
        if !is_worth(&self.rules) {
            return Vec::new();
        }
        let total = sheet.total.total();
        let [least, open] = [total.points, total.open].map(|points| {
            let share = self.rules.share(points, total.max)?;
            share.checked_mul(Rational::from(100))
        });
        let percent = least.zip(open);
        let percent =
            percent.map_or_else(String::new, |(least, open)| grade::standing(least, open));
        let worth = self.rules.worth(&total);
        let grade = match worth.grades[..] {
            [] => String::new(),
            [grade] => grade.to_owned(),
            _ => format!("?{}", worth.grades.join(" to ")),
        };
        let passed = match (self.rules.pass, worth.passed) {
            (None, _) => "",
            (_, Some(true)) => "yes",
            (_, Some(false)) => "no",
            (_, None) => "?",
        };
        vec![dialect.number(&percent), grade, passed.to_owned()]
    }

    fn mark(&mut self, sheet: &SheetOutcome, is_absent: bool) -> Result<(), Failure> {
        if self.book.is_some() {
            let row = self.row(sheet, is_absent, Dialect::new(Csv::Plain, '.'));
            let row = row.into_iter().enumerate().map(cell).collect();
            self.book
                .iter_mut()
                .for_each(|book| book.push(Vec::clone(&row)));
        }
        let row = self.row(sheet, is_absent, self.dialect);
        let row: Vec<&str> = row.iter().map(String::as_str).collect();
        self.marks.write(&self.dialect.line(&row)?)
    }

    fn detail(&mut self, sheet: &SheetOutcome, part: &PartOutcome) -> Result<(), Failure> {
        let max = self.dialect.number(&grade::rounded(part.max.0));
        let points = part_points(part, self.dialect);
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

    fn result(&mut self, sheet: &SheetOutcome, part: &PartOutcome) -> Result<(), Failure> {
        let entry = ResultEntry {
            code: &sheet.code,
            student: sheet.column("id"),
            question: part.question,
            part: &part.letter,
            item: &part.item,
            id: &part.id,
            response: &part.response,
            reading: Some(&*part.reading).filter(|reading| !reading.is_empty()),
            verdict: part.verdict,
            credit: (!part.is_undecided()).then_some(part.credit.0.to_f64()),
            points: (!part.is_undecided()).then_some(part.points.0.to_f64()),
            max: part.max.0.to_f64(),
            reasons: &part.reasons,
            feedback: &part.feedback,
            by_hand: part.by_hand.then_some(true),
        };
        let entry = serde_json::to_vec(&entry).expect("a result is plain data");
        let before: &[u8] = if std::mem::take(&mut self.is_first) {
            b"\n"
        } else {
            b",\n"
        };
        self.results.write(before)?;
        self.results.write(&entry)
    }

    /// Moves the tables to their places; the files with the marks are named.
    pub(crate) fn finish(mut self, out: &Folder) -> Result<&'static str, Failure> {
        let files = match self.book {
            Some(_) => "marks.csv, marks.xlsx",
            None => "marks.csv",
        };
        if let Some(rows) = self.book.take() {
            let parts = self.columns.iter();
            let parts = parts.map(|(question, letter)| format!("{question}{letter}"));
            let head = marks(self.has_hand, is_worth(&self.rules)).map(str::to_owned);
            let head: Vec<String> = head.chain(parts).collect();
            out.write("marks.xlsx", &workbook::written("Marks", &head, &rows)?)?;
        }
        self.results.write(b"\n]\n")?;
        for table in [self.marks, self.details, self.results] {
            table.finish()?;
        }
        Ok(files)
    }
}

/// A cell of a workbook: the first four columns are texts.
fn cell((at, text): (usize, String)) -> Cell {
    if at < 4 {
        Cell::Text(text)
    } else {
        Cell::of(&text)
    }
}

/// A part in `results.json`.
#[derive(Serialize)]
struct ResultEntry<'a> {
    code: &'a str,
    student: &'a str,
    question: usize,
    part: &'a str,
    item: &'a str,
    id: &'a str,
    response: &'a str,
    /// None if it was not read.
    reading: Option<&'a str>,
    verdict: Verdict,
    credit: Option<f64>,
    points: Option<f64>,
    max: f64,
    reasons: &'a [String],
    feedback: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    by_hand: Option<bool>,
}

/// Whether there is more to say of a sheet than its points.
fn is_worth(rules: &Marks) -> bool {
    rules.pass.is_some() || rules.full.is_some() || !rules.scale.is_empty()
}

/// The points of a part; with a question mark those that are not decided.
fn part_points(part: &PartOutcome, dialect: Dialect) -> String {
    if part.is_undecided() {
        format!("?{}", dialect.number(&grade::rounded(part.max.0)))
    } else {
        dialect.number(&grade::rounded(part.points.0))
    }
}
