//! How far the answers to a part range, and what their tolerances are worth.

use serde::Serialize;

use crate::answer::{AnswerKind, KeyValue};
use crate::bank::Template;
use crate::solution::Solution;
use crate::unit::Unit;

/// Half a unit of the third significant figure, as a share of the greatest number of that figure.
const THREE_FIGURES: f64 = 0.005;

/// What the keys of a part look like over the draws that are fit to hand out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AnswerSurvey {
    /// The identifier of the part.
    pub part: String,
    /// The unit of the numbers.
    pub unit: String,
    /// How many draws had a key.
    pub keys: u64,
    /// The least key.
    pub least: Option<f64>,
    /// The greatest key.
    pub greatest: Option<f64>,
    /// The least half-width of the tolerance as a share of its key.
    pub tightest: Option<f64>,
    /// The greatest half-width of the tolerance as a share of its key.
    pub widest: Option<f64>,
    /// The greatest share of the tolerance that honest work with three figures can take up: |y| + Σ |z ∂y/∂z|
    /// over the steps z between data and answer y, times half a unit of the third figure, by the half-width.
    pub work: Option<f64>,
    /// The least distance of a named mistake from its key, in half-widths.
    pub clearance: Option<f64>,
    #[serde(skip)]
    place: usize,
    #[serde(skip)]
    scale: Unit,
}

impl AnswerSurvey {
    /// One for each part that asks for numbers, still empty.
    pub(crate) fn of_parts(template: &Template) -> Vec<Self> {
        let parts = template.parts.iter().enumerate();
        parts
            .filter(|(_, part)| {
                matches!(
                    part.answer.kind(),
                    AnswerKind::Numeric | AnswerKind::Integer
                )
            })
            .map(|(place, part)| {
                let scale = part.answer.unit().unwrap_or(Unit::ONE);
                Self {
                    part: part.id.clone(),
                    unit: scale.to_string(),
                    keys: 0,
                    least: None,
                    greatest: None,
                    tightest: None,
                    widest: None,
                    work: None,
                    clearance: None,
                    place,
                    scale,
                }
            })
            .collect()
    }

    /// Takes in the key of one instance.
    pub(crate) fn add(&mut self, solution: &Solution<'_>) {
        if !solution.asks(self.place) {
            return;
        }
        let Ok(marker) = solution.marker(self.place) else {
            return;
        };
        let KeyValue::Numbers { si, .. } = marker.key().value else {
            return;
        };
        self.keys += 1;
        note(
            &mut self.clearance,
            marker.clearance(f64::INFINITY),
            f64::min,
        );
        let answer = &solution.template().parts[self.place].answer;
        let spreads = answer
            .keys()
            .first()
            .map(|key| solution.evaluation().spread(*key))
            .unwrap_or_default();
        let half_widths = marker.half_widths();
        for (entry, number) in si.iter().enumerate() {
            let value = self.scale.of_si(*number);
            note(&mut self.least, Some(value), f64::min);
            note(&mut self.greatest, Some(value), f64::max);
            let Some(&half) = half_widths.get(entry).filter(|half| **half > 0.0) else {
                continue;
            };
            let relative = (*number != 0.0).then(|| half / number.abs());
            note(&mut self.tightest, relative, f64::min);
            note(&mut self.widest, relative, f64::max);
            let work = spreads
                .get(entry)
                .map(|spread| THREE_FIGURES * spread / half);
            note(&mut self.work, work, f64::max);
        }
    }
}

/// Keeps the lesser or greater of the numbers seen.
fn note(kept: &mut Option<f64>, seen: Option<f64>, choose: fn(f64, f64) -> f64) {
    if let Some(seen) = seen.filter(|seen| seen.is_finite()) {
        *kept = Some(kept.map_or(seen, |kept| choose(kept, seen)));
    }
}
