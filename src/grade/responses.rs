//! Rows of a response file, sorted out: one response for each part of each sheet.

use std::cmp::Ordering;
use std::collections::BTreeSet;
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
    #[error("line {line}: question `{found}` is no number")]
    Question {
        /// Line in the file.
        line: usize,
        /// What stands there.
        found: String,
    },
    /// Rows that contradict each other.
    #[error(
        "line {line}: part {}{} of sheet {} was already answered differently in line {first}; neither counts",
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

/// The responses of a file, one for each place, held compactly.
#[derive(Debug, Default)]
pub struct Responses {
    texts: String,
    rows: Vec<Kept>,
}

/// A row with its texts in one string.
#[derive(Debug)]
struct Kept {
    line: usize,
    question: usize,
    code: Range<u32>,
    part: Range<u32>,
    response: Range<u32>,
    is_claimed: bool,
}

impl Responses {
    /// Sorts out rows. Of several rows for one place the last that is not empty counts if all others are equal or
    /// empty; else none counts. What is wrong is told in the order of the lines.
    pub fn collect<'a>(rows: impl IntoIterator<Item = Row<'a>>) -> (Self, Vec<RowError>) {
        let mut all = Self::default();
        let mut errors: Vec<RowError> = rows.into_iter().filter_map(|row| all.add(&row)).collect();
        errors.extend(all.settle());
        (all, errors)
    }

    /// Adds a row; [`Self::settle`] has to follow the last one.
    pub fn add(&mut self, row: &Row<'_>) -> Option<RowError> {
        let line = row.line;
        // Some spreadsheets write whole numbers with a decimal.
        let number = row.question.trim();
        let Ok(question) = number.strip_suffix(".0").unwrap_or(number).parse() else {
            let found = row.question.to_owned();
            return Some(RowError::Question { line, found });
        };
        let code = row.code.trim();
        let code = match code.parse::<Variant>() {
            Ok(variant) => variant.to_string(),
            Err(_) => code.to_uppercase(),
        };
        let kept = Kept {
            line,
            question,
            code: self.text(&code),
            part: self.text(&row.part.trim().to_lowercase()),
            response: self.text(row.response.trim()),
            is_claimed: false,
        };
        self.rows.push(kept);
        None
    }

    /// Leaves one row for each place, and tells which rows contradict each other, by line.
    pub fn settle(&mut self) -> Vec<RowError> {
        let mut rows = std::mem::take(&mut self.rows);
        rows.sort_by(|a, b| self.order(a, b).then(a.line.cmp(&b.line)));
        let (mut settled, mut errors) = (Vec::new(), Vec::new());
        for group in rows.chunk_by(|a, b| self.order(a, b).is_eq()) {
            let response = |row: &Kept| self.slice(&row.response);
            let mut answered = group.iter().filter(|row| !response(row).is_empty());
            let first = answered.next().unwrap_or(&group[0]);
            match answered.find(|row| response(row) != response(first)) {
                Some(other) => errors.push(RowError::Contradiction {
                    line: other.line,
                    first: first.line,
                    place: self.place(other),
                }),
                None => settled.push(Kept {
                    code: first.code.clone(),
                    part: first.part.clone(),
                    response: first.response.clone(),
                    ..*first
                }),
            }
        }
        self.rows = settled;
        errors.sort_by_key(|error| match error {
            RowError::Contradiction { line, .. } => *line,
            _ => 0,
        });
        errors
    }

    /// The response at a place, if it has a row.
    pub fn get(&self, place: &Place) -> Option<&str> {
        let found = self.find(place).ok()?;
        Some(self.slice(&self.rows[found].response))
    }

    /// The codes of the sheets that somebody answered.
    pub fn codes(&self) -> BTreeSet<&str> {
        let answered = self.rows.iter().filter(|row| !row.response.is_empty());
        answered.map(|row| self.slice(&row.code)).collect()
    }

    /// Notes that a place was handed out.
    pub fn claim(&mut self, place: &Place) {
        if let Ok(found) = self.find(place) {
            self.rows[found].is_claimed = true;
        }
    }

    /// The rows with a response that nobody claimed, by line.
    pub fn unclaimed(&self) -> Vec<RowError> {
        let lost = |row: &&Kept| !row.is_claimed && !row.response.is_empty();
        let mut errors: Vec<(usize, RowError)> = self
            .rows
            .iter()
            .filter(lost)
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

    #[test]
    fn equal_and_empty_rows_agree() {
        let rows = [row(2, ""), row(3, "5 m"), row(4, " 5 m "), row(5, "")];
        let (kept, errors) = Responses::collect(rows);
        assert_eq!(kept.get(&place()), Some("5 m"));
        assert!(errors.is_empty());
    }

    #[test]
    fn rows_that_contradict_each_other_count_not_at_all() {
        let (kept, errors) = Responses::collect([row(2, "5 m"), row(3, "6 m"), row(4, "5 m")]);
        assert_eq!(kept.get(&place()), None);
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
}
