//! Reports of course platforms: what students answered there to questions of this program.
//!
//! Columns as the platforms write them: Moodle's `quiz_last_responses_table` and `scormreport_interactions`, Canvas'
//! `StudentAnalysis`. Headings of Moodle are in the language of the site, so that its reports are known by how headings
//! and cells are built; which part a cell answers, the question says itself, as it was exported.

mod attempts;
mod cells;
mod moment;
mod options;
mod origin;
mod sheets;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;

pub(crate) use self::attempts::Which;
pub(crate) use self::sheets::{KnownQuestions, responses, taken};

use self::cells::decoded;
use self::moment::{Moment, moment};
use self::origin::{Interaction, QuestionOrigin};
use super::Failure;
use super::class_list::Places;
use super::table::{Table, TableRow};

/// The column of students with the numbers by which Canvas knows them.
pub(crate) const CANVAS_ID: &str = "canvas id";

/// What a report holds.
pub(crate) struct Report {
    /// Which report it is, as it is called in messages.
    name: &'static str,
    attempts: Vec<Attempt>,
    /// What could not be read, with lines.
    faults: Vec<String>,
    /// Columns with questions of others.
    foreign: BTreeSet<String>,
}

/// One attempt of one student.
struct Attempt {
    line: usize,
    student: BTreeMap<String, String>,
    moment: Option<Moment>,
    answers: Vec<ColumnAnswer>,
}

/// What was answered in one column.
struct ColumnAnswer {
    /// Its heading.
    column: String,
    asked: AnswerTarget,
    text: String,
    /// The share of the points that the page of a package reported for it.
    result: Option<f64>,
    /// Why the cell does not hold what was typed.
    spoilt: Option<String>,
}

/// What an answer belongs to.
enum AnswerTarget {
    Boxes(QuestionOrigin),
    Interaction(Interaction),
}

/// Where in a report the answers are.
enum ReportLayout {
    /// The headings are the texts of the questions; the points follow in the next column.
    Headings(Vec<(usize, QuestionOrigin)>),
    /// The columns of each question.
    Groups(Vec<QuestionColumns>),
}

/// Where a report has a question.
struct QuestionColumns {
    question: usize,
    response: usize,
    /// What a package says that the response is worth.
    result: Option<usize>,
}

impl Report {
    /// The report in a table, if it is one of a platform.
    pub(crate) fn of(path: &Path, table: &Table) -> Result<Option<Self>, Failure> {
        let canvas: Vec<usize> = (0..table.headings.len())
            .filter(|at| is_canvas(table, *at))
            .collect();
        let mut foreign = BTreeSet::new();
        let (name, layout, first) = if let Some(first) = canvas.first() {
            let found: Vec<(usize, QuestionOrigin)> = canvas
                .iter()
                .filter_map(|at| Some((*at, QuestionOrigin::read(&decoded(&table.headings[*at]))?)))
                .collect();
            let others = canvas
                .iter()
                .filter(|at| found.iter().all(|(own, _)| own != *at));
            foreign.extend(others.map(|at| shown(&table.headings[*at])));
            ("student analysis", ReportLayout::Headings(found), *first)
        } else {
            let Some(groups) = groups(&table.headings) else {
                return Ok(None);
            };
            let first = groups[0].start;
            let questions = questions(path, table, &groups)?;
            let is_own = |group: &Range<usize>| {
                let mut own = questions.iter();
                own.any(|columns| group.contains(&columns.question))
            };
            let others = groups.iter().filter(|group| !is_own(group));
            foreign.extend(others.map(|group| table.headings[group.start].clone()));
            (
                "report of responses",
                ReportLayout::Groups(questions),
                first,
            )
        };
        let mut report = Self {
            name,
            attempts: Vec::new(),
            faults: Vec::new(),
            foreign,
        };
        let who = Who::of(path, table, first)?;
        let width = table.headings.len();
        for row in table.rows(&|row| row.cells.len() == width) {
            match row {
                Ok(row) => report.attempt(table, &layout, &who, &row),
                Err(broken) => report
                    .faults
                    .push(format!("{broken}; the attempt in it is not marked")),
            }
        }
        if report.attempts.is_empty() && report.faults.is_empty() {
            return Err(nothing(path, name));
        }
        Ok(Some(report))
    }

    /// How many rows could not be read.
    #[cfg(feature = "fuzzing")]
    pub(crate) fn faults(&self) -> usize {
        self.faults.len()
    }

