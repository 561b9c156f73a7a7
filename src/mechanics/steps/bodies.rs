//! Newton's way: the law of each body, and the elimination of the forces of constraint.

use thiserror::Error;

use super::factors::signed_terms;
use super::lagrange::line_of;
use super::{Deriver, Line, LineSide, Reason, Step, Unavailable, product};
use crate::expr::{Expr, Name, Normal, sum_of_signed_terms};
use crate::mechanics::{Model, Quantity};
use crate::source::Span;

/// Why the laws of the bodies are not the equations of the energies.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum NewtonError {
    /// A force of constraint does not cancel.
    #[error("`{unknown}` does not cancel from the laws of the bodies along `{coordinate}`")]
    Unknown {
        /// The force.
        unknown: Name,
        /// The coordinate along which the laws are added up.
        coordinate: Name,
        /// The first body.
        span: Span,
    },
    /// The equations differ.
    #[error(
        "along `{coordinate}` the laws of the bodies differ from the equation of the energies: `{difference}` is left"
    )]
    Differs {
        /// The coordinate along which the laws are added up.
        coordinate: Name,
        /// Left side by the bodies minus left side by the energies.
        difference: String,
        /// The first body.
        span: Span,
    },
    /// A body moves by what is neither a coordinate nor a kinematic name.
    #[error("`{name}` is neither a coordinate nor a kinematic name")]
    Move {
        /// As written.
        name: Name,
        /// The body.
        span: Span,
    },
    /// The formulas cannot be compared.
    #[error("the laws of the bodies cannot be compared with the energies: {reason}")]
    Symbolic {
        /// What the algebra could not do.
        reason: String,
        /// The first body.
        span: Span,
    },
}

impl NewtonError {
    /// The body at which it is seen.
    pub fn span(&self) -> Span {
        match self {
            Self::Unknown { span, .. }
            | Self::Differs { span, .. }
            | Self::Move { span, .. }
            | Self::Symbolic { span, .. } => *span,
        }
    }
}

/// The laws of all bodies along a coordinate.
struct Along {
    inertia: Vec<(bool, Expr)>,
    forces: Vec<(bool, Expr)>,
    /// The forces of constraint that cancel.
    unknowns: Vec<Name>,
    /// Left minus right, in the coordinates.
    residual: Normal,
}

pub(crate) fn newton(deriver: &Deriver<'_>) -> Result<Vec<Step>, Unavailable> {
    let model = deriver.model;
    let bodies = &model.definition.bodies;
    if bodies.is_empty() {
        return Err(Unavailable::NoFormula);
    }
    let mut steps = Vec::new();
    for body in bodies {
        let lines = (0..body.moves.len()).map(|at| {
            let (name, inertia) = &body.moves[at];
            let left = product(inertia.clone(), Expr::name(name.clone()).prime(2));
            let (is_negative, left) = deriver.tidy(&left);
            let left = if is_negative { -left } else { left };
            let forces = body
                .forces
                .iter()
                .flat_map(|(_, all)| signed_terms(&all[at], false));
            Line::exact([left, sum_of_signed_terms(forces.filter(is_there))].map(LineSide::Formula))
        });
        steps.push(Step {
            reason: Reason::Body(body.name.clone()),
            lines: lines.collect(),
        });
    }
    let used = steps.iter().flat_map(|step| &step.lines);
    let used = used
        .flat_map(|line| &line.sides)
        .filter_map(|side| match side {
            LineSide::Formula(formula) => Some(formula),
            LineSide::Terms(_) | LineSide::Determinant(_) => None,
        });
    let relations = deriver.relations(used)?;
    steps.splice(0..0, relations);
    for (at, name) in model.coordinates().iter().enumerate() {
        let along = along(deriver, name)?;
        let sides = [along.inertia, along.forces].map(sum_of_signed_terms);
        // A law that is the equation already is not printed again.
        let law = Line::exact(sides.map(LineSide::Formula));
        let is_new = steps.iter().all(|step| !step.lines.contains(&law));
        let mut lines: Vec<Line> = is_new.then_some(law).into_iter().collect();
        let full = if model.is_linear() {
            Quantity::Equation(at)
        } else {
            Quantity::FullEquation(at)
        };
        lines.extend(model.equations(full)?.into_iter().map(line_of));
        steps.push(Step {
            reason: Reason::Elimination(name.clone(), along.unknowns),
            lines,
        });
        if !model.is_linear()
            && let Ok(equations) = model.equations(Quantity::Equation(at))
        {
            steps.push(Step {
                reason: Reason::Linearized,
                lines: equations.into_iter().map(line_of).collect(),
            });
        }
    }
    Ok(steps)
}

