//! The whole motion under a harmonic force, from an initial state.

use super::divided_difference::Nodes;
use super::driven::DrivenSystem;
use super::undamped::Beat;
use crate::numerics::{Complex, Dd, binary_exponent, hypot, two_sum};
use crate::vibration::free::FreeResponse;
use crate::vibration::oscillator::{Oscillator, Scaled};
use crate::vibration::power_of_two::PowerOfTwo;
use crate::vibration::state::State;

/// The force a cos Ωt + b sin Ωt in N; at Ω = 0 the constant a.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::HarmonicForce;
///
/// let force = HarmonicForce::cosine(10.0, 3.0);
/// assert_eq!(force, HarmonicForce { cosine: 10.0, sine: 0.0, angular_frequency: 3.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicForce {
    /// Factor a of the cosine in N.
    pub cosine: f64,
    /// Factor b of the sine in N.
    pub sine: f64,
    /// Angular frequency Ω in rad/s.
    pub angular_frequency: f64,
}

impl HarmonicForce {
    /// The force F cos Ωt.
    pub const fn cosine(amplitude: f64, angular_frequency: f64) -> Self {
        Self {
            cosine: amplitude,
            sine: 0.0,
            angular_frequency,
        }
    }

    /// The force F sin Ωt.
    pub const fn sine(amplitude: f64, angular_frequency: f64) -> Self {
        Self {
            cosine: 0.0,
            sine: amplitude,
            angular_frequency,
        }
    }

    /// The force k y + c y' on the mass of an oscillator whose base moves as y = U cos Ωt, with U in m.
    ///
    /// The response to it is the motion of the mass itself, not the one relative to the base.
    pub fn of_base_motion(oscillator: &Oscillator, amplitude: f64, angular_frequency: f64) -> Self {
        Self {
            cosine: oscillator.stiffness() * amplitude,
            sine: -oscillator.damping() * angular_frequency * amplitude,
            angular_frequency,
        }
    }

    /// The force u Ω² cos Ωt of a rotating unbalance u, mass times eccentricity, in kg·m.
    pub fn of_unbalance(unbalance: f64, angular_frequency: f64) -> Self {
        Self::cosine(
            unbalance * angular_frequency * angular_frequency,
            angular_frequency,
        )
    }

    fn with_positive_frequency(self) -> Self {
        if self.angular_frequency < 0.0 {
            Self {
                sine: -self.sine,
                angular_frequency: -self.angular_frequency,
                ..self
            }
        } else {
            self
        }
    }

    /// The force that is applied at time zero and stays.
    pub const fn constant(force: f64) -> Self {
        Self::cosine(force, 0.0)
    }
}

/// The motion of an oscillator under a harmonic force from an initial state, for times in s that are not negative,
///
/// ```text
/// m x'' + c x' + k x = a cos Ωt + b sin Ωt,   x(0) = x0,   x'(0) = v0
/// ```
///
/// Errors stay below 2e-14 of the local scale, at resonance and beside it, from short times to Ωt = 1e9 and beyond.
///
/// # Examples
///
/// Undamped resonance grows linearly, x = F t sin(Ωt)/(2 m Ω):
///
/// ```
/// use vibank_dynamics::vibration::{ForcedResponse, HarmonicForce, Oscillator, State};
///
/// let oscillator = Oscillator::new(1.0, 0.0, 4.0)?;
/// let motion = ForcedResponse::of(&oscillator, HarmonicForce::cosine(8.0, 2.0), State::REST);
/// assert!((motion.position(0.25 * std::f64::consts::PI) - 0.5 * std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ForcedResponse {
    initial: State,
    /// What the initial state alone does; none from rest.
    free: Option<FreeResponse>,
    /// What the force does from rest; none without one.
    driven: Option<FromRest>,
    /// Both in other parts; none where steady and free motion are always kept together.
    separated: Option<Separated>,
}

/// The steady motion and a free one that, with it, starts from the initial state or from rest.
#[derive(Clone, Copy, Debug)]
struct Separated {
    steady: Steady,
    transient: FreeResponse,
    /// What the initial state alone does, where the transient starts from rest.
    free: Option<FreeResponse>,
    /// The parts may be added from this time on.
    since: f64,
}

/// The steady motion X cos(Ωt - φ), as factors of cosine and sine.
#[derive(Clone, Copy, Debug)]
struct Steady {
    cosine: f64,
    sine: f64,
    frequency: f64,
}

/// The motion from rest where steady and free motion nearly cancel, in scaled units.
#[derive(Clone, Copy, Debug)]
struct FromRest {
    kind: ResponseKind,
    /// Force over mass as a complex amplitude.
    force: Complex,
    time: PowerOfTwo,
    position: PowerOfTwo,
    velocity: PowerOfTwo,
}

#[derive(Clone, Copy, Debug)]
enum ResponseKind {
    Beat(Beat),
    Nodes(Nodes),
}

