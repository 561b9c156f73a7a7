//! Lists whose entries have units of their own: `(1 m, -7.5 rad)`, `[2.3 kg, 0; 0, 0.26 kg m²]`.

use super::before_unit::with_unit;
use super::signs::is_between_digits;
use vibank_dynamics::numerics::Rational;
use vibank_formula::unit::{Dimension, Unit};

/// A list without the units of its entries, where each entry but a zero has that of its place, or all are scaled alike;
/// nothing where another unit stands in it, or none.
pub(crate) fn without(text: &str, units: &[Unit], may_be_scaled: bool) -> Option<String> {
    let entries = entries(text);
    if entries.len() != units.len() || units.len() < 2 {
        return None;
    }
    let all: Vec<Vec<(&str, Unit)>> = entries
        .iter()
        .map(|entry| numbers(&text[entry.clone()]))
        .collect();
    let scales = |own: &Unit, unit: &Unit| {
        (
            unit.dimension() / own.dimension(),
            unit.to_si(1.0) / own.to_si(1.0),
        )
    };
    let mut bases = vec![(Dimension::PURE, 1.0)];
    if may_be_scaled {
        let first = all.first()?.iter();
        bases = first.map(|(_, unit)| scales(&units[0], unit)).collect();
    }
    let is_same = |own: &Unit, unit: &Unit, base: (Dimension, f64)| {
        let (dimension, factor) = scales(own, unit);
        dimension == base.0 && (factor - base.1).abs() <= 1e-12 * base.1
    };
    let found = bases.into_iter().find_map(|base| {
        let numbers = all.iter().zip(units).map(|(own, unit)| {
            let fits = |(number, typed): &&(&str, Unit)| {
                is_same(unit, typed, base) || value(number) == Some(Rational::ZERO)
            };
            own.iter().find(fits).map(|(number, _)| *number)
        });
        numbers.collect::<Option<Vec<&str>>>()
    })?;
    let (mut bare, mut end) = (String::new(), 0);
    for (entry, number) in entries.into_iter().zip(found) {
        bare.push_str(&text[end..entry.start]);
        bare.push_str(number.trim_end());
        end = entry.end;
    }
    bare.push_str(&text[end..]);
    Some(bare)
}

/// Where the entries of a list stand, without its brackets.
fn entries(text: &str) -> Vec<std::ops::Range<usize>> {
    const AROUND: [char; 7] = ['(', ')', '[', ']', '{', '}', ' '];
    let ends = text.char_indices().filter(|(at, char)| match char {
        ',' => !is_between_digits(text, *at),
        char => matches!(char, ';' | ':' | '&' | '\n'),
    });
    let mut start = 0;
    let mut entries = Vec::new();
    for end in ends.map(|(at, _)| at).chain([text.len()]) {
        let piece = &text[start..end];
        let from = start + piece.len() - piece.trim_start_matches(AROUND).len();
        let inner = piece.trim_matches(AROUND);
        if !inner.is_empty() {
            entries.push(from..from + inner.len());
        }
        start = end + 1;
    }
    entries
}

/// The ways to read an entry as a number and a unit.
fn numbers(entry: &str) -> Vec<(&str, Unit)> {
    if value(entry).is_some() {
        return vec![(entry, Unit::ONE)];
    }
    let cut = with_unit(entry).filter(|(number, _)| value(number).is_some());
    cut.collect()
}

fn value(text: &str) -> Option<Rational> {
    Rational::from_decimal(&text.trim().replace(',', "."))
}

#[cfg(test)]
mod tests {
    use super::without;
    use vibank_formula::unit::Unit;

    #[test]
    fn entries_may_have_units_of_their_own() {
        let units = |all: &[&str]| -> Vec<Unit> {
            all.iter().map(|unit| Unit::parse(unit).unwrap()).collect()
        };
        for (text, own, bare) in [
            ("(1 m, -7.49 rad)", &["m", "rad"][..], Some("(1, -7.49)")),
            ("[1 m; -7,49 rad]", &["m", "rad"], Some("[1; -7,49]")),
            (
                "[2.3 kg, 0; 0, 0.263 kg m^2]",
                &["kg", "kg m", "kg m", "kg m^2"],
                Some("[2.3, 0; 0, 0.263]"),
            ),
            ("(1 m, 0)", &["m", "rad"], Some("(1, 0)")),
            ("(1 m, -7.49 m)", &["m", "rad"], None),
            ("(1 mm, -7.49 rad)", &["m", "rad"], None),
            ("(1, -7.49)", &["m", "rad"], None),
            ("(1 m, 2 rad, 3 m)", &["m", "rad"], None),
        ] {
            assert_eq!(without(text, &units(own), false).as_deref(), bare, "{text}");
        }
        let own = units(&["kg^(-1/2)", "1/(kg^(1/2) m)"]);
        for (text, bare) in [
            ("(1 m, -7.49 rad)", Some("(1, -7.49)")),
            ("(1, -7.49 1/m)", Some("(1, -7.49)")),
            ("(1 m, -7.49 m)", None),
            ("(1 mm, -7.49 rad)", None),
        ] {
            assert_eq!(without(text, &own, true).as_deref(), bare, "{text}");
        }
    }
}
