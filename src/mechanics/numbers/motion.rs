//! Motions: prepared once, then sampled at any time.

use super::friction::SlidingForces;
use super::modal::ModalMotion;
use super::{Numbers, Unavailable, friction, modal, steady};
use crate::expr::Undefined;
use crate::numerics::{Complex, sin_cos};
use crate::vibration::{
    ForcedResponse, FrictionPath, HarmonicForce, Oscillator, PendulumMotion, State,
};

/// A function of time of a model: a coordinate, or the energy.
#[derive(Clone, Debug)]
pub struct Motion(MotionKind);

#[derive(Clone, Debug)]
enum MotionKind {
    Oscillator(Box<OscillatorMotion>),
    Modal(ModalMotion),
    Friction(Box<FrictionPath>, SlidingForces),
    Pendulum(Box<PendulumMotion>, f64),
    Steady(SteadyMotion),
    Energy(EnergyOf),
}

/// Superposed responses of an oscillator about a position.
#[derive(Clone, Debug)]
struct OscillatorMotion {
    offset: f64,
    oscillator: Oscillator,
    responses: Vec<(HarmonicForce, ForcedResponse)>,
}

/// Harmonics about a position.
#[derive(Clone, Debug)]
struct SteadyMotion {
    offset: f64,
    /// Angular frequency and complex amplitude.
    harmonics: Vec<(f64, Complex)>,
}

/// The kinetic energy and the potential energy above that at rest, of several coordinates.
#[derive(Clone, Debug)]
struct EnergyOf {
    motions: Vec<Motion>,
    rest: Vec<f64>,
    mass: Vec<f64>,
    stiffness: Vec<f64>,
}

impl Motion {
    pub(crate) fn of_modes(motion: ModalMotion) -> Self {
        Self(MotionKind::Modal(motion))
    }

    pub(crate) fn of_friction(path: Box<FrictionPath>, forces: SlidingForces) -> Self {
        Self(MotionKind::Friction(path, forces))
    }

    pub(crate) fn of_pendulum(motion: Box<PendulumMotion>, square_rate: f64) -> Self {
        Self(MotionKind::Pendulum(motion, square_rate))
    }

    /// The value at a time in s, or a time derivative of it: order 1 for the velocity, 2 for the acceleration.
    ///
    /// # Errors
    ///
    /// [`Undefined::NoConvergence`] for a derivative that is not known (an order above 2; of an energy above 0),
    /// [`Undefined::Overflow`] for a value that is not finite.
    pub fn at(&self, order: u8, time: f64) -> Result<f64, Undefined> {
        let value = match &self.0 {
            MotionKind::Oscillator(motion) => motion.at(order, time),
            MotionKind::Modal(motion) => motion.at(order, time),
            MotionKind::Friction(path, forces) => friction_at(path, forces, order, time),
            MotionKind::Pendulum(motion, square_rate) => {
                pendulum_at(motion, *square_rate, order, time)
            }
            MotionKind::Steady(motion) => Some(motion.at(order, time)),
            MotionKind::Energy(energy) if order == 0 => Some(energy.at(time)?),
            MotionKind::Energy(_) => None,
        };
        let value = value.ok_or(Undefined::NoConvergence)?;
        Some(value)
            .filter(|value| value.is_finite())
            .ok_or(Undefined::Overflow)
    }

    /// Position and velocity at a time.
    fn state(&self, time: f64) -> Result<State, Undefined> {
        Ok(State {
            position: self.at(0, time)?,
            velocity: self.at(1, time)?,
        })
    }

    /// The motion of a coordinate from the initial state: of the linearized equations, with dry friction
    /// where the model has it.
    ///
    /// # Errors
    ///
    /// [`Unavailable::Unstable`], [`Unavailable::NotHarmonic`], [`Unavailable::CoupledDamping`], and those of
    /// [`Numbers::equilibrium`].
    pub(crate) fn of_coordinate(numbers: &Numbers, coordinate: usize) -> Result<Self, Unavailable> {
        if numbers.model.degrees_of_freedom() > 1 {
            return modal::motion(numbers, coordinate);
        }
        if numbers.model.evaluation.sticking.is_some() {
            return friction::motion(numbers);
        }
        let oscillator = numbers.oscillator()?;
        let forces = numbers.excitation()?.iter().map(|harmonic| HarmonicForce {
            cosine: harmonic.cosine[0],
            sine: harmonic.sine[0],
            angular_frequency: harmonic.frequency,
        });
        let offset = numbers.equilibrium()?[0];
        let start = numbers.start()?[0];
        let initial = State {
            position: start.position - offset,
            ..start
        };
        let forces: Vec<_> = forces.collect();
        let motion = OscillatorMotion::of(oscillator, offset, initial, &forces);
        Ok(Self(MotionKind::Oscillator(Box::new(motion))))
    }

    /// The motion of a coordinate that is left when all that decays has decayed.
    ///
    /// # Errors
    ///
    /// [`Unavailable::NoForce`], [`Unavailable::NotHarmonic`], [`Unavailable::Resonance`], and those of [`Numbers::equilibrium`].
    pub(crate) fn steady(numbers: &Numbers, coordinate: usize) -> Result<Self, Unavailable> {
        let excitation = numbers.excitation()?;
        if excitation.is_empty() {
            return Err(Unavailable::NoForce);
        }
        let harmonics = excitation
            .iter()
            .map(|harmonic| Ok((harmonic, steady::amplitudes(numbers, harmonic)?[coordinate])))
            .collect::<Result<Vec<_>, Unavailable>>()?;
        let harmonics = harmonics
            .into_iter()
            .map(|(harmonic, own)| (harmonic.frequency, own));
        Ok(Self(MotionKind::Steady(SteadyMotion {
            offset: numbers.equilibrium()?[coordinate],
            harmonics: harmonics.collect(),
        })))
    }

