//! Names resolved, forms and dimensions checked: a formula that passes can be compiled, and its value has a known type.
//!
//! All findings of a formula come at once; what follows from a finding is not reported again.

mod bound;
mod error;
mod function;
mod matrix;
mod operator;

pub use error::{CheckError, Joint};

use super::types::agree;
use super::{
    AnyDimension, Constant, Equation, Expr, Field, Form, Interval, Kind, Name, Path, Shape, Type,
};
use crate::unit::Dimension;
use vibank_dynamics::numerics::Rational;
use vibank_source::{Span, nearest};

/// What the names of a formula stand for.
///
/// `t`, if it may be used, is a name like any other.
pub trait Scope {
    /// The type of a name.
    fn name(&self, name: &Name) -> Option<Type>;

    /// The type of a quantity of a model.
    fn path(&self, path: &Path) -> Option<Type> {
        let _ = path;
        None
    }

    /// Whether a name may change with time, so that it may be primed.
    fn is_moving(&self, name: &Name) -> bool {
        let _ = name;
        true
    }

    /// The names and paths that are known, for help with misspelt ones.
    fn known(&self) -> Vec<String>;
}

pub(crate) fn formula(expr: &Expr, scope: &dyn Scope) -> Result<Type, Vec<CheckError>> {
    let mut checker = TypeChecker::new(scope);
    let found = checker.of(expr);
    checker.finish(found)
}

pub(crate) fn equation(equation: &Equation, scope: &dyn Scope) -> Result<Type, Vec<CheckError>> {
    let mut checker = TypeChecker::new(scope);
    let sides = [&equation.left, &equation.right];
    let found = operator::joined(&mut checker, Joint::Equation, "=", sides);
    checker.finish(found)
}

pub(crate) fn interval(interval: &Interval, scope: &dyn Scope) -> Result<Type, Vec<CheckError>> {
    let mut checker = TypeChecker::new(scope);
    let ends = [&interval.from, &interval.to];
    let dimension = operator::same_reals(&mut checker, Joint::Interval, &ends);
    checker.finish(dimension.map(Type::real))
}

/// The state of a check. A type that is `None` has been reported.
struct TypeChecker<'a> {
    scope: &'a dyn Scope,
    /// Names that operators bind around the place.
    local: Vec<(Name, Type)>,
    findings: Vec<CheckError>,
}

impl<'a> TypeChecker<'a> {
    fn new(scope: &'a dyn Scope) -> Self {
        Self {
            scope,
            local: Vec::new(),
            findings: Vec::new(),
        }
    }

    fn finish(mut self, found: Option<Type>) -> Result<Type, Vec<CheckError>> {
        vibank_dynamics::numerics::sort_by_key(&mut self.findings, CheckError::span);
        match found {
            Some(found) if self.findings.is_empty() => Ok(found),
            _ => Err(self.findings),
        }
    }

    fn report(&mut self, finding: CheckError) -> Option<Type> {
        self.findings.push(finding);
        None
    }

    fn of(&mut self, expr: &Expr) -> Option<Type> {
        match expr.kind() {
            Kind::Number(value) => Some(Type::real(of_number(*value))),
            Kind::Measure(value, unit) => {
                Some(Type::real(of_number(*value).map(|_| unit.dimension())))
            }
            Kind::Constant(Constant::Infinity) => Some(Type::real(None)),
            Kind::Constant(Constant::ImaginaryUnit) => Some(Type::complex(Dimension::PURE)),
            Kind::Constant(Constant::Pi | Constant::E) => Some(Type::real(Dimension::PURE)),
            Kind::Name(name) => self.name(name, expr.span()),
            Kind::Path(path) => self.path(path, expr.span()),
            Kind::Prime(inner, order) => self.prime(inner, *order),
            Kind::Index(inner, indices) => matrix::index(self, inner, indices, expr.span()),
            Kind::Negate(inner) => self.numbers(inner),
            Kind::Binary(operator, a, b) => {
                operator::arithmetic(self, *operator, a, b, expr.span())
            }
            Kind::Compare(operands, _) => {
                let operands: Vec<&Expr> = operands.iter().collect();
                operator::same_reals(self, Joint::Comparison, &operands)?;
                Some(Type::boolean())
            }
            Kind::And(a, b) | Kind::Or(a, b) => {
                let (a, b) = (self.condition(a), self.condition(b));
                a.and(b)
            }
            Kind::Not(inner) => self.condition(inner),
            Kind::If(condition, first, second) => {
                let condition = self.condition(condition);
                let value = operator::joined(self, Joint::Cases, "if", [first, second]);
                condition.and(value)
            }
            Kind::Call(function, arguments) => {
                function::call(self, *function, arguments, expr.span())
            }
            Kind::At(inner, values) => bound::at(self, inner, values),
            Kind::Diff(inner, names) => bound::derivative(self, inner, names, expr.span()),
            Kind::Root(inner, name, low, high) => {
                bound::search(self, inner, name, [low, high]).map(|(variable, _)| variable)
            }
            Kind::Integral(inner, name, low, high) => {
                let (variable, value) = bound::search(self, inner, name, [low, high])?;
                Some(Type::real(times(value.dimension(), variable.dimension())))
            }
            Kind::Array(parts) => matrix::array(self, parts),
        }
    }

