//! The motion of a pendulum from any start.
//!
//! With `kappa = theta'/(2 omega0)` the energy over that of the top is `E = kappa^2 + sin^2(theta/2)`, the same at all
//! times. Below 1 the pendulum swings with the modulus `sqrt(E)`, above it turns over with the modulus `1/sqrt(E)`.

use super::{Pendulum, PendulumError};
use crate::numerics::{
    Dd, JacobiFunctions, JacobiValues, asinh, atan, atan2, carlson_rf, cosh, scale_by_power_of_two,
    sinh,
};

/// The motion of a pendulum, prepared for many times.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::Pendulum;
///
/// let pendulum = Pendulum::new(1.0, 9.81).unwrap();
/// let motion = pendulum.motion(2.0, 0.0).unwrap();
/// let period = pendulum.period(2.0).unwrap();
/// assert!((motion.angle(0.5 * period) + 2.0).abs() < 1e-14);
///
/// // Thrown fast enough it turns over, and the angle keeps counting.
/// let motion = pendulum.motion(0.0, 7.0).unwrap();
/// assert!(motion.angle(100.0) > 400.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PendulumMotion {
    course: MotionType,
    /// The full turns of the start, in rad.
    turns: f64,
    /// Positive if the motion begins towards greater angles, or at rest from a positive one.
    direction: f64,
    /// Twice the natural angular frequency.
    double_rate: f64,
}

/// What a pendulum does in the long run, by the exact sign of `cos^2(theta/2) - kappa^2`.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{Pendulum, PendulumRegime};
///
/// // Thrown from the bottom the top is just reached with 2 sqrt(g L).
/// let pendulum = Pendulum::new(1.0, 1.0)?;
/// let regime = |velocity| pendulum.motion(0.0, velocity).map(|motion| motion.regime());
/// assert_eq!(regime(2.0)?, PendulumRegime::Separatrix);
/// assert_eq!(regime(2.0_f64.next_up())?, PendulumRegime::Turning);
/// # Ok::<(), vibank_dynamics::vibration::PendulumError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PendulumRegime {
    /// It swings to and fro.
    Swinging,
    /// It runs up towards the top and never reaches it.
    Separatrix,
    /// It turns over and over.
    Turning,
}

/// The three motions, for a start towards positive angles.
#[derive(Clone, Copy, Debug)]
enum MotionType {
    Swing {
        functions: JacobiFunctions,
        clock: Clock,
        modulus: f64,
    },
    Separatrix {
        rate: Dd,
        start: f64,
    },
    Turn {
        functions: JacobiFunctions,
        clock: Clock,
        /// The square root of the energy.
        root: f64,
    },
}

/// The phase of the elliptic functions as a function of time.
#[derive(Clone, Copy, Debug)]
struct Clock {
    rate: Dd,
    start: Start,
}

#[derive(Clone, Copy, Debug)]
enum Start {
    /// A quarter turn: released from rest.
    Quarter,
    At(Dd),
}

impl PendulumMotion {
    pub(crate) fn of(
        pendulum: &Pendulum,
        angle: f64,
        angular_velocity: f64,
    ) -> Result<Self, PendulumError> {
        // Its cube is still within the range of numbers.
        const MAX_RATIO: f64 = 1e100;
        let kappa = reduced_velocity(pendulum, angular_velocity);
        let double_rate = (pendulum.rate() * 2.0).hi();
        let is_moderate = kappa.is_finite() && kappa.hi().abs() <= MAX_RATIO;
        if !(angle.is_finite() && is_moderate && double_rate.is_finite()) {
            return Err(PendulumError::Start {
                angle,
                angular_velocity,
            });
        }
        let (half, turns) = half_angle(angle);
        let direction = if kappa.hi() < 0.0 || kappa.hi() == 0.0 && half.is_negative() {
            -1.0
        } else {
            1.0
        };
        let start = ReducedStart::new(half * direction, kappa * direction);
        let lack = energy_lack(pendulum, start, angular_velocity);
        Ok(Self {
            course: MotionType::of(pendulum.rate(), start, lack),
            turns,
            direction,
            double_rate,
        })
    }

    /// Whether it swings or turns over.
    #[must_use]
    pub fn regime(&self) -> PendulumRegime {
        match self.course {
            MotionType::Swing { .. } => PendulumRegime::Swinging,
            MotionType::Separatrix { .. } => PendulumRegime::Separatrix,
            MotionType::Turn { .. } => PendulumRegime::Turning,
        }
    }

