//! One part over many draws: its mistakes, the wrong methods to it, and honest work, each typed and marked.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use super::fault::QuestionFault;
use super::{route, typed};
use crate::answer::{AnswerKind, Credit, KeyValue, Marking, Reason, Verdict};
use crate::bank::Units;
use crate::grade;
use crate::quantity::Method;
use crate::solution::Solution;

/// Draws for which formulas and equations are marked: they are compared at points around the data, not at the data.
const SYMBOLIC_DRAWS: u64 = 4;

/// Draws for which functions are marked, each at many times.
const FUNCTION_DRAWS: u64 = 40;

/// The fewest known ways to go wrong that a part has to have.
const MIN_METHODS: usize = 3;

/// What was found out about a part.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct PartExamined {
    /// The identifier of the part.
    pub part: String,
    /// How many standard wrong methods gave another answer than the key in some draw.
    pub methods: usize,
    /// How many named mistakes met their feedback in some draw.
    pub mistakes: usize,
    /// How many named mistakes could not be typed, such as cases.
    pub untyped: usize,
    /// The draws in which honest work was marked.
    pub honest: u64,
}

/// What is tallied of a part.
#[derive(Default)]
pub(crate) struct QuestionTally {
    place: usize,
    draws: u64,
    mistakes: Vec<MistakeTally>,
    /// The methods that gave another answer, by their words.
    applied: BTreeSet<String>,
    right_method: Option<QuestionFault>,
    honest: u64,
    honest_wrong: u64,
    first_wrong: Option<(&'static str, String, u64)>,
    component: Option<QuestionFault>,
    /// The answers of a choice.
    chosen: Vec<String>,
}

#[derive(Default)]
struct MistakeTally {
    /// The draws in which it is a mistake.
    applied: u64,
    typed: u64,
    met: u64,
    right: Option<QuestionFault>,
    /// How often another mistake answered it.
    taken: BTreeMap<usize, u64>,
    unreadable: Option<String>,
}

/// What is done wrongly with a result, whatever its formula.
const RESULTS: [(&str, f64); 2] = [("the result doubled", 2.0), ("the result halved", 0.5)];

impl QuestionTally {
    pub(crate) fn of(place: usize, mistakes: usize) -> Self {
        Self {
            place,
            mistakes: std::iter::repeat_with(MistakeTally::default)
                .take(mistakes)
                .collect(),
            ..Self::default()
        }
    }

    /// Takes in one draw; what is not fit to be handed out counts for what a stated tolerance contains alone.
    pub(crate) fn add(&mut self, solution: &Solution<'_>, seed: u64, is_fit: bool) {
        let part = &solution.template().parts[self.place];
        let kind = part.answer.kind();
        if !solution.asks(self.place) || !(is_fit || part.answer.states_tolerance()) {
            return;
        }
        self.draws += 1;
        let most = match kind {
            AnswerKind::Formula | AnswerKind::Equation | AnswerKind::Matrix => SYMBOLIC_DRAWS,
            AnswerKind::Function => FUNCTION_DRAWS,
            _ => u64::MAX,
        };
        if self.draws > most {
            // A mistake that has a `when` may be one in later draws alone.
            self.add_mistakes(solution, seed, true);
            return;
        }
        self.add_mistakes(solution, seed, false);
        match kind {
            AnswerKind::Formula | AnswerKind::Equation => {
                for (method, typed) in typed::in_letters(solution, self.place) {
                    self.add_method(solution, seed, &method, typed);
                }
            }
            AnswerKind::Numeric | AnswerKind::Integer | AnswerKind::Function => {
                for method in solution.template().methods(self.place) {
                    self.add_typed(solution, seed, method);
                }
                self.add_results(solution, seed);
            }
            _ => {}
        }
        if is_fit && matches!(kind, AnswerKind::Numeric | AnswerKind::Function) {
            self.add_honest(solution, seed);
        }
        if is_fit {
            self.add_key(solution, seed);
        }
    }

    fn add_mistakes(&mut self, solution: &Solution<'_>, seed: u64, only_unmet: bool) {
        let part = &solution.template().parts[self.place];
        for number in 0..self.mistakes.len() {
            let tally = &self.mistakes[number];
            if only_unmet && tally.met > 0 {
                continue;
            }
            let ways = typed::mistake(solution, self.place, number);
            let is_one = solution.mistaken(self.place, number).is_some();
            self.mistakes[number].applied += u64::from(is_one);
            let mut last = None;
            for text in ways {
                let marking = grade::mark(solution, self.place, &text);
                let is_met = marking.reason() == Reason::Mistake(number);
                let is_better = |(_, last): &(String, Marking)| last.verdict == Verdict::Unreadable;
                if is_met || last.as_ref().is_none_or(is_better) {
                    last = Some((text, marking));
                }
            }
            let Some((text, marking)) = last else {
                continue;
            };
            let tally = &mut self.mistakes[number];
            tally.typed += 1;
            match marking.reason() {
                Reason::Mistake(own) if own == number => tally.met += 1,
                Reason::Mistake(other) => *tally.taken.entry(other).or_default() += 1,
                _ if marking.verdict == Verdict::Right
                    && part.mistakes[number].credit < Credit::FULL =>
                {
                    tally.right.get_or_insert(QuestionFault::MistakeRight {
                        part: part.id.clone(),
                        number: number + 1,
                        typed: text,
                        seed,
                    });
                }
                _ => {
                    tally.unreadable.get_or_insert(text);
                }
            }
        }
    }

