//! What does not fit in units and dimensions.

use super::entry;
use crate::answer::Misfit;
use crate::expr::{CheckError, Joint};
use crate::source::capital;
use crate::unit::{Dimension, Unit};

/// What does not fit in a response.
pub(crate) fn misfit(misfit: &Misfit) -> String {
    match misfit {
        Misfit::Unit { typed, asked } => units(typed, asked),
        Misfit::UnitOf(unit) => format!("The unit has to be that of {}.", unit.text()),
        Misfit::Count => "A count has no unit.".to_owned(),
        Misfit::Comes {
            entry: place,
            found,
            unit,
            asked,
        } => {
            let what = place.map_or("This".to_owned(), |place| {
                format!("The entry {}", entry(place))
            });
            let found = comes_out(*found);
            let due = match (unit.filter(|unit| !unit.is_one()), asked) {
                (Some(unit), _) => Some(format!("in {}", unit.text())),
                (None, Some(asked)) if asked.is_pure() => Some(dimension(*asked)),
                (None, asked) => asked.map(comes_out),
            };
            match due {
                Some(due) => format!("{what} comes out {found}; it has to be {due}."),
                None => format!("{what} comes out {found}."),
            }
        }
        Misfit::Step {
            entry: Some(place),
            error,
        } => format!("The entry {}: {}", entry(*place), step(error.as_ref())),
        Misfit::Step { entry: None, error } => step(error.as_ref()),
        Misfit::BoundUnit {
            symbol,
            typed,
            asked,
        } => {
            let due = if asked.is_one() {
                "a pure number".to_owned()
            } else {
                format!("in {}", asked.text())
            };
            format!(
                "The unit {} does not fit: `{symbol}` is {due}.",
                typed.text()
            )
        }
        Misfit::Bound {
            typed,
            read,
            symbol,
        } => format!("`{typed}`, read as `{read}`, has another dimension than `{symbol}`."),
    }
}

/// What goes against the dimensions.
fn step(error: Option<&CheckError>) -> String {
    match error {
        Some(CheckError::Dimensions {
            joint: Joint::Sum,
            left,
            right,
            ..
        }) => format!(
            "Terms of different dimensions are added: {} and {}.",
            dimension(*left),
            dimension(*right)
        ),
        Some(error) => format!("{}.", capital(&error.to_string())),
        None => "The dimensions do not fit.".to_owned(),
    }
}

fn dimension(dimension: Dimension) -> String {
    if dimension.is_pure() {
        "a pure number".to_owned()
    } else {
        dimension.describe()
    }
}

fn comes_out(dimension: Dimension) -> String {
    if dimension.is_pure() {
        "as a pure number".to_owned()
    } else {
        format!("in {}", dimension.describe())
    }
}

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

/// What a unit measures: by its form where that says more than its dimension.
fn measured(unit: &Unit) -> Option<&'static str> {
    let dimension = unit.dimension();
    if dimension == Dimension::ENERGY {
        let text = unit.text();
        if text.contains("/rad") || text.contains("/°") {
            return Some("a torsional stiffness");
        }
        if text.ends_with('J') {
            return Some("an energy");
        }
    }
    let own = |row: &&(&str, &str)| Dimension::parse(row.0) == Ok(dimension);
    let found = MEASURED.iter().find(own).map(|(_, words)| *words);
    found.or_else(|| dimension.is_pure().then_some("an angle or a pure number"))
}

fn units(typed: &Unit, asked: &Unit) -> String {
    let is = measured(typed).map_or_else(String::new, |words| {
        format!(": `{}` measures {words}", typed.text())
    });
    if asked.is_one() {
        return format!("The unit does not fit{is}. A pure number is asked for, without a unit.");
    }
    let due = measured(asked).map_or_else(String::new, |words| format!("{words}, "));
    format!(
        "The unit does not fit{is}. The answer is {due}in {}.",
        asked.text()
    )
}
