//! Response files: CSV or JSON, with one row a part or one row a sheet, or the report of a platform.
//!
//! A row that cannot be read is reported with its line, and what it answers is open; the others count.

use std::path::Path;

use serde_json::{Map, Value as Json};
use vibank::grade::{Responses, Row};
use vibank::seed::Variant;
use vibank::source::nearest;

use super::file_kind::FileKind;
use super::platform::Report;
use super::saved;
use super::scanner::Scan;
use super::table::{self, Table};
use super::{Failure, file_kind, files};

/// The columns of a file with one row a part.
const COLUMNS: [&str; 4] = ["code", "question", "part", "response"];

/// What is read of a file.
#[derive(Default)]
struct FileReading {
    responses: Responses,
    faults: Vec<String>,
}

/// What a file of responses holds.
pub(crate) enum Handed {
    /// The answers to parts of sheets, and what is wrong with single rows.
    Rows(Responses, Vec<String>),
    /// The answers that pages have saved.
    Saved(saved::Saved),
    /// The table of a scanner.
    Scan(Box<Scan>),
    /// The report of a platform.
    Report(Report),
}

#[cfg(feature = "fuzzing")]
impl Handed {
    /// How many rows have something wrong with them.
    pub(crate) fn faults(&self) -> usize {
        match self {
            Self::Rows(_, faults) => faults.len(),
            Self::Saved(saved) => saved.faults.len(),
            Self::Scan(scan) => scan.faults(),
            Self::Report(report) => report.faults(),
        }
    }
}

/// The responses of a file.
pub(crate) fn read(path: &Path) -> Result<Handed, Failure> {
    if path.is_dir() {
        return saved::folder(path).map(Handed::Saved);
    }
    let mut reading = FileReading::default();
    let is_json = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("json"));
    if is_json {
        let text = files::read(path)?;
        if saved::is_saved(&text) {
            return Ok(Handed::Saved(saved::file(path, &text)));
        }
        reading.json(path, text.as_bytes())?;
    } else {
        let table = Table::read(path)?;
        match LineLayout::of(&small(&table)) {
            Some(layout) => reading.table(&layout, &table),
            None => return report(path, table),
        }
    }
    let errors = reading.responses.settle();
    reading
        .faults
        .extend(errors.iter().map(ToString::to_string));
    Ok(Handed::Rows(reading.responses, reading.faults))
}

/// The headings of a table in small letters.
fn small(table: &Table) -> Vec<String> {
    table
        .headings
        .iter()
        .map(|name| name.to_lowercase())
        .collect()
}

/// A table that this program did not lay out.
fn report(path: &Path, table: Table) -> Result<Handed, Failure> {
    if let Some(doubt) = &table.doubt {
        eprintln!("{doubt}");
    }
    let table = match Scan::of(table) {
        Ok(scan) => return Ok(Handed::Scan(Box::new(scan))),
        Err(table) => table,
    };
    match Report::of(path, &table)? {
        Some(report) => Ok(Handed::Report(report)),
        None => Err(no_columns(path, &table)),
    }
}

/// A table whose headings say nothing of answers: what they are, and which may have been mistyped.
fn no_columns(path: &Path, table: &Table) -> Failure {
    const NEEDED: [&str; 4] = ["code", "question", "part", "response"];
    if let Some(FileKind::Blueprint | FileKind::Page) = FileKind::of_file(path) {
        return file_kind::not_answers(path, "");
    }
    let shown = path.display();
    let headings = small(table);
    let lacking = NEEDED
        .iter()
        .find(|name| !headings.iter().any(|own| own == *name));
    let candidates = headings.iter().map(String::as_str);
    let candidates = candidates.filter(|own| !NEEDED.contains(own));
    let near = lacking.and_then(|name| Some((name, nearest(name, candidates)?)));
    let near = near.map_or_else(String::new, |(name, near)| {
        format!("is `{near}` meant to be `{name}`? ")
    });
    let found = table.headings.join("`, `");
    Failure::new(format!("`{shown}` has no columns of responses, but `{found}`")).help(format!(
        "{near}the header needs `code`, `question`, `part`, `response`, or `code` and one column a part (`1a`, `1b`); or give the report of a platform or of a scanner as it was downloaded"
    ))
}

impl FileReading {
    fn add(&mut self, row: &Row<'_>) {
        let error = self.responses.add(row);
        self.faults.extend(error.map(|error| error.to_string()));
    }

