//! Response files: CSV with one row a part or one row a sheet, or JSON.

use std::path::Path;

use serde::Deserialize;
use vibank::grade::Row;

use super::{Failure, files};

/// The columns of a file with one row a part.
const COLUMNS: [&str; 4] = ["code", "question", "part", "response"];

/// The rows of a response file, and what is wrong with lines that cannot be read.
pub(crate) fn read(path: &Path) -> Result<(Vec<Row>, Vec<String>), Failure> {
    let bytes = files::read_bytes(path)?;
    if path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("json"))
    {
        return json(path, &bytes).map(|rows| (rows, Vec::new()));
    }
    csv(path, &bytes)
}

#[derive(Deserialize)]
struct Object {
    code: String,
    question: serde_json::Value,
    part: String,
    #[serde(default)]
    response: String,
}

fn json(path: &Path, bytes: &[u8]) -> Result<Vec<Row>, Failure> {
    let objects: Vec<Object> = serde_json::from_slice(bytes).map_err(|error| {
        Failure::new(format!(
            "`{}` is no list of responses: {error}",
            path.display()
        ))
        .help("give an array of objects with `code`, `question`, `part` and `response`")
    })?;
    let row = |(position, object): (usize, Object)| {
        let question = match object.question {
            serde_json::Value::String(text) => text,
            other => other.to_string(),
        };
        Row {
            line: position + 1,
            code: object.code,
            question,
            part: object.part,
            response: object.response,
        }
    };
    Ok(objects.into_iter().enumerate().map(row).collect())
}

fn csv(path: &Path, bytes: &[u8]) -> Result<(Vec<Row>, Vec<String>), Failure> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let delimiter = delimiter(bytes);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .flexible(true)
        .from_reader(bytes);
    let headers = reader
        .byte_headers()
        .map_err(|error| broken(path, &error))?
        .clone();
    let names: Vec<String> = headers
        .iter()
        .map(|name| String::from_utf8_lossy(name).trim().to_lowercase())
        .collect();
    let layout = Layout::of(&names).ok_or_else(|| {
        Failure::new(format!("`{}` has no columns of responses", path.display()))
            .help("the header needs `code`, `question`, `part`, `response`, or `code` and one column a part (`1a`, `1b`)")
    })?;
    let (mut rows, mut faults) = (Vec::new(), Vec::new());
    let mut record = csv::ByteRecord::new();
    loop {
        match reader.read_byte_record(&mut record) {
            Ok(false) => break,
            Ok(true) => {
                let line = record.position().map_or(0, csv::Position::line) as usize;
                match record
                    .iter()
                    .map(|field| std::str::from_utf8(field))
                    .collect::<Result<Vec<_>, _>>()
                {
                    Ok(fields) => layout.rows(line, &fields, &mut rows),
                    Err(_) => {
                        faults.push(format!("line {line}: not UTF-8; save the file as UTF-8"));
                    }
                }
            }
            Err(error) => return Err(broken(path, &error)),
        }
    }
    Ok((rows, faults))
}

fn broken(path: &Path, error: &csv::Error) -> Failure {
    Failure::new(format!("`{}` is no CSV: {error}", path.display()))
}

/// Spreadsheets write semicolons where the comma is the decimal sign.
fn delimiter(bytes: &[u8]) -> u8 {
    let header = bytes
        .split(|byte| *byte == b'\n')
        .next()
        .unwrap_or_default();
    let count = |sign: u8| header.iter().filter(|byte| **byte == sign).count();
    [b',', b';', b'\t']
        .into_iter()
        .max_by_key(|sign| (count(*sign), *sign == b','))
        .unwrap_or(b',')
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
        let parts: Vec<_> = names
            .iter()
            .enumerate()
            .filter_map(|(at, name)| part_column(at, name))
            .collect();
        (!parts.is_empty()).then_some(Self::Sheets(places[0]?, parts))
    }

    fn rows(&self, line: usize, fields: &[&str], rows: &mut Vec<Row>) {
        let field = |at: usize| fields.get(at).copied().unwrap_or_default().to_owned();
        match self {
            Self::Parts([code, question, part, response]) => rows.push(Row {
                line,
                code: field(*code),
                question: field(*question),
                part: field(*part),
                response: field(*response),
            }),
            Self::Sheets(code, parts) => {
                rows.extend(parts.iter().map(|(at, question, part)| Row {
                    line,
                    code: field(*code),
                    question: question.clone(),
                    part: part.clone(),
                    response: field(*at),
                }));
            }
        }
    }
}

/// A column such as `2b`: question and part.
fn part_column(at: usize, name: &str) -> Option<(usize, String, String)> {
    let digits = name.find(|letter: char| !letter.is_ascii_digit())?;
    let (question, part) = name.split_at(digits);
    let is_part = !question.is_empty()
        && part.len() <= 2
        && part.bytes().all(|byte| byte.is_ascii_lowercase());
    is_part.then(|| (at, question.to_owned(), part.to_owned()))
}
