//! Dry friction against `tests/references/friction.py`, and against what its motion keeps.

use proptest::prelude::*;
use serde_json::{Value, json};
use vibank::compute;
use vibank::numerics::{Dd, ExactNumber, powi};
use vibank::vibration::{DryFriction, FrictionError, FrictionMotion, FrictionOscillator};

use super::reference::{Accuracy, Case, ulps};

const REFERENCES: &str = include_str!("../../fixtures/references/friction.jsonl");

fn decimal(text: &str) -> ExactNumber {
    ExactNumber::from_decimal(text).unwrap()
}

/// A parameter, exactly as it is written.
fn given(case: &Case, name: &str, default: &str) -> ExactNumber {
    decimal(
        case.params
            .get(name)
            .and_then(Value::as_str)
            .unwrap_or(default),
    )
}

fn motion(case: &Case) -> FrictionMotion {
    let number = |name| given(case, name, "0");
    let fixed = if case.params.contains_key("mu_s") {
        "mu_s"
    } else {
        "mu"
    };
    let friction = DryFriction::of_weight(number("mu"), number(fixed), number("m"), number("g"));
    let system = FrictionOscillator::new(number("m"), number("c"), number("k"), friction).unwrap();
    system
        .with_force(number("F"))
        .unwrap()
        .motion(number("x0"), number("v0"))
        .unwrap_or_else(|error| panic!("{error}: {:?}", case.params))
}

/// Number of half-cycles, position and time of rest, path.
pub(super) fn rest(accuracy: &mut Accuracy) {
    for case in Case::read(REFERENCES) {
        let motion = motion(&case);
        let at = || format!("{:?}", case.params);
        let slides = case.result["n_half"].as_u64().unwrap();
        let off = motion.slides().unwrap().abs_diff(slides) as f64;
        accuracy.record("half-cycles, exactly", off, f64::MIN_POSITIVE, at);
        let is_viscous = case.number("c") > 0.0;
        let slip = case.number("mu") * case.number("m") * case.number("g") / case.number("k");
        let equilibrium = (case.number("F") / case.number("k")).abs();
        let (name, target) = if is_viscous {
            ("x_stop, viscous / slip", 1e-10)
        } else {
            ("x_stop / slip", 1e-13)
        };
        let position = motion.rest_position().unwrap();
        let error = (case.expected("x_stop") - position).hi().abs();
        // Next to a far equilibrium the last digit of the position is coarser.
        accuracy.record(name, error / (slip + equilibrium), target, at);
        if case.result["t_stop"].is_null() {
            assert_eq!(motion.stop_time(), f64::INFINITY);
        } else {
            accuracy.record(
                "t_stop, last places",
                ulps(motion.stop_time(), case.expected("t_stop")),
                2.0,
                at,
            );
        }
        let path = case.expected("path");
        // The least travel of a mass is measured against the slip, from which it is formed.
        let path_error = (path - motion.path_length()).hi().abs() / (path.hi() + slip);
        accuracy.record("path / path and slip", path_error, 1e-15, at);
    }
}

/// Position and velocity at any time.
pub(super) fn motion_in_time(accuracy: &mut Accuracy) {
    for case in Case::read(REFERENCES)
        .into_iter()
        .filter(|case| case.params.contains_key("t"))
    {
        let path = motion(&case).path();
        let (positions, velocities) = (case.expected_list("x_t"), case.expected_list("v_t"));
        let omega = (case.number("k") / case.number("m")).sqrt();
        let zeta = case.number("c") / (2.0 * case.number("m") * omega);
        let slip = case.number("mu") * case.number("m") * case.number("g") / case.number("k");
        let scale = case.number("x0").abs()
            + (case.number("F") / case.number("k")).abs()
            + slip
            + case.number("v0").abs() / omega;
        for (i, t) in case.params["t"].as_array().unwrap().iter().enumerate() {
            let state = path.state(decimal(t.as_str().unwrap()).to_dd());
            assert_eq!(
                state.position,
                path.position(decimal(t.as_str().unwrap()).to_dd())
            );
            let error = (positions[i] - state.position).hi().abs() / scale;
            let velocity_error = (velocities[i] - state.velocity).hi().abs() / scale / omega;
            let name = if zeta > 0.0 {
                "x, v, viscous / scale"
            } else {
                "x, v / scale"
            };
            accuracy.record(name, error.max(velocity_error), 1e-14, || {
                format!("t = {t} {:?}", case.params)
            });
        }
    }
}

