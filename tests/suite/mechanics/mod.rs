//! Mechanics from energies: what follows from what authors write.

mod chains;
mod derivatives;
mod mistakes;
mod systems;
mod values;

use systems::{SYSTEMS, System};
use vibank::expr::{Equation, Expr, Name, Normal};
use vibank::mechanics::{Coordinate, Definition, Model};

fn read(formula: &str) -> Expr {
    Expr::read(formula).unwrap_or_else(|error| panic!("{formula}: {error}"))
}

fn named(formulas: &[(&str, &str)]) -> Vec<(Name, Expr)> {
    let formulas = formulas.iter();
    formulas
        .map(|(name, formula)| (Name::from(*name), read(formula)))
        .collect()
}

impl System {
    fn definition(&self) -> Definition {
        let coordinate = |text: &&str| match text.strip_suffix('°') {
            Some(name) => Coordinate::angle(name),
            None => Coordinate::length(*text),
        };
        Definition {
            coordinates: self.coordinates.iter().map(coordinate).collect(),
            kinematics: named(self.kinematics),
            kinetic: read(self.kinetic),
            potential: read(self.potential),
            dissipation: read(self.dissipation),
            forces: named(self.forces),
            ..Definition::default()
        }
    }

    fn model(&self) -> Model {
        Model::derive(self.definition())
            .unwrap_or_else(|errors| panic!("{}: {errors:?}", self.name))
    }
}

fn difference(equation: &Equation) -> Normal {
    Normal::of(&equation.difference()).unwrap()
}

#[test]
fn equations_of_motion_follow_from_energies() {
    for system in SYSTEMS {
        let model = system.model();
        for (index, expected) in system.equations.iter().enumerate() {
            let derived = model.equation(index).unwrap();
            let stated = Equation::read(expected).unwrap();
            assert!(
                difference(&derived).is_equal(&difference(&stated)).unwrap(),
                "{}: {} = {} is not {expected}",
                system.name,
                derived.left,
                derived.right
            );
        }
    }
}

#[test]
fn written_formulas_read_back_to_the_same_tree() {
    for system in SYSTEMS {
        let energies = [system.kinetic, system.potential, system.dissipation];
        for text in energies {
            let formula = read(text);
            assert_eq!(read(&formula.to_string()), formula, "{text}");
        }
        for index in 0..system.equations.len() {
            let equation = system.model().equation(index).unwrap();
            assert_eq!(read(&equation.left.to_string()), equation.left);
        }
    }
}
