//! Resonance, half-power cut-offs and bandwidth.
//!
//! Differences of squares are formed in double-double before the root, and bandwidths as a product over a sum instead of
//! a difference of cut-offs, so that lightly damped resonances keep their width.
//!
//! ```text
//! n2 = 2 m k - c²,   s = √(4 m k - c²),   h = √(4 m k + c²)
//! ```

use super::oscillator::{Oscillator, Scaled};
use super::power_of_two::PowerOfTwo;
use crate::numerics::Dd;

/// Resonance of the displacement under a force of constant amplitude; there is one below ζ = 1/√2.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{DisplacementResonance, Oscillator};
///
/// let oscillator = Oscillator::new(1.0, 0.2, 1.0)?;
/// let resonance = DisplacementResonance::of(&oscillator).unwrap();
/// assert_eq!(resonance.angular_frequency(), 0.98_f64.sqrt());
/// assert!((resonance.bandwidth().unwrap() / 0.2 - 1.0104).abs() < 1e-4);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DisplacementResonance {
    scaled: Scaled,
    /// 2 m k - c².
    excess: Dd,
    /// c √(4 m k - c²).
    width: Dd,
}

impl DisplacementResonance {
    /// The resonance of an oscillator; none if ζ is 1/√2 or more, by the exact sign of 2 m k - c².
    pub fn of(oscillator: &Oscillator) -> Option<Self> {
        // In scaled units 2 m k is less than 16, so that there is no resonance long before; larger squares may
        // overflow.
        const LARGE: f64 = 1e30;
        let scaled = *oscillator.scaled();
        if scaled.damping > LARGE {
            return None;
        }
        let square = Dd::product(scaled.damping, scaled.damping);
        let excess = Dd::product(2.0 * scaled.mass, scaled.stiffness) - square;
        (excess > Dd::ZERO).then(|| Self {
            scaled,
            excess,
            width: scaled.root() * scaled.damping,
        })
    }

    /// Angular frequency of the largest amplitude, √n2/(√2 m), in rad/s.
    pub fn angular_frequency(&self) -> f64 {
        self.scaled.rate(self.frequency_of(self.excess).hi())
    }

    /// Largest amplitude over the displacement under a constant force, 2 m k/(c s); none without damping.
    pub fn peak_gain(&self) -> Option<f64> {
        let product = Dd::product(2.0 * self.scaled.mass, self.scaled.stiffness);
        (self.width > Dd::ZERO).then(|| (product / self.width).hi())
    }

    /// Angular frequency below the resonance at which the power is half of the largest, √(n2 - c s)/(√2 m), in rad/s.
    ///
    /// There is one below ζ = sin(π/8) = 0.3827.
    pub fn lower_cut_off(&self) -> Option<f64> {
        self.lower()
            .map(|frequency| self.scaled.rate(frequency.hi()))
    }

    /// Angular frequency above the resonance at which the power is half of the largest, √(n2 + c s)/(√2 m), in rad/s.
    pub fn upper_cut_off(&self) -> f64 {
        self.scaled.rate(self.upper().hi())
    }

    /// Distance of the cut-offs, c s/(m² (ω1 + ω2)), in rad/s; none where the lower one is missing.
    pub fn bandwidth(&self) -> Option<f64> {
        let mass = self.scaled.mass;
        self.lower().map(|lower| {
            self.scaled
                .rate((self.width / mass / mass / (lower + self.upper())).hi())
        })
    }

    fn lower(&self) -> Option<Dd> {
        (self.excess > self.width).then(|| self.frequency_of(self.excess - self.width))
    }

    fn upper(&self) -> Dd {
        self.frequency_of(self.excess + self.width)
    }

    /// √(square/2)/m.
    fn frequency_of(&self, square: Dd) -> Dd {
        (square * 0.5).sqrt() / self.scaled.mass
    }
}

/// Resonance of the velocity, where the power is largest: at the natural frequency, for any damping.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{Oscillator, VelocityResonance};
///
/// let resonance = VelocityResonance::of(&Oscillator::new(2.0, 3.0, 8.0)?);
/// assert_eq!(resonance.angular_frequency(), 2.0);
/// assert_eq!(resonance.bandwidth(), 1.5);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct VelocityResonance {
    scaled: Scaled,
}

