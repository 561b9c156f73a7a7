//! Dry friction, alone or with viscous damping, in closed form.
//!
//! ```text
//! m x'' + c x' + k x + F_k sgn(x') = F        while it slides
//! stuck where x' = 0 and |k x - F| <= F_s
//! ```
//!
//! Between two turning points the motion is a free one about a centre that friction shifts by `F_k/k`. So the turning
//! points follow each other by a rule that can be written down for all of them at once, and neither events are searched
//! nor half-cycles counted one by one:
//!
//! - [`FrictionOscillator`] is the system; its numbers are [`ExactNumber`]s, because an integer answer hangs on them.
//! - [`FrictionMotion`] is a motion from one start: number of slides, time and position of rest, path, heat.
//! - [`FrictionPath`] samples its position and velocity.
//!
//! Absent: a force that varies in time.

mod decay;
mod launch;
mod motion;
mod path;
mod scale;
mod ties;

pub use motion::{FrictionMotion, TurningPoint};
pub use path::FrictionPath;

use thiserror::Error;

use self::decay::Decay;
use self::scale::{Scale, is_decided, ratio};
use super::oscillator::{Oscillator, OscillatorError};
use crate::numerics::{Dd, ExactNumber, sign_of_sum};

/// The force of dry friction: while sliding, `F_k`, and at most while sticking, `F_s`; on a plane `F = mu m g`.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::ExactNumber;
/// use vibank_dynamics::vibration::{DryFriction, FrictionOscillator};
///
/// let number = |text| ExactNumber::from_decimal(text).unwrap();
/// let friction = DryFriction::of_weight(number("0.3"), number("0.4"), number("2"), number("10"));
/// let block = FrictionOscillator::new(number("2"), number("0"), number("200"), friction)?;
/// assert_eq!((block.slip_half_width(), block.stick_half_width()), (0.03, 0.04));
/// # Ok::<(), vibank_dynamics::vibration::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DryFriction {
    kinetic: Factors,
    fixed: Factors,
    /// Whether it holds as it slides.
    is_single: bool,
}

/// A force as a product, so that nothing is rounded.
type Factors = [ExactNumber; 3];

/// A mass on a spring and a damper, with dry friction and a constant force.
///
/// # Examples
///
/// A block with `mu m g/k = 0.1 m` is released at 0.3 m, which is a tie: after the first half-cycle it comes to rest
/// exactly where friction can just hold it.
///
/// ```
/// use vibank_dynamics::numerics::ExactNumber;
/// use vibank_dynamics::vibration::{DryFriction, FrictionOscillator};
///
/// let number = |text| ExactNumber::from_decimal(text).unwrap();
/// let friction = DryFriction::of_forces(number("0.1"), number("0.1"));
/// let block = FrictionOscillator::new(number("1"), number("0"), number("1"), friction)?;
/// let motion = block.motion(number("0.3"), number("0"))?;
/// assert_eq!(motion.slides(), Some(1));
/// assert_eq!(motion.rest_position(), Some(-0.1));
/// assert_eq!(motion.stop_time(), std::f64::consts::PI);
/// # Ok::<(), vibank_dynamics::vibration::FrictionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FrictionOscillator {
    given: StatedNumbers,
    system: ClosedForm,
}

/// The numbers as they were given; ties are decided on them.
#[derive(Clone, Copy, Debug)]
struct StatedNumbers {
    mass: ExactNumber,
    stiffness: ExactNumber,
    friction: DryFriction,
    force: ExactNumber,
}

/// The numbers of the closed forms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClosedForm {
    oscillator: Oscillator,
    scale: Scale,
    /// How far friction shifts the centre of a slide, F_k/k.
    slip: Dd,
    /// How far from the equilibrium friction can hold the mass, F_s/k.
    hold: Dd,
    /// The equilibrium without friction, F/k.
    equilibrium: Dd,
    decay: Decay,
}

/// Why there is no such system or motion.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FrictionError {
    /// Mass, damping and stiffness are no oscillator.
    #[error(transparent)]
    Oscillator(#[from] OscillatorError),
    /// The force of friction is negative.
    #[error("the force of friction is negative")]
    NegativeFriction,
    /// A mass that sticks less than it slides would rest and move at once.
    #[error("static friction is smaller than kinetic friction")]
    StaticBelowKinetic,
    /// More half-cycles than integers that binary64 distinguishes.
    #[error("the motion has more than 9e15 half-cycles")]
    TooManySlides,
    /// A length or a time leaves the range of numbers.
    #[error("the motion leaves the range of numbers")]
    OutOfRange,
}

