//! The quantities that a model offers to an item, by name.

use thiserror::Error;

use super::Model;
use super::numbers::{Frictional, Sdof};
use crate::expr::Name;
use crate::source::nearest;

/// A quantity of a model; coordinates are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// T in coordinates and velocities.
    Kinetic,
    /// V in the coordinates.
    Potential,
    /// D in the velocities.
    Dissipation,
    /// The linearized equation of motion along a coordinate.
    Equation(usize),
    /// Lagrange's equation along a coordinate.
    FullEquation(usize),
    /// All linearized equations.
    Equations,
    /// The equation of the natural frequencies.
    CharacteristicEquation,
    /// M.
    MassMatrix,
    /// C.
    DampingMatrix,
    /// K.
    StiffnessMatrix,
    /// The equilibrium of a coordinate.
    Equilibrium(usize),
    /// All equilibria.
    Equilibria,
    /// Whether the equilibrium is stable.
    Stable,
    /// The displacement of a coordinate from its origin to the equilibrium.
    StaticDeflection(usize),
    /// A number of one degree of freedom.
    Sdof(Sdof),
    /// ω₁ ≤ ω₂ ≤ ….
    NaturalAngularFrequencies,
    /// How often each of them occurs.
    Multiplicities,
    /// The mass-normalized shapes, by rows.
    ModeShapes,
    /// The masses of the shapes with their first nonzero component 1.
    ModalMasses,
    /// The damping ratios of the modes.
    ModalDampingRatios,
    /// The factors of cosine and sine of the modal coordinates.
    ModalAmplitudes,
    /// The motion of a coordinate from the initial state.
    Motion(usize),
    /// What is left of it when all that decays has decayed.
    SteadyMotion(usize),
    /// The mechanical energy along the motion.
    Energy,
    /// The motion with free constants.
    GeneralMotion,
    /// X with x = Re(X e^(iΩt)).
    ComplexAmplitude(usize),
    /// The period of a pendulum at any amplitude.
    ExactPeriod,
    /// The motion of a pendulum at any amplitude.
    ExactMotion,
    /// A number about a motion with dry friction.
    Frictional(Frictional),
}

/// Why a path leads to no quantity.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// There is no such quantity.
    #[error("a model has no quantity `{name}`")]
    Unknown {
        /// As written.
        name: Name,
        /// The name of a model quantity that is spelled nearly so.
        nearest: Option<&'static str>,
    },
    /// A quantity of a coordinate without the coordinate.
    #[error("`{name}` needs a coordinate: `{name}.{first}`")]
    NoCoordinate {
        /// The quantity.
        name: Name,
        /// The first coordinate of the model.
        first: Name,
    },
    /// A name that is not a coordinate, or one that is not needed.
    #[error("`{name}` is not a coordinate here")]
    NotACoordinate {
        /// As written.
        name: Name,
    },
    /// A quantity of one degree of freedom of a model that has several.
    #[error("`{name}` belongs to a model of one coordinate")]
    SeveralCoordinates {
        /// The quantity.
        name: Name,
    },
}

/// How a name becomes a quantity.
#[derive(Clone, Copy)]
enum QuantityRow {
    /// Of the model as a whole.
    Whole(Quantity),
    /// Of a model of one coordinate.
    Alone(Quantity),
    /// Of a coordinate, which may be left out if there is one alone.
    Each(fn(usize) -> Quantity),
    /// Of the only coordinate, which may be named.
    Only(Quantity),
}

use QuantityRow::{Alone, Each, Only, Whole};

