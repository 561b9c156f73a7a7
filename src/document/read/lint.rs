//! Dollar signs and brackets that look like math and are printed as they stand.

use std::ops::Range;

use super::TextError;
use crate::math::{LatexError, faults};
use crate::source::Span;

/// Looks through words for what was meant as math.
#[derive(Default)]
pub(crate) struct Lint {
    /// Up to where a finding has been reported; its closing dollar sign is none of its own.
    reported: usize,
}

impl Lint {
    /// The first thing in the words at `range` of a text that was meant as math.
    pub(crate) fn stray_math(
        &mut self,
        text: &str,
        in_cell: bool,
        range: Range<usize>,
    ) -> Option<TextError> {
        let is_escaped = |at: usize| text[..at].ends_with('\\');
        if is_escaped(range.start) {
            return bracket(text, range.start);
        }
        let start = range.start.max(self.reported);
        let at = text
            .get(start..range.end)?
            .match_indices('$')
            .map(|(at, _)| start + at)
            .find(|at| !is_escaped(*at))?;
        let (error, end) = dollar(text, in_cell, at);
        self.reported = end;
        Some(error)
    }
}

/// A bracket after a backslash, if one closes it further on and a formula stands between.
fn bracket(text: &str, at: usize) -> Option<TextError> {
    let sign = text[at..].chars().next()?;
    let closing = match sign {
        '(' => r"\)",
        '[' => r"\]",
        _ => return None,
    };
    let inside = &text[at + 1..at + text[at..].find(closing)?];
    let is_formula = sign == '(' || inside.contains(['\\', '^', '_', '=']);
    let span = Span::new(at - 1, at + 1);
    is_formula.then(|| LatexError::BracketMath { sign, span }.into())
}

/// What is wrong with the dollar sign at a place, and where what it was meant to open ends.
fn dollar(text: &str, in_cell: bool, at: usize) -> (TextError, usize) {
    let after = &text[at + 1..];
    if let Some(rest) = after.strip_prefix('$') {
        let blank = |inside: &str| inside.contains("\n\n") || inside.contains("\n\r\n");
        if let Some(end) = rest.find("$$").filter(|end| blank(&rest[..*end])) {
            let span = Span::new(at, at + 2);
            return (TextError::BlankLineInMath { span }, at + end + 4);
        }
    }
    let span = Span::new(at, at + 1);
    let line = &after[..after.find('\n').unwrap_or(after.len())];
    let Some(end) = line.find('$') else {
        return (TextError::LoneDollar { span }, at + 1);
    };
    let inside = &line[..end];
    let error = if in_cell && inside.contains('|') {
        TextError::BarInCell { span }
    } else if let Some(error) = unbalanced(inside) {
        let place = error.span().shifted(at + 1);
        error.at(place).into()
    } else if inside.starts_with([' ', '\t']) || inside.ends_with([' ', '\t']) {
        TextError::SpacedMath { span }
    } else {
        return (TextError::LoneDollar { span }, at + 1);
    };
    (error, at + end + 2)
}

/// Braces that do not match, for which the Markdown parser refuses to see a formula.
fn unbalanced(inside: &str) -> Option<LatexError> {
    faults(inside).into_iter().find(|error| {
        matches!(
            error,
            LatexError::Unbalanced { .. } | LatexError::MathInText { .. }
        )
    })
}
