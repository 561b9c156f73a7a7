//! What the answers to earlier parts stand for.

use super::{driven, guard, inside, oscillator, related, shapes, system};
use crate::answer::{AnswerKind, Answered, Marking, Reading, Reason, Verdict};
use crate::expr::{
    Equation, Expr, Field, Name, Precise, Program, Shape, Slots, Substitution, Value, Workspace,
};
use crate::math::Math;
use crate::numerics::{SortedMap, ascending};
use crate::quantity::{Evaluation, Graph, NodeId};
use crate::solution::Solution;

/// An answer of a student's own, in place of the right one.
#[derive(Clone, Debug)]
pub(crate) struct Own {
    /// The quantity that it stands for.
    pub(crate) node: NodeId,
    pub(crate) name: Name,
    pub(crate) symbol: Math,
    /// Where it comes from.
    pub(crate) source: Source,
    pub(crate) value: Value,
    /// The same as a formula in the data, if it was one.
    pub(crate) formula: Option<Expr>,
}

/// Where an answer comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// It was given to a part of this kind.
    Part(AnswerKind),
    /// It follows from equations.
    Equation,
    /// It follows from an answer to another quantity.
    Related,
}

/// What was answered to the earlier parts, by quantity.
pub(crate) struct Answers {
    /// Right answers, with the right values.
    right: SortedMap<NodeId, Value>,
    own: Vec<Own>,
}

impl Answers {
    /// What the responses with these markings stand for, and what follows from them for the part at a place; of several
    /// for one quantity the last one.
    pub(crate) fn given<'m>(
        solution: &Solution<'_>,
        earlier: impl Iterator<Item = (usize, &'m Marking)>,
        later: usize,
    ) -> Self {
        let mut answers = Self {
            right: SortedMap::new(),
            own: Vec::new(),
        };
        let (mut equations, mut are_right) = (Vec::new(), true);
        for (place, marking) in earlier {
            let part = &solution.template().parts[place];
            let kind = part.answer.kind();
            let Some(reading) = marking
                .reading
                .as_ref()
                .filter(|_| has_dimension(solution, place, marking))
            else {
                continue;
            };
            let is_right = marking.verdict == Verdict::Right
                && !marking.reasons().contains(&Reason::FollowThrough);
            if kind == AnswerKind::Equation {
                if let Answered::Equations(typed) = &reading.answered {
                    equations.extend_from_slice(typed);
                    if let ([one], false) = (&typed[..], is_right) {
                        answers.equation(solution, one);
                    }
                }
                are_right &= is_right;
                continue;
            }
            let [node] = part.answer.keys()[..] else {
                continue;
            };
            if is_right {
                answers.add_right(solution, node);
            } else if kind == AnswerKind::ModeShape {
                if let Some(value) = shapes::value(solution, node, &reading.answered.si()) {
                    answers.add(solution, node, Source::Part(kind), value, None);
                }
            } else {
                answers.add_own(solution, node, kind, reading);
            }
        }
        if are_right {
            equations.clear();
        }
        // In this order, since what one of them finds the next ones leave alone: matrices say more than one
        // number does, and formulas that have to be searched come last.
        system::extend(solution, &mut answers, &equations);
        shapes::extend(solution, &mut answers);
        related::extend(solution, &mut answers);
        driven::extend(solution, &mut answers, &equations);
        inside::extend(solution, &mut answers, later);
        answers
    }

    pub(crate) fn own(&self) -> impl Iterator<Item = &Own> {
        self.own.iter()
    }

    /// Whether a quantity was answered, or follows from what was.
    pub(crate) fn has(&self, node: NodeId) -> bool {
        self.right.contains_key(&node) || self.last(node).is_some()
    }

    /// The last answer to a quantity that is not the right one.
    pub(crate) fn last(&self, node: NodeId) -> Option<&Own> {
        self.own.iter().rev().find(|own| own.node == node)
    }

