//! Dimensions of what an author writes: energies are energies, term by term.

use super::definition::Definition;
use super::error::{DefinitionKey, ModelError};
use crate::expr::{AnyDimension, Expr, Kind, Name, Operator, Scope, Type};
use crate::numerics::SortedMap;
use crate::unit::Dimension;

/// The kinematic formulas may use each other in any order; more passes than this settle no more of them.
const MAX_PASSES: usize = 16;

/// All that is wrong with the dimensions of a definition.
pub(crate) fn check(definition: &Definition) -> Vec<ModelError> {
    let mut checker = DefinitionChecker {
        definition,
        kinematics: SortedMap::new(),
        errors: Vec::new(),
    };
    checker.settle_kinematics();
    checker.check_all();
    checker.errors
}

struct DefinitionChecker<'a> {
    definition: &'a Definition,
    /// What the kinematic names are, as far as it is known by now.
    kinematics: SortedMap<Name, Type>,
    errors: Vec<ModelError>,
}

impl Scope for DefinitionChecker<'_> {
    fn name(&self, name: &Name) -> Option<Type> {
        if name.as_str() == "t" {
            return Some(Type::real(Dimension::TIME));
        }
        if let Some(coordinate) = self
            .definition
            .coordinates
            .iter()
            .find(|own| own.name == *name)
        {
            return Some(Type::real(coordinate.dimension));
        }
        if self
            .definition
            .kinematics
            .iter()
            .any(|(own, _)| own == name)
        {
            let known = self.kinematics.get(name).cloned();
            return Some(known.unwrap_or_else(|| Type::real(AnyDimension::None)));
        }
        // A name whose dimension is not given fits everywhere.
        let dimension: AnyDimension = self.definition.dimensions.get(name).copied();
        Some(Type::real(dimension))
    }

    fn known(&self) -> Vec<String> {
        let names = self.definition.dimensions.keys();
        names.map(ToString::to_string).collect()
    }
}

impl DefinitionChecker<'_> {
    fn settle_kinematics(&mut self) {
        let formulas = &self.definition.kinematics;
        for _ in 0..formulas.len().min(MAX_PASSES) {
            for (name, formula) in formulas {
                if let Ok(found) = formula.check(&*self) {
                    self.kinematics.insert(name.clone(), found);
                }
            }
        }
    }

    fn check_all(&mut self) {
        let definition = self.definition;
        for (_, formula) in &definition.kinematics {
            self.check_form(DefinitionKey::Kinematics, formula);
        }
        self.check_sum(
            DefinitionKey::Kinetic,
            &definition.kinetic,
            Dimension::ENERGY,
        );
        self.check_sum(
            DefinitionKey::Potential,
            &definition.potential,
            Dimension::ENERGY,
        );
        self.check_sum(
            DefinitionKey::Dissipation,
            &definition.dissipation,
            Dimension::POWER,
        );
        for (name, formula) in &definition.forces {
            if let Some(along) = self.along(name) {
                self.check_sum(DefinitionKey::Forces, formula, Dimension::ENERGY / along);
            }
        }
        for (name, friction) in &definition.friction {
            if let Some(along) = self.along(name) {
                let force = Dimension::ENERGY / along;
                for formula in std::iter::once(&friction.kinetic).chain(&friction.holding) {
                    self.check_sum(DefinitionKey::Friction, formula, force);
                }
            }
        }
        for (name, initial) in &definition.initial {
            if let Some(along) = self.along(name) {
                self.check_sum(DefinitionKey::Initial, &initial.position, along);
                self.check_sum(
                    DefinitionKey::Initial,
                    &initial.velocity,
                    along / Dimension::TIME,
                );
            }
        }
        for (name, formula) in &definition.equilibrium {
            if let Some(along) = self.along(name) {
                self.check_sum(DefinitionKey::Equilibrium, formula, along);
            }
        }
    }

    /// The dimension of a coordinate.
    fn along(&self, name: &Name) -> Option<Dimension> {
        let mut coordinates = self.definition.coordinates.iter();
        coordinates
            .find(|own| own.name == *name)
            .map(|own| own.dimension)
    }

    /// Names and forms are right, whatever the dimension.
    fn check_form(&mut self, key: DefinitionKey, formula: &Expr) -> Option<Type> {
        match formula.check(&*self) {
            Ok(found) => Some(found),
            Err(findings) => {
                let errors = findings
                    .into_iter()
                    .map(|error| ModelError::Check { key, error });
                self.errors.extend(errors);
                None
            }
        }
    }

    /// Each term of a sum has the dimension that is due.
    fn check_sum(&mut self, key: DefinitionKey, formula: &Expr, expected: Dimension) {
        for term in terms(formula) {
            let Some(found) = self.check_form(key, term) else {
                continue;
            };
            if !found.fits(&Type::real(expected)) {
                self.errors.push(ModelError::Dimension {
                    key,
                    found: found.dimension(),
                    expected,
                    span: term.span(),
                });
            }
        }
    }
}

/// The terms of a sum, without their signs.
fn terms(formula: &Expr) -> Vec<&Expr> {
    let (mut terms, mut open) = (Vec::new(), vec![formula]);
    while let Some(expr) = open.pop() {
        match expr.kind() {
            Kind::Binary(Operator::Add | Operator::Subtract, a, b) => open.extend([b, a]),
            Kind::Negate(inner) => open.push(inner),
            _ => terms.push(expr),
        }
    }
    terms
}
