//! Formulas substituted for names.

use std::sync::Arc;

use super::derivative::resolve_diff;
use super::{SymbolicError, bounded, time_derivative};
use crate::expr::{Expr, Kind, Name, Path};
use vibank_dynamics::numerics::{SortedMap, SortedSet};

/// Formulas to be substituted for names, all at once.
///
/// A primed name is replaced by the time derivative of what is substituted: with `x = r*theta`, where
/// `theta` is moving, `x'` becomes `r*theta'`.
///
/// ```
/// use vibank_formula::expr::{Expr, Name, Substitution};
/// let rolling = Substitution::moving([Name::new("theta")])
///     .with("x", Expr::name("r") * Expr::name("theta"));
/// let velocity = rolling.apply(&Expr::name("x").prime(1)).unwrap();
/// assert_eq!(velocity, Expr::name("r") * Expr::name("theta").prime(1));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    names: SortedMap<Name, Arc<Replacement>>,
    paths: SortedMap<Path, Arc<Replacement>>,
    moving: SortedSet<Name>,
}

/// What is substituted, with the names that stand in it.
#[derive(Debug)]
struct Replacement {
    expr: Expr,
    names: SortedSet<Name>,
}

impl Replacement {
    fn of(expr: Expr) -> Arc<Self> {
        let mut names = SortedSet::new();
        expr.walk(&mut |node| {
            if let Kind::Name(name) = node.kind() {
                names.insert(name.clone());
            }
        });
        Arc::new(Self { expr, names })
    }
}

impl Substitution {
    /// Nothing to be substituted, where no name moves with time (but `t` itself).
    pub fn new() -> Self {
        Self::default()
    }

    /// Nothing to be substituted yet, where these names move with time.
    pub fn moving(names: impl IntoIterator<Item = Name>) -> Self {
        Self {
            moving: names.into_iter().collect(),
            ..Self::default()
        }
    }

    /// Puts a formula in for a name.
    #[must_use]
    pub fn with(mut self, name: impl Into<Name>, value: Expr) -> Self {
        self.names.insert(name.into(), Replacement::of(value));
        self
    }

    /// Puts a formula in for a quantity of a model.
    #[must_use]
    pub fn with_path(mut self, path: Path, value: Expr) -> Self {
        self.paths.insert(path, Replacement::of(value));
        self
    }

    /// The formula with everything substituted.
    ///
    /// # Errors
    ///
    /// [`SymbolicError::Captured`] where a bound name would catch a name of what is substituted,
    /// [`SymbolicError::TooLarge`], and the errors of derivatives of primed or differentiated names.
    pub fn apply(&self, expr: &Expr) -> Result<Expr, SymbolicError> {
        if self.names.is_empty() && self.paths.is_empty() {
            return Ok(expr.clone());
        }
        let result = match expr.kind() {
            Kind::Name(name) => self
                .names
                .get(name)
                .map_or(expr, |value| &value.expr)
                .clone(),
            Kind::Path(path) => self
                .paths
                .get(path)
                .map_or(expr, |value| &value.expr)
                .clone(),
            Kind::Prime(inner, order) => self.in_prime(expr, inner, *order)?,
            Kind::Diff(inner, names) => self.apply(&resolve_diff(inner, names)?)?,
            Kind::At(inner, values) => {
                let names: Vec<_> = values.iter().map(|(name, _)| name.clone()).collect();
                let values = values
                    .iter()
                    .map(|(name, value)| Ok((name.clone(), self.apply(value)?)))
                    .collect::<Result<_, SymbolicError>>()?;
                let inner = self.without(&names, expr)?.apply(inner)?;
                Expr::new(Kind::At(inner, values), expr.span())
            }
            Kind::Root(inner, name, low, high) => {
                let inner = self
                    .without(std::slice::from_ref(name), expr)?
                    .apply(inner)?;
                let kind = Kind::Root(inner, name.clone(), self.apply(low)?, self.apply(high)?);
                Expr::new(kind, expr.span())
            }
            Kind::Integral(inner, name, from, to) => {
                let inner = self
                    .without(std::slice::from_ref(name), expr)?
                    .apply(inner)?;
                let kind = Kind::Integral(inner, name.clone(), self.apply(from)?, self.apply(to)?);
                Expr::new(kind, expr.span())
            }
            _ => expr.try_map_children(&mut |child| self.apply(child))?,
        };
        bounded(result)
    }

    /// A name whose formula moves is replaced by the derivative of that formula.
    fn in_prime(&self, expr: &Expr, inner: &Expr, order: u8) -> Result<Expr, SymbolicError> {
        let replaced = self.apply(inner)?;
        if replaced.is_same(inner) && matches!(inner.kind(), Kind::Name(_)) {
            return Ok(expr.clone());
        }
        let mut rate = replaced;
        for _ in 0..order {
            rate = time_derivative(&rate, &self.moving)?;
        }
        Ok(rate)
    }

    /// The same inside an operator that binds these names.
    fn without(&self, bound: &[Name], operator: &Expr) -> Result<Self, SymbolicError> {
        let names = self.names.iter().filter(|(name, _)| !bound.contains(name));
        let moving = self.moving.iter().filter(|name| !bound.contains(name));
        let inner = Self {
            names: names
                .map(|(name, value)| (name.clone(), Arc::clone(value)))
                .collect(),
            paths: self.paths.clone(),
            moving: moving.cloned().collect(),
        };
        let caught = {
            let mut values = inner.names.values().chain(inner.paths.values());
            values.find_map(|value| bound.iter().find(|name| value.names.contains(name)))
        };
        if let Some(name) = caught {
            return Err(SymbolicError::Captured {
                name: name.clone(),
                span: operator.span(),
            });
        }
        Ok(inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> Expr {
        Expr::name(text)
    }

    #[test]
    fn all_names_are_replaced_at_once() {
        let swap = Substitution::new()
            .with("a", name("b"))
            .with("b", name("a"));
        assert_eq!(
            swap.apply(&(name("a") / name("b"))).unwrap(),
            name("b") / name("a")
        );
    }

    #[test]
    fn primes_follow_prescribed_motion() {
        let base = Substitution::moving([Name::new("z")])
            .with("x", name("z") + name("a") * name("t").squared());
        assert_eq!(
            base.apply(&name("x").prime(2)).unwrap(),
            name("z").prime(2) + name("a") * Expr::number(2)
        );
        assert_eq!(base.apply(&name("z").prime(1)).unwrap(), name("z").prime(1));
    }

    #[test]
    fn bound_names_stay_and_are_not_captured() {
        let integral = |inner: Expr| {
            Expr::derived(Kind::Integral(
                inner,
                Name::new("s"),
                Expr::number(0),
                name("s"),
            ))
        };
        let put = Substitution::new().with("s", name("b"));
        assert_eq!(
            put.apply(&integral(name("s"))).unwrap(),
            Expr::derived(Kind::Integral(
                name("s"),
                Name::new("s"),
                Expr::number(0),
                name("b")
            ))
        );
        let caught = Substitution::new().with("k", name("s"));
        assert!(matches!(
            caught.apply(&integral(name("k"))),
            Err(SymbolicError::Captured { .. })
        ));
    }
}