impl VelocityResonance {
    /// The resonance of an oscillator.
    pub const fn of(oscillator: &Oscillator) -> Self {
        Self {
            scaled: *oscillator.scaled(),
        }
    }

    /// Angular frequency of the largest velocity, the natural one, in rad/s.
    pub fn angular_frequency(&self) -> f64 {
        self.scaled.rate(self.scaled.natural_frequency().hi())
    }

    /// Angular frequency below the resonance at which the power is half of the largest, 2 k/(h + c), in rad/s.
    pub fn lower_cut_off(&self) -> f64 {
        self.scaled
            .rate((Dd::from(2.0 * self.scaled.stiffness) / self.sum()).hi())
    }

    /// Angular frequency above the resonance at which the power is half of the largest, (h + c)/(2 m), in rad/s.
    pub fn upper_cut_off(&self) -> f64 {
        self.scaled
            .rate((self.sum() / (2.0 * self.scaled.mass)).hi())
    }

    /// Distance of the cut-offs, exactly c/m = 2 λ, in rad/s.
    pub fn bandwidth(&self) -> f64 {
        PowerOfTwo::new(self.scaled.rate_exponent).apply(self.scaled.damping / self.scaled.mass)
    }

    /// h + c.
    fn sum(&self) -> Dd {
        let root = (Dd::product(4.0 * self.scaled.mass, self.scaled.stiffness).sqrt())
            .hypot(Dd::from(self.scaled.damping));
        root + self.scaled.damping
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::FrequencyResponse;

    fn oscillator(damping_ratio: f64) -> Oscillator {
        Oscillator::new(1.0, 2.0 * damping_ratio, 1.0).unwrap()
    }

    #[test]
    fn cut_offs_exist_below_their_thresholds() {
        let eighth = crate::numerics::sin(std::f64::consts::FRAC_PI_8);
        assert!(
            DisplacementResonance::of(&oscillator(eighth - 1e-10))
                .unwrap()
                .lower_cut_off()
                .is_some()
        );
        assert!(
            DisplacementResonance::of(&oscillator(eighth + 1e-10))
                .unwrap()
                .lower_cut_off()
                .is_none()
        );
        let half = std::f64::consts::FRAC_1_SQRT_2;
        assert!(DisplacementResonance::of(&oscillator(half - 1e-10)).is_some());
        assert!(DisplacementResonance::of(&oscillator(half + 1e-10)).is_none());
    }

    #[test]
    fn cut_offs_halve_the_power() {
        let oscillator = Oscillator::new(3.0, 0.8, 40.0).unwrap();
        let displacement = DisplacementResonance::of(&oscillator).unwrap();
        let amplitude =
            |frequency: f64| FrequencyResponse::at(&oscillator, frequency).amplitude(1.0);
        let peak = amplitude(displacement.angular_frequency());
        assert!((peak * 40.0 - displacement.peak_gain().unwrap()).abs() < 1e-13);
        for cut_off in [
            displacement.lower_cut_off().unwrap(),
            displacement.upper_cut_off(),
        ] {
            assert!((amplitude(cut_off) / peak - std::f64::consts::FRAC_1_SQRT_2).abs() < 1e-14);
        }
        let velocity = VelocityResonance::of(&oscillator);
        let power = |frequency: f64| FrequencyResponse::at(&oscillator, frequency).mean_power(1.0);
        for cut_off in [velocity.lower_cut_off(), velocity.upper_cut_off()] {
            assert!((power(cut_off) / power(velocity.angular_frequency()) - 0.5).abs() < 1e-14);
        }
    }

    #[test]
    fn an_undamped_oscillator_has_an_infinite_peak_without_width() {
        let resonance = DisplacementResonance::of(&oscillator(0.0)).unwrap();
        assert_eq!(resonance.peak_gain(), None);
        assert_eq!(resonance.bandwidth(), Some(0.0));
        assert_eq!(resonance.lower_cut_off(), Some(1.0));
    }
}
