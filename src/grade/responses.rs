//! Rows of a response file, sorted out: one response for each part of each sheet.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::seed::Variant;

/// A row as it was handed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row<'a> {
    /// Line in its file, from 1.
    pub line: usize,
    /// Code of the sheet.
    pub code: &'a str,
    /// Number of the question.
    pub question: &'a str,
    /// Letter of the part.
    pub part: &'a str,
    /// What was answered; empty is missing.
    pub response: &'a str,
}

/// The place of an answer: code of the sheet, number of the question, letter of the part.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Code of the sheet, as it is printed.
    pub code: String,
    /// Number of the question.
    pub question: usize,
    /// Letter of the part, small.
    pub part: String,
}

/// What is wrong with a row.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RowError {
    /// The question is no number.
    #[error("line {line}: question `{found}` is not a number")]
    Question {
        /// Line in the file.
        line: usize,
        /// What stands there.
        found: String,
    },
    /// Rows that contradict each other.
    #[error(
        "line {line}: part {}{} of sheet {} was already answered differently in line {first}; which of them counts is not decided",
        .place.question, .place.part, .place.code
    )]
    Contradiction {
        /// Line in the file.
        line: usize,
        /// Line of the other row.
        first: usize,
        /// The part.
        place: Place,
    },
    /// A sheet, or a part of one, that was not handed out.
    #[error("line {line}: no part {}{} of a sheet {} was handed out{}", .place.question, .place.part, .place.code, if *.is_code { "" } else { " (the code is mistyped: its check character does not fit)" })]
    Unknown {
        /// Line in the file.
        line: usize,
        /// The part.
        place: Place,
        /// Whether the code of the sheet can be one.
        is_code: bool,
    },
}

/// What a file holds for a place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Given<'r> {
    /// What was answered; empty if that is nothing.
    pub text: &'r str,
    /// Whether something was answered, though the file does not say what: `text` is a line that could not be read, or
    /// answers that contradict each other.
    pub is_open: bool,
    /// The line of the row that counts, where there is one.
    pub line: Option<usize>,
}

/// The responses of a file, one for each place, held compactly.
///
/// Where something was answered and the file does not say what, the place is [open](Given::is_open): it is neither an
/// answer nor a missing one.
#[derive(Debug, Default)]
pub struct Responses {
    texts: String,
    rows: Vec<Kept>,
    /// Sheets with a row whose part is not known, and what that row holds.
    open_sheets: BTreeMap<String, String>,
}

/// A row with its texts in one string.
#[derive(Debug)]
struct Kept {
    line: usize,
    question: usize,
    code: Range<u32>,
    part: Range<u32>,
    response: Range<u32>,
    /// Whether it is not known what was answered.
    is_open: bool,
    is_claimed: bool,
}

