//! Partial and total derivatives.

use super::calls::{choice, of_many_arguments, of_one_argument, of_two_arguments};
use super::{SymbolicError, bounded};
use crate::expr::{Constant, Expr, Function, Kind, Name, Operator};
use vibank_dynamics::numerics::SortedSet;

/// A name or one of its time derivatives, as the independent variable of a partial derivative.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Variable {
    /// The name, as it is written in the formula.
    pub name: Name,
    /// 0 for the name itself, 1 for `x'`, 2 for `x''`.
    pub order: u8,
}

impl Variable {
    /// The time derivative of this order of a name.
    pub fn of(name: &Name, order: u8) -> Self {
        Self {
            name: name.clone(),
            order,
        }
    }

    /// It as a formula.
    pub fn to_expr(&self) -> Expr {
        Expr::name(self.name.clone()).prime(self.order)
    }
}

impl From<&Name> for Variable {
    fn from(name: &Name) -> Self {
        Self::of(name, 0)
    }
}

impl From<&str> for Variable {
    fn from(name: &str) -> Self {
        Self::of(&Name::new(name), 0)
    }
}

/// The partial derivative by a name, or by a time derivative of it.
///
/// All other names, and the other time derivatives of the same name, are held constant.
/// Piecewise functions are differentiated by pieces: `if`, `abs`, `min`, `max`, `clamp`, `sign`, `mod`.
///
/// ```
/// use vibank_formula::expr::{Expr, Name, Variable, differentiate};
/// let (m, x) = (Expr::name("m"), Name::new("x"));
/// let velocity = Expr::name("x").prime(1);
/// let kinetic = Expr::number(1) / Expr::number(2) * m.clone() * velocity.clone().squared();
/// let momentum = differentiate(&kinetic, Variable::of(&x, 1)).unwrap();
/// assert!(differentiate(&kinetic, &x).unwrap().is_zero());
/// assert_eq!(differentiate(&momentum, Variable::of(&x, 1)).unwrap(), m);
/// ```
///
/// # Errors
///
/// [`SymbolicError::NotDifferentiable`], [`SymbolicError::Unresolved`] for a path whose formula is
/// not put in, [`SymbolicError::TooLarge`].
pub fn differentiate(expr: &Expr, by: impl Into<Variable>) -> Result<Expr, SymbolicError> {
    Rules {
        leaves: Leaves::Partial(by.into()),
        bound: Vec::new(),
    }
    .derivative(expr)
}

/// The total derivative by time: `q` becomes `q'` for each of the `moving` names, `q'` becomes `q''`,
/// and `t` becomes 1; all other names are constant.
///
/// ```
/// use vibank_formula::expr::{Expr, Function, Name, time_derivative};
/// let sine = Expr::call(Function::Sin, [Expr::name("q")]);
/// let rate = time_derivative(&sine, &[Name::new("q")].into()).unwrap();
/// assert_eq!(rate, Expr::name("q").prime(1) * Expr::call(Function::Cos, [Expr::name("q")]));
/// ```
///
/// # Errors
///
/// As for [`differentiate`].
pub fn time_derivative(expr: &Expr, moving: &SortedSet<Name>) -> Result<Expr, SymbolicError> {
    Rules {
        leaves: Leaves::Time(moving),
        bound: Vec::new(),
    }
    .derivative(expr)
}

/// What the derivative of a name is.
enum Leaves<'a> {
    Partial(Variable),
    Time(&'a SortedSet<Name>),
}

impl Leaves<'_> {
    fn derivative(&self, name: &Name, order: u8) -> Expr {
        let is_one = match self {
            Self::Partial(by) => by.name == *name && by.order == order,
            Self::Time(_) if order == 0 && name.as_str() == "t" => true,
            Self::Time(moving) => {
                if order > 0 || moving.contains(name) {
                    return Expr::name(name.clone()).prime(order.saturating_add(1));
                }
                false
            }
        };
        Expr::number(i32::from(is_one))
    }
}

