//! What can be wrong with a model.

use thiserror::Error;

use crate::diagnostic::{Code, Diagnose, Label};
use crate::expr::{CheckError, Name, SymbolicError};
use crate::source::Span;
use crate::unit::Dimension;

/// A key of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DefinitionKey {
    /// The key `coordinates`: names and dimensions of what moves.
    Coordinates,
    /// The key `kinematics`: positions as formulas in the coordinates.
    Kinematics,
    /// The key `kinetic`: T in coordinates and velocities.
    Kinetic,
    /// The key `potential`: V in the coordinates.
    Potential,
    /// The key `dissipation`: Rayleigh's D in the velocities.
    Dissipation,
    /// The key `forces`: generalized forces along the coordinates.
    Forces,
    /// The key `friction`: dry friction along a coordinate.
    Friction,
    /// The key `initial`: displacements and velocities at t = 0.
    Initial,
    /// The key `equilibrium`: where it is sought, or what it is.
    Equilibrium,
}

impl DefinitionKey {
    /// As it is written.
    pub fn name(self) -> &'static str {
        match self {
            Self::Coordinates => "coordinates",
            Self::Kinematics => "kinematics",
            Self::Kinetic => "kinetic",
            Self::Potential => "potential",
            Self::Dissipation => "dissipation",
            Self::Forces => "forces",
            Self::Friction => "friction",
            Self::Initial => "initial",
            Self::Equilibrium => "equilibrium",
        }
    }
}

impl std::fmt::Display for DefinitionKey {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(self.name())
    }
}

