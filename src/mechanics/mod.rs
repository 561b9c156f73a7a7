//! Mechanics from energies: the physics written once.
//!
//! A [`Definition`] holds the kinetic and potential energy, the dissipation function and the generalized
//! forces of a system as formulas; [`Model::derive`] makes of them, symbolically, Lagrange's equations,
//! the equilibrium and the equations linearized about it. Electrical circuits are the same with a
//! charge as coordinate, `L` for the mass, `R` for the damping and `1/C` for the stiffness.

mod characteristic;
mod definition;
mod dimensions;
mod energy;
mod equilibrium;
mod error;
mod evaluation;
mod excitation;
mod formulas;
mod kinematics;
mod lagrange;
mod linear;
mod model;
mod numbers;
mod order;
mod programs;
mod quantity;
mod quantity_type;
mod relation;
mod squares;
mod steps;
mod unavailable;

pub use definition::{Body, Coordinate, Definition, Friction, Initial};
pub use error::{DefinitionKey, ModelError};
pub use model::Model;
pub use numbers::{Frictional, Linearization, Motion, Numbers, Sdof, TurningPoints};
pub use quantity::{Quantity, QuantityError};
pub use quantity_type::QuantityType;
pub use steps::{LawTerm, Letters, Line, LineSide, NewtonError, Reason, Step, Way};
pub use unavailable::Unavailable;
