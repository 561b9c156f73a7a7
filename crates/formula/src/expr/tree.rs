//! The tree of a formula.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use super::Function;
use crate::unit::Unit;
use crate::work;
use vibank_dynamics::numerics::Rational;
use vibank_source::Span;

/// A formula: an immutable tree that is cheap to clone and to share.
///
/// Every node knows where it was written ([`Span::NONE`] for what was derived).
/// Equality and hash look at the structure alone, not at the places.
#[derive(Clone)]
pub struct Expr(Arc<Node>);

#[derive(Debug)]
struct Node {
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

/// An identifier, `[A-Za-z][A-Za-z0-9_]*`; cheap to clone.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Name(Arc<str>);

/// A dotted path into a model, `model.motion.x1` or `models.relative.M`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Path(Arc<[Name]>);

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
        Self(Arc::new(Node {
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

impl Name {
    /// The name with these letters.
    pub fn new(text: impl Into<Arc<str>>) -> Self {
        Self(text.into())
    }

    /// Its letters.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl Path {
    /// The path of these names.
    pub fn new(names: impl Into<Arc<[Name]>>) -> Self {
        Self(names.into())
    }

    /// Its names, from `model` or `models` on.
    pub fn names(&self) -> &[Name] {
        &self.0
    }
}

impl From<&str> for Name {
    fn from(text: &str) -> Self {
        Self::new(text)
    }
}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.as_str())
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.as_str())
    }
}

impl fmt::Display for Path {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, name) in self.names().iter().enumerate() {
            write!(formatter, "{}{name}", if position == 0 { "" } else { "." })?;
        }
        Ok(())
    }
}

impl fmt::Debug for Path {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}
