//! A model with numbers: each quantity computed when it is asked for, and once.

mod driving;
mod equilibrium;
mod friction;
mod general;
mod hyper_dual;
mod matrices;
mod modal;
mod motion;
mod pendulum;
mod single;
mod steady;

use std::cell::OnceCell;
use std::sync::Arc;

use super::programs::{Compiled, ModelData};
use super::{Model, Unavailable};
use crate::expr::{Name, Precise, Undefined, Value};
use crate::vibration::Oscillator;
use crate::vibration::modes::Modes;
use driving::Drive;
pub use friction::{Frictional, TurningPoints};
pub use hyper_dual::Linearization;
use matrices::Matrices;
use modal::Response;
pub use motion::Motion;
pub use single::Sdof;

/// A model with numbers for its names.
///
/// ```
/// use std::sync::Arc;
/// use vibank::expr::{Expr, Precise};
/// use vibank::mechanics::{Coordinate, Definition, Model, Numbers};
/// let model = Model::derive(Definition {
///     coordinates: vec![Coordinate::length("x")],
///     kinetic: Expr::read("1/2*m*x'^2")?,
///     potential: Expr::read("1/2*k*x^2 - m*g*x")?,
///     ..Definition::default()
/// })
/// .unwrap();
/// let numbers = Numbers::of(Arc::new(model), |name| match name.as_str() {
///     "m" => Ok(Precise::exact(2.0)),
///     "k" => Ok(Precise::exact(50.0)),
///     _ => Ok(Precise::exact(10.0)),
/// });
/// assert_eq!(numbers.oscillator()?.natural_angular_frequency(), 5.0);
/// assert_eq!(numbers.equilibrium()?, [0.4]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Numbers {
    model: Arc<Model>,
    constants: Vec<Result<Precise, Undefined>>,
    position: OnceCell<Result<Vec<f64>, Unavailable>>,
    matrices: OnceCell<Result<Matrices, Unavailable>>,
    modes: OnceCell<Result<Modes, Unavailable>>,
    drives: OnceCell<Result<Vec<Drive>, Unavailable>>,
    response: OnceCell<Result<Arc<Response>, Unavailable>>,
}

impl Numbers {
    /// The model with a number for each of its names; a name may have none.
    pub fn of(
        model: Arc<Model>,
        mut value: impl FnMut(&Name) -> Result<Precise, Undefined>,
    ) -> Self {
        Self {
            constants: model.names().iter().map(&mut value).collect(),
            model,
            position: OnceCell::new(),
            matrices: OnceCell::new(),
            modes: OnceCell::new(),
            drives: OnceCell::new(),
            response: OnceCell::new(),
        }
    }

    /// The model whose matrices these are.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The oscillator about the equilibrium.
    ///
    /// # Errors
    ///
    /// [`Unavailable::SeveralCoordinates`], [`Unavailable::Unstable`], and those of [`Self::equilibrium`].
    pub fn oscillator(&self) -> Result<Oscillator, Unavailable> {
        if self.model.degrees_of_freedom() != 1 {
            return Err(Unavailable::SeveralCoordinates);
        }
        let matrices = self.matrices()?;
        let only = |value: &Value| value.numbers()[0];
        if only(&matrices.stiffness) <= 0.0 {
            return Err(Unavailable::Unstable);
        }
        Ok(Oscillator::new(
            only(&matrices.mass),
            only(&matrices.damping),
            only(&matrices.stiffness),
        )?)
    }

    /// A formula at a position.
    fn value(&self, formula: &Compiled, position: &[Precise]) -> Result<Value, Unavailable> {
        let data = ModelData {
            constants: &self.constants,
            position,
        };
        formula.value(&self.model.evaluation.slots, &data)
    }

    /// A formula at the equilibrium, which is not looked for where the formula does not depend on it.
    fn value_at_rest(&self, formula: &Compiled) -> Result<Value, Unavailable> {
        let ready = formula.ready(&self.model.evaluation.slots)?;
        if ready.is_constant(self.constants.len()) {
            return self.value(formula, &[]);
        }
        let position = self.equilibrium()?.iter().copied();
        let position: Vec<_> = position.map(Precise::exact).collect();
        self.value(formula, &position)
    }
}
