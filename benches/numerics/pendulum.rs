//! The pendulum: period and its excess against the amplitude, motion against the distance to the separatrix.

use differential_equations::prelude::*;
use vibank::numerics::{agm, asin, cos, sin};
use vibank::vibration::Pendulum;

use crate::record::Record;
use crate::reference::Case;

fn pendulum() -> Pendulum {
    Pendulum::new(1.0, 1.0).expect("the pendulum is sound")
}

/// The first five terms of the series in the amplitude.
fn series(amplitude: f64) -> f64 {
    const TERMS: [f64; 5] = [
        1.0,
        1.0 / 16.0,
        11.0 / 3072.0,
        173.0 / 737_280.0,
        22_931.0 / 1_321_205_760.0,
    ];
    let square = amplitude * amplitude;
    TERMS
        .iter()
        .rev()
        .fold(0.0, |sum, term| sum * square + term)
}

/// The mean of 1 and √(1 - k²), with the modulus k = sin(θ0/2).
fn by_modulus(amplitude: f64) -> f64 {
    let modulus = sin(amplitude / 2.0);
    1.0 / agm(1.0, (1.0 - modulus * modulus).sqrt())
}

fn by_cosine(amplitude: f64) -> f64 {
    1.0 / agm(1.0, cos(amplitude / 2.0))
}

/// Period of a swing of a given amplitude.
pub(crate) fn period(records: &mut Vec<Record>) {
    for case in Case::of("pendulum-period") {
        let amplitude = case.number("theta0");
        let (pendulum, turn) = (pendulum(), std::f64::consts::TAU);
        records.push(case.solution("vibank", || {
            [pendulum.period(amplitude).unwrap_or(f64::NAN)]
        }));
        records.push(case.solution("series of five terms", || [turn * series(amplitude)]));
        records.push(case.solution("mean, by the modulus", || [turn * by_modulus(amplitude)]));
        records.push(case.solution("mean, by the cosine", || [turn * by_cosine(amplitude)]));
    }
}

/// By which part the period exceeds that of small swings.
pub(crate) fn excess(records: &mut Vec<Record>) {
    for case in Case::of("pendulum-excess") {
        let amplitude = case.number("theta0");
        let pendulum = pendulum();
        records.push(case.solution("vibank", || {
            [pendulum.period_excess(amplitude).unwrap_or(f64::NAN)]
        }));
        records.push(case.solution("mean less one", || [by_cosine(amplitude) - 1.0]));
    }
}

/// `θ'' = -sin θ`.
struct Equation;

impl ODE<f64, [f64; 2]> for Equation {
    fn diff(&self, _time: f64, state: &[f64; 2], rate: &mut [f64; 2]) {
        rate[0] = state[1];
        rate[1] = -sin(state[0]);
    }
}

/// A swing from the bottom by `2 asin(k sn)`, with sn from the means of 1 and √(1 - k²) (Abramowitz and Stegun, 16.4).
struct Textbook {
    modulus: f64,
    means: Vec<f64>,
    ratios: Vec<f64>,
}

impl Textbook {
    fn new(velocity: f64) -> Self {
        let modulus = velocity / 2.0;
        let (mut a, mut b) = (1.0, (1.0 - modulus * modulus).sqrt());
        let (mut means, mut ratios) = (Vec::new(), Vec::new());
        loop {
            let difference = 0.5 * (a - b);
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            means.push(a);
            ratios.push(difference / a);
            if difference.abs() <= 1e-16 {
                break;
            }
        }
        Self {
            modulus,
            means,
            ratios,
        }
    }

    fn angle(&self, time: f64) -> f64 {
        let last = self.means.last().copied().unwrap_or(1.0);
        let twice = (1_u64 << self.means.len()) as f64;
        let phase = self
            .ratios
            .iter()
            .rev()
            .fold(twice * last * time, |phase, ratio| {
                0.5 * (phase + asin(ratio * sin(phase)))
            });
        2.0 * asin(self.modulus * sin(phase))
    }
}

/// The angle of a pendulum thrown from the bottom, close to and far from the separatrix.
pub(crate) fn motion(records: &mut Vec<Record>) {
    for case in Case::of("pendulum-motion") {
        let velocity = case.number("w");
        let motion = pendulum()
            .motion(0.0, velocity)
            .expect("the motion is sound");
        records.push(case.samples("vibank", |i| motion.angle(case.at[i])));
        if velocity < 2.0 {
            let textbook = Textbook::new(velocity);
            records.push(case.samples("2 asin(k sn)", |i| textbook.angle(case.at[i])));
        }
        records.extend(case.integrated(&Equation, [0.0, velocity]));
    }
}
