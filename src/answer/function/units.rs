//! Units in a function of time: behind its terms, behind their numbers, or behind the whole.

use std::ops::Range;

use crate::unit::{Decimal, DecimalMark, Unit};

/// A function whose terms have units.
pub(super) struct Measured {
    /// Without the units.
    pub(super) bare: String,
    /// With a factor 2 for each unit: twice the function, if each of its terms has one.
    pub(super) doubled: String,
    pub(super) unit: Unit,
}

/// The function with the units taken out that stand behind numbers and brackets; none if there are none, or different ones.
/// The letter of the variable is no unit.
pub(super) fn measured(
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

/// Whether a letter stands alone in the text of a unit.
pub(super) fn contains_letter(unit: &str, letter: &str) -> bool {
    unit.split(|char: char| !char.is_alphabetic())
        .any(|word| word == letter)
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

/// The unit that begins here, behind spaces.
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