/// The rules of differentiation over given leaves.
struct Rules<'a> {
    leaves: Leaves<'a>,
    /// Names bound by the operators around the place, which no longer mean the variable.
    bound: Vec<Name>,
}

impl Rules<'_> {
    fn derivative(&mut self, expr: &Expr) -> Result<Expr, SymbolicError> {
        let zero = Expr::number(0);
        let result = match expr.kind() {
            Kind::Name(name) if self.bound.contains(name) => zero,
            Kind::Name(name) => self.leaves.derivative(name, 0),
            Kind::Prime(inner, order) => self.of_prime(expr, inner, *order)?,
            Kind::Path(path) => {
                return Err(SymbolicError::Unresolved {
                    path: path.clone(),
                    span: expr.span(),
                });
            }
            Kind::Index(vector, indices) => {
                let inner = self.derivative(vector)?;
                if inner.is_zero() {
                    zero
                } else {
                    Expr::derived(Kind::Index(inner, indices.clone()))
                }
            }
            Kind::Negate(inner) => -self.derivative(inner)?,
            Kind::Binary(operator, a, b) => self.of_binary(*operator, a, b)?,
            Kind::If(condition, a, b) => {
                let (first, second) = (self.derivative(a)?, self.derivative(b)?);
                choice(condition.clone(), first, second)
            }
            Kind::Call(function, arguments) => self.of_call(expr, *function, arguments)?,
            Kind::Array(entries) => self.of_array(entries)?,
            Kind::At(inner, values) => self.of_at(inner, values)?,
            Kind::Diff(inner, names) => {
                let resolved = resolve_diff(inner, names)?;
                self.derivative(&resolved)?
            }
            Kind::Root(inner, name, _, _) => self.of_root(expr, inner, name)?,
            Kind::Integral(inner, name, from, to) => self.of_integral(inner, name, from, to)?,
            Kind::Compare(..) | Kind::And(..) | Kind::Or(..) | Kind::Not(_) => {
                return Err(not_differentiable("a condition", expr));
            }
            _ => zero,
        };
        bounded(result)
    }

    fn of_prime(&mut self, expr: &Expr, inner: &Expr, order: u8) -> Result<Expr, SymbolicError> {
        match (inner.kind(), &self.leaves) {
            (Kind::Name(name), leaves) => Ok(leaves.derivative(name, order)),
            (_, Leaves::Time(_)) => {
                let mut rate = inner.clone();
                for _ in 0..=order {
                    rate = self.derivative(&rate)?;
                }
                Ok(rate)
            }
            (_, Leaves::Partial(_)) => Err(not_differentiable("'", expr)),
        }
    }

    fn of_binary(&mut self, operator: Operator, a: &Expr, b: &Expr) -> Result<Expr, SymbolicError> {
        let (da, db) = (self.derivative(a)?, self.derivative(b)?);
        Ok(match operator {
            Operator::Add => da + db,
            Operator::Subtract => da - db,
            Operator::Multiply => da * b.clone() + a.clone() * db,
            // The rule would square the divisor, which no light simplification takes back.
            Operator::Divide if db.is_zero() => da / b.clone(),
            Operator::Divide => (da * b.clone() - a.clone() * db) / b.clone().squared(),
            Operator::Power => power_rule(a, b, da, db),
        })
    }

    fn of_array(&mut self, entries: &[Expr]) -> Result<Expr, SymbolicError> {
        let mut rates = Vec::with_capacity(entries.len());
        for entry in entries {
            rates.push(self.derivative(entry)?);
        }
        // A row that is the name of a constant vector has the derivative 0, and still has to be a row.
        let row = rates
            .iter()
            .find(|rate| matches!(rate.kind(), Kind::Array(_)));
        if let Some(zeros) = row.map(zeros_like) {
            for rate in rates.iter_mut().filter(|rate| rate.is_zero()) {
                *rate = zeros.clone();
            }
        }
        Ok(Expr::array(rates))
    }

    /// The derivative of `f` with names bound: what moves outside of them, and the chain rule over them.
    fn of_at(&mut self, inner: &Expr, values: &[(Name, Expr)]) -> Result<Expr, SymbolicError> {
        let at = |expr: Expr| match expr.as_number() {
            Some(_) => expr,
            None => Expr::derived(Kind::At(expr, values.to_vec())),
        };
        let depth = self.bound.len();
        self.bound
            .extend(values.iter().map(|(name, _)| name.clone()));
        let direct = self.derivative(inner);
        self.bound.truncate(depth);
        let mut sum = at(direct?);
        for (name, value) in values {
            let rate = self.derivative(value)?;
            if !rate.is_zero() {
                sum = sum + at(differentiate(inner, name)?) * rate;
            }
        }
        Ok(sum)
    }

    /// The implicit function theorem: `f(r, x) = 0` moves its root by `-(∂f/∂x)/(∂f/∂r)`.
    fn of_root(&mut self, root: &Expr, inner: &Expr, name: &Name) -> Result<Expr, SymbolicError> {
        self.bound.push(name.clone());
        let direct = self.derivative(inner);
        self.bound.pop();
        let direct = direct?;
        if direct.is_zero() {
            return Ok(direct);
        }
        let at_root = |expr| Expr::derived(Kind::At(expr, vec![(name.clone(), root.clone())]));
        Ok(-(at_root(direct) / at_root(differentiate(inner, name)?)))
    }

    /// Leibniz's rule.
    fn of_integral(
        &mut self,
        inner: &Expr,
        name: &Name,
        from: &Expr,
        to: &Expr,
    ) -> Result<Expr, SymbolicError> {
        self.bound.push(name.clone());
        let direct = self.derivative(inner);
        self.bound.pop();
        let direct = direct?;
        let inside = if direct.is_zero() {
            direct
        } else {
            Expr::derived(Kind::Integral(
                direct,
                name.clone(),
                from.clone(),
                to.clone(),
            ))
        };
        let at =
            |end: &Expr| Expr::derived(Kind::At(inner.clone(), vec![(name.clone(), end.clone())]));
        Ok(inside + at(to) * self.derivative(to)? - at(from) * self.derivative(from)?)
    }

    fn of_call(
        &mut self,
        call: &Expr,
        function: Function,
        arguments: &[Expr],
    ) -> Result<Expr, SymbolicError> {
        let rates: Vec<Expr> = arguments
            .iter()
            .map(|argument| self.derivative(argument))
            .collect::<Result<_, _>>()?;
        if rates.iter().all(Expr::is_zero) {
            return Ok(Expr::number(0));
        }
        match (arguments, rates.as_slice()) {
            ([u], [du]) => of_one_argument(call, function, u, du),
            ([u, v], [du, dv]) if !matches!(function, Function::Min | Function::Max) => {
                of_two_arguments(call, function, [u, v], [du, dv])
            }
            _ => of_many_arguments(call, function, arguments, &rates),
        }
    }
}