impl Responses {
    /// Sorts out rows. Of several rows for one place the first that is not empty counts if all others are equal or
    /// empty; else the place is open. What is wrong is reported in the order of the lines.
    pub fn collect<'a>(rows: impl IntoIterator<Item = Row<'a>>) -> (Self, Vec<RowError>) {
        let mut all = Self::default();
        let mut errors: Vec<RowError> = rows.into_iter().filter_map(|row| all.add(&row)).collect();
        errors.extend(all.settle());
        (all, errors)
    }

    /// Adds a row; [`Self::settle`] has to follow the last one.
    pub fn add(&mut self, row: &Row<'_>) -> Option<RowError> {
        match question(row) {
            Some(question) => self.keep(row, question, false),
            None => {
                self.open_sheet(row);
                return Some(RowError::Question {
                    line: row.line,
                    found: row.question.to_owned(),
                });
            }
        }
        None
    }

    /// Notes a row that says that something was answered, but not what: its line could not be read. Where it does not
    /// even say in which part, all parts of its sheet that have no other row are open.
    pub fn add_open(&mut self, row: &Row<'_>) {
        match question(row) {
            Some(question) if !row.part.trim().is_empty() => self.keep(row, question, true),
            _ => self.open_sheet(row),
        }
    }

    fn keep(&mut self, row: &Row<'_>, question: usize, is_open: bool) {
        let kept = Kept {
            line: row.line,
            question,
            code: self.text(&code(row)),
            part: self.text(&row.part.trim().to_lowercase()),
            response: self.text(row.response.trim()),
            is_open,
            is_claimed: false,
        };
        self.rows.push(kept);
    }

    fn open_sheet(&mut self, row: &Row<'_>) {
        self.open_sheets
            .insert(code(row), row.response.trim().to_owned());
    }

    /// Leaves one row for each place, and reports which rows contradict each other, by line.
    pub fn settle(&mut self) -> Vec<RowError> {
        let mut rows = std::mem::take(&mut self.rows);
        rows.sort_by(|a, b| self.order(a, b).then(a.line.cmp(&b.line)));
        let (mut settled, mut errors) = (Vec::new(), Vec::new());
        let mut contradictions = Vec::new();
        for group in rows.chunk_by(|a, b| self.order(a, b).is_eq()) {
            let response = |row: &Kept| self.slice(&row.response);
            let mut answered = group
                .iter()
                .filter(|row| !row.is_open && !response(row).is_empty());
            let open = group.iter().find(|row| row.is_open);
            let first = answered.next().or(open).unwrap_or(&group[0]);
            let kept = Kept {
                code: first.code.clone(),
                part: first.part.clone(),
                response: first.response.clone(),
                ..*first
            };
            if let Some(other) = answered.find(|row| response(row) != response(first)) {
                contradictions.push((
                    settled.len(),
                    format!("{} | {}", response(first), response(other)),
                ));
                errors.push(RowError::Contradiction {
                    line: other.line,
                    first: first.line,
                    place: self.place(other),
                });
            }
            settled.push(kept);
        }
        for (at, both) in contradictions {
            settled[at].response = self.text(&both);
            settled[at].is_open = true;
        }
        self.rows = settled;
        errors.sort_by_key(|error| match error {
            RowError::Contradiction { line, .. } => *line,
            _ => 0,
        });
        errors
    }

    /// What the file holds for a place; nothing where nothing was handed in.
    pub fn given(&self, place: &Place) -> Given<'_> {
        match self.find(place) {
            Ok(found) => {
                let row = &self.rows[found];
                Given {
                    text: self.slice(&row.response),
                    is_open: row.is_open,
                    line: Some(row.line),
                }
            }
            Err(_) => self
                .open_sheets
                .get(&place.code)
                .map_or_else(Given::default, |text| Given {
                    text,
                    is_open: true,
                    line: None,
                }),
        }
    }

    /// The codes of the sheets that somebody answered.
    pub fn codes(&self) -> BTreeSet<&str> {
        let answered = self
            .rows
            .iter()
            .filter(|row| row.is_open || !row.response.is_empty());
        let open = self.open_sheets.keys().map(String::as_str);
        answered
            .map(|row| self.slice(&row.code))
            .chain(open)
            .collect()
    }

    /// How many answers the sheet of this code has.
    pub fn answers(&self, code: &str) -> usize {
        let begin = self
            .rows
            .partition_point(|row| self.slice(&row.code) < code);
        let own = self.rows[begin..].iter();
        let own = own.take_while(|row| self.slice(&row.code) == code);
        own.filter(|row| !row.response.is_empty()).count()
    }

    /// Notes that a place was handed out.
    pub fn claim(&mut self, place: &Place) {
        if let Ok(found) = self.find(place) {
            self.rows[found].is_claimed = true;
        }
    }

    /// The rows with a response that nobody claimed, by line; those of open places were reported before.
    pub fn unclaimed(&self) -> Vec<RowError> {
        let mut errors: Vec<(usize, RowError)> = self
            .rows
            .iter()
            .filter(|row| !row.is_claimed && !row.is_open && !row.response.is_empty())
            .map(|row| {
                let place = self.place(row);
                let is_code = place.code.parse::<Variant>().is_ok();
                let line = row.line;
                (
                    line,
                    RowError::Unknown {
                        line,
                        place,
                        is_code,
                    },
                )
            })
            .collect();
        errors.sort_by_key(|(line, _)| *line);
        errors.into_iter().map(|(_, error)| error).collect()
    }

    fn find(&self, place: &Place) -> Result<usize, usize> {
        self.rows.binary_search_by(|row| {
            let own = (self.slice(&row.code), row.question, self.slice(&row.part));
            own.cmp(&(&*place.code, place.question, &*place.part))
        })
    }

    fn order(&self, a: &Kept, b: &Kept) -> Ordering {
        let codes = self.slice(&a.code).cmp(self.slice(&b.code));
        codes
            .then(a.question.cmp(&b.question))
            .then_with(|| self.slice(&a.part).cmp(self.slice(&b.part)))
    }

    fn place(&self, row: &Kept) -> Place {
        Place {
            code: self.slice(&row.code).to_owned(),
            question: row.question,
            part: self.slice(&row.part).to_owned(),
        }
    }

    fn slice(&self, range: &Range<u32>) -> &str {
        &self.texts[range.start as usize..range.end as usize]
    }

    /// Keeps a text. Files are smaller than 4 GiB, so that 32 bits hold all places in them.
    fn text(&mut self, text: &str) -> Range<u32> {
        let start = self.texts.len() as u32;
        self.texts.push_str(text);
        start..self.texts.len() as u32
    }
}

