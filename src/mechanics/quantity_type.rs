//! What the quantities of a model are: types and dimensions.

use super::Model;
use super::numbers::{Frictional, Sdof};
use super::quantity::Quantity;
use crate::expr::{Field, Form, Shape, Type};
use crate::unit::Dimension;

/// Kind, shape and dimension of what a model offers under a name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum QuantityType {
    /// A formula in coordinates and velocities, of this type.
    Formula(Type),
    /// An equation of motion, or that of the natural frequencies.
    Equation,
    /// One equation per coordinate.
    Equations,
    /// A value of this type.
    Number(Type),
    /// A list of numbers of this dimension; how many there are depends on the data.
    List(Dimension),
    /// A real function of time of this dimension.
    Motion(Dimension),
    /// The general solution of the equations.
    GeneralMotion,
}

impl QuantityType {
    /// What a quantity of this model is: its type, and whether it is a function of time.
    pub fn of(model: &Model, quantity: Quantity) -> Self {
        let size = model.degrees_of_freedom();
        let along = |at: usize| model.definition.coordinates[at].dimension;
        let number = |dimension| Self::Number(Type::real(dimension));
        let vector = |dimension: Dimension| {
            let form = Form::real(Shape::Vector(size));
            Self::Number(Type::uniform(form, dimension))
        };
        match quantity {
            Quantity::Kinetic | Quantity::Potential => Self::Formula(Type::real(Dimension::ENERGY)),
            Quantity::Dissipation => Self::Formula(Type::real(Dimension::POWER)),
            Quantity::Equation(_)
            | Quantity::FullEquation(_)
            | Quantity::CharacteristicEquation => Self::Equation,
            Quantity::Equations => Self::Equations,
            Quantity::MassMatrix => square(model, 2),
            Quantity::DampingMatrix => square(model, 1),
            Quantity::StiffnessMatrix => square(model, 0),
            Quantity::Equilibrium(at) | Quantity::StaticDeflection(at) => number(along(at)),
            Quantity::Equilibria => Self::List(along(0)),
            Quantity::Stable | Quantity::Frictional(Frictional::Slides) => {
                Self::Number(Type::boolean())
            }
            Quantity::Sdof(single) => number(dimension_of_single(model, single)),
            Quantity::NaturalAngularFrequencies => vector(Dimension::FREQUENCY),
            Quantity::Multiplicities | Quantity::ModalDampingRatios => vector(Dimension::PURE),
            Quantity::ModeShapes => rows_of_coordinates(model),
            Quantity::ModalMasses => vector(coefficient(model, 0, 0, 2)),
            Quantity::ModalAmplitudes => amplitudes(model),
            Quantity::Motion(at) | Quantity::SteadyMotion(at) => Self::Motion(along(at)),
            Quantity::ExactMotion => Self::Motion(along(0)),
            Quantity::Energy => Self::Motion(Dimension::ENERGY),
            Quantity::GeneralMotion => Self::GeneralMotion,
            Quantity::ComplexAmplitude(at) => Self::Number(Type::complex(along(at))),
            Quantity::ExactPeriod | Quantity::Frictional(Frictional::StopTime) => {
                number(Dimension::TIME)
            }
            Quantity::Frictional(Frictional::HalfCycles) => number(Dimension::PURE),
            Quantity::Frictional(Frictional::RestPosition | Frictional::PathLength) => {
                number(along(0))
            }
            Quantity::Frictional(Frictional::DissipatedEnergy) => number(Dimension::ENERGY),
        }
    }
}

/// The dimension of an entry of M (order 2), C (1) or K (0): energy over two displacements, velocities
/// or accelerations with a displacement.
fn coefficient(model: &Model, row: usize, column: usize, order: usize) -> Dimension {
    let along = |at: usize| model.definition.coordinates[at].dimension;
    let stiffness = Dimension::ENERGY / along(row) / along(column);
    (0..order).fold(stiffness, |dimension, _| dimension * Dimension::TIME)
}

fn square(model: &Model, order: usize) -> QuantityType {
    let size = model.degrees_of_freedom();
    let entries = (0..size * size).map(|at| Some(coefficient(model, at / size, at % size, order)));
    typed(Shape::Matrix(size, size), entries.collect())
}

/// Mass-normalized shapes: each component times the root of its mass is pure.
fn rows_of_coordinates(model: &Model) -> QuantityType {
    let size = model.degrees_of_freedom();
    let component = |at: usize| coefficient(model, at, at, 2).sqrt().map(Dimension::inverse);
    let entries = (0..size * size).map(|at| component(at % size));
    typed(Shape::Matrix(size, size), entries.collect())
}

fn amplitudes(model: &Model) -> QuantityType {
    let size = model.degrees_of_freedom();
    let modal = Dimension::ENERGY.sqrt().map(|root| root * Dimension::TIME);
    typed(Shape::Matrix(size, 2), vec![modal; 2 * size])
}

fn dimension_of_single(model: &Model, single: Sdof) -> Dimension {
    match single {
        Sdof::Mass => coefficient(model, 0, 0, 2),
        Sdof::Damping | Sdof::CriticalDamping => coefficient(model, 0, 0, 1),
        Sdof::Stiffness => coefficient(model, 0, 0, 0),
        Sdof::NaturalAngularFrequency
        | Sdof::NaturalFrequency
        | Sdof::DecayRate
        | Sdof::DampedAngularFrequency
        | Sdof::ResonanceAngularFrequency => Dimension::FREQUENCY,
        Sdof::Period | Sdof::DampedPeriod => Dimension::TIME,
        Sdof::DampingRatio | Sdof::LogarithmicDecrement | Sdof::QualityFactor => Dimension::PURE,
    }
}

fn typed(shape: Shape, dimensions: Vec<Option<Dimension>>) -> QuantityType {
    let form = Form {
        field: Field::Real,
        shape,
    };
    QuantityType::Number(
        Type::each(form, dimensions).unwrap_or_else(|| Type::uniform(form, Dimension::PURE)),
    )
}
