//! What keeps follow-through honest.

use super::answers::Own;
use super::matrices::Matrices;
use crate::answer::AnswerKind;
use crate::expr::{Shape, Value};
use crate::instance::Instance;
use crate::numerics::EigenPair;
use crate::quantity::{Absent, NodeId};
use crate::seed::Seed;
use crate::solution::Solution;

/// An answer stands in as long as it is not further from the right one than by this factor.
const PLAUSIBLE: f64 = 10.0;

/// Values that differ by less than this part are the same.
const SAME: f64 = 1e-9;

/// Instances that are drawn to see whether a quantity can be negative.
const DRAWS: u64 = 8;

/// Whether two values are the same to rounding.
pub(crate) fn is_same(a: &Value, b: &Value) -> bool {
    let pairs = a.numbers().iter().zip(b.numbers());
    a.form() == b.form()
        && pairs
            .into_iter()
            .all(|(a, b)| (a - b).abs() <= SAME * a.abs().max(b.abs()))
}

/// Whether a value has the size of the right one, entry by entry, and not a sign that the quantity never has.
pub(crate) fn is_plausible(
    solution: &Solution<'_>,
    node: NodeId,
    own: &Value,
    right: &Value,
) -> bool {
    match right.shape() {
        Shape::Matrix(rows, columns) if rows == columns => return is_matrix_like(own, right, rows),
        Shape::Vector(_) if is_shape(solution, node) => return is_shape_like(own, right),
        _ => {}
    }
    let entries = 0..right.shape().len();
    let are_near = entries.clone().all(|entry| {
        let (own, right) = (own.entry(entry).abs(), right.entry(entry).abs());
        own.is_finite() && own >= right / PLAUSIBLE && own <= right * PLAUSIBLE && right > 0.0
    });
    are_near
        && (entries
            .into_iter()
            .all(|entry| own.entry(entry).re * right.entry(entry).re >= 0.0)
            || has_any_sign(solution, node))
}

/// Whether a shape is what a part asks for in this quantity.
fn is_shape(solution: &Solution<'_>, node: NodeId) -> bool {
    let mut parts = solution.template().parts.iter();
    parts.any(|part| part.answer.kind() == AnswerKind::ModeShape && part.answer.keys() == [node])
}

/// Whether a shape has the size of another, whatever its components are; which of them vanish is a slip like others.
fn is_shape_like(own: &Value, right: &Value) -> bool {
    has_size(length(own), length(right))
        && own.numbers().iter().filter(|own| **own != 0.0).count() > 1
}

/// The length of a list of numbers.
fn length(value: &Value) -> f64 {
    value
        .numbers()
        .iter()
        .map(|number| number * number)
        .sum::<f64>()
        .sqrt()
}

fn has_size(own: f64, right: f64) -> bool {
    own.is_finite() && right > 0.0 && own >= right / PLAUSIBLE && own <= right * PLAUSIBLE
}

/// Whether a square matrix has a diagonal of the size and signs of another, entries beside it that are not out of
/// all proportion, and couples each coordinate that the other couples.
fn is_matrix_like(own: &Value, right: &Value, size: usize) -> bool {
    let at = |value: &Value, row: usize, column: usize| value.numbers()[row * size + column];
    let diagonal = (0..size).all(|place| {
        let (own, right) = (at(own, place, place), at(right, place, place));
        own * right > 0.0 && has_size(own.abs(), right.abs())
    });
    let is_bounded = |row: usize, column: usize| {
        let scale = (at(right, row, row) * at(right, column, column))
            .abs()
            .sqrt();
        at(own, row, column).abs() <= PLAUSIBLE * scale
    };
    let couples = |value: &Value, row: usize| {
        (0..size).any(|column| column != row && at(value, row, column) != 0.0)
    };
    diagonal
        && (0..size).all(|row| (0..size).all(|column| is_bounded(row, column)))
        && (0..size).all(|row| couples(own, row) || !couples(right, row))
}

/// Whether own matrices ask as much as the right ones: coordinates stay coupled, frequencies have their sizes, and none
/// of them vanishes that should not.
pub(crate) fn is_fair_system(
    right: &Matrices,
    own: &Matrices,
    due: &[EigenPair],
    found: &[EigenPair],
) -> bool {
    /// Parts of the largest eigenvalue below which one is zero.
    const ZERO: f64 = 1e-9;
    let size = right.size();
    let couples = |of: &Matrices, row: usize| {
        let (mass, stiffness) = (of.mass(), of.stiffness());
        (0..size).any(|column| {
            let place = row * size + column;
            column != row && (mass[place] != 0.0 || stiffness[place] != 0.0)
        })
    };
    let largest = due.last().map_or(0.0, |mode| mode.value);
    (0..size).all(|row| couples(own, row) || !couples(right, row))
        && due.iter().zip(found).all(|(due, found)| {
            if due.value.abs() <= ZERO * largest {
                return found.value.abs() <= ZERO * largest;
            }
            found.value > 0.0 && has_size(found.value.sqrt(), due.value.sqrt())
        })
}

