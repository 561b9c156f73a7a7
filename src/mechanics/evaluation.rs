//! The formulas of a model that are evaluated, each compiled when it is first asked for.

use std::sync::OnceLock;

use super::Unavailable;
use super::definition::{Friction, Initial};
use super::equilibrium::{Balance, Equilibrium};
use super::excitation::Excitation;
use super::lagrange::Energies;
use super::linear::Linear;
use super::programs::{Compiled, Slots};
use super::squares::squares;
use crate::expr::{
    Constant, Expr, Function, Name, Normal, Order, Substitution, SymbolicError, Variable,
};
use crate::numerics::SortedSet;

/// What a model evaluates.
#[derive(Clone, Debug)]
pub(crate) struct Evaluation {
    pub(crate) slots: Slots,
    /// The energies as they are written.
    pub(crate) written: WrittenModel,
    /// The forces at rest as functions of the position, and their derivatives where the position is sought.
    pub(crate) restoring: Compiled,
    pub(crate) slopes: Option<Compiled>,
    /// The equilibrium, where it has a formula.
    pub(crate) position: Option<Compiled>,
    /// Position and velocity at the start, by coordinate.
    pub(crate) start: Compiled,
    /// Kinetic and largest static friction of the only coordinate.
    pub(crate) sticking: Option<Compiled>,
    squares: OnceLock<Option<Compiled>>,
    /// Whether the equation is `I θ'' + A sin θ = 0`.
    pub(crate) is_pendulum: bool,
    tangent: Option<Tangent>,
    excitation: Option<Excitation>,
}

/// What a model is evaluated from.
pub(crate) struct ModelGiven<'a> {
    pub(crate) energies: &'a Energies,
    pub(crate) residuals: &'a [Normal],
    pub(crate) balance: &'a Balance,
    pub(crate) equilibrium: &'a Equilibrium,
    pub(crate) friction: &'a [Option<Friction>],
    pub(crate) initial: &'a [Initial],
}

impl Evaluation {
    pub(crate) fn of(
        given: &ModelGiven<'_>,
        linear: Option<&Linear>,
    ) -> Result<Self, SymbolicError> {
        let names = &given.energies.coordinates;
        let slopes = match given.equilibrium {
            Equilibrium::Sought => {
                let slopes = Linear::slopes(&given.balance.restoring, names)?;
                Some(Compiled::matrix(&slopes))
            }
            _ => None,
        };
        let position = given.equilibrium.formula();
        let start = given
            .initial
            .iter()
            .flat_map(|own| [&own.position, &own.velocity]);
        Ok(Self {
            slots: slots(given),
            written: WrittenModel::of(given.energies),
            restoring: Compiled::sums(given.balance.restoring.clone()),
            slopes,
            position: position.map(|own| Compiled::list(own.iter().cloned())),
            start: Compiled::list(start.cloned()),
            sticking: compiled_friction(given.friction),
            squares: OnceLock::new(),
            is_pendulum: is_pendulum(given.residuals, names)?,
            tangent: linear.map(Tangent::of),
            excitation: Excitation::of(given.balance)?,
        })
    }

    /// Factor and row of each square of V, one after the other, if it is a sum of squares.
    pub(crate) fn squares(&self, energies: &Energies) -> Option<&Compiled> {
        let squares = self.squares.get_or_init(|| compiled_squares(energies));
        squares.as_ref()
    }

    pub(crate) fn tangent(&self) -> Result<&Tangent, Unavailable> {
        self.tangent.as_ref().ok_or(Unavailable::TimeVarying)
    }

    pub(crate) fn excitation(&self) -> Result<&Excitation, Unavailable> {
        self.excitation.as_ref().ok_or(Unavailable::NotHarmonic)
    }
}

/// The matrices as formulas for evaluation: of the position, where that has no formula.
#[derive(Clone, Debug)]
pub(crate) struct Tangent {
    pub(crate) mass: Compiled,
    pub(crate) damping: Compiled,
    pub(crate) stiffness: Compiled,
}

/// The energies and forces as they are written, for evaluation.
#[derive(Clone, Debug)]
pub(crate) struct WrittenModel {
    pub(crate) kinetic: Compiled,
    pub(crate) potential: Compiled,
    pub(crate) dissipation: Compiled,
    /// One per coordinate, none where no force acts.
    pub(crate) forces: Vec<Option<Compiled>>,
}