    fn name(&mut self, name: &Name, span: Span) -> Option<Type> {
        let local = self.local.iter().rev().find(|(local, _)| local == name);
        let found = local
            .map(|(_, found)| found.clone())
            .or_else(|| self.scope.name(name));
        if found.is_some() {
            return found;
        }
        let mut known = self.scope.known();
        known.extend(self.local.iter().map(|(local, _)| local.to_string()));
        let nearest = nearest(name.as_str(), known.iter().map(String::as_str)).map(str::to_owned);
        self.report(CheckError::UnknownName {
            name: name.clone(),
            nearest,
            span,
        })
    }

    fn path(&mut self, path: &Path, span: Span) -> Option<Type> {
        if let Some(found) = self.scope.path(path) {
            return Some(found);
        }
        let known = self.scope.known();
        let nearest =
            nearest(&path.to_string(), known.iter().map(String::as_str)).map(str::to_owned);
        self.report(CheckError::UnknownPath {
            path: path.clone(),
            nearest,
            span,
        })
    }

    fn prime(&mut self, inner: &Expr, order: u8) -> Option<Type> {
        if let Kind::Name(name) = inner.kind()
            && self.scope.name(name).is_some()
            && !self.scope.is_moving(name)
        {
            return self.report(CheckError::NotMoving {
                name: name.clone(),
                span: inner.span(),
            });
        }
        Some(self.numbers(inner)?.map(|dimension| {
            (0..order).fold(dimension, |dimension, _| dimension / Dimension::TIME)
        }))
    }

    /// A number, vector or matrix.
    fn numbers(&mut self, expr: &Expr) -> Option<Type> {
        let found = self.of(expr)?;
        if found.field() == Field::Boolean {
            return self.report(CheckError::NumberDue {
                found: found.form(),
                span: expr.span(),
            });
        }
        Some(found)
    }

    /// A real or complex number.
    fn number(&mut self, expr: &Expr) -> Option<Type> {
        let found = self.numbers(expr)?;
        if found.shape() != Shape::Scalar {
            return self.report(CheckError::NumberDue {
                found: found.form(),
                span: expr.span(),
            });
        }
        Some(found)
    }

    fn real(&mut self, expr: &Expr) -> Option<Type> {
        let found = self.number(expr)?;
        if found.field() == Field::Complex {
            return self.report(CheckError::RealDue {
                found: found.form(),
                span: expr.span(),
            });
        }
        Some(found)
    }

    fn condition(&mut self, expr: &Expr) -> Option<Type> {
        let found = self.of(expr)?;
        if found.form() != Form::BOOLEAN {
            return self.report(CheckError::ConditionDue {
                found: found.form(),
                span: expr.span(),
            });
        }
        Some(found)
    }
}

/// The dimension of a pure number: zero has every dimension.
fn of_number(value: Rational) -> AnyDimension {
    (!value.is_zero()).then_some(Dimension::PURE)
}

/// The dimension of a product: that of zero is every dimension.
fn times(a: AnyDimension, b: AnyDimension) -> AnyDimension {
    Some(a? * b?)
}

/// All entries times something of this dimension.
fn scaled(found: &Type, factor: AnyDimension) -> Type {
    match factor {
        Some(factor) => found.map(|dimension| dimension * factor),
        None => Type::uniform(found.form(), None),
    }
}

