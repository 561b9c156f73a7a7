//! A motion with dry friction, from its start to its rest.

use super::launch::Launch;
use super::path::FrictionPath;
use super::scale::is_decided;
use super::{ClosedForm, FrictionError, FrictionOscillator, StatedNumbers};
use crate::numerics::{Dd, ExactNumber};
use crate::vibration::State;

/// A motion with dry friction, prepared: what is asked for is computed then, at a cost that does not depend on the
/// number of half-cycles.
///
/// A *slide* is the motion between two instants of rest; the start counts as one, also if the mass is thrown. Released
/// from rest, each slide is a half-cycle.
///
/// # Examples
///
/// A block of 2 kg with different coefficients is thrown:
///
/// ```
/// use vibank_dynamics::numerics::ExactNumber;
/// use vibank_dynamics::vibration::{DryFriction, FrictionOscillator};
///
/// let number = |text| ExactNumber::from_decimal(text).unwrap();
/// let friction = DryFriction::of_weight(number("0.3"), number("0.4"), number("2"), number("9.81"));
/// let block = FrictionOscillator::new(number("2"), number("0"), number("200"), friction)?;
/// let motion = block.motion(number("0.2"), number("0.5"))?;
/// assert_eq!(motion.slides(), Some(4));
/// assert!((motion.stop_time() - 0.963_935_430_499).abs() < 1e-12);
/// assert!((motion.rest_position().unwrap() + 0.028_805_086_610_7).abs() < 1e-12);
/// assert!((motion.path_length() - 0.707_955_606_275).abs() < 1e-12);
/// # Ok::<(), vibank_dynamics::vibration::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FrictionMotion {
    pub(crate) system: ClosedForm,
    pub(crate) initial: State,
    pub(crate) opening: Opening,
    /// The side of the equilibrium where the first turning point lies, 1 or -1.
    pub(crate) side: f64,
    /// Its distance from the equilibrium; negative if the mass turns before it gets there.
    pub(crate) reach: Dd,
    pub(crate) ending: Ending,
    /// The distance of the last turning point from the equilibrium, if there is a last one.
    last_reach: Dd,
    /// Start, from the equilibrium.
    offset: Dd,
}

/// An instant at which a mass with dry friction has no velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningPoint {
    /// Where the mass is, in m.
    pub position: f64,
    /// The size of all forces but friction together, `|k x - F|`, in N.
    pub pull: f64,
    /// Whether friction holds the mass there for good.
    pub is_held: bool,
}

/// What happens before the first turning point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Opening {
    /// The start is a turning point.
    Released,
    /// It slides there, for a time in units of the scale.
    Thrown(Launch),
    /// It is overdamped and creeps to the centre of its slide for ever.
    Creeping,
}

/// What happens after the first turning point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ending {
    /// Rest after this number of half-cycles.
    Rest(u64),
    /// It swings for ever: kinetic friction is absent.
    Endless,
    /// It is overdamped and creeps to the centre of its slide for ever.
    Creeping,
}

/// The largest integer below which binary64 has them all.
const MAX_SLIDES: f64 = 9_007_199_254_740_991.0;

/// Up to here a count in `f64` is off by less than one half.
const SURELY_NEAREST: f64 = 1e14;

/// By how much a larger count may be off.
const MAX_MISSING: f64 = 16.0;

impl FrictionMotion {
    #[inline]
    pub(crate) fn of(
        friction: &FrictionOscillator,
        position: ExactNumber,
        velocity: ExactNumber,
    ) -> Result<Self, FrictionError> {
        let given = &friction.given;
        let offset = friction.offset(position);
        let mut motion = Self {
            system: friction.system,
            initial: State {
                position: position.to_f64(),
                velocity: velocity.to_f64(),
            },
            opening: Opening::Released,
            side: if offset.is_negative() { -1.0 } else { 1.0 },
            reach: offset.abs(),
            ending: Ending::Rest(0),
            last_reach: offset.abs(),
            offset,
        };
        if velocity.is_zero() {
            motion.end_from_rest(given, position)?;
        } else {
            // A throw first goes to a turning point; from there on it is a release from rest, whose rules
            // serve for both.
            motion.launch(velocity);
            motion.end_from_throw(given, position, velocity)?;
        }
        if motion.is_within_range() {
            Ok(motion)
        } else {
            Err(FrictionError::OutOfRange)
        }
    }