    fn attempt(&mut self, table: &Table, layout: &ReportLayout, who: &Who, row: &TableRow<'_>) {
        let mut answers = Vec::new();
        let mut add = |at: usize, asked: AnswerTarget, result: Option<f64>| {
            let spoilt = table.spoilt(row.line, at).map(|spoilt| spoilt.to_string());
            answers.push(ColumnAnswer {
                column: shown(&table.headings[at]),
                asked,
                text: decoded(row.cell(at)).trim().to_owned(),
                result,
                spoilt,
            });
        };
        match layout {
            ReportLayout::Headings(columns) => {
                // Questions that were not drawn for this student have no points.
                let drawn = columns
                    .iter()
                    .filter(|(at, _)| !row.cell(at + 1).is_empty());
                drawn.for_each(|(at, origin)| {
                    add(*at, AnswerTarget::Boxes(origin.clone()), None);
                });
            }
            ReportLayout::Groups(questions) => {
                for columns in questions {
                    let question = columns.question;
                    match asked(row.cell(question)) {
                        Some(asked) => {
                            let result = columns.result.and_then(|at| result(row.cell(at)));
                            add(columns.response, asked, result);
                        }
                        None if matches!(row.cell(question), "" | "-") => {}
                        None => {
                            self.foreign.insert(table.headings[question].clone());
                        }
                    }
                }
            }
        }
        if answers.is_empty() {
            return;
        }
        self.attempts.push(Attempt {
            line: row.line,
            student: who.student(row),
            moment: who.moment(row),
            answers,
        });
    }
}

/// A heading in messages; those of Canvas are whole questions.
fn shown(heading: &str) -> String {
    heading.chars().take(40).collect()
}

/// What the text of a question, or the identity of an interaction, says.
fn asked(cell: &str) -> Option<AnswerTarget> {
    let text = decoded(cell);
    Interaction::read(&text)
        .map(AnswerTarget::Interaction)
        .or_else(|| QuestionOrigin::read(&text).map(AnswerTarget::Boxes))
}

fn nothing(path: &Path, name: &str) -> Failure {
    Failure::new(format!(
        "`{}` is a {name} without a question of this program",
        path.display()
    ))
    .help("in Moodle, tick the display of the question text before you download the report, then give the new file; each question of an export ends with a line such as `ch1/e1-… XM2-9SB-THF 1 a b`; a form of answers has a column `code`")
}

/// Whether a heading is `1234: text` of a question, followed by its points.
fn is_canvas(table: &Table, at: usize) -> bool {
    let number = table.headings[at]
        .split_once(": ")
        .map(|(number, _)| number);
    let points = table
        .headings
        .get(at + 1)
        .is_some_and(|next| next.parse::<f64>().is_ok());
    points
        && number.is_some_and(|number| {
            !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
        })
}

/// Columns whose headings end in the same number, `Question 1`, `Response 1`.
fn groups(headings: &[String]) -> Option<Vec<Range<usize>>> {
    let mut groups: Vec<Range<usize>> = Vec::new();
    let mut last = None;
    for (at, heading) in headings.iter().enumerate() {
        let own = number_of(heading);
        match groups.last_mut() {
            Some(group) if own.is_some() && own == last => group.end = at + 1,
            _ if own.is_some() => groups.push(at..at + 1),
            _ => {}
        }
        last = own;
    }
    let is_report = groups.iter().any(|group| group.len() > 1)
        || groups
            .iter()
            .any(|group| is_one_of(&headings[group.start], RESPONSES));
    (is_report && !groups.is_empty()).then_some(groups)
}

/// The number of a question at the end of a heading.
fn number_of(heading: &str) -> Option<String> {
    let name = heading.trim_end_matches(|char: char| char.is_ascii_digit());
    let is_numbered = name.len() < heading.len() && name.chars().any(char::is_alphabetic);
    // `Grade/10` is not a question.
    (is_numbered && !name.ends_with(['/', '.', ','])).then(|| heading[name.len()..].to_owned())
}

/// Words of headings of questions and responses, where a report has one column for each.
const RESPONSES: &[&str] = &[
    "question",
    "response",
    "frage",
    "antwort",
    "réponse",
    "pregunta",
    "respuesta",
    "domanda",
    "risposta",
    "resposta",
];

/// Words of headings of right answers and results, in the languages of most sites.
const RIGHT: &[&str] = &[
    "right",
    "correct",
    "result",
    "richtig",
    "ergebnis",
    "bonne",
    "résultat",
    "resultado",
    "corret",
    "risultat",
    "juist",
];

fn is_one_of(heading: &str, words: &[&str]) -> bool {
    let heading = heading.to_lowercase();
    words.iter().any(|word| heading.contains(word))
}

/// What the standard's word for the result of an interaction is worth; other words are none.
fn result(word: &str) -> Option<f64> {
    match word {
        "correct" => Some(1.0),
        "wrong" | "incorrect" => Some(0.0),
        _ => word.parse().ok(),
    }
}

