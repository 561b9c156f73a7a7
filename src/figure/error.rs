//! What can be wrong with a figure.

use crate::diagnostic::{Code, Diagnose, Label};
use crate::source::{Span, nearest};

use super::element::KINDS;

/// Something in a figure that cannot be drawn.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// A table that begins with no kind of element.
    #[error("`{found}` is not an element of a figure")]
    Kind {
        /// The key.
        found: String,
        /// The key.
        span: Span,
    },
    /// An element without a key.
    #[error("an element of a figure begins with its kind")]
    Empty {
        /// The table.
        span: Span,
    },
    /// A place of the wrong number of points.
    #[error("`{kind}` is placed by {expected}, found {found}")]
    Place {
        /// The kind of element, as the figure writes it.
        kind: &'static str,
        /// What is due.
        expected: &'static str,
        /// What stands there.
        found: String,
        /// The place.
        span: Span,
    },
    /// A formula whose value is not a number or a point.
    #[error("this is {found}, expected {}", if *is_point { "a point, `[x, y]` in units of 10 mm" } else { "a pure number" })]
    Form {
        /// What stands there instead.
        found: String,
        /// Whether a point is due.
        is_point: bool,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A side or pass of a point that has none.
    #[error("`{found}` is not a point of this figure")]
    Point {
        /// The text.
        found: String,
        /// The point that is nearest.
        nearest: Option<String>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A side of a point at which no body is placed.
    #[error("no body is placed at `{found}`, so it has no sides")]
    NoBody {
        /// The point.
        found: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A cord that is led over something that is round nowhere.
    #[error("no pulley or disk is placed at `{found}`")]
    NoPulley {
        /// The point.
        found: String,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A motion of an item without a model.
    #[error("a figure moves by the coordinates of a model, and this item has none")]
    NoModel {
        /// The table.
        span: Span,
    },
    /// A displacement in which nothing moves.
    #[error("{found} does not move: no coordinate of the model is in it")]
    Still {
        /// The formula.
        found: String,
        /// The coordinates.
        known: Vec<String>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A displacement of the wrong dimension.
    #[error("this is {found}, expected {}", if *is_turn { "an angle" } else { "a length" })]
    Displacement {
        /// Its dimension.
        found: String,
        /// Whether an angle is due.
        is_turn: bool,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A word that a key does not take.
    #[error("`{key}` cannot be `{found}`")]
    Word {
        /// The key of the element, as it is written.
        key: &'static str,
        /// The word.
        found: String,
        /// The words that it takes.
        known: Vec<&'static str>,
        /// The bytes of the text that the message points at.
        span: Span,
    },
}

impl Diagnose for FigureError {
    fn code(&self) -> Code {
        match self {
            Self::Kind { .. } | Self::Empty { .. } => Code::FIGURE_ELEMENT,
            Self::Word { .. } => Code::FIGURE_WORD,
            Self::NoModel { .. } | Self::Still { .. } | Self::Displacement { .. } => {
                Code::FIGURE_MOTION
            }
            _ => Code::FIGURE_PLACE,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let span = match self {
            Self::Kind { span, .. }
            | Self::Empty { span }
            | Self::Place { span, .. }
            | Self::Form { span, .. }
            | Self::Point { span, .. }
            | Self::NoBody { span, .. }
            | Self::NoPulley { span, .. }
            | Self::NoModel { span }
            | Self::Still { span, .. }
            | Self::Displacement { span, .. }
            | Self::Word { span, .. } => *span,
        };
        vec![Label {
            span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::Kind { found, .. } => {
                let kinds = || KINDS.iter().map(|kind| kind.name());
                Some(match nearest(found, kinds()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!(
                        "the elements are {}",
                        kinds().collect::<Vec<_>>().join(", ")
                    ),
                })
            }
            Self::Empty { .. } => Some("write for example `{ block = \"B\" }`".to_owned()),
            Self::Place { .. } | Self::Form { .. } => None,
            Self::Point { nearest, .. } => Some(match nearest {
                Some(near) => format!("did you mean `{near}`?"),
                None => "points are declared in `points` of the figure".to_owned(),
            }),
            Self::NoModel { .. } => Some("declare `[model]`, or drop `[figure.motion]`".to_owned()),
            Self::Still { known, .. } => Some(format!("write it with {}", known.join(", "))),
            Self::Displacement { is_turn: true, .. } => {
                Some("divide the length by a radius".to_owned())
            }
            Self::Displacement { is_turn: false, .. } => Some(
                "multiply the angle by a length, or turn the body, `{ turn = \"theta\" }`"
                    .to_owned(),
            ),
            Self::NoBody { found, .. } => {
                Some(format!("place a body there, `{{ block = \"{found}\" }}`"))
            }
            Self::NoPulley { found, .. } => {
                Some(format!("place one there, `{{ pulley = \"{found}\" }}`"))
            }
            Self::Word { found, known, .. } => Some(match nearest(found, known.iter().copied()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("it is one of {}", known.join(", ")),
            }),
        }
    }
}
