//! Tables as the usual scanners of marked boxes write them, recognized by their headings.
//!
//! Auto Multiple Choice: `A:<key>`, the number of the copy, name and mark, then for each question its score and, where
//! boxes are exported as letters, `TICKED:<question>` (`AMC-perl/AMC/Export/CSV.pm`). OMRChecker: `file_id`, `input_path`,
//! `output_path`, `score`, then the labels of its template, usually `Roll` and `q1`, `q2`, … (`src/entry.py`). FormScanner:
//! the file, then `<group>.<question>`, between semicolons (`FormFileUtils.java`).
//!
//! A number, `q3`, is the third choice of the sheet; `2b` is that part.

use std::collections::BTreeMap;

use vibank::grade::{Responses, Row};
use vibank::seed::Variant;
use vibank::worksheet::{PartEntry, VariantEntry};

use super::responses::{begins_sheet, part_column};
use super::table::Table;

/// By what a row says whose it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Who {
    /// The code of a sheet.
    Code,
    /// The identity of a student.
    Student,
    /// The name of a picture, which is one of the two.
    Picture,
}

/// Headings that say whose a row is, in small letters; the first that is there counts.
const WHO: [(&str, Who); 17] = [
    ("code", Who::Code),
    ("sheet", Who::Code),
    ("variant", Who::Code),
    ("barcode", Who::Code),
    ("id", Who::Student),
    ("student", Who::Student),
    ("student id", Who::Student),
    ("student number", Who::Student),
    ("student_id", Who::Student),
    ("matriculation", Who::Student),
    ("matricula", Who::Student),
    ("roll", Who::Student),
    ("roll no", Who::Student),
    ("roll number", Who::Student),
    ("file_id", Who::Picture),
    ("file name", Who::Picture),
    ("filename", Who::Picture),
];

/// Headings that the reports of platforms have and scanners do not.
const OF_PLATFORMS: [&str; 3] = ["sis_id", "state", "response 1"];

/// What stands before the key of students, and before what was ticked.
const KEY: &str = "a:";
const TICKED: &str = "ticked:";

/// What stands before the number of a question.
const QUESTION: [&str; 4] = ["question", "quest", "item", "q"];

/// A column of the scanner's table that holds answers, and to what.
#[derive(Clone, Debug, PartialEq, Eq)]
enum AnswerColumn {
    /// The choice with this number on the sheet, from 1.
    Choice(usize),
    /// A part by its number and letter.
    Part(String, String),
}

/// A table of a scanner.
pub(crate) struct Scan {
    table: Table,
    who: Vec<(usize, Who)>,
    answers: Vec<(usize, AnswerColumn)>,
}

/// What is known of a sheet.
struct KnownSheet<'m> {
    code: &'m str,
    /// Its choices, in order, with the numbers of their questions.
    choices: Vec<(usize, &'m PartEntry)>,
}

impl Scan {
    /// A table as a scanner writes it, if it is one.
    pub(crate) fn of(table: Table) -> Result<Self, Box<Table>> {
        let names: Vec<String> = table
            .headings
            .iter()
            .map(|name| name.trim().to_lowercase())
            .collect();
        let places = names.iter().enumerate();
        let mut who: Vec<(usize, Who)> = WHO
            .iter()
            .filter_map(|(own, who)| Some((names.iter().position(|name| name == own)?, *who)))
            .collect();
        who.extend(
            places
                .clone()
                .filter(|(_, name)| name.starts_with(KEY))
                .map(|(at, _)| (at, Who::Student)),
        );
        // A picture says least.
        who.sort_by_key(|(at, who)| (*who == Who::Picture, *at));
        // Where what was ticked is there, the columns before it are scores.
        let are_ticked = names.iter().any(|name| name.starts_with(TICKED));
        let answers: Vec<(usize, AnswerColumn)> = places
            .filter(|(at, name)| {
                who.iter().all(|(own, _)| own != at) && name.starts_with(TICKED) == are_ticked
            })
            .filter_map(|(at, name)| Some((at, asked(name)?)))
            .collect();
        let is_foreign = names
            .iter()
            .any(|name| OF_PLATFORMS.contains(&name.as_str()));
        if who.is_empty() || answers.is_empty() || is_foreign {
            return Err(Box::new(table));
        }
        Ok(Self {
            table,
            who,
            answers,
        })
    }

