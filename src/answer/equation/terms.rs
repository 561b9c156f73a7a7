//! What is wrong with an equation, told by its terms.

use super::Setup;
use crate::answer::meaning::ORDERS;
use crate::expr::{Approx, Name, Notation, Precise, Program, Registers};

/// A term: an unknown or a time derivative of one, or what stands without unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Term {
    Unknown { place: usize, order: usize },
    Rest,
}

/// Coefficients that differ by more than this part are different.
const DIFFERENT: f64 = 1e-9;

/// At most two sentences about the terms that differ, for equations that are linear enough to be told.
pub(super) fn feedback(
    setup: &Setup,
    key: &Program,
    typed: &Program,
    points: &[Vec<Vec<Precise>>],
) -> Option<String> {
    let point = points.first()?.first()?;
    let terms = terms(setup);
    let own = coefficients(key, &terms, point)?;
    let found = coefficients(typed, &terms, point)?;
    let (scale, differing) = scaled(&own, &found)?;
    if differing.is_empty() || differing.len() > 2 || 2 * differing.len() > terms.len() + 1 {
        return None;
    }
    let sentences: Vec<String> = differing
        .into_iter()
        .map(|place| {
            let name = name(setup, terms[place]);
            let (due, given) = (scale * own[place], found[place]);
            if given == 0.0 {
                format!("The term {name} is missing.")
            } else if due == 0.0 {
                format!("There is one term too many {name}.")
            } else if same(due, -given) {
                format!("The sign of the term {name} is wrong.")
            } else {
                match missed(setup, key, typed, &terms, place, point) {
                    Some(missed) => format!("The term {name} misses {missed}."),
                    None => format!("The coefficient of the term {name} is wrong."),
                }
            }
        })
        .collect();
    Some(sentences.join(" "))
}

fn terms(setup: &Setup) -> Vec<Term> {
    let mut terms = Vec::new();
    for name in &setup.unknowns {
        if let Some(place) = setup.meaning.place(name) {
            terms.extend((0..3).rev().map(|order| Term::Unknown { place, order }));
        }
    }
    terms.push(Term::Rest);
    terms
}

/// The coefficient of each term: the value where that unknown is 1 and all others are 0, less the value where all are 0.
fn coefficients(program: &Program, terms: &[Term], point: &[Precise]) -> Option<Vec<f64>> {
    let mut room = Registers::<Approx<f64>>::default();
    let mut value = |point: &[Precise]| {
        let outcome = program.run(point, &mut room).ok()?;
        let number = outcome.numbers().next()?;
        // What cannot be told from zero is zero.
        Some(if number.value.abs() <= 8.0 * number.bound {
            0.0
        } else {
            number.value
        })
    };
    let mut zero = point.to_vec();
    for term in terms {
        if let Term::Unknown { place, .. } = term {
            zero[place * ORDERS..(place + 1) * ORDERS].fill(Precise::exact(0.0));
        }
    }
    let rest = value(&zero)?;
    let mut found = Vec::new();
    for term in terms {
        found.push(match term {
            Term::Rest => rest,
            Term::Unknown { place, order } => {
                let mut moved = zero.clone();
                moved[place * ORDERS + order] = Precise::exact(1.0);
                let moved = value(&moved)?;
                let difference = moved - rest;
                if difference.abs() <= 1e-13 * rest.abs() {
                    0.0
                } else {
                    difference
                }
            }
        });
    }
    Some(found)
}

/// The factor between two equations under which most terms agree, and the terms that do not.
fn scaled(own: &[f64], found: &[f64]) -> Option<(f64, Vec<usize>)> {
    let mut best: Option<(f64, Vec<usize>)> = None;
    for reference in 0..own.len() {
        if own[reference] == 0.0 || found[reference] == 0.0 {
            continue;
        }
        let scale = found[reference] / own[reference];
        let differing: Vec<usize> = (0..own.len())
            .filter(|place| !same(scale * own[*place], found[*place]))
            .collect();
        if best
            .as_ref()
            .is_none_or(|(_, least)| differing.len() < least.len())
        {
            best = Some((scale, differing));
        }
    }
    best
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= DIFFERENT * a.abs().max(b.abs())
}

/// A datum on which the coefficient should depend, over that of a term that is right, and does not.
fn missed(
    setup: &Setup,
    key: &Program,
    typed: &Program,
    terms: &[Term],
    place: usize,
    point: &[Precise],
) -> Option<String> {
    let mut missed = None;
    for (at, input) in setup.meaning.inputs.iter().enumerate() {
        let is_unknown = terms
            .iter()
            .any(|term| matches!(term, Term::Unknown { place, .. } if *place == at));
        if is_unknown || input.name.as_str() == "t" {
            continue;
        }
        let mut moved = point.to_vec();
        moved[at * ORDERS] = Precise::exact(1.25 * point[at * ORDERS].high());
        let depends = |program: &Program| -> Option<bool> {
            let before = coefficients(program, terms, point)?;
            let after = coefficients(program, terms, &moved)?;
            // Over all terms that the datum leaves alone, so that a common factor does not count.
            Some(!same(before[place], after[place]))
        };
        if depends(key)? && !depends(typed)? {
            if missed.is_some() {
                return None;
            }
            missed = Some(setup.lexicon.name(&input.name).math.plain());
        }
    }
    missed
}

fn name(setup: &Setup, term: Term) -> String {
    match term {
        Term::Rest => {
            let names: Vec<String> = setup
                .unknowns
                .iter()
                .map(|name| symbol(setup, name))
                .collect();
            format!("without {}", names.join(", "))
        }
        Term::Unknown { place, order } => {
            let name = symbol(setup, &setup.meaning.inputs[place].name);
            format!("in {name}{}", "′".repeat(order))
        }
    }
}

fn symbol(setup: &Setup, name: &Name) -> String {
    setup.lexicon.name(name).math.plain()
}
