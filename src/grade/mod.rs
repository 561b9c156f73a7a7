//! Grading: responses to the parts of an instance, marked, with credit and feedback.
//!
//! Marks are exact fractions of points and are rounded once, where they are printed.

mod among;
pub mod request;
mod responses;

pub use among::mark_among;
pub use responses::{Place, Row, RowError, collect};

use crate::answer::{Feedback, Marking, Verdict};
use crate::bank::Passage;
use crate::numerics::Rational;
use crate::solution::Solution;

/// Longest response that is read.
pub const LONGEST_RESPONSE: usize = 4000;

/// Marks a response to a part; an empty one is missing.
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
/// assert_eq!(grade::mark(&solution, 0, "twelve").verdict, Verdict::Unreadable);
/// # }
/// ```
pub fn mark(solution: &Solution<'_>, place: usize, response: &str) -> Marking {
    let response = response.trim();
    if response.is_empty() {
        return Marking::missing();
    }
    if response.len() > LONGEST_RESPONSE {
        return Marking::unreadable(format!(
            "The answer is longer than {LONGEST_RESPONSE} bytes."
        ));
    }
    match solution.marker(place) {
        Ok(marker) => marker.mark(response),
        Err(absent) => Marking::unreadable(format!(
            "This part cannot be marked for these data: {absent}."
        )),
    }
}

/// What is said about a response, piece by piece.
pub enum Said<'t> {
    /// A text of the item.
    Passage(&'t Passage),
    /// A text of the item without placeholders.
    Document(crate::document::Document),
    /// A sentence of our own.
    Words(String),
}

/// The feedback of a marking, with the texts of the item that it names: at least one piece.
pub fn said<'t>(solution: &Solution<'t>, place: usize, marking: &Marking) -> Vec<Said<'t>> {
    let mistakes = &solution.template().parts[place].mistakes;
    let piece = |feedback: &Feedback| match feedback {
        Feedback::Mistake(number) => mistakes
            .get(*number)
            .map(|mistake| Said::Passage(&mistake.feedback)),
        Feedback::Text(document) => Some(Said::Document(document.clone())),
        Feedback::Words(words) => Some(Said::Words(words.clone())),
    };
    let said: Vec<Said<'t>> = marking.feedback.iter().filter_map(piece).collect();
    if said.is_empty() {
        return vec![Said::Words(bare(marking.verdict).to_owned())];
    }
    said
}

/// What is said where there is nothing more to say.
fn bare(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Right => "Right.",
        Verdict::Partial => "Partly right.",
        Verdict::Wrong => "This is not the answer.",
        Verdict::Unreadable => "This could not be read.",
        Verdict::Missing => "There is no answer.",
    }
}

/// The points of a marking, of so many.
pub fn points(marking: &Marking, of: Rational) -> Rational {
    match marking.verdict {
        Verdict::Missing | Verdict::Unreadable => Rational::ZERO,
        _ => marking
            .credit
            .share()
            .checked_mul(of)
            .unwrap_or(Rational::ZERO),
    }
}
