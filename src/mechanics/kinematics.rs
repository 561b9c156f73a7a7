//! Everything that moves expressed in the coordinates.

use super::definition::Definition;
use super::error::{DefinitionKey, ModelError};
use crate::expr::{Expr, Kind, Name, Substitution};
use crate::numerics::SortedSet;

/// Kinematic names and what stands for them in terms of coordinates and time.
pub(crate) struct Kinematics {
    substitution: Substitution,
    /// Coordinates and kinematic names.
    moving: SortedSet<Name>,
}

impl Kinematics {
    /// Puts the kinematic formulas into one another until only coordinates and time are left.
    pub(crate) fn of(definition: &Definition) -> Result<Self, ModelError> {
        let moving = distinct_names(definition)?;
        let coordinates = definition.coordinates.iter().map(|own| own.name.clone());
        let mut resolved = Self {
            substitution: Substitution::moving(coordinates),
            moving,
        };
        let mut open: Vec<&(Name, Expr)> = definition.kinematics.iter().collect();
        while !open.is_empty() {
            let waiting: SortedSet<_> = open.iter().map(|(name, _)| name.clone()).collect();
            // Authors write relations in any order: each round takes those that need none of the others.
            let (ready, rest): (Vec<_>, Vec<_>) = open
                .into_iter()
                .partition(|(_, formula)| !mentions_any(formula, &waiting));
            let Some(_) = ready.first() else {
                let (name, formula) = rest[0];
                return Err(ModelError::Cycle {
                    name: name.clone(),
                    span: formula.span(),
                });
            };
            for (name, formula) in ready {
                let formula = resolved.apply(DefinitionKey::Kinematics, formula)?;
                resolved.substitution = resolved.substitution.with(name.clone(), formula);
            }
            open = rest;
        }
        Ok(resolved)
    }

    /// A formula in terms of coordinates, their derivatives and time.
    pub(crate) fn apply(&self, key: DefinitionKey, formula: &Expr) -> Result<Expr, ModelError> {
        self.check_primes(key, formula)?;
        let put_in = self.substitution.apply(formula);
        put_in.map_err(ModelError::symbolic(key, formula.span()))
    }

    /// Primes stand at what moves.
    fn check_primes(&self, key: DefinitionKey, formula: &Expr) -> Result<(), ModelError> {
        let mut missing = None;
        formula.walk(&mut |node| {
            if let Kind::Prime(inner, _) = node.kind()
                && let Kind::Name(name) = inner.kind()
                && !self.moving.contains(name)
            {
                missing.get_or_insert((name.clone(), node.span()));
            }
        });
        match missing {
            Some((name, span)) => Err(ModelError::MissingCoordinate { name, key, span }),
            None => Ok(()),
        }
    }
}

fn distinct_names(definition: &Definition) -> Result<SortedSet<Name>, ModelError> {
    let coordinates = definition
        .coordinates
        .iter()
        .map(|own| (&own.name, own.span));
    let kinematics = definition
        .kinematics
        .iter()
        .map(|(name, formula)| (name, formula.span()));
    let mut names = SortedSet::new();
    for (name, span) in coordinates.chain(kinematics) {
        if !names.insert(name.clone()) {
            return Err(ModelError::Duplicate {
                name: name.clone(),
                span,
            });
        }
    }
    Ok(names)
}

fn mentions_any(formula: &Expr, names: &SortedSet<Name>) -> bool {
    let mut found = false;
    formula.walk(&mut |node| {
        found |= matches!(node.kind(), Kind::Name(name) if names.contains(name));
    });
    found
}
