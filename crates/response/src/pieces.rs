//! The pieces of a function: the times for which it is meant to hold, and other functions for other times; likewise
//! equations and their conditions.

use super::list::cut;
use super::{Passage, Reworded, equations};
use vibank_source::Span;

/// A function with the times for which it holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionPiece<'r> {
    /// The function, perhaps with its name.
    pub formula: Passage<'r>,
    /// When it holds, if that is said.
    pub condition: Option<Passage<'r>>,
}

/// The pieces of a function, each on a line or after a semicolon, `…, t < 1; …, t >= 1` or `… if t < 1 otherwise …`;
/// one piece with its times, if there is no more.
pub(crate) fn function_pieces(response: &str) -> Vec<FunctionPiece<'_>> {
    if let Some(pieces) = conditional(response) {
        return pieces;
    }
    const OTHERWISE: &str = " otherwise ";
    let all = Span::new(0, response.len());
    let lines = cut(response, all, &[';', '\n']).into_iter();
    let texts = lines.flat_map(|line| response[line.range()].split(OTHERWISE));
    let mut pieces: Vec<FunctionPiece<'_>> = texts
        .map(piece)
        .filter(|piece| !piece.formula.is_empty())
        .collect();
    // A condition may come after a comma that parts it from the next function.
    let last = pieces.len().saturating_sub(1);
    let is_by_pieces = last > 0
        && pieces[..last].iter().all(|piece| piece.condition.is_some())
        && !pieces[1..]
            .iter()
            .any(|piece| piece.formula.text().contains('='));
    if !is_by_pieces {
        pieces = vec![piece(response)];
    }
    pieces
}

/// Equations that hold under conditions, each with its own, `… = -F for x' > 0; … = F for x' < 0`, or as the right sides of
/// one, `… = { -F if x' > 0; F if x' < 0 }`; none where one has no condition.
pub(crate) fn cases(text: &str) -> Option<Vec<Reworded>> {
    let bare = without_braces(text);
    let found = equations_with_conditions(bare.as_deref().unwrap_or(text));
    let (left, _) = found.first()?.0.split_once('=')?;
    let cases = found.iter().map(|(own, condition)| {
        let equation = if own.contains('=') {
            (*own).to_owned()
        } else {
            format!("{left} = {own}")
        };
        let condition = without_if(Passage::of((*condition)?)).text().to_owned();
        Some(Reworded::of(equation).under(vec![condition]))
    });
    cases.collect()
}

/// An equation without the braces around the cases of its right side.
fn without_braces(text: &str) -> Option<String> {
    let text = text.trim_end().strip_suffix('}')?;
    let mut opens = ["= {", "={"].iter();
    let (left, cases) = opens.find_map(|open| text.split_once(open))?;
    Some(format!("{left}= {cases}"))
}

/// Equations or their right sides, each with the condition that stands before or behind it, or beside it by itself.
fn equations_with_conditions(text: &str) -> Vec<(&str, Option<&str>)> {
    let is_condition = |said: &str| compares(said) && !said.contains('=');
    let mut found: Vec<(&str, Option<&str>)> = Vec::new();
    let mut next = None;
    for place in equations::equations(text) {
        let own = text[place.range()].trim();
        if is_condition(own) && piece(own).condition.is_none() {
            match found.last_mut() {
                Some((_, condition @ None)) => *condition = Some(own),
                _ => next = Some(own),
            }
            continue;
        }
        let mut joints = [":", " then "].iter();
        let before = joints.find_map(|joint| own.split_once(joint));
        let before = before.filter(|(condition, _)| is_condition(condition));
        found.push(before.map_or_else(
            || {
                let piece = piece(own);
                let behind = piece.condition.map(Passage::text);
                (piece.formula.text(), behind.or(next.take()))
            },
            |(condition, equation)| (equation, Some(condition)),
        ));
    }
    found
}

/// `if t < 1 then … otherwise …`.
fn conditional(text: &str) -> Option<Vec<FunctionPiece<'_>>> {
    let (condition, rest) = text.trim().strip_prefix("if ")?.split_once(" then ")?;
    let (formula, otherwise) = rest.split_once(" otherwise ")?;
    let last = FunctionPiece {
        formula: Passage::of(otherwise),
        condition: None,
    };
    let first = FunctionPiece {
        formula: Passage::of(formula),
        condition: Some(Passage::of(condition)),
    };
    let others = conditional(otherwise).unwrap_or(vec![last]);
    Some(std::iter::once(first).chain(others).collect())
}

/// A function and the times after it: `…, t >= 0` or `… for t > 0`.
fn piece(text: &str) -> FunctionPiece<'_> {
    let text = text.trim().trim_end_matches([',', '.']);
    // The comma of `atan2(y, x)` parts nothing.
    let is_outside = |at: usize| {
        let count = |signs: &[char]| text[..at].matches(signs).count();
        count(&['(', '[', '{']) == count(&[')', ']', '}'])
    };
    let words = [",", ";", " for ", " if ", " when ", " where "].into_iter();
    let bracket = text.ends_with(')').then_some("(");
    let cuts = words
        .chain(bracket)
        .filter_map(|sign| Some((text.rfind(sign)?, sign)));
    let cut = cuts
        .filter(|(at, _)| compares(&text[*at..]) && is_outside(*at))
        .min();
    match cut {
        Some((at, sign)) => {
            let condition = text[at + sign.len()..].trim();
            FunctionPiece {
                formula: Passage::of(text[..at].trim_end().trim_end_matches(',')),
                condition: Some(Passage::of(condition.trim_matches(['(', ')', ' ']))),
            }
        }
        None => FunctionPiece {
            formula: Passage::of(text),
            condition: None,
        },
    }
}

/// Whether a sign says which of two is larger.
fn compares(text: &str) -> bool {
    text.contains(['<', '>', '≤', '≥'])
}

/// A condition without the word that introduces it.
pub(crate) fn without_if(condition: Passage<'_>) -> Passage<'_> {
    let text = condition.text();
    let mut words = ["for ", "if ", "when ", "where ", "while "].iter();
    let bare = words.find_map(|word| text.strip_prefix(word));
    Passage::of(bare.unwrap_or(text))
}
