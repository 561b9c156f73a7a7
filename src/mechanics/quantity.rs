//! The quantities that a model offers to an item, by name.

use thiserror::Error;

use super::equilibrium::Equilibrium;
use super::numbers::{Frictional, Motion, Numbers, Sdof};
use super::{Model, ModelError, Unavailable};
use crate::expr::{Name, Value};
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

impl Quantity {
    /// Whether it has a meaning only about an equilibrium.
    fn needs_rest(self) -> bool {
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
}

impl Model {
    /// The names of all quantities.
    pub fn quantity_names() -> impl Iterator<Item = &'static str> {
        TABLE.iter().map(|row| row.0)
    }

    /// The quantity that a path names, without its beginning (`model` or `models.<name>`).
    ///
    /// ```
    /// use vibank::expr::{Expr, Name};
    /// use vibank::mechanics::{Coordinate, Definition, Model, Quantity};
    /// let model = Model::derive(Definition {
    ///     coordinates: vec![Coordinate::length("x1"), Coordinate::length("x2")],
    ///     kinetic: Expr::read("1/2*m*(x1'^2 + x2'^2)")?,
    ///     ..Definition::default()
    /// })
    /// .unwrap();
    /// let path = ["motion", "x2"].map(Name::from);
    /// assert_eq!(model.quantity(&path)?, Quantity::Motion(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A name that is not a quantity of this model, or a coordinate that is missing or unknown.
    pub fn quantity(&self, path: &[Name]) -> Result<Quantity, QuantityError> {
        let (name, coordinates) = match path {
            [name, rest @ ..] => (name, rest),
            [] => (&Name::new(""), path),
        };
        let row = TABLE.iter().find(|row| row.0 == name.as_str());
        let Some((_, row)) = row else {
            return Err(QuantityError::Unknown {
                name: name.clone(),
                nearest: nearest(name.as_str(), TABLE.iter().map(|row| row.0)),
            });
        };
        let [only_or_first, others @ ..] = self.coordinates() else {
            return Err(QuantityError::NotACoordinate { name: name.clone() });
        };
        let is_single = others.is_empty();
        let named = |own: &Name| {
            let mut coordinates = self.coordinates().iter();
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

    /// Whether a quantity can exist: most need an equilibrium.
    ///
    /// # Errors
    ///
    /// [`ModelError::NoEquilibrium`].
    pub fn check(&self, quantity: Quantity) -> Result<(), ModelError> {
        match &self.equilibrium {
            Equilibrium::Missing(name) if quantity.needs_rest() => Err(ModelError::NoEquilibrium {
                name: name.clone(),
                span: self.definition.potential.span(),
            }),
            _ => Ok(()),
        }
    }
}

impl Numbers {
    /// The value of a quantity that is a number, or several.
    ///
    /// # Errors
    ///
    /// Why it has none; [`Unavailable::NoNumber`] for formulas, equations and functions of time.
    pub fn value_of(&self, quantity: Quantity) -> Result<Value, Unavailable> {
        Ok(match quantity {
            Quantity::MassMatrix => self.mass_matrix()?.clone(),
            Quantity::DampingMatrix => self.damping_matrix()?.clone(),
            Quantity::StiffnessMatrix => self.stiffness_matrix()?.clone(),
            Quantity::Equilibrium(at) | Quantity::StaticDeflection(at) => {
                self.equilibrium_value(at)?
            }
            Quantity::Equilibria => self.equilibria_value()?,
            Quantity::Stable => self.stable_value()?,
            Quantity::Sdof(single) => self.single(single)?,
            Quantity::NaturalAngularFrequencies => self.natural_angular_frequencies()?,
            Quantity::Multiplicities => self.multiplicities()?,
            Quantity::ModeShapes => self.mode_shapes()?,
            Quantity::ModalMasses => self.modal_masses()?,
            Quantity::ModalDampingRatios => self.modal_damping_ratios()?,
            Quantity::ModalAmplitudes => self.modal_amplitudes()?,
            Quantity::ComplexAmplitude(at) => self.complex_amplitude_value(at)?,
            Quantity::ExactPeriod => self.exact_period()?,
            Quantity::Frictional(frictional) => self.frictional(frictional)?,
            _ => return Err(Unavailable::NoNumber),
        })
    }

    /// The motion that a quantity is.
    ///
    /// # Errors
    ///
    /// Why there is none; [`Unavailable::NoMotion`] for what is not a function of time.
    pub fn motion_of(&self, quantity: Quantity) -> Result<Motion, Unavailable> {
        match quantity {
            Quantity::Motion(at) => self.motion(at),
            Quantity::SteadyMotion(at) => self.steady_motion(at),
            Quantity::Energy => self.energy(),
            Quantity::ExactMotion => self.exact_motion(),
            _ => Err(Unavailable::NoMotion),
        }
    }
}