#[test]
fn requests_are_answered_by_the_same_numbers() {
    for case in Case::read(REFERENCES) {
        let (motion, reply) = (motion(&case), case.answer());
        assert_eq!(reply["n_half"], motion.slides().unwrap());
        assert_eq!(reply["x_stop"], motion.rest_position().unwrap());
        assert_eq!(reply["path"], motion.path_length());
        assert_eq!(
            reply["t_stop"].as_f64(),
            Some(motion.stop_time()).filter(|time| time.is_finite())
        );
        let stick = case.expected("x_stick").hi();
        assert!((reply["x_stick"].as_f64().unwrap() / stick - 1.0).abs() < 3e-16);
        if let Some(times) = case.params.get("t").and_then(Value::as_array) {
            let path = motion.path();
            let at = |t: &Value| path.state(decimal(t.as_str().unwrap()).to_dd());
            let positions: Vec<f64> = times.iter().map(|t| at(t).position).collect();
            let velocities: Vec<f64> = times.iter().map(|t| at(t).velocity).collect();
            assert_eq!(
                (&reply["x_t"], &reply["v_t"]),
                (&json!(positions), &json!(velocities))
            );
        }
    }
}

#[test]
fn requests_without_an_end_have_no_values() {
    let request =
        r#"{"id":1,"task":"coulomb_stop","params":{"m":1,"k":1,"mu":0,"g":9.81,"x0":1,"t":0}}"#;
    let expected = r#"{"id":1,"result":{"n_half":null,"t_stop":null,"x_stop":null,"path":null,"x_stick":0.0,"x_t":1.0,"v_t":0.0}}"#;
    assert_eq!(compute::answer(request), expected);
    let paper_tie =
        r#"{"id":1,"task":"coulomb_stop","params":{"m":1,"k":1,"mu":0.1,"g":1,"x0":0.3,"c":0}}"#;
    assert!(compute::answer(paper_tie).starts_with(r#"{"id":1,"result":{"n_half":1,"#));
    let refused = r#"{"id":1,"task":"coulomb_stop","params":{"m":1,"k":1,"mu":0.1,"mu_s":0.05,"g":1,"x0":0.3}}"#;
    assert!(compute::answer(refused).contains("out_of_domain"));
}

/// A block of 1 kg on a spring of 1 N/m: lengths and forces are the same numbers.
fn block(kinetic: ExactNumber, fixed: ExactNumber, damping: ExactNumber) -> FrictionOscillator {
    let one = ExactNumber::from(1);
    FrictionOscillator::new(one, damping, one, DryFriction::of_forces(kinetic, fixed)).unwrap()
}

fn binary(value: f64) -> ExactNumber {
    ExactNumber::from_f64(value).unwrap()
}

fn released(slip: &str, x0: &str) -> FrictionMotion {
    let slip = decimal(slip);
    block(slip, slip, ExactNumber::ZERO)
        .motion(decimal(x0), ExactNumber::ZERO)
        .unwrap()
}

#[test]
fn ties_are_decided_on_the_decimals() {
    for (slip, x0, slides) in [
        ("0.1", "0.3", 1),
        ("0.1", "0.30000000000000004", 2),
        ("0.1", "0.29999999999999993", 1),
        ("0.1", "0.1", 0),
        ("0.1", "0.10000000000000000000000000000000001", 1),
        ("0.07", "0.49", 3),
        ("0.07", "0.49000000000000000000000000001", 4),
        ("1e-12", "0.999999999999", 499_999_999_999),
        ("1e-12", "1", 500_000_000_000),
        ("1e-12", "2.000000000001", 1_000_000_000_000),
        (
            "1e-12",
            "2.0000000000010000000000000000001",
            1_000_000_000_001,
        ),
    ] {
        assert_eq!(released(slip, x0).slides(), Some(slides), "{slip} {x0}");
    }
}

#[test]
fn the_rounded_numbers_may_tie_otherwise() {
    // As binary64 three times 0.1 is more than 0.3.
    let slip = binary(0.1);
    let slides = |x0: f64| {
        block(slip, slip, ExactNumber::ZERO)
            .motion(binary(x0), ExactNumber::ZERO)
            .unwrap()
            .slides()
    };
    assert_eq!(slides(0.3), Some(1));
    assert_eq!(slides(0.3_f64.next_up()), Some(2));
}

#[test]
fn without_kinetic_friction_it_does_not_rest() {
    let zero = ExactNumber::ZERO;
    let motion = block(zero, zero, zero).motion(decimal("1"), zero).unwrap();
    assert_eq!((motion.slides(), motion.rest_position()), (None, None));
    assert_eq!(
        (motion.stop_time(), motion.path_length()),
        (f64::INFINITY, f64::INFINITY)
    );
    assert!((motion.path().position(Dd::TAU * 1e9) - 1.0).abs() < 1e-15);
    let damped = block(zero, zero, decimal("0.1"))
        .motion(decimal("1"), zero)
        .unwrap();
    assert_eq!((damped.slides(), damped.rest_position()), (None, Some(0.0)));
    assert!(damped.path_length() > 1.0 && damped.path_length().is_finite());
    // Static friction alone can hold it where damping brings it to.
    let held = block(zero, decimal("0.5"), decimal("0.1"))
        .motion(decimal("1"), zero)
        .unwrap();
    assert_eq!(held.slides(), Some(5));
    let still = block(zero, zero, zero).motion(zero, zero).unwrap();
    assert_eq!((still.slides(), still.stop_time()), (Some(0), 0.0));
}

#[test]
fn impossible_systems_are_refused() {
    let (one, zero) = (ExactNumber::from(1), ExactNumber::ZERO);
    let system = |mass, kinetic, fixed| {
        FrictionOscillator::new(mass, zero, one, DryFriction::of_forces(kinetic, fixed)).map(|_| ())
    };
    assert!(matches!(
        system(zero, one, one),
        Err(FrictionError::Oscillator(_))
    ));
    assert_eq!(system(one, -one, one), Err(FrictionError::NegativeFriction));
    assert_eq!(
        system(one, one, decimal("0.999999999999999999999999")),
        Err(FrictionError::StaticBelowKinetic)
    );
    let tiny = decimal("1e-30");
    let far = block(tiny, tiny, zero).motion(one, zero).map(|_| ());
    assert_eq!(far, Err(FrictionError::TooManySlides));
}

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("finite", |x| x.is_finite())
}

/// Damping from none to overdamped.
fn damping() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.0..0.2_f64, 0.0..3.0_f64]
}

