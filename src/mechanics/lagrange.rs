//! Lagrange's equations.

use super::definition::Definition;
use super::error::{DefinitionKey, ModelError};
use super::kinematics::Kinematics;
use crate::expr::{Expr, Kind, Name, Normal, SymbolicError, Variable};
use crate::numerics::SortedSet;

/// Energies, dissipation and forces in terms of coordinates, velocities and time.
#[derive(Clone, Debug)]
pub(crate) struct Energies {
    pub(crate) coordinates: Vec<Name>,
    pub(crate) kinetic: Expr,
    pub(crate) potential: Expr,
    pub(crate) dissipation: Expr,
    /// One per coordinate.
    pub(crate) forces: Vec<Expr>,
}

/// The energies and the dissipation as sums of products.
pub(crate) struct Sums {
    kinetic: Normal,
    pub(crate) potential: Normal,
    dissipation: Normal,
}

impl Energies {
    /// Puts the kinematics in and checks what depends on which derivatives; the kinetic energy is looked at
    /// term by term and comes as a sum too.
    ///
    /// What is wrong is added to `errors`; without it the energies can be differentiated.
    pub(crate) fn of(
        definition: &Definition,
        kinematics: &Kinematics,
        errors: &mut Vec<ModelError>,
    ) -> Option<(Self, Normal)> {
        let before = errors.len();
        let mut put_in = |key, formula| match kinematics.apply(key, formula) {
            Ok(put_in) => put_in,
            Err(error) => {
                errors.push(error);
                Expr::number(0)
            }
        };
        let mut energies = Self {
            coordinates: names(definition),
            kinetic: put_in(DefinitionKey::Kinetic, &definition.kinetic),
            potential: put_in(DefinitionKey::Potential, &definition.potential),
            dissipation: put_in(DefinitionKey::Dissipation, &definition.dissipation),
            forces: Vec::new(),
        };
        match forces(definition, kinematics) {
            Ok(forces) => energies.forces = forces,
            Err(error) => errors.push(error),
        }
        if errors.len() > before {
            return None;
        }
        errors.extend(energies.check_derivatives(definition).err());
        let kinetic = energies
            .checked_kinetic(definition)
            .map_err(|error| errors.push(error));
        let kinetic = kinetic.ok().filter(|_| errors.len() == before)?;
        Some((energies, kinetic))
    }

    fn check_derivatives(&self, definition: &Definition) -> Result<(), ModelError> {
        let written = [
            (DefinitionKey::Kinetic, &self.kinetic, &definition.kinetic),
            (
                DefinitionKey::Potential,
                &self.potential,
                &definition.potential,
            ),
            (
                DefinitionKey::Dissipation,
                &self.dissipation,
                &definition.dissipation,
            ),
        ];
        for (key, energy, written) in written {
            if let Some(Variable { name, order }) = highest_derivative(energy) {
                let span = written.span();
                if key == DefinitionKey::Potential && order > 0 {
                    return Err(ModelError::VelocityInPotential { name, span });
                }
                if order > 1 {
                    return Err(ModelError::Acceleration { key, span });
                }
            }
        }
        Ok(())
    }

    /// T is a polynomial of the second degree in the velocities, and each of them occurs squared.
    fn checked_kinetic(&self, definition: &Definition) -> Result<Normal, ModelError> {
        let span = definition.kinetic.span();
        let kinetic = Normal::of(&self.kinetic);
        let kinetic = kinetic.map_err(ModelError::symbolic(DefinitionKey::Kinetic, span))?;
        let velocities = self.coordinates.iter().map(|name| Variable::of(name, 1));
        let velocities: Vec<_> = velocities.collect();
        if kinetic
            .degree_in(&velocities)
            .is_none_or(|degree| degree > 2)
        {
            let culprit = velocities
                .iter()
                .find(|own| {
                    let degree = kinetic.degree_in(std::slice::from_ref(*own));
                    degree.is_none_or(|degree| degree > 2)
                })
                .unwrap_or(&velocities[0]);
            return Err(ModelError::NotQuadratic {
                name: culprit.name.clone(),
                span,
            });
        }
        for (coordinate, velocity) in definition.coordinates.iter().zip(velocities) {
            if kinetic.degree_in(&[velocity]) != Some(2) {
                return Err(ModelError::Massless {
                    name: coordinate.name.clone(),
                    span: coordinate.span,
                });
            }
        }
        Ok(kinetic)
    }

