//! The tree of a formula.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::ops::Neg;
use std::sync::Arc;

use super::{CheckError, Function, Name, Names, Notation, Path, ReadError, Scope, Type};
use super::{build, check, read, typeset};
use crate::unit::Unit;
use crate::work;
use vibank_dynamics::numerics::Rational;
use vibank_notation::Math;
use vibank_source::Span;

/// A formula: an immutable tree that is cheap to clone and to share.
///
/// Every node knows where it was written ([`Span::NONE`] for what was derived).
/// Equality and hash look at the structure alone, not at the places.
#[derive(Clone)]
pub struct Expr(Arc<ExprNode>);

#[derive(Debug)]
struct ExprNode {
    kind: Kind,
    span: Span,
    /// Number of nodes of the tree, counted with repetition; saturates.
    size: u32,
    /// Length of the longest path to a leaf.
    depth: u32,
    has_paths: bool,
}

/// What a node of a formula is.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// An exact pure number, as written (`0.5`) or derived (`5/6`).
    Number(Rational),
    /// An exact number with a unit, `0.1[m]`.
    Measure(Rational, Box<Unit>),
    /// A reserved constant.
    Constant(Constant),
    /// A parameter, quantity, coordinate, symbol, `t`, or the bound name of an operator.
    Name(Name),
    /// A quantity of a model, `model.equation.x1`.
    Path(Path),
    /// Time derivative: `x'` has order 1, `x''` order 2.
    Prime(Expr, u8),
    /// A component, `u[1]` or `M[1, 2]`, counted from 1.
    Index(Expr, Vec<Expr>),
    /// A sign in front.
    Negate(Expr),
    /// An arithmetic operation on two operands.
    Binary(Operator, Expr, Expr),
    /// A chain of comparisons, `a < b <= c`: one relation fewer than operands.
    Compare(Vec<Expr>, Vec<Relation>),
    /// True where both operands are.
    And(Expr, Expr),
    /// At least one.
    Or(Expr, Expr),
    /// The opposite.
    Not(Expr),
    /// `if condition then first else second`.
    If(Expr, Expr, Expr),
    /// A function of its arguments.
    Call(Function, Vec<Expr>),
    /// `at(f, x = a, …)`: the value of `f` where these names have these values.
    At(Expr, Vec<(Name, Expr)>),
    /// `diff(f, x, …)`: partial derivative, one name after the other.
    Diff(Expr, Vec<Name>),
    /// `root(f, x, lo, hi)`: the sign change of `f` in between.
    Root(Expr, Name, Expr, Expr),
    /// `integral(f, x, a, b)`.
    Integral(Expr, Name, Expr, Expr),
    /// A vector, or a matrix as an array of rows.
    Array(Vec<Expr>),
}

/// A reserved constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Constant {
    /// π = 3.14159….
    Pi,
    /// Euler's number, e = 2.71828….
    E,
    /// `i`, the imaginary unit.
    ImaginaryUnit,
    /// `inf`, no bound.
    Infinity,
}

/// An arithmetic operation on two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// `+`.
    Add,
    /// `-`.
    Subtract,
    /// `*`.
    Multiply,
    /// `/`.
    Divide,
    /// `^`.
    Power,
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Relation {
    /// `<`.
    Less,
    /// `<=`.
    LessOrEqual,
    /// `>`.
    Greater,
    /// `>=`.
    GreaterOrEqual,
    /// `==`.
    Equal,
    /// `!=`.
    NotEqual,
}

impl Expr {
    /// A node that stands at `span` in its text.
    pub fn new(kind: Kind, span: Span) -> Self {
        let (mut size, mut depth) = (1_u32, 0_u32);
        let mut has_paths = matches!(kind, Kind::Path(_));
        kind.for_each_child(&mut |child| {
            size = size.saturating_add(child.0.size);
            depth = depth.max(child.0.depth);
            has_paths |= child.0.has_paths;
        });
        Self(Arc::new(ExprNode {
            kind,
            span,
            size,
            depth: depth.saturating_add(1),
            has_paths,
        }))
    }

    /// A node that was derived, not written.
    pub fn derived(kind: Kind) -> Self {
        Self::new(kind, Span::NONE)
    }

