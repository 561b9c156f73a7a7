//! What can be wrong with the declaration of an answer.

use crate::diagnostic::{Code, Diagnose, Label};
use crate::source::Span;

/// Something in a part that its kind cannot use.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AnswerError {
    /// A key of a form that the kind does not take.
    #[error("the key of this kind is {expected}, this is {found}")]
    KeyForm {
        /// What the kind takes.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// A key whose unit is not known.
    #[error("the unit of this key is not known")]
    NoUnit,
    /// A unit of another dimension than the key.
    #[error("the key is in {expected}, this is in {found}")]
    Unit {
        /// The dimension of the key.
        expected: String,
        /// The dimension found.
        found: String,
    },
    /// A tolerance that cannot be read.
    #[error("`{found}` is not a tolerance")]
    Tolerance {
        /// What is there.
        found: String,
        /// Where in the text.
        span: Span,
    },
    /// An interval for an angle that cannot be read.
    #[error("`{0}` is not an interval for an angle")]
    Within(String),
    /// A choice without options, without a right one, or with too many.
    #[error("{0}")]
    Options(&'static str),
    /// Two options of one identity.
    #[error("there are two options `{0}`")]
    OptionTwice(String),
    /// A form in which answers are not asked.
    #[error("`{0}` is not one of `either`, `number`, `formula`")]
    Written(String),
    /// A text that is not an interval or equation.
    #[error("`{0}` is no {1}")]
    Unread(String, &'static str),
    /// A name that the item does not have.
    #[error("there is no `{0}` in this item")]
    UnknownName(String),
    /// A rubric that does not fit its part.
    #[error("{0}")]
    Rubric(String),
    /// A mistake that is not among the options.
    #[error("`{0}` is not an option of this part")]
    NoOption(String),
}

impl Diagnose for AnswerError {
    fn code(&self) -> Code {
        match self {
            Self::KeyForm { .. } | Self::UnknownName(_) | Self::Written(_) | Self::Unread(..) => {
                Code::KEY
            }
            Self::NoUnit | Self::Unit { .. } => Code::DIMENSION,
            Self::Tolerance { .. } | Self::Within(_) => Code::TOLERANCE,
            Self::Options(_) | Self::OptionTwice(_) | Self::NoOption(_) => Code::OPTIONS,
            Self::Rubric(_) => Code::PART,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let span = match self {
            Self::Tolerance { span, .. } => *span,
            _ => Span::NONE,
        };
        vec![Label {
            span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Tolerance { .. } => {
                "write for example `2 %`, `0.05 rad`, `3 sf` or `1 % of omega2`".to_owned()
            }
            Self::Within(_) => {
                "write `modulo = \"360 deg\"` and `within = \"(-180 deg, 180 deg]\"`".to_owned()
            }
            Self::Rubric(_) => {
                "write `rubric = [{ points = 2, text = \"…\" }]`, and `points` of the part as the sum of its rows".to_owned()
            }
            Self::NoUnit => "name a quantity that has a unit, or add `unit`".to_owned(),
            _ => return None,
        })
    }
}
