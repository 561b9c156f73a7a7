//! Names settled: each formula checked, and translated as soon as it has to be.

use super::error::GraphError;
use super::graph::{Graph, NodeId, NodeRole};
use super::link::NodeOrder;
use super::model;
use crate::expr::{Expr, Kind, Name, Names, Shape, Type, Variable};

/// What a settled node takes: names, and nodes that bring along theirs.
#[derive(Debug)]
pub(crate) struct Uses {
    pub(crate) names: Vec<Name>,
    pub(crate) nodes: Vec<NodeId>,
}

pub(crate) fn all(graph: &mut Graph) -> Vec<(NodeId, GraphError)> {
    let mut order = NodeOrder::of(graph);
    for id in graph.ids() {
        order.visit(id);
    }
    let (sorted, mut errors) = order.finish();
    for id in sorted {
        errors.extend(one(graph, id).into_iter().map(|error| (id, error)));
    }
    errors
}

/// Checks and compiles a node whose dependencies are settled.
pub(crate) fn one(graph: &mut Graph, id: NodeId) -> Vec<GraphError> {
    if let NodeRole::Model(_) = graph.node(id).role {
        return model::derive(graph, id);
    }
    let Some(expr) = graph.node(id).expr().cloned() else {
        return Vec::new();
    };
    let names = expr.names();
    let missing = model::offer_all(graph, &expr, &names);
    if !missing.is_empty() {
        return missing;
    }
    let found = match expr.check(&*graph) {
        Ok(found) => found,
        Err(errors) => return errors.into_iter().map(GraphError::Check).collect(),
    };
    let mut errors = Vec::new();
    // What is assumed of a quantity serves those who use it only while its own formula has no type.
    let node = graph.node(id);
    let declared = node
        .kind
        .as_ref()
        .filter(|_| matches!(node.role, NodeRole::Formula(_)));
    match declared.filter(|declared| !found.fits(declared)) {
        Some(declared) => {
            let (what, declared) = (format!("`{}`", node.label), describe(declared));
            errors.push(GraphError::Declared {
                what,
                declared,
                found: describe(&found),
            });
        }
        None => graph.nodes[id.index()].kind = Some(found),
    }
    let free = names.free.iter().map(|variable| variable.name.clone());
    let offered = names.paths.iter().filter_map(|path| graph.paths.get(path));
    let offered = offered.copied().collect();
    graph.set_uses(id, free.collect(), offered);
    if is_plain(graph, &expr, &names) {
        graph.nodes[id.index()].is_plain = true;
        return errors;
    }
    match graph.link(&expr) {
        Ok(computation) => graph.nodes[id.index()].computation = Some(computation).into(),
        Err(error) => errors.push(GraphError::Compile(error)),
    }
    errors
}

/// Whether a formula that was checked combines numbers that others compute, and nothing else: then nothing has
/// to be derived, substituted or taken apart for its translation, which cannot fail.
fn is_plain(graph: &Graph, expr: &Expr, names: &Names) -> bool {
    let is_number = |id: NodeId| {
        let shape = graph.kind(id).map(Type::shape);
        shape == Some(Shape::Scalar) && !graph.is_function(id)
    };
    let is_free = |variable: &Variable| {
        variable.order == 0 && graph.find(&variable.name).is_some_and(is_number)
    };
    let mut is_plain = names.free.iter().all(is_free)
        && names.paths.iter().all(|path| {
            let node = graph.paths.get(path).copied();
            node.is_some_and(|id| graph.is_offered_number(id) && is_number(id))
        });
    expr.walk(&mut |node| {
        is_plain &= !matches!(
            node.kind(),
            Kind::Prime(..)
                | Kind::Index(..)
                | Kind::At(..)
                | Kind::Diff(..)
                | Kind::Root(..)
                | Kind::Integral(..)
                | Kind::Array(_)
        );
    });
    is_plain
}

/// A type in words, for a message.
fn describe(kind: &Type) -> String {
    match kind.dimension() {
        Some(dimension) if !dimension.is_pure() => {
            format!("{} in {}", kind.form(), dimension.describe())
        }
        _ => kind.form().to_string(),
    }
}
