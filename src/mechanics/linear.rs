//! The linearized equations as formulas.

use super::equilibrium::{Balance, at_rest};
use crate::expr::{Expr, Name, Normal, Order, Substitution, SymbolicError, Variable};
use crate::numerics::SortedSet;

/// `M q'' + C q' + K q = f(t)` about an equilibrium, as formulas.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    pub(crate) mass: Matrix,
    pub(crate) damping: Matrix,
    pub(crate) stiffness: Matrix,
    /// The excitation of each equation: functions of time, and what the equilibrium leaves on the right.
    pub(crate) excitation: Vec<Normal>,
}

/// A square matrix by rows.
pub(crate) type Matrix = Vec<Vec<Normal>>;

impl Linear {
    /// The coefficients of equations that are linear as they stand; nothing if one is not, or if a coefficient
    /// changes with time.
    pub(crate) fn exact(residuals: &[Normal], coordinates: &[Name]) -> Option<Self> {
        let mut linear = Self {
            mass: Vec::new(),
            damping: Vec::new(),
            stiffness: Vec::new(),
            excitation: Vec::new(),
        };
        let moving: SortedSet<_> = coordinates.iter().cloned().collect();
        let time = SortedSet::from([Name::new("t")]);
        for residual in residuals {
            let mut rest = residual.clone();
            let matrices = [&mut linear.mass, &mut linear.damping, &mut linear.stiffness];
            for (matrix, order) in matrices.into_iter().zip([2, 1, 0]) {
                let mut row = Vec::new();
                for name in coordinates {
                    let (slope, others) = rest.linear_in(&Variable::of(name, order))?;
                    // A coefficient with time in it is that of parametric excitation, which has no natural
                    // frequency.
                    if slope.mentions_any(&moving) || slope.mentions_any(&time) {
                        return None;
                    }
                    row.push(slope);
                    rest = others;
                }
                matrix.push(row);
            }
            if rest.mentions_any(&moving) {
                return None;
            }
            linear.excitation.push(rest.negated());
        }
        Some(linear)
    }

    /// The linear parts of the residuals about `position`; nothing where time stands beside a coordinate.
    pub(crate) fn about(
        residuals: &[Normal],
        balance: &Balance,
        coordinates: &[Name],
        position: &[Expr],
    ) -> Result<Option<Self>, SymbolicError> {
        if !balance.is_autonomous {
            return Ok(None);
        }
        let place = RestPoint::new(coordinates, position);
        let matrix = |order| place.slopes(residuals, coordinates, order);
        let (mass, damping, stiffness) = (matrix(2)?, matrix(1)?, matrix(0)?);
        let time = Name::new("t");
        let mut entries = mass.iter().chain(&damping).chain(&stiffness).flatten();
        if entries.any(|entry| entry.mentions(&time)) {
            return Ok(None);
        }
        let mut excitation = Vec::new();
        for (row, own) in stiffness.iter().zip(&balance.excitation) {
            let mut right = own.negated();
            for (entry, rest) in row.iter().zip(position) {
                // The equation counts coordinates from their own zero, so that K times the equilibrium stands
                // on the right.
                right = right.plus(&entry.times(&Normal::of(rest)?)?)?;
            }
            excitation.push(right);
        }
        Ok(Some(Self {
            mass,
            damping,
            stiffness,
            excitation,
        }))
    }

    /// The derivatives of forces at rest by the coordinates, as functions of the position.
    pub(crate) fn slopes(
        restoring: &[Normal],
        coordinates: &[Name],
    ) -> Result<Matrix, SymbolicError> {
        RestPoint::new(&[], &[]).slopes(restoring, coordinates, 0)
    }

    /// The sum of one row on the left.
    pub(crate) fn left(&self, row: usize, coordinates: &[Name]) -> Result<Normal, SymbolicError> {
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
    pub(crate) fn is_undamped(&self) -> bool {
        self.damping.iter().flatten().all(Normal::is_zero)
    }
}

/// An equilibrium, ready to be put into derivatives.
struct RestPoint {
    moving: SortedSet<Name>,
    position: Substitution,
}

impl RestPoint {
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
        residuals
            .iter()
            .map(|residual| {
                let names = coordinates.iter();
                names
                    .map(|name| {
                        let slope = residual.derivative(&Variable::of(name, order))?;
                        let at_rest = at_rest(&slope, &self.moving)?;
                        // Most slopes are constant; writing them as formulas and reading them again would be most of the
                        // work.
                        if !at_rest.mentions_any(&self.moving) {
                            return Ok(at_rest);
                        }
                        Normal::of(&self.position.apply(&at_rest.to_expr(&Order::new()))?)
                    })
                    .collect()
            })
            .collect()
    }
}
