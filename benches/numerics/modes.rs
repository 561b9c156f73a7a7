//! Natural frequencies: networks against dense matrices.

use nalgebra::DMatrix;
use vibank::numerics::Dd;
use vibank::vibration::modes::{Link, Modes, Pair, System, natural_angular_frequencies};

use crate::measure::time;
use crate::record::{Error, Record};

/// Masses of 1 kg and springs of 1 N/m in a row from a wall.
pub(crate) fn uniform_chain(size: usize) -> (Vec<f64>, Vec<Link>) {
    (
        vec![1.0; size],
        (1..=size).map(|i| Link::between(i - 1, i, 1.0)).collect(),
    )
}

/// `2 sin((2i-1) π/(4n+2))`.
pub(crate) fn exact_frequencies(size: usize) -> Vec<Dd> {
    let turn = Dd::PI / (4 * size + 2) as f64;
    (0..size)
        .map(|i| (turn * (2 * i + 1) as f64).sin() * 2.0)
        .collect()
}

/// Largest relative error.
fn error(values: &[f64], exact: &[Dd]) -> f64 {
    let errors = values
        .iter()
        .zip(exact)
        .map(|(value, exact)| ((*value - *exact) / *exact).hi().abs());
    errors
        .map(|error| if error.is_nan() { 1.0 } else { error })
        .fold(0.0, f64::max)
}

fn all_frequencies(modes: &Modes) -> Vec<f64> {
    (0..modes.count())
        .filter_map(|mode| modes.natural_angular_frequency(mode))
        .collect()
}

/// The assembled matrix `M^(-1/2) K M^(-1/2)` and its dense symmetric eigenvalues.
fn dense_symmetric(masses: &[f64], springs: &[Link]) -> Vec<f64> {
    let size = masses.len();
    let mut matrix = DMatrix::<f64>::zeros(size, size);
    for link in springs {
        for (row, sign) in link.ends.iter().zip([1.0, -1.0]) {
            for (column, other) in link.ends.iter().zip([1.0, -1.0]) {
                if *row > 0 && *column > 0 {
                    matrix[(row - 1, column - 1)] += sign * other * link.coefficient;
                }
            }
        }
    }
    for i in 0..size {
        for j in 0..size {
            matrix[(i, j)] /= (masses[i] * masses[j]).sqrt();
        }
    }
    let mut values: Vec<f64> = matrix
        .symmetric_eigen()
        .eigenvalues
        .iter()
        .map(|value| value.sqrt())
        .collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The quadratic formula of the characteristic equation of two masses.
fn characteristic_equation([m1, m2]: [f64; 2], [k01, k12, k02]: [f64; 3]) -> Vec<f64> {
    let (a, c) = ((k01 + k12) / m1, (k02 + k12) / m2);
    let (sum, product) = (a + c, a * c - k12 / m1 * k12 / m2);
    let root = (sum * sum / 4.0 - product).sqrt();
    vec![(sum / 2.0 - root).sqrt(), (sum / 2.0 + root).sqrt()]
}

/// The task and case of a network, with the small number of a sweep.
#[derive(Clone, Copy)]
struct Place<'a> {
    task: &'a str,
    case: &'a str,
    parameter: Option<f64>,
}

impl Place<'_> {
    fn record(self, method: &'static str, exact: &[Dd], solve: &dyn Fn() -> Vec<f64>) -> Record {
        Record {
            task: self.task.to_owned(),
            case: self.case.to_owned(),
            parameter: self.parameter,
            method,
            tolerance: None,
            timing: time(|_| solve()),
            error: Error::computed(error(&solve(), exact)),
        }
    }
}

/// The measurements of one network.
fn measure(place: Place<'_>, (masses, springs): (&[f64], &[Link]), exact: &[Dd]) -> [Record; 3] {
    let system = System::of_network(masses, springs).expect("the network is sound");
    [
        place.record("vibank (with shapes)", exact, &|| {
            all_frequencies(&Modes::of_network(masses, springs).expect("the network is sound"))
        }),
        place.record("vibank (frequencies)", exact, &|| {
            natural_angular_frequencies(&system).expect("the network is stable")
        }),
        place.record("dense symmetric QR", exact, &|| {
            dense_symmetric(masses, springs)
        }),
    ]
}

/// Uniform chains of two to two hundred masses.
pub(crate) fn against_size(records: &mut Vec<Record>) {
    for size in [2, 3, 5, 10, 20, 50, 100, 200] {
        let (masses, springs) = uniform_chain(size);
        let place = Place {
            task: "modes-against-size",
            case: &format!("n={size}"),
            parameter: None,
        };
        records.extend(measure(
            place,
            (&masses, &springs),
            &exact_frequencies(size),
        ));
    }
}

/// Two masses whose wall fades away, in closed form and as networks.
pub(crate) fn against_stiffness_ratio(records: &mut Vec<Record>) {
    for power in [0, 3, 6, 9, 12, 15] {
        let weak = vibank::numerics::powi(10.0, -power);
        let springs = [weak, 1.0, 0.0];
        let links = [Link::to_ground(1, weak), Link::between(1, 2, 1.0)];
        let exact = pair_of_unit_masses(weak);
        let place = Place {
            task: "modes-against-stiffness-ratio",
            case: &format!("ratio=1e{power}"),
            parameter: Some(weak),
        };
        records.push(place.record("vibank (closed form)", &exact, &|| {
            Pair::of_network([1.0; 2], springs)
                .natural_angular_frequencies()
                .to_vec()
        }));
        records.push(place.record("characteristic equation", &exact, &|| {
            characteristic_equation([1.0; 2], springs)
        }));
        records.extend(measure(place, (&[1.0; 2], &links), &exact));
    }
}

/// `ω⁴ - (2 + k) ω² + k = 0` for a wall spring k and a coupling of 1 N/m.
fn pair_of_unit_masses(wall: f64) -> Vec<Dd> {
    let half_sum = Dd::from(2.0) * 0.5 + Dd::from(wall) * 0.5;
    let larger = half_sum + (half_sum.square() - wall).sqrt();
    vec![(Dd::from(wall) / larger).sqrt(), larger.sqrt()]
}
