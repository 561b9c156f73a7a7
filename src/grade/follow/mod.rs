//! Follow-through: a part is marked again with the student's own earlier answers.
//!
//! What an earlier part asked for stands in the graph of the item; where a later key depends on it, the
//! student's value (or formula) is put in its place and the key is computed anew. A response that is right
//! for this key is counted, and reported as a follow-through. An equation of motion stands for all that
//! follows from it, natural frequency, damping ratio and so on, and each of these for the others. Equations of several
//! coordinates, and matrices, stand for the natural frequencies and shapes that they have ([`system`]), a shape for
//! what is computed with it ([`shapes`]).
//!
//! An earlier answer stands in only if it has the dimension and the size of what was asked, and only as
//! long as it does not make the later part easier than it is ([`guard`]).

mod answers;
mod driven;
mod guard;
mod inside;
mod matrices;
mod oscillator;
mod related;
mod shapes;
mod system;

use super::mark_typed;
use super::typed::TypedResponse;
use crate::answer::{KeyValue, Marking, Reason, Remark, Verdict};
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::solution::Solution;

use self::answers::{Answers, Own, Source};

/// The marking of a response to the part at `place` as a follow-through of earlier markings, if it is one.
pub(crate) fn follow<'m>(
    solution: &Solution<'_>,
    place: usize,
    response: &TypedResponse<'_>,
    first: &Marking,
    earlier: impl ExactSizeIterator<Item = (usize, &'m Marking)>,
) -> Option<Marking> {
    let is_open = matches!(first.verdict, Verdict::Wrong | Verdict::Partial);
    if !is_open || earlier.len() == 0 {
        return None;
    }
    let answers = Answers::given(solution, earlier, place);
    let own: Vec<&Own> = answers
        .own()
        .filter(|own| is_needed(solution, place, own))
        .collect();
    // First what was given; then also what follows from it for others that were not asked, which may not have been used.
    let keys = solution.template().parts[place].answer.keys();
    let is_given = |own: &&Own| own.source != Source::Related || keys.contains(&own.node);
    let given: Vec<&Own> = own.iter().copied().filter(is_given).collect();
    let has_more = given.len() < own.len();
    let all = Some(own.clone()).filter(|_| has_more);
    // Who was wrong twice may have gone on from one of the answers alone.
    let alone = own.iter().filter(|_| own.len() > 1).map(|own| vec![*own]);
    [given]
        .into_iter()
        .chain(all)
        .chain(alone)
        .filter(|own| !own.is_empty())
        .filter_map(|own| again(solution, place, response, &answers, &own, first))
        // One that is worth no more than the first marking is not told.
        .find(|marking| marking.credit > first.credit)
}

/// Whether the marking explains a response otherwise: it is a named mistake, or the key up to a slip.
fn is_explained(first: &Marking) -> bool {
    first.reasons().iter().any(|reason| {
        matches!(
            reason,
            Reason::Mistake(_) | Reason::Sign | Reason::TwoPi | Reason::PowerOfTen
        )
    })
}

/// Whether the numbers of a response are near those of a key by more than the width of its tolerance, which is wide
/// where the steps cancel: within a quarter of it.
fn is_close(other: &Solution<'_>, place: usize, marking: &Marking) -> bool {
    // The tolerance allows for every step to be rounded in the worst way; who went on from the answer is
    // nearer.
    const SHARE: f64 = 0.25;
    let (Ok(marker), Some(reading)) = (other.marker(place), &marking.reading) else {
        return true;
    };
    let KeyValue::Numbers { si, .. } = marker.key().value else {
        return true;
    };
    let (halves, typed) = (marker.half_widths(), reading.answered.si());
    if halves.len() != si.len() || typed.len() != si.len() {
        return true;
    }
    let mut numbers = typed.iter().zip(si).zip(halves);
    numbers.all(|((own, key), half)| (own - key).abs() <= SHARE * half)
}

/// Whether the key of a part depends on what an answer stands for, so that another answer makes another key.
fn is_needed(solution: &Solution<'_>, place: usize, own: &Own) -> bool {
    let template = solution.template();
    let (part, graph) = (&template.parts[place], &template.graph);
    let keys = part.answer.keys();
    if keys.contains(&own.node) {
        // The value of one's own formula is work of its own; an answer that is copied is not.
        return own.source != Source::Part(part.answer.kind());
    }
    // Equations keep their key to themselves; one that does not depend on a formula stays as it is.
    let is_hidden = keys.is_empty() && own.formula.is_some();
    is_hidden || keys.iter().any(|key| graph.depends(*key, &own.name))
}

/// The response marked by the key that follows from some answers.
fn again(
    solution: &Solution<'_>,
    place: usize,
    response: &TypedResponse<'_>,
    answers: &Answers,
    own: &[&Own],
    first: &Marking,
) -> Option<Marking> {
    let right = solution.following(answers.right_values(solution, own), SortedMap::new());
    let other = solution.following(answers.values(own), Answers::formulas(own));
    let keys = solution.template().parts[place].answer.keys();
    if !guard::is_fair(&right, &other, &keys, own) {
        return None;
    }
    let mut marking = mark_typed(&other, place, response);
    if is_explained(first) && !is_close(&other, place, &marking) {
        return None;
    }
    marking.remarks.insert(0, Remark::Followed(symbols(own)));
    Some(marking)
}

/// The symbols of the answers from which a follow-through goes on, each once; equations have none.
fn symbols(own: &[&Own]) -> Vec<Math> {
    let mut symbols: Vec<Math> = Vec::new();
    for own in own.iter().filter(|own| own.source != Source::Equation) {
        if !symbols.contains(&own.symbol) {
            symbols.push(own.symbol.clone());
        }
    }
    symbols
}