impl WrittenModel {
    fn of(energies: &Energies) -> Self {
        let forces = energies.forces.iter();
        Self {
            kinetic: Compiled::new(energies.kinetic.clone()),
            potential: Compiled::new(energies.potential.clone()),
            dissipation: Compiled::new(energies.dissipation.clone()),
            forces: forces
                .map(|own| (!own.is_zero()).then(|| Compiled::new(own.clone())))
                .collect(),
        }
    }
}

impl Tangent {
    fn of(linear: &Linear) -> Self {
        Self {
            mass: Compiled::matrix(&linear.mass),
            damping: Compiled::matrix(&linear.damping),
            stiffness: Compiled::matrix(&linear.stiffness),
        }
    }
}

/// Factor and row of each square of V as one list, if V is a sum of squares.
fn compiled_squares(energies: &Energies) -> Option<Compiled> {
    if !energies.forces.iter().all(|force| force.is_zero()) {
        let names = &energies.coordinates;
        let depends = energies.forces.iter().any(|force| {
            names
                .iter()
                .any(|name| Normal::of(force).map_or(true, |own| own.mentions(name)))
        });
        if depends {
            return None;
        }
    }
    let entries = squares(&energies.potential, &energies.coordinates)?
        .into_iter()
        .flat_map(|own| std::iter::once(own.factor).chain(own.row));
    let entries: Vec<_> = entries.collect();
    (!entries.is_empty()).then(|| Compiled::list(entries))
}

/// Whether the only equation is that of a pendulum, undamped and undriven.
fn is_pendulum(residuals: &[Normal], names: &[Name]) -> Result<bool, SymbolicError> {
    let ([residual], [name]) = (residuals, names) else {
        return Ok(false);
    };
    let acceleration = Variable::of(name, 2);
    let Some((inertia, restoring)) = residual.linear_in(&acceleration) else {
        return Ok(false);
    };
    let time = Name::new("t");
    if inertia.mentions(name) || inertia.mentions(&time) || restoring.mentions(&time) {
        return Ok(false);
    }
    if restoring.powers_of(&Variable::of(name, 0)).is_some() {
        // A polynomial is no sine.
        return Ok(false);
    }
    let quarter_turn = Expr::constant(Constant::Pi) / Expr::number(2);
    let top = Substitution::new().with(name.clone(), quarter_turn);
    let sine = Expr::call(Function::Sin, [Expr::name(name.clone())]);
    let moment = Normal::of(&top.apply(&restoring.to_expr(&Order::new()))?)?;
    if moment.is_zero() || moment.mentions(name) {
        return Ok(false);
    }
    restoring.is_equal(&moment.times(&Normal::of(&sine)?)?)
}

/// Kinetic and static friction along the only coordinate.
fn compiled_friction(friction: &[Option<Friction>]) -> Option<Compiled> {
    let [Some(only)] = friction else {
        return None;
    };
    let holding = only.holding.clone().unwrap_or_else(|| only.kinetic.clone());
    Some(Compiled::list([only.kinetic.clone(), holding]))
}

/// All names of a model that are constants, sorted, and its coordinates.
fn slots(given: &ModelGiven<'_>) -> Slots {
    let ModelGiven {
        energies,
        friction,
        initial,
        equilibrium,
        ..
    } = given;
    let mut names = SortedSet::new();
    let mut collect = |formula: &Expr| {
        names.extend(formula.names().free.into_iter().map(|own| own.name));
    };
    [
        &energies.kinetic,
        &energies.potential,
        &energies.dissipation,
    ]
    .into_iter()
    .chain(&energies.forces)
    .chain(friction.iter().flatten().map(|own| &own.kinetic))
    .chain(
        friction
            .iter()
            .flatten()
            .filter_map(|own| own.holding.as_ref()),
    )
    .chain(
        initial
            .iter()
            .flat_map(|own| [&own.position, &own.velocity]),
    )
    .chain(equilibrium.formula().into_iter().flatten())
    .for_each(&mut collect);
    let time = Name::new("t");
    Slots {
        constants: names
            .into_iter()
            .filter(|name| *name != time && !energies.coordinates.contains(name))
            .collect(),
        coordinates: energies.coordinates.clone(),
    }
}
