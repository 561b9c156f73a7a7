//! Frequencies and shapes against `tests/references/modes.py`, and what holds for every system.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use serde::Deserialize;
use serde_json::{Value, json};
use vibank::compute::answer;
use vibank::numerics::{Dd, powi, scale_by_power_of_two};
use vibank::vibration::modes::{Link, Modes, System, natural_angular_frequencies};

use super::reference::Accuracy;

const REFERENCES: &str = include_str!("../../fixtures/references/modes.jsonl");

const U: f64 = f64::EPSILON / 2.0;

#[derive(Deserialize)]
struct Case {
    name: String,
    #[serde(default)]
    masses: Vec<f64>,
    #[serde(default)]
    springs: Vec<(usize, usize, f64)>,
    #[serde(default, rename = "M")]
    mass: Vec<Vec<f64>>,
    #[serde(default, rename = "K")]
    stiffness: Vec<Vec<f64>>,
    rates: Vec<String>,
    #[serde(default)]
    shapes: Vec<Vec<String>>,
}

impl Case {
    fn links(&self) -> Vec<Link> {
        self.springs
            .iter()
            .map(|&(i, j, k)| Link::between(i, j, k))
            .collect()
    }

    fn system(&self) -> System {
        if self.masses.is_empty() {
            System::of_matrices(&matrix(&self.mass), &matrix(&self.stiffness)).unwrap()
        } else {
            System::of_network(&self.masses, &self.links()).unwrap()
        }
    }

    fn modes(&self) -> Modes {
        Modes::of(self.system()).unwrap()
    }

    fn is_attractive_network(&self) -> bool {
        !self.masses.is_empty() && self.springs.iter().all(|spring| spring.2 >= 0.0)
    }

    /// Largest elastic frequency over the smallest one.
    fn spread(&self) -> f64 {
        let rates: Vec<f64> = self
            .exact_rates()
            .iter()
            .map(|rate| rate.hi().abs())
            .filter(|rate| *rate > 0.0)
            .collect();
        rates.iter().copied().fold(0.0, f64::max)
            / rates.iter().copied().fold(f64::INFINITY, f64::min)
    }

    fn exact_rates(&self) -> Vec<Dd> {
        self.rates.iter().map(|digits| decimal(digits)).collect()
    }
}

fn matrix(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j])
}

