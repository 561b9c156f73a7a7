//! What can be wrong with how an item's formulas hang together.

use crate::diagnostic::{Code, Diagnose, Label};
use crate::expr::{CheckError, CompileError, Name};
use crate::mechanics::{ModelError, QuantityError};
use crate::source::Span;

/// What is wrong with how an item's formulas hang together.
#[derive(Clone, Debug, thiserror::Error)]
pub enum GraphError {
    /// Names or dimensions.
    #[error(transparent)]
    Check(#[from] CheckError),
    /// Size, or a derivative that does not exist.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// A quantity that depends on itself.
    #[error("`{}` depends on itself", .circle[0])]
    Cycle {
        /// The names of the circle, the first once more at the end.
        circle: Vec<Name>,
    },
    /// A chain of quantities that is too long.
    #[error("`{name}` depends on more than {limit} quantities in a row")]
    TooLong {
        /// The quantity at which it is too long.
        name: Name,
        /// How long a chain may be.
        limit: usize,
    },
    /// A formula of another type than is declared for it.
    #[error("{what} is declared as {declared}, but its formula is {found}")]
    Declared {
        /// What it is about.
        what: String,
        /// The declared type.
        declared: String,
        /// The type found.
        found: String,
    },
    /// A model that cannot be derived.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A path that leads to no quantity of a model.
    #[error("{error}")]
    Offer {
        /// What is wrong with the formula.
        error: QuantityError,
        /// Where the path stands.
        span: Span,
    },
    /// A name that is taken.
    #[error("`{name}` is already the name of something else in this item")]
    Taken {
        /// The name of the quantity, as the item declares it.
        name: Name,
    },
}

impl Diagnose for GraphError {
    fn code(&self) -> Code {
        match self {
            Self::Check(error) => error.code(),
            Self::Model(error) => error.code(),
            Self::Offer { .. } => Code::MODEL_QUANTITY,
            Self::Compile(error) => error.code(),
            Self::Cycle { .. } | Self::TooLong { .. } => Code::CYCLE,
            Self::Declared { .. } => Code::DIMENSION,
            Self::Taken { .. } => Code::NAME_TAKEN,
        }
    }

    fn labels(&self) -> Vec<Label> {
        match self {
            Self::Check(error) => error.labels(),
            Self::Model(error) => error.labels(),
            Self::Offer { span, .. } => vec![Label {
                span: *span,
                text: String::new(),
            }],
            _ => vec![Label {
                span: Span::NONE,
                text: String::new(),
            }],
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::Check(error) => error.help(),
            Self::Model(error) => error.help(),
            Self::Offer {
                error:
                    QuantityError::Unknown {
                        nearest: Some(near),
                        ..
                    },
                ..
            } => Some(format!("did you mean `{near}`?")),
            Self::Cycle { circle } => {
                let names: Vec<String> = circle.iter().map(ToString::to_string).collect();
                Some(format!("break the circle {}", names.join(" → ")))
            }
            Self::TooLong { .. } => {
                Some("write several steps of the chain as one formula".to_owned())
            }
            Self::Taken { .. } => {
                Some("parameters and quantities share one list of names: choose another".to_owned())
            }
            _ => None,
        }
    }
}
