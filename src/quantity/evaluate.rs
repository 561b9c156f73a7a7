//! Values on demand: what is asked for and what that depends on, each computed once.

use std::cell::{Cell, OnceCell, RefCell};
use std::rc::Rc;
use std::sync::Arc;

use crate::expr::{
    Absence, Approx, Name, Path, Precise, Program, Scalar, Undefined, Value, Workspace,
};
use crate::mechanics::{Model, Motion, Numbers, TurningPoints, Unavailable};
use crate::numerics::{Dd, SortedMap};
use crate::work;

use super::given::SlotValues;
use super::graph::{Computation, Graph, GraphNode, NodeId, NodeRole};
use super::model::Offered;
use super::trace::Trace;

/// Why a quantity has no value for these data.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Absent {
    /// There is none: a person marks what is handed in.
    #[error("a person marks this part")]
    ByHand,
    /// Its condition does not hold.
    #[error("`{0}` does not exist for these data")]
    NotForTheseData(Box<str>),
    /// An operation in its formula has no value.
    #[error("`{label}` has no value: {absence}")]
    Undefined {
        /// The quantity.
        label: Box<str>,
        /// The operation.
        absence: Absence,
    },
    /// A model does not have it for these data.
    #[error("`{label}` does not exist for these data: {lack}")]
    Unavailable {
        /// The quantity.
        label: Box<str>,
        /// Why the model does not have it.
        lack: Box<Unavailable>,
    },
    /// It is a function of something that is not given.
    #[error("`{label}` is a function of {}", .of.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "))]
    Function {
        /// The quantity.
        label: Box<str>,
        /// The names that have no value.
        of: Vec<Name>,
    },
}

type Wide = Arc<[Approx<Dd>]>;

/// Units of work that all values of an item may take for one set of data: some tenths of a second.
const MAX_WORK: u64 = 20_000_000;

/// A place for each node, filled when it is first asked for.
type NodeSlots<T> = Box<[OnceCell<Result<T, Absent>>]>;

/// The values of an item's graph for certain data.
pub struct Evaluation<'g> {
    graph: &'g Graph,
    data: Arc<[Precise]>,
    values: NodeSlots<Value>,
    /// The same with twice the digits, where formulas asked for them.
    wide: OnceCell<NodeSlots<Wide>>,
    /// Values that stand in for what a formula would give.
    replaced: Vec<(NodeId, Value)>,
    /// Shared with all evaluations that follow from it.
    rooms: Rc<RefCell<Vec<Workspace>>>,
    /// Units of work that are left for values.
    work: Cell<u64>,
    /// Whether a value is being computed: those that it needs share its budget.
    is_computing: Cell<bool>,
    /// The models with numbers, and their motions, prepared when first asked for.
    systems: RefCell<SortedMap<NodeId, Rc<Numbers>>>,
    motions: RefCell<SortedMap<NodeId, Result<Rc<Motion>, Absent>>>,
}

/// A quantity as a function of its free names, its other inputs at hand.
pub struct Function<'e, 'g> {
    evaluation: &'e Evaluation<'g>,
    node: NodeId,
    computation: &'g Computation,
}

impl<'g> Evaluation<'g> {
    /// Nothing is computed yet; `data` are the values of the parameters in their order.
    pub fn new(graph: &'g Graph, data: Arc<[Precise]>) -> Self {
        Self::with_rooms(graph, data, Rc::default())
    }

    fn with_rooms(
        graph: &'g Graph,
        data: Arc<[Precise]>,
        rooms: Rc<RefCell<Vec<Workspace>>>,
    ) -> Self {
        let values = std::iter::repeat_with(OnceCell::new)
            .take(graph.nodes.len())
            .collect();
        let (wide, replaced) = (OnceCell::new(), Vec::new());
        Self {
            graph,
            data,
            values,
            wide,
            replaced,
            rooms,
            work: Cell::new(MAX_WORK),
            is_computing: Cell::new(false),
            systems: RefCell::default(),
            motions: RefCell::default(),
        }
    }

    /// The same data with these values in place of what formulas give, and those that stand there already;
    /// of two values for one node the new one stands.
    #[must_use]
    pub(crate) fn replacing(&self, mut replaced: Vec<(NodeId, Value)>) -> Self {
        replaced.extend(self.replaced.iter().cloned());
        let (data, rooms) = (Arc::clone(&self.data), Rc::clone(&self.rooms));
        let mut evaluation = Self::with_rooms(self.graph, data, rooms);
        for (node, value) in &replaced {
            // A node is replaced once; of two values the first stands.
            let _ = evaluation.values[node.index()].set(Ok(value.clone()));
        }
        evaluation.replaced = replaced;
        evaluation
    }