/// The formula that `diff(f, x, …)` stands for.
pub(crate) fn resolve_diff(inner: &Expr, names: &[Name]) -> Result<Expr, SymbolicError> {
    names
        .iter()
        .try_fold(inner.clone(), |expr, name| differentiate(&expr, name))
}

pub(crate) fn not_differentiable(what: &'static str, expr: &Expr) -> SymbolicError {
    SymbolicError::NotDifferentiable {
        what,
        span: expr.span(),
    }
}

fn power_rule(base: &Expr, exponent: &Expr, du: Expr, dv: Expr) -> Expr {
    let by_base = if du.is_zero() {
        du
    } else {
        let lower = exponent.clone() - Expr::number(1);
        exponent.clone() * base.clone().power(lower) * du
    };
    // A constant exponent needs no logarithm, which a base below zero does not have.
    if dv.is_zero() {
        return by_base;
    }
    let power = base.clone().power(exponent.clone());
    by_base + power * natural_logarithm(base) * dv
}

fn natural_logarithm(expr: &Expr) -> Expr {
    match expr.kind() {
        Kind::Constant(Constant::E) => Expr::number(1),
        _ => Expr::call(Function::Ln, [expr.clone()]),
    }
}

/// Zeros in the shape of an array.
fn zeros_like(expr: &Expr) -> Expr {
    match expr.kind() {
        Kind::Array(entries) => Expr::array(entries.iter().map(zeros_like).collect::<Vec<_>>()),
        _ => Expr::number(0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Relation;
    use crate::expr::symbolic::calls::compare;

    fn name(text: &str) -> Expr {
        Expr::name(text)
    }

    fn sine(expr: Expr) -> Expr {
        Expr::call(Function::Sin, [expr])
    }

    fn cosine(expr: Expr) -> Expr {
        Expr::call(Function::Cos, [expr])
    }

    #[test]
    fn rules_of_products_quotients_and_powers() {
        let x = || name("x");
        let by_x = |expr: Expr| differentiate(&expr, "x").unwrap();
        assert_eq!(
            by_x(name("k") * x().squared()),
            name("k") * (Expr::number(2) * x())
        );
        assert_eq!(by_x(name("a") / x()), -(name("a") / x().squared()));
        assert_eq!(
            by_x(x().power(Expr::number(3))),
            Expr::number(3) * x().squared()
        );
        assert_eq!(
            by_x(sine(name("a") * x())),
            name("a") * cosine(name("a") * x())
        );
        assert!(by_x(name("y") * name("x").prime(1)).is_zero());
    }

    #[test]
    fn pieces_are_differentiated_by_pieces() {
        let x = || name("x");
        let magnitude = Expr::call(Function::Abs, [x()]);
        assert_eq!(
            differentiate(&magnitude, "x").unwrap(),
            Expr::call(Function::Sign, [x()])
        );
        let least = Expr::call(Function::Min, [x().squared(), name("a")]);
        let expected = choice(
            compare(&x().squared(), Relation::LessOrEqual, &name("a")),
            Expr::number(2) * x(),
            Expr::number(0),
        );
        assert_eq!(differentiate(&least, "x").unwrap(), expected);
    }

    #[test]
    fn time_moves_coordinates_and_explicit_time() {
        let moving = SortedSet::from([Name::new("q")]);
        let rate = |expr: Expr| time_derivative(&expr, &moving).unwrap();
        assert_eq!(rate(name("q")), name("q").prime(1));
        assert_eq!(rate(name("q").prime(1)), name("q").prime(2));
        assert_eq!(rate(name("r") * name("q")), name("r") * name("q").prime(1));
        assert_eq!(
            rate(sine(name("Omega") * name("t"))),
            name("Omega") * cosine(name("Omega") * name("t"))
        );
        assert_eq!(
            rate((name("r") * name("q")).prime(1)),
            name("r") * name("q").prime(2)
        );
    }

    #[test]
    fn bound_names_are_local() {
        let integral = Expr::derived(Kind::Integral(
            name("x").squared(),
            Name::new("x"),
            Expr::number(0),
            name("b"),
        ));
        assert!(differentiate(&integral, "x").unwrap().is_zero());
        let by_end = differentiate(&integral, "b").unwrap();
        assert_eq!(
            by_end,
            Expr::derived(Kind::At(
                name("x").squared(),
                vec![(Name::new("x"), name("b"))]
            ))
        );
    }

    #[test]
    fn what_has_no_derivative_is_refused() {
        let floor = Expr::call(Function::Floor, [name("x")]);
        assert!(matches!(
            differentiate(&floor, "x"),
            Err(SymbolicError::NotDifferentiable { what: "floor", .. })
        ));
        assert!(differentiate(&floor, "y").unwrap().is_zero());
    }

    #[test]
    fn growth_is_bounded() {
        let product = (0..15).fold(sine(name("x")), |expr, _| expr.clone() * expr);
        let result = differentiate(&product, "x");
        assert_eq!(result, Err(SymbolicError::TooLarge));
    }
}
