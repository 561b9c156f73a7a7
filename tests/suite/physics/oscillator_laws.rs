//! What the motions of an oscillator keep: scaling, superposition, energy, and the opinion of a time integrator.

use differential_equations::prelude::*;
use proptest::prelude::*;
use vibank::numerics::{cos, exp, integral, pow, scale_by_power_of_two};
use vibank::vibration::{
    ForcedResponse, FreeResponse, FrequencyResponse, HarmonicForce, Oscillator, PeriodicForce,
    PeriodicResponse, State,
};

fn oscillator(m: f64, c: f64, k: f64) -> Oscillator {
    Oscillator::new(m, c, k).unwrap()
}

fn free(m: f64, c: f64, k: f64, position: f64, velocity: f64) -> FreeResponse {
    FreeResponse::of(&oscillator(m, c, k), State { position, velocity })
}

/// Mass, damping and stiffness with damping ratios from 0.003 to 300, and a time of a few periods.
fn systems() -> impl Strategy<Value = (f64, f64, f64, f64)> {
    let magnitude = || (-3.0..3.0_f64).prop_map(|power| pow(10.0, power));
    (magnitude(), -2.5..2.5_f64, magnitude(), 0.01..30.0_f64).prop_map(|(m, ratio, k, t)| {
        let c = 2.0 * (m * k).sqrt() * pow(10.0, ratio);
        (m, c, k, t * (m / k).sqrt())
    })
}

/// The state in units of an energy's root, so that both parts compare.
fn scaled(state: State, m: f64, k: f64) -> [f64; 2] {
    [state.position * k.sqrt(), state.velocity * m.sqrt()]
}

fn distance(a: State, b: State, m: f64, k: f64) -> f64 {
    let ([a, b], [c, d]) = (scaled(a, m, k), scaled(b, m, k));
    (a - c).abs().max((b - d).abs())
}