proptest! {
    #[test]
    fn half_cycles_are_counted_as_integers_are(slip in 1..10_000_i128, x0 in -1_000_000_000_000_000_i128..1_000_000_000_000_000, tie in any::<bool>(), off in -1..2_i128) {
        // A tie is an odd multiple of the slip; its neighbours differ in the last digit.
        let x0 = if tie { ((x0 / slip) | 1) * slip + off } else { x0 };
        let expected = (x0.abs() - slip).max(0).div_euclid(2 * slip) + i128::from((x0.abs() - slip).max(0) % (2 * slip) != 0);
        let motion = released(&format!("{slip}e-7"), &format!("{x0}e-7"));
        prop_assert_eq!(i128::from(motion.slides().unwrap()), expected);
        let last = (x0.abs() - 2 * expected * slip) * x0.signum() * if expected % 2 == 0 { 1 } else { -1 };
        let rest = format!("{last}e-7").parse::<f64>().unwrap();
        prop_assert!((motion.rest_position().unwrap() - rest).abs() <= 1e-15 * 1e-7 * slip as f64);
        prop_assert!(last != 0 || motion.rest_position() == Some(0.0));
    }

    #[test]
    fn friction_takes_its_force_times_the_path(slip in 0.001..1.0_f64, x0 in -30.0..30.0_f64, v0 in -30.0..30.0_f64, hold in 1.0..2.0_f64) {
        let system = block(binary(slip), binary(slip * hold), ExactNumber::ZERO);
        let motion = system.motion(binary(x0), binary(v0)).unwrap();
        let (heat, work) = (motion.dissipated_energy(), slip * motion.path_length());
        prop_assert!((heat - work).abs() <= 1e-14 * (x0 * x0 + v0 * v0), "{} {}", heat, work);
    }

    #[test]
    fn motions_are_continuous(slip in 0.01..1.0_f64, c in damping(), x0 in -5.0..5.0_f64, v0 in -5.0..5.0_f64, t in 0.0..40.0_f64) {
        let path = block(binary(slip), binary(slip), binary(c)).motion(binary(x0), binary(v0)).unwrap().path();
        let step = 1e-7;
        let (now, next) = (path.state(t), path.state(t + step));
        let slope = 0.5 * (now.velocity + next.velocity);
        // Within a slide the trapezium is right to the third order; where the slide changes, to the second.
        prop_assert!((next.position - now.position - slope * step).abs() < 1e-12);
        prop_assert!((next.velocity - now.velocity).abs() < 40.0 * step);
    }

    #[test]
    fn a_path_goes_from_the_start_to_the_rest(slip in 0.01..1.0_f64, c in damping(), x0 in -5.0..5.0_f64, v0 in -5.0..5.0_f64) {
        let motion = block(binary(slip), binary(slip), binary(c)).motion(binary(x0), binary(v0)).unwrap();
        let path = motion.path();
        prop_assert!((path.position(0.0) - x0).abs() < 1e-14);
        let stop = motion.stop_time();
        if stop.is_infinite() {
            return Ok(());
        }
        let before = path.state(stop * (1.0 - 1e-12));
        prop_assert!((before.position - motion.rest_position().unwrap()).abs() < 1e-9);
        prop_assert_eq!(path.position(2.0 * stop + 1.0), motion.rest_position().unwrap());
    }

    #[test]
    fn mirrored_starts_have_mirrored_motions(slip in 0.01..1.0_f64, c in damping(), x0 in -5.0..5.0_f64, v0 in -5.0..5.0_f64, t in 0.0..40.0_f64) {
        let system = block(binary(slip), binary(slip), binary(c));
        let motion = system.motion(binary(x0), binary(v0)).unwrap();
        let mirror = system.motion(binary(-x0), binary(-v0)).unwrap();
        prop_assert_eq!(motion.slides(), mirror.slides());
        prop_assert_eq!(motion.path().position(t), -mirror.path().position(t));
    }

    #[test]
    fn lengths_and_times_scale_by_powers_of_two(slip in 0.01..1.0_f64, c in damping(), x0 in -5.0..5.0_f64, v0 in -5.0..5.0_f64, t in 0.0..40.0_f64, n in -60..60_i32, p in -60..60_i32) {
        let (length, time) = (powi(2.0, n), powi(2.0, p));
        let plain = block(binary(slip), binary(slip), binary(c)).motion(binary(x0), binary(v0)).unwrap();
        let force = binary(slip * length / time / time);
        let scaled = FrictionOscillator::new(
            binary(1.0), binary(c / time), binary(1.0 / time / time), DryFriction::of_forces(force, force),
        ).unwrap().motion(binary(x0 * length), binary(v0 * length / time)).unwrap();
        prop_assert_eq!(plain.slides(), scaled.slides());
        prop_assert_eq!(plain.stop_time() * time, scaled.stop_time());
        prop_assert_eq!(plain.path().position(t) * length, scaled.path().position(t * time));
        prop_assert_eq!(plain.path_length() * length, scaled.path_length());
    }

    #[test]
    fn every_start_has_a_motion(m in finite(), c in finite(), k in finite(), slip in finite(), force in finite(), x0 in finite(), v0 in finite(), t in finite()) {
        let friction = DryFriction::of_forces(binary(slip.abs()), binary(slip.abs()));
        let system = FrictionOscillator::new(binary(m.abs()), binary(c.abs()), binary(k.abs()), friction);
        if let Ok(motion) = system.and_then(|system| system.with_force(binary(force))?.motion(binary(x0), binary(v0))) {
            prop_assert!(!motion.stop_time().is_nan() && !motion.path_length().is_nan());
            prop_assert!(motion.rest_position().is_none_or(|x| !x.is_nan()));
            let state = motion.path().state(t.abs());
            prop_assert!(!state.position.is_nan() && !state.velocity.is_nan(), "{:?}", state);
        }
    }
}
