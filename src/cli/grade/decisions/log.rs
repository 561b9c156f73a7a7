//! What decisions have changed: each with the marks before and after it.

use vibank::grade;
use vibank::output::{Decided, DecidedMark};

use super::Decisions;
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::grade::outcome::{SheetOutcome, Standing};
use crate::cli::table::Dialect;

/// The marks that decisions have changed, by the numbers of these.
#[derive(Debug, Default)]
pub(crate) struct Log {
    changed: Vec<Vec<DecidedMark>>,
}

/// The columns of `decisions.csv`.
const COLUMNS: [&str; 13] = [
    "decision",
    "about",
    "decided",
    "who",
    "why",
    "code",
    "student",
    "question",
    "part",
    "points before",
    "max before",
    "points",
    "max",
];

impl Log {
    /// Notes the marks of a sheet that are others without the decisions.
    pub(crate) fn add(&mut self, sheet: &SheetOutcome) {
        for part in &sheet.parts {
            let Some(before) = &part.before else {
                continue;
            };
            let [points_before, points] = [before, &Standing::of(part)].map(Standing::shown);
            let mark = DecidedMark {
                code: sheet.code.clone(),
                student: sheet.column("id").to_owned(),
                question: part.question,
                letter: part.letter.clone(),
                points_before,
                max_before: grade::rounded(before.max.0),
                points,
                max: grade::rounded(part.max.0),
            };
            for number in &part.decisions {
                if self.changed.len() <= *number {
                    self.changed.resize_with(*number + 1, Vec::new);
                }
                self.changed[*number].push(mark.clone());
            }
        }
    }

    /// Each decision with the marks that it has changed.
    pub(crate) fn decided(self, decisions: &Decisions) -> Vec<Decided> {
        let mut changed = self.changed.into_iter();
        let decided = decisions.all.iter().map(|decision| Decided {
            place: decision.place.clone(),
            subject: decision.subject.clone(),
            words: decision.words.clone(),
            who: decision.who.clone(),
            why: decision.why.clone(),
            changed: changed.next().unwrap_or_default(),
        });
        decided.collect()
    }
}

/// Writes `decisions.csv`: a row for each mark that a decision has changed, or for the decision alone.
pub(crate) fn write(decided: &[Decided], out: &Folder, dialect: Dialect) -> Result<(), Failure> {
    let mut table = dialect.head(&COLUMNS)?;
    for own in decided {
        let head = [&own.place, &own.subject, &own.words, &own.who, &own.why];
        let head = head.map(String::as_str);
        let mut row = |rest: [&str; 8]| {
            let row: Vec<&str> = head.into_iter().chain(rest).collect();
            table.extend(dialect.line(&row)?);
            Ok::<_, Failure>(())
        };
        if own.changed.is_empty() {
            row([""; 8])?;
        }
        for mark in &own.changed {
            let points = [
                &mark.points_before,
                &mark.max_before,
                &mark.points,
                &mark.max,
            ];
            let [a, b, c, d] = points.map(|points| dialect.number(points));
            let question = mark.question.to_string();
            row([
                &mark.code,
                &mark.student,
                &question,
                &mark.letter,
                &a,
                &b,
                &c,
                &d,
            ])?;
        }
    }
    out.write("decisions.csv", &table).map(drop)
}
