//! A part as it was handed out and answered, with what was decided about it.

use vibank::bank::Template;
use vibank::grade::Place;
use vibank::numerics::Rational;
use vibank::worksheet::{PartEntry, QuestionEntry};

use super::decisions::{Decision, Ruling};
use super::marking::Marker;
use super::undecided::Alike;
use crate::cli::Failure;

/// A part as it was handed out and answered.
pub(super) struct Answered<'a> {
    pub(super) entry: &'a PartEntry,
    /// Its place in the item.
    pub(super) place: usize,
    pub(super) max: Rational,
    pub(super) is_by_hand: bool,
    pub(super) given: &'a str,
    /// Whether `given` is what the file holds, which does not say what was answered.
    is_open: bool,
    /// What was decided about it.
    pub(super) ruling: Ruling<'a>,
    /// The line of the file that says it.
    pub(super) line: Option<usize>,
}

impl<'a> Answered<'a> {
    /// What is marked.
    pub(super) fn response(&self) -> &'a str {
        let read = self.ruling.settled.and_then(Decision::response);
        read.unwrap_or(if self.is_open { "" } else { self.given })
    }

    /// Whether a response was decided in place of what was handed in.
    pub(super) fn is_read(&self) -> bool {
        let settled = self.ruling.settled;
        settled.is_some_and(|decision| decision.response().is_some())
    }

    /// Whether nobody has said yet what was answered.
    pub(super) fn is_undecided(&self) -> bool {
        let is_settled =
            |decision: &Decision| decision.response().is_some() || decision.points().is_some();
        self.is_open && !self.ruling.settled.is_some_and(is_settled)
    }

    /// The same without anything that was decided.
    pub(super) fn plain(&self) -> Self {
        Self {
            ruling: Ruling::default(),
            ..*self
        }
    }
}

impl Marker<'_> {
    /// The parts of a question as they were handed out and answered.
    pub(super) fn answered<'q>(
        &'q self,
        code: &str,
        question: &'q QuestionEntry,
        template: &Template,
    ) -> Result<Vec<Answered<'q>>, Failure> {
        let place = |entry: &PartEntry| {
            let found = template.place(&entry.id);
            found.ok_or_else(|| {
                let id = &entry.id;
                Failure::new(format!("`{}` has no part `{id}` any more", template.id))
            })
        };
        let places = question
            .parts
            .iter()
            .map(place)
            .collect::<Result<Vec<_>, _>>()?;
        let parts = question.parts.iter().zip(places);
        let answered = parts.map(|(entry, place)| {
            let at = Place {
                code: code.to_owned(),
                question: question.number,
                part: entry.letter.clone(),
            };
            let open = self.responses.open(&at);
            let given = open.or_else(|| self.responses.get(&at)).unwrap_or_default();
            let alike = Alike::new(template.id.as_str(), &entry.id, given);
            Answered {
                entry,
                place,
                max: exact(entry.points),
                is_by_hand: template.parts[place].answer.kind().is_by_hand(),
                given,
                is_open: open.is_some(),
                ruling: self.decisions.ruling(&at, &alike),
                line: self.responses.line(&at),
            }
        });
        Ok(answered.collect())
    }
}

/// Points as the manifest states them: decimals, as they were handed out.
fn exact(points: f64) -> Rational {
    Rational::from_decimal(&points.to_string()).unwrap_or(Rational::ZERO)
}
