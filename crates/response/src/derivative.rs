//! Time derivatives of the names of a lexicon: `dx/dt`, `x_{tt}`, `xp`.

use super::Lexicon;
use super::differential::{behind, by_operator, called, leibniz, method};
use super::letters::Letters;
use super::vocabulary::{Ending, WordPiece, WordSense};
use vibank_formula::expr::{Expr, Kind};
use vibank_source::Span;

/// The derivative that stands at a place, and where it ends.
pub(crate) fn derivative(text: &str, at: usize, lexicon: &Lexicon) -> Option<(Expr, usize)> {
    let quotient = leibniz(text, at).or_else(|| behind(text, at));
    if let Some((spelling, order, end)) = &quotient
        && let Some(rate) = lexicon.rate(spelling, *order)
    {
        return Some((rate, *end));
    }
    let found = quotient
        .or_else(|| {
            let is_letter = text[at..].starts_with("D(") && lexicon.knows("D");
            called(text, at).filter(|_| !is_letter)
        })
        .or_else(|| method(text, at))
        .or_else(|| by_operator(text, at).filter(|_| !lexicon.knows("D")));
    let (spelling, order, end) = found?;
    Some((lexicon.dotted(&spelling, order)?, end))
}

/// The words of a run that ends in a rate by its index, `x_t`, `x_{tt}`, or by a letter for the prime, `c*xp`, and the
/// order of that rate; of what was typed and its letters, which end at a place.
pub(crate) fn rate_by_index(
    typed: &str,
    letters: &Letters,
    end: usize,
    lexicon: &Lexicon,
) -> Option<(Vec<WordPiece>, u8)> {
    const INDICES: [(&str, &str, u8); 7] = [
        ("_dd", "dd", 2),
        ("_d", "d", 1),
        ("_tt", "tt", 2),
        ("_{tt}", "tt", 2),
        ("_t", "t", 1),
        ("_{t}", "t", 1),
        ("p", "p", 1),
    ];
    let (_, index, order) = INDICES.iter().find(|(own, ..)| typed.ends_with(own))?;
    let is_prime = *index == "p";
    if is_prime && typed.contains('_') {
        return None;
    }
    let mut stem = letters.clone();
    stem.text
        .truncate(letters.text.len().checked_sub(index.len())?);
    stem.cuts.retain(|(at, _)| *at < stem.text.len());
    let pieces = lexicon
        .split(&stem, end, Ending::Primes(*order), false)
        .ok()?;
    let WordSense::Leaf(leaf) = &pieces.last()?.sense else {
        return None;
    };
    let is_moving = matches!(leaf.kind(), Kind::Name(name) if lexicon.is_moving(name));
    is_moving.then_some((pieces, *order))
}

/// A name with primes.
pub(crate) fn primed(leaf: Expr, order: u8, span: Span) -> Expr {
    match leaf.kind() {
        _ if order == 0 => leaf,
        Kind::Prime(inner, lower) => Expr::new(
            Kind::Prime(inner.clone(), lower.saturating_add(order)),
            span,
        ),
        _ => Expr::new(Kind::Prime(leaf, order), span),
    }
}
