//! Functions of time as they are for the data of an instance.
//!
//! A formula that serves for all data has branches for the regimes and names for the pieces. For given
//! data one branch holds, the pieces are written out, and what does not move is a number.

use std::cell::RefCell;
use std::convert::Infallible;

use super::notation::{NumberNotation, Symbols, symbol_of};
use crate::expr::{
    Expr, Kind, Name, Notation, Operator, Path, Precise, Program, Slots, Symbol, Value, Workspace,
};
use crate::math::Math;
use crate::quantity::NodeId;
use crate::solution::Solution;
use crate::unit::Decimal;

/// Pieces within pieces that are written out at most.
const MAX_DEPTH: usize = 20;

/// A formula without the branches that the data rule out, its moving pieces written out.
pub(crate) fn concrete(solution: &Solution<'_>, expr: &Expr) -> Expr {
    Concretizer { solution }.concrete(expr, 0)
}

/// A quantity that moves with time, as a formula with numbers in SI units.
pub(crate) fn function(solution: &Solution<'_>, node: NodeId) -> Option<Math> {
    let template = solution.template();
    let expr = concrete(solution, template.graph.expr(node)?);
    let folded = Folded {
        solution,
        digits: u32::from(template.info(node)?.digits),
        numbers: RefCell::default(),
    };
    Some(folded.fold(&expr).typeset(&folded))
}

struct Concretizer<'a, 't> {
    solution: &'a Solution<'t>,
}

impl Concretizer<'_, '_> {
    fn concrete(&self, expr: &Expr, depth: usize) -> Expr {
        match expr.kind() {
            Kind::If(condition, first, second) => match self.truth(condition) {
                Some(true) => self.concrete(first, depth),
                Some(false) => self.concrete(second, depth),
                None => self.in_children(expr, depth),
            },
            Kind::Name(name) if depth < MAX_DEPTH => match self.moving_piece(name) {
                Some(piece) => self.concrete(piece, depth + 1),
                None => expr.clone(),
            },
            Kind::Path(path) if depth < MAX_DEPTH => match self.of_model(path) {
                Some(formula) => self.concrete(&formula, depth + 1),
                None => expr.clone(),
            },
            // What stands in these is bound or differentiated; it stays as it is.
            Kind::Prime(..) | Kind::Diff(..) | Kind::At(..) => expr.clone(),
            Kind::Root(..) | Kind::Integral(..) => expr.clone(),
            _ => self.in_children(expr, depth),
        }
    }

    fn in_children(&self, expr: &Expr, depth: usize) -> Expr {
        expr.try_map_children(&mut |child| Ok::<_, Infallible>(self.concrete(child, depth)))
            .unwrap_or_else(|never| match never {})
    }

    /// The formula of a quantity that moves with time.
    fn moving_piece(&self, name: &Name) -> Option<&Expr> {
        let graph = &self.solution.template().graph;
        let node = graph.find(name)?;
        graph
            .expr(node)
            .filter(|_| !graph.variables(node).is_empty())
    }

    /// The formula of a model's quantity.
    fn of_model(&self, path: &Path) -> Option<Expr> {
        let (model, quantity) = self.solution.template().graph.offered(path)?;
        model.formula(quantity).ok()
    }

    /// Whether a condition holds at all times.
    fn truth(&self, condition: &Expr) -> Option<bool> {
        value(self.solution, condition)?.as_boolean()
    }
}

/// The value of a formula in which nothing moves.
fn value(solution: &Solution<'_>, expr: &Expr) -> Option<Value> {
    let graph = &solution.template().graph;
    let used = expr.names();
    if !used.paths.is_empty() || used.free.iter().any(|variable| variable.order > 0) {
        return None;
    }
    let mut names = Vec::new();
    let mut data = Vec::new();
    for variable in used.free {
        let node = graph.find(&variable.name)?;
        if !graph.variables(node).is_empty() {
            return None;
        }
        data.push(Precise::exact(solution.evaluation().real(node).ok()?));
        names.push(variable.name);
    }
    let names: Vec<&str> = names.iter().map(Name::as_str).collect();
    let program = Program::compile(expr, &Slots(&names)).ok()?;
    program.evaluate(&data[..], &mut Workspace::default()).ok()
}

/// Names as symbols, and what does not move as a number.
struct Folded<'a, 't> {
    solution: &'a Solution<'t>,
    digits: u32,
    numbers: RefCell<Vec<Decimal>>,
}

impl Folded<'_, '_> {
    /// The formula with names for the numbers of what does not move.
    fn fold(&self, expr: &Expr) -> Expr {
        // What has no data in it stays as it was written, `2` or `π/2`.
        let used = expr.names();
        if used.free.is_empty() && used.paths.is_empty() {
            return expr.clone();
        }
        if let Some(number) = self.number(expr) {
            return self.note(number);
        }
        match expr.kind() {
            Kind::Prime(..) | Kind::Diff(..) | Kind::At(..) => expr.clone(),
            Kind::Root(..) | Kind::Integral(..) => expr.clone(),
            Kind::Binary(sign @ (Operator::Add | Operator::Subtract), first, second) => {
                let (first, second) = (self.fold(first), self.fold(second));
                match (sign, self.negated(&second)) {
                    (Operator::Add, Some(second)) => first - second,
                    (_, Some(second)) => first + second,
                    (Operator::Add, None) => first + second,
                    (_, None) => first - second,
                }
            }
            _ => expr
                .try_map_children(&mut |child| Ok::<_, Infallible>(self.fold(child)))
                .unwrap_or_else(|never| match never {}),
        }
    }

    /// A datum as it is given; results with one figure more than they have at the end.
    fn number(&self, expr: &Expr) -> Option<Decimal> {
        let number = value(self.solution, expr)?.as_real()?;
        match expr.kind() {
            Kind::Name(name) => NumberNotation(self.solution).decimal(name),
            _ => Decimal::rounded(number, self.digits + 1),
        }
    }

    /// A name that stands for a number.
    fn note(&self, number: Decimal) -> Expr {
        let mut numbers = self.numbers.borrow_mut();
        numbers.push(number);
        Expr::name(format!("#{}", numbers.len() - 1).as_str())
    }

    fn noted(&self, name: &Name) -> Option<Decimal> {
        let place: usize = name.as_str().strip_prefix('#')?.parse().ok()?;
        self.numbers.borrow().get(place).copied()
    }

    /// A folded term without the sign of its first factor, if that is negative: `a + (−2)·b` is `a − 2·b`.
    fn negated(&self, term: &Expr) -> Option<Expr> {
        match term.kind() {
            Kind::Name(name) => {
                let number = self.noted(name).filter(|number| number.is_negative())?;
                Some(self.note(number.abs()))
            }
            Kind::Negate(inner) => Some(inner.clone()),
            Kind::Binary(Operator::Multiply, first, rest) => {
                Some(self.negated(first)? * rest.clone())
            }
            Kind::Binary(Operator::Divide, first, rest) => {
                Some(self.negated(first)? / rest.clone())
            }
            _ => None,
        }
    }
}

impl Notation for Folded<'_, '_> {
    fn name(&self, name: &Name) -> Symbol {
        match self.noted(name) {
            Some(number) => symbol_of(number, self.solution),
            None => Symbols(self.solution).name(name),
        }
    }
}
