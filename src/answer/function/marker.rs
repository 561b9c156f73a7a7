//! Marks functions by their values at the times of the span.

use std::cell::OnceCell;
use std::rc::Rc;
use std::sync::Arc;

use super::Setup;
use super::late::{OnSpan, Window};
use super::phase::with_rounded_numbers;
use super::read::{bare, read};
use super::samples::{fine, rounding, samples};
use super::slip::slip;
use crate::answer::meaning::ORDERS;
use crate::answer::settle::{Candidate, settle_by_rule};
use crate::answer::trial::typed as typed_number;
use crate::answer::{
    Close, Credit, Doubt, Echo, Key, Marker, Marking, Misfit, Mistaken, Nature, Reading, Remark,
    Slip, Tolerance, Trial, Unreadable, Why,
};
use crate::expr::{Expr, Form, Inputs, Kind, Precise, Scalar, Undefined};
use crate::numerics::SortedMap;
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::response::Passage;
use crate::unit::{Dimension, Unit};
use crate::work;

/// A response that was read.
pub(crate) struct Response {
    pub(crate) expr: Expr,
    /// The units in which its numbers may be.
    pub(crate) units: Vec<Unit>,
    pub(crate) reading: Reading,
    /// In SI units, for each of the units; none where the function has no value somewhere.
    pub(crate) values: Vec<Vec<f64>>,
    /// What else may have been meant, where the rules for products without signs say what is.
    pub(crate) others: Vec<Expr>,
    /// Why it is not marked, where its other sides are other functions.
    pub(crate) contradiction: Option<Unreadable>,
}

/// Of the times one in so many is looked at first: four of 48, the end among them, where a wrong frequency shows.
const FEW: usize = 15;

/// Less than this share of a half-width is a rounding of the machine.
const SAME: f64 = 1e-6;

/// A prepared key. What only some responses need is computed for the first of them; its cost is not theirs.
pub(crate) struct Prepared<'t> {
    pub(crate) setup: Arc<Setup>,
    pub(crate) evaluation: Rc<Evaluation<'t>>,
    pub(crate) key: NodeId,
    /// The span.
    pub(crate) ends: [f64; 2],
    pub(crate) times: Vec<Precise>,
    pub(crate) values: Vec<f64>,
    pub(crate) halves: Vec<f64>,
    pub(crate) tolerance: Tolerance,
    pub(crate) figures: u32,
    pub(crate) mistaken: Vec<Mistaken>,
    pub(crate) mistakes: OnceCell<Vec<Mistake>>,
    /// Where data show that do not show on the span.
    pub(crate) windows: OnceCell<Vec<Window>>,
    pub(crate) data: Vec<Precise>,
    pub(crate) doubt: Doubt,
}

/// A named mistake.
pub(crate) struct Mistake {
    number: usize,
    /// Its values at the times.
    values: Vec<f64>,
    credit: Credit,
}

