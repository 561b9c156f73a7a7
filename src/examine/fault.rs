//! What an examination finds.

use crate::bank::Template;
use crate::diagnostic::{Code, Diagnose, Finding, Label, Severity};
use crate::source::Span;

/// What is wrong with an item as a question.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum QuestionFault {
    #[error("mistake {number} of part `{part}` is right: `{typed}`, seed {seed}")]
    MistakeRight {
        part: String,
        number: usize,
        typed: String,
        seed: u64,
    },
    #[error("mistake {number} of part `{part}` never meets its feedback{}", .why.as_ref().map(|why| format!(": {why}")).unwrap_or_default())]
    MistakeUnmet {
        part: String,
        number: usize,
        why: Option<String>,
    },
    #[error(
        "mistakes {first} and {second} of part `{part}` give the same answer in {percent:.0} % of the draws"
    )]
    MistakesAlike {
        part: String,
        first: usize,
        second: usize,
        percent: f64,
    },
    #[error("a wrong method is right in part `{part}`: {method} gives `{typed}`, seed {seed}")]
    MethodRight {
        item: String,
        part: String,
        method: String,
        typed: String,
        seed: u64,
    },
    #[error("{count} wrong methods and mistakes lead to part `{part}`, fewer than {least}")]
    FewMethods {
        part: String,
        count: usize,
        least: usize,
    },
    #[error(
        "honest work on part `{part}` is {verdict} in {wrong} of {draws} draws: `{typed}`, seed {seed}"
    )]
    HonestWork {
        item: String,
        part: String,
        verdict: &'static str,
        wrong: u64,
        draws: u64,
        typed: String,
        seed: u64,
    },
    #[error(
        "{percent:.0} % of the draws are made again for `{constraint}`, which costs most; {left:.2} % pass"
    )]
    Redrawn {
        constraint: String,
        percent: f64,
        left: f64,
    },
    #[error(
        "{percent:.0} % of the draws are not fit to hand out; what costs most: {reason} ({count} of {draws})"
    )]
    Unfit {
        percent: f64,
        reason: String,
        count: u64,
        draws: u64,
        bound: Option<f64>,
    },
    #[error("the answer to part `{part}` is printed in {place}")]
    Disclosed { part: String, place: String },
    #[error("{what} between variants")]
    VariantsDiffer { what: String },
    #[error("the item has {count} questions, more than {most}")]
    ManyQuestions { count: usize, most: usize },
    #[error(
        "component {component} of the shape asked in part `{part}` is {percent:.1} % of the largest, seed {seed}"
    )]
    SmallComponent {
        part: String,
        component: usize,
        percent: f64,
        seed: u64,
    },
    #[error(
        "parts `{first}` and `{second}` have the same answer to {figures} figures in {percent:.0} % of the draws"
    )]
    AnswersCoincide {
        first: String,
        second: String,
        figures: u32,
        percent: f64,
    },
    #[error("the answer to part `{part}` is `{answer}` in all draws")]
    SameChoice { part: String, answer: String },
    #[error("the right option of part `{part}` is {how}")]
    OptionForm { part: String, how: &'static str },
    #[error("no part uses `{datum}`")]
    UnusedDatum { datum: String },
    #[error("part `{part}` asks for a number without a second route")]
    NoSecondRoute { part: String },
    #[error("part `{part}` has no hint")]
    NoHint { part: String },
    #[error("part `{part}` has no worked solution")]
    NoSolution { part: String },
    #[error("the item has a model, and its figure stands still")]
    StillFigure,
    #[error("the item keeps the rule `{rule}`, from which it is excepted")]
    NeedlessException { rule: String, place: Span },
    #[error(
        "{draws} draws of this item take more than {limit} million steps; the other draws were not examined"
    )]
    Work { draws: u64, limit: u64 },
}

