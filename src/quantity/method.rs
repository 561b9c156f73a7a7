//! Standard wrong methods: what comes out where one step to a quantity is taken wrongly.
//!
//! Each is a transformation of the item's own graph, never a list by hand: a term of a formula is dropped, a factor
//! forgotten, a datum taken as nothing, in the wrong unit, as a mass for a weight, as a diameter for a radius. Damping
//! that is left out, `ω_n` in place of `ω_d` and a spring that is forgotten are terms and data of this kind.

use std::sync::Arc;

use super::evaluate::{Absent, Evaluation, Function};
use super::graph::{Computation, Graph, NodeId, NodeRole};
use crate::expr::{Constant, Expr, Function as Elementary, Kind, Operator, Value};
use crate::numerics::Rational;

/// A step that is taken wrongly.
#[derive(Debug)]
pub struct Method {
    /// What is done wrongly.
    pub slip: Wrong,
    /// The quantity or datum that gets a wrong value by it.
    pub step: NodeId,
    change: Change,
    /// What other parts ask for on the way: it is taken rightly.
    held: Arc<[NodeId]>,
}

/// What is done wrongly in a step.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Wrong {
    /// A term of a sum is dropped.
    #[error("`{step}` without the term `{term}`")]
    Term {
        /// The quantity.
        step: Arc<str>,
        /// The term that is dropped, as it is written.
        term: String,
    },
    /// A factor is forgotten.
    #[error("`{step}` without the factor `{factor}`")]
    Factor {
        /// The quantity.
        step: Arc<str>,
        /// The factor that is forgotten, as it is written.
        factor: String,
    },
    /// Sine for cosine, or the reverse.
    #[error("`{step}` with `{typed}` for `{right}`")]
    Circular {
        /// The quantity.
        step: Arc<str>,
        /// What stands there.
        right: &'static str,
        /// What is taken.
        typed: &'static str,
    },
    /// A datum is left out.
    #[error("`{0}` left out")]
    Datum(Arc<str>),
    /// The number of a datum is taken as one in the coherent unit.
    #[error("`{0}` with its unit ignored")]
    Unit(Arc<str>),
    /// An angle is taken in degrees where it is in radians, or the reverse.
    #[error("`{0}` with degrees and radians confused")]
    Degrees(Arc<str>),
    /// The acceleration of gravity is forgotten: a mass for a weight.
    #[error("a mass for a weight, without `{0}`")]
    Weight(Arc<str>),
    /// A diameter is taken for a radius.
    #[error("a diameter for the radius `{0}`")]
    Diameter(Arc<str>),
    /// A radius is taken for a diameter.
    #[error("a radius for the diameter `{0}`")]
    Radius(Arc<str>),
    /// The result is off by a factor.
    #[error("the result {0}")]
    Result(&'static str),
}

#[derive(Debug)]
enum Change {
    /// Another formula.
    Formula(Box<Computation>, Expr),
    /// Its value by a factor.
    Times(f64),
    /// Another number, in SI units.
    Number(f64),
}

/// What is known of a datum beyond its value, as far as it can be mistaken.
#[derive(Clone, Debug, Default)]
pub struct Datum {
    /// How many coherent units its unit is.
    pub scale: f64,
    /// Whether it is an angle.
    pub is_angle: bool,
    /// Whether it is the acceleration of gravity.
    pub is_gravity: bool,
    /// Whether its name says that it is a radius.
    pub is_radius: bool,
    /// Whether its name says that it is a diameter.
    pub is_diameter: bool,
}

/// No part has more methods from its formulas: what is long has many terms that are alike.
const MAX_FORMULAS: usize = 24;

/// A degree in radians.
const DEGREE: f64 = std::f64::consts::PI / 180.0;

