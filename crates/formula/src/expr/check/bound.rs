//! The types of operators that bind names.

use super::{CheckError, Checker, Joint, disagreement, scaled, times};
use crate::expr::{Expr, Name, Shape, Type};
use crate::unit::Dimension;
use vibank_source::Span;

impl Checker<'_> {
    pub(crate) fn at(&mut self, inner: &Expr, values: &[(Name, Expr)]) -> Option<Type> {
        let mut bound = Vec::with_capacity(values.len());
        let mut fits = true;
        for (name, value) in values {
            let given = self.numbers(value);
            let declared = self.name(name, value.span());
            match (given, declared) {
                (Some(given), Some(declared)) => {
                    fits &= self.fits(name, &given, &declared, value.span());
                    bound.push((name.clone(), declared.over(given.field())));
                }
                _ => fits = false,
            }
        }
        let found = self.within(bound, inner);
        found.filter(|_| fits)
    }

    /// Whether a value fits the name that is bound to it.
    fn fits(&mut self, name: &Name, given: &Type, declared: &Type, span: Span) -> bool {
        if given.shape() != declared.shape() {
            let (left, right) = (declared.shape(), given.shape());
            self.report(CheckError::Shapes {
                operator: "at",
                left,
                right,
                spans: [span, span],
            });
            return false;
        }
        if let Some((given, declared)) = disagreement(given, declared) {
            self.report(CheckError::BoundDimension {
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
    fn within(&mut self, bound: Vec<(Name, Type)>, inner: &Expr) -> Option<Type> {
        let outside = self.local.len();
        self.local.extend(bound);
        let found = self.of(inner);
        self.local.truncate(outside);
        found
    }

    pub(crate) fn derivative(&mut self, inner: &Expr, names: &[Name], span: Span) -> Option<Type> {
        let found = self.numbers(inner);
        let mut divisor = Some(Dimension::PURE);
        let mut is_known = true;
        for name in names {
            match self.name(name, span) {
                Some(variable) if variable.shape() != Shape::Scalar => {
                    let found = variable.form();
                    let _: Option<Type> = self.report(CheckError::NumberDue { found, span });
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
        &mut self,
        inner: &Expr,
        name: &Name,
        ends: [&Expr; 2],
    ) -> Option<(Type, Type)> {
        let given = self.same_reals(Joint::Interval, &ends);
        let declared = self
            .scope
            .name(name)
            .and_then(|declared| declared.dimension());
        let dimension = given.flatten().or(declared).unwrap_or(Dimension::PURE);
        if let Some(declared) = declared.filter(|declared| *declared != dimension) {
            let span = ends[0].span().join(ends[1].span());
            self.report(CheckError::BoundDimension {
                name: name.clone(),
                declared,
                given: dimension,
                span,
            });
            return None;
        }
        let variable = Type::real(dimension);
        let outside = self.local.len();
        self.local.push((name.clone(), variable.clone()));
        let value = self.real(inner);
        self.local.truncate(outside);
        given?;
        Some((variable, value?))
    }
}
