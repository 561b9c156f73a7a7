//! Marking of parts that are looked at together.

use super::bound::bounded;
use super::typed::TypedResponse;
use super::{mark_typed, marked_again, may_answer, recalled, silence};
use crate::answer::{Beside, Marking};
use crate::response::{Folded, Passage, Reworded, withdrawn};
use crate::solution::Solution;

/// Marks the response to a part with those to all parts of the item at hand, by place; empty ones are missing.
/// Where several parts ask for one equation of motion each, the responses may make them up together.
pub fn mark_among(solution: &Solution<'_>, place: usize, responses: &[&str]) -> Marking {
    let count = solution.template().parts.len();
    let given = responses.iter().copied().chain(std::iter::repeat(""));
    let responses: Vec<TypedResponse<'_>> = given.take(count).map(TypedResponse::new).collect();
    marked(solution, place, &responses)
}

/// The same for a response to each part.
pub(crate) fn marked(
    solution: &Solution<'_>,
    place: usize,
    responses: &[TypedResponse<'_>],
) -> Marking {
    let parts = &solution.template().parts;
    let response = &responses[place];
    if response.typed().is_empty()
        || response.is_too_long()
        || !parts[place].answer.heeds_others()
        || withdrawn(response.typed(), false).is_some()
    {
        return mark_typed(solution, place, response);
    }
    recalled(solution, place, response, || {
        marked_beside(solution, place, responses)
    })
}

/// The marking of a response with those to other parts at hand.
fn marked_beside(
    solution: &Solution<'_>,
    place: usize,
    responses: &[TypedResponse<'_>],
) -> Marking {
    let parts = &solution.template().parts;
    let response = &responses[place];
    let folded = match response.folded() {
        Ok(folded) => folded,
        Err(dollar) => return Marking::unreadable(dollar),
    };
    let others = (0..parts.len())
        .filter(|at| *at != place && parts[*at].answer.heeds_others() && solution.asks(*at));
    let others: Vec<Beside<'_>> = others
        .filter_map(|at| {
            let other = Some(&responses[at]).filter(|other| !other.is_too_long())?;
            let response = other.folded().map_or(Passage::default(), Folded::passage);
            let marker = solution.marker(at).ok()?;
            Some(Beside { marker, response })
        })
        .collect();
    match solution.marker(place) {
        Ok(marker) => {
            let kind = parts[place].answer.kind();
            let mark = |response: Passage<'_>| marker.mark_beside(response, &others);
            let naming = &parts[place].naming;
            let may_answer = |other: &Reworded| may_answer(naming, marker, other);
            let marked = || marked_again(kind, folded.passage(), may_answer, mark);
            let marking = bounded(|| marked().in_typed(folded));
            silence::heard(response.typed(), marking)
        }
        Err(_) => mark_typed(solution, place, response),
    }
}