    /// Follows a mass that is thrown to its first turning point.
    fn launch(&mut self, velocity: ExactNumber) {
        let (scale, slip) = (&self.system.scale, self.system.slip);
        self.side = f64::from(velocity.signum());
        let beyond_centre = self.offset * self.side + slip;
        let speed = velocity.abs().to_dd().scale(-scale.rate_exponent);
        if let Some(launch) = Launch::of(scale, beyond_centre, speed) {
            self.reach = launch.overshoot - slip;
            self.opening = Opening::Thrown(launch);
        } else {
            self.reach = -slip;
            self.opening = Opening::Creeping;
        }
        self.last_reach = self.reach;
    }

    fn end_from_rest(
        &mut self,
        given: &StatedNumbers,
        position: ExactNumber,
    ) -> Result<(), FrictionError> {
        // The magnitudes from which the offset was formed bound its rounding.
        let size = self.initial.position.abs()
            + self.system.equilibrium.hi().abs()
            + self.system.hold.hi();
        let surplus = self.reach - self.system.hold;
        let holds = if is_decided(surplus, size) {
            surplus.is_negative()
        } else {
            given.holds_at(position)
        };
        if holds {
            return Ok(());
        }
        self.end_after_half_cycles(size, |steps| given.rests_from_rest(position, steps))
    }

    fn end_from_throw(
        &mut self,
        given: &StatedNumbers,
        position: ExactNumber,
        velocity: ExactNumber,
    ) -> Result<(), FrictionError> {
        let size = self.reach.hi().abs()
            + self.system.hold.hi()
            + self.initial.position.abs()
            + self.system.equilibrium.hi().abs();
        self.end_after_half_cycles(size, |steps| {
            given.rests_from_throw(position, velocity, steps)
        })
    }

    /// Finds the number of half-cycles, where the exact answer to "does it rest after n" is for undamped motions.
    fn end_after_half_cycles(
        &mut self,
        size: f64,
        rests_after: impl Fn(u64) -> bool,
    ) -> Result<(), FrictionError> {
        let (hold, decay) = (self.system.hold, self.system.decay);
        if !self.system.scale.oscillates() {
            if (self.reach - hold).hi() > 0.0 {
                self.ending = Ending::Creeping;
            }
            return Ok(());
        }
        if self.never_rests() {
            self.ending = Ending::Endless;
            return Ok(());
        }
        // Rounded numbers suffice to come within one of the number; the exact distance there tells which it is.
        let mut nearest = decay.steps_until(self.reach, hold).round().max(0.0);
        if nearest >= MAX_SLIDES {
            return Err(FrictionError::TooManySlides);
        }
        let mut last = decay.after(self.reach, nearest);
        if nearest > SURELY_NEAREST {
            let missing = ((last - hold) / (last - decay.next(last))).hi().round();
            // More is missing only where all digits of the distance have decayed, and then none can be gained.
            if missing.abs() <= MAX_MISSING {
                nearest += missing;
                last = decay.after(self.reach, nearest);
            }
        }
        let surplus = last - hold;
        let rests = if is_decided(surplus, size) || !self.ties_as_undamped(nearest) {
            surplus.hi() <= 0.0
        } else {
            rests_after(nearest as u64)
        };
        self.ending = Ending::Rest(nearest as u64 + u64::from(!rests));
        self.last_reach = if rests { last } else { decay.next(last) };
        Ok(())
    }