impl Method {
    /// The wrong methods to a quantity: its own formula and those on the way to it, up to the quantities in `asked`,
    /// which other parts ask for, so that what is wrong in them is marked there; and the data on this way. Formulas
    /// that are `hidden`, abbreviations of the author's algebra that no student writes, are not varied.
    pub fn all(
        graph: &Graph,
        key: NodeId,
        asked: &[NodeId],
        hidden: impl Fn(NodeId) -> bool,
        datum: impl Fn(NodeId) -> Datum,
    ) -> Vec<Self> {
        let (formulas, data, held) = way_to(graph, key, asked);
        let cases = cases(graph, key);
        let is_written = |step: &NodeId| *step == key || cases.contains(step) || !hidden(*step);
        let mut methods = Vec::new();
        for step in formulas.into_iter().filter(is_written) {
            let Some(expr) = graph.expr(step) else {
                continue;
            };
            for (slip, changed) in variations(graph.label(step), expr) {
                // A formula of another dimension cannot stand in for the quantity, and units tell whoever
                // made the slip.
                let is_sound = methods.len() < MAX_FORMULAS && changed.check(graph).is_ok();
                if let Some(computation) = is_sound.then(|| graph.link(&changed).ok()).flatten() {
                    let change = Change::Formula(Box::new(computation), changed);
                    methods.push(Self::of(slip, step, change, &held));
                }
            }
        }
        for step in data {
            let name: Arc<str> = graph.label(step).into();
            let known = datum(step);
            let mut add = |slip, change| methods.push(Self::of(slip, step, change, &held));
            if known.is_gravity {
                // The number of kilograms is then that of newtons.
                add(Wrong::Weight(name), Change::Number(1.0));
                continue;
            }
            add(Wrong::Datum(Arc::clone(&name)), Change::Number(0.0));
            if known.is_angle {
                // An angle in degrees has gone through the factor already, one in radians has not.
                let turned = if known.scale == 1.0 {
                    DEGREE
                } else {
                    1.0 / DEGREE
                };
                add(Wrong::Degrees(Arc::clone(&name)), Change::Times(turned));
            } else if known.scale > 0.0 && known.scale != 1.0 {
                add(
                    Wrong::Unit(Arc::clone(&name)),
                    Change::Times(1.0 / known.scale),
                );
            }
            if known.is_radius {
                add(Wrong::Diameter(name), Change::Times(2.0));
            } else if known.is_diameter {
                add(Wrong::Radius(name), Change::Times(0.5));
            }
        }
        methods
    }

    fn of(slip: Wrong, step: NodeId, change: Change, held: &Arc<[NodeId]>) -> Self {
        let held = Arc::clone(held);
        Self {
            slip,
            step,
            change,
            held,
        }
    }

    /// The formula that is taken in place of the right one, where it is one.
    pub fn formula(&self) -> Option<&Expr> {
        match &self.change {
            Change::Formula(_, expr) => Some(expr),
            _ => None,
        }
    }

    /// The values where this step is taken wrongly.
    ///
    /// # Errors
    ///
    /// Why the step has no value by this method, or none at all.
    pub(crate) fn evaluation<'g>(&self, right: &Evaluation<'g>) -> Result<Evaluation<'g>, Absent> {
        let step = self.step;
        let value = match &self.change {
            Change::Formula(computation, _) => right.by(step, computation)?,
            Change::Times(factor) => right.value(step)?.scaled(*factor),
            Change::Number(number) => Value::real(*number, 0.0),
        };
        let known = self.held.iter().filter(|node| **node != step);
        let known = known.filter_map(|node| Some((*node, right.value(*node).ok()?.clone())));
        let mut replaced = vec![(step, value)];
        replaced.extend(known);
        Ok(right.replacing(replaced))
    }

    /// The function that the step is where it is taken wrongly; none where it is not a function, or another step is wrong.
    pub(crate) fn function<'e, 'g>(
        &'g self,
        right: &'e Evaluation<'g>,
    ) -> Option<Function<'e, 'g>> {
        match &self.change {
            Change::Formula(computation, _) if right.graph().is_function(self.step) => {
                Some(right.function_by(self.step, computation))
            }
            _ => None,
        }
    }
}

/// The quantities that a quantity of cases is, one by one: what is written as the answer is one of them.
fn cases(graph: &Graph, key: NodeId) -> Vec<NodeId> {
    let (mut open, mut found) = (Vec::new(), Vec::new());
    open.extend(graph.expr(key));
    while let Some(expr) = open.pop() {
        match expr.kind() {
            Kind::If(_, then, otherwise) => open.extend([then, otherwise]),
            Kind::Name(name) => {
                let node = graph.find(name).filter(|node| !found.contains(node));
                found.extend(node);
                open.extend(node.and_then(|node| graph.expr(node)));
            }
            _ => {}
        }
    }
    found
}