/// In each group the column of the question, that of the response after it, and the last one if it has results.
fn questions(
    path: &Path,
    table: &Table,
    groups: &[Range<usize>],
) -> Result<Vec<QuestionColumns>, Failure> {
    let mut known = BTreeSet::new();
    for row in table.rows(&|_| false).flatten() {
        let columns = groups.iter().flat_map(Clone::clone);
        known.extend(columns.filter(|at| asked(row.cell(*at)).is_some()));
    }
    if known.is_empty() {
        return Err(nothing(path, "report of a platform"));
    }
    let mut found = Vec::new();
    for group in groups {
        let Some(question) = group.clone().find(|at| known.contains(at)) else {
            continue;
        };
        let response = question + 1;
        if !group.contains(&response) || is_one_of(&table.headings[response], RIGHT) {
            let heading = &table.headings[question];
            return Err(Failure::new(format!(
                "`{}` has a column `{heading}`, and none with the response to it",
                path.display()
            ))
            .help("tick the display of the response before you download the report; Moodle shows none for packages of SCORM 2004, only of 1.2"));
        }
        found.push(QuestionColumns {
            question,
            response,
            result: (group.end - 1 > response).then_some(group.end - 1),
        });
    }
    Ok(found)
}

/// The columns that say who answered, and when.
struct Who {
    headings: Vec<String>,
    places: Places,
    /// Whether a column has the identity.
    has_id: bool,
    /// A column with addresses of mail, where no other one says who it was.
    email: Option<usize>,
    /// The column of Canvas with the identities of the school.
    sis: Option<usize>,
    attempt: Option<usize>,
    date: Option<usize>,
}

impl Who {
    fn of(path: &Path, table: &Table, first: usize) -> Result<Self, Failure> {
        let rows: Vec<TableRow<'_>> = table.rows(&|_| false).flatten().collect();
        let filled = |at: usize| {
            let cells = rows.iter().map(move |row| row.cell(at));
            cells.filter(|cell| !matches!(*cell, "" | "-"))
        };
        let all = |at: usize, holds: &dyn Fn(&str) -> bool| {
            filled(at).next().is_some() && filled(at).all(holds)
        };
        let mut headings: Vec<String> = table.headings[..first].to_vec();
        let named = |name: &str| {
            let mut own = headings.iter();
            own.position(|heading| heading.to_lowercase().replace([' ', '_'], "") == name)
        };
        let sis = named("sisid");
        let attempt = [
            "attempt",
            "versuch",
            "tentative",
            "intento",
            "tentativo",
            "tentativa",
            "poging",
        ]
        .iter()
        .find_map(|name| named(name))
        .filter(|at| all(*at, &|cell| cell.parse::<u32>().is_ok()));
        let date = (0..first).find(|at| all(*at, &|cell| moment(cell).is_some()));
        let email = (0..first).find(|at| all(*at, &|cell| cell.contains('@')));
        // Stands for a column that the report does not have.
        headings.push("id".to_owned());
        let own = Places::of(&headings[..first], &vibank::worksheet::Columns::default());
        let (places, has_id) = match own {
            Ok(places) => (places, true),
            Err(_) => {
                let places = Places::of(&headings, &vibank::worksheet::Columns::default());
                let places = places.map_err(|error| {
                    Failure::new(format!("`{}` {error}", path.display()))
                        .help("give the report as the platform wrote it")
                })?;
                (places, false)
            }
        };
        Ok(Self {
            headings,
            places,
            has_id,
            email,
            sis,
            attempt,
            date,
        })
    }

    /// The student of a row, by the identity, else by the address, the name, the line.
    fn student(&self, row: &TableRow<'_>) -> BTreeMap<String, String> {
        let width = row.cells.len().min(self.headings.len() - 1);
        let own = TableRow {
            line: row.line,
            cells: row.cells[..width].to_vec(),
        };
        let mut columns = self.places.student(&self.headings, &own).columns;
        let mut id = if self.has_id {
            columns.get("id").cloned().unwrap_or_default()
        } else {
            String::new()
        };
        if let Some(sis) = self.sis.map(|at| row.cell(at)) {
            columns.insert(CANVAS_ID.to_owned(), std::mem::take(&mut id));
            id = if sis.is_empty() {
                columns[CANVAS_ID].clone()
            } else {
                sis.to_owned()
            };
        }
        if matches!(id.as_str(), "" | "-") {
            let email = self.email.map(|at| row.cell(at).to_owned());
            let name = columns.get("name").cloned();
            let given = [email, name]
                .into_iter()
                .flatten()
                .find(|own| !own.is_empty());
            id = given.unwrap_or_else(|| format!("line {}", row.line));
        }
        columns.insert("id".to_owned(), id);
        columns
    }

    fn moment(&self, row: &TableRow<'_>) -> Option<Moment> {
        match self.attempt.map(|at| row.cell(at).parse()) {
            Some(Ok(number)) => Some([number, 0, 0, 0, 0, 0]),
            _ => moment(row.cell(self.date?)),
        }
    }
}
