//! Numbers and letters before the answers of a list.

use std::ops::Range;

use super::before::is_of_motion;
use crate::signs::{is_digit, is_minus};

/// The length of a number or letter before an answer, as the parts of a sheet have: `1) 5 m`, `(a) x = 5 m`, `1. -5 m`.
pub(crate) fn number_of_item(text: &str) -> Option<usize> {
    if let Some(length) = label_of_field(text) {
        return Some(length);
    }
    let open = usize::from(text.starts_with('('));
    let label = text[open..].chars().next()?;
    let behind = &text[open + label.len_utf8()..];
    let is_number = label.is_ascii_digit();
    if !is_number && !('a'..='h').contains(&label) || !enumeration(text).is_empty() {
        return None;
    }
    let begins_value = |behind: &str| {
        let behind = behind.trim_start();
        let unsigned = behind.strip_prefix(is_minus).unwrap_or(behind);
        unsigned.starts_with(is_digit)
    };
    let (is_label, behind) = if let Some(behind) = behind.strip_prefix(')') {
        // Of a choice, `a) static`, letters are answers. `(2) x` may be a product; `(1) 5 m` is the same either way.
        let is_statement = behind.contains('=') || begins_value(behind);
        // The brackets of `1) 5 m 2) 6 m` are of several answers.
        let is_one = behind.matches('(').count() == behind.matches(')').count();
        let may_be_label = !is_number || label == '1';
        let is_sure = is_number && open == 0 || may_be_label && is_statement;
        (is_one && is_sure, behind)
    } else {
        let behind = behind.strip_prefix('.').filter(|_| open == 0)?;
        // `1. m` is a metre.
        let begins = behind
            .trim_start()
            .starts_with(|next: char| next.is_alphabetic() || next == '\\');
        let is_equation = label == '1' && begins && behind.contains('=');
        (is_number && (is_equation || begins_value(behind)), behind)
    };
    let is_apart = behind.starts_with(' ')
        && !behind.trim().is_empty()
        && !behind.trim_start().starts_with('=');
    (is_label && is_apart).then(|| text.len() - behind.len())
}

/// The length of a letter with a number before an answer, as the fields of a sheet have: `a1) m x'' = …`, `d2) (1, -1)`,
/// `b.2) 5 m`, `a1. x = 5 m`.
fn label_of_field(text: &str) -> Option<usize> {
    let digit = |char: char| ('1'..='9').contains(&char);
    // Any other letter in brackets may be a coefficient, `(c1) x' + k x = 0`.
    if let Some(behind) = text
        .strip_prefix("(a")
        .and_then(|text| text.strip_prefix(digit))
    {
        let behind = behind
            .strip_prefix(") ")
            .filter(|behind| is_of_motion(behind))?;
        return Some(text.len() - behind.len());
    }
    let behind = text.strip_prefix(|first: char| ('a'..='h').contains(&first))?;
    let behind = behind.strip_prefix('.').unwrap_or(behind);
    let behind = behind.strip_prefix(digit)?;
    let (behind, is_sure) = match behind.strip_prefix(')') {
        Some(behind) => (behind, true),
        None => {
            let behind = behind.strip_prefix(['.', ':'])?;
            (behind, behind.contains('='))
        }
    };
    // Of `c1) … c2) …` each is an answer of its own.
    let is_one = behind.matches('(').count() == behind.matches(')').count();
    let is_apart = behind.starts_with(' ') && !behind.trim().is_empty();
    (is_sure && is_one && is_apart).then(|| text.len() - behind.len())
}

/// The labels of several answers, `1) … 2) …`, `(a) … (b) …`, `1. x = … 2. y = …`; none where that is not how the text
/// goes.
pub(crate) fn enumeration(text: &str) -> Vec<Range<usize>> {
    const STYLES: [(&str, char, &str); 5] = [
        ("", '1', ")"),
        ("(", '1', ")"),
        ("", 'a', ")"),
        ("(", 'a', ")"),
        ("", '1', "."),
    ];
    let start = text.trim_start();
    let head = start.strip_prefix('(').unwrap_or(start);
    let rows = rows_in_words(text);
    if !rows.is_empty() {
        return rows;
    }
    let is_label = head.starts_with(['1', 'a']) && matches!(head.get(1..3), Some(") " | ". "));
    if !is_label {
        return Vec::new();
    }
    let mut found = STYLES.into_iter().map(|(open, first, close)| {
        let labels = labels(text, open, first, close);
        let are_labels = labels.len() > 1 && are_apart(text, &labels, close);
        labels.into_iter().filter(|_| are_labels).collect()
    });
    found
        .find(|labels: &Vec<_>| !labels.is_empty())
        .unwrap_or_default()
}

/// The words before the rows of a matrix, `first row: …; second row: …`.
fn rows_in_words(text: &str) -> Vec<Range<usize>> {
    const ROWS: [&[&str]; 2] = [
        &["first row:", "second row:", "third row:"],
        &["row 1:", "row 2:", "row 3:"],
    ];
    let start = text.len() - text.trim_start().len();
    let head = &text[start..];
    let Some(words) = ROWS.iter().find(|words| head.starts_with(words[0])) else {
        return Vec::new();
    };
    let found = words.iter().map_while(|words| {
        let at = text.find(words)?;
        Some(at..at + words.len())
    });
    let found: Vec<_> = found.collect();
    if found.len() > 1 { found } else { Vec::new() }
}

/// The labels of one style that follow each other in a text, the first one at its start.
fn labels(text: &str, open: &str, first: char, close: &str) -> Vec<Range<usize>> {
    const MAX_LABELS: u8 = 6;
    let (mut found, mut at) = (Vec::new(), text.len() - text.trim_start().len());
    for label in (0..MAX_LABELS).map(|place| char::from(first as u8 + place)) {
        let label = format!("{open}{label}{close} ");
        let place = if found.is_empty() {
            text[at..].starts_with(&label).then_some(at)
        } else {
            let mut next = text[at..].match_indices(&label);
            let next = next.find(|(place, _)| text[..at + place].ends_with([' ', '\n']));
            next.map(|(place, _)| at + place)
        };
        let Some(place) = place else { break };
        at = place + label.len() - 1;
        found.push(place..at);
    }
    found
}

/// Whether a statement comes after each label: `(1) + (2) x` and `1. m + 2. m` are sums.
fn are_apart(text: &str, labels: &[Range<usize>], close: &str) -> bool {
    let ends = labels[1..]
        .iter()
        .map(|label| label.start)
        .chain([text.len()]);
    let mut pieces = labels
        .iter()
        .zip(ends)
        .map(|(label, end)| text[label.end..end].trim());
    pieces.all(|piece| {
        let goes_on = piece.ends_with(['+', '-', '*', '/', '=', '<', '>', '(', '^']);
        let is_statement = piece.contains('=') || piece.starts_with(is_digit);
        // A number with a point is a label only where it can be no factor.
        let is_sure = close == ")" || is_statement || labels.len() > 2;
        !piece.is_empty() && !goes_on && is_sure
    })
}