    /// The right formula of a quantity, in the data.
    pub(crate) fn right_formula(solution: &Solution<'_>, node: NodeId) -> Option<Expr> {
        let graph = &solution.template().graph;
        in_data(graph.expr(node)?, graph)
    }

    /// Adds what follows for a quantity from an answer to another one.
    pub(crate) fn add_related(
        &mut self,
        solution: &Solution<'_>,
        node: NodeId,
        source: &Own,
        value: Value,
        formula: Option<Expr>,
    ) {
        self.add_following(solution, node, Some(source), value, formula);
    }

    /// Adds what follows for a quantity from an answer to another one, or from equations.
    pub(crate) fn add_following(
        &mut self,
        solution: &Solution<'_>,
        node: NodeId,
        source: Option<&Own>,
        value: Value,
        formula: Option<Expr>,
    ) {
        let count = self.own.len();
        let source = source.filter(|source| source.source != Source::Equation);
        let from = source.map_or(Source::Equation, |_| Source::Related);
        self.add(solution, node, from, value, formula);
        // It is told to go on from the answer that was given.
        if let (Some(own), Some(source)) = (self.own.get_mut(count), source) {
            own.symbol = source.symbol.clone();
        }
    }

    /// The right values of the quantities that were answered rightly, and of some others.
    pub(crate) fn right_values(
        &self,
        solution: &Solution<'_>,
        others: &[&Own],
    ) -> Vec<(NodeId, Value)> {
        let others = others.iter().filter_map(|own| {
            Some((
                own.node,
                solution.evaluation().value(own.node).ok()?.clone(),
            ))
        });
        others.chain(self.right.clone()).collect()
    }

    /// The student's own values of some quantities, and the right ones of those that were answered rightly.
    pub(crate) fn values(&self, own: &[&Own]) -> Vec<(NodeId, Value)> {
        // The last answer to a quantity comes first, and the first value for a node stands.
        // A student who corrected an answer goes on from the last one.
        let own = own.iter().rev().map(|own| (own.node, own.value.clone()));
        own.chain(self.right.clone()).collect()
    }

    /// The student's own formulas of some quantities.
    pub(crate) fn formulas(own: &[&Own]) -> SortedMap<Name, Expr> {
        let formulas = own
            .iter()
            .filter_map(|own| Some((own.name.clone(), own.formula.clone()?)));
        formulas.collect()
    }

    fn add_right(&mut self, solution: &Solution<'_>, node: NodeId) {
        self.own.retain(|own| own.node != node);
        if let Ok(value) = solution.evaluation().value(node) {
            self.right.insert(node, value.clone());
        }
    }

    fn add_own(
        &mut self,
        solution: &Solution<'_>,
        node: NodeId,
        kind: AnswerKind,
        reading: &Reading,
    ) {
        let Ok(right) = solution.evaluation().value(node) else {
            return;
        };
        let si = reading.answered.si();
        let (formula, value) = if si.is_empty() {
            let graph = &solution.template().graph;
            let typed = reading.answered.formula();
            let formula = typed.and_then(|typed| in_data(&typed, graph));
            let value = formula
                .as_ref()
                .and_then(|formula| value(formula, node, solution.evaluation()));
            (formula, value)
        } else {
            (None, as_written(right, &si))
        };
        if let Some(value) = value {
            self.add(solution, node, Source::Part(kind), value, formula);
        }
    }

    /// All that follows from an equation of motion of one's own.
    fn equation(&mut self, solution: &Solution<'_>, equation: &Equation) {
        for (node, formula) in oscillator::quantities(solution.template(), equation) {
            let formula = in_data(&formula, &solution.template().graph);
            let value = formula
                .as_ref()
                .and_then(|formula| value(formula, node, solution.evaluation()));
            if let Some(value) = value {
                self.add(solution, node, Source::Equation, value, formula);
            }
        }
    }

