//! A potential energy as a sum of squares, as it is written.
//!
//! Frequencies that are small beside others keep their digits only if the solver sees each spring and
//! not the sums in the stiffness matrix.

use crate::expr::{Expr, Kind, Name, Normal, Operator, Variable, differentiate};
use crate::numerics::{Rational, SortedSet};

/// A term `factor * base²` with a base linear in the coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Square {
    pub(crate) factor: Expr,
    /// The derivatives of the base by the coordinates.
    pub(crate) row: Vec<Expr>,
}

/// The squares of an energy, up to terms that are linear in the coordinates; nothing if it has others.
pub(crate) fn squares(energy: &Expr, coordinates: &[Name]) -> Option<Vec<Square>> {
    let finder = Finder {
        coordinates,
        names: coordinates.iter().cloned().collect(),
    };
    finder.of(energy)
}

struct Finder<'a> {
    coordinates: &'a [Name],
    names: SortedSet<Name>,
}

impl Finder<'_> {
    fn of(&self, expr: &Expr) -> Option<Vec<Square>> {
        // Linear terms move the equilibrium and stiffen nothing.
        if self.row(expr).is_some() {
            return Some(Vec::new());
        }
        match expr.kind() {
            Kind::Negate(inner) => Some(scaled(self.of(inner)?, &Expr::number(-1))),
            Kind::Binary(Operator::Add, a, b) => Some([self.of(a)?, self.of(b)?].concat()),
            Kind::Binary(Operator::Subtract, a, b) => {
                let second = scaled(self.of(b)?, &Expr::number(-1));
                Some([self.of(a)?, second].concat())
            }
            Kind::Binary(Operator::Multiply, a, b) if self.is_constant(a) => {
                Some(scaled(self.of(b)?, a))
            }
            Kind::Binary(Operator::Multiply, a, b) if self.is_constant(b) => {
                Some(scaled(self.of(a)?, b))
            }
            // `(x1 - x2)*(x1 - x2)` is a square as well.
            Kind::Binary(Operator::Multiply, a, b) if a == b => self.square(a),
            Kind::Binary(Operator::Divide, a, b) if self.is_constant(b) => {
                Some(scaled(self.of(a)?, &(Expr::number(1) / b.clone())))
            }
            Kind::Binary(Operator::Power, base, exponent)
                if exponent.as_number() == Some(Rational::from(2)) =>
            {
                self.square(base)
            }
            _ => None,
        }
    }

    fn square(&self, base: &Expr) -> Option<Vec<Square>> {
        let row = self.row(base)?;
        Some(vec![Square {
            factor: Expr::number(1),
            row,
        }])
    }

    /// The derivatives of a formula that is linear in the coordinates and free of time.
    fn row(&self, expr: &Expr) -> Option<Vec<Expr>> {
        self.coordinates
            .iter()
            .map(|name| {
                let slope = Normal::of(&differentiate(expr, Variable::of(name, 0)).ok()?).ok()?;
                let is_constant = !self.names.iter().any(|name| slope.mentions(name));
                is_constant.then(|| slope.to_expr(&crate::expr::Order::new()))
            })
            .collect()
    }

    fn is_constant(&self, expr: &Expr) -> bool {
        let mut found = false;
        expr.walk(&mut |node| {
            found |= matches!(node.kind(), Kind::Name(name) if self.names.contains(name));
        });
        !found
    }
}

fn scaled(squares: Vec<Square>, factor: &Expr) -> Vec<Square> {
    let squares = squares.into_iter();
    squares
        .map(|square| Square {
            factor: factor.clone() * square.factor,
            ..square
        })
        .collect()
}
