//! A model with numbers: each quantity computed when it is asked for, and once.

mod equilibrium;
mod excitation;
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
use super::{Model, Quantity, Unavailable};
use crate::expr::{Expr, Name, Precise, Undefined, Value};
use crate::vibration::modes::Modes;
use crate::vibration::{Oscillator, State};
use excitation::HarmonicLoad;
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
    excitation: OnceCell<Result<Vec<HarmonicLoad>, Unavailable>>,
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
            excitation: OnceCell::new(),
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
        if matrices.stiffness.numbers()[0] <= 0.0 {
            return Err(Unavailable::Unstable);
        }
        Ok(Oscillator::new(
            matrices.mass.numbers()[0],
            matrices.damping.numbers()[0],
            matrices.stiffness.numbers()[0],
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

    /// The forces, one entry per angular frequency.
    pub(crate) fn excitation(&self) -> Result<&[HarmonicLoad], Unavailable> {
        let excitation = self.excitation.get_or_init(|| excitation::all(self));
        excitation.as_deref().map_err(Clone::clone)
    }

    /// The angular frequencies of the excitation, in rad/s, those of constant forces left out.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NotHarmonic`], or a number that is missing.
    pub(crate) fn excitation_frequencies(&self) -> Result<Vec<f64>, Unavailable> {
        let frequencies = self.excitation()?.iter().map(|harmonic| harmonic.frequency);
        Ok(frequencies.filter(|frequency| *frequency > 0.0).collect())
    }

    /// The equilibrium about which the model is linearized.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoEquilibrium`], [`Unavailable::NotAtRest`] for a stated position that is none, or a number that
    /// is missing.
    pub fn equilibrium(&self) -> Result<&[f64], Unavailable> {
        let position = self.position.get_or_init(|| equilibrium::position(self));
        position.as_deref().map_err(Clone::clone)
    }

    /// The mass matrix, by rows.
    ///
    /// # Errors
    ///
    /// [`Unavailable::TimeVarying`], [`Unavailable::NoEquilibrium`], or a number that is missing.
    pub fn mass_matrix(&self) -> Result<&Value, Unavailable> {
        Ok(&self.matrices()?.mass)
    }

    /// The damping matrix, by rows.
    ///
    /// # Errors
    ///
    /// As for [`Self::mass_matrix`].
    pub fn damping_matrix(&self) -> Result<&Value, Unavailable> {
        Ok(&self.matrices()?.damping)
    }

    /// The stiffness matrix, by rows.
    ///
    /// # Errors
    ///
    /// As for [`Self::mass_matrix`].
    pub fn stiffness_matrix(&self) -> Result<&Value, Unavailable> {
        Ok(&self.matrices()?.stiffness)
    }

    /// The modes of the undamped model. Where the potential energy is written as a sum of squares, the
    /// solver gets those.
    ///
    /// # Errors
    ///
    /// As for [`Self::mass_matrix`], and [`Unavailable::Modes`].
    pub fn modes(&self) -> Result<&Modes, Unavailable> {
        let modes = self
            .modes
            .get_or_init(|| Ok(Modes::of(matrices::system(self)?)?));
        modes.as_ref().map_err(Clone::clone)
    }

    pub(crate) fn matrices(&self) -> Result<&Matrices, Unavailable> {
        let matrices = self.matrices.get_or_init(|| matrices::evaluated(self));
        matrices.as_ref().map_err(Clone::clone)
    }

    /// The initial state.
    pub(crate) fn start(&self) -> Result<Vec<State>, Unavailable> {
        let value = self.value(&self.model.evaluation.start, &[])?;
        let states = value.numbers().chunks_exact(2);
        Ok(states
            .map(|own| State {
                position: own[0],
                velocity: own[1],
            })
            .collect())
    }

    /// The turning points of the motion from the initial state, `most` of them at most.
    ///
    /// # Errors
    ///
    /// Those of a [`Frictional`] quantity.
    pub fn turning_points(&self, most: usize) -> Result<TurningPoints, Unavailable> {
        friction::turning_points(self, most)
    }

    /// Each coordinate as a formula in `t` with the free constants `A` and `B` (`A1`, `B1`, … of several
    /// modes): the equilibrium, the steady state and the free motion. Numbers are in SI units, to six
    /// significant digits.
    ///
    /// # Errors
    ///
    /// [`Unavailable::Unstable`], [`Unavailable::CoupledDamping`], [`Unavailable::NotHarmonic`], [`Unavailable::Resonance`].
    pub fn general_motion(&self) -> Result<Vec<Expr>, Unavailable> {
        general::motion(self)
    }

    /// The matrices about the equilibrium, by exact second derivatives of the energies as they are
    /// written, at time zero.
    ///
    /// ```text
    /// M_ij = ∂²T/∂q'_i ∂q'_j
    /// C_ij = ∂²D/∂q'_i ∂q'_j + ∂²T/∂q'_i ∂q_j − ∂²T/∂q_i ∂q'_j − ∂Q_i/∂q'_j
    /// K_ij = ∂²V/∂q_i ∂q_j − ∂²T/∂q_i ∂q_j − ∂Q_i/∂q_j
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`Self::equilibrium`], or an operation without value.
    pub fn linearization(&self) -> Result<Linearization, Unavailable> {
        hyper_dual::linearization(self)
    }

    /// The value of a quantity that is a number, or several.
    ///
    /// # Errors
    ///
    /// Why it has none; [`Unavailable::NoNumber`] for formulas, equations and functions of time.
    pub fn value_of(&self, quantity: Quantity) -> Result<Value, Unavailable> {
        Ok(match quantity {
            Quantity::MassMatrix => self.mass_matrix()?.clone(),
            Quantity::DampingMatrix => self.damping_matrix()?.clone(),
            Quantity::StiffnessMatrix => self.stiffness_matrix()?.clone(),
            Quantity::Equilibrium(at) | Quantity::StaticDeflection(at) => {
                equilibrium::of_coordinate(self, at)?
            }
            Quantity::Equilibria => equilibrium::all_values(self)?,
            Quantity::Stable => equilibrium::stability(self)?,
            Quantity::Sdof(single) => single::number(self, single)?,
            Quantity::NaturalAngularFrequencies => modal::natural_angular_frequencies(self)?,
            Quantity::Multiplicities => modal::multiplicities(self)?,
            Quantity::ModeShapes => modal::mode_shapes(self)?,
            Quantity::ModalMasses => modal::masses(self)?,
            Quantity::ModalDampingRatios => modal::damping_ratios(self)?,
            Quantity::ModalAmplitudes => modal::amplitudes(self)?,
            Quantity::ComplexAmplitude(at) => steady::complex_amplitude_value(self, at)?,
            Quantity::ExactPeriod => pendulum::period(self)?,
            Quantity::Frictional(frictional) => friction::number(self, frictional)?,
            _ => return Err(Unavailable::NoNumber),
        })
    }

    /// The motion that a quantity is.
    ///
    /// # Errors
    ///
    /// Why there is none; [`Unavailable::NoMotion`] for what is not a function of time.
    pub fn motion_of(&self, quantity: Quantity) -> Result<Motion, Unavailable> {
        match quantity {
            Quantity::Motion(at) => Motion::of_coordinate(self, at),
            Quantity::SteadyMotion(at) => Motion::steady(self, at),
            Quantity::Energy => Motion::energy(self),
            Quantity::ExactMotion => pendulum::motion(self),
            _ => Err(Unavailable::NoMotion),
        }
    }
}
