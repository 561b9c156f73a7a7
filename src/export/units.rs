//! Units that a box takes beside its own, for platforms that read them by a list.

use std::collections::BTreeSet;

use crate::unit::{KnownUnit, Unit};

/// Prefixes that people write; a list of all would be longer than the question.
const PREFIXES: [&str; 8] = ["", "G", "M", "k", "c", "m", "µ", "n"];

/// The unit of a box and those that are converted to it: as it is typed, with how many of it are one of the first.
///
/// Units by themselves come from the table of units; in a compound unit each factor takes its prefixes.
pub(crate) fn accepted(own: &Unit) -> Vec<(String, f64)> {
    let text = own.text();
    let mut found = vec![(text.clone(), 1.0)];
    let mut seen = BTreeSet::from([text.clone()]);
    let mut take = |candidate: String| {
        // A platform takes digits at the beginning for a part of the number.
        if candidate.starts_with(|sign: char| sign.is_ascii_digit()) || seen.contains(&candidate) {
            return;
        }
        let Ok(unit) = Unit::parse(&candidate) else {
            return;
        };
        let Ok(conversion) = unit.conversion(own) else {
            return;
        };
        let factor = own.of_si(conversion.apply(1.0));
        // Beyond a million to either side nobody types a unit on purpose.
        if (1e-6..=1e6).contains(&factor.abs()) {
            seen.insert(candidate.clone());
            found.push((candidate, 1.0 / factor));
        }
    };
    for known in KnownUnit::all() {
        for symbol in known.symbols {
            let prefixes = if known.takes_prefixes {
                &PREFIXES[..]
            } else {
                &PREFIXES[..1]
            };
            prefixes
                .iter()
                .for_each(|prefix| take(format!("{prefix}{symbol}")));
        }
    }
    let is_letter = |sign: char| sign.is_alphabetic();
    let mut from = 0;
    while let Some(start) = text[from..].find(is_letter).map(|at| from + at) {
        let length = text[start..].find(|sign| !is_letter(sign));
        let end = length.map_or(text.len(), |length| start + length);
        for prefix in PREFIXES {
            take(format!("{}{prefix}{}", &text[..start], &text[start..]));
        }
        from = end;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor(own: &str, typed: &str) -> Option<f64> {
        let all = accepted(&Unit::parse(own).expect("a unit"));
        all.iter()
            .find(|(text, _)| text == typed)
            .map(|(_, factor)| *factor)
    }

    #[test]
    fn units_come_with_how_many_are_one_of_the_first() {
        assert_eq!(factor("m", "m"), Some(1.0));
        assert_eq!(factor("m", "mm"), Some(1000.0));
        assert_eq!(factor("N/m", "N/mm"), Some(1e-3));
        assert_eq!(factor("N/m", "kN/m"), Some(1e-3));
        let cycles = factor("rad/s", "Hz").expect("it is taken");
        assert!((cycles - 0.5 / std::f64::consts::PI).abs() < 1e-15);
        assert_eq!(factor("m", "s"), None);
    }
}
