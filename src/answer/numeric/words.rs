//! Units that do not fit as they are written, but would in another way.

use crate::answer::Why;
use crate::unit::{Dimension, Rational, Unit};

/// The unit that is meant where that which was typed does not fit, and only one spelling apart does: `rad/s` for
/// `rad/S`, `m·s⁻¹` for `ms⁻¹`.
pub(crate) fn meant(typed: &Unit, asked: &Unit) -> Option<Unit> {
    let text = typed.text();
    let fits = |text: &str| {
        let unit = Unit::read(text).ok()?;
        (unit.dimension() == asked.dimension() && !unit.is_one()).then_some(unit)
    };
    fits(&text.to_ascii_lowercase()).or_else(|| {
        let mut runs = [("ms", "m·s"), ("rad⁻", "rad·s⁻")].into_iter();
        runs.find_map(|(run, meant)| fits(&text.replace(run, meant)))
    })
}

/// What is wrong with grams where an acceleration is asked.
pub(crate) fn gram(typed: &Unit, asked: &Unit) -> Option<Why> {
    let is_it = typed.text() == "g" && Ok(asked.dimension()) == Dimension::parse("m/s^2");
    is_it.then_some(Why::Gram)
}

/// What is wrong with a unit in which angles enter otherwise than in what is asked: `rad²/s` for `rad/s`. They may be
/// left out, be added once, and stand twice in what is made of the square of a frequency, such as `rad²/s²`.
pub(crate) fn angles(typed: &Unit, asked: &Unit) -> Option<Why> {
    let (own, due) = (typed.angles()?.numerator(), asked.angles()?.numerator());
    let [_, _, time, ..] = typed.dimension().exponents();
    let is_square = time == Rational::integer(-2);
    let fits = own == due || own * due >= 0 && (own.abs() <= 1 || is_square);
    (!fits).then_some(Why::AngleInUnit(*asked))
}

/// What is wrong with cycles or turns where a pure number is asked: whether they count or measure angles is open.
pub(crate) fn counts(typed: &Unit, asked: &Unit) -> Option<Why> {
    let is_turn = asked.is_one() && typed.has_factor("rev");
    is_turn.then_some(Why::NumberAlone)
}
