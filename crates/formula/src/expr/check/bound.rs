//! The types of operators that bind names.

use super::{CheckError, Joint, TypeChecker, disagreement, operator, scaled, times};
use crate::expr::{Expr, Name, Shape, Type};
use crate::unit::Dimension;
use vibank_source::Span;

pub(crate) fn at(
    checker: &mut TypeChecker<'_>,
    inner: &Expr,
    values: &[(Name, Expr)],
) -> Option<Type> {
    let mut bound = Vec::with_capacity(values.len());
    let mut all_fit = true;
    for (name, value) in values {
        let given = checker.numbers(value);
        let declared = checker.name(name, value.span());
        match (given, declared) {
            (Some(given), Some(declared)) => {
                all_fit &= fits(checker, name, &given, &declared, value.span());
                bound.push((name.clone(), declared.over(given.field())));
            }
            _ => all_fit = false,
        }
    }
    within(checker, bound, inner).filter(|_| all_fit)
}

/// Whether a value fits the name that is bound to it.
fn fits(
    checker: &mut TypeChecker<'_>,
    name: &Name,
    given: &Type,
    declared: &Type,
    span: Span,
) -> bool {
    if given.shape() != declared.shape() {
        let (left, right) = (declared.shape(), given.shape());
        checker.report(CheckError::Shapes {
            operator: "at",
            left,
            right,
            spans: [span, span],
        });
        return false;
    }
    if let Some((given, declared)) = disagreement(given, declared) {
        checker.report(CheckError::BoundDimension {
            name: name.clone(),
            declared,
            given,
            span,
        });
        return false;
    }
    true
}

/// Checks a formula in which names are bound.
fn within(checker: &mut TypeChecker<'_>, bound: Vec<(Name, Type)>, inner: &Expr) -> Option<Type> {
    let outside = checker.local.len();
    checker.local.extend(bound);
    let found = checker.of(inner);
    checker.local.truncate(outside);
    found
}

pub(crate) fn derivative(
    checker: &mut TypeChecker<'_>,
    inner: &Expr,
    names: &[Name],
    span: Span,
) -> Option<Type> {
    let found = checker.numbers(inner);
    let mut divisor = Some(Dimension::PURE);
    let mut is_known = true;
    for name in names {
        match checker.name(name, span) {
            Some(variable) if variable.shape() != Shape::Scalar => {
                let found = variable.form();
                let _: Option<Type> = checker.report(CheckError::NumberDue { found, span });
                is_known = false;
            }
            Some(variable) => divisor = times(divisor, variable.dimension()),
            None => is_known = false,
        }
    }
    found
        .filter(|_| is_known)
        .map(|found| scaled(&found, divisor.map(Dimension::inverse)))
}

/// A search over an interval: the types of the variable and of the body.
pub(crate) fn search(
    checker: &mut TypeChecker<'_>,
    inner: &Expr,
    name: &Name,
    ends: [&Expr; 2],
) -> Option<(Type, Type)> {
    let given = operator::same_reals(checker, Joint::Interval, &ends);
    let declared = checker
        .scope
        .name(name)
        .and_then(|declared| declared.dimension());
    let dimension = given.flatten().or(declared).unwrap_or(Dimension::PURE);
    if let Some(declared) = declared.filter(|declared| *declared != dimension) {
        let span = ends[0].span().join(ends[1].span());
        checker.report(CheckError::BoundDimension {
            name: name.clone(),
            declared,
            given: dimension,
            span,
        });
        return None;
    }
    let variable = Type::real(dimension);
    let outside = checker.local.len();
    checker.local.push((name.clone(), variable.clone()));
    let value = checker.real(inner);
    checker.local.truncate(outside);
    given?;
    Some((variable, value?))
}
