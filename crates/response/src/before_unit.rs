//! Units after formulas.

use super::Passage;
use vibank_formula::unit::Unit;

/// Most places that are tried for the beginning of the unit.
const MAX_PLACES: usize = 16;

/// A passage that may be a formula with a unit after it.
#[derive(Clone, Copy, Debug)]
pub struct BeforeUnit<'t> {
    /// What stands before the unit.
    pub formula: Passage<'t>,
    /// What stands last, read as a unit.
    pub unit: Unit,
    /// The unit as it was typed.
    pub typed: Passage<'t>,
    /// Whether a space stands between them.
    pub is_spaced: bool,
}

/// The ways to cut a text into a formula and a unit after it, the shortest unit first.
pub(crate) fn before_units(text: &str) -> impl Iterator<Item = BeforeUnit<'_>> {
    with_unit(text).map(|(formula, unit)| BeforeUnit {
        formula: Passage::of(formula),
        unit,
        typed: Passage::of(&text[formula.len()..]),
        is_spaced: formula.ends_with(char::is_whitespace),
    })
}

pub(crate) fn with_unit(text: &str) -> impl Iterator<Item = (&str, Unit)> {
    places(text).into_iter().rev().filter_map(|place| {
        let (formula, unit) = text.split_at(place);
        Some((formula, gathered(Unit::read(unit.trim()).ok()?)))
    })
}

/// A unit with each factor once, as a product of units has it: `deg deg` is what `° · °` is. Where an exponent would get
/// too large, it stays as it was typed.
pub(crate) fn gathered(unit: Unit) -> Unit {
    Unit::ONE.times(&unit).unwrap_or(unit)
}

/// Where a unit may begin: at a slash, and where letters or brackets begin.
fn places(text: &str) -> Vec<usize> {
    let mut places = Vec::new();
    let mut before = ' ';
    for (at, char) in text.char_indices() {
        let is_letter = |char: char| char.is_alphabetic() || "°º%µΩ\\".contains(char);
        // `2π 1/s`.
        let is_inverse = before == ' ' && text[at..].starts_with("1/");
        let begins = is_letter(char) && !is_letter(before) && before != '_'
            || "/([".contains(char)
            || is_inverse;
        if begins && at > 0 {
            places.push(at);
        }
        before = char;
    }
    let surplus = places.len().saturating_sub(MAX_PLACES);
    places.split_off(surplus)
}
