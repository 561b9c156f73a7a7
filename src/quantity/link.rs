//! In which order nodes are settled, and how the names of a formula get their slots.

use std::cell::RefCell;

use super::error::GraphError;
use super::graph::{Graph, NameEntry, NodeId, NodeRole};
use crate::expr::{Binder, Binding, Form, Name, Path, Scope, Type, Variable};
use crate::mechanics::QuantityType;
use crate::numerics::SortedMap;

/// Sorts nodes so that each comes after those that it needs.
pub(crate) struct NodeOrder<'g> {
    graph: &'g Graph,
    /// The nodes that have their place, each with the length of the longest chain that ends with it.
    done: SortedMap<NodeId, usize>,
    open: Vec<NodeId>,
    sorted: Vec<NodeId>,
    errors: Vec<(NodeId, GraphError)>,
}

/// No chain of quantities is longer: evaluation recurs along it.
const MAX_CHAIN_LENGTH: usize = 200;

impl<'g> NodeOrder<'g> {
    pub(crate) fn of(graph: &'g Graph) -> Self {
        Self {
            graph,
            done: SortedMap::new(),
            open: Vec::new(),
            sorted: Vec::new(),
            errors: Vec::new(),
        }
    }

    /// The nodes in order, and what stood in the way.
    pub(crate) fn finish(self) -> (Vec<NodeId>, Vec<(NodeId, GraphError)>) {
        (self.sorted, self.errors)
    }

    pub(crate) fn visit(&mut self, id: NodeId) {
        self.chain(id);
    }

    /// Gives a node its place, after those that it needs; the length of the longest chain that ends with it.
    ///
    /// The order in which quantities are written decides how deep this recurs, but not how long a chain is.
    fn chain(&mut self, id: NodeId) -> usize {
        if let Some(length) = self.done.get(&id) {
            return *length;
        }
        if let Some(start) = self.open.iter().position(|open| *open == id) {
            let circle = self.open[start..].iter().chain([&id]);
            let circle = circle.map(|id| Name::new(self.graph.label(*id))).collect();
            self.errors.push((id, GraphError::Cycle { circle }));
            return 0;
        }
        if self.open.len() >= MAX_CHAIN_LENGTH {
            // It is visited again by itself.
            return self.refuse(id);
        }
        self.open.push(id);
        let node = self.graph.node(id);
        let mut needed: Vec<NodeId> = node.when.into_iter().collect();
        match (&node.role, node.expr()) {
            (NodeRole::Model(system), _) => {
                needed.extend(
                    system
                        .needs()
                        .iter()
                        .filter_map(|name| self.graph.find(name)),
                );
            }
            (_, Some(expr)) => {
                let names = expr.names();
                needed.extend(
                    names
                        .free
                        .iter()
                        .filter_map(|variable| self.graph.find(&variable.name)),
                );
                needed.extend(
                    names
                        .paths
                        .iter()
                        .filter_map(|path| self.graph.model_of(path)),
                );
            }
            _ => {}
        }
        let mut length = 1;
        for next in needed {
            length = length.max(self.chain(next) + 1);
        }
        self.open.pop();
        if length > MAX_CHAIN_LENGTH {
            length = self.refuse(id);
        }
        self.done.insert(id, length);
        self.sorted.push(id);
        length
    }

    /// Notes that a chain is too long; after this place it is counted anew.
    fn refuse(&mut self, id: NodeId) -> usize {
        let name = Name::new(self.graph.label(id));
        let limit = MAX_CHAIN_LENGTH;
        self.errors.push((id, GraphError::TooLong { name, limit }));
        0
    }
}

/// Gives the names of a formula their slots.
pub(crate) struct Linker<'g> {
    graph: &'g Graph,
    state: RefCell<Linked>,
}

#[derive(Default)]
pub(crate) struct Linked {
    pub(crate) inputs: Vec<(u32, NodeId)>,
    pub(crate) variables: Vec<(u32, Name)>,
    pub(crate) motions: Vec<NodeId>,
    slots: u32,
}

impl Linked {
    fn take(&mut self, form: Form) -> u32 {
        let slot = self.slots;
        self.slots += form.width() as u32;
        slot
    }
}

impl<'g> Linker<'g> {
    pub(crate) fn of(graph: &'g Graph) -> Self {
        Self {
            graph,
            state: RefCell::default(),
        }
    }

    pub(crate) fn finish(self) -> Linked {
        self.state.into_inner()
    }

    fn motion(&self, id: NodeId) -> Binding {
        let motions = &mut self.state.borrow_mut().motions;
        let index = motions
            .iter()
            .position(|own| *own == id)
            .unwrap_or_else(|| {
                motions.push(id);
                motions.len() - 1
            });
        Binding::Motion(index as u32)
    }

    fn input(&self, id: NodeId, form: Form) -> Binding {
        let mut state = self.state.borrow_mut();
        if let Some((slot, _)) = state.inputs.iter().find(|(_, node)| *node == id) {
            return Binding::Input { slot: *slot, form };
        }
        let slot = state.take(form);
        state.inputs.push((slot, id));
        Binding::Input { slot, form }
    }

    fn variable(&self, name: &Name, form: Form) -> Binding {
        let mut state = self.state.borrow_mut();
        if let Some((slot, _)) = state.variables.iter().find(|(_, own)| own == name) {
            return Binding::Input { slot: *slot, form };
        }
        let slot = state.take(form);
        state.variables.push((slot, name.clone()));
        Binding::Input { slot, form }
    }
}

impl Binder for Linker<'_> {
    fn path(&self, path: &Path, _local: &[Name]) -> Option<Binding> {
        let id = *self.graph.paths.get(path)?;
        let node = self.graph.node(id);
        let NodeRole::Offered(offered) = &node.role else {
            return None;
        };
        match &offered.quantity_type {
            QuantityType::Formula(_) => offered
                .model
                .formula(offered.quantity)
                .ok()
                .map(Binding::Formula),
            QuantityType::Motion(_) => Some(self.motion(id)),
            _ => Some(self.input(id, node.kind.as_ref()?.form())),
        }
    }

    fn name(&self, variable: &Variable, local: &[Name]) -> Option<Binding> {
        if variable.order > 0 {
            return None;
        }
        match self.graph.names.get(&variable.name)? {
            NameEntry::Free(kind) => Some(self.variable(&variable.name, kind.form())),
            NameEntry::Node(id) => {
                let node = self.graph.node(*id);
                let is_open = self.graph.is_function(*id)
                    || local.iter().any(|name| self.graph.depends(*id, name));
                match node.expr() {
                    Some(expr) if is_open => Some(Binding::Formula(expr.clone())),
                    _ => Some(self.input(*id, node.kind.as_ref()?.form())),
                }
            }
        }
    }
}

/// The types of the names, for the check of a formula.
impl Scope for Graph {
    fn name(&self, name: &Name) -> Option<Type> {
        match self.names.get(name)? {
            NameEntry::Free(kind) => Some(kind.clone()),
            NameEntry::Node(id) => self.node(*id).kind.clone(),
        }
    }

    fn path(&self, path: &Path) -> Option<Type> {
        self.node(*self.paths.get(path)?).kind.clone()
    }

    fn known(&self) -> Vec<String> {
        self.names.keys().map(ToString::to_string).collect()
    }
}
