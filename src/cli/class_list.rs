//! Class lists: CSV with a header, `id` and perhaps `name`, `group`, `seat`, `language`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use vibank::worksheet::Student;

use super::{Failure, files};

/// The students of a class list, in its order.
pub(crate) fn read(path: &Path) -> Result<Vec<Student>, Failure> {
    const MOST_STUDENTS: usize = 100_000;
    let text = files::read(path)?;
    let shown = path.display();
    let mut reader = csv::ReaderBuilder::new()
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let broken = |error: csv::Error| Failure::new(format!("`{shown}` is no CSV: {error}"));
    let headers: Vec<String> = reader
        .headers()
        .map_err(broken)?
        .iter()
        .map(str::to_lowercase)
        .collect();
    if !headers.iter().any(|name| name == "id") {
        return Err(Failure::new(format!("`{shown}` has no column `id`"))
            .help("the first line names the columns: id, name, group, seat, language"));
    }
    let mut students = Vec::new();
    let mut seen = BTreeSet::new();
    for record in reader.records() {
        let record = record.map_err(broken)?;
        let line = record.position().map_or(0, csv::Position::line);
        let columns: BTreeMap<String, String> = headers
            .iter()
            .cloned()
            .zip(record.iter().map(str::to_owned))
            .collect();
        let column = |name: &str| columns.get(name).cloned().unwrap_or_default();
        let id = column("id");
        if id.is_empty() {
            return Err(Failure::new(format!(
                "`{shown}`, line {line}: a student without `id`"
            )));
        }
        if !seen.insert(id.clone()) {
            return Err(Failure::new(format!(
                "`{shown}`, line {line}: there are two students `{id}`"
            )));
        }
        students.push(Student {
            id,
            name: column("name"),
            group: column("group"),
            seat: column("seat"),
            columns,
        });
        if students.len() > MOST_STUDENTS {
            return Err(Failure::new(format!(
                "`{shown}` has more than {MOST_STUDENTS} students"
            )));
        }
    }
    if students.is_empty() {
        return Err(Failure::new(format!("`{shown}` names no student")));
    }
    Ok(students)
}
