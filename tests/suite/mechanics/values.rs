//! Numbers of models against closed forms of the textbooks.

use std::sync::Arc;

use vibank::expr::{Expr, Name, Precise, Program, Slots, Value, Workspace};
use vibank::mechanics::{
    Coordinate, Definition, Friction, Initial, Model, Numbers, Quantity, QuantityType, Unavailable,
};
use vibank::numerics::Rational;

use super::{named, read};

/// A model with data, and what has to come out.
struct Case {
    coordinates: &'static [&'static str],
    kinematics: &'static [(&'static str, &'static str)],
    kinetic: &'static str,
    potential: &'static str,
    dissipation: &'static str,
    forces: &'static [(&'static str, &'static str)],
    friction: &'static [(&'static str, &'static str)],
    initial: &'static [(&'static str, [&'static str; 2])],
    data: &'static [(&'static str, &'static str)],
    /// Quantities and closed forms in the data; functions of time are compared at many times.
    expected: &'static [(&'static str, &'static str)],
}

const PLAIN: Case = Case {
    coordinates: &["x"],
    kinematics: &[],
    kinetic: "0",
    potential: "0",
    dissipation: "0",
    forces: &[],
    friction: &[],
    initial: &[],
    data: &[],
    expected: &[],
};

impl Case {
    fn model(&self) -> Model {
        let friction = named(self.friction).into_iter().map(|(name, kinetic)| {
            let holding = None;
            (name, Friction { kinetic, holding })
        });
        let initial = self.initial.iter().map(|(name, [position, velocity])| {
            let (position, velocity) = (read(position), read(velocity));
            (Name::from(*name), Initial { position, velocity })
        });
        let coordinate = |text: &&str| match text.strip_suffix('°') {
            Some(name) => Coordinate::angle(name),
            None => Coordinate::length(*text),
        };
        Model::derive(Definition {
            coordinates: self.coordinates.iter().map(coordinate).collect(),
            kinematics: named(self.kinematics),
            kinetic: read(self.kinetic),
            potential: read(self.potential),
            dissipation: read(self.dissipation),
            forces: named(self.forces),
            friction: friction.collect(),
            initial: initial.collect(),
            ..Definition::default()
        })
        .unwrap()
    }

    fn datum(&self, name: &str) -> Option<Precise> {
        let (_, text) = self.data.iter().find(|(own, _)| *own == name)?;
        Rational::from_decimal(text).map(Precise::from)
    }

    fn numbers(&self) -> Numbers {
        Numbers::of(Arc::new(self.model()), |name| {
            Ok(self.datum(name.as_str()).unwrap())
        })
    }

    /// A closed form at a time.
    fn closed_form(&self, formula: &str, time: f64) -> Value {
        let names: Vec<_> = self
            .data
            .iter()
            .map(|(name, _)| *name)
            .chain(["t"])
            .collect();
        let mut data: Vec<_> = self
            .data
            .iter()
            .map(|(name, _)| self.datum(name).unwrap())
            .collect();
        data.push(Precise::exact(time));
        let program = Program::compile(&Expr::read(formula).unwrap(), &Slots(&names)).unwrap();
        program
            .evaluate(&data[..], &mut Workspace::default())
            .unwrap()
    }

    fn is_stable(&self) -> bool {
        let value = self.numbers().value_of(Quantity::Stable).unwrap();
        value.as_boolean().unwrap()
    }

    fn check(&self) {
        let numbers = self.numbers();
        for (path, formula) in self.expected {
            let names: Vec<_> = path.split('.').map(Name::from).collect();
            let quantity = numbers.model().quantity(&names).unwrap();
            if let QuantityType::Motion(_) = QuantityType::of(numbers.model(), quantity) {
                let motion = numbers.motion_of(quantity).unwrap();
                let times = (0..40).map(|step| 0.173 * f64::from(step));
                let pairs: Vec<_> = times
                    .map(|time| {
                        let expected = self.closed_form(formula, time).as_real().unwrap();
                        (motion.at(0, time).unwrap(), expected)
                    })
                    .collect();
                check_close(path, &pairs);
            } else {
                let value = numbers
                    .value_of(quantity)
                    .unwrap_or_else(|lack| panic!("{path}: {lack}"));
                let expected = self.closed_form(formula, 0.0);
                assert_eq!(value.numbers().len(), expected.numbers().len(), "{path}");
                let pairs = value.numbers().iter().zip(expected.numbers());
                check_close(path, &pairs.map(|(a, b)| (*a, *b)).collect::<Vec<_>>());
            }
        }
    }
}

