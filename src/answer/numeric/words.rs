//! Units that do not fit as they are written, but would in another way.

use super::super::Why;
use crate::unit::{Dimension, Unit};

/// How a unit was meant that fits only if it is written with small letters or with a space: `rad/S` for `rad/s`,
/// `ms⁻¹` for `m·s⁻¹`.
pub(super) fn miswritten(typed: &Unit, asked: &Unit) -> Option<Why> {
    let text = typed.text();
    let fits = |text: &str| {
        let unit = Unit::read(text).ok()?;
        (unit.dimension() == asked.dimension() && !unit.is_one()).then_some(unit)
    };
    if text == "g" && Ok(asked.dimension()) == Dimension::parse("m/s^2") {
        return Some(Why::Gram);
    }
    if let Some(small) = fits(&text.to_ascii_lowercase()) {
        let meant = small.text();
        return Some(Why::Capitals { meant, typed: text });
    }
    let spaced = [("ms", "m·s"), ("rad⁻", "rad·s⁻")]
        .iter()
        .find_map(|(run, meant)| fits(&text.replace(run, meant)))?;
    Some(Why::SpaceInUnit {
        read: text,
        meant: spaced,
    })
}

/// What is wrong with cycles or turns where a pure number is asked: whether they count or measure angles is open.
pub(super) fn counts(typed: &Unit, asked: &Unit) -> Option<Why> {
    let is_turn = asked.is_one() && typed.text() == "rev";
    is_turn.then_some(Why::NumberAlone)
}