    /// The motion of a coordinate in one mode, numbered from 0, without damping, in the mass-normalized scale.
    ///
    /// # Errors
    ///
    /// [`Unavailable::Unstable`] where the mode is no vibration, and those of [`Numbers::modes`].
    pub(crate) fn of_mode(
        numbers: &Numbers,
        mode: usize,
        coordinate: usize,
    ) -> Result<Self, Unavailable> {
        let modes = numbers.modes()?;
        let frequency = modes.natural_angular_frequency(mode);
        let frequency = frequency.ok_or(Unavailable::Unstable)?;
        let amplitude = Complex::new(modes.mode_shape(mode)[coordinate], 0.0);
        Ok(Self(MotionKind::Steady(SteadyMotion {
            offset: numbers.equilibrium()?[coordinate],
            harmonics: vec![(frequency, amplitude)],
        })))
    }

    /// The mechanical energy as a function of time, counted from that at rest in equilibrium.
    ///
    /// # Errors
    ///
    /// Those of [`Self::of_coordinate`].
    pub(crate) fn energy(numbers: &Numbers) -> Result<Self, Unavailable> {
        let motions = (0..numbers.model.degrees_of_freedom())
            .map(|coordinate| Self::of_coordinate(numbers, coordinate));
        let matrices = numbers.matrices()?;
        Ok(Self(MotionKind::Energy(EnergyOf {
            motions: motions.collect::<Result<_, _>>()?,
            rest: numbers.equilibrium()?.to_vec(),
            mass: matrices.mass.numbers().to_vec(),
            stiffness: matrices.stiffness.numbers().to_vec(),
        })))
    }
}

impl OscillatorMotion {
    fn of(oscillator: Oscillator, offset: f64, initial: State, forces: &[HarmonicForce]) -> Self {
        let mut responses: Vec<_> = forces
            .iter()
            .map(|force| (*force, ForcedResponse::of(&oscillator, *force, State::REST)))
            .collect();
        let free = HarmonicForce::constant(0.0);
        responses.push((free, ForcedResponse::of(&oscillator, free, initial)));
        // One response bears both the first force and the start, so that nothing cancels between them.
        if let [(force, response), .., _] = responses.as_mut_slice() {
            *response = ForcedResponse::of(&oscillator, *force, initial);
            responses.pop();
        }
        Self {
            offset,
            oscillator,
            responses,
        }
    }

    fn at(&self, order: u8, time: f64) -> Option<f64> {
        let responses = self.responses.iter();
        match order {
            0 => Some(responses.fold(self.offset, |sum, (_, own)| sum + own.position(time))),
            1 => Some(responses.map(|(_, own)| own.state(time).velocity).sum()),
            2 => Some(
                responses
                    .map(|(force, own)| self.acceleration(force, own, time))
                    .sum(),
            ),
            _ => None,
        }
    }

    /// From the equation of motion.
    fn acceleration(&self, force: &HarmonicForce, response: &ForcedResponse, time: f64) -> f64 {
        let (sine, cosine) = sin_cos(force.angular_frequency * time);
        let exciting = force.cosine * cosine + force.sine * sine;
        let state = response.state(time);
        let restoring = self.oscillator.damping() * state.velocity
            + self.oscillator.stiffness() * state.position;
        (exciting - restoring) / self.oscillator.mass()
    }
}

impl SteadyMotion {
    fn at(&self, order: u8, time: f64) -> f64 {
        let offset = if order == 0 { self.offset } else { 0.0 };
        self.harmonics
            .iter()
            .fold(offset, |sum, (frequency, amplitude)| {
                let (sine, cosine) = sin_cos(frequency * time);
                let mut turning = *amplitude * Complex::new(cosine, sine);
                for _ in 0..order {
                    turning = turning.times_i() * Complex::from(*frequency);
                }
                sum + turning.re
            })
    }
}

impl EnergyOf {
    fn at(&self, time: f64) -> Result<f64, Undefined> {
        let states: Vec<State> = self
            .motions
            .iter()
            .map(|own| own.state(time))
            .collect::<Result<_, _>>()?;
        let size = states.len();
        let mut energy = 0.0;
        for (row, (a, rest)) in states.iter().zip(&self.rest).enumerate() {
            for (column, (b, other)) in states.iter().zip(&self.rest).enumerate() {
                let at = row * size + column;
                energy += 0.5 * self.mass[at] * a.velocity * b.velocity;
                energy += 0.5 * self.stiffness[at] * (a.position - rest) * (b.position - other);
            }
        }
        Ok(energy)
    }
}

fn friction_at(path: &FrictionPath, forces: &SlidingForces, order: u8, time: f64) -> Option<f64> {
    match order {
        0 => Some(path.position(time)),
        1 => Some(path.state(time).velocity),
        2 => Some(forces.acceleration(path.state(time))),
        _ => None,
    }
}

fn pendulum_at(motion: &PendulumMotion, square_rate: f64, order: u8, time: f64) -> Option<f64> {
    match order {
        0 => Some(motion.angle(time)),
        1 => Some(motion.angular_velocity(time)),
        2 => Some(-square_rate * crate::numerics::sin(motion.angle(time))),
        _ => None,
    }
}
