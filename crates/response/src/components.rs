//! Sums of vectors, each with a factor: `(1, 2) (A cos 2t + B sin 2t) + (1, -1) C cos(4t + φ)`, read by components.

use super::frame::{groups, without_transpositions};
use super::layout::spaced;
use super::lexer::tokens;
use super::parser::Parser;
use super::sides::last_side;
use super::token::{Item, Token};
use super::ways::readings;
use super::{Lexicon, MAX_LENGTH, Manner, Trouble, TypedError};
use vibank_formula::expr::Expr;
use vibank_source::Span;

/// A vector in a row of tokens: its brackets, and the signs between its entries.
struct Vector {
    open: usize,
    close: usize,
    parts: Vec<usize>,
}

/// The components of a sum of vectors after the last equals sign; nothing where no vectors of this length stand.
///
/// # Errors
///
/// What stands in the way, such as a term without a vector.
pub(crate) fn components(
    text: &str,
    count: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Option<Vec<Expr>>, TypedError> {
    if text.len() > MAX_LENGTH {
        return Err(TypedError::new(Trouble::TooLong, MAX_LENGTH, text.len()));
    }
    let read = |comma_is_decimal| {
        let manner = Manner {
            comma_is_decimal,
            ..manner
        };
        read(text, count, lexicon, manner)
    };
    // A comma parts entries, but is a decimal sign where only so vectors are read.
    match (read(false), manner.comma_is_decimal) {
        (Ok(Some(found)), _) => Ok(Some(found)),
        (first, true) => read(true)
            .ok()
            .flatten()
            .map_or(first, |found| Ok(Some(found))),
        (first, false) => first,
    }
}

fn read(
    text: &str,
    count: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Option<Vec<Expr>>, TypedError> {
    let text = &with_separators(without_transpositions(text));
    let side = last_side(text).range();
    let Ok(tokens) = tokens(text, side.start, side.end, lexicon, manner) else {
        return Ok(None);
    };
    let vectors = vectors(&tokens, count);
    if vectors.is_empty() {
        return Ok(None);
    }
    one_in_each_term(&tokens, &vectors)?;
    (0..count)
        .map(|place| {
            let own = only_entry(&tokens, &vectors, place);
            let read = readings(|ways| Parser::new(&own, side.end, ways).whole_formula());
            read.map(|typed| typed.value)
        })
        .collect::<Result<_, _>>()
        .map(Some)
}

/// A text with separators between the numbers of its vectors that spaces part, `[1 -1]`; all places stay.
fn with_separators(mut text: String) -> String {
    for group in groups(&text, Span::new(0, text.len())) {
        let own = &text[group.range()];
        let is_vector = own.starts_with('[')
            && own
                .chars()
                .all(|char| "[]+-. ".contains(char) || char.is_ascii_digit());
        if is_vector {
            let parted = spaced(own);
            text.replace_range(group.range(), &parted);
        }
    }
    text
}

/// The brackets outside of all others that hold this many entries.
fn vectors(tokens: &[Token], count: usize) -> Vec<Vector> {
    let (mut found, mut parts, mut open, mut depth) = (Vec::new(), Vec::new(), 0, 0_usize);
    for (at, token) in tokens.iter().enumerate() {
        match token.item {
            Item::Sign('(' | '[' | '{') => {
                depth += 1;
                if depth == 1 {
                    open = at;
                    parts.clear();
                }
            }
            Item::Sign(')' | ']' | '}') => {
                depth = depth.saturating_sub(1);
                let before = open.checked_sub(1).map(|at| &tokens[at].item);
                let is_argument = matches!(before, Some(Item::Function(_) | Item::Powered(_)));
                if depth == 0 && parts.len() + 1 == count && !is_argument {
                    let parts = parts.clone();
                    found.push(Vector {
                        open,
                        close: at,
                        parts,
                    });
                }
            }
            Item::Sign(',' | ';' | '&') if depth == 1 => parts.push(at),
            _ => {}
        }
    }
    found
}

/// Refuses a term with no vector, or with several, and one that is divided by a vector.
fn one_in_each_term(tokens: &[Token], vectors: &[Vector]) -> Result<(), TypedError> {
    let (mut depth, mut start) = (0_usize, 0);
    for at in 0..=tokens.len() {
        let is_end = match tokens.get(at).map(|token| &token.item) {
            None => true,
            Some(Item::Sign('(' | '[' | '{')) => {
                depth += 1;
                false
            }
            Some(Item::Sign(')' | ']' | '}')) => {
                depth = depth.saturating_sub(1);
                false
            }
            Some(Item::Sign('+' | '-')) => depth == 0,
            Some(_) => false,
        };
        if !is_end {
            continue;
        }
        let within = start..at;
        let own = vectors.iter().filter(|own| within.contains(&own.open));
        let is_sound = match own.collect::<Vec<_>>()[..] {
            [vector] => {
                let before = vector.open.checked_sub(1).map(|at| &tokens[at].item);
                !matches!(before, Some(Item::Sign('/' | '^')))
            }
            // `+ c.c.` is of all components.
            _ => at == start + 1 && tokens[start].item == Item::Conjugates,
        };
        if start < at && !is_sound {
            let span = tokens[start].span.join(tokens[at - 1].span);
            return Err(TypedError {
                trouble: Trouble::List,
                span,
            });
        }
        start = at + 1;
    }
    Ok(())
}

/// The tokens with one entry in place of each vector.
fn only_entry(tokens: &[Token], vectors: &[Vector], place: usize) -> Vec<Token> {
    let mut kept = Vec::with_capacity(tokens.len());
    let mut from = 0;
    for vector in vectors {
        let start = match place.checked_sub(1) {
            Some(before) => vector.parts[before] + 1,
            None => vector.open + 1,
        };
        let end = vector.parts.get(place).copied().unwrap_or(vector.close);
        kept.extend_from_slice(&tokens[from..=vector.open]);
        kept.extend_from_slice(&tokens[start..end]);
        kept.push(tokens[vector.close].clone());
        from = vector.close + 1;
    }
    kept.extend_from_slice(&tokens[from..]);
    kept
}