    /// The node: a number, a name, an operation with its operands.
    pub fn kind(&self) -> &Kind {
        &self.0.kind
    }

    /// Where it stands in its text.
    pub fn span(&self) -> Span {
        self.0.span
    }

    /// Number of its nodes, counted with repetition; saturates at `u32::MAX`.
    pub fn size(&self) -> u32 {
        self.0.size
    }

    /// Length of the longest path to a leaf, 1 for a leaf.
    pub fn depth(&self) -> u32 {
        self.0.depth
    }

    /// Whether a quantity of a model stands in it.
    pub fn has_paths(&self) -> bool {
        self.0.has_paths
    }

    /// Whether two handles share one node.
    pub fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// Whether more than one handle leads to this node.
    pub(crate) fn is_shared(&self) -> bool {
        Arc::strong_count(&self.0) > 1
    }

    /// A number that no other living node has.
    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }

    /// Calls `visit` with each node, parents first, and with a shared one as often as it stands there.
    ///
    /// A tree of shared nodes may have more places than time allows: the walk is paid for by the budget that is open,
    /// and does not begin where that holds too little.
    pub fn walk<'e>(&'e self, visit: &mut impl FnMut(&'e Expr)) {
        // A visit takes a fraction of a unit.
        const VISITS_A_UNIT: u32 = 8;
        if work::spend(u64::from(self.size() / VISITS_A_UNIT)).is_err() {
            return;
        }
        let mut open = Vec::with_capacity(self.depth() as usize + 1);
        open.push(self);
        while let Some(expr) = open.pop() {
            visit(expr);
            let first = open.len();
            expr.kind().for_each_child(&mut |child| open.push(child));
            open[first..].reverse();
        }
    }

    /// The type of the formula.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::expr::{Expr, Name, Scope, Type};
    /// use vibank_formula::unit::Dimension;
    ///
    /// struct Spring;
    ///
    /// impl Scope for Spring {
    ///     fn name(&self, name: &Name) -> Option<Type> {
    ///         match name.as_str() {
    ///             "m" => Some(Type::real(Dimension::MASS)),
    ///             "k" => Some(Type::real(Dimension::FORCE / Dimension::LENGTH)),
    ///             _ => None,
    ///         }
    ///     }
    ///
    ///     fn known(&self) -> Vec<String> {
    ///         vec!["m".to_owned(), "k".to_owned()]
    ///     }
    /// }
    ///
    /// assert_eq!(Expr::read("sqrt(k/m)")?.check(&Spring).unwrap(), Type::real(Dimension::FREQUENCY));
    /// let findings = Expr::read("k + m*c")?.check(&Spring).unwrap_err();
    /// assert_eq!(findings[0].to_string(), "`c` is not known here");
    /// let findings = Expr::read("exp(k) < 1 and k < m")?.check(&Spring).unwrap_err();
    /// assert_eq!(findings[0].to_string(), "the argument of `exp` has to be a pure number, it is in N/m");
    /// assert_eq!(findings[1].to_string(), "a comparison of N/m and kg");
    /// # Ok::<(), vibank_formula::expr::ReadError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// All that is wrong with it, by place.
    pub fn check(&self, scope: &dyn Scope) -> Result<Type, Vec<CheckError>> {
        check::formula(self, scope)
    }

    /// Reads a formula of the strict grammar.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_formula::expr::Expr;
    ///
    /// let formula = Expr::read("-x^2")?;
    /// assert_eq!(formula, Expr::read("-(x^2)")?);
    /// assert_eq!(Expr::read("2 k").unwrap_err().to_string(), "no operator between `2` and `k`");
    /// # Ok::<(), vibank_formula::expr::ReadError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The first place at which the text departs from the grammar, or the bound that it passes.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        read::formula(text)
    }

    /// The names that the formula uses.
    pub fn names(&self) -> Names {
        Names::of(self)
    }

    /// Whether the formula has a free name, or a time derivative of it, for which `is_wanted` holds.
    pub fn reaches(&self, is_wanted: impl Fn(&Name) -> bool) -> bool {
        self.names()
            .free
            .iter()
            .any(|variable| is_wanted(&variable.name))
    }

    /// Whether the formula can be evaluated at complex values of its names, where it keeps its meaning: it has no
    /// condition, no search, and only functions with a complex derivative.
    ///
    /// ```
    /// use vibank_formula::expr::Expr;
    ///
    /// assert!(Expr::read("sqrt(k/m)*sin(omega*t)")?.is_analytic());
    /// assert!(!Expr::read("abs(x) + floor(y)")?.is_analytic());
    /// # Ok::<(), vibank_formula::expr::ReadError>(())
    /// ```
    pub fn is_analytic(&self) -> bool {
        let mut is_analytic = true;
        self.walk(&mut |node| {
            is_analytic &= match node.kind() {
                Kind::Call(function, _) => function.is_analytic(),
                Kind::If(..)
                | Kind::Compare(..)
                | Kind::And(..)
                | Kind::Or(..)
                | Kind::Not(_)
                | Kind::Root(..)
                | Kind::Integral(..) => false,
                _ => true,
            };
        });
        is_analytic
    }

    /// The formula as typeset mathematics.
    ///
    /// Products stand side by side, quotients are fractions, time derivatives dots, and there are as few
    /// parentheses as reading needs.
    ///
    /// ```
    /// use vibank_formula::expr::{Expr, PlainNotation};
    /// let mass = Expr::name("m");
    /// let kinetic = mass * Expr::name("x").prime(1).squared() / Expr::number(2);
    /// assert_eq!(kinetic.typeset(&PlainNotation).latex(), r"\frac{m\dot{x}^2}{2}");
    /// ```
    pub fn typeset(&self, notation: &dyn Notation) -> Math {
        typeset::formula(self, notation)
    }

    /// An exact pure number.
    ///
    /// ```
    /// use vibank_formula::expr::Expr;
    /// let (half, x) = (Expr::number(1) / Expr::number(2), Expr::name("x"));
    /// assert_eq!(half.as_number().unwrap().to_string(), "1/2");
    /// assert_eq!(Expr::number(0) + x.clone() * Expr::number(1), x);
    /// ```
    pub fn number(value: impl Into<Rational>) -> Self {
        Self::derived(Kind::Number(value.into()))
    }

    /// A variable or parameter, by its name.
    pub fn name(name: impl Into<Name>) -> Self {
        Self::derived(Kind::Name(name.into()))
    }

    /// A reserved constant.
    pub fn constant(constant: Constant) -> Self {
        Self::derived(Kind::Constant(constant))
    }

    /// A function of arguments.
    pub fn call(function: Function, arguments: impl Into<Vec<Self>>) -> Self {
        Self::derived(Kind::Call(function, arguments.into()))
    }

    /// A vector, or a matrix as an array of rows.
    pub fn array(entries: impl Into<Vec<Self>>) -> Self {
        Self::derived(Kind::Array(entries.into()))
    }

    /// A time derivative of higher order: `x` becomes `x'`, `x'` becomes `x''`; the formula itself for order 0.
    #[must_use]
    pub fn prime(self, order: u8) -> Self {
        match self.kind() {
            _ if order == 0 => self,
            Kind::Prime(inner, lower) => {
                Self::derived(Kind::Prime(inner.clone(), lower.saturating_add(order)))
            }
            _ => Self::derived(Kind::Prime(self, order)),
        }
    }

    /// The power with this exponent.
    #[must_use]
    pub fn power(self, exponent: Self) -> Self {
        let (base, power) = (self.as_number(), exponent.as_number());
        match (base, power) {
            (_, Some(power)) if power == Rational::ONE => self,
            (_, Some(power)) if power.is_zero() => Self::number(1),
            (Some(base), _) if base == Rational::ONE => Self::number(1),
            (Some(base), Some(power)) => match build::folded_power(base, power) {
                Some(value) => Self::number(value),
                None => build::binary(Operator::Power, self, exponent),
            },
            _ => build::binary(Operator::Power, self, exponent),
        }
    }

    /// The square.
    #[must_use]
    pub fn squared(self) -> Self {
        self.power(Self::number(2))
    }

    /// Its value if it is a pure number, possibly with a sign in front.
    pub fn as_number(&self) -> Option<Rational> {
        match self.kind() {
            Kind::Number(value) => Some(*value),
            Kind::Negate(inner) => inner.as_number().map(Neg::neg),
            _ => None,
        }
    }

    /// Whether it is the pure number 0.
    pub fn is_zero(&self) -> bool {
        self.as_number().is_some_and(Rational::is_zero)
    }

    /// Whether it is the pure number 1.
    pub fn is_one(&self) -> bool {
        self.as_number() == Some(Rational::ONE)
    }

    /// The same node over other operands: each child is replaced by `change`'s answer, places are kept.
    ///
    /// # Errors
    ///
    /// The first one of `change`.
    pub fn try_map_children<E>(
        &self,
        change: &mut dyn FnMut(&Self) -> Result<Self, E>,
    ) -> Result<Self, E> {
        let mut unchanged = true;
        let kind = self.kind().try_map_children(&mut |child| {
            let changed = change(child)?;
            unchanged &= changed.is_same(child);
            Ok(changed)
        })?;
        Ok(if unchanged {
            self.clone()
        } else {
            Self::new(kind, self.span())
        })
    }
}