    fn add_typed(&mut self, solution: &Solution<'_>, seed: u64, method: &Method) {
        if let Some(typed) = typed::by_method(solution, self.place, method) {
            self.add_method(solution, seed, &method.slip.to_string(), typed);
        }
    }

    /// A factor of two in the result.
    fn add_results(&mut self, solution: &Solution<'_>, seed: u64) {
        let part = &solution.template().parts[self.place];
        let Some(value) = part
            .answer
            .keys()
            .first()
            .and_then(|key| solution.evaluation().value(*key).ok())
        else {
            return;
        };
        if part.answer.kind() != AnswerKind::Numeric {
            return;
        }
        for (words, typed) in typed::of_others(solution, self.place) {
            // Where two answers coincide, that is a finding of its own.
            if grade::mark(solution, self.place, &typed).verdict != Verdict::Right {
                self.applied.insert(words);
            }
        }
        if value.numbers().iter().all(|number| *number == 0.0) {
            return;
        }
        for (words, factor) in RESULTS {
            let numbers = value
                .numbers()
                .iter()
                .map(|number| factor * number)
                .collect();
            let wrong = crate::expr::Value::new(value.form(), numbers, value.bounds().to_vec());
            let typed = wrong
                .and_then(|wrong| typed::value(&wrong, part.answer.unit(), part.answer.figures()));
            if let Some(typed) = typed {
                self.add_method(solution, seed, words, typed);
            }
        }
    }

    fn add_method(&mut self, solution: &Solution<'_>, seed: u64, method: &str, typed: String) {
        let marking = grade::mark(solution, self.place, &typed);
        match marking.verdict {
            Verdict::Unreadable | Verdict::Missing => return,
            Verdict::Right if !matches!(marking.reason(), Reason::Mistake(_)) => {
                let part = &solution.template().parts[self.place];
                let kind = part.answer.kind();
                let is_equal = matches!(
                    kind,
                    AnswerKind::Formula
                        | AnswerKind::Equation
                        | AnswerKind::Function
                        | AnswerKind::Integer
                );
                // What is the same formula, the same number or the same function is not another method.
                if is_equal && !self.is_worth_telling(solution, &typed) {
                    return;
                }
                self.right_method.get_or_insert(QuestionFault::MethodRight {
                    item: solution.template().id.to_string(),
                    part: part.id.clone(),
                    method: method.to_owned(),
                    typed,
                    seed,
                });
            }
            _ => {}
        }
        if !self.applied.contains(method) {
            self.applied.insert(method.to_owned());
        }
    }

    /// Whether a function that is right differs from the key: its values are within the tolerance, and not the same.
    fn is_worth_telling(&self, solution: &Solution<'_>, text: &str) -> bool {
        let part = &solution.template().parts[self.place];
        if part.answer.kind() != AnswerKind::Function {
            return false;
        }
        let key = part.answer.keys().first().copied();
        let right =
            key.and_then(|key| typed::function(solution.evaluation(), key, None, typed::FINE));
        right.is_some_and(|right| right != text)
    }

    fn add_honest(&mut self, solution: &Solution<'_>, seed: u64) {
        let by_key = typed::honestly(solution, self.place, solution.template());
        let by_solution = route::printed(solution, self.place);
        let ways = by_key.into_iter().chain(by_solution);
        let marked = ways.map(|text| (grade::mark(solution, self.place, &text), text));
        let read: Vec<(Marking, String)> = marked
            .filter(|(marking, _)| marking.verdict != Verdict::Unreadable)
            .collect();
        self.honest += u64::from(!read.is_empty());
        let wrong = read
            .into_iter()
            .find(|(marking, _)| marking.credit < Credit::FULL);
        if let Some((marking, text)) = wrong {
            self.honest_wrong += 1;
            self.first_wrong
                .get_or_insert((marking.verdict.name(), text, seed));
        }
    }

