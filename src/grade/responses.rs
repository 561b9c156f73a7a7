//! Rows of a response file, sorted out: one response for each part of each sheet.

use std::collections::BTreeMap;

/// A row as it was handed in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Line in its file, from 1.
    pub line: usize,
    /// Code of the sheet.
    pub code: String,
    /// Number of the question.
    pub question: String,
    /// Letter of the part.
    pub part: String,
    /// What was answered; empty is missing.
    pub response: String,
}

/// The place of an answer: code of the sheet, number of the question, letter of the part.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Code of the sheet, in capitals.
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
        "line {line}: part {question}{part} of sheet {code} was already answered differently in line {first}"
    )]
    Contradiction {
        /// Line in the file.
        line: usize,
        /// Line of the other row.
        first: usize,
        /// Code of the sheet.
        code: String,
        /// Number of the question.
        question: usize,
        /// Letter of the part.
        part: String,
    },
}

/// The response for each place. Of several rows for one place the last that is not empty counts if all
/// others are equal or empty; else none counts.
pub fn collect(rows: impl IntoIterator<Item = Row>) -> (BTreeMap<Place, String>, Vec<RowError>) {
    let mut found: BTreeMap<Place, (usize, Option<String>)> = BTreeMap::new();
    let mut errors = Vec::new();
    for row in rows {
        let Ok(question) = row.question.trim().parse::<usize>() else {
            errors.push(RowError::Question {
                line: row.line,
                found: row.question,
            });
            continue;
        };
        let code = row.code.trim().to_uppercase();
        let place = Place {
            code,
            question,
            part: row.part.trim().to_lowercase(),
        };
        let response = row.response.trim().to_owned();
        match found.get_mut(&place) {
            None => {
                found.insert(place, (row.line, Some(response)));
            }
            Some((_, None)) => {}
            Some((line, Some(earlier))) if earlier.is_empty() => {
                (*line, *earlier) = (row.line, response);
            }
            Some((_, Some(earlier))) if response.is_empty() || *earlier == response => {}
            Some((first, earlier)) => {
                *earlier = None;
                let Place {
                    code,
                    question,
                    part,
                } = place;
                errors.push(RowError::Contradiction {
                    line: row.line,
                    first: *first,
                    code,
                    question,
                    part,
                });
            }
        }
    }
    let kept = found
        .into_iter()
        .filter_map(|(place, (_, response))| Some((place, response?)));
    (kept.collect(), errors)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(line: usize, response: &str) -> Row {
        let (code, question, part) = ("ab3".to_owned(), "1".to_owned(), "A".to_owned());
        Row {
            line,
            code,
            question,
            part,
            response: response.to_owned(),
        }
    }

    #[test]
    fn equal_and_empty_rows_agree() {
        let (kept, errors) = collect([row(2, ""), row(3, "5 m"), row(4, " 5 m "), row(5, "")]);
        assert_eq!(kept.values().collect::<Vec<_>>(), ["5 m"]);
        assert!(errors.is_empty());
    }

    #[test]
    fn rows_that_contradict_each_other_count_not_at_all() {
        let (kept, errors) = collect([row(2, "5 m"), row(3, "6 m"), row(4, "5 m")]);
        assert!(kept.is_empty());
        assert_eq!(errors.len(), 1);
        assert!(
            errors[0].to_string().contains("line 3") && errors[0].to_string().contains("line 2")
        );
    }
}
