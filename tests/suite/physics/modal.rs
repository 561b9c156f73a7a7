//! Motion of several degrees of freedom against `tests/references/modal_response.py`, and its invariants.

use nalgebra::DMatrix;
use proptest::prelude::*;
use serde::Deserialize;
use vibank::numerics::{Complex, cos, powi, sin};
use vibank::vibration::modal::{
    Damping, ForcedModalResponse, HarmonicForces, HarmonicResponse, ModalResponse,
};
use vibank::vibration::modes::{Link, Modes, ModesError, System};

use super::reference::Accuracy;

const REFERENCES: &str = include_str!("../../fixtures/references/modal-response.jsonl");
const FORCED: &str = include_str!("../../fixtures/references/forced-modal-response.jsonl");

#[derive(Deserialize)]
struct Case {
    name: String,
    masses: Vec<f64>,
    springs: Vec<(usize, usize, f64)>,
    dampers: Vec<(usize, usize, f64)>,
    rayleigh: (f64, f64),
    #[serde(default)]
    x0: Vec<f64>,
    #[serde(default)]
    v0: Vec<f64>,
    #[serde(default)]
    t: Vec<f64>,
    #[serde(default)]
    x: Vec<Vec<String>>,
    #[serde(default)]
    v: Vec<Vec<String>>,
    #[serde(default)]
    forces: Vec<f64>,
    #[serde(default)]
    cosine: Vec<f64>,
    #[serde(default)]
    sine: Vec<f64>,
    #[serde(default)]
    frequency: f64,
    #[serde(default)]
    frequencies: Vec<f64>,
    #[serde(default)]
    amplitudes: Vec<Vec<(String, String)>>,
}

fn links(elements: &[(usize, usize, f64)]) -> Vec<Link> {
    elements
        .iter()
        .map(|&(i, j, k)| Link::between(i, j, k))
        .collect()
}

impl Case {
    fn system(&self) -> System {
        System::of_network(&self.masses, &links(&self.springs)).unwrap()
    }

    fn damping(&self) -> Damping {
        Damping::rayleigh(self.rayleigh.0, self.rayleigh.1).with_dampers(&links(&self.dampers))
    }

    fn motion(&self) -> ModalResponse {
        let modes = Modes::of(self.system()).unwrap();
        let horizon = self.t.iter().copied().fold(0.0, f64::max);
        ModalResponse::of(&modes, &self.damping(), &self.x0, &self.v0, horizon).unwrap()
    }

    fn is_undamped(&self) -> bool {
        self.dampers.is_empty() && self.rayleigh == (0.0, 0.0)
    }
}

fn cases() -> Vec<Case> {
    read(REFERENCES)
}

