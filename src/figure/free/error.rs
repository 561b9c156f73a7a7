//! What can be wrong with a free-body diagram.

use crate::diagnostic::{Code, Diagnose, Label};
use crate::source::Span;

/// A free-body diagram that does not show the forces of the model.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{fault}")]
pub struct FreeError {
    /// What is wrong.
    pub fault: FreeFault,
    /// The body.
    pub span: Span,
}

/// What is wrong with a free-body diagram.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FreeFault {
    /// A body that the model does not have.
    #[error("the model has no body `{name}`")]
    Unknown {
        /// As written.
        name: String,
        /// The bodies of the model.
        known: Vec<String>,
    },
    /// A body of the model without a diagram.
    #[error("the body `{name}` of the model is in no free-body diagram")]
    Missing {
        /// The body.
        name: String,
    },
    /// An identity that no element has.
    #[error("no element of the figure has the id `{id}`")]
    Identity {
        /// As written.
        id: String,
        /// What comes nearest.
        nearest: Option<String>,
    },
    /// An identity that two elements have.
    #[error("two elements of the figure have the id `{id}`")]
    Twice {
        /// The identity.
        id: String,
    },
    /// A force of the model without an arrow.
    #[error("the force `{force}` on `{body}` has no arrow")]
    NoArrow {
        /// The body, as the model names it.
        body: String,
        /// The force, as the model names it.
        force: String,
    },
    /// An arrow, link or arm of a force that the model does not have.
    #[error("the model has no force `{force}` on `{body}`")]
    NoForce {
        /// The body, as the model names it.
        body: String,
        /// As written.
        force: String,
    },
    /// A link at the body that is the source of no force.
    #[error("{link} is fastened to `{body}` and is not a force of the model")]
    Uncut {
        /// The body, as the model names it.
        body: String,
        /// The link, as a phrase.
        link: String,
    },
    /// A link that does not touch the body.
    #[error("{link} does not touch `{body}`")]
    Apart {
        /// The body, as the model names it.
        body: String,
        /// The link, as a phrase.
        link: String,
    },
    /// A component that is not a multiple of the arm.
    #[error("the moment of `{force}` on `{body}` is not a force times `{arm}`")]
    Arm {
        /// The body, as the model names it.
        body: String,
        /// The force, as the model names it.
        force: String,
        /// The arm that is stated, as it is written.
        arm: String,
    },
    /// A motion whose positive direction is not known.
    #[error("the positive direction of `{name}` is not known")]
    Direction {
        /// The displacement or angle.
        name: String,
        /// Whether it is an angle.
        is_turn: bool,
    },
    /// An arrow that does not do the work of the force.
    #[error("the arrow of `{force}` on `{body}` does not do the work of the force in the model")]
    Work {
        /// The body, as the model names it.
        body: String,
        /// The force, as the model names it.
        force: String,
    },
    /// An arrow that does work and is none of the model's.
    #[error("the {arrow} on `{body}` does work and is not a force of the model")]
    Idle {
        /// The body, as the model names it.
        body: String,
        /// Force or moment, as a word.
        arrow: &'static str,
    },
    /// A cord that pushes.
    #[error("the cord of `{force}` pushes `{body}` where its letter is positive")]
    Push {
        /// The body, as the model names it.
        body: String,
        /// The force, as the model names it.
        force: String,
    },
    /// An element without a place.
    #[error("{0}")]
    Undrawable(crate::figure::Undrawable),
}

impl Diagnose for FreeError {
    fn code(&self) -> Code {
        Code::FIGURE_FREE
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        Some(match &self.fault {
            FreeFault::Unknown { known, .. } if known.is_empty() => {
                "declare its bodies in `[model.bodies]`".to_owned()
            }
            FreeFault::Unknown { known, .. } => {
                format!("the bodies are {}; name them in `bodies`", known.join(", "))
            }
            FreeFault::Missing { name } => format!("add `[figure.free.{name}]`"),
            FreeFault::Identity { nearest, .. } => match nearest {
                Some(near) => format!("did you mean `{near}`?"),
                None => "give it one, `{ block = \"B\", id = \"block\" }`".to_owned(),
            },
            FreeFault::Twice { .. } => "an id names one element".to_owned(),
            FreeFault::NoArrow { force, .. } => format!(
                "give the link the id `{force}`, name it in `links = {{ {force} = \"…\" }}`, or write the force in `arrows`"
            ),
            FreeFault::NoForce { .. } => {
                "forces bear the names that they have in `[model.bodies]`".to_owned()
            }
            FreeFault::Uncut { .. } => {
                "give it the id of its force, or keep it with the body in `keep`".to_owned()
            }
            FreeFault::Apart { .. } => {
                "a link has an end at an element of the body; a cord may pass over it".to_owned()
            }
            FreeFault::Arm { force, .. } => {
                format!("say what the force is multiplied by, `arms = {{ {force} = \"r\" }}`")
            }
            FreeFault::Direction { is_turn: false, .. } => {
                "show it in the figure by a `coordinate`, or write `along = [1, 0]`".to_owned()
            }
            FreeFault::Direction { .. } => {
                "show it in the figure by a `turn`, or write `turn = \"ccw\"`".to_owned()
            }
            FreeFault::Work { .. } => {
                "compare the sign in the model, the positive directions, and where the arrow acts".to_owned()
            }
            FreeFault::Idle { .. } => {
                "say which force of the model it is by `force = \"…\"`, or let it act where it does no work".to_owned()
            }
            FreeFault::Push { .. } => {
                "choose the sign of what the force is proportional to, so that a stretch is positive".to_owned()
            }
            FreeFault::Undrawable(_) => return None,
        })
    }
}
