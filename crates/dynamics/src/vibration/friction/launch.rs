//! The first slide of a mass that starts with a velocity.

use super::scale::{Scale, is_decided};
use crate::numerics::Dd;
use crate::vibration::oscillator::Regime;

/// A slide up to its turning point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Launch {
    duration: Duration,
    /// How far beyond the centre of the slide it turns, in the direction of the velocity.
    pub(crate) overshoot: Dd,
}

/// How long the slide takes, in units of the scale.
#[derive(Clone, Copy, Debug)]
enum Duration {
    Known(Dd),
    /// `atan2(across, along)/omega_d`, for those who ask.
    Angle {
        across: Dd,
        along: Dd,
    },
}

impl Launch {
    /// The slide from a distance `y` beyond its centre with a speed `w`, both counted in the direction of motion.
    ///
    /// None if it never turns: an overdamped mass on its way to the centre.
    pub(crate) fn of(scale: &Scale, y: Dd, w: Dd) -> Option<Self> {
        match scale.regime {
            Regime::Undamped | Regime::Underdamped => Some(Self::oscillating(scale, y, w)),
            Regime::Critical => Self::critical(scale, y, w),
            Regime::Overdamped => Self::overdamped(scale, y, w),
        }
    }

    /// ```text
    /// t1 = atan2(w s, 2 k y + c w)/omega_d,   y1 = e^(-lambda t1) hypot(w s, 2 k y + c w)/(2 k)
    /// ```
    fn oscillating(scale: &Scale, y: Dd, w: Dd) -> Self {
        let across = w * scale.root;
        let along = scale.stiffness * y * 2.0 + scale.damping * w;
        let amplitude = across.hypot(along) / (scale.stiffness * 2.0);
        // Without damping the turning point does not depend on the time, whose inverse tangent is the dearest
        // part.
        if scale.regime == Regime::Undamped {
            return Self {
                duration: Duration::Angle { across, along },
                overshoot: amplitude,
            };
        }
        let duration = time_of_angle(scale, across, along);
        Self {
            duration: Duration::Known(duration),
            overshoot: (-decay_rate(scale) * duration).exp() * amplitude,
        }
    }

    /// How long it takes, in units of the scale.
    pub(crate) fn duration(&self, scale: &Scale) -> Dd {
        match self.duration {
            Duration::Known(duration) => duration,
            Duration::Angle { across, along } => time_of_angle(scale, across, along),
        }
    }

    /// ```text
    /// t1 = w/(lambda (w + lambda y)),   y1 = e^(-lambda t1) (y + w/lambda)
    /// ```
    fn critical(scale: &Scale, y: Dd, w: Dd) -> Option<Self> {
        let rate = decay_rate(scale);
        slope(w, rate * y).map(|slope| {
            let exponent = w / slope;
            Self {
                duration: Duration::Known(exponent / rate),
                overshoot: (-exponent).exp() * (slope / rate),
            }
        })
    }

    /// With the roots `r_s` and `r_f`, written so that they may come close:
    ///
    /// ```text
    /// e^((r_s - r_f) t1) = 1 + w (r_f - r_s)/(r_s (w - r_f y))
    /// y1 = (w - r_f y) e^(r_s t1)/(-r_f)
    /// ```
    fn overdamped(scale: &Scale, y: Dd, w: Dd) -> Option<Self> {
        let sum = scale.root + scale.damping;
        let (slow, fast) = (scale.stiffness * 2.0 / sum, sum / (scale.mass * 2.0));
        let gap = scale.root / scale.mass;
        slope(w, fast * y).map(|slope| {
            let duration = (w * gap / (slow * slope)).ln_1p() / gap;
            Self {
                duration: Duration::Known(duration),
                overshoot: (-slow * duration).exp() * (slope / fast),
            }
        })
    }
}

/// The time in which the phase of an oscillation advances by the angle of a point.
fn time_of_angle(scale: &Scale, across: Dd, along: Dd) -> Dd {
    Dd::atan2(across, along) * scale.mass * 2.0 / scale.root
}

/// The speed less that of a motion by the fast root alone, which never turns; none unless it is positive.
fn slope(speed: Dd, of_fast_root: Dd) -> Option<Dd> {
    let slope = speed + of_fast_root;
    (slope.hi() > 0.0 && is_decided(slope, speed.hi())).then_some(slope)
}

fn decay_rate(scale: &Scale) -> Dd {
    scale.damping / (scale.mass * 2.0)
}
