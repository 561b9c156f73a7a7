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

impl Model {
    /// What a quantity of this model is: its type, and whether it is a function of time.
    pub fn quantity_type(&self, quantity: Quantity) -> QuantityType {
        let size = self.degrees_of_freedom();
        let along = |at: usize| self.definition.coordinates[at].dimension;
        let number = |dimension| QuantityType::Number(Type::real(dimension));
        let vector = |dimension: Dimension| {
            let form = Form::real(Shape::Vector(size));
            QuantityType::Number(Type::uniform(form, dimension))
        };
        match quantity {
            Quantity::Kinetic | Quantity::Potential => {
                QuantityType::Formula(Type::real(Dimension::ENERGY))
            }
            Quantity::Dissipation => QuantityType::Formula(Type::real(Dimension::POWER)),
            Quantity::Equation(_)
            | Quantity::FullEquation(_)
            | Quantity::CharacteristicEquation => QuantityType::Equation,
            Quantity::Equations => QuantityType::Equations,
            Quantity::MassMatrix => self.square(2),
            Quantity::DampingMatrix => self.square(1),
            Quantity::StiffnessMatrix => self.square(0),
            Quantity::Equilibrium(at) | Quantity::StaticDeflection(at) => number(along(at)),
            Quantity::Equilibria => QuantityType::List(along(0)),
            Quantity::Stable | Quantity::Frictional(Frictional::Slides) => {
                QuantityType::Number(Type::boolean())
            }
            Quantity::Sdof(single) => number(self.dimension_of_single(single)),
            Quantity::NaturalAngularFrequencies => vector(Dimension::FREQUENCY),
            Quantity::Multiplicities | Quantity::ModalDampingRatios => vector(Dimension::PURE),
            Quantity::ModeShapes => self.rows_of_coordinates(),
            Quantity::ModalMasses => vector(self.coefficient(0, 0, 2)),
            Quantity::ModalAmplitudes => self.amplitudes(),
            Quantity::Motion(at) | Quantity::SteadyMotion(at) => QuantityType::Motion(along(at)),
            Quantity::ExactMotion => QuantityType::Motion(along(0)),
            Quantity::Energy => QuantityType::Motion(Dimension::ENERGY),
            Quantity::GeneralMotion => QuantityType::GeneralMotion,
            Quantity::ComplexAmplitude(at) => QuantityType::Number(Type::complex(along(at))),
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

    /// The dimension of an entry of M (order 2), C (1) or K (0): energy over two displacements, velocities
    /// or accelerations with a displacement.
    fn coefficient(&self, row: usize, column: usize, order: usize) -> Dimension {
        let along = |at: usize| self.definition.coordinates[at].dimension;
        let stiffness = Dimension::ENERGY / along(row) / along(column);
        (0..order).fold(stiffness, |dimension, _| dimension * Dimension::TIME)
    }

    fn square(&self, order: usize) -> QuantityType {
        let size = self.degrees_of_freedom();
        let entries =
            (0..size * size).map(|at| Some(self.coefficient(at / size, at % size, order)));
        typed(Shape::Matrix(size, size), entries.collect())
    }

    /// Mass-normalized shapes: each component times the root of its mass is pure.
    fn rows_of_coordinates(&self) -> QuantityType {
        let size = self.degrees_of_freedom();
        let component = |at: usize| self.coefficient(at, at, 2).sqrt().map(Dimension::inverse);
        let entries = (0..size * size).map(|at| component(at % size));
        typed(Shape::Matrix(size, size), entries.collect())
    }

    fn amplitudes(&self) -> QuantityType {
        let size = self.degrees_of_freedom();
        let modal = Dimension::ENERGY.sqrt().map(|root| root * Dimension::TIME);
        typed(Shape::Matrix(size, 2), vec![modal; 2 * size])
    }

    fn dimension_of_single(&self, single: Sdof) -> Dimension {
        match single {
            Sdof::Mass => self.coefficient(0, 0, 2),
            Sdof::Damping | Sdof::CriticalDamping => self.coefficient(0, 0, 1),
            Sdof::Stiffness => self.coefficient(0, 0, 0),
            Sdof::NaturalAngularFrequency
            | Sdof::NaturalFrequency
            | Sdof::DecayRate
            | Sdof::DampedAngularFrequency
            | Sdof::ResonanceAngularFrequency => Dimension::FREQUENCY,
            Sdof::Period | Sdof::DampedPeriod => Dimension::TIME,
            Sdof::DampingRatio | Sdof::LogarithmicDecrement | Sdof::QualityFactor => {
                Dimension::PURE
            }
        }
    }
}

fn typed(shape: Shape, dimensions: Vec<Option<Dimension>>) -> QuantityType {
    let form = Form {
        field: Field::Real,
        shape,
    };
    let pure = || Type::uniform(form, Dimension::PURE);
    QuantityType::Number(Type::each(form, dimensions).unwrap_or_else(pure))
}