/// The formulas and the data on the way to a quantity, in the order in which they were written, and what is asked on it.
fn way_to(
    graph: &Graph,
    key: NodeId,
    asked: &[NodeId],
) -> (Vec<NodeId>, Vec<NodeId>, Arc<[NodeId]>) {
    let (mut open, mut seen) = (vec![key], vec![key]);
    let (mut formulas, mut data, mut held) = (Vec::new(), Vec::new(), Vec::new());
    while let Some(node) = open.pop() {
        match graph.node(node).role {
            NodeRole::Parameter(_) => data.push(node),
            NodeRole::Quantity(_) | NodeRole::Formula(_) => formulas.push(node),
            // A model takes the data of its energies.
            NodeRole::Model(_) | NodeRole::Offered(_) => {}
        }
        for next in graph.needs(node) {
            if seen.contains(&next) {
                continue;
            }
            seen.push(next);
            if asked.contains(&next) {
                held.push(next);
            } else {
                open.push(next);
            }
        }
    }
    // The key's own formula first, then as they were written.
    crate::numerics::sort_by_key(&mut formulas, |node| (*node != key, *node));
    crate::numerics::sort_by(&mut data, Ord::cmp);
    (formulas, data, held.into())
}

/// The ways in which a formula is commonly taken wrongly, each with what it is then.
pub(crate) fn variations(label: &str, expr: &Expr) -> Vec<(Wrong, Expr)> {
    let step: Arc<str> = label.into();
    let mut found = Vec::new();
    vary(expr, &step, &mut |slip, changed| {
        if changed != *expr && !found.iter().any(|(_, known)| *known == changed) {
            found.push((slip, changed));
        }
    });
    found
}

/// Calls `take` with each variation of a formula.
fn vary(expr: &Expr, step: &Arc<str>, take: &mut dyn FnMut(Wrong, Expr)) {
    let term = |term: &Expr| Wrong::Term {
        step: Arc::clone(step),
        term: term.to_string(),
    };
    let factor = |factor: &Expr| Wrong::Factor {
        step: Arc::clone(step),
        factor: factor.to_string(),
    };
    match expr.kind() {
        Kind::Binary(Operator::Add, a, b) => {
            take(term(a), b.clone());
            take(term(b), a.clone());
        }
        Kind::Binary(Operator::Subtract, a, b) => {
            take(term(a), -b.clone());
            take(term(b), a.clone());
        }
        Kind::Binary(Operator::Multiply, a, b) => {
            for (own, other) in [(a, b), (b, a)] {
                if is_factor(own) {
                    take(factor(own), other.clone());
                }
            }
        }
        Kind::Binary(Operator::Divide, a, b) => {
            if is_factor(b) {
                take(factor(b), a.clone());
            }
            if is_factor(a) && !a.is_one() {
                take(factor(a), Expr::number(Rational::ONE) / b.clone());
            }
        }
        Kind::Call(function, arguments) => {
            let other = match function {
                Elementary::Sin => Some((Elementary::Cos, "sin", "cos")),
                Elementary::Cos => Some((Elementary::Sin, "cos", "sin")),
                _ => None,
            };
            if let Some((other, right, typed)) = other {
                let step = Arc::clone(step);
                let slip = Wrong::Circular { step, right, typed };
                take(slip, Expr::call(other, arguments.clone()));
            }
        }
        _ => {}
    }
    // Inside: one operand is varied, the others stay.
    let mut operands = Vec::new();
    match expr.kind() {
        // What decides between cases, bounds of searches and exponents are no steps of the work.
        Kind::If(_, a, b) => operands.extend([a, b]),
        Kind::Binary(Operator::Power, a, _) => operands.push(a),
        Kind::Binary(_, a, b) => operands.extend([a, b]),
        Kind::Negate(a) => operands.push(a),
        Kind::Call(_, all) | Kind::Array(all) => operands.extend(all),
        _ => {}
    }
    for operand in operands {
        vary(operand, step, &mut |slip, changed| {
            let put = |child: &Expr| -> Result<Expr, std::convert::Infallible> {
                Ok(if child.is_same(operand) {
                    changed.clone()
                } else {
                    child.clone()
                })
            };
            let Ok(whole) = expr.try_map_children(&mut { put });
            take(slip, whole);
        });
    }
}

/// Whether something is a factor that one forgets: a number other than one, or π.
fn is_factor(expr: &Expr) -> bool {
    match expr.kind() {
        Kind::Number(number) => *number != Rational::ONE && !number.is_zero(),
        Kind::Constant(constant) => *constant == Constant::Pi,
        Kind::Binary(Operator::Multiply | Operator::Divide, a, b) => {
            (is_factor(a) || a.is_one()) && (is_factor(b) || b.is_one())
        }
        _ => false,
    }
}