    fn add_key(&mut self, solution: &Solution<'_>, seed: u64) {
        let part = &solution.template().parts[self.place];
        let Ok(key) = solution.key(self.place) else {
            return;
        };
        match (part.answer.kind(), &key.value) {
            // Lengths and angles have no common size.
            (AnswerKind::ModeShape, KeyValue::Numbers { form, si })
                if self.is_of_one_unit(solution) =>
            {
                let width = match form.shape {
                    crate::expr::Shape::Matrix(_, columns) => columns,
                    shape => shape.len(),
                };
                for shape in si.chunks(width.max(1)) {
                    let largest = shape.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
                    // A component that is zero is a node, which one sees.
                    let small = shape.iter().position(|own| {
                        own.abs() < MIN_COMPONENT * largest && own.abs() > NODE * largest
                    });
                    if let Some(component) = small {
                        self.component.get_or_insert(QuestionFault::SmallComponent {
                            part: part.id.clone(),
                            component: component + 1,
                            percent: 100.0 * shape[component].abs() / largest,
                            seed,
                        });
                    }
                }
            }
            (AnswerKind::Choice, KeyValue::Options { ids, .. }) => {
                let answer = ids.join(", ");
                if !self.chosen.contains(&answer) {
                    self.chosen.push(answer);
                }
            }
            _ => {}
        }
    }

    /// Whether the components of a shape are in one unit.
    fn is_of_one_unit(&self, solution: &Solution<'_>) -> bool {
        let template = solution.template();
        let key = template.parts[self.place].answer.keys().first().copied();
        let units = key.and_then(|key| template.info(key)?.units.as_ref());
        match units {
            Some(Units::Each(units)) => units
                .windows(2)
                .all(|pair| pair[0].dimension() == pair[1].dimension()),
            _ => true,
        }
    }

    /// What was found out.
    pub(crate) fn examined(&self, solution: &Solution<'_>) -> PartExamined {
        PartExamined {
            part: solution.template().parts[self.place].id.clone(),
            methods: self.applied.len(),
            mistakes: self.mistakes.iter().filter(|own| own.met > 0).count(),
            untyped: self
                .mistakes
                .iter()
                .filter(|own| own.applied > 0 && own.typed == 0)
                .count(),
            honest: self.honest,
        }
    }

    /// What is wrong.
    pub(crate) fn faults(self, solution: &Solution<'_>) -> Vec<QuestionFault> {
        let template = solution.template();
        let part = &template.parts[self.place];
        let mut faults = Vec::new();
        if self.draws == 0 {
            return faults;
        }
        let (applied, met) = (
            self.applied.len(),
            self.mistakes.iter().filter(|own| own.met > 0).count(),
        );
        for (number, tally) in self.mistakes.into_iter().enumerate() {
            faults.extend(tally.faults(&part.id, number, self.draws));
        }
        faults.extend(self.right_method);
        faults.extend(self.component);
        let count = applied + met;
        let needs = matches!(
            part.answer.kind(),
            AnswerKind::Numeric | AnswerKind::Function | AnswerKind::Equation
        );
        if needs && count < MIN_METHODS && self.draws >= FEW_DRAWS {
            faults.push(QuestionFault::FewMethods {
                part: part.id.clone(),
                count,
                least: MIN_METHODS,
            });
        }
        // Accepted in 999 of 1000: in fewer draws each counts.
        if self.honest_wrong * 1000 > self.honest
            && let Some((verdict, typed, seed)) = self.first_wrong
        {
            faults.push(QuestionFault::HonestWork {
                item: template.id.to_string(),
                part: part.id.clone(),
                verdict,
                wrong: self.honest_wrong,
                draws: self.honest,
                typed,
                seed,
            });
        }
        let follows_from_data = !part.answer.keys().is_empty();
        if let [answer] = &self.chosen[..]
            && follows_from_data
            && self.draws >= FEW_DRAWS
        {
            faults.push(QuestionFault::SameChoice {
                part: part.id.clone(),
                answer: answer.clone(),
            });
        }
        faults
    }
}

/// In fewer draws a choice may have one answer by chance, and a mistake not occur.
const FEW_DRAWS: u64 = 20;

/// A component of a shape that is a smaller share of the largest one is lost in rounding.
const MIN_COMPONENT: f64 = 0.05;

/// A component that is a smaller share of the largest one is zero but for rounding in the machine.
const NODE: f64 = 1e-9;

impl MistakeTally {
    fn faults(self, part: &str, number: usize, draws: u64) -> Vec<QuestionFault> {
        let mut faults = Vec::new();
        faults.extend(self.right);
        let most = self.taken.iter().max_by_key(|(_, count)| **count);
        let alike = most.filter(|(_, count)| 2 * **count > self.typed);
        if let Some((other, count)) = alike {
            faults.push(QuestionFault::MistakesAlike {
                part: part.to_owned(),
                first: other + 1,
                second: number + 1,
                percent: 100.0 * *count as f64 / self.typed as f64,
            });
        } else if self.met == 0 && faults.is_empty() {
            let why = match (&self.unreadable, self.applied, self.typed) {
                (_, 0, _) if draws < FEW_DRAWS => return faults,
                (_, 0, _) => Some("it is a mistake in no draw, or has no value".to_owned()),
                // Cases and formulas of interval ends cannot be typed; the report counts them.
                (_, _, 0) => return faults,
                (Some(text), ..) => Some(format!("`{text}` is answered otherwise")),
                _ => None,
            };
            faults.push(QuestionFault::MistakeUnmet {
                part: part.to_owned(),
                number: number + 1,
                why,
            });
        }
        faults
    }
}
