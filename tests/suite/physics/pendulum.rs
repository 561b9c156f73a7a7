//! The pendulum against `tests/references/pendulum.py`, and against what its motion keeps.

use proptest::prelude::*;
use serde_json::json;
use vibank::numerics::{Dd, powi, sin};
use vibank::vibration::{Pendulum, PendulumMotion, PendulumRegime};

use super::reference::{Accuracy, Case, ulps};

const REFERENCES: &str = include_str!("../../fixtures/references/pendulum.jsonl");

fn cases(task: &'static str) -> impl Iterator<Item = Case> {
    Case::read(REFERENCES)
        .into_iter()
        .filter(move |case| case.task == task)
}

fn pendulum(case: &Case) -> Pendulum {
    Pendulum::new(case.number("L"), case.number("g")).unwrap()
}

/// Periods and by how much they exceed those of small swings.
pub(super) fn period(accuracy: &mut Accuracy) {
    for case in cases("pendulum_period") {
        let (pendulum, theta0) = (pendulum(&case), case.number("theta0"));
        let at = || format!("{:?}", case.params);
        for (name, value, target) in [
            ("T", pendulum.period(theta0).unwrap(), 2.0),
            ("T_small", pendulum.small_period(), 1.0),
            ("excess", pendulum.period_excess(theta0).unwrap(), 6.0),
        ] {
            let error = ulps(value, case.expected(name));
            accuracy.record(&format!("{name}, last places"), error, target, at);
        }
    }
}

/// The group of the table, and its target in units of the scale.
fn group(case: &Case, motion: &PendulumMotion, t: f64) -> (&'static str, f64) {
    let rate = (case.number("g") / case.number("L")).sqrt();
    let (sine, kappa) = (
        sin(0.5 * case.number("theta0")),
        case.number("omega0") / (2.0 * rate),
    );
    let from_separatrix = (sine * sine + kappa * kappa - 1.0).abs();
    match motion.regime() {
        PendulumRegime::Separatrix => ("separatrix", 1e-14),
        _ if from_separatrix < 2e-15 => ("within 1e-15 of the separatrix", 1e-12),
        _ if rate * t > 1e3 => ("up to 1e7 periods", 1e-13),
        PendulumRegime::Swinging => ("swinging", 1e-14),
        PendulumRegime::Turning => ("turning over", 1e-14),
    }
}

/// Angle and angular velocity at any time.
pub(super) fn motion(accuracy: &mut Accuracy) {
    for case in cases("pendulum_motion") {
        let motion = pendulum(&case)
            .motion(case.number("theta0"), case.number("omega0"))
            .unwrap();
        let (angles, velocities) = (case.expected_list("theta"), case.expected_list("omega"));
        let greatest = |list: &[Dd]| list.iter().fold(0.0_f64, |most, x| most.max(x.hi().abs()));
        let fastest = greatest(&velocities);
        let widest = greatest(&angles).min(std::f64::consts::PI);
        for (i, t) in case.numbers("t").into_iter().enumerate() {
            let (name, target) = group(&case, &motion, t);
            // A turn further the angle is rounded in larger units.
            let scale = widest.max(angles[i].hi().abs());
            let angle_error = (angles[i] - motion.angle(t)).hi().abs() / scale;
            let velocity_error = (velocities[i] - motion.angular_velocity(t)).hi().abs() / fastest;
            accuracy.record(name, angle_error.max(velocity_error), target, || {
                format!(
                    "t = {t}, {angle_error:.1e} {velocity_error:.1e} {:?}",
                    case.params
                )
            });
        }
    }
}

#[test]
fn requests_are_answered_by_the_same_numbers() {
    for case in cases("pendulum_period") {
        let (pendulum, theta0) = (pendulum(&case), case.number("theta0"));
        let reply = case.answer();
        assert_eq!(reply["T"], pendulum.period(theta0).unwrap());
        assert_eq!(reply["T_small"], pendulum.small_period());
        assert_eq!(reply["excess"], pendulum.period_excess(theta0).unwrap());
    }
    for case in cases("pendulum_motion") {
        let motion = pendulum(&case)
            .motion(case.number("theta0"), case.number("omega0"))
            .unwrap();
        let times = case.numbers("t");
        let angles: Vec<f64> = times.iter().map(|t| motion.angle(*t)).collect();
        let velocities: Vec<f64> = times.iter().map(|t| motion.angular_velocity(*t)).collect();
        let reply = case.answer();
        assert_eq!(
            (&reply["theta"], &reply["omega"]),
            (&json!(angles), &json!(velocities))
        );
    }
}

/// Starts on all sides of the separatrix.
fn starts() -> impl Strategy<Value = (f64, f64)> {
    (-12.0..12.0_f64, -6.0..6.0_f64)
}

/// The energy over that of the top.
fn energy(angle: f64, angular_velocity: f64) -> f64 {
    let sine = sin(0.5 * angle);
    0.25 * angular_velocity * angular_velocity + sine * sine
}

