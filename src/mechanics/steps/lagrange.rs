//! Lagrange's equation term by term.

use super::factors::signed_terms;
use super::{Deriver, LawTerm, Line, LineSide, Reason, Step, Unavailable, is_zero, product};
use crate::expr::{
    Equation, Expr, Name, Normal, Substitution, Variable, differentiate, sum_of_signed_terms,
};

/// A derivative through the kinematic names, and in the coordinates.
pub(crate) struct Derivative {
    through_names: Expr,
    /// In the coordinates: term by term, or collected where that is shorter.
    shortest: Expr,
    pub(crate) collected: Normal,
}

/// A line for a term, the sign with which it stands in the equation, its name and what it is.
struct TermEntry {
    is_subtracted: bool,
    term: LawTerm,
    value: Expr,
}

pub(crate) fn lagrange(deriver: &Deriver<'_>, at: usize) -> Result<Vec<Step>, Unavailable> {
    let model = deriver.model;
    let name = &model.coordinates()[at];
    let definition = &model.definition;
    let (position, velocity) = (Variable::of(name, 0), Variable::of(name, 1));
    let (mut lines, mut entries, mut used) = (Vec::new(), Vec::new(), Vec::new());
    let momentum = derivative(deriver, &definition.kinetic, &velocity, &mut used)?;
    if let Some(momentum) = momentum {
        let mut sides = vec![LineSide::term(LawTerm::Momentum(name.clone()))];
        sides.extend(momentum.sides());
        lines.push(Line::exact(sides));
        let moving = model.coordinates().iter().cloned().collect();
        let rate = momentum.collected.time_derivative(&moving)?;
        let value = deriver.collected(&rate);
        let term = LawTerm::MomentumRate(name.clone());
        lines.push(Line::exact([
            LineSide::term(term.clone()),
            LineSide::Formula(value.clone()),
        ]));
        entries.push(TermEntry {
            is_subtracted: false,
            term,
            value,
        });
    }
    let others = [
        (
            &definition.kinetic,
            &position,
            true,
            LawTerm::Kinetic(name.clone()),
        ),
        (
            &definition.potential,
            &position,
            false,
            LawTerm::Potential(name.clone()),
        ),
        (
            &definition.dissipation,
            &velocity,
            false,
            LawTerm::Dissipation(name.clone()),
        ),
    ];
    for (energy, by, is_subtracted, term) in others {
        let Some(derivative) = derivative(deriver, energy, by, &mut used)? else {
            continue;
        };
        let mut sides = vec![LineSide::term(term.clone())];
        sides.extend(derivative.sides());
        lines.push(Line::exact(sides));
        entries.push(TermEntry {
            is_subtracted,
            term,
            value: derivative.shortest,
        });
    }
    let force = force(deriver, at)?;
    if let Some(force) = &force {
        lines.push(Line::exact([
            LineSide::term(LawTerm::Force(name.clone())),
            LineSide::Formula(force.clone()),
        ]));
    }
    let mut steps = Vec::new();
    steps.extend(deriver.relations(&used)?);
    steps.push(Step {
        reason: Reason::Terms(name.clone()),
        lines,
    });
    steps.push(sum(name, &entries, force.clone()));
    finish(deriver, at, &entries, force, &mut steps)?;
    Ok(steps)
}

/// The law with the names of its terms, and with what they are.
fn sum(name: &Name, entries: &[TermEntry], force: Option<Expr>) -> Step {
    let law = entries
        .iter()
        .map(|own| (own.is_subtracted, own.term.clone()));
    let right = force
        .is_some()
        .then(|| (false, LawTerm::Force(name.clone())));
    let left = sum_of_signed_terms(signed(entries));
    Step {
        reason: Reason::Lagrange(name.clone()),
        lines: vec![
            Line::exact([
                LineSide::Terms(law.collect()),
                LineSide::Terms(right.into_iter().collect()),
            ]),
            Line::exact([left, force.unwrap_or_else(|| Expr::number(0))].map(LineSide::Formula)),
        ],
    }
}