/// Each law times the displacement per displacement along a coordinate; forces of constraint that cancel are gone.
fn along(deriver: &Deriver<'_>, coordinate: &Name) -> Result<Along, Unavailable> {
    let mut along = Along {
        inertia: Vec::new(),
        forces: Vec::new(),
        unknowns: Vec::new(),
        residual: Normal::of(&Expr::number(0))?,
    };
    for body in &deriver.model.definition.bodies {
        for (at, (name, inertia)) in body.moves.iter().enumerate() {
            let slope = deriver.slope(name, coordinate)?;
            if slope.is_zero() {
                continue;
            }
            let rate = product(inertia.clone(), Expr::name(name.clone()).prime(2));
            let left = rate * slope.clone();
            along.residual = along.residual.plus(&deriver.normal(&left)?)?;
            along.inertia.push(deriver.tidy(&left));
            for (_, components) in &body.forces {
                for (is_negative, force) in signed_terms(&components[at], false) {
                    if force.is_zero() {
                        continue;
                    }
                    let force = force * slope.clone();
                    let normal = deriver.normal(&force)?;
                    let normal = if is_negative {
                        normal
                    } else {
                        normal.negated()
                    };
                    along.residual = along.residual.plus(&normal)?;
                    let names = force.names();
                    let unknown = body.unknowns.iter().find(|name| names.uses(name));
                    let Some(unknown) = unknown else {
                        // What is only taken over keeps the order in which the author wrote it.
                        let (sign, force) = if slope.is_one() {
                            (false, force)
                        } else {
                            deriver.tidy(&force)
                        };
                        along.forces.push((is_negative != sign, force));
                        continue;
                    };
                    if !along.unknowns.contains(unknown) {
                        along.unknowns.push(unknown.clone());
                    }
                }
            }
        }
    }
    Ok(along)
}

pub(crate) fn prove_newton(model: &Model) -> Result<(), NewtonError> {
    let bodies = &model.definition.bodies;
    let Some(span) = bodies.first().map(|body| body.span) else {
        return Ok(());
    };
    let symbolic = |lack: Unavailable| NewtonError::Symbolic {
        reason: lack.to_string(),
        span,
    };
    let deriver = Deriver::of(model).map_err(symbolic)?;
    for body in bodies {
        let mut moves = body.moves.iter().map(|(name, _)| name);
        if let Some(name) = moves.find(|name| !deriver.moving.contains(*name)) {
            return Err(NewtonError::Move {
                name: name.clone(),
                span: body.span,
            });
        }
    }
    for (at, coordinate) in model.coordinates().iter().enumerate() {
        let found = along(&deriver, coordinate).map_err(symbolic)?.residual;
        let mut unknowns = bodies.iter().flat_map(|body| &body.unknowns);
        if let Some(unknown) = unknowns.find(|name| found.mentions(name)) {
            return Err(NewtonError::Unknown {
                unknown: unknown.clone(),
                coordinate: coordinate.clone(),
                span,
            });
        }
        let expected = with_dry_friction(model, at).map_err(symbolic)?;
        let is_equal = found.is_equal(&expected);
        if is_equal.map_err(|error| symbolic(error.into()))? {
            continue;
        }
        let difference = found.plus(&expected.negated());
        let difference = difference.map_err(|error| symbolic(error.into()))?;
        return Err(NewtonError::Differs {
            coordinate: coordinate.clone(),
            difference: difference.to_expr(model.order()).to_string(),
            span,
        });
    }
    Ok(())
}

/// The left side of Lagrange's equation with the force of dry friction, F sign(q').
fn with_dry_friction(model: &Model, at: usize) -> Result<Normal, Unavailable> {
    let residual = model.residuals[at].clone();
    let name = &model.coordinates()[at];
    let Some((friction, direction)) = model.definition.friction_along(name) else {
        return Ok(residual);
    };
    let force = Normal::of(&product(friction.kinetic.clone(), direction))?;
    Ok(residual.plus(&force)?)
}

fn is_there((_, force): &(bool, Expr)) -> bool {
    !force.is_zero()
}
