//! Lists, vectors and matrices as people type them: `(1, 0.618)`, `[1; -2]`, `[[3m, 0], [0, m]]`.

use std::borrow::Cow;

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
pub(in crate::answer) fn list(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Listed, TypedError> {
    if text.len() > LONGEST {
        return Err(TypedError::new(Trouble::TooLong, LONGEST, text.len()));
    }
    let plain = without_environments(text);
    let text = plain.as_ref();
    let (outer, factor, tail) = frame(text, from, to)?;
    let factor = match factor {
        Some(span) => Some(entry(text, span, lexicon, manner)?),
        None => None,
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
    Ok(Listed { rows, tail })
}

/// The text with `\begin{pmatrix} a & b \\ c & d \end{pmatrix}` in brackets; all places stay.
fn without_environments(text: &str) -> Cow<'_, str> {
    if !text.contains("\\begin{") {
        return Cow::Borrowed(text);
    }
    let mut plain = text.replace("\\\\", "; ").replace('&', ",");
    for (command, bracket) in [("\\begin{", '['), ("\\end{", ']')] {
        while let Some(start) = plain.find(command) {
            let length = plain[start..]
                .find('}')
                .map_or(command.len(), |end| end + 1);
            let padded = format!("{bracket}{}", " ".repeat(length - 1));
            plain.replace_range(start..start + length, &padded);
        }
    }
    Cow::Owned(plain)
}

fn entry(text: &str, place: Span, lexicon: &Lexicon, manner: Manner) -> Result<Expr, TypedError> {
    let (from, to) = (place.range().start, place.range().end);
    let typed = read(text, from, to, lexicon, manner, |parser| {
        let formula = parser.whole_formula()?;
        Ok(formula)
    })?;
    Ok(typed.value)
}

/// The inside of the outermost bracket, the factor before it and what follows it.
fn frame(text: &str, from: usize, to: usize) -> Result<(Span, Option<Span>, Span), TypedError> {
    let all = trimmed(text, Span::new(from, to));
    let inner = &text[all.range()];
    if let Some(close) = first_bracket(inner) {
        let start = all.range().start;
        let after = inner[close + 1..].trim_start();
        if after.is_empty()
            || after.starts_with(char::is_alphabetic)
                && cut(after, Span::new(0, after.len()), &[',', ';']).len() == 1
        {
            let tail = Span::new(start + close + 1, all.range().end);
            return Ok((Span::new(start + 1, start + close), None, tail));
        }
        if cut(inner, Span::new(0, inner.len()), &[',', ';']).len() > 1 {
            return Ok((all, None, Span::new(to, to)));
        }
    }
    let Some(close) = inner.rfind([']', ')', '}']) else {
        return Ok((all, None, Span::new(to, to)));
    };
    let mut depth = 0_usize;
    for (at, char) in inner[..=close].char_indices().rev() {
        match char {
            ']' | ')' | '}' => depth += 1,
            '[' | '(' | '{' => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            let start = all.range().start;
            let before = inner[..at].trim().trim_end_matches(['*', '·', '⋅', '×']);
            // Separators outside of the bracket: there is no bracket around all.
            if before.contains([',', ';']) || inner[close + 1..].contains([',', ';']) {
                return Ok((all, None, Span::new(to, to)));
            }
            let offset = inner.len() - inner.trim_start().len();
            let factor = (!before.is_empty())
                .then(|| Span::new(start + offset, start + offset + before.len()));
            let tail = Span::new(start + close + 1, all.range().end);
            return Ok((Span::new(start + at + 1, start + close), factor, tail));
        }
    }
    let at = all.range().start + close;
    Err(TypedError::new(Trouble::Bracket, at, at + 1))
}

/// Where the bracket closes with which a text begins.
fn first_bracket(text: &str) -> Option<usize> {
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

fn trimmed(text: &str, span: Span) -> Span {
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