impl QuestionFault {
    /// The part that it is about.
    pub(crate) fn part(&self) -> Option<&str> {
        match self {
            Self::MistakeRight { part, .. }
            | Self::MistakeUnmet { part, .. }
            | Self::MistakesAlike { part, .. }
            | Self::MethodRight { part, .. }
            | Self::FewMethods { part, .. }
            | Self::HonestWork { part, .. }
            | Self::Disclosed { part, .. }
            | Self::SmallComponent { part, .. }
            | Self::SameChoice { part, .. }
            | Self::OptionForm { part, .. }
            | Self::NoSecondRoute { part }
            | Self::NoHint { part }
            | Self::NoSolution { part }
            | Self::AnswersCoincide { first: part, .. } => Some(part),
            Self::Redrawn { .. }
            | Self::Unfit { .. }
            | Self::VariantsDiffer { .. }
            | Self::ManyQuestions { .. }
            | Self::UnusedDatum { .. }
            | Self::StillFigure
            | Self::NeedlessException { .. }
            | Self::Work { .. } => None,
        }
    }

    /// The finding, at the part or the line of the file that it is about.
    pub(crate) fn finding(&self, template: &Template) -> Finding {
        let place = match self {
            Self::Redrawn { constraint, .. } => definition(&template.source.text, constraint),
            Self::UnusedDatum { datum } => definition(&template.source.text, datum),
            Self::StillFigure => line(&template.source.text, |line| line.starts_with("[figure]")),
            Self::NeedlessException { place, .. } => *place,
            _ => self
                .part()
                .map_or(Span::NONE, |part| part_place(&template.source.text, part)),
        };
        let mut finding = Finding::of(self, &template.source);
        for label in &mut finding.labels {
            label.span = place;
        }
        finding
    }
}

/// The line that begins with a name and an equals sign.
fn definition(text: &str, name: &str) -> Span {
    line(text, |line| {
        line.strip_prefix(name)
            .is_some_and(|rest| rest.trim_start().starts_with('='))
    })
}

/// The line of a part that gives its identity: its `id`, or the `key` that stands for it; of a blank after that of its
/// group.
fn part_place(text: &str, part: &str) -> Span {
    let (group, id) = part.split_once('.').unwrap_or(("", part));
    let before = match part_line(text, group) {
        place if group.is_empty() || place == Span::NONE => 0,
        place => place.end as usize,
    };
    match part_line(&text[before..], id) {
        Span::NONE => Span::NONE,
        place => Span::new(before + place.start as usize, before + place.end as usize),
    }
}

fn part_line(text: &str, part: &str) -> Span {
    let gives = |key: &str, line: &str| {
        let value = line
            .strip_prefix(key)
            .and_then(|rest| rest.trim_start().strip_prefix('='));
        value.is_some_and(|value| {
            let value = value.split('#').next().unwrap_or_default();
            value.trim().trim_matches(['"', '\'']) == part
        })
    };
    let by_id = line(text, |line| gives("id", line));
    if by_id.is_none() {
        line(text, |line| gives("key", line))
    } else {
        by_id
    }
}

fn line(text: &str, is_it: impl Fn(&str) -> bool) -> Span {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if is_it(line.trim_start()) {
            return Span::new(start, start + line.trim_end().len());
        }
        start += line.len();
    }
    Span::NONE
}

