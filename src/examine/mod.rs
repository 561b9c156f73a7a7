//! Examinations: an item as its students meet it, over many draws.
//!
//! `check` is the examiner of the examiner. For each draw it types every named mistake, what every standard wrong
//! method gives, and honest work with rounded steps, through the reader and the marker that students meet. What is
//! wrong and right, right and wrong, or leads to another feedback than its own is a finding; so is an item whose
//! variants differ in length, whose answers coincide, or that prints what it asks for.

mod fault;
mod item;
mod part;
mod route;
mod typed;

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use self::fault::QuestionFault;
pub use self::part::PartExamined;
use self::part::QuestionTally;
use crate::answer::AnswerKind;
use crate::bank::{Allowed, Rule, Template};
use crate::diagnostic::Finding;
use crate::expr::Name;
use crate::instance::{self, Instance};
use crate::numerics::Rational;
use crate::seed::Seed;
use crate::solution::Solution;
use crate::suitability::{self, Unfit};
use crate::unit::Decimal;

/// What was found out about an item.
#[derive(Clone, Debug, Serialize)]
pub struct Examination {
    /// The identity of the item, `chapter/name`.
    pub item: String,
    /// What was found of each part, in their order.
    pub parts: Vec<PartExamined>,
    /// The exceptions that were made use of, with their reasons.
    pub allowed: Vec<Exception>,
    /// What is wrong.
    #[serde(skip)]
    pub findings: Vec<Finding>,
}

/// Whether a fault is about the part of this name, or about a blank of the group of this name.
fn is_about(template: &Template, fault: &QuestionFault, name: &str) -> bool {
    let part = fault.part().and_then(|part| template.part(part));
    part.is_some_and(|part| part.is_named(name))
}

/// A finding that is in order in an item.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Exception {
    /// The rule that the item is excepted from.
    pub rule: String,
    /// The part, where it is about one.
    pub part: Option<String>,
    /// Why it is in order.
    pub reason: String,
}

impl Examination {
    /// Examines an item over this many draws, the seeds from 0 on.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::bank::{Catalogue, embedded};
    /// use vibank::examine::Examination;
    ///
    /// let (catalogue, _) = Catalogue::load(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// let examined = Examination::of(item, 5);
    /// assert!(examined.parts.iter().all(|part| part.methods + part.mistakes >= 3));
    /// # }
    /// ```
    pub fn of(template: &Template, seeds: u64) -> Self {
        let mut course = ItemDraws::of(template);
        let mut allowance = instance::DRAWS;
        for seed in 0..seeds {
            let Ok(instance) = Instance::draw(template, Seed::new(seed)) else {
                break;
            };
            if allowance.take(|| course.add(instance, seed)).is_none() {
                // What was seen until then is not complete.
                course = ItemDraws::of(template);
                let limit = instance::DRAWS.after(seed + 1) / 1_000_000;
                course.costly = Some(QuestionFault::Work {
                    draws: seed + 1,
                    limit,
                });
                break;
            }
        }
        course.finish()
    }
}

/// The exceptions of an item that its faults need, and the findings that are left, exceptions without use among them.
fn excepted(template: &Template, faults: Vec<QuestionFault>) -> (Vec<Exception>, Vec<Finding>) {
    let mut used = vec![false; template.allowed.len()];
    let mut findings = Vec::new();
    for fault in faults {
        let finding = fault.finding(template);
        let rule = Rule::of_code(finding.code);
        let excepts = |own: &Allowed| {
            let mut parts = own.part.iter();
            rule.is_some_and(|rule| rule.name() == own.rule.value)
                && parts.all(|name| is_about(template, &fault, name))
        };
        match template.allowed.iter().position(excepts) {
            Some(place) => used[place] = true,
            None => findings.push(finding),
        }
    }
    let mut exceptions = Vec::new();
    for (own, is_used) in template.allowed.iter().zip(used) {
        let (rule, place) = (own.rule.value.clone(), own.rule.span);
        if is_used {
            exceptions.push(Exception {
                rule,
                part: own.part.clone(),
                reason: own.reason.clone(),
            });
        } else if Rule::of_name(&rule).is_some_and(Rule::holds_for_all_draws) {
            let needless = QuestionFault::NeedlessException { rule, place };
            findings.push(needless.finding(template));
        }
    }
    (exceptions, findings)
}

