//! What kinds with symbolic keys share: the formula of a node, its entries, and a mistake's formulas.

use std::sync::Arc;

use super::{Key, Mistaken};
use crate::expr::{Expr, Kind, Name, Shape, Substitution};
use crate::numerics::SortedMap;
use crate::quantity::{Graph, NodeId};
use crate::response::Lexicon;

/// The formula of a node, with the formulas of models substituted; that of a parameter is its name.
pub(crate) fn formula(graph: &Graph, node: NodeId) -> Expr {
    match graph.expr(node) {
        Some(expr) => without_paths(graph, expr),
        None => Expr::name(graph.label(node)),
    }
}

/// A formula with those of models in place of their paths, where they have one.
pub(crate) fn without_paths(graph: &Graph, expr: &Expr) -> Expr {
    if !expr.has_paths() {
        return expr.clone();
    }
    let mut put = Substitution::new();
    for path in expr.names().paths {
        let offered = graph.offered(&path);
        if let Some(formula) = offered.and_then(|(model, quantity)| model.formula(quantity).ok()) {
            put = put.with_path(path, formula);
        }
    }
    put.apply(expr).unwrap_or_else(|_| expr.clone())
}

/// A key that is a formula, as it is printed.
pub(crate) fn printed(shown: &Expr, lexicon: &Lexicon) -> Arc<Key> {
    let key = Key::formula(shown.to_string(), shown.typeset(lexicon));
    Arc::new(key)
}

/// The entries of a formula of this shape, by rows.
pub(crate) fn entries(expr: &Expr, shape: Shape) -> Vec<Expr> {
    if let Some(written) = written_entries(expr, shape) {
        return written;
    }
    let number = |place: usize| Expr::number(i32::try_from(place + 1).unwrap_or(i32::MAX));
    let index = |indices| Expr::derived(Kind::Index(expr.clone(), indices));
    match shape {
        Shape::Scalar => vec![expr.clone()],
        Shape::Vector(length) => (0..length)
            .map(|place| index(vec![number(place)]))
            .collect(),
        Shape::Matrix(rows, columns) => (0..rows * columns)
            .map(|place| index(vec![number(place / columns), number(place % columns)]))
            .collect(),
    }
}

/// The entries of a formula that is written as an array.
fn written_entries(expr: &Expr, shape: Shape) -> Option<Vec<Expr>> {
    let Kind::Array(parts) = expr.kind() else {
        return None;
    };
    let all = match shape {
        Shape::Matrix(..) => parts
            .iter()
            .map(|part| match part.kind() {
                Kind::Array(row) => Some(row.clone()),
                _ => None,
            })
            .collect::<Option<Vec<_>>>()?
            .concat(),
        _ => parts.clone(),
    };
    (all.len() == shape.len()).then_some(all)
}

/// What a mistake puts in for names of the key. What is substituted speaks of the names as they were, so it has them
/// marked as [`original`].
pub(crate) fn replaced(graph: &Graph, mistaken: &Mistaken) -> SortedMap<Name, Expr> {
    let old = || mistaken.replaced.iter().map(|(old, _)| graph.label(*old));
    let marked = old().fold(Substitution::new(), |put, name| {
        put.with(name, Expr::name(format!("{ORIGINAL}{name}").as_str()))
    });
    let new = mistaken
        .replaced
        .iter()
        .map(|(_, new)| formula(graph, *new));
    let pairs = old()
        .zip(new)
        .filter_map(|(old, new)| Some((Name::new(old), marked.apply(&new).ok()?)));
    pairs.collect()
}

/// No name that can be written begins with this sign.
const ORIGINAL: char = '=';

/// The name that is marked as untouched by what replaces names.
pub(crate) fn original(name: &Name) -> Option<Name> {
    name.as_str().strip_prefix(ORIGINAL).map(Name::new)
}
