//! Marking of parts that are looked at together.

use super::bound::bounded;
use super::{MAX_RESPONSE_LENGTH, mark, silence};
use crate::answer::{Beside, Marking};
use crate::response::{Folded, withdrawn};
use crate::solution::Solution;

/// Marks the response to a part with those to all parts of the item at hand, by place; empty ones are missing.
/// Where several parts ask for one equation of motion each, the responses may make them up together.
pub fn mark_among(solution: &Solution<'_>, place: usize, responses: &[&str]) -> Marking {
    let parts = &solution.template().parts;
    let response = responses.get(place).map_or("", |response| response.trim());
    let heeds = |at: usize| parts[at].answer.heeds_others();
    let is_short = |response: &str| response.len() <= MAX_RESPONSE_LENGTH;
    if response.is_empty()
        || !is_short(response)
        || !heeds(place)
        || withdrawn(response, false).is_some()
    {
        return mark(solution, place, response);
    }
    let folded = match Folded::of(response) {
        Ok(folded) => folded,
        Err(dollar) => return Marking::unreadable(dollar),
    };
    let others = (0..parts.len()).filter(|at| *at != place && heeds(*at) && solution.asks(*at));
    let given: Vec<(usize, Option<Folded<'_>>)> = others
        .map(|at| {
            let response = responses.get(at);
            (at, response.and_then(|given| Folded::of(given).ok()))
        })
        .collect();
    let others: Vec<Beside<'_>> = given
        .iter()
        .filter_map(|(at, folded)| {
            let response = folded.as_ref().map_or("", |folded| folded.text().trim());
            let marker = solution.marker(*at).ok()?;
            Some(Beside { marker, response }).filter(|beside| is_short(beside.response))
        })
        .collect();
    match solution.marker(place) {
        Ok(marker) => {
            let marking = bounded(|| {
                let marking = marker.mark_beside(folded.text().trim(), &others);
                marking.in_typed(&folded)
            });
            silence::heard(response, marking)
        }
        Err(_) => mark(solution, place, response),
    }
}