/// The first two entries whose dimensions differ.
fn disagreement(a: &Type, b: &Type) -> Option<(Dimension, Dimension)> {
    let (a, b) = a.entries().zip(b.entries()).find(|(a, b)| !agree(*a, *b))?;
    a.zip(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::Unit;

    /// Names in units, separated by commas.
    struct Units(&'static str);

    impl Scope for Units {
        fn name(&self, name: &Name) -> Option<Type> {
            let unit = self
                .0
                .split(", ")
                .find_map(|entry| entry.strip_prefix(name.as_str())?.strip_prefix(": "));
            unit.map(|unit| Type::real(Unit::parse(unit).unwrap().dimension()))
        }

        fn is_moving(&self, name: &Name) -> bool {
            name.as_str() == "x"
        }

        fn known(&self) -> Vec<String> {
            self.0
                .split(", ")
                .map(|entry| entry.split(':').next().unwrap().to_owned())
                .collect()
        }
    }

    const SCOPE: Units = Units(
        "m: kg, k: N/m, c: N s/m, x: m, l: m, t: s, Omega: rad/s, n: 1, F: N, J: kg m^2, R: ohm, C: F",
    );

    fn dimension(formula: &str) -> String {
        let found = Expr::read(formula).unwrap().check(&SCOPE);
        let entries: Vec<String> = match found {
            Ok(found) => found
                .entries()
                .map(|entry| entry.map_or("any".to_owned(), Dimension::describe))
                .collect(),
            Err(findings) => panic!("{formula}: {findings:?}"),
        };
        entries.join(", ")
    }

    fn findings(formula: &str) -> Vec<String> {
        let findings = Expr::read(formula).unwrap().check(&SCOPE).unwrap_err();
        findings
            .iter()
            .map(|finding| format!("{finding} @{}", &formula[finding.span().range()]))
            .collect()
    }

    #[test]
    fn dimensions_follow_the_operations() {
        for (formula, expected) in [
            ("sqrt(k/m)", "1/s"),
            ("k*x + 0", "N"),
            ("0*k", "any"),
            ("(k/m)^(1/2)*t", "1"),
            ("(k/m)^-0.5", "s"),
            ("x'", "m/s"),
            ("m*x'' + c*x' + k*x", "N"),
            ("diff(1/2*k*x^2, x, x)", "N/m"),
            ("integral(k*x, x, 0, l)", "J"),
            ("root(k*s - F, s, 0, l)", "m"),
            ("at(x', t = 2*pi/Omega)", "m/s"),
            ("if x > 0 then k else 2[N/mm]", "N/m"),
            ("atan2(c*Omega, k - m*Omega^2)", "1"),
            ("abs(F/(k - m*Omega^2 + i*c*Omega))", "m"),
            ("x <= l < 3[m] and not n == 2", "1"),
            ("exp(-c/(2*m)*t)*cos(Omega*t)", "1"),
            ("n^n*2^n", "1"),
            ("max(x, l, 1[mm])", "m"),
            ("sign(x)*floor(n)", "1"),
            ("[[m, 0], [0, J]]", "kg, any, any, kg m^2"),
            ("[[m, m*l], [m*l, J]]*[x'', n/t^2]", "N, J"),
            (
                "det([[k, k*l], [k*l, k*l^2]] - Omega^2*[[m, m*l], [m*l, J]])",
                "N^2",
            ),
            ("[[m, 0], [0, J]][2, 2]", "kg m^2"),
            ("[[m, 0], [0, J]][1]", "kg, any"),
            ("transpose([[m, x, 1]])", "kg, m, 1"),
            ("dot([x, F], [F, x])", "J"),
            ("norm([x, l])", "m"),
        ] {
            assert_eq!(dimension(formula), expected, "{formula}");
        }
    }

    #[test]
    fn a_derivative_is_by_a_number() {
        struct Vector(Type);

        impl Scope for Vector {
            fn name(&self, _: &Name) -> Option<Type> {
                Some(self.0.clone())
            }

            fn known(&self) -> Vec<String> {
                Vec::new()
            }
        }

        let pair = Expr::read("[1, 2]").unwrap().check(&SCOPE).unwrap();
        let derivative = Expr::read("diff(u, u)").unwrap();
        let findings = derivative.check(&Vector(pair)).unwrap_err();
        assert!(
            matches!(findings[..], [CheckError::NumberDue { .. }]),
            "{findings:?}"
        );
    }

    #[test]
    #[expect(clippy::too_many_lines, reason = "a table")]
    fn all_that_is_wrong_is_said_at_once() {
        for (formula, expected) in [
            ("k + m", vec!["a sum of N/m and kg @k + m"]),
            ("k + 1", vec!["a sum of N/m and pure numbers @k + 1"]),
            ("x < m", vec!["a comparison of m and kg @x < m"]),
            (
                "if x > 0 then k else m",
                vec!["the two cases are in N/m and kg @k else m"],
            ),
            (
                "sin(x)",
                vec!["the argument of `sin` has to be a pure number, it is in m @x"],
            ),
            (
                "max(x, k)",
                vec!["the arguments of `max` are in m and N/m @x, k"],
            ),
            (
                "2^x",
                vec!["an exponent has to be a pure number, it is in m @x"],
            ),
            (
                "x^n",
                vec!["the power of a quantity in m needs a constant exponent @n"],
            ),
            (
                "x^(1/11)",
                vec!["the power 1/11 of m is not a dimension @x^(1/11)"],
            ),
            ("m + omega", vec!["`omega` is not known here @omega"]),
            ("Omeg*t", vec!["`Omeg` is not known here @Omeg"]),
            ("m'", vec!["`m` does not change with time @m"]),
            (
                "if x then 1 else 2",
                vec!["a condition is due, this is a number @x"],
            ),
            (
                "(x > 0) + 1",
                vec!["a number is due, this is a condition @x > 0"],
            ),
            (
                "i < 2",
                vec!["a real number is due, this is a complex number @i"],
            ),
            (
                "floor(i)",
                vec!["a real number is due, this is a complex number @i"],
            ),
            (
                "sin([1, 2])",
                vec!["a number is due, this is a vector of 2 @[1, 2]"],
            ),
            (
                "[1, 2] + [1, 2, 3]",
                vec!["`+` cannot join a vector of 2 and a vector of 3 @[1, 2] + [1, 2, 3]"],
            ),
            (
                "[1, 2]*[1, 2]",
                vec!["`*` cannot join a vector of 2 and a vector of 2 @[1, 2]*[1, 2]"],
            ),
            (
                "[1, 2][3]",
                vec!["there is no component 3 in a vector of 2 @[1, 2][3]"],
            ),
            (
                "[1, 2][n]",
                vec!["an index is an integer from 1, written out @n"],
            ),
            ("x[1]", vec!["a number has no component with 1 index @x[1]"]),
            (
                "[[1, 2], [3]]",
                vec!["`[ ]` cannot join a vector of 2 and a vector of 1 @[1, 2], [3]"],
            ),
            (
                "det([1, 2])",
                vec!["`det` takes a square matrix, this is a vector of 2 @[1, 2]"],
            ),
            (
                "det([[m, k], [1, 1]])",
                vec!["the terms of `det` are in pure numbers and 1/s^2 @[[m, k], [1, 1]]"],
            ),
            (
                "[[m, k], [k, m]]*[x, x]",
                vec!["the terms of `*` are in kg m and N @[[m, k], [k, m]]*[x, x]"],
            ),
            (
                "at(x, t = l)",
                vec!["`t` is in s, the value for it is in m @l"],
            ),
            (
                "root(t, t, 0, l)",
                vec!["`t` is in s, the value for it is in m @0, l"],
            ),
            ("model.M", vec!["`model.M` is not known here @model.M"]),
            (
                "sin(k) + cos(q)*ln(m)",
                vec![
                    "the argument of `sin` has to be a pure number, it is in N/m @k",
                    "`q` is not known here @q",
                    "the argument of `ln` has to be a pure number, it is in kg @m",
                ],
            ),
        ] {
            assert_eq!(findings(formula), expected, "{formula}");
        }
    }

    #[test]
    fn equations_and_intervals_need_equal_dimensions() {
        let equation = |text: &str| Equation::read(text).unwrap().check(&SCOPE);
        assert!(equation("m*x'' + c*x' + k*x = F").is_ok());
        assert!(equation("m*x'' = 0").is_ok());
        assert!(equation("m*x'' = x").is_err());
        let interval = |text: &str| Interval::read(text).unwrap().check(&SCOPE);
        assert_eq!(interval("[x, inf)").unwrap(), Type::real(Dimension::LENGTH));
        assert!(interval("[x, m]").is_err());
    }

    #[test]
    fn deep_formulas_are_checked_within_a_small_stack() {
        let deep = (0..190).fold("n".to_owned(), |inner, _| format!("sin({inner})"));
        let run = move || {
            let formula = Expr::read(&deep).unwrap();
            assert!(formula.names().uses(&Name::from("n")));
            formula.check(&SCOPE).unwrap()
        };
        let thread = std::thread::Builder::new()
            .stack_size(1 << 19)
            .spawn(run)
            .unwrap();
        assert_eq!(thread.join().unwrap(), Type::real(Dimension::PURE));
    }
}
