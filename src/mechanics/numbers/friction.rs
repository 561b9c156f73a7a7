//! Dry friction along a single coordinate.

use super::{Motion, Numbers, Unavailable, single};
use crate::expr::{Form, Name, Precise, Value};
use crate::numerics::ExactNumber;
use crate::unit::Dimension;
use crate::vibration::{DryFriction, FrictionMotion, FrictionOscillator, TurningPoint};

/// A number about the motion of a model with dry friction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Frictional {
    /// The number of slides from one turning point to the next.
    HalfCycles,
    /// Whether it slides at all.
    Slides,
    /// When it comes to rest.
    StopTime,
    /// Where it comes to rest.
    RestPosition,
    /// The length of the way.
    PathLength,
    /// The heat.
    DissipatedEnergy,
}

/// The turning points of a motion with dry friction.
#[derive(Clone, Debug, PartialEq)]
pub struct TurningPoints {
    /// The first ones, up to the rest if they are not too many.
    pub points: Vec<TurningPoint>,
    /// The number of the first: 0 if it is the start, 1 if the mass was thrown.
    pub first: usize,
    /// The largest friction at rest, in the coherent unit of force or moment.
    pub holding: f64,
    /// The coordinate that friction acts along.
    pub coordinate: Name,
    /// Of its positions: a length, or 1 for an angle.
    pub dimension: Dimension,
}

pub(crate) fn turning_points(numbers: &Numbers, most: usize) -> Result<TurningPoints, Unavailable> {
    let motion = friction_motion(numbers)?;
    let coordinate = &numbers.model.definition.coordinates[0];
    Ok(TurningPoints {
        coordinate: coordinate.name.clone(),
        dimension: coordinate.dimension,
        points: motion.turning_points().take(most).collect(),
        first: usize::from(!motion.is_released()),
        holding: friction_forces(numbers)?.numbers()[1],
    })
}

/// A number about the motion with dry friction from the initial state.
///
/// # Errors
///
/// [`Unavailable::NoFriction`], [`Unavailable::Endless`] if it never rests, and those of [`Numbers::equilibrium`].
pub(crate) fn number(numbers: &Numbers, quantity: Frictional) -> Result<Value, Unavailable> {
    let motion = friction_motion(numbers)?;
    let slides = motion.slides();
    Ok(match quantity {
        Frictional::HalfCycles => Value::real(slides.ok_or(Unavailable::Endless)? as f64, 0.0),
        Frictional::Slides => {
            let slides = f64::from(u8::from(slides != Some(0)));
            Value::new(Form::BOOLEAN, vec![slides], vec![0.0]).ok_or(Unavailable::Endless)?
        }
        Frictional::StopTime => finite(numbers, motion.stop_time())?,
        Frictional::RestPosition => {
            finite(numbers, motion.rest_position().ok_or(Unavailable::Endless)?)?
        }
        Frictional::PathLength => finite(numbers, motion.path_length())?,
        Frictional::DissipatedEnergy => finite(numbers, motion.dissipated_energy())?,
    })
}

/// The motion with dry friction.
pub(crate) fn motion(numbers: &Numbers) -> Result<Motion, Unavailable> {
    let path = Box::new(friction_motion(numbers)?.path());
    let matrices = numbers.matrices()?;
    let [mass, damping, stiffness] =
        [&matrices.mass, &matrices.damping, &matrices.stiffness].map(|own| own.numbers()[0]);
    Ok(Motion::of_friction(
        path,
        SlidingForces {
            mass,
            damping,
            stiffness,
            friction: friction_forces(numbers)?.numbers()[0],
            constant: constant_force(numbers)?,
        },
    ))
}

fn friction_motion(numbers: &Numbers) -> Result<FrictionMotion, Unavailable> {
    if !numbers.excitation()?.is_empty() {
        return Err(Unavailable::Forced);
    }
    let forces = friction_forces(numbers)?;
    let matrices = numbers.matrices()?;
    let on_paper = |number: f64| ExactNumber::on_paper(number).ok_or(Unavailable::Endless);
    let friction = DryFriction::of_forces(
        on_paper(forces.numbers()[0])?,
        on_paper(forces.numbers()[1])?,
    );
    let oscillator = FrictionOscillator::new(
        on_paper(matrices.mass.numbers()[0])?,
        on_paper(matrices.damping.numbers()[0])?,
        on_paper(matrices.stiffness.numbers()[0])?,
        friction,
    )?;
    let oscillator = oscillator.with_force(on_paper(constant_force(numbers)?)?)?;
    let start = numbers.start()?[0];
    Ok(oscillator.motion(on_paper(start.position)?, on_paper(start.velocity)?)?)
}

/// Kinetic and largest static friction.
fn friction_forces(numbers: &Numbers) -> Result<Value, Unavailable> {
    let forces = numbers
        .model
        .evaluation
        .sticking
        .as_ref()
        .ok_or(Unavailable::NoFriction)?;
    numbers.value(forces, &[])
}

/// The force on the coordinate at its origin.
fn constant_force(numbers: &Numbers) -> Result<f64, Unavailable> {
    let origin = [Precise::exact(0.0)];
    Ok(-numbers
        .value(&numbers.model.evaluation.restoring, &origin)?
        .numbers()[0])
}

fn finite(numbers: &Numbers, number: f64) -> Result<Value, Unavailable> {
    if number.is_finite() {
        Ok(single::with_relative_bound(numbers, number))
    } else {
        Err(Unavailable::Endless)
    }
}

/// What acts on a sliding mass.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlidingForces {
    mass: f64,
    damping: f64,
    stiffness: f64,
    friction: f64,
    constant: f64,
}

impl SlidingForces {
    /// The acceleration in a state; none at rest.
    pub(crate) fn acceleration(&self, state: crate::vibration::State) -> f64 {
        if state.velocity == 0.0 {
            return 0.0;
        }
        let resisting = self.damping * state.velocity
            + self.stiffness * state.position
            + self.friction * state.velocity.signum();
        (self.constant - resisting) / self.mass
    }
}
