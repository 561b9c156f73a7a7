//! Position and velocity of a motion with dry friction, at any time.

use super::motion::{Ending, FrictionMotion, Opening};
use crate::numerics::Dd;
use crate::vibration::{FreeResponse, State};

/// Samples a motion with dry friction: each costs one sample of a free motion, whatever the number of half-cycles.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::ExactNumber;
/// use vibank_dynamics::vibration::{DryFriction, FrictionOscillator};
///
/// let number = |text| ExactNumber::from_decimal(text).unwrap();
/// let friction = DryFriction::of_weight(number("0.2"), number("0.2"), number("2"), number("9.81"));
/// let block = FrictionOscillator::new(number("2"), number("0"), number("100"), friction)?;
/// let path = block.motion(number("0.1"), number("0"))?.path();
/// assert!((path.position(0.1) - 0.085_432_461_718_3).abs() < 1e-13);
/// // It rests after 0.444 s.
/// assert_eq!(path.state(0.5).velocity, 0.0);
/// # Ok::<(), vibank_dynamics::vibration::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FrictionPath {
    motion: FrictionMotion,
    /// The first slide of a thrown mass, about its centre.
    launch: FreeResponse,
    /// A slide from rest at the distance 1 from its centre.
    slide: FreeResponse,
    launch_duration: Dd,
    half_period: Dd,
    /// Where and when it rests, if it does in a finite time.
    rest: Option<(f64, f64)>,
}

/// A slide, its centre and the time since it began.
struct Arc {
    response: FreeResponse,
    /// Distance of the start of the slide from its centre, for a response of unit distance.
    amplitude: f64,
    centre: Dd,
    elapsed: f64,
}

impl FrictionPath {
    pub(crate) fn of(motion: &FrictionMotion) -> Self {
        let system = &motion.system;
        let unit = State {
            position: 1.0,
            velocity: 0.0,
        };
        let beyond_centre = Dd::from(motion.initial.position) - launch_centre(motion);
        let thrown = State {
            position: beyond_centre.hi(),
            velocity: motion.initial.velocity,
        };
        let stop_time = motion.stop_time();
        Self {
            motion: *motion,
            launch: FreeResponse::of(&system.oscillator, thrown),
            slide: FreeResponse::of(&system.oscillator, unit),
            launch_duration: motion.launch_duration(),
            half_period: system.scale.half_period(),
            rest: motion
                .rest_position()
                .filter(|_| stop_time.is_finite())
                .map(|position| (stop_time, position)),
        }
    }

    /// Position at a time in s, in m; before the start it is the position at the start.
    pub fn position(&self, time: impl Into<Dd>) -> f64 {
        match self.at(time.into()) {
            Ok(arc) => (arc.centre + arc.amplitude * arc.response.position(arc.elapsed)).hi(),
            Err(resting) => resting,
        }
    }

    /// Position in m and velocity in m/s at a time in s; before the start they are those at the start.
    pub fn state(&self, time: impl Into<Dd>) -> State {
        match self.at(time.into()) {
            Ok(arc) => {
                let state = arc.response.state(arc.elapsed);
                State {
                    position: (arc.centre + arc.amplitude * state.position).hi(),
                    velocity: arc.amplitude * state.velocity,
                }
            }
            Err(position) => State {
                position,
                velocity: 0.0,
            },
        }
    }

    /// The slide that a time falls into, or the position of rest.
    fn at(&self, time: Dd) -> Result<Arc, f64> {
        let time = if time.is_negative() { Dd::ZERO } else { time };
        if let Some((_, position)) = self.rest.filter(|(stop_time, _)| time.hi() >= *stop_time) {
            return Err(position);
        }
        let motion = &self.motion;
        let scaled = scaled_time(time, motion.system.scale.rate_exponent);
        // In double-double from here on: after a billion half-cycles a rounded time would have lost nine
        // digits of the phase.
        let since_turning = scaled - self.launch_duration;
        let is_launching = match motion.opening {
            Opening::Released => false,
            Opening::Thrown(_) => since_turning.is_negative(),
            Opening::Creeping => true,
        };
        if is_launching {
            return Ok(Arc {
                response: self.launch,
                amplitude: 1.0,
                centre: launch_centre(motion),
                elapsed: time.hi(),
            });
        }
        Ok(self.half_cycle(since_turning))
    }

    /// The half-cycle that a time since the first turning point falls into.
    fn half_cycle(&self, since_turning: Dd) -> Arc {
        let motion = &self.motion;
        let steps = self.half_cycles_in(since_turning);
        let shift = motion.system.slip * motion.side_after(steps);
        let elapsed = if steps == 0.0 {
            since_turning
        } else {
            since_turning - self.half_period * steps
        };
        Arc {
            response: self.slide,
            // Each slide starts from the closed form of its turning point, not from the end of the one
            // before: errors do not add up.
            amplitude: (motion.turning_point(steps) - shift).hi(),
            centre: motion.system.equilibrium + shift,
            // After so many turns that their number is rounded, the phase is lost; it must not go backwards.
            elapsed: elapsed
                .scale(-motion.system.scale.rate_exponent)
                .hi()
                .max(0.0),
        }
    }

    /// How many half-cycles are over.
    fn half_cycles_in(&self, since_turning: Dd) -> f64 {
        let passed = || (since_turning / self.half_period).floor().hi().max(0.0);
        match self.motion.ending {
            Ending::Creeping => 0.0,
            Ending::Endless => passed(),
            Ending::Rest(half_cycles) => passed().min(half_cycles.saturating_sub(1) as f64),
        }
    }
}

/// A time in units of the scale, kept so short that the phases stay finite.
fn scaled_time(time: Dd, rate_exponent: i32) -> Dd {
    // As times of a free response: phases are a few times as large and still finite.
    const MAX_SCALED: f64 = 1e300;
    let scaled = time.scale(rate_exponent);
    if scaled.hi().abs() < MAX_SCALED {
        scaled
    } else {
        Dd::from(MAX_SCALED.copysign(time.hi()))
    }
}

/// The centre of the first slide of a thrown mass.
fn launch_centre(motion: &FrictionMotion) -> Dd {
    motion.system.equilibrium - motion.system.slip * motion.side
}
