//! The steady state at one angular frequency.

use crate::numerics::{
    Complex, Dd, atan2, binary_exponent, scale_by_power_of_two, two_prod, two_sum,
};
use crate::vibration::oscillator::{Oscillator, Scaled};

/// Response of an oscillator to excitation at one angular frequency Ω, per unit of excitation.
///
/// ```text
/// m x'' + c x' + k x = F cos Ωt,   x = X cos(Ωt - φ)
/// R = k - m Ω²,  I = c Ω,  X = F/√(R² + I²),  tan φ = I/R
/// ```
///
/// R is formed without rounding, so amplitudes keep two units in the last place and lags three at any distance from
/// resonance. At the resonance of an undamped oscillator amplitudes are infinite and the lag is that of the limit from
/// below, zero.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{FrequencyResponse, Oscillator};
///
/// let oscillator = Oscillator::new(1.0, 0.5, 4.0)?;
/// let at_resonance = FrequencyResponse::at(&oscillator, 2.0);
/// assert_eq!(at_resonance.amplitude(3.0), 3.0);
/// assert_eq!(at_resonance.phase_lag(), std::f64::consts::FRAC_PI_2);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
///
/// # References
///
/// W. Kahan, On the cost of floating-point computation without extra-precise arithmetic (2004).
#[derive(Clone, Copy, Debug)]
pub struct FrequencyResponse {
    scaled: Scaled,
    frequency: f64,
    /// R = k - m Ω².
    residual: Dd,
    /// I = c Ω.
    loss: Dd,
}

impl FrequencyResponse {
    /// The response at an angular frequency in rad/s; its sign does not count.
    #[inline]
    pub fn at(oscillator: &Oscillator, angular_frequency: f64) -> Self {
        let scaled = Scaled::driven(oscillator, angular_frequency);
        let frequency = scaled.scaled_rate(angular_frequency.abs());
        let residual = residual_stiffness(scaled.mass, scaled.stiffness, frequency);
        let loss = Dd::product(scaled.damping, frequency);
        Self {
            scaled,
            frequency,
            residual,
            loss,
        }
    }

    /// The response of a mode whose mass is the unit, and whose damping and stiffness have thirty digits in scaled units.
    pub(crate) fn of_mode(self, damping: Dd, stiffness: Dd) -> Self {
        Self {
            residual: stiffness - Dd::product(self.frequency, self.frequency),
            loss: damping * self.frequency,
            ..self
        }
    }

    /// √(R² + I²).
    fn modulus(&self) -> Dd {
        self.residual.hypot(self.loss)
    }

    /// Whether an undamped oscillator is driven at its natural frequency, so that no steady state exists.
    pub fn is_unbounded(&self) -> bool {
        self.residual == Dd::ZERO && self.loss == Dd::ZERO
    }

    /// Amplitude X in m of the displacement under a force of this amplitude in N.
    #[inline]
    pub fn amplitude(&self, force: f64) -> f64 {
        self.ratio(force, 1.0, -self.stiffness_exponent())
    }

    /// Lag φ of the displacement after the force in rad, in [0, π].
    pub fn phase_lag(&self) -> f64 {
        atan2(self.loss.hi(), self.residual.hi())
    }

    /// Mean power c (Ω X)²/2 in W that a force of this amplitude in N feeds into the damper.
    pub fn mean_power(&self, force: f64) -> f64 {
        let exponent = finite_exponent(force);
        let speed =
            Dd::from(scale_by_power_of_two(force, -exponent)) * self.frequency / self.modulus();
        let power = if self.loss == Dd::ZERO {
            Dd::ZERO
        } else {
            speed * (0.5 * self.scaled.damping) * speed
        };
        scale_by_power_of_two(
            power.hi(),
            2 * exponent - self.scaled.mass_exponent - self.scaled.rate_exponent,
        )
    }

    /// Magnification factor X k/F: the amplitude over the displacement under a constant force of the same size.
    pub fn magnification_factor(&self) -> f64 {
        self.ratio(1.0, self.scaled.stiffness, 0)
    }