fn cases() -> Vec<Case> {
    REFERENCES
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

/// A decimal number to thirty digits.
fn decimal(text: &str) -> Dd {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let digits = mantissa.trim_start_matches('-').replace('.', "");
    let decimals = mantissa
        .split_once('.')
        .map_or(0, |(_, fraction)| fraction.len());
    let integer = digits.bytes().fold(Dd::ZERO, |value, digit| {
        value * 10.0 + f64::from(digit - b'0')
    });
    let power = exponent.parse::<i32>().unwrap() - decimals as i32;
    // In two steps, so that neither power leaves the range of numbers.
    let half = power / 2;
    let value = integer * Dd::from(10.0).powi(half) * Dd::from(10.0).powi(power - half);
    if mantissa.starts_with('-') {
        -value
    } else {
        value
    }
}

fn rate(modes: &Modes, mode: usize) -> f64 {
    modes
        .natural_angular_frequency(mode)
        .unwrap_or_else(|| -modes.growth_rate(mode).unwrap())
}

fn relative_error(value: f64, expected: Dd) -> f64 {
    if expected == Dd::ZERO {
        value.abs()
    } else {
        ((value - expected) / expected).hi().abs()
    }
}

/// Frequencies of networks.
pub(super) fn frequencies(table: &mut Accuracy) {
    for case in cases().iter().filter(|case| case.is_attractive_network()) {
        let modes = case.modes();
        let values = natural_angular_frequencies(modes.system()).unwrap();
        for (mode, expected) in case.exact_rates().into_iter().enumerate() {
            let target = (modes.count().max(2) as f64) * U;
            if expected == Dd::ZERO {
                table.record(
                    "rigid modes exactly zero",
                    rate(&modes, mode) + values[mode],
                    f64::MIN_POSITIVE,
                    || case.name.clone(),
                );
            } else {
                table.record(
                    "frequencies of a network (n u)",
                    relative_error(rate(&modes, mode), expected),
                    target,
                    || case.name.clone(),
                );
                table.record(
                    "frequencies without shapes (n u)",
                    relative_error(values[mode], expected),
                    target,
                    || case.name.clone(),
                );
            }
        }
    }
}

/// Rates of matrices and of repelling springs.
pub(super) fn rates_of_matrices(table: &mut Accuracy) {
    for case in cases().iter().filter(|case| !case.is_attractive_network()) {
        let (modes, expected) = (case.modes(), case.exact_rates());
        let refined = modes.refined();
        let largest = expected
            .iter()
            .map(|rate| rate.hi().abs())
            .fold(0.0, f64::max);
        for (mode, expected) in expected.into_iter().enumerate() {
            let error = (rate(&modes, mode) - expected).hi().abs() / largest;
            table.record(
                "rates of matrices, of the largest (10 n u)",
                error,
                10.0 * modes.count() as f64 * U,
                || case.name.clone(),
            );
            let signed = refined
                .natural_angular_frequency(mode)
                .unwrap_or_else(|| -refined.growth_rate(mode).unwrap());
            let error = (signed - expected).hi().abs() / expected.hi().abs().max(f64::MIN_POSITIVE);
            table.record("refined rates of matrices", error, 1e-24, || {
                case.name.clone()
            });
        }
    }
}

/// Frequencies as requests are answered.
pub(super) fn requests(table: &mut Accuracy) {
    for case in cases().iter().filter(|case| case.rates.len() <= 64) {
        let params = if case.masses.is_empty() {
            json!({ "M": case.mass, "K": case.stiffness })
        } else {
            json!({ "masses": case.masses, "springs": case.springs })
        };
        let reply = answer(&json!({ "id": 1, "task": "modes", "params": params }).to_string());
        let reply: Value = serde_json::from_str(&reply).unwrap();
        for (mode, expected) in case.exact_rates().into_iter().enumerate() {
            let frequency = reply["result"]["omega"][mode].as_f64();
            let value =
                frequency.unwrap_or_else(|| -reply["result"]["growth"][mode].as_f64().unwrap());
            table.record(
                "frequencies by request",
                relative_error(value, expected),
                if case.spread() < 1e16 { 2.0 } else { 5.0 } * U,
                || case.name.clone(),
            );
        }
        if case.rates.len() > 10 && !case.shapes.is_empty() {
            shapes_by_request(table, case, &reply);
        }
    }
}

/// Shapes of larger systems, each component times the root of its mass, as requests are answered.
fn shapes_by_request(table: &mut Accuracy, case: &Case, reply: &Value) {
    let masses = case.modes().system().mass_matrix().diagonal();
    for (mode, exact) in case.shapes.iter().enumerate() {
        let exact: Vec<f64> = exact.iter().map(|digits| decimal(digits).hi()).collect();
        let component = |i: usize| reply["result"]["shapes"][mode][i].as_f64().unwrap();
        let product: f64 = (0..exact.len())
            .map(|i| component(i) * exact[i] * masses[i])
            .sum();
        for (i, y) in exact.iter().enumerate() {
            table.record(
                "shapes by request, component by component (4 n u)",
                (component(i) - product.signum() * y).abs() * masses[i].sqrt(),
                4.0 * exact.len() as f64 * U,
                || case.name.clone(),
            );
        }
    }
}

/// Frequencies to twice the digits.
pub(super) fn refined_frequencies(table: &mut Accuracy) {
    for case in cases()
        .iter()
        .filter(|case| case.is_attractive_network() && case.rates.len() <= 50)
    {
        let refined = case.modes().refined();
        for (mode, expected) in case.exact_rates().into_iter().enumerate() {
            let value = refined.natural_angular_frequency(mode).unwrap();
            let error = if expected == Dd::ZERO {
                value.hi()
            } else {
                ((value - expected) / expected).hi().abs()
            };
            if case.spread() <= 1e16 {
                table.record("refined frequencies of a network", error, 1e-21, || {
                    case.name.clone()
                });
            } else {
                table.record(
                    "the same, spread above 1e15 (n u)",
                    error,
                    case.rates.len() as f64 * U,
                    || case.name.clone(),
                );
            }
        }
    }
}

/// Shapes against the span of the exact ones.
pub(super) fn shapes(table: &mut Accuracy) {
    for case in cases()
        .iter()
        .filter(|case| !case.shapes.is_empty() && case.is_attractive_network())
    {
        let modes = case.modes();
        for cluster in modes.clusters(1e-9) {
            let exact: Vec<Vec<f64>> = case.shapes[cluster.clone()]
                .iter()
                .map(|shape| shape.iter().map(|digits| decimal(digits).hi()).collect())
                .collect();
            let gap = modes.relative_gap(cluster.clone()).min(1.0);
            let target = 10.0 * modes.count() as f64 * U / gap;
            let sine = modes.largest_principal_angle_sine(cluster, &exact).unwrap();
            table.record(
                "shapes, sine of the largest angle (10 n u/relgap)",
                sine,
                target,
                || case.name.clone(),
            );
        }
    }
}

/// Shapes of close modes, component by component.
pub(super) fn refined_shapes(table: &mut Accuracy) {
    for case in cases()
        .iter()
        .filter(|case| case.name.starts_with("weak coupling"))
    {
        let refined = case.modes().refined();
        for (mode, exact) in case.shapes.iter().enumerate() {
            let exact: Vec<f64> = exact.iter().map(|digits| decimal(digits).hi()).collect();
            let sign = exact[0].signum();
            for (x, y) in refined.mode_shape(mode).iter().zip(&exact) {
                table.record(
                    "refined shapes, component by component (4 n u)",
                    (x - sign * y).abs(),
                    16.0 * U,
                    || case.name.clone(),
                );
            }
        }
    }
}

fn spectral_scale(matrix: &DMatrix<f64>) -> f64 {
    (0..matrix.nrows())
        .map(|i| matrix.row(i).iter().map(|x| x.abs()).sum::<f64>())
        .fold(0.0, f64::max)
}

/// Residuals and orthogonality.
pub(super) fn residuals(table: &mut Accuracy) {
    for case in cases().iter().filter(|case| case.masses.len() != 200) {
        let modes = case.modes();
        let (mass, stiffness) = (
            modes.system().mass_matrix(),
            modes.system().stiffness_matrix(),
        );
        let target = 10.0 * modes.count().max(2) as f64 * U;
        let shapes = modes.modal_matrix();
        let defect = (shapes.transpose() * &mass * &shapes
            - DMatrix::identity(modes.count(), modes.count()))
        .amax();
        table.record(
            "orthogonality |Uᵀ M U - I| (10 n u)",
            defect,
            target,
            || case.name.clone(),
        );
        for mode in 0..modes.count() {
            let shape = DVector::from_vec(modes.mode_shape(mode));
            let eigenvalue = modes.eigenvalue(mode);
            let rest = (&stiffness * &shape - &mass * &shape * eigenvalue).norm();
            let scale = (spectral_scale(&stiffness) + eigenvalue.abs() * spectral_scale(&mass))
                * shape.norm();
            if scale > 0.0 {
                table.record(
                    "residual |K u - ω² M u|, of |K| + ω² |M| (10 n u)",
                    rest / scale,
                    target,
                    || case.name.clone(),
                );
            }
        }
    }
}

/// A network of random masses and springs, some of them to the ground.
fn networks(spread: i32) -> impl Strategy<Value = (Vec<f64>, Vec<Link>)> {
    let magnitude = move || (1.0..10.0_f64, -spread..=spread).prop_map(|(x, n)| x * powi(10.0, n));
    (2..9_usize).prop_flat_map(move |count| {
        let masses = prop::collection::vec(magnitude(), count);
        let springs = prop::collection::vec((0..=count, 1..=count, magnitude()), count..3 * count);
        (masses, springs).prop_map(|(masses, springs)| {
            let links = springs
                .into_iter()
                .filter(|(i, j, _)| i != j)
                .map(|(i, j, k)| Link::between(i, j, k))
                .collect();
            (masses, links)
        })
    })
}

fn rates(masses: &[f64], springs: &[Link]) -> Vec<f64> {
    let modes = Modes::of_network(masses, springs).unwrap();
    (0..modes.count()).map(|mode| rate(&modes, mode)).collect()
}

proptest! {
    #[test]
    fn eigenvalues_add_up_to_the_trace((masses, springs) in networks(2)) {
        let modes = Modes::of_network(&masses, &springs).unwrap();
        let sum: f64 = (0..modes.count()).map(|mode| modes.eigenvalue(mode)).sum();
        let trace: f64 = (0..masses.len()).map(|i| modes.system().stiffness_matrix()[(i, i)] / masses[i]).sum();
        prop_assert!((sum - trace).abs() <= 1e-14 * trace, "{sum} {trace}");
    }

    #[test]
    fn eigenvalues_multiply_to_the_determinant((masses, springs) in networks(1)) {
        let modes = Modes::of_network(&masses, &springs).unwrap();
        let product: f64 = (0..modes.count()).map(|mode| modes.eigenvalue(mode)).product();
        let determinant = modes.system().stiffness_matrix().determinant() / masses.iter().product::<f64>();
        let scale: f64 = (0..masses.len()).map(|i| modes.system().stiffness_matrix()[(i, i)] / masses[i]).product();
        prop_assert!((product - determinant).abs() <= 1e-12 * scale, "{product} {determinant}");
    }

    #[test]
    fn plain_frequencies_agree_with_refined_ones((masses, springs) in networks(3)) {
        let modes = Modes::of_network(&masses, &springs).unwrap();
        let refined = modes.refined();
        for mode in modes.rigid_count()..modes.count() {
            let error = relative_error(rate(&modes, mode), refined.natural_angular_frequency(mode).unwrap());
            prop_assert!(error <= modes.count() as f64 * U, "{} u", error / U);
        }
    }

    #[test]
    fn one_more_spring_interlaces((masses, springs) in networks(3), stiffness in 0.001..1000.0) {
        let before = rates(&masses, &springs);
        let mut more = springs;
        more.push(Link::between(1, 2, stiffness));
        let after = rates(&masses, &more);
        let margin = 1.0 + 1e-13;
        for mode in 0..before.len() {
            prop_assert!(after[mode] * margin >= before[mode]);
            if mode + 1 < before.len() {
                prop_assert!(after[mode] <= before[mode + 1] * margin);
            }
        }
    }

    #[test]
    fn units_that_are_powers_of_two_change_no_bit((masses, springs) in networks(4), mass in -40..40_i32, time in -40..40_i32) {
        let scaled = |x: f64, n: i32| scale_by_power_of_two(x, n);
        let heavier: Vec<f64> = masses.iter().map(|m| scaled(*m, mass)).collect();
        let stiffer: Vec<Link> =
            springs.iter().map(|s| Link { coefficient: scaled(s.coefficient, mass - 2 * time), ..*s }).collect();
        let expected: Vec<f64> = rates(&masses, &springs).iter().map(|rate| scaled(*rate, -time)).collect();
        prop_assert_eq!(rates(&heavier, &stiffer), expected);
    }

    #[test]
    fn finite_data_give_finite_modes_or_an_error((masses, springs) in networks(300)) {
        if let Ok(modes) = Modes::of_network(&masses, &springs) {
            for mode in 0..modes.count() {
                prop_assert!(rate(&modes, mode).is_finite());
                prop_assert!(modes.mode_shape(mode).iter().all(|x| !x.is_nan()));
            }
        }
    }

    #[test]
    fn springs_of_either_sign_give_finite_modes((masses, springs) in networks(3), signs in prop::collection::vec(any::<bool>(), 27)) {
        let springs: Vec<Link> = springs
            .iter()
            .zip(signs)
            .map(|(s, negative)| Link { coefficient: if negative { -s.coefficient } else { s.coefficient }, ..*s })
            .collect();
        let modes = Modes::of_network(&masses, &springs).unwrap();
        let sum: f64 = (0..modes.count()).map(|mode| modes.eigenvalue(mode)).sum();
        let stiffness = modes.system().stiffness_matrix();
        let trace: f64 = (0..masses.len()).map(|i| stiffness[(i, i)] / masses[i]).sum();
        let scale: f64 = (0..modes.count()).map(|mode| modes.eigenvalue(mode).abs()).sum();
        prop_assert!((sum - trace).abs() <= 1e-12 * scale, "{} {} {}", sum, trace, scale);
        prop_assert!((0..modes.count()).all(|mode| modes.refined().eigenvalue(mode).is_finite()));
    }
}

#[test]
fn squares_of_springs_are_the_network() {
    let (masses, springs) = (
        DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, 2.0, 1.0])),
        [1e-12, 3.0, 1e9],
    );
    let rows = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 1.0, -1.0]);
    let squares = Modes::of_squares(&masses, &rows, &springs).unwrap();
    let links = [
        Link::to_ground(1, 1e-12),
        Link::between(1, 2, 3.0),
        Link::between(2, 3, 1e9),
    ];
    let network = Modes::of_network(&[1.0, 2.0, 1.0], &links).unwrap();
    for mode in 0..3 {
        assert_eq!(
            squares.natural_angular_frequency(mode),
            network.natural_angular_frequency(mode)
        );
    }
}

