//! Derivations line by line, as a textbook writes them.
//!
//! They are made from the same definition as the equations, when a text prints them and not before. Each line is a
//! chain of sides that are equal (or equal for small displacements), so that it can be proved by comparing neighbours.

mod bodies;
mod energy;
mod factors;
mod frequencies;
mod lagrange;
mod statics;
#[cfg(test)]
mod tests;
mod ways;

pub use bodies::NewtonError;
pub(crate) use bodies::prove_newton;
pub use statics::Letters;
pub(crate) use statics::statics;
pub use ways::Way;

use super::kinematics::Kinematics;
use super::{Model, Unavailable};
use crate::expr::{Expr, Kind, Name, Normal, Operator, Order, SymbolicError, Variable};
use crate::numerics::SortedSet;

/// A step of a derivation: what it does, and its lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it does.
    pub reason: Reason,
    /// The equations that it writes, in order.
    pub lines: Vec<Line>,
}

/// Sides that are equal, from left to right.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// At least two.
    pub sides: Vec<LineSide>,
    /// Whether the last side holds for small displacements only.
    pub is_approximate: bool,
}

/// One side of a line.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LineSide {
    /// A formula in coordinates, kinematic names and constants.
    Formula(Expr),
    /// A sum of terms by their names, each with whether it is subtracted; empty for 0.
    Terms(Vec<(bool, LawTerm)>),
    /// The determinant of a matrix, by rows.
    Determinant(Vec<Vec<Expr>>),
}

/// A term of a law, by its name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LawTerm {
    /// ∂T/∂q'.
    Momentum(Name),
    /// Its time derivative.
    MomentumRate(Name),
    /// ∂T/∂q.
    Kinetic(Name),
    /// ∂V/∂q.
    Potential(Name),
    /// ∂D/∂q'.
    Dissipation(Name),
    /// The generalized force.
    Force(Name),
    /// T + V.
    Energy,
    /// Its time derivative.
    EnergyRate,
    /// The power of the forces that have no potential energy.
    Power,
}

/// What a step does.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// Relations between displacements.
    Kinematics,
    /// The terms of Lagrange's equation along a coordinate.
    Terms(Name),
    /// Lagrange's equation along a coordinate: the terms are put together.
    Lagrange(Name),
    /// The linear part of an equation for small displacements.
    Linearized,
    /// The energy and its rate.
    Energy,
    /// The power of damping and forces.
    Power,
    /// The rate of the energy is the power.
    Balance,
    /// The balance is divided by the velocity along a coordinate, which is not always zero.
    Divided(Name),
    /// Newton's law for a body.
    Body(Name),
    /// The laws are multiplied by the displacements along a coordinate and added, so that these unknown forces cancel.
    Elimination(Name, Vec<Name>),
    /// The condition for a motion in which all coordinates swing with one frequency.
    Characteristic,
    /// A row of the equations for the shape of a mode, counted from 0.
    Row(usize),
    /// The forces with a potential where all coordinates are zero.
    AtRest,
    /// What the letters in the balance at rest stand for.
    Letters,
    /// The same forces in motion, with what balances at rest gone.
    InMotion,
}

impl Line {
    fn exact(sides: impl IntoIterator<Item = LineSide>) -> Self {
        Self {
            sides: sides.into_iter().collect(),
            is_approximate: false,
        }
    }

    fn approximate(sides: impl IntoIterator<Item = LineSide>) -> Self {
        Self {
            is_approximate: true,
            ..Self::exact(sides)
        }
    }
}

impl LineSide {
    fn term(term: LawTerm) -> Self {
        Self::Terms(vec![(false, term)])
    }
}

/// What all derivations of a model use.
struct Deriver<'m> {
    model: &'m Model,
    kinematics: Kinematics,
    /// Coordinates and kinematic names.
    moving: SortedSet<Name>,
    /// The order of products with kinematic names as what moves.
    order: Order,
}

