//! Names, paths into models, and which of them a formula uses.

use std::fmt;
use std::sync::Arc;

use super::{Expr, Kind, Variable};
use vibank_dynamics::numerics::SortedSet;

/// An identifier, `[A-Za-z][A-Za-z0-9_]*`; cheap to clone.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Name(Arc<str>);

/// A dotted path into a model, `model.motion.x1` or `models.relative.M`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Path(Arc<[Name]>);

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

/// The names that a formula uses, free of what its operators bind: each once, sorted.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Expr, Name};
///
/// let formula = Expr::read("at(x', t = pi/omega) + integral(k*s, s, 0, model.stop_time)")?;
/// let names = formula.names();
/// let free: Vec<String> = names.free.iter().map(|variable| variable.to_expr().to_string()).collect();
/// assert_eq!(free, ["k", "omega", "x'"]);
/// assert_eq!(names.paths.len(), 1);
/// assert!(names.bound.contains(&Name::from("s")) && names.bound.contains(&Name::from("t")));
/// assert!(!names.uses(&Name::from("s")));
/// # Ok::<(), vibank_formula::expr::ReadError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Names {
    /// Names, and time derivatives of names, that get their value from outside.
    pub free: Vec<Variable>,
    /// Quantities of models.
    pub paths: Vec<Path>,
    /// Names that `at`, `root` and `integral` bind and by which `diff` derives. A quantity that depends on one of
    /// them matters as a formula, not by its value alone.
    pub bound: Vec<Name>,
}

impl Names {
    pub(crate) fn of(expr: &Expr) -> Self {
        let mut collector = Collector::default();
        collector.visit(expr, 0);
        let mut free = collector.free;
        vibank_dynamics::numerics::sort_by(&mut free, Ord::cmp);
        free.dedup();
        Self {
            free: free
                .into_iter()
                .map(|(name, order)| Variable::of(name, order))
                .collect(),
            paths: collector.paths.into_iter().cloned().collect(),
            bound: collector.bound.into_iter().cloned().collect(),
        }
    }

    /// Whether a name, or a time derivative of it, is free.
    pub fn uses(&self, name: &Name) -> bool {
        self.free.iter().any(|variable| variable.name == *name)
    }
}

/// Gathers names from a formula. Its recursion is as deep as the formula, which is bounded.
#[derive(Default)]
struct Collector<'e> {
    /// Names with the order of the derivative, as often as they stand.
    free: Vec<(&'e Name, u8)>,
    paths: SortedSet<&'e Path>,
    bound: SortedSet<&'e Name>,
    /// Names bound around the place.
    local: Vec<&'e Name>,
}

impl<'e> Collector<'e> {
    fn visit(&mut self, expr: &'e Expr, order: u8) {
        match expr.kind() {
            Kind::Name(name) => {
                if !self.local.contains(&name) {
                    self.free.push((name, order));
                }
            }
            Kind::Path(path) => {
                self.paths.insert(path);
            }
            Kind::Prime(inner, more) => self.visit(inner, order.saturating_add(*more)),
            Kind::At(inner, values) => {
                for (_, value) in values {
                    self.visit(value, 0);
                }
                self.within(values.iter().map(|(name, _)| name), inner);
            }
            Kind::Root(inner, name, low, high) | Kind::Integral(inner, name, low, high) => {
                self.visit(low, 0);
                self.visit(high, 0);
                self.within([name], inner);
            }
            Kind::Diff(inner, names) => {
                self.bound.extend(names);
                self.visit(inner, 0);
            }
            kind => kind.for_each_child(&mut |child| self.visit(child, order)),
        }
    }

    fn within(&mut self, names: impl IntoIterator<Item = &'e Name>, inner: &'e Expr) {
        let outside = self.local.len();
        self.local.extend(names);
        self.bound.extend(self.local[outside..].iter().copied());
        self.visit(inner, 0);
        self.local.truncate(outside);
    }
}