proptest! {
    #[test]
    fn powers_of_two_change_no_bit((m, c, k, t) in systems(), a in -300..300, b in -60..60, x0 in -2.0..2.0_f64, v0 in -2.0..2.0_f64) {
        let times = |x: f64, n: i32| scale_by_power_of_two(x, n);
        let plain = free(m, c, k, x0, v0).state(t);
        let heavy = free(times(m, a), times(c, a), times(k, a), x0, v0).state(t);
        prop_assert_eq!(plain, heavy);
        let fast = free(m, times(c, b), times(k, 2 * b), x0, times(v0, b)).state(times(t, -b));
        prop_assert_eq!(plain.position, fast.position);
        prop_assert_eq!(times(plain.velocity, b), fast.velocity);
    }

    #[test]
    fn forced_motions_scale_without_changing_a_bit((m, c, k, t) in systems(), a in -200..200, b in -60..60, w in 0.1..10.0_f64) {
        let times = |x: f64, n: i32| scale_by_power_of_two(x, n);
        let frequency = w * (k / m).sqrt();
        let plain = ForcedResponse::of(&oscillator(m, c, k), HarmonicForce::cosine(1.5, frequency), State::REST).state(t);
        let other = oscillator(times(m, a), times(c, a + b), times(k, a + 2 * b));
        let force = HarmonicForce::cosine(times(1.5, a + 2 * b), times(frequency, b));
        let scaled = ForcedResponse::of(&other, force, State::REST).state(times(t, -b));
        prop_assert_eq!(plain.position, scaled.position);
        prop_assert_eq!(times(plain.velocity, b), scaled.velocity);
    }

    #[test]
    fn the_wronskian_decays_with_the_damping((m, c, k, t) in systems()) {
        let (even, odd) = (free(m, c, k, 1.0, 0.0).state(t), free(m, c, k, 0.0, 1.0).state(t));
        let (first, second) = (even.position * odd.velocity, even.velocity * odd.position);
        let expected = exp(-c / m * t);
        let error = (first - second - expected).abs() / (first.abs() + second.abs()).max(expected);
        prop_assert!(error < 1e-14 * (1.0 + c / m * t), "{error:e}");
    }

    #[test]
    fn motions_continue_themselves((m, c, k, t) in systems(), share in 0.0..1.0_f64) {
        let motion = free(m, c, k, 0.7, 0.2 * (k / m).sqrt());
        let middle = motion.state(share * t);
        let rest = t - share * t;
        let continued = free(m, c, k, middle.position, middle.velocity).state(rest);
        // Late in an overdamped motion the middle state holds what is left of the fast part to its rounding only.
        let scale = scaled(middle, m, k).map(f64::abs);
        let error = distance(continued, motion.state(share * t + rest), m, k);
        prop_assert!(error <= 1e-14 * (scale[0] + scale[1]) * (1.0 + c / (m * k).sqrt()), "{error:e}");
    }

    #[test]
    fn motions_superpose((m, c, k, t) in systems(), x0 in -2.0..2.0_f64, v0 in -2.0..2.0_f64) {
        let (even, odd) = (free(m, c, k, 1.0, 0.0).state(t), free(m, c, k, 0.0, 1.0).state(t));
        let sum = free(m, c, k, x0, v0).state(t);
        let (position, velocity) = (x0 * even.position + v0 * odd.position, x0 * even.velocity + v0 * odd.velocity);
        let scale = (x0 * even.position).abs() + (v0 * odd.position).abs() + sum.position.abs();
        prop_assert!((sum.position - position).abs() <= 4e-14 * scale + 1e-300);
        let scale = (x0 * even.velocity).abs() + (v0 * odd.velocity).abs() + sum.velocity.abs();
        prop_assert!((sum.velocity - velocity).abs() <= 4e-14 * scale + 1e-300);
    }

    #[test]
    fn undamped_motions_run_backwards((m, _, k, t) in systems(), x0 in -2.0..2.0_f64, v0 in -2.0..2.0_f64) {
        let there = free(m, 0.0, k, x0, v0).state(t);
        let back = free(m, 0.0, k, there.position, -there.velocity).state(t);
        let start = State { position: x0, velocity: -v0 };
        let scale = scaled(start, m, k).map(f64::abs);
        prop_assert!(distance(back, start, m, k) <= 4e-15 * (scale[0] + scale[1]));
    }

    #[test]
    fn the_damper_takes_what_the_motion_loses((m, c, k, t) in systems()) {
        let motion = free(m, c, k, 0.7, 0.2 * (k / m).sqrt());
        let energy = |state: State| 0.5 * (m * state.velocity * state.velocity + k * state.position * state.position);
        let power = |time: f64| { let v = motion.state(time).velocity; c * v * v };
        // The pieces shrink towards the start, where a strong damper takes most.
        let ends: Vec<f64> = (0..30).map(|n| t * scale_by_power_of_two(1.0, -n)).chain([0.0]).collect();
        let loss: f64 = ends.windows(2).map(|ends| integral(power, ends[1], ends[0], 1e-12).unwrap().value).sum();
        let balance = energy(motion.initial()) - energy(motion.state(t)) - loss;
        prop_assert!(balance.abs() <= 1e-11 * energy(motion.initial()), "{balance:e}");
    }

    #[test]
    fn the_force_feeds_the_damper_in_the_steady_state((m, c, k, _) in systems(), w in 0.1..10.0_f64) {
        let response = FrequencyResponse::at(&oscillator(m, c, k), w * (k / m).sqrt());
        let work = 0.5 * 9.0 * response.mobility().re;
        prop_assert!((work / response.mean_power(3.0) - 1.0).abs() < 2e-15);
    }

    #[test]
    fn forced_motions_settle_to_the_steady_state((m, _, k, _) in systems(), w in 0.1..10.0_f64) {
        let c = (m * k).sqrt();
        let (oscillator, frequency) = (oscillator(m, c, k), w * (k / m).sqrt());
        let force = PeriodicForce { mean: 0.4, angular_frequency: frequency, harmonics: vec![vibank::vibration::Harmonic { cosine: 1.0, sine: -2.0 }] };
        let steady = PeriodicResponse::of(&oscillator, &force);
        let moving = ForcedResponse::of(&oscillator, HarmonicForce { cosine: 1.0, sine: -2.0, angular_frequency: frequency }, State::REST);
        let constant = ForcedResponse::of(&oscillator, HarmonicForce::constant(0.4), State::REST);
        let t = 90.0 * m / c;
        let error = distance(moving.state(t) + constant.state(t), steady.state(t), m, k);
        prop_assert!(error * k.sqrt() <= 1e-14 * k.max(1.0) * 4.0 / k.min(1.0), "{error:e}");
    }

    #[test]
    fn any_finite_system_has_a_finite_motion(m in any::<f64>(), c in any::<f64>(), k in any::<f64>(), x0 in any::<f64>(), v0 in any::<f64>(), t in 0.0..1e3_f64) {
        let Ok(oscillator) = Oscillator::new(m.abs(), c.abs(), k.abs()) else { return Ok(()) };
        let natural = oscillator.natural_angular_frequency();
        prop_assume!(natural > 1e-290 && natural < 1e290);
        let motion = FreeResponse::of(&oscillator, State { position: x0 * 1e-10, velocity: 0.0 });
        prop_assert!(!motion.state(t / natural).position.is_nan());
        let motion = FreeResponse::of(&oscillator, State { position: 0.0, velocity: v0 });
        prop_assert!(!motion.state(t / natural).velocity.is_nan());
        let forced = ForcedResponse::of(&oscillator, HarmonicForce::cosine(k.abs(), natural * t), State::REST);
        prop_assert!(!forced.state(t / natural).position.is_nan());
        let steady = FrequencyResponse::at(&oscillator, natural * t);
        prop_assert!(!steady.amplitude(x0).is_nan() && !steady.phase_lag().is_nan() && !steady.transmissibility().is_nan());
    }
}

