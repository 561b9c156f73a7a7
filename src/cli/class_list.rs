//! Class lists: a table with a row of headings, `id` and perhaps `name`, `group`, `room`, `seat`, `language`, and what is
//! granted to single students.

mod headings;

use std::collections::BTreeMap;
use std::path::Path;

use vibank::source::nearest;
use vibank::worksheet::{Columns, Student};

use self::headings::HeadingError;
pub(crate) use self::headings::Places;
use super::Failure;
use super::table::{RowFault, Table, TableRow};

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
    let headings = table.headings.len();
    let begins_row = |row: &TableRow<'_>| row.cells.len() == headings && headings > 1;
    for row in table.rows(&begins_row) {
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
        if let Some(first) = seen.insert(student.id.clone(), line) {
            let id = &student.id;
            return Err(fail(format!(
                ", line {line}: there are two students `{id}`, the first in line {first}"
            )));
        }
        students.push(student);
        if students.len() > MAX_STUDENTS {
            return Err(fail(format!(" has more than {MAX_STUDENTS} students")));
        }
    }
    if students.is_empty() {
        return Err(fail(" names no student".to_owned()));
    }
    Ok(students)
}

/// A row that cannot be read would lose a student.
fn refuse(fail: &dyn Fn(String) -> Failure, fault: &RowFault) -> Failure {
    let failure = fail(format!(", {fault}"));
    match fault {
        RowFault::Open { .. } => {
            failure.help("close it, or write `\"\"` for a quote inside of a cell")
        }
        RowFault::Wide { .. } | RowFault::Behind { .. } | RowFault::Unheaded { .. } => failure,
    }
}
