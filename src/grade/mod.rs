//! Grading: responses to the parts of an instance, marked, with credit and feedback.
//!
//! [`Grade::mark`] marks all responses of an instance together, so that a part can be marked by the student's own
//! earlier answers. Marks are exact fractions of points and are rounded once, where they are printed.

mod among;
mod bound;
mod feedback;
mod follow;
mod form;
mod pattern;
mod points;
pub mod request;
mod responses;
mod silence;
mod typed;

pub use among::mark_among;
pub use feedback::{Comment, Feedback, PartFeedback, QuestionFeedback, remarks};
pub use pattern::pattern;
pub use points::{of_marking, rounded, standing};
pub use responses::{Given, Place, Responses, Row, RowError};

use crate::answer::{AnswerKind, Credit, Echo, Marker, Marking, Naming, Unreadable, Verdict, Why};
use crate::response::{Folded, Passage, Reworded, withdrawn};
use crate::solution::Solution;
use crate::unit::DecimalMark;

use self::bound::bounded;
use self::form::is_doubtful;
use self::typed::TypedResponse;

/// Longest response that is read.
pub const MAX_RESPONSE_LENGTH: usize = 4000;

/// Marks a response to a part; an empty one, or one that says that there is no answer, is missing.
///
/// ```
/// # #[cfg(feature = "render")] {
/// use vibank::{answer::Verdict, bank, grade, instance::Instance, solution::Solution};
/// let (catalogue, _) = bank::Catalogue::load([
///     ("bank.toml", "format = 1\ntitle = 'T'"),
///     ("c/_chapter.toml", "title = 'C'"),
///     ("c/a.toml", "[item]\ntitle = 'A'\nsource = 'by hand'\n[parameters]\nf = '2 Hz'\n[quantities]\nomega = { formula = '2*pi*f', unit = 'rad/s' }\n[statement]\ntext = 'A wheel turns with << f >>.'\n[[part]]\nkey = 'omega'\nask = 'How fast is it?'\n"),
/// ]);
/// let solution = Solution::of(Instance::of_source(catalogue.find("c/a").unwrap()));
/// assert_eq!(grade::mark(&solution, 0, "12.6 rad/s").verdict, Verdict::Right);
/// assert_eq!(grade::mark(&solution, 0, "2 rad/s").verdict, Verdict::Wrong);
/// assert_eq!(grade::mark(&solution, 0, "a dozen").verdict, Verdict::Unreadable);
/// # }
/// ```
pub fn mark(solution: &Solution<'_>, place: usize, response: &str) -> Marking {
    in_decimals_of(
        solution,
        mark_typed(solution, place, &TypedResponse::new(response)),
    )
}

/// The same for a response that may have been folded before.
fn mark_typed(solution: &Solution<'_>, place: usize, response: &TypedResponse<'_>) -> Marking {
    let typed = response.typed();
    if typed.is_empty() {
        return Marking::missing();
    }
    if response.is_too_long() {
        return Marking::unreadable(Why::LongerThan(MAX_RESPONSE_LENGTH));
    }
    recalled(solution, place, response, || {
        let marking = match folded(solution, place, response) {
            Ok((marker, folded)) => bounded(|| {
                let kind = solution.template().parts[place].answer.kind();
                let mark = |response: Passage<'_>| marker.mark(response);
                let naming = &solution.template().parts[place].naming;
                let may_answer = |other: &Reworded| may_answer(naming, marker, other);
                marked_again(kind, folded.passage(), may_answer, mark).in_typed(&folded)
            }),
            Err(why) => Marking::unreadable(why),
        };
        silence::heard(typed, marking)
    })
}

/// The marking of what was typed: that which it had before, where it was right whatever the data are, or by `mark`.
fn recalled(
    solution: &Solution<'_>,
    place: usize,
    response: &TypedResponse<'_>,
    mark: impl FnOnce() -> Marking,
) -> Marking {
    let known = || solution.marker(place).ok().and_then(Marker::recalled);
    if let Some(marking) = known().and_then(|known| known.get(response.typed())) {
        return marking;
    }
    let marking = mark();
    // Asked once more: marking may have looked at the data.
    if let Some(known) = known() {
        let has_one_form = || form::is_in_one(solution, place, response);
        known.keep(response.typed(), &marking, has_one_form);
    }
    marking
}

