//! The types of functions.

use super::{CheckError, Checker, Joint, scaled};
use crate::expr::{Expr, Field, Form, Function, Shape, Type};
use crate::unit::Dimension;
use vibank_dynamics::numerics::Rational;
use vibank_source::Span;

impl Checker<'_> {
    pub(crate) fn call(
        &mut self,
        function: Function,
        arguments: &[Expr],
        span: Span,
    ) -> Option<Type> {
        let pure = Dimension::PURE;
        match (function, arguments) {
            (Function::Sqrt, [x]) => self.square_root(x, span),
            (Function::Abs, [x]) => self.number(x).map(|found| found.over(Field::Real)),
            (Function::Re | Function::Im, [x]) => {
                self.numbers(x).map(|found| found.over(Field::Real))
            }
            (Function::Conj, [x]) => self.numbers(x),
            (Function::Arg, [x]) => self.number(x).map(|_| Type::real(pure)),
            (Function::Sign, [x]) => self.real(x).map(|_| Type::real(pure)),
            (Function::Atan2, [y, x]) => self.alike(function, &[y, x]).map(|_| Type::real(pure)),
            (
                Function::Hypot | Function::Min | Function::Max | Function::Clamp | Function::Mod,
                _,
            ) => self.alike(function, &arguments.iter().collect::<Vec<_>>()),
            (Function::Transpose, [matrix]) => self.transpose(matrix),
            (Function::Det, [matrix]) => self.determinant(matrix),
            (Function::Norm, [vector]) => self.norm(vector),
            (Function::Dot, [u, v]) => self.dot(u, v),
            (_, [x]) => self.of_pure(function, x),
            _ => None,
        }
    }

    /// Real numbers of one dimension, which is that of the result.
    fn alike(&mut self, function: Function, arguments: &[&Expr]) -> Option<Type> {
        self.same_reals(Joint::Arguments(function.name()), arguments)
            .map(Type::real)
    }

    fn square_root(&mut self, x: &Expr, span: Span) -> Option<Type> {
        let found = self.number(x)?;
        let Some(base) = found.dimension() else {
            return Some(found);
        };
        if let Some(root) = base.sqrt() {
            return Some(Type::uniform(found.form(), root));
        }
        let exponent = Rational::new(1, 2)?;
        self.report(CheckError::PowerDimension {
            base,
            exponent,
            span,
        })
    }

    /// A function of a pure number, complex if the number is and the function can be.
    fn of_pure(&mut self, function: Function, x: &Expr) -> Option<Type> {
        let found = if function.is_real_only() {
            self.real(x)
        } else {
            self.number(x)
        }?;
        if let Some(dimension) = found.dimension().filter(|dimension| !dimension.is_pure()) {
            let span = x.span();
            return self.report(CheckError::NotPure {
                function: function.name(),
                found: dimension,
                span,
            });
        }
        Some(Type::uniform(found.form(), Dimension::PURE))
    }

    fn norm(&mut self, vector: &Expr) -> Option<Type> {
        let found = self.vector("norm", vector)?;
        let squares = found
            .entries()
            .map(|entry| scaled(&Type::real(entry), entry).dimension())
            .collect::<Vec<_>>();
        let square = self.sum(Joint::Terms("norm"), squares, vector.span())?;
        Some(Type::real(square.and_then(Dimension::sqrt)))
    }

    fn dot(&mut self, u: &Expr, v: &Expr) -> Option<Type> {
        let (left, right) = (self.vector("dot", u), self.vector("dot", v));
        let (left, right) = (left?, right?);
        if left.shape() != right.shape() {
            let spans = [u.span(), v.span()];
            let (left, right) = (left.shape(), right.shape());
            return self.report(CheckError::Shapes {
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
        let dimension = self.sum(Joint::Terms("dot"), products, u.span().join(v.span()))?;
        Some(Type::uniform(
            Form::scalar(left.field().max(right.field())),
            dimension,
        ))
    }

    fn vector(&mut self, function: &'static str, expr: &Expr) -> Option<Type> {
        let found = self.numbers(expr)?;
        if let Shape::Vector(_) = found.shape() {
            return Some(found);
        }
        let (found, span) = (found.form(), expr.span());
        self.report(CheckError::ShapeDue {
            function,
            due: "vectors",
            found,
            span,
        })
    }
}