/// The number of a row's question. Some spreadsheets write integers with a decimal.
fn question(row: &Row<'_>) -> Option<usize> {
    let number = row.question.trim();
    number.strip_suffix(".0").unwrap_or(number).parse().ok()
}

/// The code of a row's sheet as it is printed, where it is one.
fn code(row: &Row<'_>) -> String {
    let code = row.code.trim();
    match code.parse::<Variant>() {
        Ok(variant) => variant.to_string(),
        Err(_) => code.to_uppercase(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(line: usize, response: &str) -> Row<'_> {
        Row {
            line,
            code: "ab3",
            question: "1",
            part: "A",
            response,
        }
    }

    fn place() -> Place {
        Place {
            code: "AB3".to_owned(),
            question: 1,
            part: "a".to_owned(),
        }
    }

    /// What is held for the place, and whether it is open.
    fn given(kept: &Responses) -> (&str, bool) {
        let given = kept.given(&place());
        (given.text, given.is_open)
    }

    #[test]
    fn equal_and_empty_rows_agree() {
        let rows = [row(2, ""), row(3, "5 m"), row(4, " 5 m "), row(5, "")];
        let (kept, errors) = Responses::collect(rows);
        assert_eq!(given(&kept), ("5 m", false));
        assert_eq!(kept.given(&place()).line, Some(3));
        assert!(errors.is_empty());
    }

    #[test]
    fn rows_that_contradict_each_other_leave_their_place_open() {
        let (kept, errors) = Responses::collect([row(2, "5 m"), row(3, "6 m"), row(4, "5 m")]);
        assert_eq!(given(&kept), ("5 m | 6 m", true));
        assert_eq!(errors.len(), 1);
        let words = errors[0].to_string();
        assert!(
            words.contains("line 3") && words.contains("line 2"),
            "{words}"
        );
    }

    #[test]
    fn a_row_for_nothing_is_told_with_its_line() {
        let (mut kept, _) = Responses::collect([row(7, "5 m")]);
        let words = kept.unclaimed()[0].to_string();
        assert!(
            words.contains("line 7") && words.contains("mistyped"),
            "{words}"
        );
        kept.claim(&place());
        assert!(kept.unclaimed().is_empty());
    }

    #[test]
    fn a_line_that_cannot_be_read_leaves_its_place_open() {
        let mut kept = Responses::default();
        kept.add_open(&row(2, "\"5 m"));
        assert_eq!(kept.settle(), []);
        assert_eq!(given(&kept), ("\"5 m", true));
        assert_eq!(kept.unclaimed(), []);
        // Typed once more in a line of its own, it is known.
        kept.add(&row(3, "5 m"));
        assert_eq!(kept.settle(), []);
        assert_eq!(given(&kept), ("5 m", false));
    }

    #[test]
    fn a_row_without_its_part_leaves_what_has_no_row_open() {
        let shifted = Row {
            question: "Ann",
            ..row(2, "1")
        };
        let mut kept = Responses::default();
        assert!(kept.add(&shifted).is_some());
        kept.settle();
        assert_eq!(given(&kept), ("1", true));
        kept.add(&row(3, "5 m"));
        kept.settle();
        assert_eq!(given(&kept), ("5 m", false));
        let other = Place {
            code: "XY7".to_owned(),
            ..place()
        };
        assert_eq!(kept.given(&other), Given::default());
    }
}
