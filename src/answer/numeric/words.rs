//! What is said of units that do not fit: what they measure, and how they may have been meant.

use crate::unit::{Dimension, Unit};

/// Units with what they measure, most often in this field.
const MEASURED: &[(&str, &str)] = &[
    ("m", "a length"),
    ("kg", "a mass"),
    ("s", "a time"),
    ("1/s", "a frequency or a rate"),
    ("1/s^2", "an angular acceleration"),
    ("m/s", "a velocity"),
    ("m/s^2", "an acceleration"),
    ("N", "a force"),
    ("N m", "a moment or an energy"),
    ("W", "a power"),
    ("N/m", "a stiffness"),
    ("N s/m", "a damping coefficient"),
    ("N m s", "a damping coefficient of rotation"),
    ("kg m^2", "a moment of inertia"),
    ("kg m", "an unbalance"),
    ("kg m/s", "a momentum"),
    ("kg/m", "a mass per length"),
    ("kg/m^3", "a density"),
    ("m^2", "an area"),
    ("m^3", "a volume"),
    ("Pa", "a pressure"),
    ("1/m", "an inverse length"),
    ("V", "a voltage"),
    ("A", "a current"),
    ("C", "a charge"),
    ("ohm", "a resistance"),
    ("F", "a capacitance"),
    ("H", "an inductance"),
    ("m/N", "a compliance"),
];

/// What a dimension is that of, if it has a name.
fn measured(dimension: Dimension) -> Option<&'static str> {
    let own = |unit: &&(&str, &str)| Dimension::parse(unit.0) == Ok(dimension);
    MEASURED.iter().find(own).map(|(_, words)| *words)
}

/// What a unit is that of, where its form tells more than its dimension.
fn special(unit: &Unit) -> Option<&'static str> {
    let text = unit.text();
    if unit.dimension() != Dimension::ENERGY {
        return None;
    }
    match (
        text.contains("/rad") || text.contains("/°"),
        text.ends_with('J'),
    ) {
        (true, _) => Some("a torsional stiffness"),
        (false, true) => Some("an energy"),
        (false, false) => None,
    }
}

/// What is said where a unit of another dimension was typed.
pub(super) fn misfit(typed: &Unit, asked: &Unit) -> String {
    let of = |unit: &Unit| match special(unit).or_else(|| measured(unit.dimension())) {
        Some(words) => format!("{words}, "),
        None if unit.dimension().is_pure() => "an angle or a pure number, ".to_owned(),
        None => String::new(),
    };
    let found = of(typed);
    let found = found.trim_end_matches(", ");
    let is = if found.is_empty() {
        String::new()
    } else {
        format!(": `{}` measures {found}", typed.text())
    };
    if asked.is_one() {
        return format!("The unit does not fit{is}. A pure number is asked, without a unit.");
    }
    format!(
        "The unit does not fit{is}. What is asked is {}in {}.",
        of(asked),
        asked.text()
    )
}

/// What is said of a unit that fits if it is written with small letters or with a space: `rad/S` for `rad/s`,
/// `ms⁻¹` for `m·s⁻¹`.
pub(super) fn miswritten(typed: &Unit, asked: &Unit) -> Option<String> {
    let text = typed.text();
    let fits = |text: &str| {
        let unit = Unit::read(text).ok()?;
        (unit.dimension() == asked.dimension() && !unit.is_one()).then_some(unit)
    };
    if text == "g" && measured(asked.dimension()) == Some("an acceleration") {
        return Some("`g` is the gram: write `g0` for the acceleration of free fall.".to_owned());
    }
    if let Some(small) = fits(&text.to_lowercase()) {
        let small = small.text();
        return Some(format!(
            "Capitals matter in units: write `{small}` for `{text}`."
        ));
    }
    let spaced = [("ms", "m·s"), ("rad⁻", "rad·s⁻")]
        .iter()
        .find_map(|(run, meant)| fits(&text.replace(run, meant)))?;
    Some(format!(
        "This is read as `{text}`: write `{spaced}` with a space."
    ))
}

/// What is said of cycles or turns where a pure number is asked: whether they count or measure angles is open.
pub(super) fn counts(typed: &Unit, asked: &Unit) -> Option<String> {
    let is_turn = asked.is_one() && typed.text() == "rev";
    is_turn.then(|| "A number alone is asked: leave out what it counts.".to_owned())
}