    /// Time of a full swing, or of a full turn, in s; none on the separatrix.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        match &self.course {
            MotionType::Swing { clock, .. } => Some((Dd::TAU / clock.rate).hi()),
            MotionType::Separatrix { .. } => None,
            MotionType::Turn { clock, .. } => Some((Dd::PI / clock.rate).hi()),
        }
    }

    /// Angle at the time `t` in s, in rad; unwrapped, so that a pendulum that turns over counts its turns.
    ///
    /// It is no number where the phase, about `omega0 t`, leaves the range of numbers.
    #[must_use]
    pub fn angle(&self, t: f64) -> f64 {
        let place = self.course.at(t);
        self.turns + self.direction * place.angle(&self.course)
    }

    /// Angular velocity at the time `t` in s, in rad/s.
    #[must_use]
    pub fn angular_velocity(&self, t: f64) -> f64 {
        self.direction * self.double_rate * self.course.at(t).reduced_velocity(&self.course)
    }

    /// Angle in rad and angular velocity in rad/s at the time `t` in s, for the price of one of them.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::Pendulum;
    ///
    /// let motion = Pendulum::new(1.0, 9.81)?.motion(0.0, 7.0)?;
    /// assert_eq!(motion.state(3.0), (motion.angle(3.0), motion.angular_velocity(3.0)));
    /// # Ok::<(), vibank_dynamics::vibration::PendulumError>(())
    /// ```
    #[must_use]
    pub fn state(&self, t: f64) -> (f64, f64) {
        let place = self.course.at(t);
        (
            self.turns + self.direction * place.angle(&self.course),
            self.direction * self.double_rate * place.reduced_velocity(&self.course),
        )
    }
}

/// The elliptic functions at one time, from which angle and velocity are read off.
enum EllipticValues {
    Swing(JacobiValues),
    /// The argument of the hyperbolic functions.
    Separatrix(f64),
    Turn {
        values: JacobiValues,
        phase: Dd,
    },
}

impl MotionType {
    /// The motion of a pendulum of a natural angular frequency.
    fn of(rate: Dd, start: ReducedStart, lack: Dd) -> Self {
        if lack.hi() > 0.0 {
            Self::swing(rate, start, lack)
        } else if lack.hi() < 0.0 {
            Self::turn(rate, start, -lack)
        } else {
            Self::Separatrix {
                rate,
                start: asinh((start.sine / start.cosine).hi()),
            }
        }
    }

    /// `sin(theta/2) = k sn`, `cos(theta/2) = dn`, `kappa = k cn`.
    fn swing(rate: Dd, start: ReducedStart, lack: Dd) -> Self {
        let functions = JacobiFunctions::of(lack);
        let modulus = start.kappa.hypot(start.sine).hi();
        let clock = Clock {
            rate: rate * functions.phase_rate(),
            start: if start.kappa.hi() == 0.0 && start.sine.hi() != 0.0 {
                Start::Quarter
            } else {
                Start::At(functions.phase_rate() * start.swing_argument(modulus))
            },
        };
        Self::Swing {
            functions,
            clock,
            modulus,
        }
    }

    /// `theta/2 = am`, `kappa = sqrt(E) dn`.
    fn turn(rate: Dd, start: ReducedStart, excess: Dd) -> Self {
        let root = start.kappa.hypot(start.sine);
        let functions = JacobiFunctions::of(excess / root.square());
        let slope = (start.kappa / root).hi();
        let cosine = start.cosine.hi();
        let argument = start.sine.hi() * carlson_rf(cosine * cosine, slope * slope, 1.0);
        Self::Turn {
            functions,
            clock: Clock {
                rate: rate * root * functions.phase_rate(),
                start: Start::At(functions.phase_rate() * argument),
            },
            root: root.hi(),
        }
    }

    fn at(&self, t: f64) -> EllipticValues {
        match self {
            Self::Swing {
                functions, clock, ..
            } => EllipticValues::Swing(functions.at(clock.sin_cos(t))),
            Self::Separatrix { rate, start } => {
                EllipticValues::Separatrix((*rate * t + *start).hi())
            }
            Self::Turn {
                functions, clock, ..
            } => {
                let phase = clock.phase(t);
                EllipticValues::Turn {
                    values: functions.at(phase.sin_cos_to_f64()),
                    phase,
                }
            }
        }
    }

    /// The modulus of a swing, the root of the energy of a turn.
    const fn amplitude(&self) -> f64 {
        match self {
            Self::Swing { modulus, .. } => *modulus,
            Self::Separatrix { .. } => 1.0,
            Self::Turn { root, .. } => *root,
        }
    }
}

