//! What was answered, as values: follow-through, statistics and programs take these, and read nothing again.

use crate::expr::{Equation, Expr};
use crate::numerics::Complex;
use crate::unit::Unit;

/// What a response was read as; numbers are in SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum Answered {
    /// A real number, with the unit that came with it.
    Number {
        /// Its value.
        si: f64,
        /// The unit that was typed; none where there was none.
        unit: Option<Unit>,
    },
    /// Numbers, in the order in which they were given.
    List(Vec<f64>),
    /// Complex numbers.
    Complex(Vec<Complex>),
    /// A formula in the symbols of the item.
    Formula(Expr),
    /// The equations of a part that asks for them, such as those of motion.
    Equations(Vec<Equation>),
    /// The entries of a matrix in numbers, by rows.
    Matrix(Vec<f64>),
    /// The entries of a matrix in symbols, row by row.
    SymbolicMatrix(Vec<Vec<Expr>>),
    /// The components of mode shapes, one shape after the other.
    Shapes(Vec<f64>),
    /// A function of one variable, with the unit in which its numbers are, if it has one.
    Function(Expr, Option<Unit>),
    /// Functions of time, one for each coordinate.
    Functions(Vec<Expr>),
    /// Intervals, ascending: their ends, `None` where there is no bound, and whether they are left out.
    Set(Vec<Bounds>),
    /// Options by their ids; of a ranking in their order.
    Options(Vec<String>),
}

/// The ends of an interval, `None` where there is no bound, and whether they are left out.
pub type Bounds = ([Option<f64>; 2], [bool; 2]);

impl Answered {
    /// Its numbers in SI units, complex ones as pairs; none where it is not made of numbers.
    pub fn si(&self) -> Vec<f64> {
        match self {
            Self::Number { si, .. } => vec![*si],
            Self::List(numbers) | Self::Matrix(numbers) | Self::Shapes(numbers) => numbers.clone(),
            Self::Complex(numbers) => numbers.iter().flat_map(|own| [own.re, own.im]).collect(),
            _ => Vec::new(),
        }
    }

    /// The formula that it is, if it is one in symbols; a matrix as an array.
    pub fn formula(&self) -> Option<Expr> {
        match self {
            Self::Formula(formula) | Self::Function(formula, None) => Some(formula.clone()),
            Self::SymbolicMatrix(rows) => {
                let rows = rows.iter().cloned().map(Expr::array);
                Some(Expr::array(rows.collect::<Vec<_>>()))
            }
            _ => None,
        }
    }
}
