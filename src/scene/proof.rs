//! What an item shows and cannot be shown: plots that cannot be drawn, derivations that cannot be made or do not hold.

use super::steps::unworkable;
use super::{Data, Scene, Undrawn};
use crate::bank::{Target, Template};
use crate::diagnostic::{Code, Diagnose, Finding, Label};
use crate::document::Form;
use crate::instance::Instance;
use crate::mechanics::NewtonError;
use crate::solution::Solution;
use crate::source::Span;

/// A derivation that a text prints and that cannot be made.
#[derive(Debug, thiserror::Error)]
#[error("`{place}` cannot be printed: {reason}")]
struct Underived {
    place: String,
    reason: String,
    span: Span,
}

/// Bodies whose laws are not the equations of their model.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
struct Unproved(NewtonError);

/// The derivations of an item that cannot be made, and bodies whose laws are not the equations of the energies; `check`
/// reports them.
pub fn underived(template: &Template) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (_, model) in template.graph.systems() {
        if let Err(error) = model.prove_newton() {
            findings.push(Finding::of(&Unproved(error), &template.source));
        }
    }
    for piece in template.passages().flat_map(|passage| &passage.pieces) {
        let places = piece.document.placeholders().iter().zip(&piece.targets);
        for (place, target) in places {
            let reason = match target {
                Target::Derivation(path) => {
                    let lines = template.graph.lines(path);
                    lines.and_then(|lines| Some(lines.err()?.to_string()))
                }
                Target::Node(node) if place.form == Form::Worked => {
                    unworkable(template, *node).map(str::to_owned)
                }
                _ => None,
            };
            let error = reason.map(|reason| Underived {
                place: place.path.clone(),
                reason,
                span: definition(template, &place.path),
            });
            findings.extend(error.map(|error| Finding::of(&error, &template.source)));
        }
    }
    findings
}

/// A free-body diagram that does not show the forces of the model for the data of an instance; `check` reports it.
pub fn unfree(solution: &Solution<'_>) -> Option<Finding> {
    let error = Scene::of(solution, Data::Both).free_picture()?.err()?;
    Some(Finding::of(&error, &solution.template().source))
}

/// Where a placeholder stands in the file.
fn definition(template: &Template, path: &str) -> Span {
    let text = &*template.source.text;
    text.match_indices("<<")
        .find(|(at, _)| text[at + 2..].trim_start().starts_with(path))
        .map_or(Span::NONE, |(at, _)| {
            let length = text[at..].find(">>").map_or(2, |end| end + 2);
            Span::new(at, at + length)
        })
}

impl Diagnose for Underived {
    fn code(&self) -> Code {
        Code::UNKNOWN_PLACEHOLDER
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.span,
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        None
    }
}

impl Diagnose for Unproved {
    fn code(&self) -> Code {
        Code::CHECK
    }

    fn labels(&self) -> Vec<Label> {
        vec![Label {
            span: self.0.span(),
            text: String::new(),
        }]
    }

    fn help(&self) -> Option<String> {
        Some(
            "for each coordinate q the sum over the bodies of ∂(move)/∂q times (inertia − forces) has to be the equation of \
             the energies"
                .to_owned(),
        )
    }
}

#[derive(Debug, thiserror::Error)]
#[error("the plot `{name}` cannot be drawn for the data of the source: {reason}")]
struct Missing {
    name: String,
    reason: Undrawn,
}

/// The plots that take too long for the data of the source; `check` reports them.
pub fn undrawn(template: &Template) -> Vec<Finding> {
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    let missing = template.plots.iter().filter_map(|plot| {
        let reason = scene.plot(&plot.name).err()?;
        let name = plot.name.clone();
        matches!(reason, Undrawn::Work).then_some(Missing { name, reason })
    });
    missing
        .map(|missing| Finding::of(&missing, &template.source))
        .collect()
}

impl Diagnose for Missing {
    fn code(&self) -> Code {
        Code::SIZE
    }

    fn labels(&self) -> Vec<Label> {
        Vec::new()
    }

    fn help(&self) -> Option<String> {
        Some("draw a closed form in place of integrals and roots, or fewer curves".to_owned())
    }
}
