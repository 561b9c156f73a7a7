//! What is wrong with a decision beyond its form.

use super::VOID;
use crate::diagnostic::{Code, Diagnose, Label};
use crate::source::Span;

/// What is wrong with a decision beyond its form.
#[derive(Clone, Debug, thiserror::Error)]
pub enum DecisionError {
    /// Nothing is decided, or several things at once.
    #[error("a decision has one of `void`, `accept`, `key`, `read` and `points`; this one has {0}")]
    Effects(String, Span),
    /// An unknown word.
    #[error("`void` cannot be `{0}`")]
    Void(String, Span),
    /// Who decided, or why, is empty.
    #[error("`{0}` is empty")]
    Empty(&'static str, Span),
    /// Nothing says which item is meant.
    #[error("neither `item` nor `question` says which question is meant")]
    NoItem(Span),
    /// A key that cannot be combined with this effect.
    #[error("`{0}` cannot be combined with `{1}`")]
    Beside(&'static str, &'static str, Span),
    /// A sheet that was not handed out.
    #[error("no sheet {found} was handed out")]
    Sheet {
        /// The code.
        found: String,
        /// The nearest that was.
        near: Option<String>,
        /// Where the file says it.
        span: Span,
    },
    /// An item that was not handed out.
    #[error("no item `{found}` was handed out")]
    Item {
        /// The id of the item that the decision names.
        found: String,
        /// The nearest that was.
        near: Option<String>,
        /// Where the file says it.
        span: Span,
    },
    /// A question that is not on the sheets.
    #[error("no sheet has a question {0}")]
    Question(usize, Span),
    /// A question that is another item on other sheets.
    #[error("question {number} is not the same on all sheets: {items}")]
    Questions {
        /// Its number as it was written, from 1.
        number: usize,
        /// The items that it is.
        items: String,
        /// Where the file says it.
        span: Span,
    },
    /// A part that was not handed out.
    #[error("no part `{found}` of `{item}` was handed out")]
    Part {
        /// The id of the item that the decision names.
        item: String,
        /// The part.
        found: String,
        /// The nearest that was, or all of them.
        help: String,
        /// Where the file says it.
        span: Span,
    },
    /// A letter that is another part on other sheets.
    #[error("part {letter} of `{item}` is not the same on all sheets: {parts}")]
    Letters {
        /// The id of the item that the decision names.
        item: String,
        /// The letter that the decision names.
        letter: String,
        /// The parts that it is.
        parts: String,
        /// Where the file says it.
        span: Span,
    },
    /// The same was decided twice.
    #[error("this was already decided in line {0}")]
    Twice(usize, Span),
    /// Nothing is left that could take over the points.
    #[error(
        "no other part of `{item}` is asked with this one, so that nothing can take over its points"
    )]
    NothingLeft {
        /// The id of the item that the decision names.
        item: String,
        /// Where the file says it.
        span: Span,
    },
}

impl Diagnose for DecisionError {
    fn code(&self) -> Code {
        Code::MARKS
    }

    fn labels(&self) -> Vec<Label> {
        let (Self::Effects(_, span)
        | Self::Void(_, span)
        | Self::Empty(_, span)
        | Self::NoItem(span)
        | Self::Beside(_, _, span)
        | Self::Sheet { span, .. }
        | Self::Item { span, .. }
        | Self::Question(_, span)
        | Self::Questions { span, .. }
        | Self::Part { span, .. }
        | Self::Letters { span, .. }
        | Self::Twice(_, span)
        | Self::NothingLeft { span, .. }) = self;
        vec![Label {
            span: *span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        let near =
            |near: &Option<String>| near.as_ref().map(|near| format!("did you mean `{near}`?"));
        match self {
            Self::Effects(..) => Some("write a decision of its own for each".to_owned()),
            Self::Void(..) => Some(format!(
                "it can be {}",
                VOID.map(|(word, _)| word).join(", ")
            )),
            Self::Empty(key, _) => Some(format!("say it: `{key}` stands in the report")),
            Self::NoItem(_) => {
                Some("write `item`, or `question` where it is the same on all sheets".to_owned())
            }
            Self::Beside(key, ..) => Some(format!("remove `{key}`")),
            Self::Sheet { near: found, .. } => near(found)
                .or_else(|| Some("write the code that is printed on the sheet".to_owned())),
            Self::Item { near: found, .. } => {
                near(found).or_else(|| Some("`details.csv` has the items of all parts".to_owned()))
            }
            Self::Question(..) => Some("count the questions as they are printed".to_owned()),
            Self::Questions { .. } => Some("write `item` in place of `question`".to_owned()),
            Self::Part { help, .. } => Some(help.clone()),
            Self::Letters { .. } => Some("write the id of the part".to_owned()),
            Self::Twice(..) => Some("remove one of the two".to_owned()),
            Self::NothingLeft { .. } => Some(
                "`void = \"full marks\"` gives them to everybody, `void = \"left out\"` to nobody"
                    .to_owned(),
            ),
        }
    }
}
