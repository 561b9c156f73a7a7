//! What does not fit in units and dimensions.

use super::entry;
use crate::answer::Misfit;
use crate::expr::{CheckError, Joint};
use crate::unit::{Dimension, Unit};

/// What does not fit in a response.
pub(crate) fn misfit(misfit: &Misfit) -> String {
    match misfit {
        Misfit::Unit { typed, asked } => units(typed, asked),
        Misfit::UnitOf(unit) => format!("L’unité doit être celle de {}.", unit.text()),
        Misfit::Count => "Un nombre d’objets n’a pas d’unité.".to_owned(),
        Misfit::Comes {
            entry: place,
            found,
            unit,
            asked,
        } => {
            let what = place.map_or("Ceci".to_owned(), |place| {
                format!("L’élément {}", entry(place))
            });
            let found = comes_out(*found);
            let due = match (unit.filter(|unit| !unit.is_one()), asked) {
                (Some(unit), _) => Some(format!("en {}", unit.text())),
                (None, asked) => asked.map(comes_out),
            };
            match due {
                Some(due) => format!("{what} est {found}, il faut {due}."),
                None => format!("{what} est {found}."),
            }
        }
        Misfit::Step {
            entry: Some(place),
            error,
        } => format!("Élément {} : {}", entry(*place), step(error.as_ref())),
        Misfit::Step { entry: None, error } => step(error.as_ref()),
        Misfit::BoundUnit {
            symbol,
            typed,
            asked,
        } => {
            let due = if asked.is_one() {
                "un nombre sans dimension".to_owned()
            } else {
                format!("en {}", asked.text())
            };
            format!(
                "L’unité {} ne convient pas : `{symbol}` est {due}.",
                typed.text()
            )
        }
        Misfit::Bound {
            typed,
            read,
            symbol,
        } => format!("`{typed}`, lu `{read}`, a une autre dimension que `{symbol}`."),
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
            "Des termes de dimensions différentes sont additionnés : {} et {}.",
            dimension(*left),
            dimension(*right)
        ),
        Some(CheckError::NotPure { function, .. }) => {
            format!("L’argument de `{function}` doit être un nombre sans dimension.")
        }
        Some(CheckError::ExponentNotPure { .. }) => {
            "Un exposant doit être un nombre sans dimension.".to_owned()
        }
        Some(CheckError::UnknownName { name, .. }) => {
            format!("`{name}` n’est pas connu ici.")
        }
        _ => "Les dimensions ne s’accordent pas.".to_owned(),
    }
}

fn dimension(dimension: Dimension) -> String {
    if dimension.is_pure() {
        "un nombre sans dimension".to_owned()
    } else {
        dimension.describe()
    }
}

fn comes_out(dimension: Dimension) -> String {
    if dimension.is_pure() {
        "un nombre sans dimension".to_owned()
    } else {
        format!("en {}", dimension.describe())
    }
}

/// Units with what they measure, most often in this field.
const MEASURED: &[(&str, &str)] = &[
    ("m", "une longueur"),
    ("kg", "une masse"),
    ("s", "un temps"),
    ("1/s", "une fréquence ou un taux"),
    ("1/s^2", "une accélération angulaire"),
    ("m/s", "une vitesse"),
    ("m/s^2", "une accélération"),
    ("N", "une force"),
    ("N m", "un moment ou une énergie"),
    ("W", "une puissance"),
    ("N/m", "une raideur"),
    ("N s/m", "un coefficient d’amortissement"),
    ("N m s", "un coefficient d’amortissement en rotation"),
    ("kg m^2", "un moment d’inertie"),
    ("kg m", "un balourd"),
    ("kg m/s", "une quantité de mouvement"),
    ("kg/m", "une masse linéique"),
    ("kg/m^3", "une masse volumique"),
    ("m^2", "une aire"),
    ("m^3", "un volume"),
    ("Pa", "une pression"),
    ("1/m", "l’inverse d’une longueur"),
    ("V", "une tension"),
    ("A", "une intensité"),
    ("C", "une charge"),
    ("ohm", "une résistance"),
    ("F", "une capacité"),
    ("H", "une inductance"),
    ("m/N", "une souplesse"),
];

/// What a unit measures: by its form where that says more than its dimension.
fn measured(unit: &Unit) -> Option<&'static str> {
    let dimension = unit.dimension();
    if dimension == Dimension::ENERGY {
        let text = unit.text();
        if text.contains("/rad") || text.contains("/°") {
            return Some("une raideur de torsion");
        }
        if text.ends_with('J') {
            return Some("une énergie");
        }
    }
    let own = |row: &&(&str, &str)| Dimension::parse(row.0) == Ok(dimension);
    let found = MEASURED.iter().find(own).map(|(_, words)| *words);
    found.or_else(|| {
        dimension
            .is_pure()
            .then_some("un angle ou un nombre sans dimension")
    })
}

fn units(typed: &Unit, asked: &Unit) -> String {
    let is = measured(typed).map_or_else(String::new, |words| {
        format!(" : `{}` mesure {words}", typed.text())
    });
    if asked.is_one() {
        return format!(
            "L’unité ne convient pas{is}. Un nombre sans dimension est demandé, sans unité."
        );
    }
    let due = measured(asked).map_or_else(String::new, |words| format!("{words}, "));
    format!(
        "L’unité ne convient pas{is}. La réponse demandée est {due}en {}.",
        asked.text()
    )
}
