//! Derivations as lines: those of a model, and the way from a formula to its value.

use super::Scene;
use super::lines::{SetChain, aligned};
use super::notation::{Quantities, Symbols};
use super::{concrete, fill, turns};
use crate::bank::QuantityInfo;
use crate::document::{Filling, Step as Shown};
use crate::expr::{Expr, Kind, Name, Notation, Path};
use crate::math::{Class, Math, TableKind};
use crate::mechanics::{LawTerm, Line, LineSide, Step, Way};
use crate::quantity::{Graph, NodeId};

/// Characters of a formula with its helpers opened beyond which nobody follows the numbers in it.
const MAX_WORKED_LENGTH: usize = 90;

/// The derivation that a path asks for.
pub(crate) fn filling(scene: &Scene<'_, '_>, path: &Path) -> Filling {
    let graph = &scene.solution.template().graph;
    if let Some((_, Way::TurningPoints)) = graph.way(path) {
        return turns::filling(scene, path);
    }
    let steps = graph.lines(path).and_then(Result::ok).unwrap_or_default();
    Filling::Steps(steps.iter().map(|step| shown_step(scene, step)).collect())
}

fn shown_step(scene: &Scene<'_, '_>, step: &Step) -> Shown {
    let mut lines: Vec<SetChain> = step.lines.iter().map(|line| chain(scene, line)).collect();
    // What differs in its order alone is printed once.
    lines.dedup_by(|line, before| line.sides == before.sides);
    Shown {
        words: scene.language.step(&step.reason, &Symbols(scene.solution)),
        lines: aligned(&lines),
    }
}

fn chain(scene: &Scene<'_, '_>, line: &Line) -> SetChain {
    let notation = Symbols(scene.solution);
    let mut sides: Vec<Math> = Vec::new();
    for side in &line.sides {
        let math = set_side(side, &notation);
        // What differs as a formula may be printed alike, 2·(½ k x) and k x.
        if sides.last() != Some(&math) {
            sides.push(math);
        }
    }
    SetChain {
        sides,
        is_approximate: line.is_approximate,
    }
}

fn set_side(side: &LineSide, notation: &dyn Notation) -> Math {
    match side {
        LineSide::Formula(formula) => formula.typeset(notation),
        LineSide::Determinant(rows) => Math::Table {
            rows: rows
                .iter()
                .map(|row| row.iter().map(|own| own.typeset(notation)).collect())
                .collect(),
            kind: TableKind::Matrix,
        }
        .fenced("|", "|"),
        LineSide::Terms(terms) if terms.is_empty() => Math::number("0"),
        LineSide::Terms(terms) => {
            let mut row = Vec::new();
            for (is_subtracted, term) in terms {
                match (is_subtracted, row.is_empty()) {
                    (true, true) => row.push(Math::prefix("−")),
                    (true, false) => row.push(Math::binary("−")),
                    (false, true) => {}
                    (false, false) => row.push(Math::binary("+")),
                }
                row.push(set_term(term, notation));
            }
            Math::row(row)
        }
    }
}

fn set_term(term: &LawTerm, notation: &dyn Notation) -> Math {
    let symbol = |name: &Name| notation.name(name).math;
    let partial = |above: &str, below: Math| {
        let sign = || Math::operator("∂", Class::Ordinary);
        let letter = Math::identifier(above, crate::math::Style::Default);
        Math::fraction(Math::row([sign(), letter]), Math::row([sign(), below]))
    };
    let rate = |of: Math| {
        let (above, below) = (Math::upright("d"), Math::letter('t'));
        let derivative = Math::fraction(above, Math::row([Math::upright("d"), below]));
        Math::row([derivative, Math::thin_space(), of])
    };
    match term {
        LawTerm::Momentum(name) => partial("T", symbol(name).derivative(1)),
        LawTerm::MomentumRate(name) => rate(partial("T", symbol(name).derivative(1))),
        LawTerm::Kinetic(name) => partial("T", symbol(name)),
        LawTerm::Potential(name) => partial("V", symbol(name)),
        LawTerm::Dissipation(name) => partial("D", symbol(name).derivative(1)),
        LawTerm::Force(name) => Math::letter('Q').with_sub(symbol(name)),
        LawTerm::Energy => Math::row([Math::letter('T'), Math::binary("+"), Math::letter('V')]),
        LawTerm::EnergyRate => {
            let sum = [Math::letter('T'), Math::binary("+"), Math::letter('V')];
            rate(Math::row(sum).in_parentheses())
        }
        LawTerm::Power => Math::letter('P'),
    }
}

