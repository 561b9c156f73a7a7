//! What is wrong with an item whatever is drawn: data without use, answers that are printed, what is missing.

use super::fault::QuestionFault;
use crate::answer::{Answer, AnswerKind, Choosing};
use crate::bank::{Part, Passage, Target, Template};
use crate::document::{Document, Filling, Form};
use crate::expr::{Expr, Kind, Name};
use crate::quantity::NodeId;
use crate::response;
use crate::solution::Solution;

/// Most questions of an item, where a group counts as one: an examination of an hour, at seven minutes each.
const MAX_QUESTIONS: usize = 8;

/// All of it.
pub(crate) fn faults(template: &Template, solution: &Solution<'_>) -> Vec<QuestionFault> {
    let mut faults = unused(template, solution);
    faults.extend(disclosed(template));
    let count = template.questions();
    if count > MAX_QUESTIONS {
        let most = MAX_QUESTIONS;
        faults.push(QuestionFault::ManyQuestions { count, most });
    }
    let figure = template.figure.as_ref();
    if figure.is_some_and(|figure| !figure.moves()) && template.graph.derived("model").is_some() {
        faults.push(QuestionFault::StillFigure);
    }
    for part in &template.parts {
        faults.extend(option_form(part));
        faults.extend(missing(template, part));
    }
    faults
}

/// Data on which no key depends. What work on paper takes is not known: where it is asked, none is found.
fn unused(template: &Template, solution: &Solution<'_>) -> Vec<QuestionFault> {
    let mut parts = template.parts.iter();
    if parts.any(|part| part.answer.kind().is_by_hand()) {
        return Vec::new();
    }
    let is_used = |name: &Name, node: NodeId| {
        template.parts.iter().enumerate().any(|(place, part)| {
            let keys = part.answer.keys();
            let by_keys = keys
                .iter()
                .any(|key| *key == node || template.graph.depends(*key, name));
            by_keys
                || part
                    .when
                    .is_some_and(|when| template.graph.depends(when, name))
                || keys.is_empty() && is_in_equations(solution, place, name)
        })
    };
    let parameters = template.parameters.iter();
    parameters
        .filter(|parameter| {
            let node = template.graph.find(&parameter.name);
            node.is_some_and(|node| !is_used(&parameter.name, node))
        })
        .map(|parameter| QuestionFault::UnusedDatum {
            datum: parameter.name.to_string(),
        })
        .collect()
}

/// Whether an equation that is asked for has a name in it, through quantities too.
fn is_in_equations(solution: &Solution<'_>, place: usize, name: &Name) -> bool {
    let graph = &solution.template().graph;
    let Some(equations) = solution
        .marker(place)
        .ok()
        .and_then(|marker| marker.equations(response::Passage::default()))
    else {
        return false;
    };
    let sides = equations
        .key
        .iter()
        .flat_map(|equation| [&equation.left, &equation.right]);
    sides.flat_map(|side| side.names().free).any(|variable| {
        variable.name == *name
            || graph
                .find(&variable.name)
                .is_some_and(|node| graph.depends(node, name))
    })
}

/// Parts whose answers are printed before they are due, or in a later question.
fn disclosed(template: &Template) -> Vec<QuestionFault> {
    let mut faults = Vec::new();
    for (place, part) in template.parts.iter().enumerate() {
        let keys = part.answer.keys();
        let [key] = keys[..] else { continue };
        let is_letters = matches!(
            part.answer.kind(),
            AnswerKind::Formula | AnswerKind::Equation | AnswerKind::Matrix
        );
        let is_datum = template
            .info(key)
            .is_some_and(|info| info.parameter.is_some());
        if is_datum {
            continue;
        }
        if prints(&template.statement, key, is_letters) {
            faults.push(QuestionFault::Disclosed {
                part: part.id.clone(),
                place: "the statement".to_owned(),
            });
        }
        let others = template
            .parts
            .iter()
            .enumerate()
            .filter(|(other, _)| *other >= place);
        let is_shown = |other: &Part| {
            let mut group = other.group.iter();
            prints(&other.ask, key, is_letters)
                || group.any(|group| prints(&group.text, key, is_letters))
        };
        if let Some((_, other)) = others.into_iter().find(|(_, other)| is_shown(other)) {
            let place = format!("the question of part `{}`", other.id);
            faults.push(QuestionFault::Disclosed {
                part: part.id.clone(),
                place,
            });
        }
    }
    faults
}

