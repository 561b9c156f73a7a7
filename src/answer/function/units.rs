//! Units in a function of time: after its terms, after their numbers, or after the whole.

use std::ops::Range;

use crate::unit::{Decimal, DecimalMark, Dimension, Unit};

/// A function whose terms have units.
pub(crate) struct Measured {
    /// Without the units.
    pub(crate) bare: String,
    /// With a factor 2 for each unit: twice the function, if each of its terms has one.
    pub(crate) doubled: String,
    pub(crate) unit: Unit,
}

/// The function with the units taken out that come after numbers and brackets; none if there are none, or different ones.
/// The letter of the variable is not a unit.
pub(crate) fn measured(
    text: &str,
    variable: &str,
    fits: impl Fn(&Unit) -> bool,
) -> Option<Measured> {
    let found = places(text, variable, fits);
    let unit = found.first()?.1;
    let size = unit.to_si(1.0);
    let is_one_unit = found
        .iter()
        .all(|(_, other)| other.to_si(1.0).total_cmp(&size).is_eq());
    let with = |factor: &str| {
        let (mut written, mut from) = (String::new(), 0);
        for (place, _) in &found {
            written.push_str(&text[from..place.start]);
            written.push_str(factor);
            from = place.end;
        }
        written + &text[from..]
    };
    is_one_unit.then(|| Measured {
        bare: with(" "),
        doubled: with(" *2 "),
        unit,
    })
}

/// A function without the units of rates before its variable, `e^(-0.75 s⁻¹ t)`, `cos(5 rad/s t)`, `e^(-t/s)`: they make
/// its arguments pure numbers, in SI units as the bare ones are. Nothing where there are none, or where others stand
/// there.
pub(crate) fn without_rates(text: &str, variable: &str) -> Option<String> {
    let rate = Dimension::TIME.inverse();
    let is_rate =
        |unit: &Unit| unit.dimension() == rate && !unit.counts_cycles() && unit.to_si(1.0) == 1.0;
    let mut bare = text.to_owned();
    let over = format!("{variable}/s");
    while let Some(at) = letter_in(&bare, &over) {
        let end = at + over.len();
        bare.replace_range(at + variable.len()..end, "  ");
    }
    let mut at = 0;
    while let Some(end) = number_from(text, at) {
        at = end;
        let behind = &text[end..];
        let Some(unit) = letter_in(behind, variable).map(|letter| &behind[..letter]) else {
            break;
        };
        let unit = unit.trim_end_matches([' ', '*', ')']);
        let start = end + unit.len() - unit.trim_start().len();
        let written = unit.trim_start();
        if !written.is_empty() && Unit::read(written).is_ok_and(|unit| is_rate(&unit)) {
            bare.replace_range(
                start..end + unit.len(),
                &" ".repeat(end + unit.len() - start),
            );
        }
    }
    (bare != text).then_some(bare)
}

/// A function without the word before its unit, `… in mm`, and without the unit of its phases, `cos(4 t - 0.9 rad)`.
/// Nothing where there is neither.
pub(crate) fn without_words(text: &str) -> Option<String> {
    const WORD: &str = " in ";
    const RADIANS: &str = "rad";
    let mut bare = text.to_owned();
    if let Some((before, unit)) = text.rsplit_once(WORD)
        && Unit::read(unit.trim()).is_ok()
    {
        bare.replace_range(
            before.len()..before.len() + WORD.len(),
            &" ".repeat(WORD.len()),
        );
    }
    let mut at = 0;
    while let Some(end) = number_from(text, at) {
        at = end;
        let behind = text[end..].trim_start();
        let start = text.len() - behind.len();
        let is_last = |rest: &str| rest.trim_start().starts_with([')', ']']);
        if behind.strip_prefix(RADIANS).is_some_and(is_last) && is_in_wave(&text[..start]) {
            bare.replace_range(start..start + RADIANS.len(), &" ".repeat(RADIANS.len()));
        }
    }
    (bare != text).then_some(bare)
}

/// Whether the bracket that stands open after a text is that of a sine or cosine.
fn is_in_wave(before: &str) -> bool {
    let mut closed = 0_usize;
    let open = before.char_indices().rev().find(|(_, char)| match char {
        ')' | ']' => {
            closed += 1;
            false
        }
        '(' | '[' if closed > 0 => {
            closed -= 1;
            false
        }
        char => matches!(char, '(' | '['),
    });
    open.is_some_and(|(at, _)| {
        let name = before[..at].trim_end();
        ["cos", "sin", "Cos", "Sin", "COS", "SIN"]
            .iter()
            .any(|wave| name.ends_with(wave))
    })
}

