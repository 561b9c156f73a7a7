//! The names of an item, what each stands for, and in which order they can be computed.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use super::error::GraphError;
use super::model::{DeclaredSystem, Offered};
use super::settle::Uses;
use crate::expr::{Expr, Kind, Name, Path, Program, Type};
use crate::unit::Dimension;

/// A thing of an item that has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

/// Everything of an item that has a value, and how it hangs together.
#[derive(Debug, Default)]
pub struct Graph {
    pub(crate) nodes: Vec<Node>,
    pub(crate) names: BTreeMap<Name, NameEntry>,
    /// The models by their beginning in paths, `model` or `models.relative`.
    pub(crate) models: BTreeMap<Box<str>, NodeId>,
    /// The quantities of models that formulas ask for.
    pub(crate) paths: BTreeMap<Path, NodeId>,
}

/// What a name stands for.
#[derive(Clone, Debug)]
pub(crate) enum NameEntry {
    /// A parameter or quantity.
    Node(NodeId),
    /// The time, a coordinate or a symbol: free in every formula.
    Free(Type),
}

/// A parameter, quantity or formula.
#[derive(Debug)]
pub(crate) struct Node {
    /// Its name, or what it is for.
    pub(crate) label: Box<str>,
    pub(crate) role: NodeRole,
    /// The type, once it is known.
    pub(crate) kind: Option<Type>,
    /// The condition without which it does not exist.
    pub(crate) when: Option<NodeId>,
    /// What it takes, once it is settled.
    pub(crate) uses: Option<Uses>,
    /// All names on which it depends, through others too, and its own.
    pub(crate) reach: OnceLock<BTreeSet<Name>>,
    /// Whether its translation cannot fail, and waits until its value is asked for.
    pub(crate) is_plain: bool,
    pub(crate) computation: OnceLock<Option<Computation>>,
}

#[derive(Debug)]
pub(crate) enum NodeRole {
    /// Given, at this place of the data.
    Parameter(u32),
    /// A named formula.
    Quantity(Expr),
    /// A formula without a name.
    Formula(Expr),
    /// A mechanical system.
    Model(Box<DeclaredSystem>),
    /// A quantity that a model offers.
    Offered(Offered),
}

/// How the value of a node follows from others.
#[derive(Debug)]
pub(crate) struct Computation {
    pub(crate) program: Program,
    /// What the slots of the program are, by first slot.
    pub(crate) inputs: Vec<(u32, NodeId)>,
    /// The free names on which it depends, with their slots.
    pub(crate) variables: Vec<(u32, Name)>,
    /// The functions of time that are computed by models, by their number.
    pub(crate) motions: Vec<NodeId>,
}

impl Graph {
    /// A graph that knows the time alone.
    pub fn new() -> Self {
        let mut graph = Self::default();
        graph
            .names
            .insert(Name::new("t"), NameEntry::Free(Type::real(Dimension::TIME)));
        graph
    }

    /// Adds a datum; its place is the number of parameters before it.
    ///
    /// # Errors
    ///
    /// If the name is taken.
    pub fn parameter(&mut self, name: &Name, kind: Type) -> Result<NodeId, GraphError> {
        let place = self
            .nodes
            .iter()
            .filter(|node| matches!(node.role, NodeRole::Parameter(_)))
            .count() as u32;
        self.named(name, NodeRole::Parameter(place), Some(kind))
    }

    /// Adds a coordinate or symbol, free in every formula; a quantity of the same name goes before it.
    ///
    /// # Errors
    ///
    /// If the name is that of a parameter.
    pub fn free(&mut self, name: &Name, kind: Type) -> Result<(), GraphError> {
        match self.names.get(name) {
            Some(NameEntry::Node(_)) => Err(GraphError::Taken { name: name.clone() }),
            Some(NameEntry::Free(_)) => Ok(()),
            None => {
                self.names.insert(name.clone(), NameEntry::Free(kind));
                Ok(())
            }
        }
    }

    /// Adds a quantity, and the condition without which it does not exist; both are checked by
    /// [`Graph::resolve`], when all names are known.
    ///
    /// # Errors
    ///
    /// If the name is taken.
    pub fn quantity(
        &mut self,
        name: &Name,
        expr: Expr,
        declared: Option<Type>,
        when: Option<Expr>,
    ) -> Result<NodeId, GraphError> {
        let id = self.named(name, NodeRole::Quantity(expr), declared)?;
        if let Some(condition) = when {
            let label = format!("condition of {name}").into();
            let when = self.push(Node::new(
                label,
                NodeRole::Formula(condition),
                Some(Type::boolean()),
            ));
            self.nodes[id.index()].when = Some(when);
        }
        Ok(id)
    }

    /// Adds a formula without a name, of which `label` says what it is for; all names are known by now.
    ///
    /// # Errors
    ///
    /// All that is wrong with its names and dimensions.
    pub fn formula(
        &mut self,
        label: impl Into<Box<str>>,
        expr: Expr,
    ) -> Result<NodeId, Vec<GraphError>> {
        if let Some(list) = self.list(&expr) {
            return Ok(list);
        }
        let id = self.push(Node::new(label.into(), NodeRole::Formula(expr), None));
        let errors = self.settle(id);
        if errors.is_empty() {
            Ok(id)
        } else {
            Err(errors)
        }
    }