    /// The responses to the sheets of a run, and what is wrong with single rows.
    pub(crate) fn taken(&self, sheets: &[VariantEntry]) -> (Responses, Vec<String>) {
        let known = RunSheets::of(sheets);
        let (mut responses, mut faults) = (Responses::default(), Vec::new());
        let code = self.who.iter().find(|(_, who)| *who == Who::Code);
        let code = code.map_or(usize::MAX, |(at, _)| *at);
        for row in self.table.rows(&|row| begins_sheet(row, code)) {
            let row = match row {
                Ok(row) => row,
                Err(broken) => {
                    faults.push(format!("{broken}; what it answers is not decided"));
                    continue;
                }
            };
            let line = row.line;
            let sheet = match known.find(&self.who, &|at| row.cell(at)) {
                Ok(sheet) => sheet,
                Err(why) => {
                    faults.push(format!("row {line}: {why}; its answers belong to nobody"));
                    continue;
                }
            };
            for (at, asked) in &self.answers {
                let response = boxes(row.cell(*at));
                let place = match asked {
                    AnswerColumn::Part(question, part) => Some((question.clone(), part.clone())),
                    AnswerColumn::Choice(number) => {
                        let choice = number.checked_sub(1).and_then(|at| sheet.choices.get(at));
                        choice.map(|(number, part)| (number.to_string(), part.letter.clone()))
                    }
                };
                let Some((question, part)) = place else {
                    if !response.is_empty() {
                        let (name, count) = (&self.table.headings[*at], sheet.choices.len());
                        faults.push(format!(
                            "row {line}: `{name}` has an answer, and the sheet {} has {count} choices",
                            sheet.code
                        ));
                    }
                    continue;
                };
                let error = responses.add(&Row {
                    line,
                    code: sheet.code,
                    question: &question,
                    part: &part,
                    response: &response,
                });
                faults.extend(error.map(|error| error.to_string()));
            }
        }
        let errors = responses.settle();
        faults.extend(errors.iter().map(ToString::to_string));
        (responses, faults)
    }

    #[cfg(feature = "fuzzing")]
    pub(crate) fn faults(&self) -> usize {
        self.taken(&[]).1.len()
    }
}

/// The sheets of a run, by code and student.
struct RunSheets<'m> {
    sheets: Vec<KnownSheet<'m>>,
    codes: BTreeMap<&'m str, usize>,
    students: BTreeMap<&'m str, Vec<usize>>,
}

impl<'m> RunSheets<'m> {
    fn of(entries: &'m [VariantEntry]) -> Self {
        let mut known = Self {
            sheets: Vec::new(),
            codes: BTreeMap::new(),
            students: BTreeMap::new(),
        };
        for (at, entry) in entries.iter().enumerate() {
            let choices = entry.questions.iter().flat_map(|question| {
                let parts = question.parts.iter();
                let parts = parts.filter(|part| !part.options.is_empty());
                parts.map(|part| (question.number, part))
            });
            known.codes.insert(&entry.code, at);
            let id = entry.student.as_ref().and_then(|student| student.get("id"));
            if let Some(id) = id {
                known.students.entry(id).or_default().push(at);
            }
            known.sheets.push(KnownSheet {
                code: &entry.code,
                choices: choices.collect(),
            });
        }
        known
    }

