//! The names of a formula.

use std::collections::BTreeSet;

use super::{Expr, Kind, Name, Path, Variable};

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
    /// Whether a name, or a time derivative of it, is free.
    pub fn uses(&self, name: &Name) -> bool {
        self.free.iter().any(|variable| variable.name == *name)
    }
}

impl Expr {
    /// The names that the formula uses.
    pub fn names(&self) -> Names {
        let mut collector = Collector::default();
        collector.visit(self, 0);
        let mut free = collector.free;
        vibank_dynamics::numerics::sort_by(&mut free, Ord::cmp);
        free.dedup();
        Names {
            free: free
                .into_iter()
                .map(|(name, order)| Variable::of(name, order))
                .collect(),
            paths: collector.paths.into_iter().cloned().collect(),
            bound: collector.bound.into_iter().cloned().collect(),
        }
    }

    /// Whether the formula has a free name, or a time derivative of it, for which `is_wanted` holds.
    pub fn reaches(&self, is_wanted: impl Fn(&Name) -> bool) -> bool {
        self.names()
            .free
            .iter()
            .any(|variable| is_wanted(&variable.name))
    }
}

impl Expr {
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
}

/// Gathers names from a formula. Its recursion is as deep as the formula, which is bounded.
#[derive(Default)]
struct Collector<'e> {
    /// Names with the order of the derivative, as often as they stand.
    free: Vec<(&'e Name, u8)>,
    paths: BTreeSet<&'e Path>,
    bound: BTreeSet<&'e Name>,
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
        self.bound.extend(&self.local[outside..]);
        self.visit(inner, 0);
        self.local.truncate(outside);
    }
}
