//! What nobody has decided yet: answers that could not be read, like ones together, so that one decision settles all.

use std::collections::BTreeMap;

use vibank::answer::Verdict;
use vibank::output::{Lost, LostSheet};

use super::outcome::{PartOutcome, SheetOutcome};
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::table::Dialect;

/// The columns of `unreadable.csv`; the last three are for the teacher, see `overrides`.
const COLUMNS: [&str; 13] = [
    "code", "student", "name", "question", "part", "item", "id", "given", "times", "why",
    "response", "points", "feedback",
];

/// The same words to the same part of an item, whatever the data of the sheet are.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct AlikeAnswers {
    pub(crate) item: String,
    pub(crate) id: String,
    given: String,
}

impl AlikeAnswers {
    /// Blanks do not count, nor does the apostrophe that keeps a spreadsheet from running a cell.
    pub(crate) fn new(item: &str, id: &str, given: &str) -> Self {
        let given = match given.strip_prefix('\'') {
            Some(rest) if rest.starts_with(['=', '+', '-', '@']) => rest,
            _ => given,
        };
        Self {
            item: item.to_owned(),
            id: id.to_owned(),
            given: given.split_whitespace().collect::<Vec<_>>().join(" "),
        }
    }

    pub(crate) fn of(part: &PartOutcome) -> Self {
        Self::new(&part.item, &part.id, &part.response)
    }
}

/// The answers that could not be read, in the order in which the first of them came.
#[derive(Debug, Default)]
pub(crate) struct Undecided {
    places: BTreeMap<AlikeAnswers, usize>,
    groups: Vec<Lost>,
}

impl Undecided {
    /// Adds those of a sheet.
    pub(crate) fn add(&mut self, sheet: &SheetOutcome) {
        let lost = sheet.parts.iter();
        for part in lost.filter(|part| part.verdict == Verdict::Unreadable) {
            let new = self.groups.len();
            // What a person marks is not alike for having no points yet.
            let place = if part.by_hand {
                new
            } else {
                *self.places.entry(AlikeAnswers::of(part)).or_insert(new)
            };
            if place == new {
                self.groups.push(Lost {
                    question: part.question,
                    letter: part.letter.clone(),
                    item: part.item.clone(),
                    id: part.id.clone(),
                    response: part.response.clone(),
                    why: part.feedback.clone(),
                    by_hand: part.by_hand,
                    sheets: Vec::new(),
                });
            }
            self.groups[place].sheets.push(LostSheet {
                code: sheet.code.clone(),
                student: sheet.column("id").to_owned(),
                name: sheet.column("name").to_owned(),
            });
        }
    }

    /// Those that were given most often first.
    pub(crate) fn groups(mut self) -> Vec<Lost> {
        self.groups
            .sort_by_key(|group| std::cmp::Reverse(group.sheets.len()));
        self.groups
    }
}

/// Writes them to be settled, with a row for each decision.
pub(crate) fn write(groups: &[Lost], out: &Folder, dialect: Dialect) -> Result<(), Failure> {
    let mut table = dialect.head(&COLUMNS)?;
    for group in groups {
        let joined = |word: fn(&LostSheet) -> &str| {
            let words = group.sheets.iter().map(word);
            let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
            words.join("; ")
        };
        let code = match group.sheets.as_slice() {
            [one] => &one.code,
            _ => super::decisions::ALL,
        };
        table.extend(dialect.line(&[
            code,
            &joined(|sheet| &sheet.student),
            &joined(|sheet| &sheet.name),
            &group.question.to_string(),
            &group.letter,
            &group.item,
            &group.id,
            &group.response,
            &group.sheets.len().to_string(),
            &group.why,
            "",
            "",
            "",
        ])?);
    }
    out.write("unreadable.csv", &table).map(drop)
}
