//! What can go wrong in a symbolic calculation.

use thiserror::Error;

use crate::expr::{Name, Path};
use crate::work::Exhausted;
use vibank_source::Span;

/// Why a formula has no derivative, substitution or normal form.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SymbolicError {
    /// The operation has no derivative, or none that this language can write.
    #[error("`{what}` has no derivative")]
    NotDifferentiable {
        /// The function or operation.
        what: &'static str,
        /// Where it stands.
        span: Span,
    },
    /// A quantity of a model stands where its formula would be needed.
    #[error("`{path}` has no formula here")]
    Unresolved {
        /// The path, as it is written in the formula.
        path: Path,
        /// Where it stands.
        span: Span,
    },
    /// A bound name of an operator would catch a name of what is substituted.
    #[error("the bound name `{name}` also stands in what is substituted")]
    Captured {
        /// The bound name.
        name: Name,
        /// Where the operator stands.
        span: Span,
    },
    /// A division by zero.
    #[error("the formula divides by zero")]
    Undefined,
    /// The result would grow beyond the bounds.
    #[error("the formula grows too large")]
    TooLarge,
}

/// What takes too long has grown too large on its way.
impl From<Exhausted> for SymbolicError {
    fn from(_: Exhausted) -> Self {
        Self::TooLarge
    }
}

impl SymbolicError {
    /// Where in the formula the reason stands, if it has a place.
    pub fn span(&self) -> Option<Span> {
        match self {
            Self::NotDifferentiable { span, .. }
            | Self::Unresolved { span, .. }
            | Self::Captured { span, .. } => Some(*span),
            Self::Undefined | Self::TooLarge => None,
        }
    }
}
