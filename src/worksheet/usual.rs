//! What most instances of an item have in common, so that the variants of a sheet can be alike.

use std::collections::BTreeMap;

use super::draw::asked;
use super::plan::Planned;
use super::sheet::SheetQuestion;
use crate::bank::Template;
use crate::instance::Instance;
use crate::seed::Seed;
use crate::solution::Solution;

/// What most instances of an item have in common.
#[derive(Debug, Default)]
pub(crate) struct Usual {
    /// The parts that are asked, as places in the item.
    parts: Vec<usize>,
    /// The usual size of each numeric answer that differs between instances, by place in the item.
    sizes: BTreeMap<usize, f64>,
}

/// How a question differs from most instances of its item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum Unusual {
    #[error("it asks other parts than most variants")]
    Parts,
    #[error("an answer is of another size than in most variants")]
    Size,
}

/// Instances that are looked at.
const PROBES: u64 = 24;

/// Answers are of like size within this factor of the usual one.
const LIKE_SIZE: f64 = 10.0;

impl Usual {
    /// What most instances of an item have in common, as a question asks for it.
    pub(crate) fn of(template: &Template, planned: &Planned<'_>) -> Self {
        let set: Vec<(&str, &str)> = planned
            .set
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let probes = (0..PROBES).filter_map(|seed| {
            let instance = Instance::of(template, Some(Seed::new(seed)), &set).ok()?;
            let solution = Solution::of(instance);
            let parts = asked(planned, &solution);
            let sizes = parts
                .iter()
                .filter_map(|part| Some((*part, size(&solution, *part)?)));
            Some((parts.clone(), sizes.collect::<Vec<_>>()))
        });
        let mut asked_parts: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        let mut sizes: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
        for (parts, found) in probes {
            *asked_parts.entry(parts).or_default() += 1;
            for (part, size) in found {
                sizes.entry(part).or_default().push(size);
            }
        }
        let most = asked_parts.into_iter().max_by_key(|(_, count)| *count);
        let sizes = sizes.into_iter();
        Self {
            parts: most.map(|(parts, _)| parts).unwrap_or_default(),
            sizes: sizes
                .filter_map(|(part, all)| Some((part, middle(all)?)))
                .collect(),
        }
    }

    /// Whether a question is like most others.
    pub(crate) fn judge(&self, question: &SheetQuestion<'_>) -> Result<(), Unusual> {
        if question.parts != self.parts {
            return Err(Unusual::Parts);
        }
        for (part, usual) in &self.sizes {
            let found = size(&question.solution, *part).unwrap_or(*usual);
            if found > usual * LIKE_SIZE || found < usual / LIKE_SIZE {
                return Err(Unusual::Size);
            }
        }
        Ok(())
    }

    /// Whether the answer to a part differs between instances.
    pub(crate) fn differs(&self, part: usize) -> bool {
        self.sizes.contains_key(&part)
    }
}

/// The size of the answer to a part that is one number.
pub(crate) fn size(solution: &Solution<'_>, part: usize) -> Option<f64> {
    solution.number(part).map(f64::abs)
}

/// The middle one of some sizes, if they differ and it is not zero.
fn middle(mut sizes: Vec<f64>) -> Option<f64> {
    sizes.sort_by(f64::total_cmp);
    let middle = *sizes.get(sizes.len() / 2)?;
    (sizes.first() != sizes.last() && middle > 0.0).then_some(middle)
}