/// The draws of an item so far.
struct ItemDraws<'t> {
    template: &'t Template,
    tallies: Vec<QuestionTally>,
    draws: u64,
    fit: u64,
    redraws: u64,
    broken: BTreeMap<&'t str, u64>,
    unfit: BTreeMap<String, Refused>,
    /// The parts that are asked, with their points, as they occur.
    shapes: BTreeSet<(Vec<usize>, Rational)>,
    coincidences: BTreeMap<(usize, usize), u64>,
    /// Why there are no draws.
    costly: Option<QuestionFault>,
}

/// Draws that are refused for one reason.
#[derive(Default)]
struct Refused {
    count: u64,
    /// The greatest damping ratio among them.
    damping: Option<f64>,
}

/// More than this share of refused draws makes variants alike.
const MAX_REFUSED: f64 = 0.5;

impl<'t> ItemDraws<'t> {
    fn of(template: &'t Template) -> Self {
        let parts = template.parts.iter().enumerate();
        Self {
            template,
            tallies: parts
                .map(|(place, part)| QuestionTally::of(place, part.mistakes.len()))
                .collect(),
            draws: 0,
            fit: 0,
            redraws: 0,
            broken: BTreeMap::new(),
            unfit: BTreeMap::new(),
            shapes: BTreeSet::new(),
            coincidences: BTreeMap::new(),
            costly: None,
        }
    }

    fn add(&mut self, instance: Instance<'t>, seed: u64) {
        self.draws += 1;
        self.redraws += u64::from(instance.redraws());
        for (name, count) in instance.broken() {
            *self.broken.entry(name).or_default() += u64::from(*count);
        }
        let solution = Solution::of(instance);
        let parts: Vec<usize> = (0..self.template.parts.len()).collect();
        let judged = suitability::judge(&solution, &parts)
            .and_then(|()| suitability::judge_methods(&solution, &parts));
        let is_fit = judged.is_ok();
        match judged {
            Ok(()) => {
                self.fit += 1;
                self.note(&solution);
            }
            Err(reason) => self.refuse(&solution, &reason),
        }
        for tally in &mut self.tallies {
            tally.add(&solution, seed, is_fit);
        }
    }

    /// What a draw has in common with others.
    fn note(&mut self, solution: &Solution<'_>) {
        let asked = (0..self.template.parts.len()).filter(|place| solution.asks(*place));
        let asked: Vec<usize> = asked.collect();
        let points = asked.iter().map(|place| self.template.parts[*place].points);
        let points = points.fold(Rational::ZERO, |sum, own| {
            sum.checked_add(own).unwrap_or(sum)
        });
        let keys: Vec<(usize, f64, String)> = asked
            .iter()
            .filter_map(|place| number(solution, *place))
            .collect();
        for (at, (first, a, printed)) in keys.iter().enumerate() {
            for (second, b, other) in &keys[at + 1..] {
                let unit = |place: &usize| {
                    self.template.parts[*place]
                        .answer
                        .unit()
                        .map(|unit| unit.dimension())
                };
                // What is equal by a law is no coincidence.
                let differs = (a - b).abs() > EQUAL * a.abs();
                if differs && printed == other && unit(first) == unit(second) {
                    *self.coincidences.entry((*first, *second)).or_default() += 1;
                }
            }
        }
        self.shapes.insert((asked, points));
    }