impl Diagnose for QuestionFault {
    fn code(&self) -> Code {
        match self {
            Self::MistakeRight { .. } => Code::CHECK_MISTAKE_RIGHT,
            Self::MistakeUnmet { .. } => Code::CHECK_MISTAKE_UNMET,
            Self::MistakesAlike { .. } => Code::CHECK_MISTAKES_ALIKE,
            Self::MethodRight { .. } => Code::CHECK_METHOD_RIGHT,
            Self::FewMethods { .. } => Code::CHECK_FEW_METHODS,
            Self::HonestWork { .. } => Code::CHECK_HONEST_WORK,
            Self::Redrawn { .. } | Self::Unfit { .. } => Code::CHECK_REFUSED,
            Self::Disclosed { .. } => Code::CHECK_DISCLOSED,
            Self::VariantsDiffer { .. } => Code::CHECK_VARIANTS_DIFFER,
            Self::ManyQuestions { .. } => Code::CHECK_MANY_QUESTIONS,
            Self::SmallComponent { .. } => Code::CHECK_SMALL_COMPONENT,
            Self::AnswersCoincide { .. } => Code::CHECK_ANSWERS_COINCIDE,
            Self::SameChoice { .. } => Code::CHECK_SAME_CHOICE,
            Self::OptionForm { .. } => Code::CHECK_OPTION_FORM,
            Self::UnusedDatum { .. } => Code::CHECK_UNUSED_DATUM,
            Self::NoSecondRoute { .. } => Code::CHECK_NO_SECOND_ROUTE,
            Self::NoHint { .. } => Code::CHECK_NO_HINT,
            Self::NoSolution { .. } => Code::CHECK_NO_SOLUTION,
            Self::StillFigure => Code::CHECK_STILL_FIGURE,
            Self::NeedlessException { .. } => Code::CHECK_NEEDLESS_EXCEPTION,
            Self::Work { .. } => Code::SIZE,
        }
    }

    fn severity(&self) -> Severity {
        match self {
            Self::NoSecondRoute { .. }
            | Self::NoHint { .. }
            | Self::NoSolution { .. }
            | Self::StillFigure
            | Self::NeedlessException { .. } => Severity::Warning,
            // It costs time and makes variants alike, and sheets are made all the same.
            Self::Redrawn { left, .. } if *left >= 1.0 => Severity::Warning,
            _ => Severity::Error,
        }
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: Span::NONE,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::MistakeRight { .. } => {
                "narrow a stated tolerance or drop it, or mend the mistake"
            }
            Self::MistakeUnmet { .. } => {
                "put it before what hides it, mend its formula or its `when`, or drop it"
            }
            Self::MistakesAlike { .. } => {
                "join them into one, or constrain the data so that they differ"
            }
            Self::MethodRight {
                item,
                seed,
                part,
                typed,
                ..
            } => {
                return Some(format!(
                    "narrow a stated tolerance or drop it; `vibank mark {item} --seed {seed} {part} '{typed}'` shows the marking"
                ));
            }
            Self::FewMethods { .. } => "name the mistakes that are made in it",
            Self::HonestWork { .. } => {
                "widen the stated tolerance or drop it, or ask for more figures with `ask_digits`"
            }
            Self::Redrawn { .. } => "choose ranges in which the constraint seldom fails",
            Self::Unfit {
                bound: Some(bound), ..
            } => {
                return Some(format!(
                    "in these draws the right answer shows from a damping ratio of {bound:.2} on: constrain it to more"
                ));
            }
            Self::Unfit { .. } => {
                "choose ranges in which the wrong way gives another answer, or ask for more figures with `ask_digits`"
            }
            Self::Disclosed { .. } => "ask in letters, or drop the number",
            Self::VariantsDiffer { .. } => "narrow the ranges, or ask what exists for all data",
            Self::ManyQuestions { .. } => {
                "group small ones as `[[part.blank]]` tables of one part, or make two items"
            }
            Self::SmallComponent { .. } => "keep such data away by a constraint",
            Self::AnswersCoincide { .. } => "choose ranges in which they differ",
            Self::SameChoice { .. } => "widen the ranges so that another option can be right",
            Self::OptionForm { .. } => "write all options in one form",
            Self::UnusedDatum { .. } => "drop it, or ask for what it decides",
            Self::NoSecondRoute { .. } => {
                "give the quantity `verify`, an independent formula for it"
            }
            Self::NoHint { .. } => "give `hints`: first the principle, then the first step",
            Self::NoSolution { .. } => "give `solution`",
            Self::StillFigure => {
                "move it by `[figure.motion]`, or except it from `still-figure` by `[[allow]]`, with the reason"
            }
            Self::NeedlessException { .. } => "drop this `[[allow]]`",
            Self::Work { .. } => {
                "write integrals and roots in closed form, or keep them out of each other and away from singular ends"
            }
        };
        Some(help.to_owned())
    }
}