impl EllipticValues {
    /// The angle of a motion that begins towards positive ones, in rad.
    fn angle(&self, course: &MotionType) -> f64 {
        match self {
            Self::Swing(at) => 2.0 * atan2(course.amplitude() * at.sn, at.dn),
            Self::Separatrix(argument) => 2.0 * atan(sinh(*argument)),
            Self::Turn { values, phase } => {
                (JacobiFunctions::amplitude_of(values, *phase) * 2.0).hi()
            }
        }
    }

    /// theta'/(2 omega0).
    fn reduced_velocity(&self, course: &MotionType) -> f64 {
        match self {
            Self::Swing(at) => course.amplitude() * at.cn,
            Self::Separatrix(argument) => 1.0 / cosh(*argument),
            Self::Turn { values, .. } => course.amplitude() * values.dn,
        }
    }
}

impl Clock {
    fn phase(&self, t: f64) -> Dd {
        let elapsed = self.rate * t;
        match self.start {
            Start::Quarter => elapsed + Dd::FRAC_PI_2,
            Start::At(phase) => elapsed + phase,
        }
    }

    fn sin_cos(&self, t: f64) -> (f64, f64) {
        let elapsed = self.rate * t;
        match self.start {
            Start::Quarter => {
                // The sum with a rounded right angle would leave a trace of velocity at the turning points.
                let (sine, cosine) = elapsed.sin_cos_to_f64();
                (cosine, -sine)
            }
            Start::At(phase) => (elapsed + phase).sin_cos_to_f64(),
        }
    }
}

/// A start: half the angle by its sine and cosine, and the reduced velocity.
#[derive(Clone, Copy)]
struct ReducedStart {
    sine: Dd,
    cosine: Dd,
    kappa: Dd,
}

impl ReducedStart {
    fn new(half: Dd, kappa: Dd) -> Self {
        let (sine, cosine) = half.sin_cos();
        Self {
            sine,
            cosine,
            kappa,
        }
    }

    /// The argument u with `k sn(u) = sin(theta/2)`, between -K and K for a start towards positive angles.
    fn swing_argument(&self, modulus: f64) -> f64 {
        let (sn, cn) = (self.sine.hi() / modulus, self.kappa.hi() / modulus);
        let dn = self.cosine.hi();
        if sn == 0.0 || modulus == 0.0 {
            return 0.0;
        }
        sn * carlson_rf(cn * cn, dn * dn, 1.0)
    }
}

/// theta'/(2 omega0).
fn reduced_velocity(pendulum: &Pendulum, angular_velocity: f64) -> Dd {
    let scaled = scale_by_power_of_two(angular_velocity, -pendulum.exponent - 1);
    Dd::from(scaled) / pendulum.rate
}

/// What the energy lacks to reach the top, `cos^2(theta/2) - kappa^2`, without rounding in what cancels.
fn energy_lack(pendulum: &Pendulum, start: ReducedStart, angular_velocity: f64) -> Dd {
    let (velocity, length, gravity) = scaled(pendulum, angular_velocity);
    let square = Dd::product(velocity, velocity);
    let [first, second] = [
        Dd::product(square.hi(), length),
        Dd::product(square.lo(), length),
    ];
    let top = Dd::from(4.0 * gravity) * start.cosine.square();
    let lack = (top - first.hi()) - first.lo() - second.hi() - second.lo();
    lack / (4.0 * gravity)
}

/// Velocity, length and gravity in units that keep their squares and products within the exponent range.
fn scaled(pendulum: &Pendulum, angular_velocity: f64) -> (f64, f64, f64) {
    let of_length = crate::numerics::binary_exponent(pendulum.length);
    (
        scale_by_power_of_two(angular_velocity, -pendulum.exponent),
        scale_by_power_of_two(pendulum.length, -of_length),
        scale_by_power_of_two(pendulum.gravity, -of_length - 2 * pendulum.exponent),
    )
}

/// Half of the angle less its full turns, and these turns in rad.
fn half_angle(angle: f64) -> (Dd, f64) {
    if angle.abs() <= Dd::PI.hi() {
        return (Dd::from(0.5 * angle), 0.0);
    }
    let (sine, cosine) = Dd::from(0.5 * angle).sin_cos();
    let half = if cosine.is_negative() {
        Dd::atan2(-sine, -cosine)
    } else {
        Dd::atan2(sine, cosine)
    };
    (half, (angle - half * 2.0).hi())
}
