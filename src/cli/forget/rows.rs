//! The rows of a student in tables of answers and marks.

use serde_json::Value;
use vibank::output::WRITERS;
use vibank::worksheet::Csv;

use super::Task;
use super::trace::Person;
use crate::cli::folder::Folder;
use crate::cli::record::FORM;
use crate::cli::sheet::PRINTS;
use crate::cli::table::{Dialect, Edit, Table, TableRow};
use crate::cli::{Failure, files, grade};

/// The tables of a run and of its marks.
const TABLES: [&str; 5] = [
    FORM,
    "marks.csv",
    "details.csv",
    "changes.csv",
    "unreadable.csv",
];

/// Pages about all, which `vibank sheet` and `vibank grade` make again, beside those on fairness.
const OVERVIEWS: [&str; 3] = ["report.html", "report.json", "report.csv"];

/// Tables that are packed, which `vibank sheet` and `vibank grade` make again: they are removed as a whole, as is what is
/// for the printer.
const PACKED: [&str; 2] = ["key-table.xlsx", "marks.xlsx"];

/// Between those who gave the same answer.
const BETWEEN: &str = "; ";

/// Removes the rows of the student from tables.
pub(crate) fn remove(task: &mut Task, folder: &Folder, inside: &str) -> Result<(), Failure> {
    for name in TABLES {
        let name = format!("{inside}{name}");
        if !folder.has(&name) {
            continue;
        }
        let path = folder.path(&name)?;
        let before = files::digest_of(&path)?;
        let table = Table::read(&path)?;
        let place = |heading: &str| {
            let mut headings = table.headings.iter();
            headings.position(|own| own.eq_ignore_ascii_case(heading))
        };
        let places = Places {
            code: place("code"),
            student: place("student"),
            name: place("name"),
            times: place("times"),
        };
        let (text, count) = table.edited(&mut |row| edit(&task.person, row, &places, &table))?;
        if count == 0 {
            continue;
        }
        let mark = if table.has_mark { "\u{feff}" } else { "" };
        let text = format!("{mark}{text}");
        task.write(folder, &name, text.as_bytes())?;
        if name == FORM {
            task.form = Some((before, files::digest(text.as_bytes())));
        }
        task.note(count, ["row", "rows"], &name);
    }
    let results = format!("{inside}results.json");
    if folder.has(&results) {
        remove_results(task, folder, &results)?;
    }
    Ok(())
}

/// What becomes of a row.
fn edit(
    person: &Person,
    row: &TableRow<'_>,
    places: &Places,
    table: &Table,
) -> Result<Edit, Failure> {
    let cell = |place: Option<usize>| place.map_or("", |at| row.cell(at));
    let (code, student) = (cell(places.code), cell(places.student));
    if person.is_own(code, student) {
        return Ok(Edit::Drop);
    }
    let Some(id) = &person.id else {
        return Ok(Edit::Keep);
    };
    // Like answers of several students are in one row.
    let students: Vec<&str> = student.split(BETWEEN).collect();
    let Some(at) = students.iter().position(|own| own == id) else {
        return Ok(Edit::Keep);
    };
    let mut cells: Vec<String> = row.cells.iter().map(|cell| cell.to_string()).collect();
    let mut put = |place: Option<usize>, text: String| {
        if let Some(cell) = place.and_then(|at| cells.get_mut(at)) {
            *cell = text;
        }
    };
    let names: Vec<&str> = cell(places.name).split(BETWEEN).collect();
    let is_paired = names.len() == students.len();
    let names = names
        .iter()
        .enumerate()
        .filter(|(own, name)| !(is_paired && *own == at || !is_paired && person.is_named(name)));
    let names: Vec<&str> = names.map(|(_, name)| *name).collect();
    put(places.name, names.join(BETWEEN));
    let students = students.iter().filter(|own| *own != id);
    put(
        places.student,
        students.copied().collect::<Vec<_>>().join(BETWEEN),
    );
    if let Ok(count) = cell(places.times).parse::<usize>() {
        put(places.times, count.saturating_sub(1).to_string());
    }
    let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
    let csv = if table.delimiter() == Some(b';') {
        Csv::Excel
    } else {
        Csv::Plain
    };
    let line = Dialect::new(csv, '.').line(&cells)?;
    Ok(Edit::Replace(String::from_utf8_lossy(&line).into_owned()))
}

/// Removes entries of the marks for programs, which are in one line each.
fn remove_results(task: &mut Task, folder: &Folder, name: &str) -> Result<(), Failure> {
    let path = folder.path(name)?;
    let text = files::read(&path)?;
    let entries: Vec<Value> = serde_json::from_str(&text).map_err(|error| {
        Failure::new(format!("`{}` holds no marks: {error}", path.display()))
            .help("give the folder that `vibank grade` wrote")
    })?;
    let before = entries.len();
    let field = |entry: &Value, name: &str| entry[name].as_str().unwrap_or_default().to_owned();
    let others = entries.iter().filter(|entry| {
        !task
            .person
            .is_own(&field(entry, "code"), &field(entry, "student"))
    });
    let lines: Vec<String> = others.map(ToString::to_string).collect();
    let count = before - lines.len();
    if count > 0 {
        let text = format!("[\n{}\n]\n", lines.join(",\n"));
        task.write(folder, name, text.as_bytes())?;
        task.note(count, ["entry", "entries"], name);
    }
    Ok(())
}

/// Removes pages about all that tell of the student.
pub(crate) fn remove_overviews(
    task: &mut Task,
    folder: &Folder,
    inside: &str,
) -> Result<(), Failure> {
    // And what is left of a grading that was interrupted, or of which parts are not joined.
    let names = folder.names(inside.trim_end_matches('/')).into_iter();
    let marked = names.filter(|name| grade::is_journal(name) || grade::is_part(name));
    let endings = WRITERS.iter().map(|writer| writer.extension());
    let overviews = endings
        .map(|ending| format!("fairness.{ending}"))
        .chain(OVERVIEWS.map(str::to_owned));
    for name in overviews.chain(marked) {
        let name = format!("{inside}{name}");
        if folder.has(&name) {
            let bytes = files::read_bytes(&folder.path(&name)?)?;
            if task
                .person
                .trace(&String::from_utf8_lossy(&bytes))
                .is_some()
            {
                task.remove(folder, &name)?;
            }
        }
    }
    let packed = PACKED.map(str::to_owned).into_iter();
    let prints = folder.names(&format!("{inside}{PRINTS}")).into_iter();
    for name in packed.chain(prints.map(|name| format!("{PRINTS}/{name}"))) {
        let name = format!("{inside}{name}");
        if folder.has(&name) {
            task.remove(folder, &name)?;
        }
    }
    let feedback = format!("{inside}feedback");
    for file in folder.names(&feedback) {
        let code = file.split('.').next().unwrap_or_default();
        if task.person.codes.contains(code) {
            task.remove(folder, &format!("{feedback}/{file}"))?;
        }
    }
    Ok(())
}

/// Where a table has what tells of a student.
struct Places {
    code: Option<usize>,
    student: Option<usize>,
    name: Option<usize>,
    times: Option<usize>,
}