    /// The sheet of a row, by the first of its columns that says it.
    fn find<'r>(
        &self,
        who: &[(usize, Who)],
        cell: &dyn Fn(usize) -> &'r str,
    ) -> Result<&KnownSheet<'m>, String> {
        let mut tried = Vec::new();
        for (at, who) in who {
            let text = cell(*at).trim();
            let text = match who {
                // `scans/s17.png` is the sheet of s17.
                Who::Picture => stem(text),
                _ => text,
            };
            if text.is_empty() {
                continue;
            }
            let by_code = || {
                let code = text.parse::<Variant>().ok()?.to_string();
                self.codes.get(code.as_str()).map(|at| vec![*at])
            };
            let bare = text.trim_start_matches('0');
            let by_id = || {
                let found = self.students.get(text).or_else(|| {
                    // Boxes for a number have leading zeros.
                    let mut all = self.students.iter();
                    let same = all.find(|(id, _)| id.trim_start_matches('0') == bare);
                    same.map(|(_, sheets)| sheets)
                });
                found.cloned()
            };
            let found = match who {
                Who::Code => by_code(),
                Who::Student => by_id(),
                Who::Picture => by_code().or_else(by_id),
            };
            match found.as_deref() {
                Some([sheet]) => return Ok(&self.sheets[*sheet]),
                Some(_) => {
                    return Err(format!(
                        "the student `{text}` has several sheets, give their codes"
                    ));
                }
                None => tried.push(format!("`{text}`")),
            }
        }
        Err(if tried.is_empty() {
            "nothing says whose it is".to_owned()
        } else {
            format!("no sheet of {} was handed out", tried.join(" or "))
        })
    }
}

/// The name of a file without its folder and ending.
fn stem(path: &str) -> &str {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

/// What a heading asks for: `q3`, `Question 07`, `Group.q12`, `TICKED:2b`.
fn asked(heading: &str) -> Option<AnswerColumn> {
    let ticked = heading.strip_prefix(TICKED).map(str::trim);
    let name = ticked.unwrap_or(heading);
    // FormScanner puts the name of the group before that of the question.
    let name = name.rsplit('.').next().unwrap_or(name).trim();
    if let Some((question, part)) = part_column(name) {
        return Some(AnswerColumn::Part(question.to_owned(), part.to_owned()));
    }
    let stated = QUESTION.iter().find_map(|word| name.strip_prefix(word));
    let rest = stated.map(|rest| rest.trim_start_matches([' ', '_', '-', ':']));
    let rest = match (rest, ticked) {
        (Some(rest), _) => rest,
        // A bare number is one where its heading says that boxes are meant.
        (None, Some(_)) => name,
        (None, None) => return None,
    };
    if let Some((question, part)) = part_column(rest) {
        return Some(AnswerColumn::Part(question.to_owned(), part.to_owned()));
    }
    let number = rest.parse::<usize>().ok().filter(|number| *number > 0)?;
    Some(AnswerColumn::Choice(number))
}

/// What was ticked, as it is typed: `AC` and `A|C` are `a, c`. What are no letters stays as it is.
fn boxes(cell: &str) -> String {
    let cell = cell.trim();
    if !cell
        .chars()
        .all(|letter| letter.is_ascii_alphabetic() || "|,; ".contains(letter))
    {
        return cell.to_owned();
    }
    let letters = cell.chars().filter(char::is_ascii_alphabetic);
    let letters: Vec<String> = letters
        .map(|letter| letter.to_ascii_lowercase().to_string())
        .collect();
    letters.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_name_choices_by_their_number_or_parts() {
        let choice = |number| Some(AnswerColumn::Choice(number));
        assert_eq!(asked("q1"), choice(1));
        assert_eq!(asked("question007"), choice(7));
        assert_eq!(asked("block 1.question 12"), choice(12));
        assert_eq!(asked("ticked:q03"), choice(3));
        assert_eq!(asked("ticked:4"), choice(4));
        let part = Some(AnswerColumn::Part("2".to_owned(), "b".to_owned()));
        assert_eq!(asked("2b"), part);
        assert_eq!(asked("ticked:2b"), part);
        assert_eq!(asked("q2b"), part);
        for other in ["4", "score", "quality", "mark", "q0"] {
            assert_eq!(asked(other), None, "{other}");
        }
    }

    #[test]
    fn ticked_boxes_become_letters() {
        assert_eq!(
            ["AC", "A|C", "b", "", " D "].map(boxes),
            ["a, c", "a, c", "b", "", "d"]
        );
        assert_eq!(boxes("0;1;0"), "0;1;0");
    }
}
