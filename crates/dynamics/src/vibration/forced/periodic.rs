//! Steady response to a periodic force, by superposition of its harmonics.

use std::f64::consts::PI;

use super::frequency_response::FrequencyResponse;
use crate::numerics::{Complex, Dd};
use crate::vibration::oscillator::Oscillator;
use crate::vibration::state::State;

/// One harmonic a cos nΩt + b sin nΩt of a periodic force, in N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Harmonic {
    /// Factor a of the cosine in N.
    pub cosine: f64,
    /// Factor b of the sine in N.
    pub sine: f64,
}

/// A periodic force as a Fourier series,
///
/// ```text
/// F(t) = F0 + Σ (a_n cos nΩt + b_n sin nΩt),   n = 1, 2, ...
/// ```
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::PeriodicForce;
///
/// let force = PeriodicForce::square(3.0, 2.0, 5);
/// assert_eq!(force.harmonics[0].sine, 12.0 / std::f64::consts::PI);
/// assert_eq!(force.harmonics[1].sine, 0.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicForce {
    /// Mean F0 in N.
    pub mean: f64,
    /// Fundamental angular frequency Ω in rad/s.
    pub angular_frequency: f64,
    /// The harmonics n = 1, 2, ...
    pub harmonics: Vec<Harmonic>,
}

impl PeriodicForce {
    /// A square wave between F and -F, F in the first half period.
    pub fn square(amplitude: f64, angular_frequency: f64, harmonics: usize) -> Self {
        Self::of_sines(angular_frequency, harmonics, |n| {
            if n % 2 == 1 {
                4.0 * amplitude / (PI * n as f64)
            } else {
                0.0
            }
        })
    }

    /// A triangular wave between F and -F, zero and rising at time zero.
    pub fn triangle(amplitude: f64, angular_frequency: f64, harmonics: usize) -> Self {
        Self::of_sines(angular_frequency, harmonics, |n| {
            let size = 8.0 * amplitude / (PI * n as f64 * (PI * n as f64));
            match n % 4 {
                1 => size,
                3 => -size,
                _ => 0.0,
            }
        })
    }

    /// A sawtooth that rises from -F to F in each period, zero and rising at time zero.
    pub fn sawtooth(amplitude: f64, angular_frequency: f64, harmonics: usize) -> Self {
        Self::of_sines(angular_frequency, harmonics, |n| {
            let size = 2.0 * amplitude / (PI * n as f64);
            if n % 2 == 1 { size } else { -size }
        })
    }

    /// A force without mean and cosines, from the factors of its sines.
    fn of_sines(angular_frequency: f64, harmonics: usize, factor: impl Fn(usize) -> f64) -> Self {
        Self {
            mean: 0.0,
            angular_frequency,
            harmonics: (1..=harmonics)
                .map(|n| Harmonic {
                    cosine: 0.0,
                    sine: factor(n),
                })
                .collect(),
        }
    }

    /// The force in N at a time in s.
    pub fn at(&self, time: f64) -> f64 {
        let phase = Dd::product(self.angular_frequency, time);
        let harmonics = self.harmonics.iter().enumerate();
        harmonics.fold(self.mean, |sum, (index, harmonic)| {
            let (sine, cosine) = (phase * (index as f64 + 1.0)).sin_cos_to_f64();
            sum + (harmonic.cosine * cosine + harmonic.sine * sine)
        })
    }
}

/// The steady motion of an oscillator under a periodic force, prepared for samples.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::{Oscillator, PeriodicForce, PeriodicResponse};
///
/// let oscillator = Oscillator::new(1.0, 0.4, 25.0)?;
/// let motion = PeriodicResponse::of(&oscillator, &PeriodicForce::square(5.0, 2.0, 31));
/// let half_period = 0.5 * std::f64::consts::PI;
/// assert!((motion.position(0.3) + motion.position(0.3 + half_period)).abs() < 1e-15);
/// # Ok::<(), vibank_dynamics::vibration::OscillatorError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicResponse {
    mean: f64,
    angular_frequency: f64,
    /// Complex amplitudes X_n with x = Σ Re(X_n e^(inΩt)).
    amplitudes: Vec<Complex>,
}

impl PeriodicResponse {
    /// The steady motion; infinite where an undamped oscillator resonates with a harmonic.
    pub fn of(oscillator: &Oscillator, force: &PeriodicForce) -> Self {
        let amplitude = |(index, harmonic): (usize, &Harmonic)| {
            if *harmonic == Harmonic::default() {
                return Complex::ZERO;
            }
            let response =
                FrequencyResponse::at(oscillator, force.angular_frequency * (index as f64 + 1.0));
            response.receptance() * Complex::new(harmonic.cosine, -harmonic.sine)
        };
        Self {
            mean: FrequencyResponse::at(oscillator, 0.0).amplitude(force.mean),
            angular_frequency: force.angular_frequency,
            amplitudes: force.harmonics.iter().enumerate().map(amplitude).collect(),
        }
    }

    /// Mean position in m.
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// Complex amplitudes in m of the harmonics n = 1, 2, ...: their moduli are the amplitudes, their arguments the
    /// phases of the cosines.
    pub fn amplitudes(&self) -> &[Complex] {
        &self.amplitudes
    }

    /// Position in m at a time in s.
    pub fn position(&self, time: f64) -> f64 {
        self.state(time).position
    }

    /// Position in m and velocity in m/s at a time in s.
    pub fn state(&self, time: f64) -> State {
        let phase = Dd::product(self.angular_frequency, time);
        let mut position = self.mean;
        let mut velocity = 0.0;
        for (index, amplitude) in self.amplitudes.iter().enumerate() {
            let order = index as f64 + 1.0;
            if *amplitude == Complex::ZERO {
                continue;
            }
            let (sine, cosine) = (phase * order).sin_cos_to_f64();
            position += amplitude.re * cosine - amplitude.im * sine;
            velocity -=
                order * self.angular_frequency * (amplitude.re * sine + amplitude.im * cosine);
        }
        State { position, velocity }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_approach_their_waves() {
        let quarter = 0.25;
        for (force, expected) in [
            (PeriodicForce::square(2.0, PI, 4001), 2.0),
            (PeriodicForce::triangle(2.0, PI, 401), 1.0),
            (PeriodicForce::sawtooth(2.0, PI, 4001), 0.5),
        ] {
            assert!(
                (force.at(quarter) - expected).abs() < 2e-3,
                "{}",
                force.at(quarter)
            );
        }
    }

    #[test]
    fn the_steady_motion_obeys_its_equation() {
        let oscillator = Oscillator::new(2.0, 0.7, 30.0).unwrap();
        let force = PeriodicForce {
            mean: 3.0,
            ..PeriodicForce::triangle(5.0, 1.7, 9)
        };
        let motion = PeriodicResponse::of(&oscillator, &force);
        for t in [0.1, 0.9, 2.7, 1e6] {
            let (before, state, after) = (
                motion.state(t - 1e-4),
                motion.state(t),
                motion.state(t + 1e-4),
            );
            let acceleration = (after.velocity - before.velocity) / 2e-4;
            let sum = 2.0 * acceleration + 0.7 * state.velocity + 30.0 * state.position;
            assert!((sum - force.at(t)).abs() < 1e-5, "{t}");
        }
    }
}
