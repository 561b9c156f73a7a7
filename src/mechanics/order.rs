//! The order in which formulas of a model are written.

use super::definition::Definition;
use crate::expr::{Kind, Name, Order};
use crate::numerics::SortedSet;
use crate::unit::Dimension;

/// Coordinates move; constants come as textbooks print them: `m g l`, `k l²`, `m U Ω²`.
pub(crate) fn textbook(definition: &Definition) -> Order {
    let coordinates = definition.coordinates.iter();
    let moving: Vec<_> = coordinates.map(|own| own.name.clone()).collect();
    let mut names = names_by_appearance(definition);
    crate::numerics::sort_by_key(&mut names, |name| {
        definition
            .dimensions
            .get(name)
            .map_or(FactorClass::Unknown, class_of)
    });
    Order::new().moving(moving).ranked(names)
}

/// What comes first in a product.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum FactorClass {
    /// Masses, stiffnesses, forces, inductances.
    Inertial,
    /// Accelerations and velocities.
    Kinematic,
    Length,
    Time,
    Pure,
    Unknown,
}

fn class_of(dimension: &Dimension) -> FactorClass {
    let [mass, length, time, current, ..] = dimension.exponents().map(|own| own.numerator() != 0);
    match (mass || current, length, time) {
        (true, ..) => FactorClass::Inertial,
        (_, true, true) => FactorClass::Kinematic,
        (_, true, false) => FactorClass::Length,
        (_, false, true) => FactorClass::Time,
        (_, false, false) => FactorClass::Pure,
    }
}

/// All names, in the order in which the author writes them.
fn names_by_appearance(definition: &Definition) -> Vec<Name> {
    let energies = [
        &definition.kinetic,
        &definition.potential,
        &definition.dissipation,
    ];
    let named = definition.forces.iter().chain(&definition.kinematics);
    let (mut names, mut known) = (Vec::new(), SortedSet::new());
    for formula in energies
        .into_iter()
        .chain(named.map(|(_, formula)| formula))
    {
        formula.walk(&mut |node| {
            if let Kind::Name(name) = node.kind()
                && known.insert(name.clone())
            {
                names.push(name.clone());
            }
        });
    }
    names
}
