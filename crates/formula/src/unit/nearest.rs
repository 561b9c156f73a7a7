//! The unit that somebody may have meant.

use std::ops::Range;

use vibank_source::EditDistance;

use super::error::{Error, ErrorKind};
use super::table::{Found, PREFIXES, ROWS, prefix, word};

/// The error about a name that is not a unit.
pub(crate) fn unknown(name: &str, span: Range<usize>) -> Error {
    Error::new(
        ErrorKind::UnknownUnit {
            found: name.to_owned(),
        },
        span,
    )
}

/// The symbol of the unit whose symbol or word is nearest, if one is near.
pub(crate) fn nearest(name: &str) -> Option<String> {
    if let Some(found) = word(name) {
        return Some(spelled(found));
    }
    let known = FOREIGN
        .iter()
        .find(|(names, _)| names.split(' ').any(|own| own.eq_ignore_ascii_case(name)));
    if let Some((_, meant)) = known {
        return Some((*meant).to_owned());
    }
    // One letter is near to everything.
    if name.chars().count() == 1 {
        return None;
    }
    if let Some(same) = all().find(|&found| is_symbol_but_for_case(name, found)) {
        return Some(spelled(same));
    }
    // Short names are near to everything: there only the case may differ.
    let bound = name.chars().count() / 4;
    if bound == 0 || name.len() > MAX_LENGTH {
        return None;
    }
    let candidates = all().flat_map(|found| {
        let row = &ROWS[usize::from(found.row)];
        let (symbol, word) =
            prefix(found.prefix).map_or(("", ""), |prefix| (prefix.symbols[0], prefix.word));
        let words = row.words.iter().map(move |&name| (found, word, name));
        words.chain([(found, symbol, row.symbols[0])])
    });
    let distance = EditDistance::from_word(name);
    candidates
        .filter_map(|(found, head, tail)| {
            let spelled = head.chars().chain(tail.chars());
            Some((distance.word(spelled, bound)?, found))
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, found)| spelled(found))
}

/// Names of other places and trades, with the unit to give the value in.
const FOREIGN: [(&str, &str); 13] = [
    ("in inch inches mil mils thou", "mm"),
    ("ft foot feet yd yard yards", "m"),
    ("lb lbs lbm pound pounds slug slugs oz", "kg"),
    ("lbf ozf kip kips kp dyn dyne", "N"),
    ("psi ksi atm", "Pa"),
    ("mph kph kmph", "km/h"),
    ("cps", "Hz"),
    ("cpm", "rpm"),
    ("tr tours umdrehungen u ups", "rev"),
    ("rd", "rad"),
    ("micron microns", "um"),
    ("hp ps cv", "W"),
    ("cal kcal erg", "J"),
];

/// The longest name that is compared.
const MAX_LENGTH: usize = 24;

/// All units, first without prefixes.
fn all() -> impl Iterator<Item = Found> {
    let rows = || (0..ROWS.len()).map(|row| row as u8);
    let prefixed = PREFIXES.iter().flat_map(move |prefix| {
        rows()
            .filter(|&row| ROWS[usize::from(row)].prefixes)
            .map(|row| Found {
                row,
                prefix: prefix.power,
            })
    });
    rows().map(|row| Found { row, prefix: 0 }).chain(prefixed)
}

fn is_symbol_but_for_case(name: &str, found: Found) -> bool {
    let head = prefix(found.prefix).map_or("", |prefix| prefix.symbols[0]);
    let Some((start, end)) = name.split_at_checked(head.len()) else {
        return false;
    };
    // A capital K is a slip for a kilo; other prefixes mean something else in the other case, and in `MM` either is one.
    let is_shouted = start.starts_with(char::is_uppercase) && end.len() == 1;
    (start == head && !is_shouted || start == "K" && head == "k")
        && end.eq_ignore_ascii_case(ROWS[usize::from(found.row)].symbols[0])
}

/// A unit with its prefix.
fn spelled(found: Found) -> String {
    let symbol = prefix(found.prefix).map_or("", |prefix| prefix.symbols[0]);
    format!("{symbol}{}", ROWS[usize::from(found.row)].symbols[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_the_unit_that_was_meant() {
        for (name, meant) in [
            ("newtn", "N"),
            ("hz", "Hz"),
            ("Newtons", "N"),
            ("radd", "rad"),
            ("kilogrm", "kg"),
            ("secnds", "s"),
            ("secodn", "s"),
            ("inches", "mm"),
            ("tr", "rev"),
        ] {
            assert_eq!(nearest(name).as_deref(), Some(meant), "{name}");
        }
        for name in ["q", "k", "NM", "MM", "f", "D"] {
            assert_eq!(nearest(name), None, "{name}");
        }
        assert_eq!(nearest("furlong"), None);
    }
}
