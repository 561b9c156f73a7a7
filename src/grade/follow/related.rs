//! What follows from one number of an oscillator for another: a period from one's own frequency.
//!
//! Items have closed forms for each, so that the graph of quantities does not show it; the model behind both does.

use super::answers::{Answers, Own};
use super::oscillator;
use crate::expr::{Expr, Name, Precise, Program, Slots, Substitution, Value, Workspace};
use crate::mechanics::Single;
use crate::quantity::NodeId;
use crate::solution::Solution;

/// How the textbooks get a number of an oscillator from others, by [`letter`]; tried in order.
const RULES: &[(Single, &str)] = &[
    (Single::NaturalAngularFrequency, "sqrt(k/m)"),
    (Single::NaturalAngularFrequency, "2*pi*f"),
    (Single::NaturalAngularFrequency, "2*pi/T"),
    (Single::NaturalFrequency, "w/(2*pi)"),
    (Single::NaturalFrequency, "1/T"),
    (Single::Period, "2*pi/w"),
    (Single::Period, "1/f"),
    (Single::CriticalDamping, "2*sqrt(k*m)"),
    (Single::CriticalDamping, "2*m*w"),
    (Single::DampingRatio, "a/w"),
    (Single::DampingRatio, "c/(2*sqrt(k*m))"),
    (Single::DampingRatio, "c/(2*m*w)"),
    (Single::DampingRatio, "1/(2*Q)"),
    (Single::DecayRate, "z*w"),
    (Single::DecayRate, "c/(2*m)"),
    (Single::DampedAngularFrequency, "w*sqrt(1 - z^2)"),
    (Single::DampedAngularFrequency, "sqrt(w^2 - a^2)"),
    (Single::DampedAngularFrequency, "2*pi/P"),
    (Single::DampedPeriod, "2*pi/d"),
    (Single::LogarithmicDecrement, "a*P"),
    (Single::LogarithmicDecrement, "2*pi*z/sqrt(1 - z^2)"),
    (Single::QualityFactor, "1/(2*z)"),
];

fn letter(single: Single) -> &'static str {
    match single {
        Single::Mass => "m",
        Single::Damping => "c",
        Single::Stiffness => "k",
        Single::NaturalAngularFrequency => "w",
        Single::NaturalFrequency => "f",
        Single::Period => "T",
        Single::DecayRate => "a",
        Single::DampingRatio => "z",
        Single::CriticalDamping => "C",
        Single::DampedAngularFrequency => "d",
        Single::DampedPeriod => "P",
        Single::LogarithmicDecrement => "D",
        Single::QualityFactor => "Q",
        Single::ResonanceAngularFrequency => "r",
    }
}

/// A number of an oscillator that the item has a quantity for.
struct Known {
    node: NodeId,
    coordinate: Name,
    single: Single,
}

/// Adds what follows from the student's own numbers for those that were not answered.
pub(super) fn extend(solution: &Solution<'_>, answers: &mut Answers) {
    if answers.own().next().is_none() {
        return;
    }
    let known: Vec<Known> = oscillator::numbers(solution.template())
        .map(|(node, coordinate, single)| Known {
            node,
            coordinate,
            single,
        })
        .collect();
    for (single, rule) in RULES {
        for target in known.iter().filter(|own| own.single == *single) {
            if !answers.has(target.node) {
                follow(solution, answers, &known, target, rule);
            }
        }
    }
}

/// Adds a number that a rule gives from others of the same oscillator, one of which is the student's own.
fn follow(
    solution: &Solution<'_>,
    answers: &mut Answers,
    known: &[Known],
    target: &Known,
    rule: &str,
) -> Option<()> {
    let rule = Expr::read(rule).ok()?;
    let mut values = Vec::new();
    let mut put = Some(Substitution::new());
    let mut source: Option<Own> = None;
    for variable in rule.names().free {
        let mut others = known.iter();
        let other = others.find(|own| {
            own.coordinate == target.coordinate && letter(own.single) == variable.name.as_str()
        })?;
        let own = answers.last(other.node);
        let (number, formula) = match own {
            Some(own) => (own.value.as_real()?, own.formula.clone()),
            None => (
                solution.evaluation().real(other.node).ok()?,
                Answers::right_formula(solution, other.node),
            ),
        };
        put = put
            .zip(formula)
            .map(|(put, formula)| put.with(variable.name.clone(), formula));
        source = source.or_else(|| own.cloned());
        values.push((variable.name, number));
    }
    let source = source?;
    let names: Vec<&str> = values.iter().map(|(name, _)| name.as_str()).collect();
    let data: Vec<Precise> = values
        .iter()
        .map(|(_, number)| Precise::exact(*number))
        .collect();
    let program = Program::compile(&rule, &Slots(&names)).ok()?;
    let number = program
        .evaluate(&data[..], &mut Workspace::default())
        .ok()?
        .as_real()?;
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