impl Prepared<'_> {
    fn windows(&self) -> &[Window] {
        self.windows.get_or_init(|| {
            if self.setup.is_in_pieces {
                return Vec::new();
            }
            let on_span = OnSpan {
                evaluation: &self.evaluation,
                key: self.key,
                ends: self.ends,
                times: &self.times,
                values: &self.values,
                halves: &self.halves,
                share: rounding(self.figures),
                stated: self.is_stated().then_some((&self.tolerance, self.figures)),
            };
            work::aside(|| on_span.windows())
        })
    }

    fn mistakes(&self) -> &[Mistake] {
        let mistakes = self.mistaken.iter().filter_map(|mistaken| {
            Some(Mistake {
                number: mistaken.number,
                values: self.values_of_mistake(mistaken, &self.times).ok()?,
                credit: mistaken.credit,
            })
        });
        self.mistakes
            .get_or_init(|| work::aside(|| mistakes.collect()))
    }

    fn values_of_mistake(
        &self,
        mistaken: &Mistaken,
        times: &[Precise],
    ) -> Result<Vec<f64>, Absent> {
        let evaluation = &self.evaluation;
        let accuracy = fine(largest(&self.values));
        if let Some(node) = mistaken.given.first() {
            return samples(evaluation, *node, times, accuracy);
        }
        let with = mistaken
            .replaced
            .iter()
            .map(|(old, new)| Ok((*old, evaluation.value(*new)?.clone())));
        let replaced = evaluation.replacing(with.collect::<Result<Vec<_>, Absent>>()?);
        samples(&replaced, self.key, times, accuracy)
    }

    /// The distance of a mistake from the key, in tolerances, where it is less than `limit`.
    fn distance_within(&self, limit: f64, mistaken: &Mistaken) -> Option<f64> {
        // The farthest time decides, and some few mostly show that it is too far.
        let few = (0..self.times.len()).rev().step_by(FEW);
        let times: Vec<Precise> = few.clone().map(|place| self.times[place]).collect();
        let values = self.values_of_mistake(mistaken, &times).ok()?;
        let mut distances = few
            .zip(values)
            .map(|(place, value)| (value - self.values[place]).abs() / self.halves[place]);
        if distances.any(|distance| distance.is_finite() && distance >= limit) {
            return None;
        }
        let values = self.values_of_mistake(mistaken, &self.times).ok()?;
        self.distance(&values).filter(|distance| *distance < limit)
    }

    /// Whether the item states the tolerance.
    fn is_stated(&self) -> bool {
        !self.tolerance.is_derived()
    }

    /// The values of a typed function at the times.
    pub(crate) fn values_of(&self, expr: &Expr) -> Option<Vec<f64>> {
        self.values_at(expr, &self.times)
    }

    fn values_at(&self, expr: &Expr, times: &[Precise]) -> Option<Vec<f64>> {
        let setup = &self.setup;
        let program = setup.meaning.compile(expr, &SortedMap::new()).ok()?;
        let slot = setup.meaning.place(&setup.variable)? * ORDERS;
        if program.form() != Form::REAL {
            return None;
        }
        let inputs = times.iter().map(|time| AtTime {
            data: &self.data,
            slot: slot as u32,
            time: *time,
        });
        let inputs: Vec<AtTime<'_>> = inputs.collect();
        program.sweep(vec![slot as u32]).reals(0.0, &inputs).ok()
    }

    /// The same in SI units, where the numbers are in one of these.
    pub(crate) fn values_in(&self, expr: &Expr, units: &[Unit]) -> Option<Vec<Vec<f64>>> {
        let values = self.values_of(expr)?;
        let in_si = |unit: &Unit| values.iter().map(|value| unit.to_si(*value)).collect();
        Some(units.iter().map(in_si).collect())
    }

    /// The dimension of a function of data alone that is not that of the key.
    pub(crate) fn dimension_trouble(&self, expr: &Expr) -> Option<Dimension> {
        // Numbers stand for values in the unit of the key, rates and frequencies: only formulas in data alone have dimensions.
        let found = expr.check(&self.setup.meaning).ok();
        let found = found.filter(|_| self.has_data(expr))?;
        let (key, typed) = (self.setup.kind.dimension()?, found.dimension()?);
        (key != typed && !typed.is_pure()).then_some(typed)
    }

    /// Whether letters of the question stand in a function.
    pub(crate) fn has_data(&self, expr: &Expr) -> bool {
        let names = expr.names();
        let mut free = names.free.iter();
        free.any(|variable| variable.name != self.setup.variable)
    }

    /// Whether a function is written in letters, with no number that could be rounded.
    fn is_in_letters(&self, expr: &Expr) -> bool {
        let mut has_decimals = false;
        expr.walk(&mut |node| {
            has_decimals |= matches!(node.kind(), Kind::Number(value) if !value.is_integer());
        });
        let found = expr.check(&self.setup.meaning).ok();
        let dimension = found.and_then(|kind| kind.dimension());
        self.has_data(expr) && !has_decimals && dimension == self.setup.kind.dimension()
    }

    /// Whether one of these has the values of the key to rounding.
    fn is_exact(&self, found: &[Vec<f64>]) -> bool {
        // Both are computed from the same data, and nothing was rounded by a person: what differs by more is
        // another function.
        const ROUNDING: f64 = 1e-7;
        let limit = ROUNDING * largest(&self.values);
        found.iter().any(|values| {
            let mut pairs = values.iter().zip(&self.values);
            pairs.all(|(typed, key)| (typed - key).abs() <= limit)
        })
    }

    /// Whether one of these is near a key at all times.
    pub(crate) fn fits(&self, found: &[Vec<f64>], key: &[f64]) -> bool {
        found.iter().any(|values| self.is_near(values, key))
    }

    fn is_near(&self, typed: &[f64], key: &[f64]) -> bool {
        typed
            .iter()
            .zip(key)
            .zip(&self.halves)
            .all(|((typed, key), half)| (typed - key).abs() <= half + 1e-12 * key.abs())
    }
}

