//! Quantities of a model as formulas in its names.

use super::numbers::Single;
use super::quantity::Quantity;
use super::{Lack, Model};
use crate::expr::{Constant, Equation, Expr, Function, Kind, Normal, Operator, SymbolicError};

impl Model {
    /// A quantity as a formula in the names of the model, where it has one.
    ///
    /// # Errors
    ///
    /// [`Lack::NoFormula`] where it has none, [`Lack::SeveralCoordinates`].
    pub fn formula(&self, quantity: Quantity) -> Result<Expr, Lack> {
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
            Quantity::Single(single) => Some(self.formula_of_single(single)?),
            _ => None,
        };
        formula.ok_or(Lack::NoFormula)
    }

    /// The equations that a quantity is: one, or one per coordinate, with dry friction on the right.
    ///
    /// # Errors
    ///
    /// [`Lack::NoFormula`].
    pub fn equations(&self, quantity: Quantity) -> Result<Vec<Equation>, Lack> {
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
        equations.ok_or(Lack::NoFormula)
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
    fn formula_of_single(&self, single: Single) -> Result<Expr, Lack> {
        let [mass, damping, stiffness] = self.coefficients()?;
        let two = Normal::of(&Expr::number(2))?;
        let root = |formula: &Normal| Expr::call(Function::Sqrt, [self.written(formula)]);
        let square = || stiffness.over(&mass);
        let decay = || damping.over(&two.times(&mass)?);
        let angular = |damped: i32| -> Result<Expr, SymbolicError> {
            let rate = decay()?;
            let less = rate
                .times(&rate)?
                .times(&Normal::of(&Expr::number(-damped))?)?;
            Ok(root(&square()?.plus(&less)?))
        };
        let turn = || product(Expr::number(2), Expr::constant(Constant::Pi));
        let geometric = || -> Result<Expr, SymbolicError> { Ok(root(&stiffness.times(&mass)?)) };
        Ok(match single {
            Single::Mass => self.written(&mass),
            Single::Damping => self.written(&damping),
            Single::Stiffness => self.written(&stiffness),
            Single::NaturalAngularFrequency => root(&square()?),
            Single::NaturalFrequency => ratio(root(&square()?), turn()),
            Single::Period => product(turn(), root(&mass.over(&stiffness)?)),
            Single::DecayRate => self.written(&decay()?),
            Single::DampingRatio => {
                let below = product(Expr::number(2), geometric()?);
                ratio(self.written(&damping), below)
            }
            Single::CriticalDamping => product(Expr::number(2), geometric()?),
            Single::DampedAngularFrequency => angular(1)?,
            Single::DampedPeriod => ratio(turn(), angular(1)?),
            Single::LogarithmicDecrement => {
                let above = product(turn(), self.written(&decay()?));
                ratio(above, angular(1)?)
            }
            Single::QualityFactor => ratio(geometric()?, self.written(&damping)),
            Single::ResonanceAngularFrequency => angular(2)?,
        })
    }
}

fn product(a: Expr, b: Expr) -> Expr {
    Expr::derived(Kind::Binary(Operator::Multiply, a, b))
}

fn ratio(a: Expr, b: Expr) -> Expr {
    Expr::derived(Kind::Binary(Operator::Divide, a, b))
}
