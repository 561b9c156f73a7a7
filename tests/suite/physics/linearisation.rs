//! Linearisation against `tests/references/linearisation.py`.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Deserialize;
use serde_json::Value;
use vibank::expr::{Expr, Precise};
use vibank::mechanics::{Coordinate, Definition, Model, Numbers};

use super::reference::{Accuracy, read};

const REFERENCES: &str = include_str!("../../fixtures/references/linearisation.jsonl");

#[derive(Deserialize)]
struct Case {
    data: BTreeMap<String, f64>,
    entries: [Value; 6],
    scales: [Value; 6],
}

/// Two pendulums in a row with a spring between the rods, in absolute angles.
fn model() -> Arc<Model> {
    let read = |formula| Expr::read(formula).unwrap();
    let definition = Definition {
        coordinates: vec![Coordinate::angle("p"), Coordinate::angle("q")],
        kinetic: read("1/2*(m1 + m2)*a^2*p'^2 + 1/2*m2*b^2*q'^2 + m2*a*b*p'*q'*cos(p - q)"),
        potential: read("-(m1 + m2)*g*a*cos(p) - m2*g*b*cos(q) + 1/2*k*(q - p - s)^2"),
        ..Definition::default()
    };
    Arc::new(Model::derive(definition).unwrap())
}

/// Entries of M and K about the equilibrium, by hyper-dual numbers and by symbolic derivatives.
pub(super) fn entries(table: &mut Accuracy) {
    const TARGET: f64 = 4.0 * f64::EPSILON / 2.0;
    let model = model();
    for line in REFERENCES.lines() {
        let case: Case = serde_json::from_str(line).unwrap();
        let numbers = Numbers::of(Arc::clone(&model), |name| {
            Ok(Precise::exact(case.data[name.as_str()]))
        });
        let by_duals = numbers.linearization().unwrap();
        let stiffness = numbers.stiffness_matrix().unwrap().numbers().to_vec();
        let mass = numbers.mass_matrix().unwrap().numbers().to_vec();
        for (name, stiffness, mass) in [
            (
                "M and K by hyper-duals / terms",
                &by_duals.stiffness,
                &by_duals.mass,
            ),
            ("M and K by formulas / terms", &stiffness, &mass),
        ] {
            let found = [0, 1, 3]
                .map(|i| stiffness[i])
                .into_iter()
                .chain([0, 1, 3].map(|i| mass[i]));
            for (index, value) in found.enumerate() {
                let error = (read(&case.entries[index]) - value).hi().abs();
                // A spring that is absent has no terms.
                let error = error / read(&case.scales[index]).hi().max(f64::MIN_POSITIVE);
                table.record(name, error, TARGET, || {
                    format!("entry {index} of {:?}", case.data)
                });
            }
        }
    }
}
