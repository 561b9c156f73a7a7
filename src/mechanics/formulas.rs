//! Quantities of a model as formulas in its names.

use super::numbers::Sdof;
use super::quantity::Quantity;
use super::{Model, Unavailable};
use crate::expr::{Equation, Expr, Function, Kind, Normal, Operator, Substitution};

impl Model {
    /// A quantity as a formula in the names of the model, where it has one.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoFormula`] where it has none, [`Unavailable::SeveralCoordinates`].
    pub fn formula(&self, quantity: Quantity) -> Result<Expr, Unavailable> {
        let formula = match quantity {
            Quantity::Kinetic => Some(self.kinetic()),
            Quantity::Potential => Some(self.potential()),
            Quantity::Dissipation => Some(self.dissipation()),
            Quantity::MassMatrix => self.mass_matrix(),
            Quantity::DampingMatrix => self.damping_matrix(),
            Quantity::StiffnessMatrix => self.stiffness_matrix(),
            Quantity::Equilibrium(at) | Quantity::StaticDeflection(at) => {
                self.equilibrium().and_then(|all| all.get(at).cloned())
            }
            Quantity::Sdof(single) => Some(self.formula_of_single(single)?),
            _ => None,
        };
        formula.ok_or(Unavailable::NoFormula)
    }

    /// The equations that a quantity is: one, or one per coordinate, with dry friction on the right.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoFormula`].
    pub fn equations(&self, quantity: Quantity) -> Result<Vec<Equation>, Unavailable> {
        let equations = match quantity {
            Quantity::Equation(at) => self
                .equation(at)
                .map(|own| vec![self.with_friction(at, own)]),
            Quantity::FullEquation(at) => self
                .full_equation(at)
                .map(|own| vec![self.with_friction(at, own)]),
            Quantity::CharacteristicEquation => self.characteristic_equation().map(|own| vec![own]),
            Quantity::Equations => (0..self.degrees_of_freedom())
                .map(|at| Some(self.with_friction(at, self.equation(at)?)))
                .collect(),
            _ => None,
        };
        equations.ok_or(Unavailable::NoFormula)
    }

    /// An equation along a coordinate with the force of dry friction against the velocity, −F sign(q').
    fn with_friction(&self, coordinate: usize, equation: Equation) -> Equation {
        let name = &self.coordinates()[coordinate];
        let own = self.definition.friction.iter().find(|(own, _)| own == name);
        let Some((_, friction)) = own else {
            return equation;
        };
        let velocity = Expr::name(name.clone()).prime(1);
        let direction = Expr::call(Function::Sign, [velocity]);
        Equation {
            left: equation.left,
            right: equation.right - product(friction.kinetic.clone(), direction),
        }
    }

    /// A number of one degree of freedom in terms of m, c and k.
    fn formula_of_single(&self, single: Sdof) -> Result<Expr, Unavailable> {
        let [mass, damping, stiffness] = self.coefficients()?;
        let expr = |coefficient: &Normal| self.written(coefficient);
        let put = Substitution::new()
            .with("m", expr(&mass))
            .with("c", expr(&damping))
            .with("k", expr(&stiffness));
        let definition = Expr::read(single.definition()).map_err(|_| Unavailable::NoFormula)?;
        self.in_normal_form(&definition, &put)
    }

    /// A definition with the coefficients substituted; what has no root and no number like π is written in normal form.
    fn in_normal_form(&self, definition: &Expr, put: &Substitution) -> Result<Expr, Unavailable> {
        let mut is_rational = !definition.names().free.is_empty();
        definition.walk(&mut |node| {
            is_rational &= !matches!(node.kind(), Kind::Call(..) | Kind::Constant(_));
        });
        if is_rational {
            return Ok(self.written(&Normal::of(&put.apply(definition)?)?));
        }
        definition.try_map_children(&mut |child| self.in_normal_form(child, put))
    }
}

fn product(a: Expr, b: Expr) -> Expr {
    Expr::derived(Kind::Binary(Operator::Multiply, a, b))
}