impl ForcedResponse {
    /// The motion under a force, from an initial state in m and m/s.
    pub fn of(oscillator: &Oscillator, force: HarmonicForce, initial: State) -> Self {
        let subject = DrivenSystem {
            oscillator,
            mode: None,
        };
        Self::of_subject(subject, force, initial)
    }

    /// The motion `q'' + c q' + k q = a cos Ωt + b sin Ωt` of a mode; `None` if these numbers are not an oscillator.
    pub(crate) fn of_mode(
        damping: Dd,
        stiffness: Dd,
        force: HarmonicForce,
        initial: State,
    ) -> Option<Self> {
        let oscillator = Oscillator::new(1.0, damping.hi(), stiffness.hi()).ok()?;
        let subject = DrivenSystem {
            oscillator: &oscillator,
            mode: Some((damping, stiffness)),
        };
        Some(Self::of_subject(subject, force, initial))
    }

    fn of_subject(subject: DrivenSystem<'_>, force: HarmonicForce, initial: State) -> Self {
        let force = force.with_positive_frequency();
        let is_driven = force.cosine != 0.0 || force.sine != 0.0;
        let is_beat = subject.oscillator.damping() == 0.0 && force.sine == 0.0;
        let free = (initial != State::REST).then(|| subject.free(initial));
        let separated = || Separated::of(subject, force, is_beat, initial, free);
        Self {
            initial,
            free,
            driven: is_driven.then(|| FromRest::of(subject, force, is_beat)),
            separated: is_driven.then(separated).flatten(),
        }
    }

    /// Position in m at a time in s.
    pub fn position(&self, time: f64) -> f64 {
        if time == 0.0 {
            return self.initial.position;
        }
        let (free, driven) = match self.separated(time) {
            Some(parts) => (&parts.free, Some(parts.position(time))),
            None => (&self.free, self.driven.map(|driven| driven.position(time))),
        };
        let free = free.map_or(0.0, |free| free.position(time));
        driven.map_or(free, |driven| free + driven)
    }

    /// Position in m and velocity in m/s at a time in s.
    pub fn state(&self, time: f64) -> State {
        if time == 0.0 {
            return self.initial;
        }
        let (free, driven) = match self.separated(time) {
            Some(parts) => (&parts.free, Some(parts.state(time))),
            None => (&self.free, self.driven.map(|driven| driven.state(time))),
        };
        let free = free.map_or(State::REST, |free| free.state(time));
        driven.map_or(free, |driven| free + driven)
    }

    /// The parts, where they may be added.
    fn separated(&self, time: f64) -> Option<&Separated> {
        self.separated.as_ref().filter(|parts| time >= parts.since)
    }
}

impl Separated {
    /// The motions, and the time after which no exponential of the free one is close to that of the force,
    /// 1/min |r - iΩ|. A beat is taken apart only where the force is much faster than the free motion.
    fn of(
        subject: DrivenSystem<'_>,
        force: HarmonicForce,
        is_beat: bool,
        initial: State,
        free: Option<FreeResponse>,
    ) -> Option<Self> {
        const FAST: f64 = 1e6;
        let oscillator = subject.oscillator;
        let frequency = force.angular_frequency;
        if is_beat && frequency < FAST * oscillator.natural_angular_frequency() {
            return None;
        }
        let nearest = if let Some((slow, _)) = oscillator.decay_roots() {
            hypot(slow, frequency)
        } else {
            let free = oscillator.damped_angular_frequency().unwrap_or(0.0);
            hypot(oscillator.decay_rate(), free - frequency)
        };
        let steady = Steady::of(subject, force);
        let joined = steady.transient(initial);
        let transient = joined.or_else(|| steady.transient(State::REST))?;
        Some(Self {
            steady,
            transient: subject.free(transient),
            free: free.filter(|_| joined.is_none()),
            since: 1.0 / nearest,
        })
    }

    fn position(&self, time: f64) -> f64 {
        self.steady.position(time) + self.transient.position(time)
    }

    fn state(&self, time: f64) -> State {
        self.steady.state(time) + self.transient.state(time)
    }
}

impl Steady {
    fn of(subject: DrivenSystem<'_>, force: HarmonicForce) -> Self {
        let response = subject.steady(force.angular_frequency);
        let (cosine, sine) = response.direction();
        let (from_cosine, from_sine) = (
            response.amplitude(force.cosine),
            response.amplitude(force.sine),
        );
        Self {
            cosine: from_cosine * cosine - from_sine * sine,
            sine: from_cosine * sine + from_sine * cosine,
            frequency: force.angular_frequency,
        }
    }

    /// The free motion at time zero that brings the steady one to an initial state; none where its rounding exceeds that of
    /// the steady motion, which is off by some units in the last place of its amplitude: where one part of a free motion
    /// decays much faster than the other, what is lost of a large initial state would outlast it.
    fn transient(&self, initial: State) -> Option<State> {
        let amplitude = hypot(self.cosine, self.sine);
        let rest = |initial: f64, steady: f64, amplitude: f64| {
            let (rest, error) = two_sum(initial, -steady);
            (error.abs() <= f64::EPSILON * amplitude).then_some(rest)
        };
        Some(State {
            position: rest(initial.position, self.cosine, amplitude)?,
            velocity: rest(
                initial.velocity,
                self.frequency * self.sine,
                self.frequency * amplitude,
            )?,
        })
    }

