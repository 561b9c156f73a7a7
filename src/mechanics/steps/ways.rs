//! The derivations that a model offers, by name.

use crate::expr::Name;
use crate::mechanics::Model;
use crate::mechanics::quantity::QuantityError;

/// A way to the equations of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Way {
    /// Lagrange's equation along a coordinate, counted from 0.
    Lagrange(usize),
    /// The balance of energy.
    Energy,
    /// Newton's law for each body.
    Newton,
    /// The determinant of K − ω² M and its equation, for one or two coordinates.
    Characteristic,
    /// A row of (K − ω² M) u = 0 and its ratio, for a mode of two coordinates, counted from 0.
    Row(usize),
    /// The turning points under dry friction. Their lines are numbers, which the data of an instance give:
    /// [`Numbers::turning_points`](crate::mechanics::Numbers::turning_points).
    TurningPoints,
    /// The balance at rest, and what is left of it in motion.
    Static,
}

impl Way {
    /// The names of all ways.
    pub const NAMES: [&str; 7] = [
        "lagrange",
        "energy",
        "newton",
        "characteristic",
        "row",
        "turning_points",
        "static",
    ];

    /// The derivation that a path names, without its beginning (`model` or `models.<name>`).
    ///
    /// # Errors
    ///
    /// As for [`Model::quantity`].
    pub fn of(model: &Model, path: &[Name]) -> Result<Self, QuantityError> {
        let unknown = |name: &str| QuantityError::Unknown {
            name: Name::new(name),
            nearest: crate::source::nearest(name, Self::NAMES),
        };
        let (name, rest) = path.split_first().ok_or_else(|| unknown(""))?;
        let way = match name.as_str() {
            "lagrange" => return along(model, name, rest).map(Self::Lagrange),
            "energy" => Self::Energy,
            "newton" => Self::Newton,
            "characteristic" => Self::Characteristic,
            "turning_points" => Self::TurningPoints,
            "static" => Self::Static,
            "row" => return mode(model, rest).map(Self::Row),
            name => return Err(unknown(name)),
        };
        match rest.first() {
            Some(extra) => Err(QuantityError::NotACoordinate {
                name: extra.clone(),
            }),
            None => Ok(way),
        }
    }
}

/// The mode of a path, which counts from 1.
fn mode(model: &Model, rest: &[Name]) -> Result<usize, QuantityError> {
    let number = rest.first().cloned().unwrap_or_else(|| Name::new("row"));
    let count = match rest {
        [number] => number.as_str().parse().ok(),
        _ => None,
    };
    count
        .and_then(|count: usize| count.checked_sub(1))
        .filter(|mode| *mode < model.degrees_of_freedom())
        .ok_or(QuantityError::NotACoordinate { name: number })
}

/// The coordinate of a path; it may be omitted if there is one alone.
fn along(model: &Model, name: &Name, rest: &[Name]) -> Result<usize, QuantityError> {
    match rest {
        [] if model.degrees_of_freedom() == 1 => Ok(0),
        [] => Err(QuantityError::NoCoordinate {
            name: name.clone(),
            first: model.coordinates()[0].clone(),
        }),
        [own] => {
            let mut coordinates = model.coordinates().iter();
            let at = coordinates.position(|coordinate| coordinate == own);
            at.ok_or_else(|| QuantityError::NotACoordinate { name: own.clone() })
        }
        [_, extra, ..] => Err(QuantityError::NotACoordinate {
            name: extra.clone(),
        }),
    }
}