/// Agreement to 1e-14 of the largest.
fn check_close(path: &str, pairs: &[(f64, f64)]) {
    let scale = pairs
        .iter()
        .fold(0.0, |scale: f64, (_, b)| scale.max(b.abs()));
    for (value, expected) in pairs {
        let off = (value - expected).abs();
        assert!(
            off <= 1e-14 * scale,
            "{path}: {value} instead of {expected}"
        );
    }
}

#[test]
fn damped_oscillator() {
    Case {
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*x^2 - m*g*x",
        dissipation: "1/2*c*x'^2",
        initial: &[("x", ["x0", "v0"])],
        data: &[("m", "2"), ("k", "800"), ("c", "8"), ("g", "9.81"), ("x0", "0.15"), ("v0", "-0.3")],
        expected: &[
            ("mass", "m"),
            ("natural_angular_frequency", "sqrt(k/m)"),
            ("natural_frequency", "sqrt(k/m)/(2*pi)"),
            ("period", "2*pi*sqrt(m/k)"),
            ("decay_rate", "c/(2*m)"),
            ("damping_ratio", "c/(2*sqrt(k*m))"),
            ("critical_damping", "2*sqrt(k*m)"),
            ("damped_angular_frequency", "sqrt(k/m - (c/(2*m))^2)"),
            ("damped_period", "2*pi/sqrt(k/m - (c/(2*m))^2)"),
            ("logarithmic_decrement", "c/(2*m)*2*pi/sqrt(k/m - (c/(2*m))^2)"),
            ("quality_factor", "sqrt(k*m)/c"),
            ("resonance_angular_frequency", "sqrt(k/m - 2*(c/(2*m))^2)"),
            ("equilibrium", "m*g/k"),
            ("static_deflection.x", "m*g/k"),
            (
                "motion",
                "m*g/k + exp(-c/(2*m)*t)*((x0 - m*g/k)*cos(sqrt(k/m - (c/(2*m))^2)*t) + (v0 + c/(2*m)*(x0 - m*g/k))/sqrt(k/m - (c/(2*m))^2)*sin(sqrt(k/m - (c/(2*m))^2)*t))",
            ),
        ],
        ..PLAIN
    }
    .check();
}

#[test]
fn block_on_a_moving_base() {
    Case {
        coordinates: &["z"],
        kinematics: &[("u", "U*sin(Omega*t)"), ("x", "z + u")],
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*z^2",
        dissipation: "1/2*b*z'^2",
        data: &[("m", "3"), ("k", "120"), ("b", "4.5"), ("U", "0.02"), ("Omega", "5")],
        expected: &[
            ("complex_amplitude", "-i*m*U*Omega^2/(k - m*Omega^2 + i*b*Omega)"),
            (
                "steady_motion",
                "m*U*Omega^2/sqrt((k - m*Omega^2)^2 + (b*Omega)^2)*sin(Omega*t - atan2(b*Omega, k - m*Omega^2))",
            ),
        ],
        ..PLAIN
    }
    .check();
}

#[test]
fn pendulum_at_rest() {
    let case = Case {
        coordinates: &["theta°"],
        kinetic: "1/2*m*(l*theta')^2",
        potential: "-m*g*l*cos(theta)",
        initial: &[("theta", ["theta0", "0"])],
        data: &[
            ("m", "0.4"),
            ("l", "0.75"),
            ("g", "9.81"),
            ("theta0", "1.2"),
        ],
        expected: &[
            ("equilibria", "[0, pi]"),
            ("natural_angular_frequency", "sqrt(g/l)"),
            ("exact_period", "4*sqrt(l/g)*elliptic_k(sin(theta0/2)^2)"),
        ],
        ..PLAIN
    };
    case.check();
    assert!(case.is_stable());
}

#[test]
fn inverted_pendulum_between_springs() {
    let case = Case {
        coordinates: &["theta°"],
        kinetic: "1/2*m*l^2*theta'^2",
        potential: "k*a^2*sin(theta)^2 + m*g*l*cos(theta)",
        data: &[
            ("m", "1"),
            ("l", "0.5"),
            ("g", "9.81"),
            ("k", "100"),
            ("a", "0.2"),
        ],
        expected: &[(
            "equilibria",
            "[-acos(m*g*l/(2*k*a^2)), 0, acos(m*g*l/(2*k*a^2)), pi]",
        )],
        ..PLAIN
    };
    case.check();
    assert!(case.is_stable());
}

