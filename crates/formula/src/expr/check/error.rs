//! What is wrong with the types of a formula.

use std::fmt;

use thiserror::Error;

use crate::expr::{Form, Name, Path, Shape};
use crate::unit::Dimension;
use vibank_dynamics::numerics::Rational;
use vibank_source::Span;
use vibank_source::diagnostic::{Code, Diagnose, Label};

/// What is wrong with the names, forms or dimensions of a formula.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CheckError {
    /// A name that stands for nothing.
    #[error("`{name}` is not known here")]
    UnknownName {
        /// The name, as it is written in the formula.
        name: Name,
        /// The nearest known name.
        nearest: Option<String>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A quantity that the model does not have.
    #[error("`{path}` is not known here")]
    UnknownPath {
        /// The path, as it is written in the formula.
        path: Path,
        /// The nearest known path.
        nearest: Option<String>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Two dimensions that have to agree and do not.
    #[error("{joint} {} and {}", describe(*.left), describe(*.right))]
    Dimensions {
        /// What joins the two.
        joint: Joint,
        /// Of the first.
        left: Dimension,
        /// Of the second.
        right: Dimension,
        /// Where the two stand.
        spans: [Span; 2],
    },
    /// An argument with a dimension where a pure number is due.
    #[error("the argument of `{function}` has to be a pure number, it is in {}", found.describe())]
    NotPure {
        /// The function that is called.
        function: &'static str,
        /// The dimension of the argument.
        found: Dimension,
        /// The argument.
        span: Span,
    },
    /// An exponent with a dimension.
    #[error("an exponent has to be a pure number, it is in {}", found.describe())]
    ExponentNotPure {
        /// Its dimension.
        found: Dimension,
        /// The exponent.
        span: Span,
    },
    /// A power of a quantity with a dimension whose exponent is no constant.
    #[error("the power of a quantity in {} needs a constant exponent", base.describe())]
    ExponentNotConstant {
        /// The dimension of the base.
        base: Dimension,
        /// The exponent.
        span: Span,
    },
    /// A power whose dimension has exponents beyond all use.
    #[error("the power {exponent} of {} is not a dimension", base.describe())]
    PowerDimension {
        /// The dimension of the base.
        base: Dimension,
        /// The exponent, as it is written.
        exponent: Rational,
        /// The power.
        span: Span,
    },
    /// A number where a condition is due.
    #[error("a condition is due, this is {found}")]
    ConditionDue {
        /// What there is.
        found: Form,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A condition, vector or matrix where a number is due.
    #[error("a number is due, this is {found}")]
    NumberDue {
        /// What there is.
        found: Form,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A complex number where a real number is due.
    #[error("a real number is due, this is {found}")]
    RealDue {
        /// What there is.
        found: Form,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A number where a function takes vectors or matrices.
    #[error("`{function}` takes {due}, this is {found}")]
    ShapeDue {
        /// The function or operator.
        function: &'static str,
        /// What it takes.
        due: &'static str,
        /// What there is.
        found: Form,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Two shapes that an operator cannot join.
    #[error("`{operator}` cannot join {left} and {right}")]
    Shapes {
        /// The operator or function.
        operator: &'static str,
        /// Of the first.
        left: Shape,
        /// Of the second.
        right: Shape,
        /// Where the two stand.
        spans: [Span; 2],
    },
    /// An index that is not an integer from 1.
    #[error("an index is an integer from 1, written out")]
    IndexNotWhole {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// An index beyond the end.
    #[error("there is no component {index} in {shape}")]
    IndexRange {
        /// The index, as it is written.
        index: usize,
        /// What is indexed.
        shape: Shape,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// An index of something that has no components, or too many indices.
    #[error("{found} has no component with {count} {}", if *.count == 1 { "index" } else { "indices" })]
    IndexCount {
        /// What is indexed.
        found: Form,
        /// The number of indices.
        count: usize,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A prime on something that does not change with time.
    #[error("`{name}` does not change with time")]
    NotMoving {
        /// The name, as it is written in the formula.
        name: Name,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A value for a name that does not fit it.
    #[error("`{name}` is in {}, the value for it is in {}", declared.describe(), given.describe())]
    BoundDimension {
        /// The name, as it is written in the formula.
        name: Name,
        /// Its dimension.
        declared: Dimension,
        /// The dimension of the value.
        given: Dimension,
        /// The value.
        span: Span,
    },
}

/// What joins two dimensions that have to agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joint {
    /// `+` and `-`.
    Sum,
    /// `<` and kin.
    Comparison,
    /// `if`.
    Cases,
    /// Arguments of a function.
    Arguments(&'static str),
    /// The terms that are added in a product of matrices, a scalar product or a determinant.
    Terms(&'static str),
    /// The two sides of an equation.
    Equation,
    /// The two ends of an interval.
    Interval,
}

/// As the beginning of a message that ends in `… N and m`.
impl fmt::Display for Joint {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sum => formatter.write_str("a sum of"),
            Self::Comparison => formatter.write_str("a comparison of"),
            Self::Cases => formatter.write_str("the two cases are in"),
            Self::Arguments(function) => write!(formatter, "the arguments of `{function}` are in"),
            Self::Terms(operator) => write!(formatter, "the terms of `{operator}` are in"),
            Self::Equation => formatter.write_str("the sides of the equation are in"),
            Self::Interval => formatter.write_str("the ends of the interval are in"),
        }
    }
}

fn describe(dimension: Dimension) -> String {
    if dimension.is_pure() {
        "pure numbers".to_owned()
    } else {
        dimension.describe()
    }
}

impl CheckError {
    /// Where in the formula it is.
    pub fn span(&self) -> Span {
        match self {
            Self::UnknownName { span, .. }
            | Self::UnknownPath { span, .. }
            | Self::NotPure { span, .. }
            | Self::ExponentNotPure { span, .. }
            | Self::ExponentNotConstant { span, .. }
            | Self::PowerDimension { span, .. }
            | Self::ConditionDue { span, .. }
            | Self::NumberDue { span, .. }
            | Self::RealDue { span, .. }
            | Self::ShapeDue { span, .. }
            | Self::IndexNotWhole { span }
            | Self::IndexRange { span, .. }
            | Self::IndexCount { span, .. }
            | Self::NotMoving { span, .. }
            | Self::BoundDimension { span, .. } => *span,
            Self::Dimensions { spans, .. } | Self::Shapes { spans, .. } => spans[0].join(spans[1]),
        }
    }
}

impl Diagnose for CheckError {
    fn code(&self) -> Code {
        match self {
            Self::UnknownName { .. } | Self::UnknownPath { .. } => Code::FORMULA_UNKNOWN_NAME,
            Self::Dimensions { .. }
            | Self::NotPure { .. }
            | Self::ExponentNotPure { .. }
            | Self::ExponentNotConstant { .. }
            | Self::PowerDimension { .. }
            | Self::BoundDimension { .. } => Code::FORMULA_DIMENSION,
            _ => Code::FORMULA_FORM,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let label = |span: Span, text: String| Label { span, text };
        match self {
            Self::Dimensions {
                left, right, spans, ..
            } => {
                vec![
                    label(spans[0], left.describe()),
                    label(spans[1], right.describe()),
                ]
            }
            Self::Shapes {
                left, right, spans, ..
            } => {
                vec![
                    label(spans[0], left.to_string()),
                    label(spans[1], right.to_string()),
                ]
            }
            _ => vec![label(self.span(), String::new())],
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::UnknownName { nearest, .. } | Self::UnknownPath { nearest, .. } => {
                nearest.as_ref().map(|nearest| format!("write `{nearest}`"))
            }
            Self::Shapes {
                operator: "*",
                left: Shape::Vector(_),
                right: Shape::Vector(_),
                ..
            } => Some("write `dot(u, v)` for the scalar product".to_owned()),
            Self::RealDue { .. } => Some("take `re`, `im` or `abs` of it".to_owned()),
            _ => None,
        }
    }
}
