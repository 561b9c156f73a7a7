//! What stands around a list: its brackets, a factor before them, a sign of transposition and a unit behind.

use super::list::{cut, trimmed};
use super::{Trouble, TypedError};
use crate::source::Span;

/// The inside of the outermost bracket, and what stands around it.
pub(super) struct Frame {
    pub(super) outer: Span,
    pub(super) factor: Option<Span>,
    /// Whether a minus stands before the bracket.
    pub(super) is_negative: bool,
    pub(super) is_transposed: bool,
    /// What stands behind it: a unit.
    pub(super) tail: Span,
}

impl Frame {
    /// No bracket around all.
    fn bare(outer: Span) -> Self {
        let end = outer.range().end;
        Self {
            outer,
            factor: None,
            is_negative: false,
            is_transposed: false,
            tail: Span::new(end, end),
        }
    }
}

pub(super) fn frame(text: &str, from: usize, to: usize) -> Result<Frame, TypedError> {
    let all = trimmed(text, Span::new(from, to));
    let start = all.range().start;
    let inner = &text[all.range()];
    let is_one = |text: &str| cut(text, Span::new(0, text.len()), &[',', ';']).len() == 1;
    if let Some(close) = first_bracket(inner) {
        let after = inner[close + 1..].trim_start();
        let is_transposed = after.starts_with(TRANSPOSED);
        let after = without_transposition(after);
        if after.is_empty() || after.starts_with(char::is_alphabetic) && is_one(after) {
            return Ok(Frame {
                outer: Span::new(start + 1, start + close),
                is_transposed,
                tail: Span::new(all.range().end - after.len(), all.range().end),
                ..Frame::bare(all)
            });
        }
        if !is_one(inner) {
            return Ok(Frame::bare(all));
        }
    }
    let Some(close) = inner.rfind([']', ')', '}']) else {
        return Ok(Frame::bare(all));
    };
    let close = last_of_list(inner).unwrap_or(close);
    let Some(open) = opening(&inner[..=close]) else {
        let at = start + close;
        return Err(TypedError::new(Trouble::Bracket, at, at + 1));
    };
    let after = inner[close + 1..].trim_start();
    let is_transposed = after.starts_with(TRANSPOSED);
    let after = without_transposition(after);
    let before = inner[..open].trim().trim_end_matches(['*', '·', '⋅', '×']);
    // Separators outside of the bracket: there is no bracket around all.
    if before.contains([',', ';']) || after.contains([',', ';']) {
        return Ok(Frame::bare(all));
    }
    let is_negative = matches!(before, "-" | "−");
    let offset = inner.len() - inner.trim_start().len();
    let factor = (!before.is_empty() && !is_negative)
        .then(|| Span::new(start + offset, start + offset + before.len()));
    Ok(Frame {
        outer: Span::new(start + open + 1, start + close),
        factor,
        is_negative,
        is_transposed,
        tail: Span::new(all.range().end - after.len(), all.range().end),
    })
}

/// What begins a sign of transposition.
const TRANSPOSED: &[char] = &['^', 'ᵀ', '\'', '’', '′'];

/// What follows a sign of transposition, `^T` or `'`.
fn without_transposition(text: &str) -> &str {
    const SIGNS: &[&str] = &[
        "^{\\mathrm{T}}",
        "^\\mathrm{T}",
        "^\\mathsf{T}",
        "^{\\top}",
        "^\\top",
        "^\\intercal",
        "^{T}",
        "^T",
        "^t",
        "ᵀ",
        "'",
        "’",
        "′",
    ];
    let rest = SIGNS.iter().find_map(|sign| text.strip_prefix(sign));
    rest.map_or(text, str::trim_start)
}

/// The closing bracket before the sign of transposition in braces, `)^{T}`.
fn last_of_list(text: &str) -> Option<usize> {
    let at = text.rfind('^')?;
    let is_transposition = without_transposition(&text[at..]).len() < text[at..].len();
    let before = text[..at].trim_end();
    (is_transposition && before.ends_with([']', ')', '}'])).then(|| before.len() - 1)
}

/// Where the bracket opens that ends a text.
fn opening(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, char) in text.char_indices().rev() {
        match char {
            ']' | ')' | '}' => depth += 1,
            '[' | '(' | '{' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// Where the bracket closes with which a text begins.
pub(in crate::answer) fn first_bracket(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, char) in text.char_indices() {
        match char {
            '[' | '(' | '{' => depth += 1,
            ']' | ')' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return (at > 0).then_some(at);
        }
    }
    None
}