proptest! {
    #[test]
    fn energy_is_kept((angle, velocity) in starts(), t in 0.0..50.0_f64) {
        let motion = Pendulum::new(2.0, 2.0).unwrap().motion(angle, velocity).unwrap();
        let (before, after) = (energy(angle, velocity), energy(motion.angle(t), motion.angular_velocity(t)));
        prop_assert!((after - before).abs() <= 1e-14 * (1.0 + before), "{before} {after}");
    }

    #[test]
    fn motions_begin_at_their_start((angle, velocity) in starts()) {
        let motion = Pendulum::new(1.0, 9.81).unwrap().motion(angle, velocity).unwrap();
        prop_assert!((motion.angle(0.0) - angle).abs() < 1e-14);
        prop_assert!((motion.angular_velocity(0.0) - velocity).abs() < 3e-14);
    }

    #[test]
    fn mirrored_starts_have_mirrored_motions((angle, velocity) in starts(), t in 0.0..50.0_f64) {
        let pendulum = Pendulum::new(1.0, 9.81).unwrap();
        let (motion, mirror) = (pendulum.motion(angle, velocity).unwrap(), pendulum.motion(-angle, -velocity).unwrap());
        prop_assert_eq!(motion.angle(t), -mirror.angle(t));
        prop_assert_eq!(motion.angular_velocity(t), -mirror.angular_velocity(t));
    }

    #[test]
    fn time_runs_both_ways((angle, velocity) in starts(), t in 0.0..5.0_f64) {
        let pendulum = Pendulum::new(1.0, 1.0).unwrap();
        let there = pendulum.motion(angle, velocity).unwrap();
        prop_assume!((energy(angle, velocity) - 1.0).abs() > 1e-3);
        let back = pendulum.motion(there.angle(t), there.angular_velocity(t)).unwrap();
        prop_assert!((back.angle(-t) - angle).abs() < 1e-11);
        prop_assert!((back.angular_velocity(-t) - velocity).abs() < 1e-11);
    }

    #[test]
    fn a_period_brings_the_start_back((angle, velocity) in starts()) {
        let motion = Pendulum::new(1.0, 9.81).unwrap().motion(angle, velocity).unwrap();
        let turn = match motion.regime() {
            PendulumRegime::Turning => Dd::TAU.hi().copysign(velocity),
            _ => 0.0,
        };
        let period = motion.period().unwrap();
        // The rounding of a long period moves the pendulum on by as much as it moves in that time.
        prop_assert!((motion.angle(period) - angle - turn).abs() < 2e-14 + 1e-15 * period * velocity.abs());
    }

    #[test]
    fn time_scales_by_powers_of_two((angle, velocity) in starts(), t in 0.0..50.0_f64, n in -40..40_i32) {
        let factor = powi(2.0, n);
        let motion = Pendulum::new(1.3, 9.81).unwrap().motion(angle, velocity).unwrap();
        let slowed = Pendulum::new(1.3 * factor * factor, 9.81).unwrap().motion(angle, velocity / factor).unwrap();
        prop_assert_eq!(motion.angle(t), slowed.angle(t * factor));
        prop_assert_eq!(motion.angular_velocity(t), slowed.angular_velocity(t * factor) * factor);
    }

    #[test]
    fn every_start_has_a_motion(length in positive(), gravity in positive(), angle in finite(), velocity in finite(), t in finite()) {
        let pendulum = Pendulum::new(length, gravity).unwrap();
        if let Ok(motion) = pendulum.motion(angle, velocity) {
            if (t / motion.period().unwrap_or(1.0)).abs() >= 1e300 {
                return Ok(());
            }
            prop_assert!(!motion.angle(t).is_nan() && !motion.angular_velocity(t).is_nan());
        }
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("finite", |x| x.is_finite())
}

fn positive() -> impl Strategy<Value = f64> {
    finite()
        .prop_map(f64::abs)
        .prop_filter("positive", |x| *x > 0.0)
}

#[test]
fn the_separatrix_is_met_exactly() {
    // w^2 L = 4 g without rounding, and the neighbours on both sides.
    for (length, gravity, top) in [
        (1.0, 1.0, 2.0),
        (4.0, 9.0, 3.0),
        (0.25, 2.25, 6.0_f64),
        (powi(2.0, 600), powi(2.0, 602), 4.0),
    ] {
        let pendulum = Pendulum::new(length, gravity).unwrap();
        let regime = |velocity| pendulum.motion(0.0, velocity).unwrap().regime();
        assert_eq!(
            regime(top),
            PendulumRegime::Separatrix,
            "{length} {gravity} {top}"
        );
        assert_eq!(regime(-top), PendulumRegime::Separatrix);
        assert_eq!(regime(top.next_up()), PendulumRegime::Turning);
        assert_eq!(regime(top.next_down()), PendulumRegime::Swinging);
    }
}

#[test]
fn released_pendulums_rest_at_the_start() {
    for angle in [3.0, -1e-9, 1e-160] {
        let motion = Pendulum::new(1.0, 9.81)
            .unwrap()
            .motion(angle, 0.0)
            .unwrap();
        assert_eq!(motion.angular_velocity(0.0), 0.0);
        assert!((motion.angle(0.0) / angle - 1.0).abs() < 3e-16);
    }
    let still = Pendulum::new(1.0, 9.81).unwrap().motion(0.0, 0.0).unwrap();
    assert_eq!((still.angle(7.0), still.angular_velocity(7.0)), (0.0, 0.0));
}

#[test]
fn fast_and_huge_starts_are_refused_not_wrong() {
    let pendulum = Pendulum::new(1.0, 9.81).unwrap();
    assert!(pendulum.motion(0.0, 1e200).is_err());
    assert!(pendulum.motion(f64::NAN, 0.0).is_err());
    let motion = pendulum.motion(1e300, 1e50).unwrap();
    assert!(motion.angle(1.0).is_finite());
}