    /// Whether the path and the time of all its slides are within the range of numbers, by bounds that cost less.
    fn is_within_range(&self) -> bool {
        let span = 2.0 * (self.reach.hi().abs() + self.offset.hi().abs());
        match self.ending {
            // A slide is no longer than the first, and takes half a period at most.
            Ending::Rest(half_cycles) => {
                let slides = half_cycles as f64 + 2.0;
                let scale = &self.system.scale;
                let is_ended_in_time = || {
                    let time = scale.half_period() * slides;
                    time.scale(-scale.rate_exponent).hi().is_finite()
                };
                (span * slides).is_finite() && (!scale.oscillates() || is_ended_in_time())
            }
            Ending::Endless if self.system.decay.is_viscous() => {
                self.system.decay.endless_path(self.reach).hi().is_finite()
            }
            Ending::Endless | Ending::Creeping => span.is_finite(),
        }
    }

    /// Without kinetic friction a turning point outside the reach of static friction, if any, is followed by others.
    fn never_rests(&self) -> bool {
        let dies_out = self.system.decay.is_viscous() && self.system.hold.hi() > 0.0;
        self.system.slip.hi() == 0.0 && !dies_out && (self.reach - self.system.hold).hi() > 0.0
    }

    /// Whether viscous damping is too weak to move the turning points against a tie.
    fn ties_as_undamped(&self, steps: f64) -> bool {
        // Turning points that move by less are the same in double-double, which has 31 digits.
        const WEAK: f64 = 1e-30;
        steps == 0.0 && matches!(self.opening, Opening::Released)
            || self.system.decay.theta() * (steps + 1.0) * (steps + 1.0) < WEAK
    }

    /// The number of slides until it rests for good; none if it swings for ever. A slide that creeps counts.
    pub fn slides(&self) -> Option<u64> {
        let opening = u64::from(!matches!(self.opening, Opening::Released));
        match (self.opening, self.ending) {
            (Opening::Creeping, _) => Some(1),
            (_, Ending::Rest(half_cycles)) => Some(opening + half_cycles),
            (_, Ending::Creeping) => Some(opening + 1),
            (_, Ending::Endless) => None,
        }
    }

    /// The time at which it comes to rest, in s; infinite if it only creeps towards its rest, or swings for ever.
    pub fn stop_time(&self) -> f64 {
        match (self.opening, self.ending) {
            (Opening::Creeping, _) | (_, Ending::Endless | Ending::Creeping) => f64::INFINITY,
            (_, Ending::Rest(half_cycles)) => {
                let time = self.launch_duration() + self.half_cycles_duration(half_cycles);
                time.scale(-self.system.scale.rate_exponent).hi()
            }
        }
    }

    /// Where it comes to rest, in m, at last; none if it swings for ever without damping.
    pub fn rest_position(&self) -> Option<f64> {
        if self.slides() == Some(0) {
            return Some(self.initial.position);
        }
        let offset = self.rest_offset()?;
        Some((self.system.equilibrium + offset).hi())
    }

    /// The length of the path until it rests, in m; infinite if it swings for ever without damping.
    pub fn path_length(&self) -> f64 {
        let launch = match self.opening {
            Opening::Released => Dd::ZERO,
            Opening::Thrown(_) | Opening::Creeping => self.reach - self.offset * self.side,
        };
        let rest = match self.ending {
            Ending::Rest(half_cycles) => {
                self.system
                    .decay
                    .path(self.reach, half_cycles as f64, self.last_reach)
            }
            Ending::Endless => self.system.decay.endless_path(self.reach),
            Ending::Creeping => self.reach - self.system.slip,
        };
        (launch + rest).hi()
    }

    /// The energy that has turned into heat when it rests, in J.
    ///
    /// ```text
    /// m v0^2/2 + k (x0 - F/k)^2/2 - k (x_n - F/k)^2/2
    /// ```
    pub fn dissipated_energy(&self) -> f64 {
        let Some(rest) = self.rest_offset() else {
            return 0.0;
        };
        let oscillator = &self.system.oscillator;
        let speed = Dd::from(self.initial.velocity);
        let elastic = (self.offset - rest) * (self.offset + rest) * oscillator.stiffness();
        ((elastic + speed.square() * oscillator.mass()) * 0.5).hi()
    }

