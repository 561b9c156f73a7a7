//! What can be wrong with the meaning of an item file.

use crate::diagnostic::{Code, Diagnose, Label};
use crate::source::{Span, nearest};
use crate::unit;

/// Something in an item file that has no meaning, or not the one that is due.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ItemError {
    /// A unit that cannot be read.
    #[error("{0}")]
    Unit(unit::Error),
    /// A declared unit of another dimension than the formula has.
    #[error("`{name}` is declared in {declared}, but its formula is in {found}")]
    DeclaredUnit {
        /// The quantity.
        name: String,
        /// The declared unit.
        declared: String,
        /// The dimension found.
        found: String,
    },
    /// A second route to something else than the quantity is.
    #[error("`{name}` is {expected}, but its second route is {found}")]
    Route {
        /// The quantity.
        name: String,
        /// Form and dimension of the quantity.
        expected: String,
        /// What the route leads to.
        found: String,
    },
    /// Units for another number of entries than the formula has.
    #[error("`{name}` has {found} units for {expected} entries")]
    UnitCount {
        /// The quantity.
        name: String,
        /// How many units.
        found: usize,
        /// How many entries.
        expected: usize,
    },
    /// A word that cannot be a name.
    #[error("`{found}` cannot be a name{}", if *is_reserved { ": the formula language uses it" } else { "" })]
    Name {
        /// The word.
        found: String,
        /// Whether the formula language has it.
        is_reserved: bool,
    },
    /// A key that names no equation.
    #[error("`{found}` is not an equation")]
    NoEquation {
        /// The key.
        found: String,
    },
    /// A name that is taken.
    #[error("`{found}` is already the name of something else in this item")]
    Taken {
        /// The name.
        found: String,
    },
    /// A formula where a condition is due.
    #[error("this is a number, expected a condition")]
    NoCondition,
    /// A placeholder for something that is not there.
    #[error("there is no `{found}` in this item")]
    Placeholder {
        /// The name.
        found: String,
        /// The known name that is nearest.
        nearest: Option<String>,
        /// Where it stands.
        span: Span,
    },
    /// A form that the thing does not have.
    #[error("`{found}` has no {form}")]
    Form {
        /// The name.
        found: String,
        /// The form that the placeholder asks for.
        form: &'static str,
        /// Where it stands.
        span: Span,
    },
    /// A topic that is not in the vocabulary.
    #[error("`{found}` is not a topic of this bank")]
    Topic {
        /// The word.
        found: String,
        /// The vocabulary.
        known: Vec<String>,
    },
    /// A guard that cannot be lifted.
    #[error("`{found}` is nothing that can be allowed")]
    Allow {
        /// The word.
        found: String,
    },
    /// A rule of `check` that does not exist.
    #[error("`{found}` is not a rule from which an item can be excepted")]
    Rule {
        /// The word.
        found: String,
    },
    /// An exception without a reason.
    #[error("this exception has no reason")]
    Reason,
    /// A kind of answer that does not exist.
    #[error("`{found}` is not a kind of answer")]
    Kind {
        /// The word.
        found: String,
    },
    /// A part without identity.
    #[error("this part needs an `id`: its key is not a name")]
    PartId,
    /// Two parts of one identity.
    #[error("there are two parts `{found}`")]
    PartTwice {
        /// The identity.
        found: String,
    },
    /// A group with fewer than two blanks.
    #[error("a group has at least two blanks")]
    SmallGroup,
    /// A share of the points outside [0, 1].
    #[error("a credit lies from 0 to 1")]
    Credit,
    /// Points that are zero, negative or not a number.
    #[error("`points` has to be a positive number")]
    Points,
    /// A working space that cannot be read.
    #[cfg(feature = "render")]
    #[error("{0}")]
    Space(crate::bank::SpaceError),
    /// A mistake that says neither what it gives nor what it replaces.
    #[error("a mistake has either `answer` or `with`")]
    Mistake,
    /// A check of something that is not there.
    #[error("`{found}` is not a quantity or part of this item")]
    Expected {
        /// The name.
        found: String,
        /// The known name that is nearest.
        nearest: Option<String>,
    },
    /// A kind of plot that does not exist.
    #[error("`{found}` is not a kind of plot")]
    PlotKind {
        /// The word.
        found: String,
    },
    /// A style of curves that does not exist.
    #[error("`{found}` is not a style of a curve")]
    PlotStyle {
        /// The word.
        found: String,
    },
    /// Something that is not two formulas.
    #[error("two formulas are due here")]
    PlotPair,
    /// A formula that has no number to draw.
    #[error("a plot draws real numbers, which this formula does not give")]
    PlotValue,
    /// A band without two edges.
    #[error("a band has two edges")]
    PlotBand,
    /// A phasor that is not a number.
    #[error("a phasor is one number, real or complex")]
    Phasor,
    /// A function of something else than the variable.
    #[error("this is a function of `{of}`, which is not the variable")]
    PlotVariable {
        /// What the formula is a function of.
        of: String,
    },
    /// A unit that its formula does not have.
    #[error("the axis is in {unit}, but this is in {found}")]
    PlotUnit {
        /// The unit of the axis.
        unit: String,
        /// The dimension found.
        found: String,
    },
    /// Too many curves, or none.
    #[error("a plot has from 1 to {most} curves, and this one {found}")]
    CurveCount {
        /// The number that the file has.
        found: usize,
        /// The largest number that is accepted.
        most: usize,
    },
    /// Mode shapes of a model that is not there.
    #[error("there is no `{found}` in this item")]
    PlotModel {
        /// Its name.
        found: String,
    },
    /// A parameter that is not there.
    #[error("`{found}` is not a parameter of this item")]
    Parameter {
        /// The name.
        found: String,
        /// The known name that is nearest.
        nearest: Option<String>,
    },
}

