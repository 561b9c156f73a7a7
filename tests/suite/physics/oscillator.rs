//! The oscillator against `tests/references/oscillator.py`, as requests see it.

use serde_json::{Value, json};
use vibank::compute::answer;
use vibank::numerics::Dd;
use vibank::vibration::{ForcedResponse, FrequencyResponse, HarmonicForce, Oscillator, State};

use super::reference::{Accuracy, Case, ulps};

/// What a quantity is held to.
#[derive(Clone, Copy)]
enum Target {
    /// Units in the last place.
    Ulps(f64),
    /// Parts of the local scale, which stands beside the reference.
    OfScale(f64),
}
use Target::{OfScale, Ulps};

/// Answers all cases and holds each quantity to its target.
fn check(accuracy: &mut Accuracy, references: &str, targets: &[(&'static str, Target)]) {
    for case in Case::read(references) {
        let result = match case.task.as_str() {
            "forced_by_sine" => forced_by_sine(&case),
            "transfer" => transfer(&case),
            _ => solve(&case),
        };
        for (name, expected) in &case.result {
            let Some((name, target)) = targets.iter().find(|target| target.0 == name) else {
                assert!(
                    name.ends_with("_scale") || expected == &result[name],
                    "{name} of {:?}",
                    case.params
                );
                continue;
            };
            assert_eq!(
                expected.is_null(),
                result[*name].is_null(),
                "{name} of {:?}",
                case.params
            );
            record(accuracy, &case, &result, name, *target);
        }
    }
}

fn solve(case: &Case) -> Value {
    let request = json!({ "id": 0, "task": case.task, "params": case.params });
    let reply: Value = serde_json::from_str(&answer(&request.to_string())).unwrap();
    assert!(reply["error"].is_null(), "{reply} for {request}");
    reply["result"].clone()
}

fn oscillator(case: &Case) -> Oscillator {
    Oscillator::new(case.number("m"), case.number("c"), case.number("k")).unwrap()
}

fn forced_by_sine(case: &Case) -> Value {
    let force = HarmonicForce::sine(case.number("F0"), case.number("Omega"));
    let motion = ForcedResponse::of(&oscillator(case), force, State::REST);
    let states: Vec<State> = case
        .numbers("t")
        .into_iter()
        .map(|t| motion.state(t))
        .collect();
    let positions: Vec<f64> = states.iter().map(|state| state.position).collect();
    let velocities: Vec<f64> = states.iter().map(|state| state.velocity).collect();
    json!({ "x": positions, "v": velocities })
}

fn transfer(case: &Case) -> Value {
    let response = FrequencyResponse::at(&oscillator(case), case.number("Omega"));
    let (impedance, receptance) = (response.impedance(), response.receptance());
    let (mobility, accelerance) = (response.mobility(), response.accelerance());
    json!({
        "relative": response.relative_amplitude(0.25), "unbalance": response.unbalance_amplitude(0.5),
        "magnification": response.magnification_factor(), "transmission_lag": response.transmission_lag(),
        "resistance": impedance.re, "reactance": impedance.im,
        "receptance_re": receptance.re, "receptance_im": receptance.im,
        "mobility_re": mobility.re, "mobility_im": mobility.im,
        "accelerance_re": accelerance.re, "accelerance_im": accelerance.im,
    })
}

fn record(
    accuracy: &mut Accuracy,
    case: &Case,
    result: &Value,
    name: &'static str,
    target: Target,
) {
    let at = |index: usize| format!("{} at {index} of {:?}", name, case.params);
    match target {
        Ulps(target) if !result[name].is_null() => {
            let value = result[name].as_f64().unwrap();
            let error = ulps(value, case.expected(name));
            accuracy.record(&format!("{name}, last places"), error, target, || at(0));
        }
        Ulps(_) => {}
        OfScale(target) => {
            let values = result[name]
                .as_array()
                .unwrap()
                .iter()
                .map(|value| value.as_f64().unwrap());
            let expected = case
                .expected_list(name)
                .into_iter()
                .zip(case.expected_list(&format!("{name}_scale")));
            for (index, (value, (expected, scale))) in values.zip(expected).enumerate() {
                let error = error(value, expected, scale.hi());
                accuracy.record(&format!("{name} / scale"), error, target, || at(index));
            }
        }
    }
}

/// The error over the local scale, or over the smallest normal number where the scale is below.
fn error(value: f64, expected: Dd, scale: f64) -> f64 {
    (expected - value).hi().abs() / scale.max(f64::MIN_POSITIVE)
}

/// Free response in all regimes.
pub(super) fn free(accuracy: &mut Accuracy) {
    check(
        accuracy,
        include_str!("../../fixtures/references/free.jsonl"),
        &[
            ("x", OfScale(1e-15)),
            ("v", OfScale(1e-15)),
            ("omega0", Ulps(1.0)),
            ("zeta", Ulps(1.0)),
            ("omega_d", Ulps(2.0)),
            ("r_slow", Ulps(2.0)),
            ("r_fast", Ulps(2.0)),
        ],
    );
}

/// Total response at, near and far from resonance.
pub(super) fn forced(accuracy: &mut Accuracy) {
    check(
        accuracy,
        include_str!("../../fixtures/references/forced.jsonl"),
        &[("x", OfScale(2e-14)), ("v", OfScale(2e-14))],
    );
}

/// Steady states, resonances and bandwidths.
pub(super) fn steady(accuracy: &mut Accuracy) {
    let (steady, resonance) = (Ulps(2.0), Ulps(1.0));
    check(
        accuracy,
        include_str!("../../fixtures/references/steady.jsonl"),
        &[
            ("X", steady),
            ("phi", Ulps(3.0)),
            ("power", steady),
            ("transmissibility", steady),
            ("omega_r", resonance),
            ("gain_peak", resonance),
            ("omega1", resonance),
            ("omega2", resonance),
            ("bandwidth", resonance),
            ("Q", resonance),
            ("vel_omega1", resonance),
            ("vel_omega2", resonance),
            ("vel_bandwidth", resonance),
            ("relative", Ulps(3.0)),
            ("unbalance", Ulps(3.0)),
            ("magnification", Ulps(3.0)),
            ("transmission_lag", Ulps(3.0)),
            ("resistance", resonance),
            ("reactance", resonance),
            ("receptance_re", Ulps(4.0)),
            ("receptance_im", Ulps(4.0)),
            ("mobility_re", Ulps(4.0)),
            ("mobility_im", Ulps(4.0)),
            ("accelerance_re", Ulps(4.0)),
            ("accelerance_im", Ulps(4.0)),
        ],
    );
}

/// Decrements and what follows from them.
pub(super) fn decrement(accuracy: &mut Accuracy) {
    let target = Ulps(1.0);
    check(
        accuracy,
        include_str!("../../fixtures/references/decrement.jsonl"),
        &["delta", "zeta", "lambda", "omega0", "c", "k"].map(|name| (name, target)),
    );
}