    /// Transmissibility √(k² + I²)/√(R² + I²): force on the ground over force on the mass, or motion of the mass over
    /// motion of its base.
    pub fn transmissibility(&self) -> f64 {
        let passed_on = Dd::from(self.scaled.stiffness).hypot(self.loss);
        self.ratio(1.0, passed_on.hi(), 0)
    }

    /// Lag in rad of the mass behind a moving base, or of the force on the ground behind the force on the mass, in [0, π].
    pub fn transmission_lag(&self) -> f64 {
        let inertia = Dd::product(self.frequency, self.frequency) * self.scaled.mass;
        atan2(
            (self.loss * inertia).hi(),
            (self.residual * self.scaled.stiffness + self.loss.square()).hi(),
        )
    }

    /// Amplitude in m of the motion relative to a base that moves with this amplitude in m.
    pub fn relative_amplitude(&self, base: f64) -> f64 {
        let inertia = Dd::product(self.frequency, self.frequency) * self.scaled.mass;
        self.ratio(base, inertia.hi(), 0)
    }

    /// Amplitude in m under a rotating unbalance, mass times eccentricity, in kg·m.
    pub fn unbalance_amplitude(&self, unbalance: f64) -> f64 {
        self.ratio(
            unbalance,
            self.frequency * self.frequency,
            -self.scaled.mass_exponent,
        )
    }

    /// Receptance x/F in m/N.
    pub fn receptance(&self) -> Complex {
        self.per_unit_force().scale(-self.stiffness_exponent())
    }

    /// Mobility v/F in m/(N·s).
    pub fn mobility(&self) -> Complex {
        let exponent = self.scaled.mass_exponent + self.scaled.rate_exponent;
        (self.per_unit_force() * self.frequency)
            .times_i()
            .scale(-exponent)
    }

    /// Accelerance a/F in 1/kg.
    pub fn accelerance(&self) -> Complex {
        -(self.per_unit_force() * self.frequency * self.frequency).scale(-self.scaled.mass_exponent)
    }

    /// Mechanical impedance F/v in N·s/m, or electrical impedance in Ω for a circuit,
    ///
    /// ```text
    /// Z = c + i (m Ω - k/Ω)
    /// ```
    pub fn impedance(&self) -> Complex {
        let reactance = (-self.residual / self.frequency).hi();
        let exponent = self.scaled.mass_exponent + self.scaled.rate_exponent;
        Complex::new(self.scaled.damping, reactance).scale(exponent)
    }

    /// Cosine and sine of the lag.
    pub(crate) fn direction(&self) -> (f64, f64) {
        if self.is_unbounded() {
            return (1.0, 0.0);
        }
        let modulus = self.modulus().hi();
        (self.residual.hi() / modulus, self.loss.hi() / modulus)
    }

    /// Exponent of the unit of stiffness.
    #[inline]
    fn stiffness_exponent(&self) -> i32 {
        self.scaled.mass_exponent + 2 * self.scaled.rate_exponent
    }

    /// number * factor/√(R² + I²) * 2^exponent.
    #[inline]
    fn ratio(&self, number: f64, factor: f64, exponent: i32) -> f64 {
        if number == 0.0 {
            return 0.0;
        }
        let own = finite_exponent(number);
        let mantissa = scale_by_power_of_two(number, -own);
        scale_by_power_of_two(self.over_modulus(factor * mantissa), own + exponent)
    }

    /// number/√(R² + I²), rounded once.
    fn over_modulus(&self, number: f64) -> f64 {
        const ORDINARY: std::ops::Range<f64> = 1e-140..1e140;
        let (residual, residual_rest) = square(self.residual);
        let (loss, loss_rest) = square(self.loss);
        let (square, rest) = two_sum(residual, loss);
        if !(ORDINARY.contains(&square) && number.is_finite()) {
            return (Dd::from(number) / self.modulus()).hi();
        }
        let root = square.sqrt();
        let reciprocal = 1.0 / root;
        let (product, error) = two_prod(root, root);
        let rest = rest + (residual_rest + loss_rest);
        let beyond = 0.5 * reciprocal * ((square - product) - error + rest);
        let quotient = number * reciprocal;
        let (back, error) = two_prod(quotient, root);
        quotient + reciprocal * ((number - back) - error - quotient * beyond)
    }

