//! Equilibria as numbers.

use nalgebra::{DMatrix, DVector};

use super::{Numbers, Unavailable};
use crate::expr::{Form, Precise, Shape, Value};
use crate::mechanics::equilibrium::Equilibrium;
use crate::numerics::{Dd, bracketed_root};

/// Newton's method is given up after this many steps.
// Near an equilibrium each step doubles the digits, so that a dozen suffice; the others are for a start far from it.
const MAX_STEPS: usize = 200;

/// A step is halved at most this often before it is taken as it is.
// 2^-40 of a step is 1e-12 of it, which moves nothing that is printed.
const MAX_HALVINGS: usize = 40;

/// An angle is searched for equilibria in this many steps of a turn; equilibria a textbook asks
/// for lie further apart, or at simple fractions of a turn, which are among the steps.
const STEPS_OF_A_TURN: i32 = 720;

/// Bound on the error of a fraction of a turn in double-double.
const PI_ERROR: f64 = 1e-31;

/// All equilibria of the single coordinate, ascending; of an angle those in (−π, π].
///
/// # Errors
///
/// [`Unavailable::SeveralCoordinates`], and those of [`Numbers::equilibrium`].
pub(crate) fn equilibria(numbers: &Numbers) -> Result<Vec<f64>, Unavailable> {
    let [coordinate] = numbers.model.definition.coordinates.as_slice() else {
        return Err(Unavailable::SeveralCoordinates);
    };
    if !coordinate.is_angle {
        return Ok(numbers.equilibrium()?.to_vec());
    }
    let mut positions = Vec::new();
    let mut last: Option<(f64, f64)> = None;
    for step in 0..=STEPS_OF_A_TURN {
        let share = f64::from(2 * step - STEPS_OF_A_TURN) / f64::from(STEPS_OF_A_TURN);
        let angle = Dd::PI * share;
        let (force, is_zero) = force_at(numbers, &[Precise::of_dd(angle, PI_ERROR)])?;
        // The first step is −π, which is the same place as the last one.
        if is_zero && step > 0 {
            positions.push(angle.hi());
        }
        if let Some((before, _)) = last.filter(|(_, old)| old * force < 0.0 && !is_zero) {
            let force =
                |at: f64| force_at(numbers, &[Precise::exact(at)]).map_or(f64::NAN, |own| own.0);
            positions.extend(bracketed_root(force, before, angle.hi(), 0.0).ok());
        }
        // Next to a zero that was met the sign is rounding, and would be found a second time as a change.
        last = (!is_zero).then_some((angle.hi(), force));
    }
    Ok(positions)
}

/// Whether the equilibrium is stable: whether the potential energy has a minimum there.
///
/// # Errors
///
/// Those of [`Numbers::equilibrium`] and [`Numbers::modes`].
pub(crate) fn is_stable(numbers: &Numbers) -> Result<bool, Unavailable> {
    if numbers.model.degrees_of_freedom() == 1 {
        return Ok(numbers.stiffness_matrix()?.numbers()[0] > 0.0);
    }
    let modes = numbers.modes()?;
    Ok(!modes.is_unstable() && modes.rigid_count() == 0)
}

/// A coordinate of the equilibrium as a value.
///
/// # Errors
///
/// Those of [`Numbers::equilibrium`].
pub(crate) fn of_coordinate(numbers: &Numbers, coordinate: usize) -> Result<Value, Unavailable> {
    let position = numbers.equilibrium()?[coordinate];
    if let Some(formula) = &numbers.model.evaluation.position {
        let value = numbers.value(formula, &[])?;
        return Ok(Value::real(position, value.bounds()[coordinate]));
    }
    Ok(Value::real(position, 16.0 * f64::EPSILON * position.abs()))
}

/// [`equilibria`] as a value.
///
/// # Errors
///
/// Those of [`equilibria`].
pub(crate) fn all_values(numbers: &Numbers) -> Result<Value, Unavailable> {
    let positions = equilibria(numbers)?;
    let bounds = positions.iter().map(|own| 16.0 * f64::EPSILON * own.abs());
    let form = Form::real(Shape::Vector(positions.len()));
    let bounds = bounds.collect();
    Value::new(form, positions, bounds).ok_or(Unavailable::NoEquilibrium)
}

/// [`is_stable`] as a value.
///
/// # Errors
///
/// Those of [`is_stable`].
pub(crate) fn stability(numbers: &Numbers) -> Result<Value, Unavailable> {
    let stable = f64::from(u8::from(is_stable(numbers)?));
    Value::new(Form::BOOLEAN, vec![stable], vec![0.0]).ok_or(Unavailable::NoEquilibrium)
}

/// The restoring force of a single coordinate, and whether it cannot be distinguished from zero.
fn force_at(numbers: &Numbers, position: &[Precise]) -> Result<(f64, bool), Unavailable> {
    let forces = numbers.value(&numbers.model.evaluation.restoring, position)?;
    let force = forces.numbers()[0];
    Ok((force, force.abs() <= forces.bounds()[0]))
}

