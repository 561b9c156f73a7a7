//! The types of operators.

use super::{CheckError, Joint, TypeChecker, disagreement, matrix, scaled};
use crate::expr::{AnyDimension, Expr, Field, Form, Operator, Type, fold};
use crate::unit::{self, Dimension};
use vibank_dynamics::numerics::Rational;
use vibank_source::Span;

/// Real numbers of one dimension.
pub(crate) fn same_reals(
    checker: &mut TypeChecker<'_>,
    joint: Joint,
    operands: &[&Expr],
) -> Option<AnyDimension> {
    let found: Vec<Option<Type>> = operands
        .iter()
        .map(|operand| checker.real(operand))
        .collect();
    let mut common: Option<(Dimension, Span)> = None;
    let mut agree = true;
    for (operand, found) in operands.iter().zip(&found) {
        let Some(dimension) = found.as_ref()?.dimension() else {
            continue;
        };
        match common {
            None => common = Some((dimension, operand.span())),
            Some((first, span)) if first != dimension => {
                agree = false;
                let spans = [span, operand.span()];
                checker.report(CheckError::Dimensions {
                    joint,
                    left: first,
                    right: dimension,
                    spans,
                });
            }
            Some(_) => {}
        }
    }
    agree.then(|| common.map(|(dimension, _)| dimension))
}

/// Two values of one shape and of one dimension entry by entry.
pub(crate) fn joined(
    checker: &mut TypeChecker<'_>,
    joint: Joint,
    operator: &'static str,
    operands: [&Expr; 2],
) -> Option<Type> {
    let (left, right) = (checker.of(operands[0]), checker.of(operands[1]));
    let (left, right) = (left?, right?);
    let spans = operands.map(Expr::span);
    let booleans = [&left, &right].map(|found| found.field() == Field::Boolean);
    if booleans == [true, true] && joint == Joint::Cases {
        return Some(left);
    }
    for (found, (is_boolean, span)) in [&left, &right]
        .into_iter()
        .zip(booleans.into_iter().zip(spans))
    {
        if is_boolean {
            return checker.report(CheckError::NumberDue {
                found: found.form(),
                span,
            });
        }
    }
    if left.shape() != right.shape() {
        let (left, right) = (left.shape(), right.shape());
        return checker.report(CheckError::Shapes {
            operator,
            left,
            right,
            spans,
        });
    }
    if let Some((left, right)) = disagreement(&left, &right) {
        return checker.report(CheckError::Dimensions {
            joint,
            left,
            right,
            spans,
        });
    }
    let form = Form {
        field: left.field().max(right.field()),
        shape: left.shape(),
    };
    Type::each(
        form,
        left.entries()
            .zip(right.entries())
            .map(|(a, b)| a.or(b))
            .collect(),
    )
}

pub(crate) fn arithmetic(
    checker: &mut TypeChecker<'_>,
    operator: Operator,
    a: &Expr,
    b: &Expr,
    span: Span,
) -> Option<Type> {
    match operator {
        Operator::Add => joined(checker, Joint::Sum, "+", [a, b]),
        Operator::Subtract => joined(checker, Joint::Sum, "-", [a, b]),
        Operator::Multiply => matrix::product(checker, a, b),
        Operator::Divide => {
            let (found, divisor) = (checker.numbers(a), checker.number(b));
            let (found, divisor) = (found?, divisor?);
            let field = found.field().max(divisor.field());
            Some(scaled(&found, divisor.dimension().map(Dimension::inverse)).over(field))
        }
        Operator::Power => power(checker, a, b, span),
    }
}

fn power(checker: &mut TypeChecker<'_>, base: &Expr, exponent: &Expr, span: Span) -> Option<Type> {
    let (found, power) = (checker.number(base), checker.number(exponent));
    let (found, power) = (found?, power?);
    if let Some(dimension) = power.dimension().filter(|dimension| !dimension.is_pure()) {
        return checker.report(CheckError::ExponentNotPure {
            found: dimension,
            span: exponent.span(),
        });
    }
    let form = Form::scalar(found.field().max(power.field()));
    let Some(base) = found.dimension().filter(|dimension| !dimension.is_pure()) else {
        return Some(Type::uniform(form, found.dimension()));
    };
    let Some(value) = fold(exponent) else {
        return checker.report(CheckError::ExponentNotConstant {
            base,
            span: exponent.span(),
        });
    };
    match small(value).and_then(|value| base.pow(value)) {
        Some(dimension) => Some(Type::uniform(form, dimension)),
        None => checker.report(CheckError::PowerDimension {
            base,
            exponent: value,
            span,
        }),
    }
}

/// A fraction as an exponent of units.
fn small(value: Rational) -> Option<unit::Rational> {
    unit::Rational::new(
        value.numerator().try_into().ok()?,
        value.denominator().try_into().ok()?,
    )
}
