//! One degree of freedom: free motion in all regimes, the total response near resonance, the steady state.

use differential_equations::prelude::*;
use vibank::numerics::{Dd, cos, exp, hypot, sin};
use vibank::vibration::{
    ForcedResponse, FreeResponse, FrequencyResponse, HarmonicForce, Oscillator, State as Motion,
};

use crate::integrate::ladder;
use crate::measure::time;
use crate::record::Record;

const SAMPLES: usize = 201;

/// Unit mass and stiffness, damping, and a cosine force of 1 N.
struct Equation {
    damping: f64,
    force: Option<f64>,
}

impl ODE<f64, [f64; 2]> for Equation {
    fn diff(&self, time: f64, state: &[f64; 2], rate: &mut [f64; 2]) {
        let force = self.force.map_or(0.0, |frequency| cos(frequency * time));
        rate[0] = state[1];
        rate[1] = force - self.damping * state[1] - state[0];
    }
}

/// Times with a step that is a whole number of eighths.
fn times(step: f64) -> Vec<f64> {
    (0..SAMPLES).map(|i| step * i as f64).collect()
}

fn error(values: &[f64], exact: &[f64]) -> f64 {
    let scale = exact.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
    let difference = values.iter().zip(exact).map(|(x, y)| (x - y).abs());
    difference
        .map(|x| if x.is_nan() { scale } else { x })
        .fold(0.0, f64::max)
        / scale
}

/// Adds a method that yields all samples at once, or costs one sample an item.
fn add(
    records: &mut Vec<Record>,
    (task, case, method): (&'static str, &str, &'static str),
    exact: &[f64],
    solve: &dyn Fn() -> Vec<f64>,
    sample: Option<&dyn Fn(usize) -> f64>,
) {
    let error = error(&solve(), exact);
    let timing = match sample {
        Some(sample) => time(|item| sample(item % SAMPLES)),
        None => time(|_| solve()).over(SAMPLES),
    };
    records.push(Record {
        task,
        case: case.to_owned(),
        method,
        tolerance: None,
        timing,
        relative_error: error,
        scaled_error: error,
    });
}

/// Free motion from a displacement of 1 m, by the formulas of the regimes in double-double arithmetic.
fn exact_free(damping: f64, time: f64) -> f64 {
    let half = Dd::from(damping) * 0.5;
    let difference = Dd::ONE - half.square();
    let root = difference.abs().sqrt();
    let decay = (-half * time).exp();
    if difference == Dd::ZERO {
        return (decay * (half * time + 1.0)).hi();
    }
    let (even, odd) = if difference.is_negative() {
        ((root * time).cosh(), (root * time).sinh())
    } else {
        ((root * time).cos(), (root * time).sin())
    };
    (decay * (even + half / root * odd)).hi()
}

/// The same as it stands in textbooks.
fn textbook_free(damping: f64, time: f64) -> f64 {
    let ratio = damping / 2.0;
    if ratio < 1.0 {
        let frequency = (1.0 - ratio * ratio).sqrt();
        exp(-ratio * time) * (cos(frequency * time) + ratio / frequency * sin(frequency * time))
    } else if ratio == 1.0 {
        exp(-time) * (1.0 + time)
    } else {
        let root = (ratio * ratio - 1.0).sqrt();
        let (slow, fast) = (-ratio + root, -ratio - root);
        (slow * exp(fast * time) - fast * exp(slow * time)) / (slow - fast)
    }
}

/// Damping ratios from none to strong, with the neighbours of the critical one.
pub(crate) fn free(records: &mut Vec<Record>) {
    const TASK: &str = "free-response";
    let cases = [
        ("undamped", 0.0),
        ("underdamped", 0.1),
        ("zeta=1-1e-9", 2.0 - 2e-9),
        ("critical", 2.0),
        ("zeta=1+1e-9", 2.0 + 2e-9),
        ("overdamped", 20.0),
    ];
    for (case, damping) in cases {
        let times = times(0.125);
        let exact: Vec<f64> = times
            .iter()
            .map(|&time| exact_free(damping, time))
            .collect();
        let oscillator = Oscillator::new(1.0, damping, 1.0).expect("the oscillator is sound");
        let start = Motion {
            position: 1.0,
            velocity: 0.0,
        };
        let motion = FreeResponse::of(&oscillator, start);
        let all = || times.iter().map(|&time| motion.position(time)).collect();
        add(
            records,
            (TASK, case, "vibank"),
            &exact,
            &all,
            Some(&|i| motion.position(times[i])),
        );
        let grid = || {
            let mut positions = vec![0.0; SAMPLES];
            motion.positions(0.0, 0.125, &mut positions);
            positions
        };
        add(
            records,
            (TASK, case, "vibank (uniform grid)"),
            &exact,
            &grid,
            None,
        );
        let textbook = || {
            times
                .iter()
                .map(|&time| textbook_free(damping, time))
                .collect()
        };
        let sample = |i: usize| textbook_free(damping, times[i]);
        add(
            records,
            (TASK, case, "textbook formula"),
            &exact,
            &textbook,
            Some(&sample),
        );
        let equation = Equation {
            damping,
            force: None,
        };
        integrators(records, (TASK, case), &equation, [1.0, 0.0], &times, &exact);
    }
}

