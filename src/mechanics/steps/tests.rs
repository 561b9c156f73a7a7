use super::*;
use crate::mechanics::{Body, Coordinate, Definition, Friction};
use crate::source::Span;

fn read(formula: &str) -> Expr {
    Expr::read(formula).unwrap()
}

fn named(pairs: &[(&str, &str)]) -> Vec<(Name, Expr)> {
    let pairs = pairs.iter();
    pairs
        .map(|(name, formula)| (Name::from(*name), read(formula)))
        .collect()
}

/// A stepped disk between a hanging block on a spring and a block on a table.
fn stepped_disk() -> Definition {
    Definition {
        coordinates: vec![Coordinate::length("x1"), Coordinate::angle("theta")],
        kinematics: named(&[("x2", "-r2*theta"), ("x3", "-r1*theta"), ("z", "x3 - x1")]),
        kinetic: read("1/2*m1*x1'^2 + 1/2*m2*x2'^2 + 1/2*J*theta'^2"),
        potential: read("1/2*k1*z^2 + 1/2*k2*x2^2"),
        dissipation: read("1/2*b1*x1'^2 + 1/2*b2*x2'^2"),
        ..Definition::default()
    }
}

fn body(name: &str, moves: &[(&str, &str)], forces: &[(&str, &[&str])], unknowns: &[&str]) -> Body {
    Body {
        name: Name::from(name),
        moves: named(moves),
        forces: forces
            .iter()
            .map(|(name, all)| (Name::from(*name), all.iter().map(|one| read(one)).collect()))
            .collect(),
        unknowns: unknowns.iter().map(|name| Name::from(*name)).collect(),
        span: Span::NONE,
    }
}

fn with_bodies(definition: Definition, bodies: Vec<Body>) -> Definition {
    Definition {
        bodies,
        ..definition
    }
}

fn disk_bodies() -> Vec<Body> {
    vec![
        body(
            "hanging",
            &[("x1", "m1")],
            &[("spring", &["k1*z"]), ("damper", &["-b1*x1'"])],
            &[],
        ),
        body(
            "sliding",
            &[("x2", "m2")],
            &[
                ("spring", &["-k2*x2"]),
                ("damper", &["-b2*x2'"]),
                ("cord", &["S2"]),
            ],
            &["S2"],
        ),
        body(
            "disk",
            &[("theta", "J")],
            &[("spring", &["k1*z*r1"]), ("cord", &["S2*r2"])],
            &["S2"],
        ),
    ]
}

/// The lines as text.
fn lines(definition: Definition, way: Way) -> Vec<String> {
    let model = Model::derive(definition).unwrap();
    let steps = model.derivation(way).unwrap();
    let lines = steps.iter().flat_map(|step| &step.lines);
    lines.map(text).collect()
}

fn text(line: &Line) -> String {
    let side = |side: &LineSide| match side {
        LineSide::Formula(formula) => formula.to_string(),
        LineSide::Determinant(rows) => format!("det{}", rows.len()),
        LineSide::Terms(terms) if terms.is_empty() => "0".to_owned(),
        LineSide::Terms(terms) => terms
            .iter()
            .map(|(is_subtracted, term)| {
                format!("{}{term:?}", if *is_subtracted { "-" } else { "+" })
            })
            .collect(),
    };
    let sides: Vec<String> = line.sides.iter().map(side).collect();
    sides.join(if line.is_approximate { " ~ " } else { " = " })
}

#[test]
fn terms_go_through_the_kinematic_names() {
    assert_eq!(
        lines(stepped_disk(), Way::Lagrange(1)),
        [
            "x2 = -(r2*theta)",
            "z = -(x1 + r1*theta)",
            "+Momentum(theta) = m2*x2'*-r2 + J*theta' = (m2*r2^2 + J)*theta'",
            "+MomentumRate(theta) = (m2*r2^2 + J)*theta''",
            "+Potential(theta) = k1*z*-r1 + k2*x2*-r2 = k1*r1*(x1 + r1*theta) + k2*r2^2*theta",
            "+Dissipation(theta) = b2*x2'*-r2 = b2*r2^2*theta'",
            "+MomentumRate(theta)+Potential(theta)+Dissipation(theta) = 0",
            "(m2*r2^2 + J)*theta'' + k1*r1*(x1 + r1*theta) + k2*r2^2*theta + b2*r2^2*theta' = 0",
            "(m2*r2^2 + J)*theta'' + b2*r2^2*theta' + k1*r1*x1 + (k1*r1^2 + k2*r2^2)*theta = 0",
        ]
    );
}

#[test]
fn the_energy_of_several_coordinates_is_a_balance() {
    let lines = lines(stepped_disk(), Way::Energy);
    assert_eq!(
        lines[1..],
        [
            "+Power = -b1*x1'^2 - b2*r2^2*theta'^2",
            "+EnergyRate = +Power",
            "(m1*x1'' + k1*x1 + k1*r1*theta)*x1' + ((m2*r2^2 + J)*theta'' + k1*r1*x1 \
             + (k1*r1^2 + k2*r2^2)*theta)*theta' = -b1*x1'^2 - b2*r2^2*theta'^2",
        ]
    );
}

