//! Lists, vectors and matrices as people type them: `(1, 0.618)`, `[1; -2]`, `[[3m, 0], [0, m]]`.

use super::frame::{Frame, frame};
use super::layout::{spaced, without_latex};
use super::{DEEPEST, LONGEST, Lexicon, Manner, Trouble, TypedError, read};
use crate::expr::Expr;
use crate::source::Span;

/// Most entries that are read.
const MOST_ENTRIES: usize = 400;

/// A list of formulas by rows.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::answer) struct Listed {
    /// The entries, each row as long as the others.
    pub(in crate::answer) rows: Vec<Vec<Expr>>,
    /// What stands behind the closing bracket: a unit.
    pub(in crate::answer) tail: Span,
}

/// The entries of a list in `text[from..to]`, by rows; a list without rows is one row.
pub(super) fn list(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Listed, TypedError> {
    if text.len() > LONGEST {
        return Err(TypedError::new(Trouble::TooLong, LONGEST, text.len()));
    }
    let plain = without_latex(text);
    let text = plain.as_ref();
    let Frame {
        outer,
        factor,
        is_negative,
        is_transposed,
        tail,
    } = frame(text, from, to)?;
    let factor = match factor {
        Some(span) => Some(entry(text, span, lexicon, manner)?),
        None => is_negative.then(|| -Expr::number(1)),
    };
    let has_rows = text[outer.range()]
        .trim_start()
        .starts_with(['[', '(', '{']);
    let row_signs: &[char] = if has_rows { &[',', ';'] } else { &[';'] };
    let mut rows = Vec::new();
    for row in cut(text, outer, row_signs) {
        let row = if has_rows { unwrapped(text, row)? } else { row };
        let comma = if manner.comma_is_decimal {
            &['&', ';'][..]
        } else {
            &[',', '&', ';'][..]
        };
        let mut entries = Vec::new();
        for place in cut(text, row, comma) {
            let value = entry(text, place, lexicon, manner)?;
            let value = match &factor {
                Some(factor) => factor.clone() * value,
                None => value,
            };
            if value.depth() > DEEPEST {
                return Err(TypedError {
                    trouble: Trouble::TooDeep,
                    span: place,
                });
            }
            entries.push(value);
        }
        rows.push(entries);
        if rows.iter().map(Vec::len).sum::<usize>() > MOST_ENTRIES {
            return Err(TypedError {
                trouble: Trouble::TooLong,
                span: outer,
            });
        }
    }
    if rows.iter().any(|row| row.len() != rows[0].len()) {
        return Err(TypedError {
            trouble: Trouble::Ragged,
            span: outer,
        });
    }
    if is_transposed {
        rows = transposed(&rows);
    }
    Ok(Listed { rows, tail })
}

/// A list of the size that is asked, whose entries may also be parted by spaces; of another size it is as it was typed.
pub(in crate::answer) fn list_of_size(
    text: &str,
    from: usize,
    lexicon: &Lexicon,
    manner: Manner,
    fits: impl Fn(&Listed) -> bool,
) -> Result<Listed, TypedError> {
    let read = |text: &str| list(text, from, text.len(), lexicon, manner);
    let typed = read(text);
    if typed.as_ref().is_ok_and(&fits) {
        return typed;
    }
    let spaced = read(&spaced(text));
    if spaced.as_ref().is_ok_and(&fits) {
        spaced
    } else {
        typed
    }
}

fn transposed(rows: &[Vec<Expr>]) -> Vec<Vec<Expr>> {
    let width = rows.first().map_or(0, Vec::len);
    let column = |at: usize| rows.iter().map(|row| row[at].clone()).collect();
    (0..width).map(column).collect()
}

fn entry(text: &str, place: Span, lexicon: &Lexicon, manner: Manner) -> Result<Expr, TypedError> {
    let (from, to) = (place.range().start, place.range().end);
    let typed = read(text, from, to, lexicon, manner, |parser| {
        let formula = parser.whole_formula()?;
        Ok(formula)
    })?;
    Ok(typed.value)
}

/// A row without its brackets.
fn unwrapped(text: &str, row: Span) -> Result<Span, TypedError> {
    let row = trimmed(text, row);
    let inner = &text[row.range()];
    if inner.starts_with(['[', '(', '{']) && inner.ends_with([']', ')', '}']) {
        return Ok(Span::new(row.range().start + 1, row.range().end - 1));
    }
    Err(TypedError {
        trouble: Trouble::Ragged,
        span: row,
    })
}

pub(super) fn trimmed(text: &str, span: Span) -> Span {
    let inner = &text[span.range()];
    let start = span.range().start + inner.len() - inner.trim_start().len();
    Span::new(start, start + inner.trim().len())
}

/// The pieces between signs that stand in no bracket.
pub(in crate::answer) fn cut(text: &str, span: Span, signs: &[char]) -> Vec<Span> {
    let (mut pieces, mut start, mut depth) = (Vec::new(), span.range().start, 0_usize);
    for (at, char) in text[span.range()].char_indices() {
        let at = span.range().start + at;
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ if depth == 0 && signs.contains(&char) => {
                pieces.push(Span::new(start, at));
                start = at + char.len_utf8();
            }
            _ => {}
        }
    }
    pieces.push(Span::new(start, span.range().end));
    pieces
}
