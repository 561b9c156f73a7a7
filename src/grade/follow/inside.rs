//! What follows from an answer that stands inside the author's formula, though the author wrote it in the data.
//!
//! An author's `n*pi*sqrt(m/(2*k))` goes back to the data where a student goes on from the period. A part of a formula
//! that is a number times a power of what was asked, whatever the data, is this power of the student's own answer.
//! Where the formula has no such part, the second route of the quantity may be written in what was asked.

use super::answers::{Answers, Own, Source, in_data};
use crate::expr::{
    Expr, Kind, Name, Precise, Program, Slots, Substitution, Value, Workspace, fold,
};
use crate::numerics::{Rational, pow};
use crate::quantity::{Graph, NodeId};
use crate::solution::Solution;

/// The powers that are looked for, the usual ones first.
const POWERS: [(i128, i128); 6] = [(1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2)];
/// Points at which parts of formulas are compared.
const POINTS: usize = 4;
/// Values that agree to this part are the same.
const ROUNDING: f64 = 1e-9;
/// Most nodes of a formula whose parts are looked at.
const MAX_NODES: usize = 400;

/// Adds what follows for the keys of a part.
pub(crate) fn extend(solution: &Solution<'_>, answers: &mut Answers, place: usize) {
    for key in solution.template().parts[place].answer.keys() {
        if !answers.has(key) {
            let found =
                by_parts(solution, answers, key).or_else(|| by_route(solution, answers, key));
            if let Some((source, value, formula)) = found {
                answers.add_following(solution, key, Some(&source), value, formula);
            }
        }
    }
}

/// What comes of the key where own answers stand in for parts of its formula.
fn by_parts(
    solution: &Solution<'_>,
    answers: &Answers,
    key: NodeId,
) -> Option<(Own, Value, Option<Expr>)> {
    let graph = &solution.template().graph;
    let mut formula = in_data(graph.expr(key)?, graph)?;
    let data = NearbyData::of(solution, &formula)?;
    let (mut source, mut symbols, mut values) = (None, Substitution::new(), Vec::new());
    let mut has_formulas = true;
    for own in answers.own() {
        // Where the graph shows that the key depends on the answer, this is substituted anyway.
        let goes_on =
            !graph.depends(key, &own.name) && own.node != key && own.source != Source::Related;
        let (Some(value), Some(asked)) = (own.value.as_real(), graph.expr(own.node)) else {
            continue;
        };
        let Some(asked) = in_data(asked, graph).filter(|_| goes_on) else {
            continue;
        };
        let Some(asked) = data.values(&asked) else {
            continue;
        };
        // No formula can write this name.
        let letter = Name::new(&*format!("own {}", own.name));
        let mut search = PartSearch {
            data: &data,
            asked,
            letter: letter.clone(),
            count: 0,
            nodes: 0,
        };
        formula = search.replaced(&formula);
        if search.count > 0 {
            source.get_or_insert(own.clone());
            match &own.formula {
                Some(own) => symbols = symbols.with(letter.clone(), own.clone()),
                None => has_formulas = false,
            }
            values.push((letter, value));
        }
    }
    let source = source?;
    let value = NearbyData::at(solution, &formula, &values)?;
    let formula = has_formulas.then(|| symbols.apply(&formula).ok()).flatten();
    Some((source, Value::real(value, 0.0), formula))
}

/// What comes of the second route of the key, where this is written in own answers and the formula is not.
fn by_route(
    solution: &Solution<'_>,
    answers: &Answers,
    key: NodeId,
) -> Option<(Own, Value, Option<Expr>)> {
    let graph = &solution.template().graph;
    let route = solution.template().info(key)?.verify?;
    let own: Vec<&Own> = answers
        .own()
        .filter(|own| {
            let stands = graph.depends(route, &own.name) && !graph.depends(key, &own.name);
            stands && own.source != Source::Related
        })
        .collect();
    let source = (*own.first()?).clone();
    let evaluation = solution.evaluation().replacing(answers.values(&own));
    let value = evaluation.value(route).ok()?.clone();
    Some((source, value, None))
}

/// Data at a few points around those of the instance.
struct NearbyData {
    names: Vec<Name>,
    points: Vec<Vec<Precise>>,
}

impl NearbyData {
    fn of(solution: &Solution<'_>, formula: &Expr) -> Option<Self> {
        let graph = &solution.template().graph;
        let mut names: Vec<Name> = solution
            .template()
            .parameters
            .iter()
            .map(|parameter| parameter.name.clone())
            .collect();
        crate::numerics::sort_by(&mut names, Ord::cmp);
        if formula
            .names()
            .free
            .iter()
            .any(|free| !names.contains(&free.name))
        {
            return None;
        }
        let value = |name: &Name| solution.evaluation().real(graph.find(name)?).ok();
        let values = names.iter().map(value).collect::<Option<Vec<f64>>>()?;
        Some(Self {
            names: names.clone(),
            points: (0..POINTS)
                .map(|number| {
                    let moved = values.iter().enumerate().map(|(place, value)| {
                        // Irrational shares, so that no two data move alike.
                        let share =
                            (0.618_034 * (1 + place) as f64 + 0.414_214 * number as f64).fract();
                        // Near the data, where the same branches of the formulas hold.
                        Precise::exact(value * (0.9 + 0.2 * share))
                    });
                    moved.collect()
                })
                .collect(),
        })
    }