/// The printed equation; where the full one is not linear, that one and the linear parts come before it.
fn finish(
    deriver: &Deriver<'_>,
    at: usize,
    entries: &[TermEntry],
    force: Option<Expr>,
    steps: &mut Vec<Step>,
) -> Result<(), Unavailable> {
    let model = deriver.model;
    let quantity = crate::mechanics::Quantity::Equation;
    let linear = model.equations(quantity(at)).ok();
    let linear = linear.and_then(|all| all.into_iter().next());
    if model.is_linear() {
        if let (Some(equation), Some(last)) = (linear, steps.last_mut()) {
            // The sum of the terms may be the printed equation already.
            let line = line_of(equation);
            if last.lines.last() != Some(&line) {
                last.lines.push(line);
            }
        }
        return Ok(());
    }
    let (Some(equation), Some(rest)) = (linear, model.equilibrium()) else {
        let full = crate::mechanics::Quantity::FullEquation(at);
        let full = model.equations(full)?.into_iter().next();
        if let (Some(full), Some(last)) = (full, steps.last_mut()) {
            last.lines.push(line_of(full));
        }
        return Ok(());
    };
    let mut lines = Vec::new();
    for (name, value) in model.coordinates().iter().zip(&rest) {
        if !value.is_zero() {
            lines.push(Line::exact(
                [Expr::name(name.clone()), value.clone()].map(LineSide::Formula),
            ));
        }
    }
    let named = entries.iter().map(|own| (own.term.clone(), &own.value));
    let force = force.as_ref();
    let named =
        named.chain(force.map(|own| (LawTerm::Force(model.coordinates()[at].clone()), own)));
    for (term, value) in named {
        // A force along the velocity of dry friction, or one that depends on time alone, stays as it is.
        if let Some(part) = linear_part(deriver, value, &rest)? {
            lines.push(Line::approximate([
                LineSide::term(term),
                LineSide::Formula(part),
            ]));
        }
    }
    lines.push(line_of(equation));
    steps.push(Step {
        reason: Reason::Linearized,
        lines,
    });
    Ok(())
}

/// The linear part of a term about the equilibrium; `None` where the term is linear.
fn linear_part(
    deriver: &Deriver<'_>,
    term: &Expr,
    rest: &[Expr],
) -> Result<Option<Expr>, Unavailable> {
    let names = deriver.model.coordinates();
    let mut at_rest = Substitution::new();
    for (name, value) in names.iter().zip(rest) {
        at_rest = at_rest.with(name.clone(), value.clone());
    }
    let moving = names.iter().cloned().collect();
    let normal = Normal::of(term)?;
    let still = |formula: &Normal| -> Result<Normal, Unavailable> {
        let expr = formula.to_expr(deriver.model.order());
        let expr = crate::mechanics::equilibrium::at_rest(&Normal::of(&expr)?, &moving)?;
        Ok(Normal::of(
            &at_rest.apply(&expr.to_expr(deriver.model.order()))?,
        )?)
    };
    let mut part = still(&normal)?;
    for (name, value) in names.iter().zip(rest) {
        for order in 0..=2 {
            let variable = Variable::of(name, order);
            let slope = still(&normal.derivative(&variable)?)?;
            let mut displacement = Normal::of(&variable.to_expr())?;
            if order == 0 {
                displacement = displacement.plus(&Normal::of(value)?.negated())?;
            }
            part = part.plus(&slope.times(&displacement)?)?;
        }
    }
    if part.is_equal(&normal)? {
        return Ok(None);
    }
    Ok(Some(deriver.collected(&part)))
}

