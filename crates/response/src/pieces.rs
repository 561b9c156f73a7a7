//! The pieces of a function: the times for which it is meant to hold, and other functions for other times.

use super::Passage;
use super::list::cut;
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
    let is_condition = |text: &str| text.contains(['<', '>', '≤', '≥']);
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
        .filter(|(at, _)| is_condition(&text[*at..]) && is_outside(*at))
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

/// A condition without the word that introduces it.
pub(crate) fn without_if(condition: Passage<'_>) -> Passage<'_> {
    let text = condition.text();
    Passage::of(text.trim_start_matches("for ").trim_start_matches("if "))
}
