//! What follows from a mode shape of one's own.
//!
//! A shape may be answered in any scale; it stands in with unit modal mass, as the right one does. Quantities whose
//! second route is written in shapes, such as the modal coordinates of an initial state, follow by this route.

use super::answers::{Answers, Own, Source, number};
use super::system::normalized;
use crate::answer::AnswerKind;
use crate::expr::{Kind, Value};
use crate::mechanics::Quantity;
use crate::quantity::NodeId;
use crate::solution::Solution;

/// A typed shape with unit modal mass.
pub(crate) fn value(solution: &Solution<'_>, node: NodeId, typed: &[f64]) -> Option<Value> {
    let graph = &solution.template().graph;
    let info = solution.template().info(node)?;
    let mut routes = [Some(node), info.verify].into_iter().flatten();
    let model = routes.find_map(|route| {
        let paths = graph.expr(route)?.names().paths;
        let offered = paths.iter().filter_map(|path| graph.offered(path));
        let mut shapes = offered.filter(|(_, quantity)| *quantity == Quantity::ModeShapes);
        Some(shapes.next()?.0)
    })?;
    let mass = model.mass_matrix()?;
    let Kind::Array(rows) = mass.kind() else {
        return None;
    };
    let mut numbers = Vec::new();
    for row in rows {
        let Kind::Array(entries) = row.kind() else {
            return None;
        };
        for entry in entries {
            let formula = super::answers::in_data(entry, graph)?;
            numbers.push(number(&formula, solution.evaluation())?);
        }
    }
    let form = solution.evaluation().value(node).ok()?.form();
    let shape = normalized(typed, &numbers)?;
    let bounds = vec![0.0; shape.len()];
    Value::new(form, shape, bounds)
}

/// Adds what follows from own shapes by second routes for the quantities that were not answered.
pub(crate) fn extend(solution: &Solution<'_>, answers: &mut Answers) {
    let graph = &solution.template().graph;
    let shapes: Vec<Own> = answers
        .own()
        .filter(|own| own.source == Source::Part(AnswerKind::ModeShape))
        .cloned()
        .collect();
    for shape in &shapes {
        let own: Vec<&Own> = shapes.iter().collect();
        let evaluation = solution.evaluation().replacing(answers.values(&own));
        for (node, info) in &solution.template().quantities {
            let route = info.verify.filter(|route| {
                graph.depends(*route, &shape.name) && !graph.depends(*node, &shape.name)
            });
            let Some(route) = route else {
                continue;
            };
            if answers.has(*node) {
                continue;
            }
            if let Ok(value) = evaluation.value(route) {
                let value = value.clone();
                answers.add_following(solution, *node, Some(shape), value, None);
            }
        }
    }
}
