//! The balance at rest: what weights and pre-stretches do to a system that is described from its equilibrium, and why
//! they drop out of its motion.

use super::{Deriver, LawTerm, Line, LineSide, Reason, Step, Unavailable, lagrange};
use crate::expr::{Expr, Name, Normal, Substitution, Variable};
use crate::mechanics::Model;

/// Letters that stand for formulas which contain others: no chain of them is as long.
const MAX_CHAIN_LENGTH: usize = 20;

/// What letters of a model stand for, each as a formula.
pub type Letters = [(Name, Expr)];

pub(crate) fn statics(
    model: &Model,
    reduced: &Model,
    letters: &Letters,
) -> Result<Vec<Step>, Unavailable> {
    let deriver = Deriver::of(model)?;
    let names = model.coordinates();
    if reduced.coordinates() != names {
        return Err(Unavailable::AnotherMotion {
            coordinate: names[0].clone(),
            difference: "the coordinates differ".to_owned(),
        });
    }
    let (mut rest, mut values, mut motion) = (Vec::new(), Vec::new(), Vec::new());
    let mut used = Vec::new();
    for (at, name) in names.iter().enumerate() {
        prove_motion(model, at, reduced, letters)?;
        let position = Variable::of(name, 0);
        let potential = &model.definition.potential;
        let Some(force) = lagrange::derivative(&deriver, potential, &position, &mut used)? else {
            continue;
        };
        let balance = at_rest(&force.collected, names)?;
        if !balance.is_zero() {
            if !opened(&balance, letters)?.is_zero() {
                return Err(Unavailable::NotAtRest {
                    coordinate: name.clone(),
                });
            }
            let sides = [deriver.collected(&balance), Expr::number(0)].map(LineSide::Formula);
            let term = LineSide::term(LawTerm::Potential(name.clone()));
            rest.push(Line::exact(std::iter::once(term).chain(sides)));
            for (letter, formula) in letters {
                let line = [Expr::name(letter.clone()), formula.clone()];
                let line = Line::exact(line.map(LineSide::Formula));
                // What the other model has, too, is no static displacement.
                let is_static = balance.mentions(letter) && !reduced.names().contains(letter);
                if is_static && !values.contains(&line) {
                    values.push(line);
                }
            }
        }
        let mut sides = vec![LineSide::term(LawTerm::Potential(name.clone()))];
        sides.extend(force.sides());
        let left = reduced.residuals[at].plus(&model.residuals[at].negated())?;
        let left = force.collected.plus(&left)?;
        sides.push(LineSide::Formula(deriver.collected(&left)));
        sides.dedup();
        motion.push(Line::exact(sides));
    }
    if rest.is_empty() {
        return Err(Unavailable::NothingStatic);
    }
    let mut steps: Vec<Step> = deriver.relations(&used)?.into_iter().collect();
    steps.push(Step {
        reason: Reason::AtRest,
        lines: rest,
    });
    if !values.is_empty() {
        steps.push(Step {
            reason: Reason::Letters,
            lines: values,
        });
    }
    steps.push(Step {
        reason: Reason::InMotion,
        lines: motion,
    });
    Ok(steps)
}

/// Along a coordinate nothing but the balance at rest tells the two models apart.
fn prove_motion(
    model: &Model,
    at: usize,
    reduced: &Model,
    letters: &Letters,
) -> Result<(), Unavailable> {
    let difference = model.residuals[at].plus(&reduced.residuals[at].negated())?;
    let difference = opened(&difference, letters)?;
    if difference.is_zero() {
        return Ok(());
    }
    Err(Unavailable::AnotherMotion {
        coordinate: model.coordinates()[at].clone(),
        difference: difference.to_expr(model.order()).to_string(),
    })
}

/// A force where all coordinates are zero.
fn at_rest(force: &Normal, coordinates: &[Name]) -> Result<Normal, Unavailable> {
    let zero = coordinates.iter().fold(Substitution::new(), |zero, name| {
        zero.with(name.clone(), Expr::number(0))
    });
    let force = force.to_expr(&crate::expr::Order::new());
    Ok(Normal::of(&zero.apply(&force)?)?)
}

/// A formula with what its letters stand for.
fn opened(formula: &Normal, letters: &Letters) -> Result<Normal, Unavailable> {
    let values = letters
        .iter()
        .fold(Substitution::new(), |values, (name, value)| {
            values.with(name.clone(), value.clone())
        });
    let mut formula = formula.clone();
    for _ in 0..MAX_CHAIN_LENGTH {
        if letters.iter().all(|(name, _)| !formula.mentions(name)) {
            break;
        }
        let written = formula.to_expr(&crate::expr::Order::new());
        formula = Normal::of(&values.apply(&written)?)?;
    }
    Ok(formula)
}