/// Whether a text prints the value of a node, or its formula where that is asked.
fn prints(passage: &Passage, key: NodeId, in_letters: bool) -> bool {
    passage.pieces.iter().any(|piece| {
        let pairs = piece.document.placeholders().iter().zip(&piece.targets);
        pairs.into_iter().any(|(placeholder, target)| {
            let is_value = matches!(
                placeholder.form,
                Form::Value | Form::Given | Form::Number | Form::Substituted | Form::Equation
            );
            let is_formula = matches!(
                placeholder.form,
                Form::Formula | Form::Equation | Form::Substituted
            );
            *target == Target::Node(key) && (is_value && !in_letters || is_formula && in_letters)
        })
    })
}

/// A right option that its form gives away.
fn option_form(part: &Part) -> Option<QuestionFault> {
    let answer: &dyn Answer = &*part.answer;
    if answer.choosing() != Some(Choosing::One) || !answer.keys().is_empty() {
        return None;
    }
    let right = answer.always_right()?;
    let forms: Vec<(bool, usize)> = answer
        .options()
        .iter()
        .map(|option| form(&option.text))
        .collect();
    let (own_math, own_length) = *forms.get(right)?;
    let others = || {
        forms
            .iter()
            .enumerate()
            .filter(|(place, _)| *place != right)
            .map(|(_, form)| form)
    };
    let is_only_formula = own_math && others().all(|(math, _)| !math) && forms.len() > 2;
    let is_only_words = !own_math && others().all(|(math, _)| *math) && forms.len() > 2;
    let longest = others().map(|(_, length)| *length).max()?;
    let how = if is_only_formula {
        "the only one with a formula"
    } else if is_only_words {
        "the only one without a formula"
    } else if own_length > 2 * longest.max(SHORT) {
        "more than twice as long as any other"
    } else {
        return None;
    };
    Some(QuestionFault::OptionForm {
        part: part.id.clone(),
        how,
    })
}

/// Options of so few letters are all short.
const SHORT: usize = 20;

/// Whether a text has a formula, and how long it is.
fn form(text: &Document) -> (bool, usize) {
    let none: Vec<Filling> = Vec::new();
    (
        text.markdown(&none).contains('$'),
        text.plain(&none).chars().count(),
    )
}

/// Whether a number has a second route: its own, or those of all that it lists.
fn has_route(template: &Template, key: NodeId) -> bool {
    let known = |node| {
        template
            .info(node)
            .is_some_and(|info| info.verify.is_some() || info.parameter.is_some())
    };
    let listed = match template.graph.expr(key).map(Expr::kind) {
        Some(Kind::Array(entries)) if !known(key) => &entries[..],
        _ => return known(key),
    };
    listed.iter().all(|entry| match entry.kind() {
        Kind::Name(name) => template.graph.find(name).is_some_and(known),
        _ => false,
    })
}

/// What a part should have and does not.
fn missing(template: &Template, part: &Part) -> Vec<QuestionFault> {
    let own = || part.id.clone();
    let mut faults = Vec::new();
    let asks_number = matches!(
        part.answer.kind(),
        AnswerKind::Numeric | AnswerKind::Integer
    );
    let keys = part.answer.keys();
    if asks_number
        && !keys.iter().all(|key| has_route(template, *key))
        && !template.about.allows("single-route")
    {
        faults.push(QuestionFault::NoSecondRoute { part: own() });
    }
    if part.hints.iter().all(Passage::is_empty) {
        faults.push(QuestionFault::NoHint { part: own() });
    }
    if part.worked().next().is_none() {
        faults.push(QuestionFault::NoSolution { part: own() });
    }
    faults
}