impl Kind {
    /// Calls `visit` with each operand, in the order written.
    pub fn for_each_child<'e>(&'e self, visit: &mut dyn FnMut(&'e Expr)) {
        match self {
            Self::Number(_)
            | Self::Measure(..)
            | Self::Constant(_)
            | Self::Name(_)
            | Self::Path(_) => {}
            Self::Prime(a, _) | Self::Negate(a) | Self::Not(a) | Self::Diff(a, _) => visit(a),
            Self::Binary(_, a, b) | Self::And(a, b) | Self::Or(a, b) => {
                [a, b].into_iter().for_each(visit);
            }
            Self::If(a, b, c) | Self::Root(a, _, b, c) | Self::Integral(a, _, b, c) => {
                [a, b, c].into_iter().for_each(visit);
            }
            Self::Compare(all, _) | Self::Call(_, all) | Self::Array(all) => {
                all.iter().for_each(visit);
            }
            Self::Index(a, all) => std::iter::once(a).chain(all).for_each(visit),
            Self::At(a, all) => std::iter::once(a)
                .chain(all.iter().map(|(_, value)| value))
                .for_each(visit),
        }
    }

    fn try_map_children<E>(
        &self,
        change: &mut dyn FnMut(&Expr) -> Result<Expr, E>,
    ) -> Result<Self, E> {
        let mut all = |list: &[Expr]| list.iter().map(&mut *change).collect::<Result<Vec<_>, E>>();
        Ok(match self {
            Self::Index(a, list) => {
                let list = all(list)?;
                Self::Index(change(a)?, list)
            }
            Self::Compare(list, relations) => Self::Compare(all(list)?, relations.clone()),
            Self::Call(function, list) => Self::Call(*function, all(list)?),
            Self::Array(list) => Self::Array(all(list)?),
            Self::Prime(a, order) => Self::Prime(change(a)?, *order),
            Self::Negate(a) => Self::Negate(change(a)?),
            Self::Not(a) => Self::Not(change(a)?),
            Self::Diff(a, names) => Self::Diff(change(a)?, names.clone()),
            Self::Binary(operator, a, b) => Self::Binary(*operator, change(a)?, change(b)?),
            Self::And(a, b) => Self::And(change(a)?, change(b)?),
            Self::Or(a, b) => Self::Or(change(a)?, change(b)?),
            Self::If(a, b, c) => Self::If(change(a)?, change(b)?, change(c)?),
            Self::Root(a, name, b, c) => {
                Self::Root(change(a)?, name.clone(), change(b)?, change(c)?)
            }
            Self::Integral(a, name, b, c) => {
                Self::Integral(change(a)?, name.clone(), change(b)?, change(c)?)
            }
            Self::At(a, bound) => {
                let bound = bound
                    .iter()
                    .map(|(name, value)| Ok((name.clone(), change(value)?)))
                    .collect::<Result<_, E>>()?;
                Self::At(change(a)?, bound)
            }
            _ => self.clone(),
        })
    }
}

impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.is_same(other) || self.0.size == other.0.size && self.0.kind == other.0.kind
    }
}

impl Eq for Expr {}

impl Hash for Expr {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.kind.hash(state);
    }
}

impl fmt::Debug for Expr {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.kind.fmt(formatter)
    }
}
