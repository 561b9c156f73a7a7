//! Where the statements of a response stand, `x = a, y = b`, and what each is of.

use super::list::{cut_where, trimmed};
use super::sides::is_word;
use super::signs::{is_between_digits, is_digit, is_of_name};
use super::words::STATEMENTS;
use vibank_source::Span;

/// A place that counts from so much further on.
pub(crate) fn moved(span: Span, by: usize) -> Span {
    Span::new(span.range().start + by, span.range().end + by)
}

/// What stands before the first equals sign of a statement.
pub(crate) fn label(text: &str, statement: Span) -> Option<Span> {
    let start = statement.range().start;
    let end = text[statement.range()].find(['=', '≈'])?;
    let label = trimmed(text, Span::new(start, start + end));
    (!label.range().is_empty()).then_some(label)
}

/// The statements of a text, each but the first with an equals sign; the text where it is one. What is only compared
/// with a statement, `ω = √(k/m) < ω_0`, is none.
pub(crate) fn statements(text: &str) -> Vec<Span> {
    statements_by(text, word_at)
}

/// The same with other words that join statements, by their length.
pub(crate) fn statements_by(text: &str, joint_at: impl Fn(&str) -> Option<usize>) -> Vec<Span> {
    const RELATIONS: [char; 4] = ['<', '>', '≤', '≥'];
    let whole = vec![Span::new(0, text.len())];
    if !text.contains(['=', '≈']) {
        return whole;
    }
    let (before, bracketed) = match bracketed(text) {
        Some((before, inner)) => (before, Some(inner)),
        None => (text.len(), None),
    };
    let first = text.split(['=', '≈']).next().unwrap_or(text).trim();
    let is_end = |at: usize, char: char| match char {
        ';' | '\n' => true,
        '/' => is_before_sibling(text, at, first),
        ',' => !is_between_digits(text, at),
        '.' => is_full_stop(text, at),
        ' ' => joint_at(&text[at + 1..]).is_some(),
        ':' => joint_at(&text[at..]).is_some(),
        char => RELATIONS.contains(&char),
    };
    let parts = [Some(Span::new(0, before)), bracketed]
        .into_iter()
        .flatten();
    let mut found: Vec<Span> = Vec::new();
    for piece in parts.flat_map(|part| cut_where(text, part, is_end)) {
        let mut own = trimmed(text, piece);
        // `, where ω = …`
        while let Some(length) = joint_at(&text[own.range()]).filter(|_| !found.is_empty()) {
            own = trimmed(text, Span::new(own.range().start + length, own.range().end));
        }
        // `, i.e. x'' = …`; `I = …, with r = R, = …` goes on with what the statement before is about.
        if !found.is_empty()
            && let Some(behind) = text[own.range()].strip_prefix('=')
            && behind.contains(['=', '≈'])
        {
            own = trimmed(text, Span::new(own.range().start + 1, own.range().end));
        }
        if own.range().is_empty() {
            continue;
        }
        let is_statement = |own: Span| text[own.range()].contains(['=', '≈']);
        let is_compared = text[..piece.range().start].ends_with(RELATIONS);
        match found.first() {
            None => found.push(own),
            Some(_) if is_statement(own) => found.push(own),
            Some(first) if is_compared && is_statement(*first) => {}
            Some(_) => return whole,
        }
        // `μ m g ≥ F, μ = …` begins with an inequality.
        let is_compared_next = text[piece.range().end..].starts_with(RELATIONS);
        if is_compared_next && !is_statement(own) {
            return whole;
        }
    }
    if found.is_empty() { whole } else { found }
}

/// Whether a statement says what a function is nearly, `sin θ ≈ θ`, `cos θ ≈ 1`, and is no equation beside others.
pub(crate) fn is_approximation(statement: &str) -> bool {
    const AROUND: [char; 4] = [' ', '(', ')', '\\'];
    let parted = |side: &'_ str| {
        let side = side.trim_matches(AROUND);
        let mut names = ["sin", "tan", "cos"].into_iter();
        let found = names.find_map(|name| Some((Some(name), side.strip_prefix(name)?)));
        let (name, argument) = found.unwrap_or((None, side));
        (name, argument.trim_matches(AROUND).to_owned())
    };
    let mut sides = statement.split('≈').map(parted);
    let Some((Some(name), argument)) = sides.next() else {
        return false;
    };
    let nearly = if name == "cos" { "1" } else { &argument };
    statement.contains('≈') && sides.all(|(_, side)| side == nearly)
}

/// Whether the point at a place ends a statement before another one, `N = m g. m x'' = -μ N`.
fn is_full_stop(text: &str, at: usize) -> bool {
    let (before, behind) = (&text[..at], &text[at + 1..]);
    let next = behind.strip_prefix([' ', '\n']).unwrap_or_default();
    // `2. x = 3` may be the second one of a list.
    let ends_in_number =
        before.ends_with(is_digit) && !before.trim_end_matches(is_digit).ends_with(is_of_name);
    before.contains(['=', '≈'])
        && !ends_in_number
        && next.starts_with(|next: char| next.is_alphabetic() || next == '\\')
        && next.contains(['=', '≈'])
}

/// Whether the slash at a place parts two statements, `ω1 = 2 / ω2 = 3`: after it a letter of the first one's kind stands
/// before an equals sign.
fn is_before_sibling(text: &str, at: usize, first: &str) -> bool {
    let Some((sibling, _)) = text[at + 1..].split_once(['=', '≈']) else {
        return false;
    };
    let sibling = sibling.trim();
    let stem = |word: &str| {
        word.trim_end_matches(|last: char| !last.is_alphabetic())
            .len()
    };
    let is_apart = text[..at].ends_with(' ') && text[at + 1..].starts_with(' ');
    is_apart
        && sibling != first
        && is_word(first)
        && is_word(sibling)
        && sibling[..stem(sibling)] == first[..stem(first)]
}

/// The length of the word with which a text begins and that joins statements.
pub(crate) fn word_at(text: &str) -> Option<usize> {
    let mut words = STATEMENTS.iter().filter(|word| {
        // `N = m g. So m x'' = -μ N`
        let own = text.get(..word.len());
        own.is_some_and(|own| own.eq_ignore_ascii_case(word))
    });
    let found = words.find(|word| text[word.len()..].starts_with([' ', ',', ':']));
    found.map(|word| word.len())
}

/// The statements in brackets after a response, `(with ω = …)`, and where what stands before them ends.
fn bracketed(text: &str) -> Option<(usize, Span)> {
    let inner = text.strip_suffix(')')?;
    let mut depth = 0_usize;
    let (open, _) = inner.char_indices().rev().find(|(_, char)| match char {
        ')' => {
            depth += 1;
            false
        }
        '(' if depth == 0 => true,
        '(' => {
            depth -= 1;
            false
        }
        _ => false,
    })?;
    let is_apart = inner[..open].ends_with(' ') && inner[open..].contains('=');
    is_apart.then(|| (open, Span::new(open + 1, inner.len())))
}
