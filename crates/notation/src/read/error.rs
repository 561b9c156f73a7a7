//! What can be wrong with a formula in LaTeX.

use vibank_source::Span;
use vibank_source::diagnostic::{Code, Diagnose, Label, Severity};

/// What is wrong with a formula in LaTeX, with its place in it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LatexError {
    /// A formula that is longer than any should be.
    #[error("formula of {length} bytes, at most {limit} are read")]
    TooLong {
        /// The length of the formula in bytes.
        length: usize,
        /// The bound.
        limit: usize,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Groups inside each other beyond measure.
    #[error("nested too deeply")]
    TooDeep {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A command that is not in our LaTeX.
    #[error("unknown command `\\{name}`")]
    UnknownCommand {
        /// The command without its backslash.
        name: String,
        /// The command it may have been meant for.
        nearest: Option<&'static str>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// An environment that is not in our LaTeX.
    #[error("unknown environment `{name}`")]
    UnknownEnvironment {
        /// What stands between the braces of `\begin`.
        name: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Something that opens and does not close, or closes what was not opened.
    #[error("`{sign}` is not balanced")]
    Unbalanced {
        /// The sign that opens or closes.
        sign: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A character that means nothing in a formula.
    #[error("`{char}` cannot stand here in a formula")]
    StrayCharacter {
        /// The character, as it stands in the formula.
        char: char,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// LaTeX that cannot be read for another reason.
    #[error("{reason}")]
    Malformed {
        /// In the words of the parser.
        reason: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// `\(x\)`.
    #[error("`\\{sign}` does not begin a formula here")]
    BracketMath {
        /// The bracket.
        sign: char,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A formula between dollar signs within words of a formula.
    #[error("a dollar sign in `\\text` does not begin a formula")]
    MathInText {
        /// The bytes of the text that the message points at.
        span: Span,
    },
}

impl LatexError {
    /// Where it stands in the formula.
    pub fn span(&self) -> Span {
        match self {
            Self::TooLong { span, .. }
            | Self::TooDeep { span }
            | Self::UnknownCommand { span, .. }
            | Self::UnknownEnvironment { span, .. }
            | Self::Unbalanced { span, .. }
            | Self::StrayCharacter { span, .. }
            | Self::Malformed { span, .. }
            | Self::BracketMath { span, .. }
            | Self::MathInText { span } => *span,
        }
    }

    /// The same error somewhere else.
    #[must_use]
    pub fn at(mut self, place: Span) -> Self {
        match &mut self {
            Self::TooLong { span, .. }
            | Self::TooDeep { span }
            | Self::UnknownCommand { span, .. }
            | Self::UnknownEnvironment { span, .. }
            | Self::Unbalanced { span, .. }
            | Self::StrayCharacter { span, .. }
            | Self::Malformed { span, .. }
            | Self::BracketMath { span, .. }
            | Self::MathInText { span } => *span = place,
        }
        self
    }
}

impl Diagnose for LatexError {
    fn code(&self) -> Code {
        match self {
            Self::TooLong { .. } | Self::TooDeep { .. } => Code::TEXT_MARKUP,
            Self::UnknownCommand { .. }
            | Self::UnknownEnvironment { .. }
            | Self::Unbalanced { .. }
            | Self::StrayCharacter { .. }
            | Self::Malformed { .. } => Code::TEXT_MATH,
            Self::BracketMath { .. } | Self::MathInText { .. } => Code::TEXT_DOLLAR,
        }
    }

    fn severity(&self) -> Severity {
        match self {
            Self::BracketMath { .. } => Severity::Warning,
            _ => Severity::Error,
        }
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.span(),
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::TooLong { .. } | Self::TooDeep { .. } => "say it in fewer words",
            Self::UnknownCommand {
                nearest: Some(name),
                ..
            } => return Some(format!(r"write `\{name}`")),
            Self::UnknownCommand { .. } => {
                r"use a command of LaTeX and `amsmath`; for a function write `\operatorname{name}`"
            }
            Self::UnknownEnvironment { .. } => {
                "write `aligned`, `cases`, `matrix`, `pmatrix`, `bmatrix` or `vmatrix`"
            }
            Self::Unbalanced { .. } => "close what is opened and open what is closed",
            Self::StrayCharacter { char: '%', .. } => r"write `\%`",
            Self::StrayCharacter { .. } => r"leave it out, or put words into `\text{…}`",
            Self::Malformed { .. } => return None,
            Self::BracketMath { .. } => "write `$…$`, or `$$…$$` for a formula on its own",
            Self::MathInText { .. } => r"close the text before the formula: `\text{if }x`",
        };
        Some(help.to_owned())
    }
}