/// Integrators, whose time is that of a sample and whose error is that at the last time, where no interpolation enters.
fn integrators(
    records: &mut Vec<Record>,
    place: (&'static str, &str),
    equation: &Equation,
    start: [f64; 2],
    times: &[f64],
    exact: &[f64],
) {
    let first = records.len();
    ladder(records, place, equation, start, times, |states| {
        let scale = exact.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
        (states[SAMPLES - 1][0] - exact[SAMPLES - 1]).abs() / scale
    });
    for record in &mut records[first..] {
        record.timing = record.timing.over(SAMPLES);
    }
}

/// From rest under `cos Ωt`: `(cos Ωt - cos t)/(1 - Ω²)`, or `t sin(t)/2` at resonance, in double-double arithmetic.
fn exact_forced(frequency: f64, time: f64) -> f64 {
    let difference = Dd::ONE - Dd::product(frequency, frequency);
    if difference == Dd::ZERO {
        return (Dd::from(time).sin() * time * 0.5).hi();
    }
    let cosines = Dd::product(frequency, time).cos() - Dd::from(time).cos();
    (cosines / difference).hi()
}

/// The same as it stands in textbooks.
fn textbook_forced(frequency: f64, time: f64) -> f64 {
    if frequency == 1.0 {
        time * sin(time) / 2.0
    } else {
        (cos(frequency * time) - cos(time)) / (1.0 - frequency * frequency)
    }
}

/// The undamped oscillator from rest, off, near and at resonance.
pub(crate) fn forced(records: &mut Vec<Record>) {
    const TASK: &str = "forced-response";
    for (case, frequency) in [
        ("off", 0.25),
        ("detuned by 1e-3", 1.001),
        ("detuned by 1e-9", 1.0 + 1e-9),
        ("at resonance", 1.0),
    ] {
        let times = times(0.125);
        let exact: Vec<f64> = times
            .iter()
            .map(|&time| exact_forced(frequency, time))
            .collect();
        let oscillator = Oscillator::new(1.0, 0.0, 1.0).expect("the oscillator is sound");
        let motion = ForcedResponse::of(
            &oscillator,
            HarmonicForce::cosine(1.0, frequency),
            Motion::REST,
        );
        let all = || times.iter().map(|&time| motion.position(time)).collect();
        add(
            records,
            (TASK, case, "vibank"),
            &exact,
            &all,
            Some(&|i| motion.position(times[i])),
        );
        let textbook = || {
            times
                .iter()
                .map(|&time| textbook_forced(frequency, time))
                .collect()
        };
        let sample = |i: usize| textbook_forced(frequency, times[i]);
        add(
            records,
            (TASK, case, "textbook formula"),
            &exact,
            &textbook,
            Some(&sample),
        );
        let equation = Equation {
            damping: 0.0,
            force: Some(frequency),
        };
        integrators(records, (TASK, case), &equation, [0.0; 2], &times, &exact);
    }
}

/// Amplitude and phase lag of the steady state beside resonance, set-up included.
pub(crate) fn steady(records: &mut Vec<Record>) {
    const TASK: &str = "steady-state";
    for power in [1, 4, 8, 12] {
        let (damping, detuning) = (1e-14, vibank::numerics::powi(10.0, -power));
        let case = format!("detuned by 1e-{power}");
        let frequencies: Vec<f64> = (0..SAMPLES)
            .map(|i| 1.0 + detuning * (1.0 + i as f64 / SAMPLES as f64))
            .collect();
        let exact: Vec<f64> = frequencies
            .iter()
            .map(|&frequency| {
                let rest = Dd::ONE - Dd::product(frequency, frequency);
                rest.hypot(Dd::product(damping, frequency)).recip().hi()
            })
            .collect();
        let oscillator = Oscillator::new(1.0, damping, 1.0).expect("the oscillator is sound");
        let ours = |i: usize| FrequencyResponse::at(&oscillator, frequencies[i]).amplitude(1.0);
        let textbook = |i: usize| {
            let ratio = frequencies[i];
            1.0 / hypot(1.0 - ratio * ratio, damping * ratio)
        };
        for (method, sample) in [
            ("vibank", &ours as &dyn Fn(usize) -> f64),
            ("textbook formula", &textbook),
        ] {
            let all = || (0..SAMPLES).map(sample).collect();
            add(records, (TASK, &case, method), &exact, &all, Some(sample));
        }
    }
}