    /// The graph whose values these are.
    pub fn graph(&self) -> &'g Graph {
        self.graph
    }

    /// The value of a node, computed the first time it is asked for.
    ///
    /// # Errors
    ///
    /// Why it has none for these data.
    pub fn value(&self, id: NodeId) -> Result<&Value, Absent> {
        self.values[id.index()]
            .get_or_init(|| self.bounded(|| self.compute(id)))
            .as_ref()
            .map_err(Clone::clone)
    }

    /// The real number that a node is.
    ///
    /// # Errors
    ///
    /// As [`Self::value`]; what is not a real number has no value either.
    pub fn real(&self, id: NodeId) -> Result<f64, Absent> {
        self.value(id)?
            .as_real()
            .ok_or_else(|| self.undefined(id, Undefined::NotReal))
    }

    /// The same, where an absolute error of `accuracy` in SI units is good enough.
    ///
    /// # Errors
    ///
    /// As [`Self::real`].
    pub(crate) fn real_within(&self, accuracy: f64, id: NodeId) -> Result<f64, Absent> {
        match self.function(id) {
            Ok(formula) if self.values[id.index()].get().is_none() => {
                self.bounded(|| formula.real_at(&[], accuracy))
            }
            _ => self.real(id),
        }
    }

    /// Whether a condition holds.
    ///
    /// # Errors
    ///
    /// As [`Self::value`].
    pub fn holds(&self, id: NodeId) -> Result<bool, Absent> {
        let value = self.value(id)?;
        value
            .as_boolean()
            .ok_or_else(|| self.undefined(id, Undefined::NotReal))
    }

    /// A node as a function of its free names.
    ///
    /// # Errors
    ///
    /// Why it does not exist for these data.
    pub fn function(&self, id: NodeId) -> Result<Function<'_, 'g>, Absent> {
        let node = self.graph.node(id);
        self.exists(node)?;
        let computation = self
            .graph
            .computation(id)
            .ok_or_else(|| self.undefined(id, Undefined::NotReal))?;
        Ok(Function {
            evaluation: self,
            node: id,
            computation,
        })
    }

    /// Whether a node exists for these data; its value is not computed.
    ///
    /// # Errors
    ///
    /// Why it does not.
    pub(crate) fn exists_for(&self, id: NodeId) -> Result<(), Absent> {
        self.exists(self.graph.node(id))
    }

    /// What was computed so far, and what was not.
    pub fn trace(&self) -> Trace {
        Trace::of(self.graph, |id| self.values[id.index()].get().is_some())
    }

    /// How far rounding in the steps between data and this value can move it, entry by entry:
    /// |y| + Σ |z ∂y/∂z| over the quantities z on which y depends.
    ///
    /// The derivatives are one-sided differences, of which a tolerance needs one figure.
    pub fn spread(&self, id: NodeId) -> Vec<f64> {
        // Truncation is of the order of the step, rounding of ε over the step, 2e-10: about six figures are left.
        const STEP: f64 = 1e-6;
        let Ok(value) = self.value(id) else {
            return Vec::new();
        };
        let mut spread: Vec<f64> = value.numbers().iter().map(|number| number.abs()).collect();
        for step in self.graph.steps(id) {
            let Ok(given) = self.value(step) else {
                continue;
            };
            let other = self.replacing(vec![(step, given.scaled(1.0 + STEP))]);
            let Ok(changed) = other.value(id) else {
                continue;
            };
            for ((sum, a), b) in spread
                .iter_mut()
                .zip(changed.numbers())
                .zip(value.numbers())
            {
                let part = (a - b).abs() / STEP;
                // Beyond the step lies what does not exist; a tolerance without an end would accept anything.
                *sum += if part.is_finite() { part } else { 0.0 };
            }
        }
        spread
    }

    /// The value of a node by another formula than its own.
    pub(crate) fn by(&self, id: NodeId, computation: &Computation) -> Result<Value, Absent> {
        if !computation.variables.is_empty() {
            return Err(self.none(id));
        }
        self.bounded(|| self.run(self.graph.node(id), computation, &[]))
    }

    /// A node as the function that another formula than its own is.
    pub(crate) fn function_by(&self, id: NodeId, computation: &'g Computation) -> Function<'_, 'g> {
        Function {
            evaluation: self,
            node: id,
            computation,
        }
    }

    /// A node that has no such value.
    pub(crate) fn none(&self, id: NodeId) -> Absent {
        self.undefined(id, Undefined::NotReal)
    }

    /// Computes a value with what is left of the work for these data.
    fn bounded<T>(&self, compute: impl FnOnce() -> T) -> T {
        if self.is_computing.replace(true) {
            return compute();
        }
        let computed = work::within(self.work.get(), compute);
        self.work.set(self.work.get() - computed.units);
        self.is_computing.set(false);
        computed.value
    }

    fn compute(&self, id: NodeId) -> Result<Value, Absent> {
        let node = self.graph.node(id);
        self.exists(node)?;
        if let NodeRole::Parameter(place) = node.role {
            let datum = &self.data[place as usize];
            // What rounding to binary64 drops of a decimal is a part of its bound.
            return Ok(Value::real(datum.high(), datum.low().abs() + datum.rest()));
        }
        if let NodeRole::Offered(offered) = &node.role {
            let value = self.numbers(offered).value_of(offered.quantity);
            return value.map_err(|lack| Absent::Unavailable {
                label: node.label.clone(),
                lack: Box::new(lack),
            });
        }
        let computation = self
            .graph
            .computation(id)
            .ok_or_else(|| self.undefined(id, Undefined::NotReal))?;
        if !computation.variables.is_empty() {
            let of = computation
                .variables
                .iter()
                .map(|(_, name)| name.clone())
                .collect();
            return Err(Absent::Function {
                label: node.label.clone(),
                of,
            });
        }
        self.run(node, computation, &[])
    }

    fn run(
        &self,
        node: &GraphNode,
        computation: &Computation,
        variables: &[Precise],
    ) -> Result<Value, Absent> {
        self.run_with(node, computation, variables, |program, inputs, room| {
            program.evaluate(inputs, room)
        })
    }

    fn run_with<T>(
        &self,
        node: &GraphNode,
        computation: &Computation,
        variables: &[Precise],
        run: impl FnOnce(&Program, &SlotValues<'_, '_>, &mut Workspace) -> Result<T, Absence>,
    ) -> Result<T, Absent> {
        let inputs = SlotValues {
            evaluation: self,
            computation,
            variables,
        };
        // A value asks for others while it is computed: each takes a room of its own, and none is borrowed
        // meanwhile.
        let mut room = self.rooms.borrow_mut().pop().unwrap_or_default();
        let result = run(&computation.program, &inputs, &mut room);
        self.rooms.borrow_mut().push(room);
        result.map_err(|absence| Absent::Undefined {
            label: node.label.clone(),
            absence,
        })
    }

    fn exists(&self, node: &GraphNode) -> Result<(), Absent> {
        match node.when.map(|when| self.holds(when)) {
            None | Some(Ok(true)) => Ok(()),
            Some(Ok(false)) => Err(Absent::NotForTheseData(node.label.clone())),
            Some(Err(absent)) => Err(absent),
        }
    }

    /// The numbers of a node with twice the digits.
    pub(crate) fn precise(&self, id: NodeId) -> Result<&Wide, Absent> {
        let cells = self.wide.get_or_init(|| {
            std::iter::repeat_with(OnceCell::new)
                .take(self.values.len())
                .collect()
        });
        cells[id.index()]
            .get_or_init(|| self.compute_precisely(id))
            .as_ref()
            .map_err(Clone::clone)
    }

    fn compute_precisely(&self, id: NodeId) -> Result<Wide, Absent> {
        if let Some((_, value)) = self.replaced.iter().find(|(node, _)| *node == id) {
            return Ok(value
                .numbers()
                .iter()
                .map(|number| Approx::certain(Dd::from(*number)))
                .collect());
        }
        let node = self.graph.node(id);
        self.exists(node)?;
        if let NodeRole::Parameter(place) = node.role {
            return Ok([Approx::of(&self.data[place as usize])].into());
        }
        if let NodeRole::Offered(_) = node.role {
            // A solver gives binary64; its bound goes along.
            let value = self.value(id)?;
            let pairs = value.numbers().iter().zip(value.bounds());
            return Ok(pairs
                .map(|(number, bound)| Approx::new(Dd::from(*number), *bound))
                .collect());
        }
        let computation = self
            .graph
            .computation(id)
            .ok_or_else(|| self.undefined(id, Undefined::NotReal))?;
        let inputs = SlotValues {
            evaluation: self,
            computation,
            variables: &[],
        };
        let mut room = Default::default();
        let outcome = computation.program.run::<Approx<Dd>>(&inputs, &mut room);
        let outcome = outcome.map_err(|absence| Absent::Undefined {
            label: node.label.clone(),
            absence,
        })?;
        Ok(outcome.numbers().copied().collect())
    }

    /// A model with the numbers of these data.
    fn numbers(&self, offered: &Offered) -> Rc<Numbers> {
        self.system(offered.system, &offered.model)
    }

    /// The turning points of the motion of a model with dry friction, `most` of them at most; none where the path names
    /// no such model or the data have no such motion.
    pub fn turning_points(&self, path: &Path, most: usize) -> Option<TurningPoints> {
        let system = self.graph.model_of(path)?;
        let model = self.graph.system(system)?.model.as_ref()?;
        self.system(system, model).turning_points(most).ok()
    }

    /// The model under the beginning of a path, `model`, with the numbers of these data.
    pub fn model(&self, beginning: &str) -> Option<Rc<Numbers>> {
        let system = *self.graph.models.get(beginning)?;
        let model = self.graph.system(system)?.model.as_ref()?;
        Some(self.system(system, model))
    }

    fn system(&self, system: NodeId, model: &Arc<Model>) -> Rc<Numbers> {
        if let Some(numbers) = self.systems.borrow().get(&system) {
            return Rc::clone(numbers);
        }
        let value = |name: &Name| {
            let missing = Undefined::Missing { slot: 0 };
            let node = self.graph.find(name).ok_or(missing)?;
            let numbers = self.precise(node).map_err(|_| missing)?;
            let number = numbers.first().ok_or(missing)?;
            Ok(Precise::of_dd(number.value, number.bound))
        };
        let numbers = Rc::new(Numbers::of(Arc::clone(model), value));
        self.systems
            .borrow_mut()
            .insert(system, Rc::clone(&numbers));
        numbers
    }

    /// The motion that a node of a model is.
    pub(crate) fn motion(&self, id: NodeId) -> Result<Rc<Motion>, Absent> {
        if let Some(motion) = self.motions.borrow().get(&id) {
            return motion.clone();
        }
        let node = self.graph.node(id);
        let NodeRole::Offered(offered) = &node.role else {
            return Err(self.undefined(id, Undefined::NotReal));
        };
        let motion = self.numbers(offered).motion_of(offered.quantity);
        let motion = motion.map(Rc::new).map_err(|lack| Absent::Unavailable {
            label: node.label.clone(),
            lack: Box::new(lack),
        });
        self.motions.borrow_mut().insert(id, motion.clone());
        motion
    }

    fn undefined(&self, id: NodeId, reason: Undefined) -> Absent {
        let absence = Absence {
            reason,
            span: crate::source::Span::NONE,
        };
        Absent::Undefined {
            label: self.graph.node(id).label.clone(),
            absence,
        }
    }
}