/// Whether what is read in place of a response names no other quantity than the one that is asked, comes from no steps
/// that may be a multiple of it, `2 x1 with F = m g: …`, and has no condition that never holds.
fn may_answer(naming: &Naming, marker: &dyn Marker, other: &Reworded) -> bool {
    let steps = other.steps();
    naming.check(other.passage()).is_ok()
        && (steps.is_empty() || !naming.may_have_asked(steps))
        && other.conditions().all(|own| marker.may_hold(own))
}

/// A longer answer is no answer with something said beside it, and takes its time for each way to read it.
const MAX_SAID: usize = 400;

/// The marking of a response; where that cannot be read, and another way to read it is right that may answer, the marking
/// by that.
fn marked_again(
    kind: AnswerKind,
    response: Passage<'_>,
    may_answer: impl Fn(&Reworded) -> bool,
    mark: impl Fn(Passage<'_>) -> Marking,
) -> Marking {
    let first = mark(response);
    let is_of_words = matches!(
        kind,
        AnswerKind::Choice | AnswerKind::Integer | AnswerKind::Interval | AnswerKind::Work
    );
    if is_of_words
        || !response.is_shorter_than(MAX_SAID)
        || first.verdict != Verdict::Unreadable
        || is_doubtful(&first)
    {
        return first;
    }
    let is_right = |marking: &Marking| marking.verdict == Verdict::Right;
    let mut others = response.read_again().filter(may_answer);
    let again = others.find_map(|other| Some(mark(other.passage())).filter(is_right));
    again.unwrap_or(first)
}

/// How a response to a part is read while it is typed: this tells nothing of the key.
///
/// # Errors
///
/// Why it cannot be read.
pub fn echo(solution: &Solution<'_>, place: usize, response: &str) -> Result<Echo, Unreadable> {
    let (marker, folded) = folded(solution, place, &TypedResponse::new(response))?;
    let mut echo = marker.echo(folded.passage()).map_err(|mut why| {
        why.point_at_typed(&folded);
        why
    })?;
    if solution.mark() == DecimalMark::Comma {
        let readings = std::iter::once(&mut echo.reading.math).chain(&mut echo.other);
        readings.for_each(|math| math.set_decimal_sign(","));
    }
    Ok(echo)
}

/// With the decimals of its reading as the sheet prints them.
fn in_decimals_of(solution: &Solution<'_>, mut marking: Marking) -> Marking {
    if solution.mark() == DecimalMark::Comma
        && let Some(reading) = &mut marking.reading
    {
        reading.math.set_decimal_sign(",");
    }
    marking
}

/// What marks a response, and the response in one spelling.
fn folded<'s, 'r>(
    solution: &'s Solution<'_>,
    place: usize,
    response: &TypedResponse<'r>,
) -> Result<(&'s dyn Marker, Folded<'r>), Unreadable> {
    if response.is_too_long() {
        return Err(Why::LongerThan(MAX_RESPONSE_LENGTH).into());
    }
    let part = &solution.template().parts[place];
    let kind = part.answer.kind();
    if let Some(words) = withdrawn(response.typed(), kind == AnswerKind::Choice) {
        return Err(Unreadable::at(words, Why::Withdrawn));
    }
    let folded = match kind {
        // Before a bound, `=>` is a sign of its own.
        AnswerKind::Interval => Folded::of(response.typed())?,
        _ => response.folded()?.clone(),
    };
    let folded = part.naming.named(folded)?;
    let folded = part.naming.answering(folded);
    part.naming.check(folded.passage()).map_err(|mut why| {
        why.point_at_typed(&folded);
        why
    })?;
    let marker = solution.marker(place).map_err(Why::NoKey)?;
    Ok((marker, folded))
}

/// What a sheet asks of an item, and how it counts.
#[derive(Clone, Copy, Debug)]
pub struct Sheet<'a> {
    /// The parts that it asks for, by their places in the item.
    pub asked: &'a [usize],
    /// What a right value is worth where a formula is asked, and a formula where a value is; the item decides, or half
    /// of the points, where this is none. Nothing is paid where another part that is asked has the same key.
    pub other_form: Option<Credit>,
}

