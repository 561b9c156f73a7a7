//! The table of keys as a workbook: a sheet in a row, a part in a column.
//!
//! While the run lasts, each row is a line of JSON in the draft, so that an interrupted run goes on after it.

use vibank::message::Language;
use vibank::scene::{Data, Scene};
use vibank::worksheet::{Sheet, headings};

use crate::cli::Failure;
use crate::cli::table::workbook::{self, Cell};

/// What a row says before its keys.
const HEAD: [&str; 4] = ["code", "student", "name", "group"];

/// The row of a sheet: its first cells, and each part with its key as it is printed.
type KeyRowCells = ([String; HEAD.len()], Vec<(String, String)>);

/// The line of a sheet.
pub(crate) fn line(sheet: &Sheet<'_>, language: Language) -> String {
    let student = sheet.student.as_ref();
    let own = |of: fn(&vibank::worksheet::Student) -> &String| {
        student.map(of).cloned().unwrap_or_default()
    };
    let first = [
        sheet.variant.to_string(),
        own(|student| &student.id),
        own(|student| &student.name),
        own(|student| &student.group),
    ];
    let mut keys = Vec::new();
    for question in &sheet.questions {
        let scene = Scene::of(&question.solution, Data::Both).spoken(language);
        let template = question.solution.template();
        let headings = headings(template, &question.parts);
        for (heading, place) in headings.iter().zip(&question.parts) {
            let key = match scene.key(*place) {
                Ok(Some(key)) => key.plain(),
                Ok(None) => "see the solution".to_owned(),
                Err(_) if template.parts[*place].answer.kind().is_by_hand() => "by hand".to_owned(),
                Err(_) => "–".to_owned(),
            };
            keys.push((format!("{}{}", question.number, heading.letter), key));
        }
    }
    let row: KeyRowCells = (first, keys);
    format!("{}\n", serde_json::json!(row))
}

/// The workbook of these lines.
pub(crate) fn bound(lines: &str) -> Result<Vec<u8>, Failure> {
    let rows: Vec<KeyRowCells> = lines
        .lines()
        .map(|line| {
            serde_json::from_str(line)
                .map_err(|error| Failure::new(format!("a draft of the run: {error}")))
        })
        .collect::<Result<_, _>>()?;
    // Sheets may ask different parts: in the order in which they come.
    let mut parts: Vec<&str> = Vec::new();
    let known: Vec<&(String, String)> = rows.iter().flat_map(|(_, keys)| keys).collect();
    for (part, _) in known {
        if !parts.contains(&part.as_str()) {
            parts.push(part);
        }
    }
    parts.sort_by_key(|part| (part.len(), *part));
    let head: Vec<String> = HEAD
        .into_iter()
        .chain(parts.iter().copied())
        .map(str::to_owned)
        .collect();
    let rows: Vec<Vec<Cell>> = rows
        .iter()
        .map(|(first, keys)| {
            first
                .iter()
                .map(Cell::text)
                .chain(parts.iter().map(|part| {
                    let found = keys.iter().find(|(own, _)| own == part);
                    Cell::text(found.map_or("", |(_, key)| key))
                }))
                .collect()
        })
        .collect();
    workbook::written("Keys", &head, &rows)
}