#[test]
fn two_blocks() {
    Case {
        coordinates: &["x1", "x2"],
        kinetic: "1/2*(4*m)*x1'^2 + 1/2*(2*m)*x2'^2",
        potential: "1/2*(2*k)*x1^2 + 1/2*k*(x2 - x1)^2",
        initial: &[("x1", ["0.1[m]", "0.3[m/s]"]), ("x2", ["0", "0.5[m/s]"])],
        data: &[("m", "1"), ("k", "16")],
        expected: &[
            ("M", "[[4*m, 0], [0, 2*m]]"),
            ("K", "[[3*k, -k], [-k, k]]"),
            ("natural_angular_frequencies", "[sqrt(k/(4*m)), sqrt(k/m)]"),
            (
                "mode_shapes",
                "[[1/sqrt(12*m), 2/sqrt(12*m)], [1/sqrt(6*m), -1/sqrt(6*m)]]",
            ),
            ("modal_masses", "[12*m, 6*m]"),
            ("multiplicities", "[1, 1]"),
            (
                "motion.x1",
                "0.1/3*cos(2*t) + 0.8/6*sin(2*t) + 0.2/3*cos(4*t) + 0.1/12*sin(4*t)",
            ),
            (
                "motion.x2",
                "2*(0.1/3*cos(2*t) + 0.8/6*sin(2*t)) - 0.2/3*cos(4*t) - 0.1/12*sin(4*t)",
            ),
            ("energy", "1/2*4*m*0.3^2 + 1/2*2*m*0.5^2 + 1/2*3*k*0.1^2"),
        ],
        ..PLAIN
    }
    .check();
}

#[test]
fn three_beads_on_a_ring() {
    Case {
        coordinates: &["x1", "x2", "x3"],
        kinetic: "1/2*m*(x1'^2 + x2'^2 + x3'^2)",
        potential: "1/2*k*((x2 - x1)^2 + (x3 - x2)^2 + (x1 - x3)^2)",
        initial: &[
            ("x1", ["0.02[m]", "0.1[m/s]"]),
            ("x2", ["0.02[m]", "0.1[m/s]"]),
            ("x3", ["0.02[m]", "0.1[m/s]"]),
        ],
        data: &[("m", "0.5"), ("k", "96")],
        expected: &[
            (
                "natural_angular_frequencies",
                "[0, sqrt(3*k/m), sqrt(3*k/m)]",
            ),
            ("multiplicities", "[1, 2, 2]"),
            ("motion.x2", "0.02 + 0.1*t"),
        ],
        ..PLAIN
    }
    .check();
}

#[test]
fn two_degrees_of_freedom_in_the_steady_state() {
    Case {
        coordinates: &["x1", "x2"],
        kinetic: "1/2*(2*m)*x1'^2 + 1/2*m*x2'^2",
        potential: "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 + 1/2*(2*k)*x2^2",
        forces: &[("x1", "f0*sin(Omega*t)")],
        data: &[("m", "1"), ("k", "4"), ("f0", "2"), ("Omega", "1")],
        expected: &[
            (
                "steady_motion.x1",
                "f0*(3*k - m*Omega^2)/((2*k - 2*m*Omega^2)*(3*k - m*Omega^2) - k^2)*sin(Omega*t)",
            ),
            (
                "steady_motion.x2",
                "f0*k/((2*k - 2*m*Omega^2)*(3*k - m*Omega^2) - k^2)*sin(Omega*t)",
            ),
            (
                "complex_amplitude.x2",
                "-i*f0*k/((2*k - 2*m*Omega^2)*(3*k - m*Omega^2) - k^2)",
            ),
        ],
        ..PLAIN
    }
    .check();
}

#[test]
fn dry_friction_with_a_tie() {
    // Released at 0.3 m, three times the half-width of the band of 0.1 m: it stops exactly on its edge.
    let case = Case {
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*x^2",
        friction: &[("x", "mu*m*g")],
        initial: &[("x", ["0.3[m]", "0"])],
        data: &[("m", "1"), ("k", "29.43"), ("mu", "0.3"), ("g", "9.81")],
        expected: &[
            ("half_cycles", "1"),
            ("rest_position", "-0.1"),
            ("stop_time", "pi*sqrt(m/k)"),
            ("path_length", "0.4"),
            ("dissipated_energy", "0.4*mu*m*g"),
            (
                "motion",
                "if t < pi*sqrt(m/k) then 0.1 + 0.2*cos(sqrt(k/m)*t) else -0.1",
            ),
        ],
        ..PLAIN
    };
    case.check();
}

