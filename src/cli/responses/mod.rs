//! Response files: CSV or JSON, with one row a part or one row a sheet.
//!
//! A row that cannot be read is told with its line; the others count.

mod table;

pub(crate) use table::{Lines, delimiter};

use std::path::Path;

use serde_json::{Map, Value as Json};
use vibank::grade::{Responses, Row};

use super::{Failure, files};

/// The columns of a file with one row a part.
const COLUMNS: [&str; 4] = ["code", "question", "part", "response"];

/// What is read of a file.
#[derive(Default)]
struct Reading {
    responses: Responses,
    faults: Vec<String>,
}

/// The responses of a file, and what is wrong with single rows.
pub(crate) fn read(path: &Path) -> Result<(Responses, Vec<String>), Failure> {
    let bytes = files::read_bytes(path)?;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let mut reading = Reading::default();
    let is_json = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("json"));
    if is_json {
        reading.json(path, bytes)?;
    } else {
        reading.csv(path, bytes)?;
    }
    let errors = reading.responses.settle();
    reading
        .faults
        .extend(errors.iter().map(ToString::to_string));
    Ok((reading.responses, reading.faults))
}

impl Reading {
    fn add(&mut self, row: &Row<'_>) {
        let error = self.responses.add(row);
        self.faults.extend(error.map(|error| error.to_string()));
    }

    fn json(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        let entries: Vec<Json> = serde_json::from_slice(bytes).map_err(|error| {
            Failure::new(format!(
                "`{}` is no list of responses: {error}",
                path.display()
            ))
            .help("give an array of objects with `code`, `question`, `part` and `response`")
        })?;
        for (position, entry) in entries.iter().enumerate() {
            let number = position + 1;
            match entry.as_object() {
                Some(object) => self.object(number, object),
                None => self.faults.push(format!("entry {number} is no object")),
            }
        }
        Ok(())
    }

    /// One part, or one sheet with a key for each part.
    fn object(&mut self, number: usize, object: &Map<String, Json>) {
        let text = |name: &str| object.get(name).and_then(written);
        let Some(code) = text("code") else {
            self.faults.push(format!("entry {number} has no `code`"));
            return;
        };
        if object.contains_key("question") {
            let [question, part] = ["question", "part"].map(|name| text(name).unwrap_or_default());
            let row = Row {
                line: number,
                code: &code,
                question: &question,
                part: &part,
                response: &text("response").unwrap_or_default(),
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
enum Layout {
    /// One row a part: places of [`COLUMNS`].
    Parts([usize; 4]),
    /// One row a sheet: place of the code, and of each part.
    Sheets(usize, Vec<(usize, String, String)>),
}

impl Layout {
    fn of(names: &[String]) -> Option<Self> {
        let place = |name: &str| names.iter().position(|found| found == name);
        let places = COLUMNS.map(place);
        if let [Some(a), Some(b), Some(c), Some(d)] = places {
            return Some(Self::Parts([a, b, c, d]));
        }
        let part = |(at, name): (usize, &String)| {
            let (question, part) = part_column(name)?;
            Some((at, question.to_owned(), part.to_owned()))
        };
        let parts: Vec<_> = names.iter().enumerate().filter_map(part).collect();
        (!parts.is_empty()).then_some(Self::Sheets(places[0]?, parts))
    }

    /// The column of codes.
    fn code(&self) -> usize {
        match self {
            Self::Parts([code, ..]) | Self::Sheets(code, _) => *code,
        }
    }

    fn rows(&self, line: usize, fields: &[&str], take: &mut dyn FnMut(&Row<'_>)) {
        let field = |at: usize| fields.get(at).copied().unwrap_or_default();
        match self {
            Self::Parts([code, question, part, response]) => take(&Row {
                line,
                code: field(*code),
                question: field(*question),
                part: field(*part),
                response: field(*response),
            }),
            Self::Sheets(code, parts) => {
                for (at, question, part) in parts {
                    take(&Row {
                        line,
                        code: field(*code),
                        question,
                        part,
                        response: field(*at),
                    });
                }
            }
        }
    }
}

/// A column such as `2b`: question and part.
fn part_column(name: &str) -> Option<(&str, &str)> {
    let digits = name.find(|letter: char| !letter.is_ascii_digit())?;
    let (question, part) = name.split_at(digits);
    let is_part = !question.is_empty()
        && part.len() <= 2
        && part.bytes().all(|byte| byte.is_ascii_lowercase());
    is_part.then_some((question, part))
}