    /// Adds a formula without a name in which `variable` is free, of type `kind`.
    ///
    /// A parameter or quantity of this name stands back: what depends on it follows the variable.
    ///
    /// # Errors
    ///
    /// All that is wrong with its names and dimensions.
    pub(crate) fn formula_over(
        &mut self,
        label: impl Into<Box<str>>,
        expr: Expr,
        variable: &Name,
        kind: Type,
    ) -> Result<NodeId, Vec<GraphError>> {
        let is_number = self
            .find(variable)
            .is_some_and(|id| self.variables(id).is_empty());
        if is_number {
            // No formula can write this name.
            let free = Name::new(&*format!("{variable} of the plot"));
            let put = Expr::name(free.clone());
            let span = expr.span();
            let expr = Expr::new(Kind::At(expr, vec![(variable.clone(), put)]), span);
            return self.formula_over(label, expr, &free, kind);
        }
        let hidden = self.names.insert(variable.clone(), NameEntry::Free(kind));
        let result = self.formula(label, expr);
        match hidden {
            Some(entry) => self.names.insert(variable.clone(), entry),
            None => self.names.remove(variable),
        };
        result
    }

    /// The node of a name, if it is a parameter or quantity.
    pub fn find(&self, name: &Name) -> Option<NodeId> {
        match self.names.get(name) {
            Some(NameEntry::Node(id)) => Some(*id),
            _ => None,
        }
    }

    /// The condition without which a quantity does not exist.
    pub fn condition(&self, id: NodeId) -> Option<NodeId> {
        self.node(id).when
    }

    /// All names that formulas may use.
    pub fn names(&self) -> impl Iterator<Item = &Name> {
        self.names.keys()
    }

    /// All nodes, in the order in which they were added.
    pub fn ids(&self) -> impl Iterator<Item = NodeId> + use<> {
        (0..self.nodes.len() as u32).map(NodeId)
    }

    /// The type of a node that was resolved.
    pub fn kind(&self, id: NodeId) -> Option<&Type> {
        self.node(id).kind.as_ref()
    }

    /// The formula of a node; a parameter has none.
    pub fn expr(&self, id: NodeId) -> Option<&Expr> {
        self.node(id).expr()
    }

    /// The name of a node, or what it is for.
    pub fn label(&self, id: NodeId) -> &str {
        &self.node(id).label
    }

    /// The free names of which a node is a function.
    pub fn variables(&self, id: NodeId) -> Vec<Name> {
        let variables = self.slots_of_variables(id).iter();
        variables.map(|(_, name)| name.clone()).collect()
    }

    /// Whether a node is a function of free names.
    pub(crate) fn is_function(&self, id: NodeId) -> bool {
        !self.slots_of_variables(id).is_empty()
    }

    fn slots_of_variables(&self, id: NodeId) -> &[(u32, Name)] {
        let computation = self.node(id).computation.get();
        computation
            .and_then(Option::as_ref)
            .map_or(&[], |computation| &computation.variables)
    }

    /// Whether a node depends on a name, through others too.
    pub fn depends(&self, id: NodeId, name: &Name) -> bool {
        self.reach(id).contains(name)
    }

    /// The quantities on which a node depends, itself left out.
    pub fn steps(&self, id: NodeId) -> Vec<NodeId> {
        let names = self.reach(id).iter();
        let nodes = names
            .filter_map(|name| self.find(name))
            .filter(|step| *step != id);
        nodes
            .filter(|step| matches!(self.node(*step).role, NodeRole::Quantity(_)))
            .collect()
    }

    /// The data on which a node depends.
    pub fn parameters(&self, id: NodeId) -> Vec<NodeId> {
        let nodes = self.reach(id).iter().filter_map(|name| self.find(name));
        nodes
            .filter(|datum| matches!(self.node(*datum).role, NodeRole::Parameter(_)))
            .collect()
    }

    pub(crate) fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    fn named(
        &mut self,
        name: &Name,
        role: NodeRole,
        kind: Option<Type>,
    ) -> Result<NodeId, GraphError> {
        if let Some(NameEntry::Node(_)) = self.names.get(name) {
            return Err(GraphError::Taken { name: name.clone() });
        }
        let id = self.push(Node::new(name.as_str().into(), role, kind));
        self.names.insert(name.clone(), NameEntry::Node(id));
        Ok(id)
    }

    pub(crate) fn push(&mut self, node: Node) -> NodeId {
        self.nodes.push(node);
        NodeId(self.nodes.len() as u32 - 1)
    }
}

impl NodeId {
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }
}

impl Node {
    pub(crate) fn new(label: Box<str>, role: NodeRole, kind: Option<Type>) -> Self {
        Self {
            label,
            role,
            kind,
            when: None,
            uses: None,
            reach: OnceLock::new(),
            is_plain: false,
            computation: OnceLock::new(),
        }
    }

    pub(crate) fn expr(&self) -> Option<&Expr> {
        match &self.role {
            NodeRole::Parameter(_) | NodeRole::Model(_) | NodeRole::Offered(_) => None,
            NodeRole::Quantity(expr) | NodeRole::Formula(expr) => Some(expr),
        }
    }
}
