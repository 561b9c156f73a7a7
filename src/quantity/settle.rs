//! Names settled: each formula checked, and translated as soon as it has to be.

use std::collections::BTreeSet;

use super::error::GraphError;
use super::graph::{Computation, Graph, NodeId, NodeRole};
use super::link::{Linked, Linker, NodeOrder};
use crate::expr::{CompileError, Expr, Kind, Name, Names, Path, Program, Shape, Type, Variable};

/// What a settled node takes: names, and nodes that bring along theirs.
#[derive(Debug)]
pub(crate) struct Uses {
    names: Vec<Name>,
    nodes: Vec<NodeId>,
}

impl Graph {
    /// Checks all quantities, in an order in which each comes after those that it needs.
    pub fn resolve(&mut self) -> Vec<(NodeId, GraphError)> {
        let mut order = NodeOrder::of(self);
        for id in self.ids() {
            order.visit(id);
        }
        let (sorted, mut errors) = order.finish();
        for id in sorted {
            errors.extend(self.settle(id).into_iter().map(|error| (id, error)));
        }
        errors
    }

    /// Checks and compiles a node whose dependencies are settled.
    pub(crate) fn settle(&mut self, id: NodeId) -> Vec<GraphError> {
        if let NodeRole::Model(_) = self.node(id).role {
            return self.derive(id);
        }
        let Some(expr) = self.node(id).expr().cloned() else {
            return Vec::new();
        };
        let names = expr.names();
        let missing = self.offer_all(&expr, &names);
        if !missing.is_empty() {
            return missing;
        }
        let found = match expr.check(&*self) {
            Ok(found) => found,
            Err(errors) => return errors.into_iter().map(GraphError::Check).collect(),
        };
        let mut errors = Vec::new();
        // What is assumed of a quantity serves those who use it only while its own formula has no type.
        let node = self.node(id);
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
            None => self.nodes[id.index()].kind = Some(found),
        }
        let free = names.free.iter().map(|variable| variable.name.clone());
        let offered = names.paths.iter().filter_map(|path| self.paths.get(path));
        let offered = offered.copied().collect();
        self.set_uses(id, free.collect(), offered);
        if self.is_plain(&expr, &names) {
            self.nodes[id.index()].is_plain = true;
            return errors;
        }
        match self.link(&expr) {
            Ok(computation) => self.nodes[id.index()].computation = Some(computation).into(),
            Err(error) => errors.push(GraphError::Compile(error)),
        }
        errors
    }

    /// Whether a formula that was checked combines numbers that others compute, and nothing else: then nothing has
    /// to be derived, substituted or taken apart for its translation, which cannot fail.
    fn is_plain(&self, expr: &Expr, names: &Names) -> bool {
        let is_number = |id: NodeId| {
            let shape = self.kind(id).map(Type::shape);
            shape == Some(Shape::Scalar) && !self.is_function(id)
        };
        let is_free = |variable: &Variable| {
            variable.order == 0 && self.find(&variable.name).is_some_and(is_number)
        };
        let is_offered = |path: &Path| {
            let node = self.paths.get(path).copied();
            node.is_some_and(|id| self.is_offered_number(id) && is_number(id))
        };
        let mut is_plain = names.free.iter().all(is_free) && names.paths.iter().all(is_offered);
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

    /// Says what a node takes: these names, with the nodes that bear them, and nodes without a name.
    pub(crate) fn set_uses(&mut self, id: NodeId, names: Vec<Name>, mut nodes: Vec<NodeId>) {
        nodes.extend(names.iter().filter_map(|name| self.find(name)));
        let node = &mut self.nodes[id.index()];
        node.uses = Some(Uses { names, nodes });
        node.reach.take();
    }

    /// The nodes that a node takes.
    pub(crate) fn needs(&self, id: NodeId) -> Vec<NodeId> {
        let uses = self.node(id).uses.as_ref();
        uses.map_or(Vec::new(), |uses| uses.nodes.clone())
    }

    /// All names on which a node depends, through others too, and its own.
    pub(crate) fn reach(&self, id: NodeId) -> &BTreeSet<Name> {
        self.node(id).reach.get_or_init(|| {
            let (mut open, mut seen) = (vec![id], BTreeSet::from([id]));
            let mut reach = BTreeSet::new();
            while let Some(id) = open.pop() {
                let node = self.node(id);
                if matches!(node.role, NodeRole::Parameter(_) | NodeRole::Quantity(_)) {
                    reach.insert(Name::new(&*node.label));
                }
                if let Some(uses) = &node.uses {
                    reach.extend(uses.names.iter().cloned());
                    open.extend(uses.nodes.iter().filter(|own| seen.insert(**own)));
                }
            }
            reach
        })
    }

    pub(crate) fn link(&self, expr: &Expr) -> Result<Computation, CompileError> {
        let linker = Linker::of(self);
        let program = Program::compile(expr, &linker)?;
        let Linked {
            inputs,
            variables,
            motions,
            ..
        } = linker.finish();
        Ok(Computation {
            program,
            inputs,
            variables,
            motions,
        })
    }

    /// How the value of a node is computed.
    pub(crate) fn computation(&self, id: NodeId) -> Option<&Computation> {
        let node = self.node(id);
        if !node.is_plain {
            return node.computation.get()?.as_ref();
        }
        let translated = || self.link(node.expr()?).ok();
        node.computation.get_or_init(translated).as_ref()
    }
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
