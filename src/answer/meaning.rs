//! What the names of an answer stand for: data, free symbols, and formulas in these.

use std::sync::{Arc, OnceLock};

use super::equality::Condition;
use super::{Declare, Known, Role};
use crate::expr::{
    Binder, Binding, CompileError, Expr, Form, Name, Precise, Program, Scope, Substitution, Type,
    Variable,
};
use crate::numerics::SortedMap;
use crate::quantity::{Evaluation, NodeId};

/// The names of an item as the answers of a part use them, down to what varies freely.
#[derive(Debug)]
pub(crate) struct Meaning {
    pub(crate) inputs: Vec<Input>,
    formulas: SortedMap<Name, (Expr, Type)>,
    /// What the data of the item have to meet.
    constraints: Vec<Expr>,
    /// The same over the inputs, once it was compiled.
    conditions: OnceLock<Vec<Condition>>,
}

/// A name that varies freely.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Input {
    pub(crate) name: Name,
    /// What it is, in words.
    pub(crate) title: Option<Arc<str>>,
    kind: Type,
    /// Where its value for an instance is to be had.
    node: Option<NodeId>,
    pub(crate) is_signed: bool,
    /// Whether it is an integer by its meaning, such as a number of cycles.
    pub(crate) is_integer: bool,
    /// Whether its time derivatives vary freely, too.
    pub(crate) is_moving: bool,
}

impl Input {
    /// Whether it has a value for an instance.
    pub(crate) fn is_datum(&self) -> bool {
        self.node.is_some()
    }
}

/// A name and its time derivatives take this many slots.
pub(crate) const ORDERS: usize = 4;

/// Which of two things of one name an answer speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Prefer {
    /// The quantity, as everywhere but in equations.
    Quantities,
    /// The coordinate, as in equations.
    Coordinates,
}

impl Meaning {
    /// The names of an item.
    pub(crate) fn of(declare: &dyn Declare, prefer: Prefer) -> Self {
        let known = declare.known();
        let mut meaning = Self {
            inputs: Vec::new(),
            formulas: SortedMap::new(),
            constraints: declare.constraints(),
            conditions: OnceLock::new(),
        };
        for own in &known {
            let mut alike = known.iter().filter(|other| other.name == own.name);
            let is_named_twice = alike.any(|other| is_free(other.role) != is_free(own.role));
            if !is_named_twice || is_free(own.role) != (prefer == Prefer::Quantities) {
                meaning.add(own, declare);
            }
        }
        if !meaning
            .inputs
            .iter()
            .any(|input| input.name.as_str() == "t")
        {
            meaning.inputs.push(Input {
                name: Name::new("t"),
                title: None,
                kind: Type::real(crate::unit::Dimension::TIME),
                node: None,
                is_signed: false,
                is_integer: false,
                is_moving: false,
            });
        }
        meaning
    }

    fn add(&mut self, own: &Known, declare: &dyn Declare) {
        let input = |node, is_signed, is_moving| Input {
            name: own.name.clone(),
            title: own.title.clone(),
            kind: own.kind.clone(),
            node,
            is_signed,
            is_integer: false,
            is_moving,
        };
        match own.role {
            Role::Parameter {
                node,
                is_signed,
                is_integer,
            } => self.inputs.push(Input {
                is_integer,
                ..input(Some(node), is_signed, false)
            }),
            Role::Symbol => self.inputs.push(input(None, true, false)),
            Role::Coordinate => self.inputs.push(input(None, true, true)),
            Role::Quantity { node, .. } => {
                let formula = super::symbolic::formula(declare.graph(), node);
                if !formula.has_paths() {
                    self.formulas
                        .insert(own.name.clone(), (formula, own.kind.clone()));
                } else if own.kind.form() == Form::REAL {
                    // What a model computes is taken as it is.
                    self.inputs.push(input(Some(node), true, false));
                }
            }
        }
    }

    /// Adds a letter of no dimension that varies freely.
    /// It takes the place of a quantity of that name.
    pub(crate) fn add_free(&mut self, name: &Name) {
        self.formulas.remove(name);
        self.inputs.retain(|input| input.name != *name);
        self.inputs.push(Input {
            name: name.clone(),
            title: None,
            kind: Type::real(None),
            node: None,
            is_signed: true,
            is_integer: false,
            is_moving: false,
        });
    }

    /// Lets the time derivatives of a name vary freely, too; one that is a quantity varies from now on.
    pub(crate) fn set_moving(&mut self, name: &Name) {
        if let Some((_, kind)) = self.formulas.remove(name) {
            self.inputs.push(Input {
                name: name.clone(),
                title: None,
                kind,
                node: None,
                is_signed: true,
                is_integer: false,
                is_moving: true,
            });
        }
        if let Some(input) = self.inputs.iter_mut().find(|input| input.name == *name) {
            input.is_moving = true;
            input.node = None;
            input.is_integer = false;
            input.is_signed = true;
        }
    }

    /// The conditions that the data of the item have to meet.
    pub(crate) fn conditions(&self) -> &[Condition] {
        self.conditions
            .get_or_init(|| Condition::of(self, &self.constraints))
    }

    /// Compiles a formula; `replaced` stand in for names.
    pub(crate) fn compile(
        &self,
        expr: &Expr,
        replaced: &SortedMap<Name, Expr>,
    ) -> Result<Program, CompileError> {
        Program::compile(expr, &self.bound(replaced))
    }

    /// The names with these in place of some, as a program binds them.
    pub(crate) fn bound<'a>(&'a self, replaced: &'a SortedMap<Name, Expr>) -> impl Binder + 'a {
        Bound {
            meaning: self,
            replaced,
            form: Form::REAL,
        }
    }

