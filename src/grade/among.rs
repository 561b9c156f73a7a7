//! Marking of parts that are looked at together.

use std::borrow::Cow;

use super::{LONGEST_RESPONSE, mark};
use crate::answer::{Beside, Marking, plain};
use crate::solution::Solution;

/// Marks the response to a part with those to all parts of the item at hand, by place; empty ones are missing.
/// Where several parts ask for one equation of motion each, the responses may make them up together.
pub fn mark_among(solution: &Solution<'_>, place: usize, responses: &[&str]) -> Marking {
    let parts = &solution.template().parts;
    let response = responses.get(place).map_or("", |response| response.trim());
    let heeds = |at: usize| parts[at].answer.heeds_others();
    let is_short = |response: &str| response.len() <= LONGEST_RESPONSE;
    if response.is_empty() || !is_short(response) || !heeds(place) {
        return mark(solution, place, response);
    }
    let response = match plain(response) {
        Ok(response) => response,
        Err(help) => return Marking::unreadable(help),
    };
    let given: Vec<Cow<'_, str>> = responses
        .iter()
        .map(|response| plain(response).unwrap_or_default())
        .collect();
    let others: Vec<Beside<'_>> = (0..parts.len())
        .filter(|at| *at != place && heeds(*at) && solution.asks(*at))
        .filter_map(|at| {
            let response = given.get(at).map_or("", |response| response.trim());
            let marker = solution.marker(at).ok()?;
            Some(Beside { marker, response }).filter(|beside| is_short(beside.response))
        })
        .collect();
    match solution.marker(place) {
        Ok(marker) => marker.mark_beside(response.trim(), &others),
        Err(_) => mark(solution, place, &response),
    }
}