impl Function<'_, '_> {
    /// The free names, in the order in which [`Self::at`] takes their values.
    pub fn variables(&self) -> impl Iterator<Item = &Name> {
        self.computation.variables.iter().map(|(_, name)| name)
    }

    /// The value where the free names have these values, in SI units.
    ///
    /// # Errors
    ///
    /// Why there is none.
    pub fn at(&self, variables: &[Precise]) -> Result<Value, Absent> {
        self.evaluation.run(
            self.evaluation.graph.node(self.node),
            self.computation,
            variables,
        )
    }

    /// The values of a real function at many places, each given by the values of the free names, as [`Self::real_at`]
    /// gives them; what does not depend on the free names is computed once.
    ///
    /// # Errors
    ///
    /// Those of [`Self::real_at`], for the first place that has one.
    pub(crate) fn reals_at<'v>(
        &self,
        places: impl Iterator<Item = &'v [Precise]>,
        accuracy: f64,
    ) -> Result<Vec<f64>, Absent> {
        let varied = self.computation.variables.iter().map(|(slot, _)| *slot);
        let inputs = places.map(|variables| SlotValues {
            evaluation: self.evaluation,
            computation: self.computation,
            variables,
        });
        let inputs: Vec<SlotValues<'_, '_>> = inputs.collect();
        let mut sweep = self.computation.program.sweep(varied.collect());
        let values = sweep.reals(accuracy, &inputs);
        values.map_err(|absence| Absent::Undefined {
            label: self.evaluation.graph.node(self.node).label.clone(),
            absence,
        })
    }

    /// The value of a real function, where an absolute error of `accuracy` in SI units is good enough.
    ///
    /// # Errors
    ///
    /// Why there is none; a function with other values has none.
    pub(crate) fn real_at(&self, variables: &[Precise], accuracy: f64) -> Result<f64, Absent> {
        let node = self.evaluation.graph.node(self.node);
        self.evaluation.run_with(
            node,
            self.computation,
            variables,
            |program, inputs, room| program.evaluate_within(accuracy, inputs, room),
        )
    }
}