#[test]
fn the_regimes_join_at_critical_damping() {
    for (m, c, k) in [
        (0.1, 0.2, 0.1),
        (1.0, 2.0, 1.0),
        (3.0, 6.0, 3.0),
        (0.25, 4.0, 16.0_f64),
    ] {
        for phase in [0.01, 0.5, 3.0, 40.0, 300.0] {
            let rate = (k / m).sqrt();
            let at = |c: f64| free(m, c, k, 1.0, 0.5).state(phase / rate);
            let (below, critical, above) = (at(f64::next_down(c)), at(c), at(f64::next_up(c)));
            // One unit in the last place of c changes the motion by as much times the square of the phase.
            let scale = 1e-15 * exp(-phase) * (2.0 + phase) * (1.0 + phase) * (1.0 + phase);
            for side in [below, above] {
                assert!(
                    (side.position - critical.position).abs() < scale,
                    "{c} {phase}"
                );
                assert!(
                    (side.velocity - critical.velocity).abs() < scale * (1.0 + rate),
                    "{c} {phase}"
                );
            }
        }
    }
}

/// m x'' + c x' + k x = F cos Ωt as a first-order system.
struct Equation {
    m: f64,
    c: f64,
    k: f64,
    force: f64,
    frequency: f64,
}

impl ODE<f64, [f64; 2]> for Equation {
    fn diff(&self, t: f64, y: &[f64; 2], dydt: &mut [f64; 2]) {
        let force = self.force * cos(self.frequency * t);
        *dydt = [y[1], (force - self.c * y[1] - self.k * y[0]) / self.m];
    }
}

#[test]
fn a_time_integrator_agrees() {
    for c in [0.0, 0.02, 0.5, 2.0, 3.0, 9.0] {
        for frequency in [0.0, 0.6, 1.0, 1.0001, 4.0] {
            let equation = Equation {
                m: 1.0,
                c,
                k: 1.0,
                force: 0.8,
                frequency,
            };
            let start = State {
                position: 0.3,
                velocity: -0.4,
            };
            let solver = ExplicitRungeKutta::dop853().rtol(1e-12).atol(1e-14);
            let solution = IVP::ode(&equation, 0.0, 25.0, [start.position, start.velocity])
                .method(solver)
                .solve()
                .unwrap();
            let motion = ForcedResponse::of(
                &oscillator(1.0, c, 1.0),
                HarmonicForce::cosine(0.8, frequency),
                start,
            );
            for (t, y) in solution.t.iter().zip(&solution.y) {
                let state = motion.state(*t);
                assert!(
                    (state.position - y[0]).abs() < 1e-10,
                    "c = {c}, Ω = {frequency}, t = {t}"
                );
                assert!(
                    (state.velocity - y[1]).abs() < 1e-10,
                    "c = {c}, Ω = {frequency}, t = {t}"
                );
            }
        }
    }
}
