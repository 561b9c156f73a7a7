//! Why a text is no formula.

use std::fmt;

use thiserror::Error;

use crate::unit;
use vibank_source::Span;
use vibank_source::diagnostic::{Code, Diagnose, Label};

/// Why a text could not be read as a formula, equation or interval.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// Another word than the grammar asks for.
    #[error("expected {expected}, found {found}")]
    Unexpected {
        /// What would have fitted, in words.
        expected: &'static str,
        /// What stands there: letters in back-ticks, or `the end`.
        found: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Two factors without a sign between them, `2k`.
    #[error("no operator between `{left}` and `{right}`")]
    ImplicitProduct {
        /// The end of the first factor.
        left: String,
        /// The beginning of the second factor.
        right: String,
        /// From the first to the end of the second.
        span: Span,
    },
    /// `**`, the power of other languages.
    #[error("`**` is not an operator")]
    DoubleStar {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// `=` where two things are compared.
    #[error("`=` does not compare")]
    SingleEquals {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// `0,5`.
    #[error("`{whole},{fraction}` is not a number")]
    DecimalComma {
        /// Before the comma.
        whole: String,
        /// After it.
        fraction: String,
        /// The whole.
        span: Span,
    },
    /// `5.` or `.5`.
    #[error("a decimal point needs digits on both sides")]
    BarePoint {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A number with more digits or a larger exponent than can be kept exactly.
    #[error("`{text}` has too many digits or too large an exponent")]
    NumberRange {
        /// As written.
        text: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A function that the language does not have.
    #[error("there is no function `{name}`")]
    UnknownFunction {
        /// As written.
        name: String,
        /// The nearest function.
        nearest: Option<&'static str>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A word of the language where a name is due.
    #[error("`{name}` is a word of the language, not a name")]
    Reserved {
        /// As written.
        name: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Too few or too many arguments.
    #[error("`{function}` takes {}, not {found}", Count(*.least, *.most))]
    ArgumentCount {
        /// The function or operator.
        function: &'static str,
        /// How many it has.
        found: usize,
        /// The smallest number it takes.
        least: usize,
        /// The largest number it takes.
        most: usize,
        /// The call.
        span: Span,
    },
    /// `x = a` as an argument of a function other than `at`, or none where `at` needs one.
    #[error("{}", if *.due { "`at` takes values as `name = value`" } else { "only `at` takes arguments with a name" })]
    NamedArgument {
        /// Whether a name was due.
        due: bool,
        /// The argument.
        span: Span,
    },
    /// Something else where an operator needs the name of a variable.
    #[error("`{operator}` needs the name of a variable here")]
    NameDue {
        /// `diff`, `root` or `integral`.
        operator: &'static str,
        /// What stands there.
        span: Span,
    },
    /// `2 [m]`.
    #[error("the unit of a number stands right after it")]
    SpaceBeforeUnit {
        /// The space and the bracket.
        span: Span,
    },
    /// `2[m`.
    #[error("the bracket of this unit is not closed")]
    UnclosedUnit {
        /// The bracket.
        span: Span,
    },
    /// What stands in the brackets is not a unit.
    #[error("{reason}")]
    Unit {
        /// What is wrong, with the place between the brackets.
        reason: unit::Error,
        /// The unit with its brackets.
        span: Span,
    },
    /// A letter that formulas do not use.
    #[error("`{character}` has no meaning in a formula")]
    UnknownCharacter {
        /// The character, as it stands in the formula.
        character: char,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// More primes than any motion needs.
    #[error("more than {most} primes")]
    TooManyPrimes {
        /// The bound.
        most: u8,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A text that is too long to be a formula.
    #[error("{bytes} bytes are too long for a formula, at most {most} are read")]
    TooLong {
        /// Its length.
        bytes: usize,
        /// The bound.
        most: usize,
    },
    /// Too many nodes.
    #[error("the formula has more than {most} operations and operands")]
    TooLarge {
        /// The bound.
        most: u32,
        /// Where the bound was passed.
        span: Span,
    },
    /// Too deep a nesting.
    #[error("the formula is nested more than {most} deep")]
    TooDeep {
        /// The bound.
        most: u32,
        /// Where the bound was passed.
        span: Span,
    },
}

impl ReadError {
    /// Where in the text it is.
    pub fn span(&self) -> Span {
        match self {
            Self::Unexpected { span, .. }
            | Self::ImplicitProduct { span, .. }
            | Self::DoubleStar { span }
            | Self::SingleEquals { span }
            | Self::DecimalComma { span, .. }
            | Self::BarePoint { span }
            | Self::NumberRange { span, .. }
            | Self::UnknownFunction { span, .. }
            | Self::Reserved { span, .. }
            | Self::ArgumentCount { span, .. }
            | Self::NamedArgument { span, .. }
            | Self::NameDue { span, .. }
            | Self::SpaceBeforeUnit { span }
            | Self::UnclosedUnit { span }
            | Self::UnknownCharacter { span, .. }
            | Self::TooManyPrimes { span, .. }
            | Self::TooLarge { span, .. }
            | Self::TooDeep { span, .. } => *span,
            Self::Unit { reason, span } => {
                Span::from(reason.span.clone()).shifted(span.start as usize + 1)
            }
            Self::TooLong { bytes, .. } => Span::new(0, *bytes),
        }
    }
}

impl Diagnose for ReadError {
    fn code(&self) -> Code {
        Code::FORMULA_SYNTAX
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.span(),
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::ImplicitProduct { left, right, .. } if right == "(" => {
                format!("write `{left}*(`")
            }
            Self::ImplicitProduct { left, right, .. } => format!("write `{left}*{right}`"),
            Self::DoubleStar { .. } => "write `^` for a power".to_owned(),
            Self::SingleEquals { .. } => "write `==` to compare".to_owned(),
            Self::DecimalComma {
                whole, fraction, ..
            } => format!("write `{whole}.{fraction}`"),
            Self::BarePoint { .. } => "write `0.5` or `5`".to_owned(),
            Self::NumberRange { .. } => {
                "keep at most 38 digits, before and after the point together".to_owned()
            }
            Self::UnknownFunction {
                nearest: Some(nearest),
                ..
            } => format!("write `{nearest}`"),
            Self::UnknownFunction { name, .. } => format!("write `{name}*(` if a product is meant"),
            Self::Reserved { name, .. } => format!("choose another name than `{name}`"),
            Self::SpaceBeforeUnit { .. } => "remove the space before the bracket".to_owned(),
            Self::UnclosedUnit { .. } => "close the unit with `]`".to_owned(),
            Self::Unit { reason, .. } => return reason.help(),
            Self::TooLarge { .. } | Self::TooDeep { .. } | Self::TooLong { .. } => {
                "give parts of the formula names of their own".to_owned()
            }
            _ => return None,
        })
    }
}

/// A number of arguments in words.
struct Count(usize, usize);

impl fmt::Display for Count {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self(1, 1) => formatter.write_str("1 argument"),
            Self(least, most) if least == most => write!(formatter, "{least} arguments"),
            Self(least, usize::MAX) => write!(formatter, "{least} or more arguments"),
            Self(least, most) => write!(formatter, "{least} to {most} arguments"),
        }
    }
}