    fn add(
        &mut self,
        solution: &Solution<'_>,
        node: NodeId,
        source: Source,
        value: Value,
        formula: Option<Expr>,
    ) {
        let Some(info) = solution
            .template()
            .info(node)
            .filter(|info| info.parameter.is_none())
        else {
            return;
        };
        let Ok(right) = solution.evaluation().value(node) else {
            return;
        };
        if guard::is_same(&value, right) {
            self.right.insert(node, right.clone());
        } else if guard::is_plausible(solution, node, &value, right) {
            self.right.remove(&node);
            self.own.push(Own {
                node,
                name: info.name.clone(),
                symbol: Math::clone(&info.symbol),
                source,
                value,
                formula,
            });
        }
    }
}

/// Whether a response had the dimension that was asked.
fn has_dimension(solution: &Solution<'_>, place: usize, marking: &Marking) -> bool {
    let mistakes = &solution.template().parts[place].mistakes;
    marking.reasons().iter().all(|reason| match reason {
        Reason::Dimension => false,
        Reason::Mistake(number) => mistakes
            .get(*number)
            .is_none_or(|mistake| mistake.unit.is_none()),
        _ => true,
    })
}

/// Numbers in the form of a value; those of an unordered list in the order of its own.
fn as_written(right: &Value, si: &[f64]) -> Option<Value> {
    let mut numbers = si.to_vec();
    if matches!(
        (right.form().field, right.shape()),
        (Field::Real, Shape::Vector(_))
    ) && si.len() == right.numbers().len()
    {
        let mut sorted = numbers.clone();
        crate::numerics::sort_by(&mut sorted, f64::total_cmp);
        ascending(si.len(), &|place| right.numbers()[place])
            .into_iter()
            .zip(sorted)
            .for_each(|(place, number)| numbers[place] = number);
    }
    let bounds = vec![0.0; numbers.len()];
    Value::new(right.form(), numbers, bounds)
}

/// A formula in the data of the item alone.
pub(crate) fn in_data(formula: &Expr, graph: &Graph) -> Option<Expr> {
    // Each step goes down one level of the graph, which has no cycles.
    const MAX_STEPS: usize = 20;
    let mut formula = formula.clone();
    for _ in 0..MAX_STEPS {
        let quantities = formula.names().free.into_iter().filter_map(|variable| {
            let expr = graph.expr(graph.find(&variable.name)?)?;
            Some((variable.name, expr.clone()))
        });
        let put = quantities.collect::<Vec<_>>();
        if put.is_empty() {
            return Some(formula);
        }
        let put = put
            .into_iter()
            .fold(Substitution::new(), |put, (name, expr)| {
                put.with(name, expr)
            });
        formula = put.apply(&formula).ok()?;
    }
    None
}

/// The value that a formula in the data has, if it has the dimension of a quantity.
fn value(formula: &Expr, node: NodeId, evaluation: &Evaluation<'_>) -> Option<Value> {
    let graph = evaluation.graph();
    let kind = graph.kind(node)?;
    formula.check(graph).ok().filter(|found| found.fits(kind))?;
    let value = computed(formula, evaluation)?;
    (value.form() == evaluation.value(node).ok()?.form()).then_some(value)
}

/// The number that a formula in the data is.
pub(crate) fn number(formula: &Expr, evaluation: &Evaluation<'_>) -> Option<f64> {
    computed(formula, evaluation)?.as_real()
}

fn computed(formula: &Expr, evaluation: &Evaluation<'_>) -> Option<Value> {
    let graph = evaluation.graph();
    let names: Vec<Name> = formula
        .names()
        .free
        .into_iter()
        .map(|variable| variable.name)
        .collect();
    let texts: Vec<&str> = names.iter().map(Name::as_str).collect();
    let program = Program::compile(formula, &Slots(&texts)).ok()?;
    let data = names
        .iter()
        .map(|name| Some(Precise::exact(evaluation.real(graph.find(name)?).ok()?)))
        .collect::<Option<Vec<_>>>()?;
    program.evaluate(&data[..], &mut Workspace::default()).ok()
}