#[test]
fn squares_keep_small_frequencies_that_their_matrix_loses() {
    // Coordinates x1 and x2 - x1: the mass matrix is coupled, the weak wall and the stiff spring are one square each.
    let mass = DMatrix::from_row_slice(2, 2, &[3.0, 2.0, 2.0, 2.0]);
    let rows = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 1.0]);
    let modes = Modes::of_squares(&mass, &rows, &[1e-9, 1e9]).unwrap();
    let links = [Link::to_ground(1, 1e-9), Link::between(1, 2, 1e9)];
    let expected = Modes::of_network(&[1.0, 2.0], &links).unwrap();
    for mode in 0..2 {
        let (a, b) = (
            modes.natural_angular_frequency(mode).unwrap(),
            expected.natural_angular_frequency(mode).unwrap(),
        );
        assert!((a / b - 1.0).abs() < 4.0 * U, "{a} {b}");
    }
}

#[test]
fn data_that_are_no_system_are_refused_by_name() {
    let message = |masses: &[f64], springs: &[Link]| {
        Modes::of_network(masses, springs).unwrap_err().to_string()
    };
    assert_eq!(message(&[], &[]), "there is no mass");
    assert_eq!(
        message(&[1.0, 0.0], &[]),
        "the mass of node 2 is 0 kg: it must be positive and finite"
    );
    assert_eq!(
        message(&[1.0], &[Link::between(1, 2, 1.0)]),
        "element 1 ends at node 2, but the nodes are 1 to 1, and 0 for the ground"
    );
    assert_eq!(
        message(&[1.0], &[Link::between(1, 1, 1.0)]),
        "element 1 joins node 1 to itself"
    );
    assert_eq!(
        message(&[1.0], &[Link::to_ground(1, f64::NAN)]),
        "the coefficient of element 1 is NaN"
    );
    let indefinite = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 1.0]);
    let error = Modes::of_matrices(&indefinite, &DMatrix::identity(2, 2)).unwrap_err();
    assert_eq!(error.to_string(), "mass matrix not positive definite");
    let skew = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 3.0, 9.0]);
    let error = Modes::of_matrices(&DMatrix::identity(2, 2), &skew).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the matrix is not symmetric at row 2, column 1"
    );
    assert!(Modes::of_matrices(&DMatrix::identity(2, 2), &DMatrix::identity(3, 3)).is_err());
}