    /// 1/(R + i I) in scaled units.
    fn per_unit_force(&self) -> Complex {
        let (cosine, sine) = self.direction();
        let gain = self.over_modulus(1.0);
        Complex::new(gain * cosine, -gain * sine)
    }
}

/// The square of a number as a rounded one and what that leaves.
#[inline]
fn square(x: Dd) -> (f64, f64) {
    let (square, error) = two_prod(x.hi(), x.hi());
    (square, error + 2.0 * x.hi() * x.lo())
}

/// Exponent of a number's leading bit; zero for zero and for what is not a number.
#[inline]
fn finite_exponent(x: f64) -> i32 {
    match binary_exponent(x) {
        i32::MIN | i32::MAX => 0,
        exponent => exponent,
    }
}

/// k - m Ω² to the last digits of a double-double: where it is a small difference, the product is kept in four parts.
#[inline]
pub(crate) fn residual_stiffness(mass: f64, stiffness: f64, frequency: f64) -> Dd {
    // Where fewer than three digits cancel, low parts that are rounded to binary64 leave 29 of 32 digits.
    const CANCELLED: f64 = 1e-3;
    let square = Dd::product(frequency, frequency);
    let leading = Dd::product(mass, square.hi());
    let (high, low) = two_sum(stiffness, -leading.hi());
    if high.abs() > CANCELLED * stiffness {
        return Dd::sum(high, low - leading.lo() - mass * square.lo());
    }
    let trailing = Dd::product(mass, square.lo());
    let difference = Dd::sum(stiffness, -leading.hi());
    difference + Dd::sum(-leading.lo(), -trailing.hi()) - trailing.lo()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn response(m: f64, c: f64, k: f64, angular_frequency: f64) -> FrequencyResponse {
        FrequencyResponse::at(&Oscillator::new(m, c, k).unwrap(), angular_frequency)
    }

    #[test]
    fn low_and_high_frequencies_have_their_limits() {
        let slow = response(2.0, 3.0, 5.0, 1e-200);
        assert_eq!(slow.amplitude(10.0), 2.0);
        assert!((slow.phase_lag() / 6e-201 - 1.0).abs() < 4e-16);
        let fast = response(2.0, 3.0, 5.0, 1e100);
        assert!((fast.amplitude(10.0) / 5e-200 - 1.0).abs() < 4e-16);
        assert_eq!(fast.phase_lag(), PI);
        assert!((fast.relative_amplitude(0.1) - 0.1).abs() < 1e-16);
        assert!((fast.accelerance().re - 0.5).abs() < 1e-16);
    }

    #[test]
    fn undamped_resonance_is_infinite_and_lossless() {
        let resonance = response(1.0, 0.0, 4.0, 2.0);
        assert_eq!(resonance.amplitude(1.0), f64::INFINITY);
        assert_eq!(resonance.amplitude(0.0), 0.0);
        assert_eq!(resonance.mean_power(1.0), 0.0);
        assert_eq!(response(1.0, 0.0, 4.0, 3.0).phase_lag(), PI);
    }

    #[test]
    fn impedance_receptance_and_mobility_agree() {
        let at = response(2.0, 0.7, 30.0, 3.0);
        let mobility = at.mobility() * at.impedance();
        assert!((mobility - Complex::ONE).abs() < 4e-16);
        assert!((at.receptance().abs() - at.amplitude(1.0)).abs() < 1e-17);
        assert!((at.receptance().times_i() * 3.0 - at.mobility()).abs() < 1e-16);
        assert!((at.mean_power(2.0) - 0.5 * 4.0 * at.mobility().re).abs() < 1e-15);
    }

    #[test]
    fn transmissibility_is_the_modulus_of_the_transfer() {
        let at = response(2.0, 0.7, 30.0, 3.0);
        let transfer = Complex::new(30.0, 2.1) * at.receptance();
        assert!((transfer.abs() - at.transmissibility()).abs() < 4e-16);
        assert!((transfer.argument() + at.transmission_lag()).abs() < 4e-16);
    }
}
