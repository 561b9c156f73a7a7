//! What follows from one number of an oscillator for another: a period from one's own frequency.
//!
//! Items have closed forms for each, so that the graph of quantities does not show it; the model behind both does.

use super::answers::{self, Answers, Own};
use super::oscillator;
use crate::expr::{Expr, Name, Precise, Program, Slots, Substitution, Value, Workspace};
use crate::mechanics::Sdof;
use crate::quantity::NodeId;
use crate::solution::Solution;

/// A number of an oscillator that the item has a quantity for.
struct KnownNumber {
    node: NodeId,
    coordinate: Name,
    single: Sdof,
}

/// Adds what follows from the student's own numbers for those that were not answered.
pub(crate) fn extend(solution: &Solution<'_>, answers: &mut Answers) {
    if answers.own().next().is_none() {
        return;
    }
    let known: Vec<KnownNumber> = oscillator::numbers(solution.template())
        .map(|(node, coordinate, single)| KnownNumber {
            node,
            coordinate,
            single,
        })
        .collect();
    // What follows may lead further, by a relation to a number that stands before it.
    const ROUNDS: usize = 3;
    for _ in 0..ROUNDS {
        let count = answers.own().count();
        for single in Sdof::ALL {
            for target in known.iter().filter(|own| own.single == single) {
                for rule in single.relations() {
                    if !answers.has(target.node) {
                        follow(solution, answers, &known, target, rule);
                    }
                }
            }
        }
        if answers.own().count() == count {
            break;
        }
    }
}

/// Adds a number that a rule gives from others of the same oscillator, one of which is the student's own.
fn follow(
    solution: &Solution<'_>,
    answers: &mut Answers,
    known: &[KnownNumber],
    target: &KnownNumber,
    rule: &str,
) -> Option<()> {
    // Both come from the same data in a few roundings; a rule that does not hold for the item is off by more.
    const ROUNDING: f64 = 1e-9;
    let rule = Expr::read(rule).ok()?;
    let names: Vec<Name> = rule
        .names()
        .free
        .into_iter()
        .map(|free| free.name)
        .collect();
    let taken = names
        .iter()
        .map(|name| TakenNumber::of(solution, answers, known, target, name))
        .collect::<Option<Vec<_>>>()?;
    let source = taken.iter().find_map(|taken| taken.own.clone())?;
    let texts: Vec<&str> = names.iter().map(Name::as_str).collect();
    let program = Program::compile(&rule, &Slots(&texts)).ok()?;
    let value = |number: fn(&TakenNumber) -> f64| {
        let data: Vec<Precise> = taken.iter().map(number).map(Precise::exact).collect();
        program
            .evaluate(&data[..], &mut Workspace::default())
            .ok()?
            .as_real()
    };
    // With the right numbers the rule has to give the right one.
    let right = solution.evaluation().real(target.node).ok()?;
    if (value(|taken| taken.right)? - right).abs() > ROUNDING * right.abs() {
        return None;
    }
    let number = value(|taken| taken.number)?;
    let put = names
        .iter()
        .zip(&taken)
        .try_fold(Substitution::new(), |put, (name, taken)| {
            Some(put.with(name.as_str(), taken.formula.clone()?))
        });
    let formula = put.and_then(|put| put.apply(&rule).ok());
    answers.add_related(
        solution,
        target.node,
        &source,
        Value::real(number, 0.0),
        formula,
    );
    Some(())
}

/// What a rule takes for a letter: the student's own answer, or the right number of the item or of its model.
struct TakenNumber {
    number: f64,
    right: f64,
    formula: Option<Expr>,
    own: Option<Own>,
}

impl TakenNumber {
    fn of(
        solution: &Solution<'_>,
        answers: &Answers,
        known: &[KnownNumber],
        target: &KnownNumber,
        name: &Name,
    ) -> Option<Self> {
        let evaluation = solution.evaluation();
        let single = Sdof::of_letter(name.as_str())?;
        let Some(quantity) = known
            .iter()
            .find(|own| own.coordinate == target.coordinate && own.single == single)
        else {
            let formula = oscillator::right(solution.template(), &target.coordinate, single)?;
            let number = answers::number(&formula, evaluation)?;
            return Some(Self {
                number,
                right: number,
                formula: Some(formula),
                own: None,
            });
        };
        let right = evaluation.real(quantity.node).ok()?;
        let own = answers.last(quantity.node).cloned();
        Some(match &own {
            Some(answer) => Self {
                number: answer.value.as_real()?,
                right,
                formula: answer.formula.clone(),
                own,
            },
            None => Self {
                number: right,
                right,
                formula: Answers::right_formula(solution, quantity.node),
                own,
            },
        })
    }
}