const TABLE: &[(&str, QuantityRow)] = &[
    ("kinetic", Whole(Quantity::Kinetic)),
    ("potential", Whole(Quantity::Potential)),
    ("dissipation", Whole(Quantity::Dissipation)),
    ("equation", Each(Quantity::Equation)),
    ("full_equation", Each(Quantity::FullEquation)),
    ("equations", Whole(Quantity::Equations)),
    (
        "characteristic_equation",
        Whole(Quantity::CharacteristicEquation),
    ),
    ("M", Whole(Quantity::MassMatrix)),
    ("C", Whole(Quantity::DampingMatrix)),
    ("K", Whole(Quantity::StiffnessMatrix)),
    ("equilibrium", Each(Quantity::Equilibrium)),
    ("equilibria", Alone(Quantity::Equilibria)),
    ("stable", Whole(Quantity::Stable)),
    ("static_deflection", Each(Quantity::StaticDeflection)),
    ("mass", Alone(Quantity::Sdof(Sdof::Mass))),
    ("damping", Alone(Quantity::Sdof(Sdof::Damping))),
    ("stiffness", Alone(Quantity::Sdof(Sdof::Stiffness))),
    (
        "natural_angular_frequency",
        Alone(Quantity::Sdof(Sdof::NaturalAngularFrequency)),
    ),
    (
        "natural_frequency",
        Alone(Quantity::Sdof(Sdof::NaturalFrequency)),
    ),
    ("period", Alone(Quantity::Sdof(Sdof::Period))),
    ("decay_rate", Alone(Quantity::Sdof(Sdof::DecayRate))),
    ("damping_ratio", Alone(Quantity::Sdof(Sdof::DampingRatio))),
    (
        "critical_damping",
        Alone(Quantity::Sdof(Sdof::CriticalDamping)),
    ),
    (
        "damped_angular_frequency",
        Alone(Quantity::Sdof(Sdof::DampedAngularFrequency)),
    ),
    ("damped_period", Alone(Quantity::Sdof(Sdof::DampedPeriod))),
    (
        "logarithmic_decrement",
        Alone(Quantity::Sdof(Sdof::LogarithmicDecrement)),
    ),
    ("quality_factor", Alone(Quantity::Sdof(Sdof::QualityFactor))),
    (
        "resonance_angular_frequency",
        Alone(Quantity::Sdof(Sdof::ResonanceAngularFrequency)),
    ),
    (
        "natural_angular_frequencies",
        Whole(Quantity::NaturalAngularFrequencies),
    ),
    ("multiplicities", Whole(Quantity::Multiplicities)),
    ("mode_shapes", Whole(Quantity::ModeShapes)),
    ("modal_masses", Whole(Quantity::ModalMasses)),
    ("modal_damping_ratios", Whole(Quantity::ModalDampingRatios)),
    ("modal_amplitudes", Whole(Quantity::ModalAmplitudes)),
    ("motion", Each(Quantity::Motion)),
    ("steady_motion", Each(Quantity::SteadyMotion)),
    ("energy", Whole(Quantity::Energy)),
    ("general_motion", Whole(Quantity::GeneralMotion)),
    ("complex_amplitude", Each(Quantity::ComplexAmplitude)),
    ("exact_period", Alone(Quantity::ExactPeriod)),
    ("exact_motion", Only(Quantity::ExactMotion)),
    (
        "half_cycles",
        Alone(Quantity::Frictional(Frictional::HalfCycles)),
    ),
    ("slides", Alone(Quantity::Frictional(Frictional::Slides))),
    (
        "stop_time",
        Alone(Quantity::Frictional(Frictional::StopTime)),
    ),
    (
        "rest_position",
        Only(Quantity::Frictional(Frictional::RestPosition)),
    ),
    (
        "path_length",
        Alone(Quantity::Frictional(Frictional::PathLength)),
    ),
    (
        "dissipated_energy",
        Alone(Quantity::Frictional(Frictional::DissipatedEnergy)),
    ),
];

/// The name that is spelled nearly so, or else the longest one with which it ends, as `natural_period` does with `period`.
fn meant(name: &str) -> Option<&'static str> {
    let names = || TABLE.iter().map(|row| row.0);
    let is_end = |own: &&str| {
        name.strip_suffix(own)
            .is_some_and(|rest| rest.ends_with('_'))
    };
    nearest(name, names()).or_else(|| names().filter(is_end).max_by_key(|own| own.len()))
}

impl Quantity {
    /// Whether it has a meaning only about an equilibrium.
    pub(crate) fn needs_rest(self) -> bool {
        !matches!(
            self,
            Self::Kinetic
                | Self::Potential
                | Self::Dissipation
                | Self::Equation(_)
                | Self::FullEquation(_)
                | Self::Equations
                | Self::MassMatrix
                | Self::DampingMatrix
                | Self::StiffnessMatrix
                | Self::Sdof(Sdof::Mass | Sdof::Damping | Sdof::Stiffness)
        )
    }

    /// The names of all quantities.
    pub fn names() -> impl Iterator<Item = &'static str> {
        TABLE.iter().map(|row| row.0)
    }

    pub(crate) fn of(model: &Model, path: &[Name]) -> Result<Self, QuantityError> {
        let (name, coordinates) = match path {
            [name, rest @ ..] => (name, rest),
            [] => (&Name::new(""), path),
        };
        let row = TABLE.iter().find(|row| row.0 == name.as_str());
        let Some((_, row)) = row else {
            return Err(QuantityError::Unknown {
                name: name.clone(),
                nearest: meant(name.as_str()),
            });
        };
        let [only_or_first, others @ ..] = model.coordinates() else {
            return Err(QuantityError::NotACoordinate { name: name.clone() });
        };
        let is_single = others.is_empty();
        let named = |own: &Name| {
            let mut coordinates = model.coordinates().iter();
            let at = coordinates.position(|coordinate| coordinate == own);
            at.ok_or_else(|| QuantityError::NotACoordinate { name: own.clone() })
        };
        let at = match coordinates {
            [] => None,
            [own] => Some(named(own)?),
            [_, extra, ..] => {
                return Err(QuantityError::NotACoordinate {
                    name: extra.clone(),
                });
            }
        };
        match (*row, at) {
            (Whole(_) | Alone(_), Some(_)) => Err(QuantityError::NotACoordinate {
                name: coordinates[0].clone(),
            }),
            (Alone(_) | Only(_), _) if !is_single => {
                Err(QuantityError::SeveralCoordinates { name: name.clone() })
            }
            (Whole(quantity) | Alone(quantity) | Only(quantity), _) => Ok(quantity),
            (Each(of), Some(at)) => Ok(of(at)),
            (Each(of), None) if is_single => Ok(of(0)),
            (Each(_), None) => Err(QuantityError::NoCoordinate {
                name: name.clone(),
                first: only_or_first.clone(),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn names_that_are_nearly_right_are_known() {
        assert_eq!(meant("dampng_ratio"), Some("damping_ratio"));
        assert_eq!(meant("natural_period"), Some("period"));
        assert_eq!(meant("first_damped_period"), Some("damped_period"));
        assert_eq!(meant("omega"), None);
    }
}