    /// Compiles a formula over complex inputs, two slots for each real one.
    pub(crate) fn compile_complex(
        &self,
        expr: &Expr,
        replaced: &SortedMap<Name, Expr>,
    ) -> Result<Program, CompileError> {
        let bound = Bound {
            meaning: self,
            replaced,
            form: Form::COMPLEX,
        };
        Program::compile(expr, &bound)
    }

    /// Whether a formula keeps its meaning at complex values of its names, with those that are substituted for them.
    pub(crate) fn is_analytic(&self, expr: &Expr, replaced: &SortedMap<Name, Expr>) -> bool {
        // To give up is safe: the formula is then compared at real points alone.
        const MAX_NAMES: usize = 200;
        let mut open = vec![expr.clone()];
        let mut seen: Vec<Name> = Vec::new();
        while let Some(expr) = open.pop() {
            if !expr.is_analytic() || seen.len() > MAX_NAMES {
                return false;
            }
            for variable in expr.names().free {
                if seen.contains(&variable.name) {
                    continue;
                }
                let formula = replaced.get(&variable.name).or_else(|| {
                    self.formulas
                        .get(&variable.name)
                        .map(|(formula, _)| formula)
                });
                open.extend(formula.cloned());
                seen.push(variable.name);
            }
        }
        true
    }

    /// Whether something that moves with time stands in a formula, or in what its names stand for.
    pub(crate) fn uses_moving(&self, expr: &Expr) -> bool {
        let names = self.expanded(expr, &[]).names().free;
        let mut places = names.iter().filter_map(|used| self.place(&used.name));
        places.any(|place| self.inputs[place].is_moving)
    }

    /// The place of a name among the inputs.
    pub(crate) fn place(&self, name: &Name) -> Option<usize> {
        self.inputs.iter().position(|input| input.name == *name)
    }

    /// The value of an input for an instance, if it has one.
    pub(crate) fn value(&self, place: usize, evaluation: &Evaluation<'_>) -> Option<f64> {
        evaluation.real(self.inputs[place].node?).ok()
    }

    /// The value of each input for an instance, if it has one.
    pub(crate) fn values(&self, evaluation: &Evaluation<'_>) -> Vec<Option<f64>> {
        let places = 0..self.inputs.len();
        places.map(|place| self.value(place, evaluation)).collect()
    }

    /// The inputs for an instance; what has no value there is zero.
    pub(crate) fn data(&self, evaluation: &Evaluation<'_>) -> Vec<Precise> {
        Self::slots(&self.values(evaluation))
    }

    /// The slots of inputs with these values; all else is zero.
    pub(crate) fn slots(values: &[Option<f64>]) -> Vec<Precise> {
        let mut slots = vec![Precise::exact(0.0); values.len() * ORDERS];
        for (slot, value) in slots.iter_mut().step_by(ORDERS).zip(values) {
            *slot = Precise::exact(value.unwrap_or_default());
        }
        slots
    }

    /// A formula with all names substituted that an answer may not use.
    pub(crate) fn expanded(&self, expr: &Expr, keep: &[Name]) -> Expr {
        // Each step goes down one level of definitions, which have no cycles.
        const MAX_STEPS: usize = 20;
        let mut result = expr.clone();
        for _ in 0..MAX_STEPS {
            let mut put = Substitution::new();
            let mut is_done = true;
            for variable in result.names().free {
                if keep.contains(&variable.name) {
                    continue;
                }
                if let Some((formula, _)) = self.formulas.get(&variable.name) {
                    put = put.with(variable.name, formula.clone());
                    is_done = false;
                }
            }
            match put.apply(&result) {
                Ok(next) if !is_done => result = next,
                _ => break,
            }
        }
        result
    }
}

fn is_free(role: Role) -> bool {
    matches!(role, Role::Symbol | Role::Coordinate)
}

struct Bound<'a> {
    meaning: &'a Meaning,
    replaced: &'a SortedMap<Name, Expr>,
    /// Of the inputs.
    form: Form,
}

impl Binder for Bound<'_> {
    fn name(&self, variable: &Variable, _local: &[Name]) -> Option<Binding> {
        let order = usize::from(variable.order);
        if let Some(expr) = self.replaced.get(&variable.name) {
            return (order == 0).then(|| Binding::Formula(expr.clone()));
        }
        let plain = super::symbolic::original(&variable.name);
        let name = plain.as_ref().unwrap_or(&variable.name);
        if let Some(place) = self.meaning.place(name) {
            let input = &self.meaning.inputs[place];
            let is_slot = order == 0 || input.is_moving && order < ORDERS;
            return is_slot.then_some(Binding::Input {
                slot: ((place * ORDERS + order) * self.form.width()) as u32,
                form: self.form,
            });
        }
        let (expr, _) = self.meaning.formulas.get(name)?;
        (order == 0).then(|| Binding::Formula(expr.clone()))
    }
}

impl Scope for Meaning {
    fn name(&self, name: &Name) -> Option<Type> {
        match self.place(name) {
            Some(place) => Some(self.inputs[place].kind.clone()),
            None => self.formulas.get(name).map(|(_, kind)| kind.clone()),
        }
    }

    fn is_moving(&self, name: &Name) -> bool {
        self.place(name)
            .is_none_or(|place| self.inputs[place].is_moving)
    }

    fn known(&self) -> Vec<String> {
        let inputs = self.inputs.iter().map(|input| input.name.to_string());
        inputs
            .chain(self.formulas.keys().map(ToString::to_string))
            .collect()
    }
}
