//! What in a blueprint does not fit the bank.

use crate::diagnostic::{Code, Diagnose, Label, Severity};
use crate::source::Span;

/// What in a blueprint does not fit the bank.
#[derive(Debug, thiserror::Error)]
pub(crate) enum PlanError {
    #[error("the bank has no item `{found}`")]
    Item {
        found: String,
        nearest: Option<String>,
        span: Span,
    },
    #[error("the bank has an item `{found}` too")]
    Known { found: String, span: Span },
    #[error("there is something wrong with the item `{found}`")]
    Broken { found: String, span: Span },
    #[error("`{item}` has no part `{found}`")]
    Part {
        item: String,
        found: String,
        nearest: Option<String>,
        span: Span,
    },
    #[error("`{item}` has no parameter `{found}`")]
    Parameter {
        item: String,
        found: String,
        nearest: Option<String>,
        span: Span,
    },
    #[error("`{name}`: {message}")]
    Value {
        name: String,
        message: String,
        span: Span,
    },
    #[error("no item of the bank has the {what} `{found}`")]
    Word {
        what: &'static str,
        found: String,
        nearest: Option<String>,
        span: Span,
    },
    #[error("{found} items pass this filter, {wanted} are wanted")]
    TooFew {
        found: usize,
        wanted: usize,
        span: Span,
    },
    #[error("the points of parts belong to one `item`")]
    PartPoints { span: Span },
    #[error("the space of parts belongs to one `item`")]
    PartSpace { span: Span },
    #[error("part `{found}` is not asked")]
    NotAsked { found: String, span: Span },
    #[error("`part_points` gives points to part `{found}` twice")]
    Twice { found: String, span: Span },
    #[error("{stated}")]
    Sum { stated: String, span: Span },
    #[error("the chapters of these items have no formulas")]
    NoFormulas { span: Span },
    #[error(
        "the texts of the items are in `{bank}`, headings, answer lines and feedback will be in `{found}`"
    )]
    OtherLanguage {
        found: String,
        bank: String,
        span: Span,
    },
    #[error("the texts of the bank are in `{bank}`, not in `{found}`")]
    Language {
        found: String,
        bank: String,
        span: Span,
    },
}

impl Diagnose for PlanError {
    fn code(&self) -> Code {
        Code::BLUEPRINT
    }

    fn severity(&self) -> Severity {
        match self {
            Self::OtherLanguage { .. } => Severity::Warning,
            _ => Severity::Error,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let (Self::Item { span, .. }
        | Self::Known { span, .. }
        | Self::Broken { span, .. }
        | Self::Part { span, .. }
        | Self::Parameter { span, .. }
        | Self::Value { span, .. }
        | Self::Word { span, .. }
        | Self::TooFew { span, .. }
        | Self::PartPoints { span }
        | Self::PartSpace { span }
        | Self::NotAsked { span, .. }
        | Self::Twice { span, .. }
        | Self::Sum { span, .. }
        | Self::NoFormulas { span }
        | Self::OtherLanguage { span, .. }
        | Self::Language { span, .. }) = self;
        vec![Label {
            span: *span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::Item { nearest, .. } => match nearest {
                Some(near) => Some(format!("did you mean `{near}`?")),
                None => Some("`vibank list` shows all items".to_owned()),
            },
            Self::Known { .. } => Some("give the question another `id`".to_owned()),
            Self::Broken { found, .. } => Some(format!("`vibank check {found}` shows what it is")),
            Self::Part { nearest, .. } | Self::Parameter { nearest, .. } => nearest
                .as_ref()
                .map(|near| format!("did you mean `{near}`?")),
            Self::Word { nearest, .. } => Some(match nearest {
                Some(near) => format!("did you mean `{near}`?"),
                None => "`vibank list` shows all items, chapters and topics".to_owned(),
            }),
            Self::TooFew { .. } => Some("widen the filter, or lower `count`".to_owned()),
            Self::NoFormulas { .. } => {
                Some("write them under `formulas` in `_chapter.toml`".to_owned())
            }
            Self::PartPoints { .. } => {
                Some("give `points` of the question, which are shared out by weights".to_owned())
            }
            Self::PartSpace { .. } => {
                Some("give `space` of the question, which all its parts get".to_owned())
            }
            Self::NotAsked { .. } => Some("add it to `parts`, or remove its points".to_owned()),
            Self::Twice { .. } => Some(
                "name a group of blanks or single blanks of it, and a part by one name".to_owned(),
            ),
            Self::Sum { .. } => {
                Some("leave `points` of the question out, or let the sums agree".to_owned())
            }
            Self::OtherLanguage { .. } => Some(
                "for items in this language name a translated copy of the bank with `--bank`"
                    .to_owned(),
            ),
            Self::Language { bank, .. } => Some(format!(
                "write `language = \"{bank}\"`, or remove the key; a bank in another language is given with `--bank`"
            )),
            Self::Value { .. } => None,
        }
    }
}
