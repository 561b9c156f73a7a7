//! Quantities of a model as formulas in its names.

use super::numbers::Sdof;
use super::quantity::Quantity;
use super::{Model, Unavailable, characteristic};
use crate::expr::{Equation, Expr, Kind, Normal, Operator, Substitution};

pub(crate) fn formula(model: &Model, quantity: Quantity) -> Result<Expr, Unavailable> {
    let formula = match quantity {
        Quantity::Kinetic => Some(model.kinetic()),
        Quantity::Potential => Some(model.potential()),
        Quantity::Dissipation => Some(model.dissipation()),
        Quantity::MassMatrix => model.mass_matrix(),
        Quantity::DampingMatrix => model.damping_matrix(),
        Quantity::StiffnessMatrix => model.stiffness_matrix(),
        Quantity::Equilibrium(at) | Quantity::StaticDeflection(at) => {
            model.equilibrium().and_then(|all| all.get(at).cloned())
        }
        Quantity::Sdof(single) => Some(formula_of_single(model, single)?),
        _ => None,
    };
    formula.ok_or(Unavailable::NoFormula)
}

pub(crate) fn equations(model: &Model, quantity: Quantity) -> Result<Vec<Equation>, Unavailable> {
    let equations = match quantity {
        Quantity::Equation(at) => model
            .equation(at)
            .map(|own| vec![with_friction(model, at, own)]),
        Quantity::FullEquation(at) => model
            .full_equation(at)
            .map(|own| vec![with_friction(model, at, own)]),
        Quantity::CharacteristicEquation => characteristic::equation(model).map(|own| vec![own]),
        Quantity::Equations => (0..model.degrees_of_freedom())
            .map(|at| Some(with_friction(model, at, model.equation(at)?)))
            .collect(),
        _ => None,
    };
    equations.ok_or(Unavailable::NoFormula)
}

/// An equation along a coordinate with the force of dry friction against the velocity, −F sign(q').
fn with_friction(model: &Model, coordinate: usize, equation: Equation) -> Equation {
    let name = &model.coordinates()[coordinate];
    let Some((friction, direction)) = model.definition.friction_along(name) else {
        return equation;
    };
    Equation {
        left: equation.left,
        right: equation.right - product(friction.kinetic.clone(), direction),
    }
}

/// A number of one degree of freedom in terms of m, c and k.
fn formula_of_single(model: &Model, single: Sdof) -> Result<Expr, Unavailable> {
    let [mass, damping, stiffness] = model.coefficients()?;
    let put = Substitution::new()
        .with("m", model.written(&mass))
        .with("c", model.written(&damping))
        .with("k", model.written(&stiffness));
    let definition = Expr::read(single.definition()).map_err(|_| Unavailable::NoFormula)?;
    in_normal_form(model, &definition, &put)
}

/// A definition with the coefficients substituted; what has no root and no number like π is written in normal form.
fn in_normal_form(
    model: &Model,
    definition: &Expr,
    put: &Substitution,
) -> Result<Expr, Unavailable> {
    let mut is_rational = !definition.names().free.is_empty();
    definition.walk(&mut |node| {
        is_rational &= !matches!(node.kind(), Kind::Call(..) | Kind::Constant(_));
    });
    if is_rational {
        return Ok(model.written(&Normal::of(&put.apply(definition)?)?));
    }
    definition.try_map_children(&mut |child| in_normal_form(model, child, put))
}

fn product(a: Expr, b: Expr) -> Expr {
    Expr::derived(Kind::Binary(Operator::Multiply, a, b))
}
