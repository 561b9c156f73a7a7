//! The symbols that stand beside equals signs and say what is answered.

use super::label::without_unit;
use super::list::cut_where;
use super::{Folded, Passage};
use crate::signs::is_of_name;
use vibank_source::Span;

/// Signs of a difference before a symbol.
const DIFFERENCES: [&str; 6] = ["Δ", "∆", "\\Delta", "Delta", "delta", "d"];

/// What stands before the first sign of equality or colon of a response, and where that begins.
pub fn label_in_front<'f>(response: &'f Folded<'_>) -> Option<(Passage<'f>, usize)> {
    let text = response.text();
    let end = text.find(['=', '≈', ':'])?;
    Some((Passage::of(&text[..end]), end))
}

/// What stands after the last sign of equality of a response that begins with a value, and where the value ends.
pub fn label_behind<'f>(response: &'f Folded<'_>) -> Option<(Passage<'f>, usize)> {
    let (value, name) = response.text().rsplit_once(['=', '≈'])?;
    begins_value(value).then(|| (Passage::of(name), value.len()))
}

/// What stands before the first equals sign of each statement, or after the last where a value stands first; and what stands
/// before a colon.
pub(crate) fn labels(response: &str) -> Vec<Passage<'_>> {
    if !response.contains(['=', '≈', ':']) {
        return Vec::new();
    }
    let whole = Span::new(0, response.len());
    // `1 : 2` is a ratio.
    let is_colon =
        |at: usize| response[at..].starts_with(": ") && !response[..at].ends_with([' ', ':']);
    let is_end = |at: usize, char: char| ";,\n".contains(char) || is_colon(at);
    let label = |statement: Span| {
        let text = &response[statement.range()];
        let Some(end) = text.find(['=', '≈']) else {
            let is_led = response[statement.range().end..].starts_with(':');
            return is_led.then(|| Passage::of(text));
        };
        let last = text.rsplit(['=', '≈']).next().unwrap_or(text);
        let is_name = last.trim_start().starts_with(char::is_alphabetic);
        let is_last = is_name && begins_value(text);
        Some(Passage::of(if is_last { last } else { &text[..end] }))
    };
    let statements = cut_where(response, whole, is_end).into_iter();
    statements.filter_map(label).collect()
}

/// Whether a text begins as a number does.
pub(crate) fn begins_value(text: &str) -> bool {
    text.trim_start()
        .starts_with(|first: char| first.is_ascii_digit() || "+-.√(".contains(first))
}

/// A symbol without what may stand around it: bars, its unit in brackets.
pub(crate) fn without_frame(label: &str) -> &str {
    let label = without_unit(label.trim()).trim_matches(['|', '[', ']', ' ']);
    if let Some(inner) = label
        .strip_prefix('(')
        .and_then(|label| label.strip_suffix(')'))
    {
        return inner;
    }
    if !label.ends_with([')', ']']) {
        return label;
    }
    label
        .find(['(', '['])
        .map_or(label, |at| label[..at].trim_end())
}

/// What comes after the sign of a difference.
pub(crate) fn behind_difference(label: &str) -> Option<&str> {
    DIFFERENCES.iter().find_map(|sign| label.strip_prefix(sign))
}

/// The letter of a name, and its index: `omega_n`, `k1`.
pub fn parted(name: &str) -> (&str, &str) {
    let end = name
        .find(|char: char| char == '_' || char.is_ascii_digit())
        .unwrap_or(name.len());
    (&name[..end], name[end..].trim_start_matches('_'))
}

/// Whether a name is that of a frequency, of which the lower one is the first by custom; roots and places are numbered
/// as one likes.
pub(crate) fn is_frequency(name: &str) -> bool {
    const LETTERS: [&str; 6] = ["omega", "ω", "w", "Omega", "Ω", "f"];
    let name = name.trim_start_matches('\\');
    let behind = LETTERS.iter().find_map(|letter| name.strip_prefix(letter));
    behind.is_some_and(|behind| !behind.starts_with(char::is_alphabetic))
}

/// Whether a name stands for something that is made of a complex number, `|Z|`, `Re(Z)`, `arg Z`, `Z*`; a bar or a line
/// below marks phasors, too.
pub(crate) fn is_made_of_complex(name: &str) -> bool {
    name.starts_with(['|', '∠']) || name.ends_with('*') || behind_part_of_complex(name).is_some()
}

/// What comes after the word for a part of a complex number, `Z` of `arg Z` and of `Re(Z)`.
pub(crate) fn behind_part_of_complex(name: &str) -> Option<&str> {
    const MADE: [&str; 10] = [
        "Re",
        "Im",
        "conj",
        "arg",
        "abs",
        "mod",
        "\\Re",
        "\\Im",
        "\\arg",
        "\\operatorname",
    ];
    let mut behind = MADE.iter().filter_map(|made| name.strip_prefix(made));
    let behind = behind.find(|behind| !behind.starts_with(is_of_name))?;
    Some(behind.trim_matches([' ', '(', ')', '[', ']']))
}

/// Whether a text is no more than a symbol: letters, digits, and what subscripts are written with.
pub(crate) fn is_symbol(text: &str) -> bool {
    // Symbols with their subscripts are shorter; a longer side is a formula.
    const MAX_LENGTH: usize = 30;
    let mut chars = text.chars();
    text.len() <= MAX_LENGTH && chars.all(|char| is_of_name(char) || "{}\\()'|, ".contains(char))
}
