//! Why a formula cannot become a program.

use thiserror::Error;

use crate::expr::{Form, Name, Path, SymbolicError};
use vibank_source::Span;
use vibank_source::diagnostic::{Code, Diagnose, Label};

/// What translation gives.
pub(crate) type Result<T> = std::result::Result<T, CompileError>;

/// Why a formula cannot become a program. A formula that was checked fails only for its size or a missing derivative.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CompileError {
    /// A name that nothing is bound to.
    #[error("`{name}` has no meaning here")]
    UnknownName {
        /// The name, as it is written in the formula.
        name: Name,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A path that nothing is bound to.
    #[error("`{path}` has no meaning here")]
    UnknownPath {
        /// The path, as it is written in the formula.
        path: Path,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A value of a form that does not fit its place.
    #[error("{found} does not fit here")]
    Form {
        /// What there is.
        found: Form,
    },
    /// An index that is not an integer.
    #[error("an index has to be an integer")]
    Index {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A derivative that cannot be formed.
    #[error(transparent)]
    Symbolic(#[from] SymbolicError),
    /// More steps than a program may have.
    #[error("the formula grows too large when its names are substituted")]
    TooLarge,
    /// Names that are put in deeper than the bounds allow, or in a circle.
    #[error("the formula grows too deep when its names are substituted")]
    TooDeep,
}

impl CompileError {
    /// Where in the formula it is, if it has a place.
    pub fn span(&self) -> Span {
        match self {
            Self::UnknownName { span, .. }
            | Self::UnknownPath { span, .. }
            | Self::Index { span } => *span,
            Self::Symbolic(error) => error.span().unwrap_or(Span::NONE),
            Self::Form { .. } | Self::TooLarge | Self::TooDeep => Span::NONE,
        }
    }
}

impl Diagnose for CompileError {
    fn code(&self) -> Code {
        match self {
            Self::UnknownName { .. } | Self::UnknownPath { .. } => Code::FORMULA_UNKNOWN_NAME,
            Self::Form { .. } | Self::Index { .. } => Code::FORMULA_FORM,
            Self::Symbolic(SymbolicError::TooLarge) | Self::TooLarge | Self::TooDeep => {
                Code::FORMULA_SIZE
            }
            Self::Symbolic(_) => Code::FORMULA_PROGRAM,
        }
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.span(),
            text: String::new(),
        }]
    }
}