/// Formula, data substituted, value, and the value in the unit in which a part asks for it.
pub(crate) fn worked(scene: &Scene<'_, '_>, node: NodeId, info: &QuantityInfo) -> Filling {
    let graph = &scene.solution.template().graph;
    let formula = graph.expr(node).and_then(|expr| {
        let expr = concrete::concrete(scene.solution, expr);
        opened(scene.solution.template(), &expr)
    });
    let mut sides = vec![Math::clone(&info.symbol)];
    if let Some(formula) = formula {
        sides.push(formula.typeset(&Symbols(scene.solution)));
        sides.push(formula.typeset(&Quantities(scene)));
    }
    sides.push(fill::value(scene, node, info));
    sides.extend(fill::value_as_asked(scene, node, info));
    sides.dedup();
    let line = SetChain {
        sides,
        is_approximate: false,
    };
    Filling::Steps(vec![Shown {
        words: Vec::new(),
        lines: aligned(&[line]),
    }])
}

/// Why a quantity cannot be worked out line by line; `None` where it can.
pub(crate) fn unworkable(template: &crate::bank::Template, node: NodeId) -> Option<&'static str> {
    let Some(expr) = template.graph.expr(node) else {
        return Some("it is given");
    };
    let Some(formula) = opened(template, expr) else {
        return Some("a quantity in it has neither a unit nor a formula");
    };
    let is_long = formula
        .typeset(&crate::expr::PlainNotation)
        .plain()
        .chars()
        .count()
        > MAX_WORKED_LENGTH;
    is_long.then_some("its formula is too long with its helpers opened")
}

/// The quantities whose values stand in the line of a quantity that is worked out.
#[cfg(feature = "render")]
pub(crate) fn shown_in(template: &crate::bank::Template, node: NodeId) -> Vec<NodeId> {
    let formula = template
        .graph
        .expr(node)
        .and_then(|expr| opened(template, expr));
    let names = formula
        .map(|formula| formula.names().free)
        .unwrap_or_default();
    let nodes = names
        .into_iter()
        .filter_map(|variable| template.graph.find(&variable.name));
    nodes.collect()
}

/// A formula with the helpers opened that have no unit, and so no value of their own to print.
fn opened(template: &crate::bank::Template, expr: &Expr) -> Option<Expr> {
    // No chain of helpers is as long.
    const MAX_DEPTH: usize = 20;
    opened_at(template, expr, MAX_DEPTH)
}

fn opened_at(template: &crate::bank::Template, expr: &Expr, deepest: usize) -> Option<Expr> {
    let graph: &Graph = &template.graph;
    let deeper = deepest.checked_sub(1)?;
    match expr.kind() {
        Kind::Name(name) => {
            let Some(node) = graph.find(name) else {
                return Some(expr.clone());
            };
            match template.info(node) {
                Some(info) if info.units.is_some() => Some(expr.clone()),
                _ => opened_at(template, graph.expr(node)?, deeper),
            }
        }
        Kind::Path(path) => {
            let (model, quantity) = graph.offered(path)?;
            opened_at(template, &model.formula(quantity).ok()?, deeper)
        }
        _ => expr
            .try_map_children(&mut |child| opened_at(template, child, deepest).ok_or(()))
            .ok(),
    }
}

#[cfg(test)]
mod tests;
