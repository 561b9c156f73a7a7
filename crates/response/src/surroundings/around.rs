//! Marks, brackets and calls of programs around a whole answer.

use crate::list::cut;
use crate::signs::QUOTES;
use vibank_source::Span;

/// The lengths of the marks around an answer.
pub(crate) fn quotes(text: &str) -> Option<(usize, usize)> {
    // A star or two underscores that begin a text multiply nothing, whatever is multiplied between them.
    for mark in ["*", "__"] {
        let inner = text
            .strip_prefix(mark)
            .and_then(|text| text.strip_suffix(mark));
        let inner = inner.filter(|_| !text.starts_with("**"));
        if inner.is_some_and(|inner| !inner.trim().is_empty() && !inner.ends_with('^')) {
            return Some((mark.len(), mark.len()));
        }
    }
    QUOTES.iter().find_map(|(open, close)| {
        let inner = text.strip_prefix(open)?.strip_suffix(close)?;
        let is_whole = !inner.trim().is_empty() && !inner.contains(open) && !inner.contains(close);
        is_whole.then_some((open.len(), close.len()))
    })
}

/// The lengths of the fence around a block of code, with the language after its first mark.
pub(crate) fn fence(text: &str) -> Option<(usize, usize)> {
    const MARK: &str = "```";
    let inner = text.strip_prefix(MARK)?.strip_suffix(MARK)?;
    let own = match inner.split_once('\n') {
        Some((line, own)) if line.trim().bytes().all(|byte| byte.is_ascii_alphabetic()) => own,
        _ => inner,
    };
    let is_whole = !own.trim().is_empty() && !own.contains(MARK);
    is_whole.then(|| (text.len() - MARK.len() - own.len(), MARK.len()))
}

/// The lengths of what programs write around a function or a solution: `Function[t, …]`, `{{x -> …}}`.
pub(crate) fn program(text: &str) -> Option<(usize, usize)> {
    const HEADS: &[&str] = &["Function[t,", "Function[{t},", "Function[t_,"];
    let head = HEADS.iter().find(|head| text.starts_with(**head));
    if let Some(head) = head.filter(|_| text.ends_with(']')) {
        return Some((head.len(), 1));
    }
    // `span{(1, 0), (0, 1)}`
    let spans = [("span{", '}'), ("span(", ')'), ("span\\{", '}')];
    let span = spans
        .iter()
        .find(|(head, end)| text.starts_with(head) && text.ends_with(*end));
    if let Some((head, _)) = span.filter(|(head, _)| text.len() > head.len() + 2) {
        return Some((head.len(), if text.ends_with("\\}") { 2 } else { 1 }));
    }
    let between = |open: &str, close| text.strip_prefix(open)?.strip_suffix(close);
    let (inner, length) = match between("\\{", "\\}") {
        Some(inner) => (inner, 2),
        None => (between("{", "}")?, 1),
    };
    // `{x1(t) = …, x2(t) = …}`, as Maple gives solutions.
    let is_set = || {
        let pieces = cut(inner, Span::new(0, inner.len()), &[',', ';']);
        let mut texts = pieces.iter().map(|piece| &inner[piece.range()]);
        let others = ['<', '>', '!', '|', '{', '}'];
        pieces.len() > 1 && texts.all(|text| text.contains('=') && !text.contains(others))
    };
    (text.contains("->") && !inner.is_empty() || is_set()).then_some((length, length))
}

/// Whether brackets stand around a whole statement, `(x = 3 m)`.
pub(crate) fn bracketed(text: &str) -> bool {
    let inner = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let Some(inner) =
        inner.filter(|inner| !inner.contains([',', ';', '<', '>', '≤', '≥', '!', '|']))
    else {
        return false;
    };
    let mut depth = 0_i32;
    let is_whole = inner.chars().all(|char| {
        depth += match char {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth >= 0
    });
    is_whole && inner.contains('=')
}