    fn refuse(&mut self, solution: &Solution<'_>, reason: &Unfit) {
        let words = match reason {
            Unfit::NoKey { part, .. } => format!("part `{part}` has no answer"),
            Unfit::UncertainKey { part } => {
                format!("the key of part `{part}` is lost in rounding")
            }
            Unfit::NearMistake { part, .. } => {
                format!("a mistake of part `{part}` lies near its key")
            }
            Unfit::NearMethod { part, method, .. } => {
                format!("part `{part}`: {method} gives nearly the key")
            }
        };
        let own = self.unfit.entry(words).or_default();
        own.count += 1;
        let damping = ["zeta", "xi"].into_iter().find_map(|name| {
            let node = self.template.graph.find(&Name::new(name))?;
            solution.evaluation().real(node).ok()
        });
        own.damping = match (own.damping, damping) {
            (Some(known), Some(found)) => Some(known.max(found)),
            (known, found) => known.or(found),
        };
    }

    fn finish(self) -> Examination {
        let template = self.template;
        let solution = Solution::of(Instance::of_source(template));
        let mut faults = item::faults(template, &solution);
        faults.extend(self.refusals());
        faults.extend(self.differences());
        for ((first, second), count) in &self.coincidences {
            let share = *count as f64 / self.fit as f64;
            if share >= 0.5 {
                faults.push(QuestionFault::AnswersCoincide {
                    first: template.parts[*first].id.clone(),
                    second: template.parts[*second].id.clone(),
                    figures: template.parts[*first].answer.figures(),
                    percent: 100.0 * share,
                });
            }
        }
        let parts = self
            .tallies
            .iter()
            .map(|tally| tally.examined(&solution))
            .collect();
        match self.costly {
            Some(costly) => faults.push(costly),
            None => {
                let of_draws = self
                    .tallies
                    .into_iter()
                    .map(|tally| tally.faults(&solution));
                faults.extend(of_draws.flatten());
            }
        }
        let (allowed, findings) = excepted(template, faults);
        Examination {
            item: template.id.to_string(),
            parts,
            allowed,
            findings,
        }
    }

    /// Constraints, mistakes and methods for which too many draws are refused.
    fn refusals(&self) -> Vec<QuestionFault> {
        let mut faults = Vec::new();
        let all = self.redraws + self.draws;
        let redrawn = self.redraws as f64 / all.max(1) as f64;
        let worst = self.broken.iter().max_by_key(|(_, count)| **count);
        if let Some((constraint, count)) = worst.filter(|_| redrawn > MAX_REFUSED) {
            faults.push(QuestionFault::Redrawn {
                constraint: (*constraint).to_owned(),
                percent: 100.0 * *count as f64 / all as f64,
                left: 100.0 * (1.0 - redrawn),
            });
        }
        let unfit = self.draws - self.fit;
        let share = unfit as f64 / self.draws.max(1) as f64;
        let worst = self.unfit.iter().max_by_key(|(_, own)| own.count);
        if let Some((reason, own)) = worst.filter(|_| share > MAX_REFUSED) {
            faults.push(QuestionFault::Unfit {
                percent: 100.0 * share,
                reason: reason.clone(),
                count: own.count,
                draws: self.draws,
                bound: own.damping,
            });
        }
        faults
    }

    fn differences(&self) -> Option<QuestionFault> {
        let mut shapes = self.shapes.iter();
        let (first, points) = shapes.next()?;
        let (other, others) = shapes.next()?;
        let what = if points == others {
            let differing = first
                .iter()
                .chain(other)
                .find(|place| !(first.contains(place) && other.contains(place)));
            let part = differing.map(|place| self.template.parts[*place].id.clone());
            format!("part `{}` comes and goes", part.unwrap_or_default())
        } else {
            "the points differ".to_owned()
        };
        Some(QuestionFault::VariantsDiffer { what })
    }
}

/// Numbers that differ by a smaller share are equal but for rounding in the machine.
const EQUAL: f64 = 1e-9;

/// The number that a part asks for, in SI units, and as it is printed in the figures that are asked for.
fn number(solution: &Solution<'_>, place: usize) -> Option<(usize, f64, String)> {
    let answer = &solution.template().parts[place].answer;
    if answer.kind() != AnswerKind::Numeric {
        return None;
    }
    let number = solution.number(place).filter(|own| *own != 0.0)?;
    let printed = Decimal::rounded(number, answer.figures())?;
    Some((place, number, printed.to_string()))
}