    fn position(&self, time: f64) -> f64 {
        let (sine, cosine) = Dd::product(self.frequency, time).sin_cos_to_f64();
        self.cosine * cosine + self.sine * sine
    }

    fn state(&self, time: f64) -> State {
        let (sine, cosine) = Dd::product(self.frequency, time).sin_cos_to_f64();
        State {
            position: self.cosine * cosine + self.sine * sine,
            velocity: self.frequency * (self.sine * cosine - self.cosine * sine),
        }
    }
}

impl FromRest {
    fn of(subject: DrivenSystem<'_>, force: HarmonicForce, is_beat: bool) -> Self {
        let scaled = Scaled::driven(subject.oscillator, force.angular_frequency);
        let frequency = scaled.scaled_rate(force.angular_frequency);
        let kind = if is_beat {
            ResponseKind::Beat(subject.beat(&scaled, frequency))
        } else {
            ResponseKind::Nodes(subject.nodes(&scaled, frequency))
        };
        let exponent = binary_exponent(force.cosine)
            .max(binary_exponent(force.sine))
            // A force that is zero has the smallest integer for an exponent, which must not overflow when it
            // is subtracted.
            .clamp(-1100, 1100);
        let unit = PowerOfTwo::new(-exponent);
        let position = exponent - scaled.mass_exponent - 2 * scaled.rate_exponent;
        Self {
            kind,
            force: Complex::new(unit.apply(force.cosine), -unit.apply(force.sine)) / scaled.mass,
            time: PowerOfTwo::new(scaled.rate_exponent),
            position: PowerOfTwo::new(position),
            velocity: PowerOfTwo::new(position + scaled.rate_exponent),
        }
    }

    fn position(&self, time: f64) -> f64 {
        let t = self.time.apply(time);
        self.position.apply(match &self.kind {
            ResponseKind::Beat(beat) => self.force.re * beat.position(t),
            ResponseKind::Nodes(nodes) => (self.force * nodes.position(t)).re,
        })
    }

    fn state(&self, time: f64) -> State {
        let t = self.time.apply(time);
        let (position, velocity) = match &self.kind {
            ResponseKind::Beat(beat) => {
                let state = beat.state(t);
                (
                    self.force.re * state.position,
                    self.force.re * state.velocity,
                )
            }
            ResponseKind::Nodes(nodes) => {
                let differences = nodes.differences(t);
                (
                    (self.force * differences.position).re,
                    (self.force * differences.velocity).re,
                )
            }
        };
        State {
            position: self.position.apply(position),
            velocity: self.velocity.apply(velocity),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::forced::frequency_response::FrequencyResponse;

    /// The largest position over the last of many periods.
    fn late_amplitude(oscillator: &Oscillator, force: HarmonicForce) -> f64 {
        let motion = ForcedResponse::of(oscillator, force, State::REST);
        let sample = |n: i32| motion.position(1e3 + 0.002 * f64::from(n)).abs();
        (0..2000).map(sample).fold(0.0, f64::max)
    }

    #[test]
    fn base_motion_and_unbalance_settle_to_their_amplitudes() {
        let oscillator = Oscillator::new(2.0, 0.7, 30.0).unwrap();
        let response = FrequencyResponse::at(&oscillator, 3.0);
        let base = late_amplitude(
            &oscillator,
            HarmonicForce::of_base_motion(&oscillator, 0.1, 3.0),
        );
        assert!((base / (0.1 * response.transmissibility()) - 1.0).abs() < 1e-5);
        let unbalance = late_amplitude(&oscillator, HarmonicForce::of_unbalance(0.05, 3.0));
        assert!((unbalance / response.unbalance_amplitude(0.05) - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_negative_frequency_turns_the_sine() {
        let oscillator = Oscillator::new(1.0, 0.1, 1.0).unwrap();
        let force = HarmonicForce {
            cosine: 1.0,
            sine: 2.0,
            angular_frequency: -1.5,
        };
        let same = HarmonicForce {
            cosine: 1.0,
            sine: -2.0,
            angular_frequency: 1.5,
        };
        let state = |force| ForcedResponse::of(&oscillator, force, State::REST).state(2.0);
        assert_eq!(state(force), state(same));
    }

    #[test]
    fn no_force_leaves_the_free_motion() {
        let oscillator = Oscillator::new(1.0, 0.1, 1.0).unwrap();
        let initial = State {
            position: 0.3,
            velocity: 0.1,
        };
        let forced = ForcedResponse::of(&oscillator, HarmonicForce::constant(0.0), initial);
        assert_eq!(
            forced.state(4.0),
            FreeResponse::of(&oscillator, initial).state(4.0)
        );
    }
}