/// The markings of the parts of an instance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grade {
    parts: Vec<(usize, Marking)>,
}

impl Grade {
    /// Marks responses to parts, given by their places in the item in any order, equations among each other.
    /// One that is not right is marked again with what was answered to earlier parts: follow-through.
    ///
    /// # Panics
    ///
    /// If the item has no part at such a place.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::{answer::{Reason, Verdict}, bank, grade::Grade, instance::Instance, solution::Solution};
    /// let (catalogue, _) = bank::Catalogue::load([
    ///     ("bank.toml", "format = 1\ntitle = 'T'"),
    ///     ("c/_chapter.toml", "title = 'C'"),
    ///     ("c/a.toml", "[item]\ntitle = 'A'\nsource = 'by hand'\n[parameters]\nT = '2 s'\nR = '3 m'\n[quantities]\nomega = { formula = '2*pi/T', unit = 'rad/s' }\nv = { formula = 'R*omega', unit = 'm/s' }\n[statement]\ntext = 'A wheel.'\n[[part]]\nkey = 'omega'\nask = 'How fast does it turn?'\n[[part]]\nkey = 'v'\nask = 'How fast is its rim?'\n"),
    /// ]);
    /// let solution = Solution::of(Instance::of_source(catalogue.find("c/a").unwrap()));
    /// let grade = Grade::mark(&solution, [(0, "1.57 rad/s"), (1, "4.71 m/s")]);
    /// assert_eq!(grade.part(0).unwrap().verdict, Verdict::Wrong);
    /// assert_eq!(grade.part(1).unwrap().verdict, Verdict::Right);
    /// assert_eq!(grade.part(1).unwrap().reason(), Reason::FollowThrough);
    /// # }
    /// ```
    pub fn mark<'r>(
        solution: &Solution<'_>,
        responses: impl IntoIterator<Item = (usize, &'r str)>,
    ) -> Self {
        let parts = 0..solution.template().parts.len();
        let asked: Vec<usize> = parts.filter(|place| solution.asks(*place)).collect();
        let sheet = Sheet {
            asked: &asked,
            other_form: None,
        };
        Self::mark_on(solution, &sheet, responses)
    }

    /// The same on a sheet that asks for some of the parts.
    ///
    /// # Panics
    ///
    /// If the item has no part at such a place.
    pub fn mark_on<'r>(
        solution: &Solution<'_>,
        sheet: &Sheet<'_>,
        responses: impl IntoIterator<Item = (usize, &'r str)>,
    ) -> Self {
        let mut responses: Vec<(usize, &str)> = responses.into_iter().collect();
        crate::numerics::sort_by_key(&mut responses, |(place, _)| *place);
        let mut all: Vec<TypedResponse<'_>> = Vec::new();
        all.resize_with(solution.template().parts.len(), TypedResponse::default);
        for (place, response) in &responses {
            all[*place] = TypedResponse::new(response);
        }
        let mut grade = Self::default();
        // What later parts go on from in place of a marking: what was answered in the other form.
        let mut others: Vec<Option<Marking>> = Vec::new();
        for (place, _) in responses {
            let response = &all[place];
            let first = among::marked(solution, place, &all);
            let first = form::otherwise(solution, place, response, &first, sheet).unwrap_or(first);
            let earlier = grade.parts.iter().zip(&others);
            let earlier =
                earlier.map(|((place, own), other)| (*place, other.as_ref().unwrap_or(own)));
            let followed = follow::follow(solution, place, response, &first, earlier);
            let marking = followed.unwrap_or(first);
            others.push(form::standing(solution, place, response, &marking));
            grade.parts.push((place, in_decimals_of(solution, marking)));
        }
        grade
    }

    /// The marking of the part at a place of the item, if there was a response to it.
    pub fn part(&self, place: usize) -> Option<&Marking> {
        let own = self.parts.iter().find(|(own, _)| *own == place);
        own.map(|(_, marking)| marking)
    }

    /// The same, taken out.
    pub fn take(&mut self, place: usize) -> Option<Marking> {
        let own = self.parts.iter().position(|(own, _)| *own == place)?;
        Some(self.parts.remove(own).1)
    }
}