    fn values(&self, formula: &Expr) -> Option<Vec<f64>> {
        let texts: Vec<&str> = self.names.iter().map(Name::as_str).collect();
        let program = Program::compile(formula, &Slots(&texts)).ok()?;
        let mut room = Workspace::default();
        self.points
            .iter()
            .map(|point| program.evaluate(&point[..], &mut room).ok()?.as_real())
            .collect()
    }

    /// The value of a formula for the instance, with these values of further names.
    fn at(solution: &Solution<'_>, formula: &Expr, further: &[(Name, f64)]) -> Option<f64> {
        let graph: &Graph = &solution.template().graph;
        let names: Vec<Name> = formula
            .names()
            .free
            .into_iter()
            .map(|free| free.name)
            .collect();
        let texts: Vec<&str> = names.iter().map(Name::as_str).collect();
        let program = Program::compile(formula, &Slots(&texts)).ok()?;
        let value = |name: &Name| match further.iter().find(|(own, _)| own == name) {
            Some((_, value)) => Some(*value),
            None => solution.evaluation().real(graph.find(name)?).ok(),
        };
        let data = names.iter().map(|name| value(name).map(Precise::exact));
        let data = data.collect::<Option<Vec<_>>>()?;
        program
            .evaluate(&data[..], &mut Workspace::default())
            .ok()?
            .as_real()
    }
}

/// A search for the parts of a formula that are powers of what was asked.
struct PartSearch<'a> {
    data: &'a NearbyData,
    /// The values of what was asked.
    asked: Vec<f64>,
    letter: Name,
    count: usize,
    nodes: usize,
}

impl PartSearch<'_> {
    /// The formula with these parts replaced, the largest ones.
    fn replaced(&mut self, formula: &Expr) -> Expr {
        self.nodes += 1;
        let is_compound = !matches!(
            formula.kind(),
            Kind::Number(_) | Kind::Measure(..) | Kind::Constant(_) | Kind::Name(_)
        );
        if !is_compound || self.nodes > MAX_NODES || fold(formula).is_some() {
            return formula.clone();
        }
        if let Some(power) = self.power(formula) {
            self.count += 1;
            return power;
        }
        let mapped = formula.try_map_children(&mut |child| Ok::<_, ()>(self.replaced(child)));
        mapped.unwrap_or_else(|()| formula.clone())
    }

    /// The power of the letter that a part is, with the number before it.
    fn power(&self, part: &Expr) -> Option<Expr> {
        let values = self.data.values(part)?;
        let is_moving = values
            .iter()
            .any(|value| (value - values[0]).abs() > ROUNDING * value.abs());
        if !is_moving {
            return None;
        }
        POWERS.into_iter().find_map(|(above, below)| {
            let exponent = above as f64 / below as f64;
            let mut pairs = values.iter().zip(&self.asked);
            let ratio = |(value, asked): (&f64, &f64)| value / pow(*asked, exponent);
            let first = ratio(pairs.next()?);
            if !first.is_finite()
                || first == 0.0
                || !pairs.all(|pair| (ratio(pair) - first).abs() <= ROUNDING * first.abs())
            {
                return None;
            }
            let exponent = Rational::new(above, below)?;
            Some(factor(first)? * Expr::name(self.letter.clone()).power(Expr::number(exponent)))
        })
    }
}

/// A number as a fraction times a power of π.
fn factor(number: f64) -> Option<Expr> {
    // Textbooks have small denominators, such as the 12 of a rod about its centre.
    const MAX_BELOW: i128 = 24;
    // Frequencies bring in π, and their squares π², as in k = 4π² m/T².
    const PI_POWERS: [i32; 5] = [0, 1, -1, 2, -2];
    PI_POWERS.into_iter().find_map(|power| {
        let rest = number / crate::numerics::powi(std::f64::consts::PI, power);
        let below = (1..=MAX_BELOW).find(|below| {
            let above = rest * *below as f64;
            above.round() != 0.0 && (above - above.round()).abs() <= ROUNDING * above.abs()
        })?;
        let fraction = Rational::new((rest * below as f64).round() as i128, below)?;
        let pi = Expr::constant(crate::expr::Constant::Pi);
        Some(Expr::number(fraction) * pi.power(Expr::number(power)))
    })
}