impl DryFriction {
    /// Friction of two forces in N: of sliding, and the greatest of sticking.
    pub fn of_forces(kinetic: ExactNumber, fixed: ExactNumber) -> Self {
        let one = ExactNumber::from(1);
        Self {
            kinetic: [kinetic, one, one],
            fixed: [fixed, one, one],
            is_single: kinetic == fixed,
        }
    }

    /// Friction under the weight of a mass in kg in a gravity in m/s², by the coefficients of sliding and of sticking.
    pub fn of_weight(
        kinetic: ExactNumber,
        fixed: ExactNumber,
        mass: ExactNumber,
        gravity: ExactNumber,
    ) -> Self {
        Self {
            kinetic: [kinetic, mass, gravity],
            fixed: [fixed, mass, gravity],
            is_single: kinetic == fixed,
        }
    }

    fn check(&self) -> Result<(), FrictionError> {
        let signs = self.kinetic.iter().map(|factor| factor.signum());
        if signs.product::<i32>() < 0 {
            Err(FrictionError::NegativeFriction)
        } else if !self.is_single
            && sign_of_sum(&[&self.fixed, &ties::negated(self.kinetic)]).is_lt()
        {
            Err(FrictionError::StaticBelowKinetic)
        } else {
            Ok(())
        }
    }
}

impl FrictionOscillator {
    /// A system of a mass in kg, a damping coefficient in N·s/m, a stiffness in N/m and dry friction.
    ///
    /// # Errors
    ///
    /// Mass and stiffness must be positive, the damping coefficient and friction not negative, static friction not below
    /// kinetic friction, and the damping ratio below 1e150.
    #[inline]
    pub fn new(
        mass: ExactNumber,
        damping: ExactNumber,
        stiffness: ExactNumber,
        friction: DryFriction,
    ) -> Result<Self, FrictionError> {
        let oscillator = Oscillator::new(mass.to_f64(), damping.to_f64(), stiffness.to_f64())?;
        friction.check()?;
        let scale = Scale::of(mass, damping, stiffness);
        let slip = ratio(&friction.kinetic, stiffness);
        let hold = if friction.is_single {
            slip
        } else {
            ratio(&friction.fixed, stiffness)
        };
        if !(hold.is_finite() && scale.is_moderate()) {
            return Err(FrictionError::OutOfRange);
        }
        Ok(Self {
            given: StatedNumbers {
                mass,
                stiffness,
                friction,
                force: ExactNumber::ZERO,
            },
            system: ClosedForm {
                oscillator,
                scale,
                slip,
                hold,
                equilibrium: Dd::ZERO,
                decay: Decay::new(slip, scale.decay_in_half_period()),
            },
        })
    }

    /// The same system under a constant force in N, such as the weight along an incline.
    ///
    /// # Errors
    ///
    /// [`FrictionError::OutOfRange`] if the equilibrium is beyond the range of numbers.
    pub fn with_force(mut self, force: ExactNumber) -> Result<Self, FrictionError> {
        self.given.force = force;
        self.system.equilibrium = ratio(&[force], self.given.stiffness);
        if self.system.equilibrium.is_finite() {
            Ok(self)
        } else {
            Err(FrictionError::OutOfRange)
        }
    }

    /// The motion from a position in m with a velocity in m/s.
    ///
    /// # Errors
    ///
    /// [`FrictionError::TooManySlides`] or [`FrictionError::OutOfRange`] for a motion beyond numbers.
    #[inline]
    pub fn motion(
        &self,
        position: ExactNumber,
        velocity: ExactNumber,
    ) -> Result<FrictionMotion, FrictionError> {
        FrictionMotion::of(self, position, velocity)
    }

    /// How far friction shifts the centre of a slide, `F_k/k`, in m.
    pub fn slip_half_width(&self) -> f64 {
        self.system.slip.hi()
    }

    /// How far from the equilibrium friction can hold the mass at rest, `F_s/k`, in m.
    pub fn stick_half_width(&self) -> f64 {
        self.system.hold.hi()
    }

    /// Where the mass would rest without friction, `F/k`, in m.
    pub fn equilibrium(&self) -> f64 {
        self.system.equilibrium.hi()
    }

    /// The distance of a position from the equilibrium, with an exact sign.
    fn offset(&self, position: ExactNumber) -> Dd {
        let position_dd = position.to_dd();
        let offset = position_dd - self.system.equilibrium;
        if is_decided(offset, position_dd.hi()) {
            return offset;
        }
        match self.given.side_of(position) {
            std::cmp::Ordering::Equal => Dd::ZERO,
            std::cmp::Ordering::Less => -offset.abs(),
            std::cmp::Ordering::Greater => offset.abs(),
        }
    }
}