/// Whether a quantity is negative for some data of the item and positive for others.
fn has_any_sign(solution: &Solution<'_>, node: NodeId) -> bool {
    let is_negative: Vec<bool> = (0..DRAWS)
        .filter_map(|seed| Instance::draw(solution.template(), Seed::new(seed)).ok())
        .filter_map(|instance| {
            let value = instance
                .evaluation()
                .value(node)
                .ok()?
                .numbers()
                .first()
                .copied()?;
            (value != 0.0).then_some(value < 0.0)
        })
        .collect();
    is_negative.contains(&true) && is_negative.contains(&false)
}

/// Whether a key with answers of one's own in it asks as much as the right key does: it exists, it is not zero,
/// it is not one of the numbers at hand, and what it depends on is as much as before.
///
/// `right` has the right values in place of the same quantities.
pub(crate) fn is_fair(
    right: &Solution<'_>,
    other: &Solution<'_>,
    keys: &[NodeId],
    own: &[&Own],
) -> bool {
    keys.iter().all(|key| {
        match (
            right.evaluation().value(*key),
            other.evaluation().value(*key),
        ) {
            (Ok(due), Ok(found)) => {
                let is_work = match (due.as_real(), found.as_real()) {
                    (Some(due), Some(found)) => is_work(right, other, *key, due, found, own),
                    _ => true,
                };
                is_work && (is_zero(due) || !is_zero(found))
            }
            // A function has no number, it is marked as it is.
            (Err(Absent::Function { .. }), Err(Absent::Function { .. })) => true,
            _ => false,
        }
    })
}

fn is_zero(value: &Value) -> bool {
    value.form() != crate::expr::Form::BOOLEAN
        && value.numbers().iter().all(|number| *number == 0.0)
}

fn is_work(
    right: &Solution<'_>,
    other: &Solution<'_>,
    key: NodeId,
    due: f64,
    found: f64,
    own: &[&Own],
) -> bool {
    // The value of one's own formula is work, unless the formula is a datum.
    if own.iter().any(|own| own.node == key) {
        return !is_at_hand(right, other, key, due, found, &[]);
    }
    !is_at_hand(right, other, key, due, found, own)
        && still_depends(right, other, key, due, found, own)
}

/// Whether the key is a datum or one of the answers, where the right key is not.
fn is_at_hand(
    right: &Solution<'_>,
    other: &Solution<'_>,
    key: NodeId,
    due: f64,
    found: f64,
    own: &[&Own],
) -> bool {
    let graph = &right.template().graph;
    let has_kind = |node: NodeId| match (graph.kind(node), graph.kind(key)) {
        (Some(a), Some(b)) => a.dimension() == b.dimension(),
        _ => false,
    };
    let is_same = |a: f64, b: f64| (a.abs() - b.abs()).abs() <= SAME * b.abs();
    let at_hand = parameters(right)
        .chain(own.iter().map(|own| own.node))
        .filter(|node| has_kind(*node));
    let values = at_hand.filter_map(|node| {
        Some((
            right.evaluation().real(node).ok()?,
            other.evaluation().real(node).ok()?,
        ))
    });
    values
        .into_iter()
        .any(|(old, new)| is_same(found, new) && !is_same(due, old))
}

/// Whether the key still moves with all data and answers with which the right one moves.
fn still_depends(
    right: &Solution<'_>,
    other: &Solution<'_>,
    key: NodeId,
    due: f64,
    found: f64,
    own: &[&Own],
) -> bool {
    /// A share of one in twenty is felt, a hundredth of that is not.
    const FELT: f64 = 0.05;
    // A dependence that is lost leaves rounding alone, 1e-11 over the step below.
    const LOST: f64 = 0.0005;
    let mut inputs = parameters(right).chain(own.iter().map(|own| own.node));
    inputs.all(|input| {
        elasticity(right, key, due, input) < FELT || elasticity(other, key, found, input) >= LOST
    })
}

/// By how much the key moves with an input, as a ratio of relative changes.
fn elasticity(solution: &Solution<'_>, key: NodeId, value: f64, input: NodeId) -> f64 {
    // Rounding leaves 1e-11 of a slope over this step, and its curvature 1e-5: both are far below what
    // decides.
    const STEP: f64 = 1e-5;
    let moved = || {
        let given = solution.evaluation().real(input).ok()?;
        let moved = Value::real(given * (1.0 + STEP), 0.0);
        solution
            .evaluation()
            .replacing(vec![(input, moved)])
            .real(key)
            .ok()
    };
    moved().map_or(0.0, |moved| ((moved - value) / (STEP * value)).abs())
}

fn parameters<'s>(solution: &'s Solution<'_>) -> impl Iterator<Item = NodeId> + use<'s> {
    let template = solution.template();
    template
        .parameters
        .iter()
        .filter_map(|parameter| template.graph.find(&parameter.name))
}
