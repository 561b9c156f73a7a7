//! One degree of freedom: free motion in all regimes, total response, steady state, bandwidth, decrement.

use differential_equations::prelude::*;
use vibank::numerics::{cos, exp, hypot, ln, sin};
use vibank::vibration::{
    DisplacementResonance, ForcedResponse, FreeResponse, FrequencyResponse, HarmonicForce,
    LogarithmicDecrement, Oscillator, State as Motion,
};

use crate::record::Record;
use crate::reference::Case;

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

fn oscillator(damping: f64) -> Oscillator {
    Oscillator::new(1.0, damping, 1.0).expect("the oscillator is sound")
}

/// Free motion from a displacement of 1 m, as it stands in textbooks.
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

/// Free motion from no damping to strong damping, with the neighbours of the critical one.
pub(crate) fn free(records: &mut Vec<Record>) {
    for case in Case::of("free-response") {
        let damping = case.number("c");
        let start = Motion {
            position: 1.0,
            velocity: 0.0,
        };
        let motion = FreeResponse::of(&oscillator(damping), start);
        records.push(case.samples("vibank", |i| motion.position(case.at[i])));
        records.push(case.all("vibank (uniform grid)", || {
            let mut positions = vec![0.0; case.at.len()];
            motion.positions(case.at[0], case.at[1] - case.at[0], &mut positions);
            positions
        }));
        records.push(case.samples("textbook formula", |i| textbook_free(damping, case.at[i])));
        let equation = Equation {
            damping,
            force: None,
        };
        records.extend(case.integrated(&equation, [1.0, 0.0]));
    }
}

/// From rest under `cos Ωt`, as it stands in textbooks.
fn textbook_forced(frequency: f64, time: f64) -> f64 {
    if frequency == 1.0 {
        time * sin(time) / 2.0
    } else {
        (cos(frequency * time) - cos(time)) / (1.0 - frequency * frequency)
    }
}

/// The undamped oscillator from rest, off, near and at resonance.
pub(crate) fn forced(records: &mut Vec<Record>) {
    for case in Case::of("forced-response") {
        let frequency = case.number("Omega");
        let force = HarmonicForce::cosine(1.0, frequency);
        let motion = ForcedResponse::of(&oscillator(0.0), force, Motion::REST);
        records.push(case.samples("vibank", |i| motion.position(case.at[i])));
        let textbook = |i: usize| textbook_forced(frequency, case.at[i]);
        records.push(case.samples("textbook formula", textbook));
        let equation = Equation {
            damping: 0.0,
            force: Some(frequency),
        };
        records.extend(case.integrated(&equation, [0.0; 2]));
    }
}

/// Amplitudes of the steady state, set-up included.
pub(crate) fn steady(records: &mut Vec<Record>) {
    for case in Case::of("steady-state") {
        let damping = case.number("c");
        let oscillator = oscillator(damping);
        records.push(case.samples("vibank", |i| {
            FrequencyResponse::at(&oscillator, case.at[i]).amplitude(1.0)
        }));
        records.push(case.samples("textbook formula", |i| {
            let ratio = case.at[i];
            1.0 / hypot(1.0 - ratio * ratio, damping * ratio)
        }));
    }
}

/// Bandwidth of the displacement.
pub(crate) fn bandwidth(records: &mut Vec<Record>) {
    for case in Case::of("bandwidth") {
        let damping = case.number("c");
        records.push(case.solution("vibank", || {
            let resonance = DisplacementResonance::of(&oscillator(damping));
            [resonance
                .and_then(|resonance| resonance.bandwidth())
                .unwrap_or(f64::NAN)]
        }));
        records.push(case.solution("difference of cut-offs", || {
            let ratio = damping / 2.0;
            let (middle, half) = (
                1.0 - 2.0 * ratio * ratio,
                2.0 * ratio * (1.0 - ratio * ratio).sqrt(),
            );
            [(middle + half).sqrt() - (middle - half).sqrt()]
        }));
    }
}

/// Damping ratio from two amplitudes.
pub(crate) fn decrement(records: &mut Vec<Record>) {
    for case in Case::of("decrement") {
        let (first, last) = (case.number("x1"), case.number("xn1"));
        records.push(case.solution("vibank", || {
            [LogarithmicDecrement::of(first, last, 1)
                .map_or(f64::NAN, |decrement| decrement.damping_ratio())]
        }));
        records.push(case.solution("textbook formula", || {
            let decrement = ln(first / last);
            [decrement / hypot(std::f64::consts::TAU, decrement)]
        }));
    }
}
