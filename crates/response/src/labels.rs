//! Symbols before the pieces of a list: `x1 = 1, x2 = 0.291`, `u2 = (1, 0, -1)`, `mode 1: (1, 1.414, 1)`.

use super::list::{cut, trimmed};
use super::words::RANKS;
use super::{Trouble, TypedError};
use crate::signs::{is_digit, is_digit_or_index};
use vibank_dynamics::numerics::SortedMap;
use vibank_source::{Span, lower};

/// The symbol before a piece, and the piece without it.
pub(crate) fn labelled(text: &str, piece: Span) -> (Option<Span>, Span) {
    let piece = trimmed(text, piece);
    let own = &text[piece.range()];
    let (mut depth, mut end) = (0_usize, None);
    for (at, char) in own.char_indices() {
        let next = &own[at + char.len_utf8()..];
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            '=' | '≈' if depth == 0 => end = Some(own.len() - next.len()),
            ':' if depth == 0 && next.trim_start().starts_with(['(', '[', '{']) => {
                end = Some(own.len() - next.len());
            }
            _ => {}
        }
    }
    let Some(end) = end else {
        return (None, piece);
    };
    let start = piece.range().start;
    let rest = Span::new(start + end, piece.range().end);
    (Some(Span::new(start, start + end)), trimmed(text, rest))
}

/// Refuses symbols whose numbers do not ascend: what they name may stand in another order than what is asked.
/// One symbol alone names the whole.
pub(crate) fn in_order(text: &str, labels: &[Option<Span>]) -> Result<(), TypedError> {
    let labels: Vec<Span> = labels.iter().flatten().copied().collect();
    if let Some(label) = labels
        .iter()
        .find(|label| is_computed(&text[label.range()]))
    {
        return Err(TypedError {
            trouble: Trouble::Unsolved,
            span: *label,
        });
    }
    let mut last = None;
    for label in labels.iter().filter(|_| labels.len() > 1) {
        let place = place(&text[label.range()]);
        if place <= last {
            return Err(TypedError {
                trouble: Trouble::Order,
                span: *label,
            });
        }
        last = place;
    }
    Ok(())
}

/// Whether what stands before an equals sign is made of what is asked, and is another value: `K⁻¹`, `2K`, `det K`.
/// Any other power may number a mode.
fn is_computed(label: &str) -> bool {
    const FUNCTIONS: [&str; 5] = ["inv", "det", "\\det", "sqrt", "\\sqrt"];
    let label = label.trim_start();
    let mut arguments = FUNCTIONS.iter().filter_map(|name| label.strip_prefix(name));
    let factor =
        label.trim_start_matches(|char: char| char.is_ascii_digit() || "./*".contains(char));
    let is_ordinal = ["st", "nd", "rd", "th"]
        .iter()
        .any(|end| factor.starts_with(end));
    let is_scaled =
        label.starts_with(is_digit) && factor.starts_with(char::is_alphabetic) && !is_ordinal;
    // `u_1^2` is a square where the index numbers the mode; `u^2`, `u^{(2)}` and `u_1^{(2)}` are modes.
    let is_square = label
        .split_once(['^', '²', '³'])
        .is_some_and(|(base, power)| {
            base.ends_with(|last| is_digit_or_index(last) || last == '}')
                && power
                    .trim_end_matches([' ', '=', ':', '≈'])
                    .chars()
                    .all(is_digit)
        });
    label.starts_with('-')
        || is_scaled
        || is_square
        || ["^-", "^{-", "≠"].iter().any(|sign| label.contains(sign))
        || arguments.any(|rest| rest.starts_with([' ', '(', '{', '\\']))
}

/// The rows of a matrix whose entries have symbols with two indices, in any order and several for one value,
/// `K22 = k, K12 = K21 = -k, K11 = 2k`; nothing where not each entry is given once. The value comes after its first
/// symbol, and others may follow: `K12 = -k = K21`.
pub(crate) fn by_indices(text: &str, pieces: &[Span]) -> Option<Vec<Vec<Span>>> {
    let mut entries = SortedMap::new();
    for piece in pieces {
        let mut sides = cut(text, *piece, &['=', '≈']);
        let is_value = |side: &Span| indices(&text[side.range()]).is_none();
        // `K11 = k11` has a letter of the question as its value.
        let value = sides.iter().position(is_value).unwrap_or(sides.len() - 1);
        let value = sides.remove(value);
        if sides.is_empty() || value.range().start == piece.range().start {
            return None;
        }
        for symbol in sides {
            if entries
                .insert(indices(&text[symbol.range()])?, value)
                .is_some()
            {
                return None;
            }
        }
    }
    let (rows, columns) = *entries.keys().next_back()?;
    let is_whole = rows > 1 && entries.len() == (rows * columns) as usize;
    let due = (1..=rows).flat_map(|row| (1..=columns).map(move |column| (row, column)));
    if !is_whole || !due.eq(entries.keys().copied()) {
        return None;
    }
    let places: Vec<Span> = entries.values().copied().collect();
    Some(
        places
            .chunks(columns as usize)
            .map(<[Span]>::to_vec)
            .collect(),
    )
}

/// The two indices of a symbol of an entry, `K12`, `K_{12}`, `k_{1,2}`, `K₁₂`.
fn indices(symbol: &str) -> Option<(u32, u32)> {
    let name = symbol.trim().trim_start_matches(char::is_alphabetic);
    let mut chars = name.chars();
    let is_named = name.len() < symbol.trim().len()
        && chars.all(|char| is_digit_or_index(char) || "_{},() ".contains(char));
    let both = number(name).filter(|both| is_named && (11..=99).contains(both) && both % 10 > 0)?;
    Some((both / 10, both % 10))
}

/// The place of a label among others: its number with what comes after that, `2a`, or what its word says, `first`.
fn place(label: &str) -> Option<(u32, &str)> {
    let label = label.trim_end_matches([' ', '=', ':', '≈', '}', ')']);
    let word = lower(label);
    let rank = RANKS
        .iter()
        .find(|(own, _)| *own == word)
        .and_then(|(_, rank)| *rank);
    let number = rank.map(u32::from).or_else(|| number(label))?;
    let letters = label.rsplit(is_digit_or_index).next();
    Some((number, letters.unwrap_or_default()))
}

/// The number in a symbol, `2` of `x_2` and `ω₂`; a ratio of symbols has none.
fn number(label: &str) -> Option<u32> {
    if label.contains('/') {
        return None;
    }
    let digits = label.chars().filter_map(|char| match char {
        '₀'..='₉' => Some(u32::from(char) - u32::from('₀')),
        char => char.to_digit(10),
    });
    let digits: Vec<u32> = digits.collect();
    let number = digits.iter().take(6).fold(0, |sum, digit| 10 * sum + digit);
    (!digits.is_empty()).then_some(number)
}
