//! Class lists: a table with a row of headings, `id` and perhaps `name`, `group`, `room`, `seat`, `language`, and what is
//! granted to single students.

mod headings;
mod notes;

use std::collections::BTreeMap;
use std::path::Path;

use vibank::source::nearest;
use vibank::worksheet::{Columns, Student};

use self::headings::HeadingError;
pub(crate) use self::headings::Places;
use super::Failure;
use super::table::{RowFault, Table};

/// The students of a class list, in its order.
pub(crate) fn read(path: &Path, columns: &Columns) -> Result<Vec<Student>, Failure> {
    // Far above any course: it bounds what a wrong file can cost.
    const MAX_STUDENTS: usize = 100_000;
    let shown = path.display();
    let fail = |what: String| Failure::new(format!("`{shown}`{what}"));
    let table = Table::read(path)?;
    let places = Places::of(&table.headings, columns).map_err(|error| {
        let found = table.headings.join("`, `");
        let near = match &error {
            HeadingError::Missing(heading) => {
                nearest(heading, table.headings.iter().map(String::as_str))
            }
            _ => None,
        };
        let near = near.map_or_else(String::new, |near| format!("did you mean `{near}`? "));
        fail(format!(" {error}")).help(format!(
            "{near}its headings are `{found}`; say in the blueprint which is which: columns = {{ id = \"…\", name = [\"…\", \"…\"] }}"
        ))
    })?;
    if let Some(doubt) = &table.doubt {
        eprintln!("{doubt}");
    }
    let mut students = Vec::new();
    let mut seen = BTreeMap::new();
    let mut notes = notes::Notes::default();
    let headings = table.headings.len();
    for row in table.rows(&|row| row.cells.len() == headings && headings > 1) {
        let row = row.map_err(|broken| refuse(&fail, &broken.fault))?;
        let line = row.line;
        let mut used = places.columns();
        if let Some((at, spoilt)) = used.find_map(|at| Some((at, table.spoilt(line, at)?))) {
            let heading = &table.headings[at];
            return Err(fail(format!(", row {line}, column `{heading}`: {spoilt}"))
                .help("format the column as text, and type it again"));
        }
        let mut student = places.student(&table.headings, &row);
        let large = student
            .columns
            .get("large_print")
            .map_or("", String::as_str);
        student.type_size = Student::read_type_size(large).map_err(|error| {
            fail(format!(", line {line}: {error}")).help(
                "give large print as a number of points from 8 to 36, or as `yes` for 18 points",
            )
        })?;
        if student.id.is_empty() {
            let width = row.cells.join(" ");
            return Err(fail(format!(", line {line}: a student without `id`"))
                .help(format!("give `{}` one, or remove the line", width.trim())));
        }
        if let Some(fault) = long_cell(&student) {
            return Err(fail(format!(", line {line}: {fault}"))
                .help("shorten it, or look for a quote or a line break that is missing there"));
        }
        if is_rounded(&student.id) {
            let id = &student.id;
            return Err(fail(format!(
                ", line {line}: the `id` is `{id}`, which a spreadsheet has made of a long number"
            ))
            .help(
                "format the column as text, and type the ids again: their last digits are lost",
            ));
        }
        if let Some(first) = seen.insert(student.id.clone(), line) {
            let id = &student.id;
            return Err(fail(format!(
                ", line {line}: there are two students `{id}`, the first in line {first}"
            ))
            .help("give one of them another `id`, or remove one of the lines"));
        }
        notes.look_at(&student, line);
        students.push(student);
        if students.len() > MAX_STUDENTS {
            return Err(fail(format!(" has more than {MAX_STUDENTS} students")));
        }
    }
    if students.is_empty() {
        return Err(fail(" names no student".to_owned())
            .help("give it a row for each student, below the row of headings"));
    }
    notes.print(&shown.to_string());
    Ok(students)
}

/// A cell that is longer than what it should hold, which stands on each page of a sheet.
fn long_cell(student: &Student) -> Option<String> {
    /// Most letters of an `id`.
    const MAX_ID: usize = 100;
    /// Most letters of a name and of what else is printed.
    const MAX_NAME: usize = 300;
    let cells = [
        ("id", &student.id, MAX_ID),
        ("name", &student.name, MAX_NAME),
        ("group", &student.group, MAX_NAME),
        ("room", &student.room, MAX_NAME),
        ("seat", &student.seat, MAX_NAME),
        ("extra_time", &student.extra_time, MAX_NAME),
    ];
    cells.into_iter().find_map(|(name, cell, most)| {
        let letters = cell.chars().count();
        (letters > most).then(|| format!("`{name}` has {letters} letters, at most {most} are read"))
    })
}

/// Whether an `id` is what a spreadsheet shows of a number that is too long for its cell, `1.23E+11`.
fn is_rounded(id: &str) -> bool {
    let Some((number, exponent)) = id.split_once("E+") else {
        return false;
    };
    number.starts_with(|char: char| char.is_ascii_digit())
        && number
            .chars()
            .all(|char| char.is_ascii_digit() || matches!(char, '.' | ','))
        && exponent.len() == 2
        && exponent.bytes().all(|byte| byte.is_ascii_digit())
}

/// A row that cannot be read would lose a student.
fn refuse(fail: &dyn Fn(String) -> Failure, fault: &RowFault) -> Failure {
    let failure = fail(format!(", {fault}"));
    match fault {
        RowFault::Open { .. } => {
            failure.help("close it, or write `\"\"` for a quote inside of a cell")
        }
        RowFault::Wide { .. }
        | RowFault::Behind { .. }
        | RowFault::Unheaded { .. }
        | RowFault::Nameless { .. } => failure,
    }
}