/// Why a model cannot be derived, or serves no purpose.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// No coordinate, or more than can be treated.
    #[error("a model has 1 to {most} coordinates, this one has {found}")]
    CoordinateCount {
        /// How many there are.
        found: usize,
        /// How many there can be.
        most: usize,
    },
    /// Something is wrong with a formula by itself.
    #[error("`{key}`: {error}")]
    Check {
        /// In which formula.
        key: DefinitionKey,
        /// What is wrong with the formula.
        error: CheckError,
    },
    /// A term of another dimension than its formula has to have.
    #[error("a term of `{key}` is in {}, due is {}", found.map_or("several dimensions".into(), Dimension::describe), expected.describe())]
    Dimension {
        /// In which formula.
        key: DefinitionKey,
        /// The dimension of the term; none if it is not a single number.
        found: Option<Dimension>,
        /// What is due.
        expected: Dimension,
        /// The term.
        span: Span,
    },
    /// A name stands for two things that move.
    #[error("`{name}` is declared twice in `coordinates` and `kinematics`")]
    Duplicate {
        /// The name, as the model writes it.
        name: Name,
        /// Where it is declared again.
        span: Span,
    },
    /// Kinematic names that need each other.
    #[error("`{name}` is defined by itself")]
    Cycle {
        /// One of them.
        name: Name,
        /// Its formula.
        span: Span,
    },
    /// Something is given along a name that is not a coordinate.
    #[error("`{name}` in `{key}` is not a coordinate of this model")]
    UnknownCoordinate {
        /// The name, as the model writes it.
        name: Name,
        /// In which table.
        key: DefinitionKey,
        /// The formula that is given.
        span: Span,
    },
    /// A velocity of something that does not move.
    #[error("`{name}'` in `{key}`, but `{name}` is neither a coordinate nor in `kinematics`")]
    MissingCoordinate {
        /// The name, as the model writes it.
        name: Name,
        /// In which formula.
        key: DefinitionKey,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// An energy that depends on accelerations.
    #[error("`{key}` depends on an acceleration")]
    Acceleration {
        /// In which formula.
        key: DefinitionKey,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A potential energy that depends on velocities.
    #[error("`potential` depends on the velocity `{name}'`")]
    VelocityInPotential {
        /// The coordinate.
        name: Name,
        /// The formula.
        span: Span,
    },
    /// A kinetic energy that is not of the second degree in the velocities.
    #[error("`kinetic` is not quadratic in `{name}'`")]
    NotQuadratic {
        /// The coordinate.
        name: Name,
        /// The formula.
        span: Span,
    },
    /// A coordinate along which nothing has inertia.
    #[error("`kinetic` does not depend on `{name}'`: nothing has mass along `{name}`")]
    Massless {
        /// The coordinate.
        name: Name,
        /// Where it is declared.
        span: Span,
    },
    /// A potential energy that falls without bound on both sides.
    #[error("`potential` has no lower bound along `{name}`")]
    Unbounded {
        /// The coordinate.
        name: Name,
        /// The formula.
        span: Span,
    },
    /// A system that rests nowhere.
    #[error("the model has no equilibrium: a constant force along `{name}` is not balanced")]
    NoEquilibrium {
        /// A coordinate along which the force acts.
        name: Name,
        /// The formula of the potential energy.
        span: Span,
    },
    /// A stated position that is not an equilibrium.
    #[error("the stated position is not an equilibrium: a force along `{name}` is left")]
    NotAnEquilibrium {
        /// The coordinate.
        name: Name,
        /// The stated position.
        span: Span,
    },
    /// A calculation with formulas that does not go through.
    #[error("`{key}`: {error}")]
    Symbolic {
        /// In which formula.
        key: DefinitionKey,
        /// What the algebra could not do.
        error: SymbolicError,
        /// The formula, or the place in it.
        span: Span,
    },
}

impl ModelError {
    pub(crate) fn symbolic(key: DefinitionKey, whole: Span) -> impl Fn(SymbolicError) -> Self {
        move |error| {
            let place = error.span().filter(|span| !span.is_none());
            Self::Symbolic {
                key,
                span: place.unwrap_or(whole),
                error,
            }
        }
    }
}

impl Diagnose for ModelError {
    fn code(&self) -> Code {
        match self {
            Self::Check { error, .. } => error.code(),
            Self::Dimension { .. } => Code::MODEL_DIMENSION,
            Self::Unbounded { .. } | Self::NoEquilibrium { .. } | Self::NotAnEquilibrium { .. } => {
                Code::MODEL_EQUILIBRIUM
            }
            Self::NotQuadratic { .. } | Self::Massless { .. } | Self::Acceleration { .. } => {
                Code::MODEL_KINETIC
            }
            Self::Symbolic { .. } => Code::MODEL_FORMULA,
            _ => Code::MODEL_COORDINATE,
        }
    }

    fn labels(&self) -> Vec<Label> {
        match self {
            Self::Check { error, .. } => error.labels(),
            Self::Dimension { found, span, .. } => {
                vec![Label {
                    span: *span,
                    text: found.map_or_else(String::new, Dimension::describe),
                }]
            }
            Self::CoordinateCount { .. } => Vec::new(),
            Self::Duplicate { span, .. }
            | Self::Cycle { span, .. }
            | Self::UnknownCoordinate { span, .. }
            | Self::MissingCoordinate { span, .. }
            | Self::Acceleration { span, .. }
            | Self::VelocityInPotential { span, .. }
            | Self::NotQuadratic { span, .. }
            | Self::Massless { span, .. }
            | Self::Unbounded { span, .. }
            | Self::NoEquilibrium { span, .. }
            | Self::NotAnEquilibrium { span, .. }
            | Self::Symbolic { span, .. } => vec![Label {
                span: *span,
                text: String::new(),
            }],
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Check { error, .. } => return error.help(),
            Self::CoordinateCount { .. } => "declare the coordinates in `coordinates`".to_owned(),
            Self::Duplicate { name, .. } => format!("give one of the two `{name}` another name"),
            Self::Cycle { .. } => "express it in coordinates and time".to_owned(),
            Self::UnknownCoordinate { name, .. } => {
                format!("add `{name}` to `coordinates`, or name one that is there")
            }
            Self::MissingCoordinate { name, .. } => {
                format!("add `{name}` to `coordinates`, or say in `kinematics` how it moves")
            }
            Self::VelocityInPotential { .. } => {
                "write what damps in `dissipation`, other forces in `forces`".to_owned()
            }
            Self::Acceleration { .. } => "write energies in positions and velocities".to_owned(),
            Self::NotQuadratic { name, .. } => {
                format!("write the kinetic energy with `{name}'^2`, as `1/2*m*{name}'^2`")
            }
            Self::Massless { name, .. } => {
                format!(
                    "add the kinetic energy of what moves with `{name}`, or express `{name}` in `kinematics`"
                )
            }
            Self::Unbounded { .. } => {
                "check the signs: the energy of a spring is positive".to_owned()
            }
            Self::NoEquilibrium { .. } => {
                "add what holds the system, or check the force".to_owned()
            }
            Self::NotAnEquilibrium { .. } => {
                "leave `equilibrium` out to have it found, or correct the position".to_owned()
            }
            Self::Dimension { .. } | Self::Symbolic { .. } => return None,
        })
    }
}