    fn table(&mut self, layout: &LineLayout, table: &Table) {
        if let Some(doubt) = &table.doubt {
            eprintln!("{doubt}");
        }
        for row in table.rows(&|row| begins_sheet(row, layout.code())) {
            match row {
                Ok(row) => layout.rows(&row, &mut |at, response| match table.spoilt(row.line, at) {
                    Some(spoilt) => {
                        self.faults.push(format!(
                            "row {}, column `{}`: {spoilt}; format the column as text, and type the answer again",
                            row.line, table.headings[at]
                        ));
                        self.responses.add_open(response);
                    }
                    None => self.add(response),
                }),
                Err(broken) => {
                    self.faults.push(format!("{broken}; what it answers is not decided"));
                    layout.rows(&broken.row, &mut |_, response| self.responses.add_open(response));
                }
            }
        }
    }

    fn json(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        let entries: Vec<Json> = serde_json::from_slice(bytes)
            .map_err(|error| file_kind::not_answers(path, &error.to_string()))?;
        for (position, entry) in entries.iter().enumerate() {
            let number = position + 1;
            match entry.as_object() {
                Some(object) => self.object(number, object),
                None => self.faults.push(format!("entry {number} is not an object")),
            }
        }
        Ok(())
    }

    /// One part, or one sheet with a key for each part.
    fn object(&mut self, number: usize, object: &Map<String, Json>) {
        let Some(code) = object.get("code").and_then(written) else {
            self.faults.push(format!("entry {number} has no `code`"));
            return;
        };
        if object.contains_key("question") {
            let [question, part] = ["question", "part"]
                .map(|name| object.get(name).and_then(written).unwrap_or_default());
            let row = Row {
                line: number,
                code: &code,
                question: &question,
                part: &part,
                response: &object.get("response").and_then(written).unwrap_or_default(),
            };
            return self.add(&row);
        }
        for (name, value) in object {
            if let (Some((question, part)), Some(response)) =
                (part_column(&name.to_lowercase()), written(value))
            {
                self.add(&Row {
                    line: number,
                    code: &code,
                    question,
                    part,
                    response: &response,
                });
            }
        }
    }
}

/// A text, or a number as it is written.
fn written(value: &Json) -> Option<String> {
    match value {
        Json::String(text) => Some(text.clone()),
        Json::Number(number) => Some(number.to_string()),
        Json::Null => Some(String::new()),
        _ => None,
    }
}

/// Where in a line the answers stand.
enum LineLayout {
    /// One row a part: places of [`COLUMNS`].
    Parts([usize; 4]),
    /// One row a sheet: place of the code, and of each part.
    Sheets(usize, Vec<(usize, String, String)>),
}

impl LineLayout {
    fn of(names: &[String]) -> Option<Self> {
        let places = COLUMNS.map(|name| names.iter().position(|found| found == name));
        if let [Some(a), Some(b), Some(c), Some(d)] = places {
            return Some(Self::Parts([a, b, c, d]));
        }
        let parts = names.iter().enumerate().filter_map(|(at, name)| {
            let (question, part) = part_column(name)?;
            Some((at, question.to_owned(), part.to_owned()))
        });
        let parts: Vec<_> = parts.collect();
        (!parts.is_empty()).then_some(Self::Sheets(places[0]?, parts))
    }

    /// The column of codes.
    fn code(&self) -> usize {
        match self {
            Self::Parts([code, ..]) | Self::Sheets(code, _) => *code,
        }
    }

    /// Hands on the answers of a row, each with its column.
    fn rows(&self, row: &table::TableRow<'_>, take: &mut dyn FnMut(usize, &Row<'_>)) {
        match self {
            Self::Parts([code, question, part, response]) => take(
                *response,
                &Row {
                    line: row.line,
                    code: row.cell(*code),
                    question: row.cell(*question),
                    part: row.cell(*part),
                    response: row.cell(*response),
                },
            ),
            Self::Sheets(code, parts) => {
                for (at, question, part) in parts {
                    let response = Row {
                        line: row.line,
                        code: row.cell(*code),
                        question,
                        part,
                        response: row.cell(*at),
                    };
                    take(*at, &response);
                }
            }
        }
    }
}

/// Whether cells look like a row of their own: several, with the code of a sheet where codes stand.
pub(crate) fn begins_sheet(row: &table::TableRow<'_>, code: usize) -> bool {
    row.cells.len() > 1 && row.cell(code).parse::<Variant>().is_ok()
}

/// A column such as `2b`, or `2b1` of a blank: question and part.
pub(crate) fn part_column(name: &str) -> Option<(&str, &str)> {
    let digits = name.find(|letter: char| !letter.is_ascii_digit())?;
    let (question, part) = name.split_at(digits);
    let letters = part.trim_end_matches(|char: char| char.is_ascii_digit());
    let is_part = !question.is_empty()
        && (1..=2).contains(&letters.len())
        && part.len() - letters.len() <= 3
        && letters.bytes().all(|byte| byte.is_ascii_lowercase());
    is_part.then_some((question, part))
}
