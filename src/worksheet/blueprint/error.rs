//! What is wrong with a blueprint beyond its form.

use super::FORMATS;
use crate::bank::SpaceError;
use crate::diagnostic::{Code, Diagnose, Label};
use crate::source::{Span, nearest};

/// What is wrong with a blueprint beyond its form.
#[derive(Clone, Debug, thiserror::Error)]
pub enum BlueprintError {
    /// Two keys, of which a blueprint has one.
    #[error("a blueprint has either `{0}` or `{1}`")]
    Either(&'static str, &'static str, Span),
    /// An unknown word.
    #[error("`{key}` cannot be `{found}`")]
    Word {
        /// The key of the blueprint, as it is written.
        key: &'static str,
        /// The word.
        found: String,
        /// What it can be.
        known: &'static [&'static str],
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A working space that cannot be read.
    #[error("{0}")]
    Space(SpaceError, Span),
    /// `columns` without a class list.
    #[error("`columns` names headings of a class list, and there is no class list")]
    Columns(Span),
    /// A blueprint from which no sheet can be made: it has no `[[question]]`.
    #[error("the blueprint has no question")]
    NoQuestion,
    /// More of something than a sheet can have.
    #[error("there are {found} {of}, at most {most} are read")]
    TooMany {
        /// What there are many of.
        of: &'static str,
        /// The number that is asked for.
        found: usize,
        /// The largest number that is accepted.
        most: usize,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A public number and a file that keys the seeds.
    #[error("a blueprint has either `seed` or `secret`")]
    SeedAndSecret(Span),
    /// Sheets beside a class list that is not there.
    #[error("`spares` needs `students`")]
    SparesWithoutList(Span),
    /// No output format.
    #[error("`formats` is empty, so that no sheet would be written")]
    NoFormat(Span),
    /// `[print]` without a format that is printed.
    #[error("`[print]` makes files for the printer, and these formats have none")]
    NothingToPrint(Span),
    /// An `id` of `[page]` that is not a name.
    #[error("the `id` of a page has 1 to 64 letters, digits, dots and hyphens")]
    PageId(Span),
    /// A question without anything to ask.
    #[error("a question has one of `item`, `pick` and `statement`")]
    Nothing(Span),
    /// A question of one's own that also names an item.
    #[error("a question of your own has no `{0}`")]
    OwnAndItem(&'static str, Span),
    /// An `id` of a question of one's own that is not a name.
    #[error("the `id` of a question has 1 to 80 small letters, digits and hyphens")]
    OwnId(Span),
    /// Two questions of one's own with one name.
    #[error("another question of your own has the name `{0}`")]
    OwnTwice(String, Span),
    /// Something else between the lines of a question.
    #[error("this stands between the lines of a question of your own")]
    OwnApart(Span),
    /// A question of one's own in braces.
    #[error("a question of your own has a header `[[question]]`")]
    OwnInline(Span),
    /// An output format that is listed twice.
    #[error("the format `{0}` is listed twice")]
    FormatTwice(String, Span),
}

impl Diagnose for BlueprintError {
    fn code(&self) -> Code {
        Code::BLUEPRINT
    }

    fn labels(&self) -> Vec<Label> {
        match self {
            Self::Either(_, _, span)
            | Self::Columns(span)
            | Self::Space(_, span)
            | Self::Word { span, .. }
            | Self::TooMany { span, .. }
            | Self::SeedAndSecret(span)
            | Self::SparesWithoutList(span)
            | Self::NoFormat(span)
            | Self::NothingToPrint(span)
            | Self::PageId(span)
            | Self::Nothing(span)
            | Self::OwnAndItem(_, span)
            | Self::OwnId(span)
            | Self::OwnTwice(_, span)
            | Self::OwnApart(span)
            | Self::OwnInline(span)
            | Self::FormatTwice(_, span) => vec![Label {
                span: *span,
                text: String::new(),
            }],
            Self::NoQuestion => Vec::new(),
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Either(a, b, _) => format!("write one of `{a}` and `{b}`"),
            Self::Word { known, found, .. } => {
                let near = nearest(found, known.iter().copied());
                let near = near.map_or_else(String::new, |near| format!("did you mean `{near}`? "));
                format!("{near}it can be {}", known.join(", "))
            }
            Self::Space(..) => SpaceError::HELP.to_owned(),
            Self::Columns(_) => "name the list with `students`, or remove `columns`".to_owned(),
            Self::NoQuestion => "add a `[[question]]` with an `item`".to_owned(),
            Self::TooMany { of, .. } => format!("write fewer {of}"),
            Self::SeedAndSecret(_) => {
                "for an exam keep `secret` and remove `seed`; `vibank new secret FILE` makes a secret"
                    .to_owned()
            }
            Self::SparesWithoutList(_) => "raise `variants` instead".to_owned(),
            Self::NoFormat(_) => {
                let known = FORMATS.join(", ");
                format!("list at least one of {known}, or remove the key for html")
            }
            Self::NothingToPrint(_) => {
                "add `pdf` or `html` to `formats`, or remove `[print]`".to_owned()
            }
            Self::PageId(_) => "write a name such as `dynamics-week-3`, and keep it".to_owned(),
            Self::Nothing(_) => {
                "name an `item`, `pick` among items, or write `statement` and `[[question.part]]` of your own"
                    .to_owned()
            }
            Self::OwnAndItem(key, _) => {
                format!("remove `{key}`, or `statement` and `[[question.part]]`")
            }
            Self::OwnId(_) => "write a name such as `bungee-jump`, and keep it".to_owned(),
            Self::OwnTwice(..) => "give one of them another `id`".to_owned(),
            Self::OwnApart(_) => "move it above the first `[[question]]`".to_owned(),
            Self::OwnInline(_) => "write `[[question]]` above its keys, without braces".to_owned(),
            Self::FormatTwice(..) => "list each format once".to_owned(),
        })
    }
}
