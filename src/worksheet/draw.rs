//! Drawing a sheet: which questions a variant has, their data and their points.

use super::marks::Scored;
use super::plan::{Plan, Planned};
use super::sheet::{Sheet, SheetQuestion, Student, is_one_group};
use crate::bank::{Part, Template, share_in_group, share_out};
use crate::instance::{Instance, InstanceError};
use crate::numerics::Rational;
use crate::seed::{Seed, Streams, Variant};
use crate::solution::Solution;
use crate::unit::DecimalMark;

/// Why a run cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SheetError {
    /// An item has no data that meet its constraints.
    #[error(transparent)]
    Instance(#[from] InstanceError),
    /// A further sheet of a student always has something of the first one.
    #[error(
        "no data were found in {attempts} tries that the first sheet does not have; most often {datum} is the same"
    )]
    Shared {
        /// How many seeds were tried.
        attempts: u64,
        /// The datum that was on the first sheet most often, with its item.
        datum: String,
    },
    /// No suitable variant was found.
    #[error("no suitable variant was found in {attempts} tries; the last: {reason}")]
    NoVariant {
        /// How many seeds were tried.
        attempts: u64,
        /// Why the last one is not suitable.
        reason: String,
    },
}

impl<'c> Sheet<'c> {
    /// The sheet of a variant: a pure function of plan and variant.
    ///
    /// # Errors
    ///
    /// [`SheetError::Instance`].
    pub fn draw(
        plan: &Plan<'c>,
        variant: Variant,
        student: Option<Student>,
    ) -> Result<Self, SheetError> {
        let mark = DecimalMark::of_char(plan.blueprint.decimal).unwrap_or_default();
        let order = order(plan, variant);
        let mut taken: Vec<&Template> = Vec::new();
        let mut questions = Vec::new();
        for place in order {
            let planned = &plan.questions[place];
            let template = pick(planned, place, variant, &taken);
            taken.push(template);
            // By the item and not by its place: a question that is moved keeps its data.
            let seed = variant.item(template.id.as_str(), plan.secret.as_ref());
            let set: Vec<(&str, &str)> = planned
                .set
                .iter()
                .map(|(name, value)| (name.as_str(), value.as_str()))
                .collect();
            let instance = Instance::of(template, Some(seed), &set)?;
            let number = questions.len() + 1;
            questions.push(question(
                number,
                place,
                planned,
                Solution::with_mark(instance, mark),
            ));
        }
        let marks = plan.blueprint.marks.clone().unwrap_or_default();
        let scored = questions.iter().map(|question| Scored {
            points: Rational::ZERO,
            open: Rational::ZERO,
            max: question.total(),
            bonus: question.bonus,
            section: &question.section,
        });
        let points = marks.total(&scored.collect::<Vec<_>>()).max;
        Ok(Self {
            variant,
            student,
            questions,
            points,
            best: marks.best,
        })
    }
}

/// The order of the questions, as places in the plan.
fn order(plan: &Plan<'_>, variant: Variant) -> Vec<usize> {
    let count = plan.questions.len();
    if plan.blueprint.shuffle {
        // A stream of its own, so that the order changes no data.
        return Streams::of(Seed::new(variant.number()), "order")
            .named("questions")
            .permutation(count);
    }
    (0..count).collect()
}

/// The item of a question; of several candidates one that the sheet does not have yet.
fn pick<'c>(
    planned: &Planned<'c>,
    place: usize,
    variant: Variant,
    taken: &[&Template],
) -> &'c Template {
    if let [one] = planned.candidates[..] {
        return one;
    }
    let order = Streams::of(Seed::new(variant.number()), "order")
        .named(&format!("pick {place}"))
        .permutation(planned.candidates.len());
    planned.candidates[*order
        .iter()
        .find(|at| {
            taken
                .iter()
                .all(|item| item.id != planned.candidates[**at].id)
        })
        .unwrap_or(&order[0])]
}

/// A question with its parts and their points.
fn question<'c>(
    number: usize,
    place: usize,
    planned: &Planned<'c>,
    solution: Solution<'c>,
) -> SheetQuestion<'c> {
    let parts = asked(planned, &solution);
    let points = points_of(planned, solution.template(), &parts);
    let spaces = parts
        .iter()
        .map(|place| planned.space(&solution.template().parts[*place]))
        .collect();
    SheetQuestion {
        number,
        place,
        solution,
        parts,
        points,
        bonus: planned.bonus,
        section: planned.section.clone(),
        spaces,
    }
}

/// The points of the parts of an item that are asked.
///
/// Those of a question are shared out over its parts, where a group counts as one; those of a group over its blanks.
pub(crate) fn points_of(
    planned: &Planned<'_>,
    template: &Template,
    parts: &[usize],
) -> Vec<Rational> {
    let all: Vec<&Part> = parts.iter().map(|place| &template.parts[*place]).collect();
    let named = |part: &Part| {
        let mut named = planned.part_points.iter();
        named.find(|(name, _)| part.is_named(name))
    };
    // Parts among which something is shared: those of one name, else those of one group, else a part alone.
    let belong = |a: &&Part, b: &&Part| match (named(a), named(b)) {
        (None, None) => is_one_group(a, b),
        (Some((name, _)), Some((other, _))) => name == other,
        _ => false,
    };
    let weights = |unit: &[&Part]| unit.iter().map(|part| part.points).collect::<Vec<_>>();
    let units: Vec<&[&Part]> = all.chunk_by(belong).collect();
    let fixed: Vec<Option<Rational>> = units
        .iter()
        .map(|unit| named(unit[0]).map(|(_, points)| *points))
        .collect();
    let others = units.iter().zip(&fixed).filter(|(_, own)| own.is_none());
    let others: Vec<Rational> = others
        .filter_map(|(unit, _)| Rational::sum(&weights(unit)))
        .collect();
    let given: Vec<Rational> = fixed.iter().copied().flatten().collect();
    let rest = planned
        .points
        .and_then(|whole| whole.checked_sub(Rational::sum(&given)?));
    let mut shares = rest.map(|rest| share_out(rest, &others).into_iter());
    let points = units.iter().zip(&fixed).flat_map(|(unit, fixed)| {
        let whole = fixed.or_else(|| {
            shares
                .as_mut()
                .map(|shares| shares.next().unwrap_or(Rational::ZERO))
        });
        match whole {
            Some(whole) => share_in_group(whole, &weights(unit)),
            None => weights(unit),
        }
    });
    points.collect()
}

/// The parts that a question asks for these data, as places in the item.
pub(crate) fn asked(planned: &Planned<'_>, solution: &Solution<'_>) -> Vec<usize> {
    let all = &solution.template().parts;
    (0..all.len())
        .filter(|place| planned.asks(&all[*place]) && solution.asks(*place))
        .collect()
}
