//! The balance of energy.

use super::factors::signed_terms;
use super::{Deriver, LawTerm, Line, LineSide, Reason, Step, Unavailable, lagrange, product};
use crate::expr::{Expr, Name, Normal, Variable, sum_of_signed_terms};

/// For one coordinate the equation of motion by the rate of the energy; for several the balance alone.
pub(crate) fn energy(deriver: &Deriver<'_>) -> Result<Vec<Step>, Unavailable> {
    let model = deriver.model;
    let (kinetic, potential) = (model.kinetic(), model.potential());
    let energy = sum_of_signed_terms(
        [
            signed_terms(&kinetic, false),
            signed_terms(&potential, false),
        ]
        .concat(),
    );
    // Where a support is driven, it does work, and the rate of the energy is no balance of these terms.
    if energy.names().uses(&Name::new("t")) {
        return Err(Unavailable::TimeVarying);
    }
    let normal = Normal::of(&energy)?;
    let written = normal.to_expr(&deriver.model.order().clone().descending());
    let mut sides = vec![
        LineSide::term(LawTerm::Energy),
        LineSide::Formula(energy.clone()),
    ];
    if model.degrees_of_freedom() == 1 && written != energy && written.size() < energy.size() {
        sides.push(LineSide::Formula(written));
    }
    let mut steps = vec![Step {
        reason: Reason::Energy,
        lines: vec![Line::exact(sides)],
    }];
    let powers = powers(deriver)?;
    let power = powers
        .iter()
        .flat_map(|(_, power)| signed_terms(power, false));
    let power = sum_of_signed_terms(power);
    if !power.is_zero() {
        steps.push(Step {
            reason: Reason::Power,
            lines: vec![Line::exact([
                LineSide::term(LawTerm::Power),
                LineSide::Formula(power.clone()),
            ])],
        });
    }
    let rates = (0..model.degrees_of_freedom()).map(|at| conservative(deriver, at));
    let rates = rates.collect::<Result<Vec<_>, _>>()?;
    let rate = rates.iter().zip(model.coordinates()).map(|(rate, name)| {
        (
            false,
            product(rate.clone(), Expr::name(name.clone()).prime(1)),
        )
    });
    steps.push(Step {
        reason: Reason::Balance,
        lines: vec![
            law(&power),
            Line::exact([sum_of_signed_terms(rate), power].map(LineSide::Formula)),
        ],
    });
    let ([name], [per_velocity]) = (model.coordinates(), rates.as_slice()) else {
        return Ok(steps);
    };
    let force = powers.into_iter().map(|(force, _)| (false, force));
    let force = sum_of_signed_terms(force);
    let mut lines = vec![Line::exact(
        [per_velocity.clone(), force].map(LineSide::Formula),
    )];
    let quantity = if model.is_linear() || model.equilibrium().is_none() {
        crate::mechanics::Quantity::FullEquation(0)
    } else {
        crate::mechanics::Quantity::Equation(0)
    };
    let equation = model.equations(quantity)?.into_iter().next();
    let mut equation = equation.map(super::lagrange::line_of);
    if !model.is_linear()
        && let Some(last) = equation.take()
    {
        lines.dedup();
        steps.push(Step {
            reason: Reason::Divided(name.clone()),
            lines,
        });
        steps.push(Step {
            reason: Reason::Linearized,
            lines: vec![last],
        });
        return Ok(steps);
    }
    lines.extend(equation);
    lines.dedup();
    steps.push(Step {
        reason: Reason::Divided(name.clone()),
        lines,
    });
    Ok(steps)
}

/// The rate of the energy per velocity along a coordinate: the left side of Lagrange's equation without dampers and
/// forces. That these times the velocities add up to the rate holds where time does not stand in the energies.
fn conservative(deriver: &Deriver<'_>, at: usize) -> Result<Expr, Unavailable> {
    let model = deriver.model;
    let velocity = Variable::of(&model.coordinates()[at], 1);
    let damping = deriver.normal(&model.definition.dissipation)?;
    let damping = damping.derivative(&velocity)?;
    let force = Normal::of(&model.energies.forces[at])?;
    let rate = model.residuals[at].plus(&damping.negated())?.plus(&force)?;
    Ok(deriver.collected(&rate))
}

fn law(power: &Expr) -> Line {
    let right = if power.is_zero() {
        Vec::new()
    } else {
        vec![(false, LawTerm::Power)]
    };
    Line::exact([LineSide::term(LawTerm::EnergyRate), LineSide::Terms(right)])
}

/// Force and power along each coordinate of what has no potential energy: dampers, forces, friction.
fn powers(deriver: &Deriver<'_>) -> Result<Vec<(Expr, Expr)>, Unavailable> {
    let model = deriver.model;
    let dissipation = deriver.normal(&model.definition.dissipation)?;
    let mut powers = Vec::new();
    for (at, name) in model.coordinates().iter().enumerate() {
        let velocity = Variable::of(name, 1);
        let damping = dissipation.derivative(&velocity)?.negated();
        let damping = deriver.collected(&damping);
        let forces = [Some(damping), lagrange::force(deriver, at)?]
            .into_iter()
            .flatten();
        let forces = forces.filter(|own| !own.is_zero());
        let force = sum_of_signed_terms(forces.flat_map(|own| signed_terms(&own, false)));
        if !force.is_zero() {
            let power = if signed_terms(&force, false).len() == 1 {
                let (sign, short) = deriver.tidy(&(force.clone() * velocity.to_expr()));
                if sign { -short } else { short }
            } else {
                product(force.clone(), velocity.to_expr())
            };
            powers.push((force, power));
        }
    }
    Ok(powers)
}
