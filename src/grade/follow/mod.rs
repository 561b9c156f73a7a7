//! Follow-through: a part is marked again with the student's own earlier answers.
//!
//! What an earlier part asked for stands in the graph of the item; where a later key depends on it, the
//! student's value (or formula) is put in its place and the key is computed anew. A response that is right
//! for this key is counted, and told to be a follow-through. An equation of motion stands for all that
//! follows from it, natural frequency, damping ratio and so on, and each of these for the others. Equations of several
//! coordinates, and matrices, stand for the natural frequencies and shapes that they have ([`system`]), a shape for
//! what is computed with it ([`shapes`]).
//!
//! An earlier answer stands in only if it has the dimension and the size of what was asked, and only as
//! long as it does not make the later part easier than it is ([`guard`]).

mod answers;
mod guard;
mod matrices;
mod oscillator;
mod related;
mod shapes;
mod system;

use std::collections::BTreeMap;

use super::mark;
use crate::answer::{Marking, Remark, Verdict};
use crate::math::Math;
use crate::solution::Solution;

use self::answers::{Answers, Own, Source};

/// The marking of a response to the part at `place` as a follow-through of earlier markings, if it is one.
pub(super) fn follow(
    solution: &Solution<'_>,
    place: usize,
    response: &str,
    first: &Marking,
    earlier: &[(usize, Marking)],
) -> Option<Marking> {
    if !matches!(first.verdict, Verdict::Wrong | Verdict::Partial) {
        return None;
    }
    let answers = Answers::given(solution, earlier);
    let own: Vec<&Own> = answers
        .own()
        .filter(|own| is_needed(solution, place, own))
        .collect();
    let together = Some(own.clone()).filter(|own| !own.is_empty());
    // Who was wrong twice may have gone on from one of the answers alone.
    let alone = own.iter().filter(|_| own.len() > 1).map(|own| vec![*own]);
    together
        .into_iter()
        .chain(alone)
        .filter_map(|own| again(solution, place, response, &answers, &own))
        .find(|marking| marking.credit > first.credit)
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
    response: &str,
    answers: &Answers,
    own: &[&Own],
) -> Option<Marking> {
    let right = solution.following(answers.right_values(solution, own), BTreeMap::new());
    let other = solution.following(answers.values(own), Answers::formulas(own));
    let keys = solution.template().parts[place].answer.keys();
    if !guard::is_fair(&right, &other, &keys, own) {
        return None;
    }
    let mut marking = mark(&other, place, response);
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