pub(crate) fn position(numbers: &Numbers) -> Result<Vec<f64>, Unavailable> {
    match (
        &numbers.model.equilibrium,
        &numbers.model.evaluation.position,
    ) {
        (Equilibrium::Stated(_), Some(formula)) => {
            let position = numbers.value(formula, &[])?;
            check_rest(numbers, &position)?;
            Ok(position.numbers().to_vec())
        }
        (Equilibrium::Missing(_), _) => Err(Unavailable::NoEquilibrium),
        (_, Some(formula)) => Ok(numbers.value(formula, &[])?.numbers().to_vec()),
        _ => sought_position(numbers),
    }
}

/// A stated position leaves no force beyond what its own rounding explains.
fn check_rest(numbers: &Numbers, position: &Value) -> Result<(), Unavailable> {
    let at: Vec<_> = position
        .numbers()
        .iter()
        .copied()
        .map(Precise::exact)
        .collect();
    let forces = numbers.value(&numbers.model.evaluation.restoring, &at)?;
    let slopes = numbers.value(&numbers.model.evaluation.tangent()?.stiffness, &at)?;
    let size = at.len();
    for (row, name) in numbers.model.coordinates().iter().enumerate() {
        let slopes = &slopes.numbers()[row * size..][..size];
        let rounding: f64 = slopes
            .iter()
            .zip(position.numbers().iter().zip(position.bounds()))
            .map(|(slope, (at, bound))| slope.abs() * (bound + 4.0 * f64::EPSILON * at.abs()))
            .sum();
        // Bounds add up the worst of each rounding, but the position was rounded to `f64` besides.
        if forces.numbers()[row].abs() > 4.0 * (rounding + forces.bounds()[row]) {
            return Err(Unavailable::NotAtRest {
                coordinate: name.clone(),
            });
        }
    }
    Ok(())
}

/// Newton's method from zero, each step halved until the forces get smaller.
fn sought_position(numbers: &Numbers) -> Result<Vec<f64>, Unavailable> {
    let size = numbers.model.degrees_of_freedom();
    let mut at = Trial::of(numbers, DVector::zeros(size))?;
    for _ in 0..MAX_STEPS {
        if at.is_at_rest() {
            return Ok(at.position.as_slice().to_vec());
        }
        let step = at.newton_step().ok_or(Unavailable::NoEquilibrium)?;
        let Some(next) = at.after(numbers, &step) else {
            // No shorter step helps: either nothing but rounding is left, or there is no way on.
            let is_tiny = step.amax() <= 64.0 * f64::EPSILON * at.position.amax();
            let position = at.position.as_slice().to_vec();
            return if is_tiny {
                Ok(position)
            } else {
                Err(Unavailable::NoEquilibrium)
            };
        };
        at = next;
    }
    Err(Unavailable::NoEquilibrium)
}

/// A position with the forces there.
struct Trial {
    position: DVector<f64>,
    forces: DVector<f64>,
    bounds: DVector<f64>,
    slopes: DMatrix<f64>,
}

impl Trial {
    fn of(numbers: &Numbers, position: DVector<f64>) -> Result<Self, Unavailable> {
        let at: Vec<_> = position.iter().copied().map(Precise::exact).collect();
        let forces = numbers.value(&numbers.model.evaluation.restoring, &at)?;
        let slopes = numbers.model.evaluation.slopes.as_ref();
        let slopes = numbers.value(slopes.ok_or(Unavailable::NoEquilibrium)?, &at)?;
        let size = at.len();
        Ok(Self {
            position,
            forces: DVector::from_column_slice(forces.numbers()),
            bounds: DVector::from_column_slice(forces.bounds()),
            slopes: DMatrix::from_row_slice(size, size, slopes.numbers()),
        })
    }

    fn is_at_rest(&self) -> bool {
        let pairs = self.forces.iter().zip(self.bounds.iter());
        pairs
            .into_iter()
            .all(|(force, bound)| force.abs() <= *bound)
    }

    /// The step to where the forces would vanish; along the forces where the slopes are singular.
    fn newton_step(&self) -> Option<DVector<f64>> {
        let newton = self
            .slopes
            .clone()
            .lu()
            .solve(&self.forces)
            .map(|step| -step);
        let is_finite = |step: &DVector<f64>| step.iter().all(|x| x.is_finite());
        newton.filter(is_finite).or_else(|| {
            let scale = self.forces.norm();
            // Of length one, in whatever units: shortened by halves it finds its size.
            Some(-self.forces.clone() / scale).filter(is_finite)
        })
    }

    /// The first place along a step, whole or halved, where the forces are smaller.
    fn after(&self, numbers: &Numbers, step: &DVector<f64>) -> Option<Self> {
        let mut share = 1.0;
        for _ in 0..MAX_HALVINGS {
            let place = Self::of(numbers, &self.position + step * share).ok();
            if let Some(place) = place.filter(|place| place.forces.norm() < self.forces.norm()) {
                return Some(place);
            }
            share *= 0.5;
        }
        None
    }
}