impl<'m> Deriver<'m> {
    fn of(model: &'m Model) -> Result<Self, Unavailable> {
        let definition = &model.definition;
        let kinematics = Kinematics::of(definition).map_err(|_| Unavailable::NoFormula)?;
        let names = definition.kinematics.iter().map(|(name, _)| name);
        let all: Vec<Name> = names.chain(model.coordinates()).cloned().collect();
        Ok(Self {
            model,
            kinematics,
            moving: all.iter().cloned().collect(),
            order: model.order().clone().moving(all),
        })
    }

    /// A formula in coordinates alone.
    fn resolved(&self, formula: &Expr) -> Result<Expr, Unavailable> {
        let key = super::DefinitionKey::Kinematics;
        self.kinematics
            .apply(key, formula)
            .map_err(|_| Unavailable::NoFormula)
    }

    fn normal(&self, formula: &Expr) -> Result<Normal, Unavailable> {
        Ok(Normal::of(&self.resolved(formula)?)?)
    }

    /// As the model writes its equations.
    fn collected(&self, formula: &Normal) -> Expr {
        formula.to_expr(self.model.order())
    }

    /// The kinematic relations that formulas use, each in terms of the coordinates.
    fn relations<'e>(
        &self,
        formulas: impl IntoIterator<Item = &'e Expr>,
    ) -> Result<Option<Step>, Unavailable> {
        let mut used = SortedSet::new();
        for formula in formulas {
            used.extend(formula.names().free.into_iter().map(|own| own.name));
        }
        let kinematics = self.model.definition.kinematics.iter();
        let lines = kinematics.filter(|(name, _)| used.contains(name));
        let lines = lines
            .map(|(name, formula)| {
                let sides = [Expr::name(name.clone()), self.bracketed(formula)?];
                Ok(Line::exact(sides.map(LineSide::Formula)))
            })
            .collect::<Result<Vec<_>, Unavailable>>()?;
        Ok((!lines.is_empty()).then_some(Step {
            reason: Reason::Kinematics,
            lines,
        }))
    }

    /// A displacement in the coordinates; a common sign stands before a bracket.
    fn bracketed(&self, formula: &Expr) -> Result<Expr, Unavailable> {
        let normal = self.normal(formula)?;
        Ok(if normal.has_negative_coefficients_alone() {
            -normal.negated().to_bracket(&self.order)
        } else {
            normal.to_bracket(&self.order)
        })
    }

    /// The displacement of a kinematic name or coordinate per displacement along a coordinate.
    fn slope(&self, name: &Name, coordinate: &Name) -> Result<Expr, Unavailable> {
        let moved = self.resolved(&Expr::name(name.clone()))?;
        let slope = Normal::of(&moved)?.derivative(&Variable::of(coordinate, 0))?;
        Ok(slope.to_expr(&self.order))
    }

    /// A term in order, without its brackets multiplied out.
    fn tidy(&self, term: &Expr) -> (bool, Expr) {
        factors::in_order(term, &self.order)
    }
}

/// A product as it stands: nothing is rearranged.
fn product(first: Expr, second: Expr) -> Expr {
    Expr::derived(Kind::Binary(Operator::Multiply, first, second))
}

fn is_zero(formula: &Expr) -> Result<bool, SymbolicError> {
    Ok(formula.is_zero() || Normal::of(formula)?.is_zero())
}

pub(crate) fn derivation(model: &Model, way: Way) -> Result<Vec<Step>, Unavailable> {
    let deriver = Deriver::of(model)?;
    match way {
        Way::Lagrange(at) => lagrange::lagrange(&deriver, at),
        Way::Energy => energy::energy(&deriver),
        Way::Newton => bodies::newton(&deriver),
        Way::Characteristic => frequencies::characteristic(&deriver),
        Way::Row(mode) => frequencies::row(&deriver, mode),
        Way::Static => Err(Unavailable::NothingStatic),
        Way::TurningPoints if model.definition.friction.is_empty() => Err(Unavailable::NoFriction),
        Way::TurningPoints => Ok(Vec::new()),
    }
}
