//! Equilibria, as formulas.

use super::definition::Definition;
use super::error::{DefinitionKey, ModelError};
use super::kinematics::Kinematics;
use super::lagrange::position;
use crate::expr::{Expr, Kind, Name, Normal, Order, Substitution, SymbolicError, Variable};
use crate::numerics::SortedSet;

/// What is known of the equilibrium before any number is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Equilibrium {
    /// The author states it; whether it is one is checked with numbers.
    Stated(Vec<Expr>),
    /// Solved from the conditions; for a linear system, or where all coordinates are zero.
    Solved(Vec<Expr>),
    /// The conditions are not linear: found by Newton's method, starting at zero.
    Sought,
    /// There is none: a constant force along this coordinate is not balanced.
    Missing(Name),
}

impl Equilibrium {
    /// The position, if it has a formula.
    pub(crate) fn formula(&self) -> Option<&[Expr]> {
        match self {
            Self::Stated(position) | Self::Solved(position) => Some(position),
            Self::Sought | Self::Missing(_) => None,
        }
    }
}

/// The residuals of the equations of motion taken apart: what holds the system at rest, and its excitation.
#[derive(Clone, Debug)]
pub(crate) struct Balance {
    /// The generalized forces at rest, as functions of the position, negative as on the left side.
    pub(crate) restoring: Vec<Normal>,
    /// What depends on time alone, as on the left side.
    pub(crate) excitation: Vec<Normal>,
    /// Whether time stands beside a coordinate.
    pub(crate) is_autonomous: bool,
}

impl Balance {
    /// Sets all velocities and accelerations to zero.
    pub(crate) fn of(residuals: &[Normal], coordinates: &[Name]) -> Result<Self, SymbolicError> {
        let time = SortedSet::from([Name::new("t")]);
        let moving: SortedSet<_> = coordinates.iter().cloned().collect();
        let mut balance = Self {
            restoring: Vec::new(),
            excitation: Vec::new(),
            is_autonomous: true,
        };
        for residual in residuals {
            let (excitation, restoring) = at_rest(residual, &moving)?.split_by(&time);
            balance.is_autonomous &= !excitation.mentions_any(&moving);
            balance.excitation.push(excitation);
            balance.restoring.push(restoring);
        }
        Ok(balance)
    }

    /// The position in which all restoring forces vanish.
    pub(crate) fn equilibrium(
        &self,
        definition: &Definition,
        kinematics: &Kinematics,
        coordinates: &[Name],
    ) -> Result<Equilibrium, ModelError> {
        if !definition.equilibrium.is_empty() {
            return stated(definition, kinematics).map(Equilibrium::Stated);
        }
        let span = definition.potential.span();
        let symbolic = ModelError::symbolic(DefinitionKey::Potential, span);
        // First, since it settles pendulums and other systems that no linear solver does.
        if self.vanishes_at_zero(coordinates).map_err(&symbolic)? {
            return Ok(Equilibrium::Solved(vec![
                Expr::number(0);
                coordinates.len()
            ]));
        }
        let Some(system) = self.linear_system(coordinates) else {
            return Ok(Equilibrium::Sought);
        };
        match system.solved() {
            Ok(Solution::Position(position)) => {
                let order = Order::new();
                let position = position.iter().map(|own| own.to_expr(&order));
                Ok(Equilibrium::Solved(position.collect()))
            }
            Ok(Solution::None(row)) => Ok(Equilibrium::Missing(coordinates[row].clone())),
            // The formula would be too large to be of use; numbers are not.
            Err(_) => Ok(Equilibrium::Sought),
        }
    }

    fn vanishes_at_zero(&self, coordinates: &[Name]) -> Result<bool, SymbolicError> {
        let zero = coordinates.iter().fold(Substitution::new(), |put, name| {
            put.with(name.clone(), Expr::number(0))
        });
        for restoring in &self.restoring {
            let at_zero = match restoring
                .where_zero(&|own| own.order == 0 && coordinates.contains(&own.name))
            {
                Some(left) => Ok(left),
                None => Normal::of(&zero.apply(&restoring.to_expr(&Order::new()))?),
            };
            match at_zero {
                Ok(left) if left.is_zero() => {}
                Ok(_) | Err(SymbolicError::Undefined) => return Ok(false),
                Err(error) => return Err(error),
            }
        }
        Ok(true)
    }