#[test]
fn the_energy_of_one_coordinate_gives_its_equation() {
    let block = Definition {
        coordinates: vec![Coordinate::length("x")],
        kinetic: read("1/2*m*x'^2"),
        potential: read("1/2*k*x^2"),
        dissipation: read("1/2*c*x'^2"),
        friction: vec![(
            Name::from("x"),
            Friction {
                kinetic: read("mu*m*g"),
                holding: None,
            },
        )],
        ..Definition::default()
    };
    assert_eq!(
        lines(block, Way::Energy),
        [
            "+Energy = 1/2*m*x'^2 + 1/2*k*x^2",
            "+Power = (-c*x' - mu*m*g*sign(x'))*x'",
            "+EnergyRate = +Power",
            "(m*x'' + k*x)*x' = (-c*x' - mu*m*g*sign(x'))*x'",
            "m*x'' + k*x = -c*x' - mu*m*g*sign(x')",
            "m*x'' + c*x' + k*x = -(mu*m*g*sign(x'))",
        ]
    );
}

#[test]
fn a_driven_support_does_work_that_is_in_no_balance() {
    let driven = Definition {
        coordinates: vec![Coordinate::length("x")],
        kinematics: named(&[("y", "Y*cos(Omega*t)")]),
        kinetic: read("1/2*m*x'^2"),
        potential: read("1/2*k*(x - y)^2"),
        ..Definition::default()
    };
    let model = Model::derive(driven).unwrap();
    assert_eq!(model.derivation(Way::Energy), Err(Unavailable::TimeVarying));
    assert!(model.derivation(Way::Lagrange(0)).is_ok());
}

#[test]
fn what_is_not_linear_is_linearized_term_by_term() {
    let pendulums = Definition {
        coordinates: vec![Coordinate::angle("a"), Coordinate::angle("b")],
        kinetic: read("1/2*m*(l*a')^2 + 1/2*m*(l*b')^2"),
        potential: read("-m*g*l*cos(a) - m*g*l*cos(b) + 1/2*K*(s*(sin(a) - sin(b)))^2"),
        ..Definition::default()
    };
    assert_eq!(
        lines(pendulums, Way::Lagrange(0)),
        [
            "+Momentum(a) = m*l^2*a'",
            "+MomentumRate(a) = m*l^2*a''",
            "+Potential(a) = m*l*g*sin(a) + K*s^2*(sin(a) - sin(b))*cos(a)",
            "+MomentumRate(a)+Potential(a) = 0",
            "m*l^2*a'' + m*l*g*sin(a) + K*s^2*(sin(a) - sin(b))*cos(a) = 0",
            "+Potential(a) ~ (m*l*g + K*s^2)*a - K*s^2*b",
            "m*l^2*a'' + (m*l*g + K*s^2)*a - K*s^2*b = 0",
        ]
    );
}

#[test]
fn newtons_laws_lose_the_forces_of_constraint() {
    let definition = with_bodies(stepped_disk(), disk_bodies());
    assert_eq!(
        Model::derive(definition.clone()).unwrap().prove_newton(),
        Ok(())
    );
    assert_eq!(
        lines(definition, Way::Newton),
        [
            "x2 = -(r2*theta)",
            "z = -(x1 + r1*theta)",
            "m1*x1'' = k1*z - b1*x1'",
            "m2*x2'' = -k2*x2 - b2*x2' + S2",
            "J*theta'' = k1*z*r1 + S2*r2",
            "m1*x1'' + b1*x1' + k1*x1 + k1*r1*theta = 0",
            "-m2*r2*x2'' + J*theta'' = k2*r2*x2 + b2*r2*x2' + k1*z*r1",
            "(m2*r2^2 + J)*theta'' + b2*r2^2*theta' + k1*r1*x1 + (k1*r1^2 + k2*r2^2)*theta = 0",
        ]
    );
}

#[test]
fn bodies_that_are_not_the_model_are_refused() {
    let refused = |change: &dyn Fn(&mut Vec<Body>)| {
        let mut bodies = disk_bodies();
        change(&mut bodies);
        let model = Model::derive(with_bodies(stepped_disk(), bodies)).unwrap();
        model.prove_newton().unwrap_err().to_string()
    };
    // The cord pulls the disk the other way: its tension does not cancel.
    let slipped = refused(&|bodies| bodies[2].forces[1].1[0] = read("-S2*r2"));
    assert_eq!(
        slipped,
        "`S2` does not cancel from the laws of the bodies along `theta`"
    );
    // A damper is forgotten.
    let forgotten = refused(&|bodies| {
        bodies[0].forces.pop();
    });
    assert_eq!(
        forgotten,
        "along `x1` the laws of the bodies differ from the equation of the energies: `-b1*x1'` is left"
    );
    let unknown = refused(&|bodies| bodies[0].moves[0].0 = Name::from("x4"));
    assert_eq!(unknown, "`x4` is neither a coordinate nor a kinematic name");
}
