//! The types of functions.

use super::{CheckError, Joint, TypeChecker, matrix, operator, scaled};
use crate::expr::{Expr, Field, Form, Function, Shape, Type};
use crate::unit::Dimension;
use vibank_dynamics::numerics::Rational;
use vibank_source::Span;

pub(crate) fn call(
    checker: &mut TypeChecker<'_>,
    function: Function,
    arguments: &[Expr],
    span: Span,
) -> Option<Type> {
    let pure = Dimension::PURE;
    match (function, arguments) {
        (Function::Sqrt, [x]) => square_root(checker, x, span),
        (Function::Abs, [x]) => checker.number(x).map(|found| found.over(Field::Real)),
        (Function::Re | Function::Im, [x]) => {
            checker.numbers(x).map(|found| found.over(Field::Real))
        }
        (Function::Conj, [x]) => checker.numbers(x),
        (Function::Arg, [x]) => checker.number(x).map(|_| Type::real(pure)),
        (Function::Sign, [x]) => checker.real(x).map(|_| Type::real(pure)),
        (Function::Atan2, [y, x]) => alike(checker, function, &[y, x]).map(|_| Type::real(pure)),
        (Function::Hypot | Function::Min | Function::Max | Function::Clamp | Function::Mod, _) => {
            alike(checker, function, &arguments.iter().collect::<Vec<_>>())
        }
        (Function::Transpose, [matrix]) => matrix::transpose(checker, matrix),
        (Function::Det, [matrix]) => matrix::determinant(checker, matrix),
        (Function::Norm, [vector]) => norm(checker, vector),
        (Function::Dot, [u, v]) => dot(checker, u, v),
        (_, [x]) => of_pure(checker, function, x),
        _ => None,
    }
}

/// Real numbers of one dimension, which is that of the result.
fn alike(checker: &mut TypeChecker<'_>, function: Function, arguments: &[&Expr]) -> Option<Type> {
    operator::same_reals(checker, Joint::Arguments(function.name()), arguments).map(Type::real)
}

fn square_root(checker: &mut TypeChecker<'_>, x: &Expr, span: Span) -> Option<Type> {
    let found = checker.number(x)?;
    let Some(base) = found.dimension() else {
        return Some(found);
    };
    if let Some(root) = base.sqrt() {
        return Some(Type::uniform(found.form(), root));
    }
    let exponent = Rational::new(1, 2)?;
    checker.report(CheckError::PowerDimension {
        base,
        exponent,
        span,
    })
}

/// A function of a pure number, complex if the number is and the function can be.
fn of_pure(checker: &mut TypeChecker<'_>, function: Function, x: &Expr) -> Option<Type> {
    let found = if function.is_real_only() {
        checker.real(x)
    } else {
        checker.number(x)
    }?;
    if let Some(dimension) = found.dimension().filter(|dimension| !dimension.is_pure()) {
        let span = x.span();
        return checker.report(CheckError::NotPure {
            function: function.name(),
            found: dimension,
            span,
        });
    }
    Some(Type::uniform(found.form(), Dimension::PURE))
}

fn norm(checker: &mut TypeChecker<'_>, vector: &Expr) -> Option<Type> {
    let squares = vector_due(checker, "norm", vector)?
        .entries()
        .map(|entry| scaled(&Type::real(entry), entry).dimension())
        .collect::<Vec<_>>();
    let square = matrix::sum(checker, Joint::Terms("norm"), squares, vector.span())?;
    Some(Type::real(square.and_then(Dimension::sqrt)))
}

fn dot(checker: &mut TypeChecker<'_>, u: &Expr, v: &Expr) -> Option<Type> {
    let (left, right) = (vector_due(checker, "dot", u), vector_due(checker, "dot", v));
    let (left, right) = (left?, right?);
    if left.shape() != right.shape() {
        let spans = [u.span(), v.span()];
        let (left, right) = (left.shape(), right.shape());
        return checker.report(CheckError::Shapes {
            operator: "dot",
            left,
            right,
            spans,
        });
    }
    let products = left
        .entries()
        .zip(right.entries())
        .map(|(a, b)| super::times(a, b))
        .collect();
    let dimension = matrix::sum(
        checker,
        Joint::Terms("dot"),
        products,
        u.span().join(v.span()),
    )?;
    Some(Type::uniform(
        Form::scalar(left.field().max(right.field())),
        dimension,
    ))
}

fn vector_due(checker: &mut TypeChecker<'_>, function: &'static str, expr: &Expr) -> Option<Type> {
    let found = checker.numbers(expr)?;
    if let Shape::Vector(_) = found.shape() {
        return Some(found);
    }
    let (found, span) = (found.form(), expr.span());
    checker.report(CheckError::ShapeDue {
        function,
        due: "vectors",
        found,
        span,
    })
}