impl Marker for Prepared<'_> {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "exp("),
            Trial::new(Nature::Unreadable, "unheard_of cos(t)"),
        ];
        let text = self.setup.shown.to_string();
        let largest = largest(&self.values);
        // Cases and numbers with units cannot be typed, and nothing is next to zero.
        let is_typable = !text.contains("if ") && !text.contains('[');
        if !is_typable || largest == 0.0 || !self.setup.shown.names().paths.is_empty() {
            return trials;
        }
        trials.push(Trial::new(Nature::Right, text.as_str()));
        let shares = self.values.iter().zip(&self.halves);
        let nearest = shares
            .map(|(value, half)| half / value.abs())
            .fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            let scaled = |share: f64| format!("({})*({text})", typed_number(1.0 + share * nearest));
            trials.push(Trial::new(Nature::Borderline, scaled(0.99)));
            trials.push(Trial::new(Nature::Wrong, scaled(1.01)));
        }
        trials
    }

    fn key(&self) -> Key {
        Key::clone(self.setup.printed())
    }

    fn clearance(&self, limit: f64) -> Option<f64> {
        let mistakes = self.mistaken.iter();
        let costly = mistakes.filter(|mistake| mistake.credit < Credit::FULL);
        let distances = costly.filter_map(|mistake| self.distance_within(limit, mistake));
        // What is the key itself but for rounding is no other answer for these data.
        let nearest = distances
            .filter(|distance| *distance > SAME)
            .min_by(f64::total_cmp);
        nearest.filter(|_| !self.looks_later())
    }

    fn distance(&self, si: &[f64]) -> Option<f64> {
        let pairs = si.iter().zip(&self.values).zip(&self.halves);
        let distances = pairs.map(|((given, key), half)| (given - key).abs() / half);
        let largest = distances
            .filter(|distance| distance.is_finite())
            .fold(0.0, f64::max);
        (si.len() == self.values.len()).then_some(largest)
    }

    fn samples(&self) -> (&[Precise], &[f64]) {
        (&self.times, &self.values)
    }

    fn looks_later(&self) -> bool {
        !self.windows().is_empty()
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        match read(self, response) {
            Ok(Response {
                contradiction: Some(why),
                ..
            })
            | Err(why) => Marking::unreadable(why),
            Ok(response) => {
                let others = response.others.clone().into_iter();
                let candidate = |response: Response| Candidate {
                    shown: self.setup.lexicon.written(&response.expr),
                    marking: self.judged(response),
                };
                let others = others.map(|other| candidate(bare(self, other)));
                let read = response.expr.clone();
                let written = || self.setup.lexicon.written(&read);
                settle_by_rule(self.doubt, self.judged(response), written, others)
            }
        }
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let read = read(self, response)?;
        let others = read
            .others
            .into_iter()
            .map(|other| bare(self, other).reading);
        Echo::of([read.reading].into_iter().chain(others)).ok_or_else(|| Why::Incomparable.into())
    }
}

