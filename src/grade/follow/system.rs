//! What follows from a student's own equations of motion, or matrices, of several coordinates.
//!
//! The equations stand for the rows of M, C and K. Each is scaled so that it agrees with one of the right rows in as
//! many entries as can be; a row that was not answered is the right one. From these matrices follow the natural
//! frequencies and shapes, and all quantities whose formula or second route is written in them.

use std::sync::Arc;

use super::answers::{Answers, Own, Source, in_data, number};
use super::guard;
use super::matrices::{Matrices, MatrixEntry};
use crate::answer::AnswerKind;
use crate::expr::{Equation, Expr, Function, Path, Substitution, Value, Variable, differentiate};
use crate::mechanics::{Model, Quantity};
use crate::numerics::{EigenPair, pencil};
use crate::quantity::{Evaluation, NodeId};
use crate::solution::Solution;

/// Adds what follows from own equations and matrices for the quantities that were not answered.
pub(crate) fn extend(solution: &Solution<'_>, answers: &mut Answers, equations: &[Equation]) {
    for model in models(solution) {
        let Some(right) = Matrices::of_model(&model, solution) else {
            continue;
        };
        let found = from_equations(&model, &right, solution, equations)
            .map(|own| (own, None))
            .or_else(|| from_answers(&model, &right, solution, answers));
        if let Some((own, source)) = found {
            add(solution, answers, &model, &right, &own, source.as_ref());
        }
    }
}

/// The models of several coordinates of which something is asked.
fn models(solution: &Solution<'_>) -> Vec<Arc<Model>> {
    let graph = &solution.template().graph;
    let mut models: Vec<Arc<Model>> = Vec::new();
    for (path, _) in graph.asked() {
        let Some((model, _)) = graph.offered(path) else {
            continue;
        };
        let is_new = models.iter().all(|own| !Arc::ptr_eq(own, model));
        if is_new && model.degrees_of_freedom() > 1 {
            models.push(Arc::clone(model));
        }
    }
    models
}

/// The matrices that equations stand for.
fn from_equations(
    model: &Model,
    right: &Matrices,
    solution: &Solution<'_>,
    equations: &[Equation],
) -> Option<Matrices> {
    let mut own = right.clone();
    let mut taken = vec![false; right.size()];
    for equation in equations {
        let Some(row) = row(model, equation, solution) else {
            continue;
        };
        let best = (0..right.size())
            .filter(|at| !taken[*at])
            .filter_map(|at| Some((at, right.likeness(at, &row)?)))
            // Of rows that agree as well the first: equations are mostly given in the order of the
            // coordinates.
            .max_by_key(|(at, likeness)| (likeness.count, usize::MAX - at));
        let (at, likeness) = best?;
        taken[at] = true;
        own.set_row(at, row.iter().map(|entry| likeness.scaled(entry)).collect());
    }
    taken.contains(&true).then_some(own)
}

/// The coefficients of an equation, accelerations, velocities, then positions; none where they are not constant.
fn row(model: &Model, equation: &Equation, solution: &Solution<'_>) -> Option<Vec<MatrixEntry>> {
    let difference = equation.difference();
    let coordinates = model.coordinates();
    let mut row = Vec::new();
    for order in [2, 1, 0] {
        for coordinate in coordinates {
            let slope = differentiate(&difference, Variable::of(coordinate, order)).ok()?;
            if slope.reaches(|name| coordinates.contains(name) || name.as_str() == "t") {
                return None;
            }
            let formula = in_data(&slope, &solution.template().graph)?;
            let value = number(&formula, solution.evaluation())?;
            row.push(MatrixEntry {
                value,
                formula: Some(formula),
            });
        }
    }
    // Without an acceleration it is a constraint or a balance at rest.
    let has_inertia = row[..coordinates.len()]
        .iter()
        .any(|entry| entry.value != 0.0);
    has_inertia.then_some(row)
}

/// The matrices with those that were answered in place of the right ones, and the last of these answers.
fn from_answers(
    model: &Arc<Model>,
    right: &Matrices,
    solution: &Solution<'_>,
    answers: &Answers,
) -> Option<(Matrices, Option<Own>)> {
    let graph = &solution.template().graph;
    let (mut own, mut source) = (right.clone(), None);
    for answer in answers
        .own()
        .filter(|own| own.source == Source::Part(AnswerKind::Matrix))
    {
        let info = solution.template().info(answer.node)?;
        let mut routes = [Some(answer.node), info.verify].into_iter().flatten();
        let quantity = routes.find_map(|route| {
            let crate::expr::Kind::Path(path) = graph.expr(route)?.kind() else {
                return None;
            };
            let (of, quantity) = graph.offered(path)?;
            Arc::ptr_eq(of, model).then_some(quantity)
        });
        if let Some(quantity) = quantity
            && own.set(quantity, answer)
        {
            source = Some(answer.clone());
        }
    }
    source.map(|source| (own, Some(source)))
}