/// The generalized force along a coordinate, with dry friction.
pub(crate) fn force(deriver: &Deriver<'_>, at: usize) -> Result<Option<Expr>, Unavailable> {
    let definition = &deriver.model.definition;
    let name = &deriver.model.coordinates()[at];
    let written = definition.forces.iter().find(|(own, _)| own == name);
    let mut terms = Vec::new();
    if let Some((_, force)) = written
        && !is_zero(force)?
    {
        terms.push(deriver.tidy(&deriver.resolved(force)?));
    }
    if let Some((friction, direction)) = definition.friction_along(name) {
        terms.push((
            true,
            product(deriver.resolved(&friction.kinetic)?, direction),
        ));
    }
    Ok((!terms.is_empty()).then(|| sum_of_signed_terms(terms)))
}

/// The derivative of an energy by a coordinate or its velocity, term by term as the author wrote it; `None` where it
/// vanishes. What contributes is noted in `used`.
pub(crate) fn derivative(
    deriver: &Deriver<'_>,
    energy: &Expr,
    by: &Variable,
    used: &mut Vec<Expr>,
) -> Result<Option<Derivative>, Unavailable> {
    let (mut through_names, mut in_coordinates) = (Vec::new(), Vec::new());
    for (is_negative, term) in signed_terms(energy, false) {
        for (is_subtracted, outer, inner) in chain(deriver, &term, by)? {
            let is_subtracted = is_negative != is_subtracted;
            let whole = deriver.resolved(&(outer.clone() * inner.clone()))?;
            let (sign, short) = deriver.tidy(&whole);
            in_coordinates.push((is_subtracted != sign, short));
            used.push(outer.clone());
            // A number is no link of the chain that one has to see.
            let (sign, chained) = match inner.as_number() {
                Some(_) => deriver.tidy(&(outer * inner)),
                None => (false, product(outer, inner)),
            };
            through_names.push((is_subtracted != sign, chained));
        }
    }
    let in_coordinates = sum_of_signed_terms(in_coordinates);
    let collected = Normal::of(&in_coordinates)?;
    if collected.is_zero() {
        return Ok(None);
    }
    let short = deriver.collected(&collected);
    Ok(Some(Derivative {
        shortest: if short.size() < in_coordinates.size() {
            short
        } else {
            in_coordinates
        },
        through_names: sum_of_signed_terms(through_names),
        collected,
    }))
}

/// The products of the chain rule: ∂τ/∂n and ∂n/∂q for each name n that moves, with the sign of the first.
fn chain(
    deriver: &Deriver<'_>,
    term: &Expr,
    by: &Variable,
) -> Result<Vec<(bool, Expr, Expr)>, Unavailable> {
    let mut factors = Vec::new();
    for inner in term.names().free {
        if !deriver.moving.contains(&inner.name) {
            continue;
        }
        let is_coordinate = deriver.model.coordinates().contains(&inner.name);
        let slope = if is_coordinate {
            if inner != *by {
                continue;
            }
            Expr::number(1)
        } else {
            let moved = Normal::of(&deriver.resolved(&inner.to_expr())?)?;
            let slope = moved.derivative(by)?.to_expr(&deriver.order);
            let (is_negative, slope) = deriver.tidy(&slope);
            if is_negative { -slope } else { slope }
        };
        if slope.is_zero() {
            continue;
        }
        let outer = differentiate(term, inner)?;
        if is_zero(&outer)? {
            continue;
        }
        let (sign, outer) = deriver.tidy(&outer);
        factors.push((sign, outer, slope));
    }
    Ok(factors)
}

impl Derivative {
    pub(crate) fn sides(&self) -> Vec<LineSide> {
        let sides = [&self.through_names, &self.shortest];
        let mut sides: Vec<Expr> = sides.into_iter().cloned().collect();
        sides.dedup();
        sides.into_iter().map(LineSide::Formula).collect()
    }
}

fn signed(entries: &[TermEntry]) -> impl Iterator<Item = (bool, Expr)> {
    entries
        .iter()
        .flat_map(|own| signed_terms(&own.value, own.is_subtracted))
}

pub(crate) fn line_of(equation: Equation) -> Line {
    Line::exact([equation.left, equation.right].map(LineSide::Formula))
}