impl Diagnose for ItemError {
    fn code(&self) -> Code {
        match self {
            Self::Unit(_) => Code::QUANTITY,
            Self::DeclaredUnit { .. } | Self::UnitCount { .. } | Self::Route { .. } => {
                Code::DIMENSION
            }
            Self::Name { .. } => Code::NAME,
            Self::NoEquation { .. } => Code::KEY,
            Self::Taken { .. } => Code::NAME_TAKEN,
            Self::NoCondition => Code::CONDITION,
            Self::Placeholder { .. } | Self::Form { .. } => Code::UNKNOWN_PLACEHOLDER,
            Self::Topic { .. } => Code::TOPIC,
            Self::Allow { .. } | Self::Rule { .. } | Self::Reason => Code::ALLOW,
            Self::Kind { .. } => Code::ANSWER_KIND,
            Self::PartId | Self::PartTwice { .. } | Self::SmallGroup | Self::Points => Code::PART,
            #[cfg(feature = "render")]
            Self::Space(_) => Code::PART,
            Self::Credit | Self::Mistake => Code::MISTAKE,
            Self::Expected { .. } | Self::Parameter { .. } => Code::CHECK,
            Self::PlotKind { .. }
            | Self::PlotStyle { .. }
            | Self::PlotPair
            | Self::PlotValue
            | Self::PlotBand
            | Self::Phasor
            | Self::PlotVariable { .. }
            | Self::PlotUnit { .. }
            | Self::CurveCount { .. }
            | Self::PlotModel { .. } => Code::PLOT,
        }
    }

    fn labels(&self) -> Vec<Label> {
        let span = match self {
            Self::Unit(error) => error.span.clone().into(),
            Self::Placeholder { span, .. } | Self::Form { span, .. } => *span,
            _ => Span::NONE,
        };
        vec![Label {
            span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        let mean =
            |near: &Option<String>| near.as_ref().map(|near| format!("did you mean `{near}`?"));
        match self {
            Self::Unit(error) => error.help(),
            Self::Placeholder { nearest, .. }
            | Self::Expected { nearest, .. }
            | Self::Parameter { nearest, .. } => mean(nearest),
            Self::Topic { found, known } => {
                let near = nearest(found, known.iter().map(String::as_str)).map(str::to_owned);
                mean(&near).or_else(|| {
                    Some("add it to `[topics]` in bank.toml, with a description".to_owned())
                })
            }
            Self::Allow { .. } => Some(format!(
                "it can be {}",
                crate::bank::about::LIFTABLE.join(", ")
            )),
            Self::Rule { found } => {
                let names = || crate::bank::Rule::ALL.iter().map(|rule| rule.name());
                let near = nearest(found, names()).map(str::to_owned);
                mean(&near).or_else(|| {
                    let all: Vec<&str> = names().collect();
                    Some(format!("it can be {}", all.join(", ")))
                })
            }
            Self::Reason => Some("say why the finding is in order here".to_owned()),
            Self::Kind { found } => {
                let names = || {
                    crate::answer::AnswerKind::ALL
                        .iter()
                        .map(|kind| kind.name())
                };
                let near = nearest(found, names()).map(str::to_owned);
                mean(&near).or_else(|| {
                    Some(format!(
                        "the kinds are {}",
                        names().collect::<Vec<_>>().join(", ")
                    ))
                })
            }
            Self::PlotKind { .. } => {
                Some("it can be curves, mode-shapes, phase-plane, phasors".to_owned())
            }
            Self::PlotStyle { .. } => {
                let names: Vec<_> = crate::figure::plot::CurveStyle::names().collect();
                Some(format!("it can be {}", names.join(", ")))
            }
            Self::PlotPair => Some("write `[\"0\", \"5*T\"]`".to_owned()),
            Self::Phasor => Some("write a complex amplitude, `i*c*Omega*X`".to_owned()),
            Self::PlotBand => Some("write both, `[-delta, delta]`".to_owned()),
            Self::PlotVariable { .. } => Some(
                "substitute its value, `at(x, t = 2[s])`, or choose it as the variable".to_owned(),
            ),
            Self::PlotModel { .. } => Some(
                "mode shapes are those of `[model]` or of the model named in `model`".to_owned(),
            ),
            Self::NoCondition => Some("compare two numbers, for example `zeta < 1`".to_owned()),
            Self::SmallGroup => Some("write a single blank as a part of its own".to_owned()),
            #[cfg(feature = "render")]
            Self::Space(_) => Some(crate::bank::SpaceError::HELP.to_owned()),
            Self::PartId => Some("add `id = \"…\"`".to_owned()),
            Self::NoEquation { .. } => {
                Some("write `\"a = b\"`, or name an equation of a model".to_owned())
            }
            Self::Taken { .. } => {
                Some("parameters, symbols and quantities share one list of names".to_owned())
            }
            Self::Name { .. } => Some(
                "a name begins with a letter and has letters, digits and underscores".to_owned(),
            ),
            _ => None,
        }
    }
}