    /// The turning points from the first to the rest, without end if it swings for ever; none if it creeps from its
    /// start. Released from rest, the first is the start.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::numerics::ExactNumber;
    /// use vibank_dynamics::vibration::{DryFriction, FrictionOscillator};
    ///
    /// let number = |text| ExactNumber::from_decimal(text).unwrap();
    /// let friction = DryFriction::of_forces(number("1"), number("1"));
    /// let block = FrictionOscillator::new(number("1"), number("0"), number("8"), friction)?;
    /// let motion = block.motion(number("0.5"), number("0"))?;
    /// let points: Vec<_> = motion.turning_points().collect();
    /// assert_eq!(points.len(), 3);
    /// assert_eq!((points[1].position, points[1].pull), (-0.25, 2.0));
    /// assert!(points[2].is_held && points[2].pull == 0.0);
    /// # Ok::<(), vibank_dynamics::vibration::FrictionError>(())
    /// ```
    pub fn turning_points(&self) -> impl Iterator<Item = TurningPoint> + '_ {
        let count = match (self.opening, self.ending) {
            (Opening::Creeping, _) => 0,
            (_, Ending::Rest(half_cycles)) => half_cycles.saturating_add(1),
            (_, Ending::Creeping) => 1,
            (_, Ending::Endless) => u64::MAX,
        };
        let stiffness = self.system.oscillator.stiffness();
        (0..count).map(move |half_cycles| {
            let is_held = self.ending == Ending::Rest(half_cycles);
            let offset = if is_held {
                self.rest_offset().unwrap_or(Dd::ZERO)
            } else {
                self.turning_point(half_cycles as f64)
            };
            TurningPoint {
                position: (self.system.equilibrium + offset).hi(),
                pull: (offset.abs() * stiffness).hi(),
                is_held,
            }
        })
    }

    /// Whether it was released from rest, so that its first turning point is its start.
    pub fn is_released(&self) -> bool {
        matches!(self.opening, Opening::Released)
    }

    /// Position and velocity as functions of time.
    pub fn path(&self) -> FrictionPath {
        FrictionPath::of(self)
    }

    /// Where it rests, from the equilibrium.
    pub(crate) fn rest_offset(&self) -> Option<Dd> {
        let side = Dd::from(self.side);
        match self.ending {
            Ending::Rest(half_cycles) => {
                // The last distance is kept from when it was tested: formed anew it might round to the other
                // side of the hold.
                let offset = self.last_reach * self.side_after(half_cycles as f64);
                // What is left of a long difference is rounding: it rests at the equilibrium.
                Some(if is_decided(offset, self.reach.hi()) {
                    offset
                } else {
                    Dd::ZERO
                })
            }
            Ending::Creeping => Some(side * self.system.slip),
            Ending::Endless => self.system.decay.is_viscous().then_some(Dd::ZERO),
        }
    }

    /// The turning point after a number of half-cycles, from the equilibrium.
    pub(crate) fn turning_point(&self, half_cycles: f64) -> Dd {
        self.system.decay.after(self.reach, half_cycles) * self.side_after(half_cycles)
    }

    /// The side of the turning point after a number of half-cycles.
    pub(crate) fn side_after(&self, half_cycles: f64) -> f64 {
        if (half_cycles as u64).is_multiple_of(2) {
            self.side
        } else {
            -self.side
        }
    }

    /// The duration of the first slide of a thrown mass, in units of the scale.
    pub(crate) fn launch_duration(&self) -> Dd {
        match self.opening {
            Opening::Thrown(launch) => launch.duration(&self.system.scale),
            Opening::Released | Opening::Creeping => Dd::ZERO,
        }
    }

    fn half_cycles_duration(&self, half_cycles: u64) -> Dd {
        if half_cycles == 0 {
            return Dd::ZERO;
        }
        self.system.scale.half_period() * half_cycles as f64
    }
}