/// Adds the quantities that the matrices give.
fn add(
    solution: &Solution<'_>,
    answers: &mut Answers,
    model: &Arc<Model>,
    right: &Matrices,
    own: &Matrices,
    source: Option<&Own>,
) {
    let modes = |of: &Matrices| pencil(&of.mass(), &of.stiffness());
    let (Some(due), Some(found)) = (modes(right), modes(own)) else {
        return;
    };
    if !guard::is_fair_system(right, own, &due, &found) {
        return;
    }
    let own = Derived {
        matrices: own,
        modes: &found,
    };
    let graph = &solution.template().graph;
    let offered: Vec<(&Path, NodeId, Quantity)> = graph
        .asked()
        .filter_map(|(path, node)| {
            let (of, quantity) = graph.offered(path)?;
            Arc::ptr_eq(of, model).then_some((path, node, quantity))
        })
        .collect();
    let values = offered.iter().filter_map(|(_, node, quantity)| {
        let form = solution.evaluation().value(*node).ok()?.form();
        let numbers = own.numbers(*quantity)?;
        let bounds = vec![0.0; numbers.len()];
        Some((*node, Value::new(form, numbers, bounds)?))
    });
    let evaluation = solution.evaluation().replacing(values.collect());
    let mut put = Substitution::new();
    for (path, _, quantity) in &offered {
        if let Some(formula) = own.formula(*quantity) {
            put = put.with_path((*path).clone(), formula);
        }
    }
    let routes = solution.template().quantities.iter();
    let routes: Vec<(NodeId, NodeId)> = routes
        .flat_map(|(node, info)| {
            let routes = [Some(*node), info.verify].into_iter().flatten();
            routes.map(|route| (*node, route))
        })
        .collect();
    for (node, route) in routes {
        let Some(value) = changed(solution, &evaluation, route) else {
            continue;
        };
        if answers.has(node) {
            continue;
        }
        let formula = graph
            .expr(route)
            .and_then(|expr| put.apply(expr).ok())
            .filter(|expr| expr.names().paths.is_empty())
            .and_then(|expr| in_data(&expr, graph));
        answers.add_following(solution, node, source, value, formula);
    }
}

/// The value of a route, if it is another one than the right one.
pub(crate) fn changed(
    solution: &Solution<'_>,
    other: &Evaluation<'_>,
    route: NodeId,
) -> Option<Value> {
    let due = solution.evaluation().value(route).ok()?;
    let found = other.value(route).ok()?;
    (due.form() == found.form() && !guard::is_same(due, found)).then(|| found.clone())
}

/// Matrices with what follows from them.
struct Derived<'a> {
    matrices: &'a Matrices,
    modes: &'a [EigenPair],
}

impl Derived<'_> {
    fn numbers(&self, quantity: Quantity) -> Option<Vec<f64>> {
        Some(match quantity {
            Quantity::MassMatrix => self.matrices.mass(),
            Quantity::DampingMatrix => self.matrices.damping(),
            Quantity::StiffnessMatrix => self.matrices.stiffness(),
            Quantity::NaturalAngularFrequencies => self
                .modes
                .iter()
                .map(|mode| frequency(mode.value))
                .collect(),
            Quantity::ModeShapes => {
                let mass = self.matrices.mass();
                let shapes = self
                    .modes
                    .iter()
                    .map(|mode| normalized(&mode.vector, &mass));
                shapes.collect::<Option<Vec<_>>>()?.concat()
            }
            _ => return None,
        })
    }

    fn formula(&self, quantity: Quantity) -> Option<Expr> {
        let [mass, damping, stiffness] = self.matrices.formulas()?;
        let size = self.matrices.size();
        let rows = |entries: &[Expr]| {
            Expr::array(entries.chunks(size).map(Expr::array).collect::<Vec<_>>())
        };
        match quantity {
            Quantity::MassMatrix => Some(rows(&mass)),
            Quantity::DampingMatrix => Some(rows(&damping)),
            Quantity::StiffnessMatrix => Some(rows(&stiffness)),
            Quantity::NaturalAngularFrequencies => frequencies_of_two(&mass, &stiffness),
            _ => None,
        }
    }
}

fn frequency(square: f64) -> f64 {
    // Rounding may leave the square of a rigid motion below zero.
    square.max(0.0).sqrt()
}

/// A shape with unit modal mass, its first component that is not zero positive.
pub(crate) fn normalized(shape: &[f64], mass: &[f64]) -> Option<Vec<f64>> {
    // What rounding leaves of a node of the shape.
    const ZERO: f64 = 1e-9;
    let rows = mass.chunks(shape.len());
    let modal: f64 = rows
        .zip(shape)
        .map(|(row, own)| own * row.iter().zip(shape).map(|(a, b)| a * b).sum::<f64>())
        .sum();
    let largest = shape.iter().map(|own| own.abs()).fold(0.0, f64::max);
    let first = shape.iter().find(|own| own.abs() > ZERO * largest)?;
    let scale = modal.sqrt() * first.signum();
    (mass.len() == shape.len() * shape.len() && modal > 0.0)
        .then(|| shape.iter().map(|own| own / scale).collect())
}

/// The roots of det(K − ω² M) = 0 for two coordinates, ascending.
fn frequencies_of_two(mass: &[Expr], stiffness: &[Expr]) -> Option<Expr> {
    let [m11, m12, m21, m22] = mass else {
        return None;
    };
    let [k11, k12, k21, k22] = stiffness else {
        return None;
    };
    let a = m11 * m22 - m12 * m21;
    let b = m11 * k22 + m22 * k11 - m12 * k21 - m21 * k12;
    let c = k11 * k22 - k12 * k21;
    let sqrt = |inner: Expr| Expr::call(Function::Sqrt, vec![inner]);
    let root = sqrt(b.clone().squared() - Expr::number(4) * a.clone() * c);
    let twice = Expr::number(2) * a;
    let lower = sqrt((b.clone() - root.clone()) / twice.clone());
    Some(Expr::array(vec![lower, sqrt((b + root) / twice)]))
}