    /// The conditions as linear equations, if that is what they are.
    fn linear_system(&self, coordinates: &[Name]) -> Option<LinearSystem> {
        let moving: SortedSet<_> = coordinates.iter().cloned().collect();
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for restoring in &self.restoring {
            let (mut row, mut rest) = (Vec::new(), restoring.clone());
            for name in coordinates {
                let (slope, others) = rest.linear_in(&Variable::of(name, 0))?;
                if slope.mentions_any(&moving) {
                    return None;
                }
                row.push(slope);
                rest = others;
            }
            if rest.mentions_any(&moving) {
                return None;
            }
            matrix.push(row);
            right.push(rest.negated());
        }
        Some(LinearSystem { matrix, right })
    }
}

/// The position that the author states, 0 for coordinates that are not named.
fn stated(definition: &Definition, kinematics: &Kinematics) -> Result<Vec<Expr>, ModelError> {
    let mut stated = vec![Expr::number(0); definition.coordinates.len()];
    for (name, formula) in &definition.equilibrium {
        let at = position(definition, name, DefinitionKey::Equilibrium, formula)?;
        stated[at] = kinematics.apply(DefinitionKey::Equilibrium, formula)?;
    }
    Ok(stated)
}

/// The sum with all derivatives of these names set to zero.
pub(crate) fn at_rest(sum: &Normal, moving: &SortedSet<Name>) -> Result<Normal, SymbolicError> {
    match sum.where_zero(&|own| own.order > 0 && moving.contains(&own.name)) {
        Some(at_rest) => Ok(at_rest),
        None => Normal::of(&without_rates(&sum.to_expr(&Order::new()), moving)?),
    }
}

fn without_rates(expr: &Expr, moving: &SortedSet<Name>) -> Result<Expr, SymbolicError> {
    match expr.kind() {
        Kind::Prime(inner, _) => match inner.kind() {
            Kind::Name(name) if moving.contains(name) => Ok(Expr::number(0)),
            _ => Ok(expr.clone()),
        },
        _ => expr.try_map_children(&mut |child| without_rates(child, moving)),
    }
}

/// Linear equations with formulas as coefficients.
struct LinearSystem {
    matrix: Vec<Vec<Normal>>,
    right: Vec<Normal>,
}

fn vanishes(formula: &Normal) -> Result<bool, SymbolicError> {
    formula.is_equal(&Normal::of(&Expr::number(0))?)
}

enum Solution {
    Position(Vec<Normal>),
    /// This equation is left without an unknown and is not fulfilled.
    None(usize),
}

impl LinearSystem {
    /// Elimination with exact formulas; an unknown that stays free is zero.
    fn solved(mut self) -> Result<Solution, SymbolicError> {
        let size = self.right.len();
        let mut rows: Vec<usize> = (0..size).collect();
        let mut pivots: Vec<(usize, usize)> = Vec::new();
        for column in 0..size {
            let mut candidates = Vec::new();
            for row in &rows {
                if !vanishes(&self.matrix[*row][column])? {
                    candidates.push(*row);
                }
            }
            let simplest = candidates
                .into_iter()
                // The fewest terms keep the fractions of the result small.
                .min_by_key(|row| self.matrix[*row][column].terms());
            let Some(pivot) = simplest else {
                continue;
            };
            rows.retain(|row| *row != pivot);
            pivots.push((pivot, column));
            for row in 0..size {
                // In the rows above as well, so that each unknown is read off without putting others in.
                if row != pivot && !self.matrix[row][column].is_zero() {
                    self.eliminate(row, pivot, column)?;
                }
            }
        }
        for row in rows {
            if !vanishes(&self.right[row])? {
                return Ok(Solution::None(row));
            }
        }
        let mut position = vec![Normal::of(&Expr::number(0))?; size];
        for (row, column) in pivots {
            position[column] = self.right[row].over(&self.matrix[row][column])?;
        }
        Ok(Solution::Position(position))
    }

    /// Removes an unknown from a row, without fractions where the pivot divides.
    fn eliminate(&mut self, row: usize, pivot: usize, column: usize) -> Result<(), SymbolicError> {
        let factor = self.matrix[row][column]
            .over(&self.matrix[pivot][column])?
            .negated();
        for at in 0..self.right.len() {
            let term = self.matrix[pivot][at].times(&factor)?;
            self.matrix[row][at] = self.matrix[row][at].plus(&term)?;
        }
        let term = self.right[pivot].times(&factor)?;
        self.right[row] = self.right[row].plus(&term)?;
        // The coefficient vanishes by construction, whatever form the fractions have.
        self.matrix[row][column] = Normal::of(&Expr::number(0))?;
        Ok(())
    }
}
