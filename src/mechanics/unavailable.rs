//! Why a quantity of a model has no value.

use thiserror::Error;

use crate::expr::{Absence, CompileError, Name, SymbolicError, Undefined};
use crate::vibration::modes::ModesError;
use crate::vibration::{FrictionError, OscillatorError, PendulumError};

/// Why a quantity of a model does not exist, or not for these data.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Unavailable {
    /// The quantity belongs to a single degree of freedom.
    #[error("the quantity belongs to a model of one coordinate")]
    SeveralCoordinates,
    /// Time stands beside a coordinate, so there is no linearization with constant coefficients.
    #[error("the coefficients of the equations change with time")]
    TimeVarying,
    /// The quantity has no closed form in symbols.
    #[error("the quantity has no formula")]
    NoFormula,
    /// The quantity is a formula, an equation or a function of time.
    #[error("the quantity is not a number")]
    NoNumber,
    /// The quantity is no function of time.
    #[error("the quantity is not a function of time")]
    NoMotion,
    /// No equilibrium was found.
    #[error("no equilibrium was found")]
    NoEquilibrium,
    /// The stated position is none at rest for these data.
    #[error("the stated position is not an equilibrium: a force along `{coordinate}` is left")]
    NotAtRest {
        /// The coordinate along which a force is left.
        coordinate: Name,
    },
    /// No weight or pre-stretch is balanced at rest.
    #[error(
        "nothing is balanced at rest: weights and pre-stretches belong to a further model, `[models.full]`, and the balance to \
         `models.full.static`"
    )]
    NothingStatic,
    /// A model with weights and pre-stretches moves in another way than the one without.
    #[error("along `{coordinate}` it moves otherwise than `[model]`: `{difference}` is left")]
    AnotherMotion {
        /// Name of the coordinate whose equation differs.
        coordinate: Name,
        /// Its left side minus that of the model.
        difference: String,
    },
    /// The equilibrium is not stable, so that nothing vibrates about it.
    #[error("the equilibrium is not stable")]
    Unstable,
    /// The motion does not oscillate.
    #[error("the free motion does not oscillate")]
    NotOscillating,
    /// There is no damping.
    #[error("the model is undamped")]
    Undamped,
    /// There is no resonance peak.
    #[error("the damping leaves no resonance")]
    NoResonance,
    /// The forces are no sum of constants and harmonics.
    #[error("the forces are not harmonic")]
    NotHarmonic,
    /// There is no harmonic force.
    #[error("no harmonic force acts")]
    NoForce,
    /// More than one frequency excites the model, or none has an amplitude by itself.
    #[error("more than one angular frequency excites the model")]
    SeveralFrequencies,
    /// An undamped model is excited at a natural frequency.
    #[error("the model is excited at a natural frequency without damping")]
    Resonance,
    /// The damping couples the modes.
    #[error("the damping couples the modes")]
    CoupledDamping,
    /// The model is no pendulum `I θ'' + A sin θ = 0`.
    #[error("the model is not a pendulum")]
    NotPendulum,
    /// The model has no dry friction.
    #[error("the model has no dry friction")]
    NoFriction,
    /// Friction does not bring the motion to rest.
    #[error("the motion does not come to rest")]
    Endless,
    /// A force that varies in time acts on a model with dry friction.
    #[error("dry friction under a force that varies in time has no closed form")]
    Forced,
    /// The matrices are singular.
    #[error("the equations have no single solution")]
    Singular,
    /// An operation in a formula has no value.
    #[error(transparent)]
    Absent(#[from] Absence),
    /// A number that is needed has no value.
    #[error(transparent)]
    Undefined(#[from] Undefined),
    /// A formula that cannot be evaluated.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// A calculation with formulas that does not go through.
    #[error(transparent)]
    Symbolic(#[from] SymbolicError),
    /// Mass, damping and stiffness that do not make an oscillator.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// Matrices without modes.
    #[error(transparent)]
    Modes(#[from] ModesError),
    /// Dry friction without motion.
    #[error(transparent)]
    Friction(#[from] FrictionError),
    /// A pendulum without motion.
    #[error(transparent)]
    Pendulum(#[from] PendulumError),
}
