//! What is written with two formulas: equations and intervals.

use super::{CheckError, Expr, ReadError, Scope, Type, check, read};
use vibank_source::Span;

/// An equation, `a = b`.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Equation, Expr};
///
/// let equation = Equation::read("m*x'' + k*x = 0")?;
/// assert_eq!(equation.left, Expr::read("m*x'' + k*x")?);
/// # Ok::<(), vibank_formula::expr::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
}

/// An interval, `[a, b)`; a bound that is `inf` is none.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::Interval;
///
/// let interval = Interval::read("[mu_min, inf)")?;
/// assert_eq!(interval.open, [false, true]);
/// # Ok::<(), vibank_formula::expr::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    /// Lower bound.
    pub from: Expr,
    /// Upper bound.
    pub to: Expr,
    /// Whether the bounds are left out.
    pub open: [bool; 2],
}

impl Equation {
    /// Where it stands in its text.
    pub fn span(&self) -> Span {
        self.left.span().join(self.right.span())
    }

    /// What is zero where it holds: left minus right.
    pub fn difference(&self) -> Expr {
        self.left.clone() - self.right.clone()
    }

    /// The type of both sides.
    ///
    /// # Errors
    ///
    /// All that is wrong with them, by place.
    pub fn check(&self, scope: &dyn Scope) -> Result<Type, Vec<CheckError>> {
        check::equation(self, scope)
    }

    /// Reads `a = b`.
    ///
    /// # Errors
    ///
    /// As [`Expr::read`].
    pub fn read(text: &str) -> Result<Self, ReadError> {
        read::equation(text)
    }
}

impl Interval {
    /// Where its bounds stand in its text.
    pub fn span(&self) -> Span {
        self.from.span().join(self.to.span())
    }

    /// The type of both ends.
    ///
    /// # Errors
    ///
    /// All that is wrong with them, by place.
    pub fn check(&self, scope: &dyn Scope) -> Result<Type, Vec<CheckError>> {
        check::interval(self, scope)
    }

    /// Reads `[a, b)` and kin; a round bracket leaves its end out, `inf` is not a bound.
    ///
    /// # Errors
    ///
    /// As [`Expr::read`].
    pub fn read(text: &str) -> Result<Self, ReadError> {
        read::interval(text)
    }
}