fn read(references: &str) -> Vec<Case> {
    references
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn numbers(digits: &[String]) -> Vec<f64> {
    digits.iter().map(|x| x.parse().unwrap()).collect()
}

/// The largest difference of components over the largest component.
fn error(values: &[f64], expected: &[f64]) -> f64 {
    let largest = expected
        .iter()
        .fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let difference = values
        .iter()
        .zip(expected)
        .map(|(x, y)| (x - y).abs())
        .fold(0.0, f64::max);
    if difference == 0.0 {
        0.0
    } else {
        difference / largest
    }
}

fn state(motion: &ModalResponse, time: f64, size: usize) -> (Vec<f64>, Vec<f64>) {
    let (mut x, mut v) = (vec![0.0; size], vec![0.0; size]);
    motion.state(time, &mut x, &mut v).unwrap();
    (x, v)
}

/// Motion of several degrees of freedom to long times.
pub(super) fn motion(table: &mut Accuracy) {
    for case in cases().iter().filter(|case| !case.t.is_empty()) {
        let motion = case.motion();
        let name = match (case.is_undamped(), motion.is_classically_damped()) {
            (true, _) => "free motion, undamped, of the largest",
            (_, true) => "free motion, classical damping",
            (_, false) => "free motion, general damping",
        };
        for (i, &time) in case.t.iter().enumerate() {
            let (x, v) = state(&motion, time, case.masses.len());
            let at = || format!("{} t = {time}", case.name);
            table.record(name, error(&x, &numbers(&case.x[i])), 1e-13, at);
            table.record(name, error(&v, &numbers(&case.v[i])), 1e-13, at);
        }
    }
}

/// Motion under a harmonic force to long times.
pub(super) fn forced_motion(table: &mut Accuracy) {
    for case in read(FORCED) {
        let modes = Modes::of(case.system()).unwrap();
        let forces = HarmonicForces {
            cosine: &case.cosine,
            sine: &case.sine,
            angular_frequency: case.frequency,
        };
        let horizon = case.t.iter().copied().fold(0.0, f64::max);
        let motion =
            ForcedModalResponse::of(&modes, &case.damping(), forces, &case.x0, &case.v0, horizon)
                .unwrap();
        let name = if case.dampers.is_empty() {
            "forced motion, modes, of the largest"
        } else {
            "forced motion, general damping"
        };
        for (i, &time) in case.t.iter().enumerate() {
            let (mut x, mut v) = (case.x0.clone(), case.v0.clone());
            motion.state(time, &mut x, &mut v).unwrap();
            let at = || format!("{} t = {time}", case.name);
            table.record(name, error(&x, &numbers(&case.x[i])), 1e-13, at);
            table.record(name, error(&v, &numbers(&case.v[i])), 1e-13, at);
        }
    }
}

#[test]
fn grids_agree_with_samples() {
    for case in cases().iter().filter(|case| !case.t.is_empty()) {
        let (motion, size) = (case.motion(), case.masses.len());
        let step = 20.0 / 128.0;
        let mut grid = vec![0.0; 129 * size];
        motion.grid(0.0, step, &mut grid).unwrap();
        let scale = grid.iter().fold(0.0_f64, |scale, x| scale.max(x.abs()));
        for (i, sample) in grid.chunks_exact(size).enumerate() {
            let (x, _) = state(&motion, step * i as f64, size);
            for (a, b) in x.iter().zip(sample) {
                assert!((a - b).abs() < 2e-14 * scale, "{} {i}: {a} {b}", case.name);
            }
        }
    }
}

#[test]
fn which_damping_is_classical() {
    for case in cases().iter().filter(|case| !case.t.is_empty()) {
        let expected = !case.name.contains("damper") && case.name != "defective"
            || case.name == "dampers beside springs";
        // A damper that acts on one mode alone, or on the relative motion of a pair of equal oscillators.
        let by_symmetry =
            ["isolated and dragged", "critical pair", "defective"].contains(&case.name.as_str());
        assert_eq!(
            case.motion().is_classically_damped(),
            expected || by_symmetry,
            "{}",
            case.name
        );
    }
}

/// Steady states next to resonance.
pub(super) fn steady(table: &mut Accuracy) {
    for case in cases().iter().filter(|case| !case.frequencies.is_empty()) {
        for (i, &frequency) in case.frequencies.iter().enumerate() {
            let response =
                HarmonicResponse::of(&case.system(), &case.damping(), frequency).unwrap();
            let forces: Vec<Complex> = case.forces.iter().copied().map(Complex::from).collect();
            let amplitudes = response.amplitudes(&forces).unwrap();
            for (value, (re, im)) in amplitudes.iter().zip(&case.amplitudes[i]) {
                let expected = Complex::new(re.parse().unwrap(), im.parse().unwrap());
                let error = (*value - expected).abs() / expected.abs();
                table.record("steady state, each amplitude", error, 1e-15, || {
                    format!("{} {frequency}", case.name)
                });
            }
        }
    }
}

#[test]
fn undamped_resonance_has_no_steady_state() {
    let springs = [
        Link::to_ground(1, 3.0),
        Link::between(1, 2, 2.0),
        Link::to_ground(2, 1.0),
    ];
    let system = System::of_network(&[1.0, 2.0], &springs).unwrap();
    let error = HarmonicResponse::of(&system, &Damping::none(), 1.0).unwrap_err();
    assert_eq!(error, ModesError::Resonance);
}

#[test]
fn a_force_on_a_coupled_system_is_found_by_both_routes() {
    let springs = [
        Link::to_ground(1, 3.0),
        Link::between(1, 2, 2.0),
        Link::to_ground(2, 1.0),
    ];
    let modes = Modes::of_network(&[1.0, 2.0], &springs).unwrap();
    let (cosine, sine) = ([1.0, -0.5], [0.25, 2.0]);
    for frequency in [0.0, 0.3, 1.0, 1.7, 20.0] {
        let forces = HarmonicForces {
            cosine: &cosine,
            sine: &sine,
            angular_frequency: frequency,
        };
        // A damper too weak to be seen makes the modes coupled; the other route drives them one by one.
        let nearly = Damping::rayleigh(0.1, 0.0).with_dampers(&[Link::to_ground(1, 1e-13)]);
        let x0 = ([0.5, 0.0], [0.0, -1.0]);
        let motion = |damping: &Damping| {
            ForcedModalResponse::of(&modes, damping, forces, &x0.0, &x0.1, 50.0).unwrap()
        };
        let (one, other) = (motion(&Damping::rayleigh(0.1, 0.0)), motion(&nearly));
        for time in [0.0, 0.1, 3.0, 50.0] {
            let mut states = [[0.0; 2]; 4];
            let [x, v, y, w] = &mut states;
            one.state(time, x, v).unwrap();
            other.state(time, y, w).unwrap();
            for i in 0..2 {
                assert!(
                    (x[i] - y[i]).abs() < 1e-12,
                    "{frequency} {time}: {x:?} {y:?}"
                );
                assert!(
                    (v[i] - w[i]).abs() < 1e-12,
                    "{frequency} {time}: {v:?} {w:?}"
                );
            }
        }
    }
}

#[test]
fn a_forced_free_body_accelerates() {
    let modes = Modes::of_network(&[1.0, 3.0], &[Link::between(1, 2, 2.0)]).unwrap();
    let forces = HarmonicForces {
        cosine: &[8.0, 0.0],
        sine: &[0.0, 0.0],
        angular_frequency: 0.0,
    };
    let motion = ForcedModalResponse::of(
        &modes,
        &Damping::none(),
        forces,
        &[0.0; 2],
        &[0.0; 2],
        100.0,
    )
    .unwrap();
    let (mut x, mut v) = ([0.0; 2], [0.0; 2]);
    motion.state(10.0, &mut x, &mut v).unwrap();
    let centre = (x[0] + 3.0 * x[1]) / 4.0;
    assert!((centre - 100.0).abs() < 1e-11, "{centre}");
}

/// Masses, springs, dampers, displacements and velocities.
type Drawn = (Vec<f64>, Vec<Link>, Vec<Link>, Vec<f64>, Vec<f64>);

fn systems() -> impl Strategy<Value = Drawn> {
    (2..6_usize).prop_flat_map(|count| {
        let element = || (0..=count, 1..=count, 0.1..10.0_f64);
        let keep = |elements: Vec<(usize, usize, f64)>| -> Vec<Link> {
            links(&elements)
                .into_iter()
                .filter(|link| link.ends[0] != link.ends[1])
                .collect()
        };
        (
            prop::collection::vec(0.1..10.0_f64, count),
            prop::collection::vec(element(), count..2 * count).prop_map(keep),
            prop::collection::vec(element(), 0..3).prop_map(keep),
            prop::collection::vec(-1.0..1.0_f64, count),
            prop::collection::vec(-1.0..1.0_f64, count),
        )
    })
}

fn energy(modes: &Modes, x: &[f64], v: &[f64]) -> f64 {
    let form = |matrix: DMatrix<f64>, y: &[f64]| {
        let y = nalgebra::DVector::from_column_slice(y);
        y.dot(&(matrix * &y)) / 2.0
    };
    form(modes.system().mass_matrix(), v) + form(modes.system().stiffness_matrix(), x)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn energy_stays_or_decays((masses, springs, dampers, x0, v0) in systems(), time in 0.1..100.0) {
        let modes = Modes::of_network(&masses, &springs).unwrap();
        let before = energy(&modes, &x0, &v0);
        let motion = ModalResponse::of(&modes, &Damping::of_dampers(&dampers), &x0, &v0, time).unwrap();
        let (x, v) = state(&motion, time, masses.len());
        let after = energy(&modes, &x, &v);
        // Rigid motion carries the coordinates far away; its elastic energy is a small difference there.
        let reach = x.iter().map(|x| x * x).sum::<f64>() * 20.0;
        if dampers.is_empty() {
            prop_assert!((after - before).abs() <= 1e-12 * (before + reach), "{before} {after}");
        } else {
            prop_assert!(after <= before + 1e-12 * (before + reach), "{before} {after}");
        }
    }

    #[test]
    fn two_short_motions_are_one_long((masses, springs, dampers, x0, v0) in systems(), first in 0.0..5.0, second in 0.0..5.0) {
        let modes = Modes::of_network(&masses, &springs).unwrap();
        let damping = Damping::rayleigh(0.05, 0.01).with_dampers(&dampers);
        let size = masses.len();
        let motion = ModalResponse::of(&modes, &damping, &x0, &v0, 10.0).unwrap();
        let (x1, v1) = state(&motion, first, size);
        let rest = ModalResponse::of(&modes, &damping, &x1, &v1, 10.0).unwrap();
        let ((x, v), (y, w)) = (state(&motion, first + second, size), state(&rest, second, size));
        for i in 0..size {
            prop_assert!((x[i] - y[i]).abs() < 1e-12 && (v[i] - w[i]).abs() < 1e-12, "{:?} {:?}", x, y);
        }
    }

    #[test]
    fn receptances_are_reciprocal((masses, springs, dampers, _, _) in systems(), frequency in 0.01..10.0) {
        let system = System::of_network(&masses, &springs).unwrap();
        let damping = Damping::rayleigh(0.01, 0.0).with_dampers(&dampers);
        let response = HarmonicResponse::of(&system, &damping, frequency).unwrap();
        let (there, back) = (response.receptances(0).unwrap()[1], response.receptances(1).unwrap()[0]);
        prop_assert!((there - back).abs() <= 1e-14 * there.abs() + 1e-300);
    }

    #[test]
    fn no_finite_system_gives_nan((masses, springs, dampers, x0, v0) in systems(), exponent in -150..150_i32, time in 0.0..1e12) {
        let scale = powi(10.0, exponent);
        let scaled = |elements: &[Link]| -> Vec<Link> {
            elements.iter().map(|link| Link { coefficient: link.coefficient * scale, ..*link }).collect()
        };
        let Ok(modes) = Modes::of_network(&masses, &scaled(&springs)) else { return Ok(()) };
        let damping = Damping::of_dampers(&scaled(&dampers));
        if let Ok(motion) = ModalResponse::of(&modes, &damping, &x0, &v0, time) {
            let (x, v) = state(&motion, time, masses.len());
            prop_assert!(x.iter().chain(&v).all(|x| x.is_finite()), "{x:?} {v:?}");
        }
    }
}

#[test]
fn a_steady_state_is_where_a_forced_motion_ends() {
    let springs = [
        Link::to_ground(1, 3.0),
        Link::between(1, 2, 2.0),
        Link::to_ground(2, 1.0),
    ];
    let modes = Modes::of_network(&[1.0, 2.0], &springs).unwrap();
    let damping = Damping::of_dampers(&[Link::to_ground(1, 0.8)]);
    let forces = HarmonicForces {
        cosine: &[1.0, 0.0],
        sine: &[0.0, 0.0],
        angular_frequency: 1.3,
    };
    let motion =
        ForcedModalResponse::of(&modes, &damping, forces, &[0.3, 0.0], &[0.0, 0.0], 1000.0)
            .unwrap();
    let response = HarmonicResponse::of(modes.system(), &damping, 1.3).unwrap();
    let amplitudes = response.amplitudes(&[Complex::ONE, Complex::ZERO]).unwrap();
    let (mut x, mut v) = ([0.0; 2], [0.0; 2]);
    motion.state(1000.0, &mut x, &mut v).unwrap();
    for (x, amplitude) in x.iter().zip(amplitudes) {
        let expected = amplitude.re * cos(1300.0) - amplitude.im * sin(1300.0);
        assert!((x - expected).abs() < 1e-13, "{x} {expected}");
    }
}
