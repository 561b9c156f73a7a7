//! A part as it was handed out and answered, with what was decided about it.

use vibank::bank::Template;
use vibank::grade::Place;
use vibank::numerics::Rational;
use vibank::worksheet::{PartEntry, QuestionEntry};

use super::decisions::{Decision, Ruling};
use super::marking::Marker;
use super::undecided::AlikeAnswers;
use crate::cli::Failure;

/// A part as it was handed out and answered.
pub(crate) struct Answered<'a> {
    pub(crate) entry: &'a PartEntry,
    /// Its place in the item.
    pub(crate) place: usize,
    pub(crate) max: Rational,
    pub(crate) is_by_hand: bool,
    pub(crate) given: &'a str,
    /// Whether `given` is what the file holds, which does not say what was answered.
    is_open: bool,
    /// What was decided about it.
    pub(crate) ruling: Ruling<'a>,
    /// The line of the file that says it.
    pub(crate) line: Option<usize>,
}

impl<'a> Answered<'a> {
    /// What is marked.
    pub(crate) fn response(&self) -> &'a str {
        let read = self.ruling.settled.and_then(Decision::response);
        read.unwrap_or(if self.is_open { "" } else { self.given })
    }

    /// Whether a response was decided in place of what was handed in.
    pub(crate) fn is_read(&self) -> bool {
        let settled = self.ruling.settled;
        settled.is_some_and(|decision| decision.response().is_some())
    }

    /// Whether nobody has said yet what was answered.
    pub(crate) fn is_undecided(&self) -> bool {
        self.is_open
            && !self.ruling.settled.is_some_and(|decision| {
                decision.response().is_some() || decision.points().is_some()
            })
    }

    /// Whether somebody has typed an answer to it, or looked at it on this sheet.
    pub(crate) fn is_touched(&self) -> bool {
        !self.given.trim().is_empty() || self.is_open || self.ruling.is_own
    }

    /// The same without anything that was decided.
    pub(crate) fn plain(&self) -> Self {
        Self {
            ruling: Ruling::default(),
            ..*self
        }
    }
}

/// The parts of a question as they were handed out and answered.
pub(crate) fn parts<'q>(
    marker: &Marker<'q>,
    code: &str,
    question: &'q QuestionEntry,
    template: &Template,
) -> Result<Vec<Answered<'q>>, Failure> {
    let places = question.parts.iter().map(|entry| {
        template.place(&entry.id).ok_or_else(|| {
            let id = &entry.id;
            Failure::new(format!("`{}` has no part `{id}` any more", template.id))
        })
    });
    let places = places.collect::<Result<Vec<_>, _>>()?;
    let answered = question.parts.iter().zip(places).map(|(entry, place)| {
        let at = Place {
            code: code.to_owned(),
            question: question.number,
            part: entry.letter.clone(),
        };
        let given = marker.responses.given(&at);
        let ruling = if marker.decisions.is_empty() {
            Ruling::default()
        } else {
            let alike = AlikeAnswers::new(template.id.as_str(), &entry.id, given.text);
            marker.decisions.ruling(&at, &alike)
        };
        Answered {
            entry,
            place,
            max: exact(entry.points),
            is_by_hand: template.parts[place].answer.kind().is_by_hand(),
            given: given.text,
            is_open: given.is_open,
            ruling,
            line: given.line,
        }
    });
    Ok(answered.collect())
}

/// Points as the manifest states them: decimals, as they were handed out.
fn exact(points: f64) -> Rational {
    Rational::from_decimal(&points.to_string()).unwrap_or(Rational::ZERO)
}
