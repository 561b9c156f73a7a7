//! The names of an item, what each stands for, and in which order they can be computed.

use std::sync::{Arc, OnceLock};

use super::error::GraphError;
use super::link::{Linked, Linker};
use super::model::{DeclaredSystem, Offered, beginning, rest};
use super::settle::Uses;
use super::{model, settle};
use crate::expr::{CompileError, Expr, Kind, Name, Path, Program, Type};
use crate::mechanics::{
    Definition, Model, Quantity, QuantityError, QuantityType, Step, Unavailable, Way,
};
use crate::numerics::{SortedMap, SortedSet};
use crate::unit::Dimension;

/// A thing of an item that has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u32);

/// Everything of an item that has a value, and how it hangs together.
#[derive(Debug, Default)]
pub struct Graph {
    pub(crate) nodes: Vec<GraphNode>,
    pub(crate) names: SortedMap<Name, NameEntry>,
    /// The models by their beginning in paths, `model` or `models.relative`.
    pub(crate) models: SortedMap<Box<str>, NodeId>,
    /// The quantities of models that formulas ask for.
    pub(crate) paths: SortedMap<Path, NodeId>,
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
pub(crate) struct GraphNode {
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
    pub(crate) reach: OnceLock<SortedSet<Name>>,
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
            let when = self.push(GraphNode::new(
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
        if let Some(list) = model::list(self, &expr) {
            return Ok(list);
        }
        let id = self.push(GraphNode::new(label.into(), NodeRole::Formula(expr), None));
        let errors = settle::one(self, id);
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

    /// The quantities on which a node depends, itself left out. One that only repeats another, to be printed with more
    /// figures, is that other one: nobody rounds it a second time.
    pub fn steps(&self, id: NodeId) -> Vec<NodeId> {
        let own = self.repeated(id);
        let names = self.reach(id).iter();
        names
            .filter_map(|name| self.find(name))
            .filter(|step| *step != own && self.repeated(*step) == *step)
            .filter(|step| matches!(self.node(*step).role, NodeRole::Quantity(_)))
            .collect()
    }

    /// The quantity that a node only repeats by its name, through others too; itself if it says more.
    fn repeated(&self, id: NodeId) -> NodeId {
        let chain = std::iter::successors(Some(id), |node| self.repeats(*node));
        // A chain that is longer goes in a circle, which `resolve` reports.
        chain.take(self.nodes.len()).last().unwrap_or(id)
    }

    /// The quantity whose name is all of a quantity's formula.
    fn repeats(&self, id: NodeId) -> Option<NodeId> {
        let quantity = |id: NodeId| match &self.node(id).role {
            NodeRole::Quantity(formula) => Some(formula),
            _ => None,
        };
        let Kind::Name(name) = quantity(id)?.kind() else {
            return None;
        };
        self.find(name).filter(|other| quantity(*other).is_some())
    }

    /// The data on which a node depends.
    pub fn parameters(&self, id: NodeId) -> Vec<NodeId> {
        let nodes = self.reach(id).iter().filter_map(|name| self.find(name));
        nodes
            .filter(|datum| matches!(self.node(*datum).role, NodeRole::Parameter(_)))
            .collect()
    }

    pub(crate) fn node(&self, id: NodeId) -> &GraphNode {
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
        let id = self.push(GraphNode::new(name.as_str().into(), role, kind));
        self.names.insert(name.clone(), NameEntry::Node(id));
        Ok(id)
    }

    pub(crate) fn push(&mut self, node: GraphNode) -> NodeId {
        self.nodes.push(node);
        NodeId(self.nodes.len() as u32 - 1)
    }

    /// Checks all quantities, in an order in which each comes after those that it needs.
    pub fn resolve(&mut self) -> Vec<(NodeId, GraphError)> {
        settle::all(self)
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
    pub(crate) fn reach(&self, id: NodeId) -> &SortedSet<Name> {
        self.node(id).reach.get_or_init(|| {
            let (mut open, mut seen) = (vec![id], SortedSet::from([id]));
            let mut reach = SortedSet::new();
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
        node.computation
            .get_or_init(|| self.link(node.expr()?).ok())
            .as_ref()
    }

    /// Adds a system under the beginning of its paths, `model` or `models.relative`.
    pub fn model(&mut self, beginning: &str, definition: Definition) -> NodeId {
        let system = Box::new(DeclaredSystem {
            definition,
            model: None,
        });
        let id = self.push(GraphNode::new(
            beginning.into(),
            NodeRole::Model(system),
            None,
        ));
        self.models.insert(beginning.into(), id);
        id
    }

    /// The model that was derived under this beginning of a path.
    pub fn derived(&self, beginning: &str) -> Option<&Arc<Model>> {
        self.system(*self.models.get(beginning)?)?.model.as_ref()
    }

    /// The model and the quantity that a path names.
    pub fn offered(&self, path: &Path) -> Option<(&Arc<Model>, Quantity)> {
        let model = self.system(self.model_of(path)?)?.model.as_ref()?;
        Some((model, model.quantity(rest(path)).ok()?))
    }

    /// The model and the derivation that a path names.
    pub fn way(&self, path: &Path) -> Option<(&Arc<Model>, Way)> {
        self.derivation(path)?.ok()
    }

    /// The same with the reason why there is no such derivation; nothing where there is no such model, or where it could
    /// not be derived itself.
    pub fn derivation(&self, path: &Path) -> Option<Result<(&Arc<Model>, Way), QuantityError>> {
        let model = self.system(self.model_of(path)?)?.model.as_ref()?;
        Some(Way::of(model, rest(path)).map(|way| (model, way)))
    }

    /// The lines of the derivation that a path names; nothing where it names none.
    pub fn lines(&self, path: &Path) -> Option<Result<Vec<Step>, Unavailable>> {
        let (model, way) = self.way(path)?;
        Some(match way {
            Way::Static => {
                let reduced = self.derived("model")?;
                model.statics(reduced, &self.letters(model))
            }
            way => model.derivation(way),
        })
    }

    /// The quantities that a model uses as letters, with their formulas; one whose formula is a number stays a letter.
    fn letters(&self, model: &Model) -> Vec<(Name, Expr)> {
        let formula = |name: &Name| {
            let formula = self.expr(self.find(name)?)?;
            let is_number = formula.names().free.is_empty();
            (!is_number).then(|| (name.clone(), formula.clone()))
        };
        model.names().iter().filter_map(formula).collect()
    }

    /// All models that were derived, by the beginnings of their paths.
    pub fn systems(&self) -> impl Iterator<Item = (&str, &Arc<Model>)> {
        let models = self.models.iter();
        models.filter_map(|(name, id)| Some((name.as_ref(), self.system(*id)?.model.as_ref()?)))
    }

    /// The quantities of models that formulas ask for, by path.
    pub fn asked(&self) -> impl Iterator<Item = (&Path, NodeId)> {
        self.paths.iter().map(|(path, node)| (path, *node))
    }

    /// The node of the system of a path.
    pub(crate) fn model_of(&self, path: &Path) -> Option<NodeId> {
        self.models.get(beginning(path).as_str()).copied()
    }

    pub(crate) fn system(&self, id: NodeId) -> Option<&DeclaredSystem> {
        match &self.node(id).role {
            NodeRole::Model(system) => Some(system),
            _ => None,
        }
    }

    /// Whether a node is a number of a model, no formula or function of time.
    pub(crate) fn is_offered_number(&self, id: NodeId) -> bool {
        let role = &self.node(id).role;
        matches!(role, NodeRole::Offered(offered) if matches!(offered.quantity_type, QuantityType::Number(_)))
    }
}

impl NodeId {
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }
}

impl GraphNode {
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
