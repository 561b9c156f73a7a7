//! What can be wrong with a text.

use crate::diagnostic::{Code, Diagnose, Label, Severity};
use crate::math::LatexError;
use crate::source::Span;

/// What is wrong with a text, with its place in it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TextError {
    /// A formula that cannot be read, or a bracket of LaTeX where no formula begins.
    #[error(transparent)]
    Formula(#[from] LatexError),
    /// A text that is longer than any should be.
    #[error("text of {length} bytes, at most {limit} are read")]
    TooLong {
        /// The length of the text in bytes.
        length: usize,
        /// The bound.
        limit: usize,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// Brackets, lists or quotations inside each other beyond measure.
    #[error("nested too deeply")]
    TooDeep {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A character that no text may contain.
    #[error("the character U+{:04X} cannot stand in a text", u32::from(*.char))]
    Character {
        /// The character, as it stands in the text.
        char: char,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// `<<` without `>>`.
    #[error("`<<` is not closed")]
    UnterminatedPlaceholder {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// What stands between `<<` and `>>` is not a name.
    #[error("`{text}` is not a name")]
    MalformedPlaceholder {
        /// What stands there.
        text: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A word after the dot that is not a form.
    #[error("unknown form `{name}`")]
    UnknownForm {
        /// The word.
        name: String,
        /// The form it may have been meant for.
        nearest: Option<&'static str>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// More placeholders than a text may have.
    #[error("more than {limit} placeholders in one text")]
    TooManyPlaceholders {
        /// The bound.
        limit: usize,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A placeholder where nothing can be put: in code, in the target of a link.
    #[error("a placeholder cannot stand in {place}")]
    MisplacedPlaceholder {
        /// What the placeholder stands in, as a phrase.
        place: &'static str,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// HTML in a text.
    #[error("HTML in a text")]
    Html {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A Markdown image: figures are declared in `[figure]`.
    #[error("an image in a text")]
    Image {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A link that leads elsewhere than to a page.
    #[error("the link `{to}` is neither `https`, `http` nor relative")]
    Link {
        /// Its target.
        to: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// `$ x $`.
    #[error("a blank inside the dollar signs, so this is printed as it stands")]
    SpacedMath {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A formula on its own with an empty line in it.
    #[error("an empty line ends the formula before its closing `$$`")]
    BlankLineInMath {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// `$|x|$` in a table.
    #[error("a bar in a formula ends the cell of the table")]
    BarInCell {
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A dollar sign that begins no formula.
    #[error("a dollar sign that begins no formula")]
    LoneDollar {
        /// The bytes of the text that the message points at.
        span: Span,
    },
}

impl TextError {
    /// Where it stands in the text.
    pub fn span(&self) -> Span {
        match self {
            Self::Formula(error) => error.span(),
            Self::TooLong { span, .. }
            | Self::TooDeep { span }
            | Self::Character { span, .. }
            | Self::UnterminatedPlaceholder { span }
            | Self::MalformedPlaceholder { span, .. }
            | Self::UnknownForm { span, .. }
            | Self::TooManyPlaceholders { span, .. }
            | Self::MisplacedPlaceholder { span, .. }
            | Self::Html { span }
            | Self::Image { span }
            | Self::Link { span, .. }
            | Self::SpacedMath { span }
            | Self::BlankLineInMath { span }
            | Self::BarInCell { span }
            | Self::LoneDollar { span } => *span,
        }
    }

    /// The same error somewhere else.
    #[must_use]
    pub fn at(mut self, place: Span) -> Self {
        match &mut self {
            Self::Formula(error) => return error.clone().at(place).into(),
            Self::TooLong { span, .. }
            | Self::TooDeep { span }
            | Self::Character { span, .. }
            | Self::UnterminatedPlaceholder { span }
            | Self::MalformedPlaceholder { span, .. }
            | Self::UnknownForm { span, .. }
            | Self::TooManyPlaceholders { span, .. }
            | Self::MisplacedPlaceholder { span, .. }
            | Self::Html { span }
            | Self::Image { span }
            | Self::Link { span, .. }
            | Self::SpacedMath { span }
            | Self::BlankLineInMath { span }
            | Self::BarInCell { span }
            | Self::LoneDollar { span } => *span = place,
        }
        self
    }
}

impl Diagnose for TextError {
    fn code(&self) -> Code {
        match self {
            Self::Formula(error) => error.code(),
            Self::TooLong { .. }
            | Self::TooDeep { .. }
            | Self::Character { .. }
            | Self::Html { .. }
            | Self::Image { .. }
            | Self::Link { .. } => Code::TEXT_MARKUP,
            Self::UnterminatedPlaceholder { .. }
            | Self::MalformedPlaceholder { .. }
            | Self::UnknownForm { .. }
            | Self::TooManyPlaceholders { .. }
            | Self::MisplacedPlaceholder { .. } => Code::TEXT_PLACEHOLDER,
            Self::SpacedMath { .. }
            | Self::BlankLineInMath { .. }
            | Self::BarInCell { .. }
            | Self::LoneDollar { .. } => Code::TEXT_DOLLAR,
        }
    }

    fn severity(&self) -> Severity {
        match self {
            Self::Formula(error) => error.severity(),
            Self::LoneDollar { .. } | Self::SpacedMath { .. } => Severity::Warning,
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
            Self::Formula(error) => return error.help(),
            Self::TooLong { .. } | Self::TooDeep { .. } => "say it in fewer words",
            Self::Character { .. } => "leave it out",
            Self::UnterminatedPlaceholder { .. } => {
                r"close it with `>>`; for the sign itself write `\<<`, in a formula `\ll`"
            }
            Self::MalformedPlaceholder { .. } => "write `<< name >>` or `<< name.form >>`",
            Self::UnknownForm {
                nearest: Some(name),
                ..
            } => return Some(format!("write `{name}`")),
            Self::UnknownForm { .. } => {
                "write one of `given`, `symbol`, `name`, `number`, `unit`, `formula`, `substituted`, `equation`"
            }
            Self::TooManyPlaceholders { .. } => "split the text",
            Self::MisplacedPlaceholder { .. } => "put it on a line of its own or into the words",
            Self::Html { .. } => r"write Markdown; for the sign itself write `\<`",
            Self::Image { .. } => {
                "place a figure by `<< figure >>` or a plot by `<< plots.name >>`"
            }
            Self::Link { .. } => "write the whole address, beginning with `https://`",
            Self::SpacedMath { .. } => r"leave out the blanks; for the sign itself write `\$`",
            Self::BlankLineInMath { .. } => "leave out the empty line",
            Self::BarInCell { .. } => r"write `\lvert x\rvert` or `\mid`",
            Self::LoneDollar { .. } => r"for the sign itself write `\$`",
        };
        Some(help.to_owned())
    }
}