#[test]
fn what_does_not_exist_says_why() {
    let case = Case {
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*x^2",
        data: &[("m", "1"), ("k", "4")],
        ..PLAIN
    };
    let numbers = case.numbers();
    let lack = |name: &str| {
        let quantity = numbers.model().quantity(&[Name::from(name)]).unwrap();
        numbers.value_of(quantity).unwrap_err()
    };
    assert_eq!(lack("quality_factor"), Unavailable::Undamped);
    assert_eq!(lack("complex_amplitude"), Unavailable::NoForce);
    assert_eq!(lack("half_cycles"), Unavailable::NoFriction);
    assert_eq!(lack("exact_period"), Unavailable::NotPendulum);
}

#[test]
fn damping_that_couples_the_modes() {
    let case = Case {
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m*x1'^2 + 1/2*m*x2'^2",
        potential: "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 - m*g*x2",
        dissipation: "1/2*c*x1'^2",
        forces: &[("x2", "F0*cos(Omega*t)")],
        initial: &[("x1", ["X0", "0"]), ("x2", ["0", "V0"])],
        data: &[
            ("m", "2"),
            ("k", "50"),
            ("c", "3"),
            ("g", "9.81"),
            ("F0", "4"),
            ("Omega", "3"),
            ("X0", "0.1"),
            ("V0", "-0.5"),
        ],
        expected: &[("equilibrium.x1", "m*g/k"), ("equilibrium.x2", "2*m*g/k")],
        ..PLAIN
    };
    case.check();
    let numbers = case.numbers();
    assert_eq!(
        numbers.value_of(Quantity::ModalDampingRatios),
        Err(Unavailable::CoupledDamping)
    );
    let [first, second] =
        [0, 1].map(|coordinate| numbers.motion_of(Quantity::Motion(coordinate)).unwrap());
    let at = |order, time| {
        let value = |motion: &vibank::mechanics::Motion| motion.at(order, time).unwrap();
        [value(&first), value(&second)]
    };
    let start = [at(0, 0.0), at(1, 0.0)].concat();
    for (value, expected) in start.iter().zip([0.1, 0.0, 0.0, -0.5]) {
        assert!((value - expected).abs() < 1e-14);
    }
    // Velocity and acceleration are the slopes of position and velocity.
    let step = 1e-4;
    for time in [0.3, 1.7, 12.0, 250.0] {
        for order in [0, 1] {
            let (before, after) = (at(order, time - step), at(order, time + step));
            let slope = at(order + 1, time);
            for coordinate in [0, 1] {
                let quotient = (after[coordinate] - before[coordinate]) / (2.0 * step);
                assert!(
                    (quotient - slope[coordinate]).abs() < 1e-6,
                    "{order} at {time}"
                );
            }
        }
    }
}

#[test]
fn general_solutions_have_two_constants_a_mode() {
    let one = Case {
        kinetic: "1/2*m*x'^2",
        potential: "1/2*k*x^2",
        dissipation: "1/2*c*x'^2",
        forces: &[("x", "F0*sin(Omega*t)")],
        data: &[
            ("m", "1"),
            ("k", "25"),
            ("c", "6"),
            ("F0", "8"),
            ("Omega", "5"),
        ],
        ..PLAIN
    };
    let written = |case: &Case| {
        let motion = case.numbers().general_motion().unwrap();
        motion.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(
        written(&one),
        ["exp(-(3*t))*(A*cos(4*t) + B*sin(4*t)) - 0.266667*cos(5*t)"]
    );
    let two = Case {
        coordinates: &["x1", "x2"],
        kinetic: "1/2*m*x1'^2 + 1/2*m*x2'^2",
        potential: "1/2*k*(x2 - x1)^2",
        data: &[("m", "1"), ("k", "8")],
        ..PLAIN
    };
    assert_eq!(
        written(&two),
        [
            "A1 + B1*t + (A2*cos(4*t) + B2*sin(4*t))",
            "A1 + B1*t - (A2*cos(4*t) + B2*sin(4*t))"
        ]
    );
}
