//! M and K of a double pendulum from its energies, about the equilibrium.

use std::sync::Arc;

use vibank::expr::{Expr, Precise};
use vibank::mechanics::{Coordinate, Definition, Model, Numbers};
use vibank::numerics::{cos, powi};

use crate::record::Record;
use crate::reference::Case;

fn read(formula: &str) -> Expr {
    Expr::read(formula).expect("the formula can be read")
}

/// Two pendulums on a cart that a spring and a damper hold: three coordinates, as many as any system of the bank has.
pub(crate) fn cart() -> Definition {
    Definition {
        coordinates: vec![
            Coordinate::length("x"),
            Coordinate::angle("p"),
            Coordinate::angle("q"),
        ],
        kinetic: read(
            "1/2*M*x'^2 + 1/2*m*(x'^2 + 2*l*x'*p'*cos(p) + l^2*p'^2) + 1/2*m*(x'^2 + 2*l*x'*q'*cos(q) + l^2*q'^2)",
        ),
        potential: read("1/2*k*x^2 - m*g*l*cos(p) - m*g*l*cos(q) + 1/2*kc*l^2*(sin(q) - sin(p))^2"),
        dissipation: read("1/2*c*x'^2"),
        ..Definition::default()
    }
}

/// The double pendulum with numbers in it.
pub(crate) fn numbers(model: &Arc<Model>, prestretch: f64) -> Numbers {
    Numbers::of(Arc::clone(model), |name| {
        let is_prestretch = name.as_str() == "s";
        Ok(Precise::exact(if is_prestretch { prestretch } else { 1.0 }))
    })
}

pub(crate) fn model() -> Arc<Model> {
    let definition = Definition {
        coordinates: vec![Coordinate::angle("p"), Coordinate::angle("q")],
        kinetic: read("J*(p'^2 + 1/2*q'^2 + p'*q'*cos(p - q))"),
        potential: read("-2*G*cos(p) - G*cos(q) + H*(q - p - s)^2"),
        ..Definition::default()
    };
    Arc::new(Model::derive(definition).expect("the model is sound"))
}

/// Second differences of the potential energy with a step, about an angle pair.
fn by_differences([p, q]: [f64; 2], prestretch: f64, step: f64) -> [f64; 6] {
    let potential = |p: f64, q: f64| {
        let stretch = q - p - prestretch;
        -2.0 * cos(p) - cos(q) + stretch * stretch
    };
    let second = |a: f64, b: f64| {
        (potential(p + a, q + b) - 2.0 * potential(p, q) + potential(p - a, q - b)) / (step * step)
    };
    let (first, last) = (second(step, 0.0), second(0.0, step));
    let mixed = (second(step, step) - first - last) / 2.0;
    [first, mixed, last, 2.0, cos(p - q), 1.0]
}

/// M and K about the equilibrium, for prepared energies.
pub(crate) fn of_a_double_pendulum(records: &mut Vec<Record>) {
    let model = model();
    for case in Case::of("linearisation") {
        let prestretch = case.number("s");
        let numbers = || numbers(&model, prestretch);
        let rest = numbers();
        let place = match rest.equilibrium() {
            Ok([p, q]) => [*p, *q],
            _ => [f64::NAN; 2],
        };
        let entries = |matrix: &[f64]| [matrix[0], matrix[1], matrix[3]];
        let linearized = |numbers: &Numbers| {
            let Ok(linearization) = numbers.linearization() else {
                return [f64::NAN; 6];
            };
            let ([a, b, c], [d, e, f]) = (
                entries(&linearization.stiffness),
                entries(&linearization.mass),
            );
            [a, b, c, d, e, f]
        };
        records.push(case.solution("vibank", || linearized(&rest)));
        records.push(case.solution("vibank (with the equilibrium)", || linearized(&numbers())));
        for power in 2..9 {
            let step = powi(10.0, -power);
            let mut record = case.solution("second differences", || {
                by_differences(place, prestretch, step)
            });
            record.tolerance = Some(step);
            records.push(record);
        }
    }
}
