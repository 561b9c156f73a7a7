//! The linearized equations as formulas.

use std::collections::BTreeSet;

use super::equilibrium::Balance;
use crate::expr::{
    Expr, Name, Normal, Order, Substitution, SymbolicError, Variable, differentiate,
};

/// `M q'' + C q' + K q = f(t)` about a position at rest, as formulas.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    pub(super) mass: Matrix,
    pub(super) damping: Matrix,
    pub(super) stiffness: Matrix,
    /// What drives each equation: functions of time, and what the position at rest leaves on the right.
    pub(super) driving: Vec<Normal>,
}

/// A square matrix by rows.
pub(super) type Matrix = Vec<Vec<Normal>>;

impl Linear {
    /// The linear parts of the residuals about `position`; nothing where time stands beside a coordinate.
    pub(super) fn of(
        residuals: &[Normal],
        balance: &Balance,
        coordinates: &[Name],
        position: &[Expr],
    ) -> Result<Option<Self>, SymbolicError> {
        if !balance.is_autonomous {
            return Ok(None);
        }
        let place = Place::new(coordinates, position);
        let matrix = |order| place.slopes(residuals, coordinates, order);
        let (mass, damping, stiffness) = (matrix(2)?, matrix(1)?, matrix(0)?);
        let time = Name::new("t");
        let mut entries = mass.iter().chain(&damping).chain(&stiffness).flatten();
        if entries.any(|entry| entry.mentions(&time)) {
            return Ok(None);
        }
        let mut driving = Vec::new();
        for (row, own) in stiffness.iter().zip(&balance.driving) {
            let mut right = own.negated();
            for (entry, rest) in row.iter().zip(position) {
                right = right.plus(&entry.times(&Normal::of(rest)?)?)?;
            }
            driving.push(right);
        }
        Ok(Some(Self {
            mass,
            damping,
            stiffness,
            driving,
        }))
    }

    /// The whole equations, where they are linear: `varying` are their derivatives anywhere.
    pub(super) fn whole(
        residuals: &[Normal],
        varying: &Self,
        coordinates: &[Name],
    ) -> Result<Option<Self>, SymbolicError> {
        let mut whole = varying.clone();
        whole.driving.clear();
        let moving: BTreeSet<_> = coordinates.iter().cloned().collect();
        for (row, residual) in residuals.iter().enumerate() {
            let driving = varying.left(row, coordinates)?.plus(&residual.negated())?;
            let entries = [&varying.mass, &varying.damping, &varying.stiffness];
            let moves = |part: &Normal| !part.split_by(&moving).0.is_zero();
            if moves(&driving) || entries.iter().flat_map(|own| &own[row]).any(moves) {
                return Ok(None);
            }
            whole.driving.push(driving);
        }
        Ok(Some(whole))
    }

    /// The derivatives of forces at rest by the coordinates, as functions of the position.
    pub(super) fn slopes(
        restoring: &[Normal],
        coordinates: &[Name],
    ) -> Result<Matrix, SymbolicError> {
        Place::new(&[], &[]).slopes(restoring, coordinates, 0)
    }

    /// The sum of one row on the left.
    pub(super) fn left(&self, row: usize, coordinates: &[Name]) -> Result<Normal, SymbolicError> {
        let mut sum = Normal::of(&Expr::number(0))?;
        for (matrix, order) in [(&self.mass, 2), (&self.damping, 1), (&self.stiffness, 0)] {
            for (entry, name) in matrix[row].iter().zip(coordinates) {
                let variable = Normal::of(&Variable::of(name, order).to_expr())?;
                sum = sum.plus(&entry.times(&variable)?)?;
            }
        }
        Ok(sum)
    }

    /// Whether no velocity stands in the equations.
    pub(super) fn is_undamped(&self) -> bool {
        self.damping.iter().flatten().all(Normal::is_zero)
    }
}

/// A position at rest, ready to be put into derivatives.
struct Place {
    moving: BTreeSet<Name>,
    position: Substitution,
}

impl Place {
    fn new(coordinates: &[Name], position: &[Expr]) -> Self {
        let values = coordinates.iter().zip(position);
        Self {
            moving: coordinates.iter().cloned().collect(),
            position: values.fold(Substitution::new(), |put, (name, value)| {
                put.with(name.clone(), value.clone())
            }),
        }
    }

    /// The derivatives of all residuals by all coordinates, or their time derivatives, at this place.
    fn slopes(
        &self,
        residuals: &[Normal],
        coordinates: &[Name],
        order: u8,
    ) -> Result<Matrix, SymbolicError> {
        let slope = |residual: &Expr, name: &Name| {
            let slope = differentiate(residual, Variable::of(name, order))?;
            let at_rest = super::equilibrium::at_rest(&slope, &self.moving)?;
            Normal::of(&self.position.apply(&at_rest)?)
        };
        let row = |residual: &Normal| {
            let residual = residual.to_expr(&Order::new());
            let names = coordinates.iter();
            names.map(|name| slope(&residual, name)).collect()
        };
        residuals.iter().map(row).collect()
    }
}