/// The place of a letter that stands alone.
fn letter_in(text: &str, letter: &str) -> Option<usize> {
    let is_apart = |char: Option<char>| !char.is_some_and(char::is_alphanumeric);
    let places = text.match_indices(letter).map(|(at, _)| at);
    let mut alone = places.filter(|at| {
        is_apart(text[..*at].chars().next_back())
            && is_apart(text[at + letter.len()..].chars().next())
    });
    alone.next()
}

/// Whether a letter stands alone in the text of a unit.
pub(crate) fn contains_letter(unit: &str, letter: &str) -> bool {
    unit.split(|char: char| !char.is_alphabetic())
        .any(|word| word == letter)
}

/// Where the next number ends from a place on.
fn number_from(text: &str, from: usize) -> Option<usize> {
    let (mut at, mut before) = (from, text[..from].chars().next_back().unwrap_or(' '));
    while let Some(char) = text[at..].chars().next() {
        let begins = (char.is_ascii_digit() || char == '.')
            && !(before.is_alphanumeric() || "_.,".contains(before));
        let number = begins.then(|| Decimal::read(&text[at..], DecimalMark::Point).ok());
        if let Some((_, length)) = number.flatten() {
            return Some(at + length.max(1));
        }
        at += char.len_utf8();
        before = char;
    }
    None
}

/// Where units stand.
fn places(text: &str, variable: &str, fits: impl Fn(&Unit) -> bool) -> Vec<(Range<usize>, Unit)> {
    let mut found = Vec::new();
    let (mut at, mut before) = (0, ' ');
    while let Some(char) = text[at..].chars().next() {
        let rest = &text[at..];
        let begins_number = (char.is_ascii_digit() || char == '.')
            && !(before.is_alphanumeric() || "_.,".contains(before));
        let number = begins_number
            .then(|| Decimal::read(rest, DecimalMark::Point).ok())
            .flatten();
        let width = number.map_or(char.len_utf8(), |(_, length)| length.max(1));
        at += width;
        before = text[..at].chars().next_back().unwrap_or(' ');
        if (number.is_some() || ")]}".contains(char))
            && let Some((place, unit)) = unit_at(text, at)
            && fits(&unit)
            && !contains_letter(&text[place.clone()], variable)
        {
            at = place.end;
            before = ' ';
            found.push((place, unit));
        }
    }
    found
}

/// The unit that begins here, after spaces.
fn unit_at(text: &str, at: usize) -> Option<(Range<usize>, Unit)> {
    let rest = &text[at..];
    let start = at + rest.len() - rest.trim_start().len();
    let run = &text[start..];
    let end = if run.starts_with('\\') {
        run.find('}').map(|last| last + 1)
    } else {
        run.find(|char: char| " *+-,;()[]{}".contains(char))
    };
    let place = start..start + end.unwrap_or(run.len());
    let unit = Unit::read(&text[place.clone()]).ok();
    Some((place, unit.filter(|unit| !unit.is_one())?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_behind_numbers_and_brackets() {
        let length = Unit::parse("m").unwrap().dimension();
        for (typed, bare) in [
            (
                "146 mm e^(-t) + 54.1 mm e^(-9 t)",
                "146 e^(-t) + 54.1 e^(-9 t)",
            ),
            ("1.5×10^-5 m cos(2 t)", "1.5×10^-5 cos(2 t)"),
            ("(0.5 m)exp(-t)", "(0.5 )exp(-t)"),
            ("0.5 cos(2 t) m - 2 sin(t) m", "0.5 cos(2 t) - 2 sin(t)"),
            ("0.5m cos(2 t)", "0.5 cos(2 t)"),
        ] {
            let found = measured(typed, "t", |unit| unit.dimension() == length);
            let found = found.map(|found| {
                let words = found.bare.split_whitespace();
                words.collect::<Vec<_>>().join(" ")
            });
            assert_eq!(found.as_deref(), Some(bare), "{typed}");
        }
        for typed in ["0.5 cos(2 t)", "x1 m", "0.5 mm + 2 m", "2 t", "cos(2 rad)"] {
            let found = measured(typed, "t", |unit| unit.dimension() == length);
            assert!(found.is_none(), "{typed}");
        }
    }
}