impl Prepared<'_> {
    /// The marking of a function that was read.
    fn judged(&self, response: Response) -> Marking {
        let wrong =
            |response: Response, remark: Option<Remark>| Marking::wrong(response.reading, remark);
        if response.values.is_empty() {
            return wrong(response, Some(Slip::NoValueOnSpan.into()));
        }
        let begins_rightly = self.fits(&response.values, &self.values);
        if begins_rightly && self.fits_late(&response) {
            // What is all in letters needs no tolerance.
            if self.has_tolerance_for(&response) {
                return Marking::right(response.reading);
            }
            return wrong(response, Some(Slip::Near(Close::Function).into()));
        }
        let mut mistakes = self.mistakes().iter();
        if let Some(Mistake { number, credit, .. }) =
            mistakes.find(|mistake| self.fits(&response.values, &mistake.values))
        {
            return Marking::mistake(response.reading, *number, *credit);
        }
        if !begins_rightly && self.is_right_but_for_its_rounding(&response) {
            return Marking::right(response.reading);
        }
        if begins_rightly {
            return wrong(response, Some(Slip::RunsAway.into()));
        }
        if let Some(found) = self.dimension_trouble(&response.expr) {
            let misfit = Misfit::Comes {
                entry: None,
                found,
                unit: None,
                asked: None,
            };
            return wrong(response, Some(misfit.into()));
        }
        let slip = slip(self, &response);
        wrong(response, slip.map(Remark::from))
    }

    /// Whether a function that fits on the span has the size of the key after it, where the windows ask for it.
    fn fits_late(&self, response: &Response) -> bool {
        let in_si = |unit: &Unit, values: &[f64]| -> Vec<f64> {
            values.iter().map(|value| unit.to_si(*value)).collect()
        };
        self.windows().iter().all(|window| {
            let values = self.values_at(&response.expr, &window.times);
            values.is_none_or(|values| {
                let mut units = response.units.iter();
                units.any(|unit| window.admits(&in_si(unit, &values)))
            })
        })
    }

    /// Whether a function of one wave differs from the key by no more than the rounding of its numbers, and so from no
    /// named mistake.
    fn is_right_but_for_its_rounding(&self, response: &Response) -> bool {
        // The parts are taken one by one: what two of them do together is less than this share of both.
        const TOGETHER: f64 = 1.05;
        let moved = with_rounded_numbers(&response.expr, &self.setup.variable, self.figures);
        let Some(moved) = moved else { return false };
        let moved: Option<Vec<[Vec<Vec<f64>>; 2]>> = moved
            .into_iter()
            .map(|[lower, higher]| {
                let values = |expr: &Expr| self.values_in(expr, &response.units);
                Some([values(&lower)?, values(&higher)?])
            })
            .collect();
        let Some(moved) = moved else { return false };
        let is_near = |key: &[f64]| {
            let mut forms = response.values.iter().enumerate();
            forms.any(|(form, values)| {
                let mut times = values.iter().zip(key).enumerate();
                times.all(|(time, (value, key))| {
                    let parts = moved.iter().map(|sides| {
                        let sizes = sides
                            .each_ref()
                            .map(|side| (side[form][time] - value).abs());
                        sizes[0].max(sizes[1])
                    });
                    (value - key).abs() <= TOGETHER * parts.sum::<f64>() + 1e-12 * key.abs()
                })
            })
        };
        is_near(&self.values)
            && self.fits_late(response)
            && self.has_tolerance_for(response)
            && !self
                .mistakes()
                .iter()
                .any(|mistake| is_near(&mistake.values))
    }

    fn has_tolerance_for(&self, response: &Response) -> bool {
        self.is_stated() || !self.is_in_letters(&response.expr) || self.is_exact(&response.values)
    }
}

/// The data of an item at a time.
struct AtTime<'d> {
    data: &'d [Precise],
    /// The slot of the time.
    slot: u32,
    time: Precise,
}

impl<S: Scalar> Inputs<S> for AtTime<'_> {
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        if slot == self.slot {
            return Ok(S::of(&self.time));
        }
        self.data.input(slot)
    }
}

/// The largest size of some values.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()))
}