    /// All as sums of products; the kinetic energy is known as one.
    pub(crate) fn sums(&self, kinetic: Normal) -> Result<Sums, SymbolicError> {
        Ok(Sums {
            kinetic,
            potential: Normal::of(&self.potential)?,
            dissipation: Normal::of(&self.dissipation)?,
        })
    }

    /// The left side of `d/dt ∂T/∂q' − ∂T/∂q + ∂V/∂q + ∂D/∂q' − Q = 0` for each coordinate.
    pub(crate) fn residuals(&self, sums: &Sums) -> Result<Vec<Normal>, SymbolicError> {
        let moving: SortedSet<_> = self.coordinates.iter().cloned().collect();
        self.coordinates
            .iter()
            .zip(&self.forces)
            .map(|(name, force)| {
                let (position, velocity) = (Variable::of(name, 0), Variable::of(name, 1));
                let momentum = sums.kinetic.derivative_of(&self.kinetic, &velocity)?;
                let kinetic = sums.kinetic.derivative_of(&self.kinetic, &position)?;
                let potential = sums.potential.derivative_of(&self.potential, &position)?;
                let dissipation = sums
                    .dissipation
                    .derivative_of(&self.dissipation, &velocity)?;
                let terms = [
                    kinetic.negated(),
                    potential,
                    dissipation,
                    Normal::of(force)?.negated(),
                ];
                let inertia = momentum.time_derivative(&moving)?;
                terms.iter().try_fold(inertia, |sum, term| sum.plus(term))
            })
            .collect()
    }
}

fn names(definition: &Definition) -> Vec<Name> {
    let coordinates = definition.coordinates.iter();
    coordinates.map(|own| own.name.clone()).collect()
}

/// The generalized force along each coordinate, 0 where none is given.
fn forces(definition: &Definition, kinematics: &Kinematics) -> Result<Vec<Expr>, ModelError> {
    let mut forces = vec![Expr::number(0); definition.coordinates.len()];
    for (name, formula) in &definition.forces {
        let at = position(definition, name, DefinitionKey::Forces, formula)?;
        let force = kinematics.apply(DefinitionKey::Forces, formula)?;
        if highest_derivative(&force).is_some_and(|highest| highest.order > 1) {
            return Err(ModelError::Acceleration {
                key: DefinitionKey::Forces,
                span: formula.span(),
            });
        }
        forces[at] = force;
    }
    Ok(forces)
}

/// The place of a coordinate for which something is given.
pub(crate) fn position(
    definition: &Definition,
    name: &Name,
    key: DefinitionKey,
    formula: &Expr,
) -> Result<usize, ModelError> {
    let mut coordinates = definition.coordinates.iter();
    coordinates
        .position(|own| own.name == *name)
        .ok_or_else(|| ModelError::UnknownCoordinate {
            name: name.clone(),
            key,
            span: formula.span(),
        })
}

/// The highest time derivative that stands in a formula.
fn highest_derivative(expr: &Expr) -> Option<Variable> {
    let mut highest: Option<Variable> = None;
    expr.walk(&mut |node| {
        if let Kind::Prime(inner, order) = node.kind()
            && let Kind::Name(name) = inner.kind()
            && highest
                .as_ref()
                .is_none_or(|highest| highest.order < *order)
        {
            highest = Some(Variable::of(name, *order));
        }
    });
    highest
}
