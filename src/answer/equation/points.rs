//! The points at which equations are compared.
//!
//! For each of a few choices of the data there are points that differ in everything else. Velocities and
//! accelerations are drawn so large that their terms in the key are of one size with the rest: a slip in a
//! term that is small for everyday values shows as well as in any other.

use super::Setup;
use super::rows::{RowSpace, Rows};
use crate::answer::equality::Around;
use crate::answer::meaning::ORDERS;
use crate::expr::{Approx, Precise, Program, Registers};

/// Choices of the data besides typical data of the item.
const DATA_POINTS: usize = 4;
/// Points for each of them, beyond two for each equation of the key.
const SPARE: usize = 10;
/// Draws until data lie in the domain of the item; later ones are nearer to typical data.
const MAX_DRAWS: usize = 40;
/// The largest and, inverted, the least factor by which a term is brought to size.
const MAX_FACTOR: f64 = 1e4;

/// Points that differ in all but the data.
pub(crate) type Choice = Vec<Vec<Precise>>;

/// The choices of data for a key, with the points for each.
#[derive(Debug)]
pub(crate) struct Choices {
    pub(crate) points: Vec<Choice>,
    /// For each choice what follows from the key; none where the key has no value at some point.
    pub(crate) spaces: Vec<Option<RowSpace>>,
}

impl Choices {
    /// Those around typical data of the item.
    pub(crate) fn around(setup: &Setup, key: &[Program], centres: Vec<Option<f64>>) -> Self {
        let mut around = Around::new(&setup.meaning, centres);
        let choice = |place: usize| {
            let spread = 0.3 * (1.0 - place as f64 / DATA_POINTS as f64);
            let data = data(&mut around, spread);
            beside(setup, key, &mut around, &data)
        };
        Self::at((0..=DATA_POINTS).map(choice).collect(), key)
    }

    /// The data of an instance alone.
    pub(crate) fn of_instance(setup: &Setup, key: &[Program], data: &[Option<f64>]) -> Self {
        Self::at(vec![of_instance(setup, key, data)], key)
    }

    /// Its points, where the data are those of an instance alone.
    pub(crate) fn of_one_instance(&self) -> Option<&Choice> {
        match &self.points[..] {
            [points] => Some(points),
            _ => None,
        }
    }

    fn at(points: Vec<Choice>, key: &[Program]) -> Self {
        let key: Vec<&Program> = key.iter().collect();
        let spaces = points.iter().map(|points| RowSpace::of(&key, points));
        Self {
            spaces: spaces.collect(),
            points,
        }
    }

    /// How equations compare with those of a key, for the choice of data for which they do worst.
    pub(crate) fn compare<'p>(
        &self,
        key: impl IntoIterator<Item = &'p Program>,
        typed: impl IntoIterator<Item = &'p Program>,
    ) -> Rows {
        let key: Vec<&Program> = key.into_iter().collect();
        let typed: Vec<&Program> = typed.into_iter().collect();
        let choices = self.points.iter();
        let at = choices.map(|points| Rows::of(&key, &typed, points));
        at.reduce(Rows::worse).unwrap_or(Rows::Undefined)
    }

    /// How typed equations compare with the key.
    pub(crate) fn compare_with_key(&self, typed: &[Program]) -> Rows {
        let typed: Vec<&Program> = typed.iter().collect();
        let choices = self.spaces.iter().zip(&self.points);
        let at = choices.map(|(space, points)| match space {
            Some(space) => space.compare(&typed, points),
            None => Rows::Undefined,
        });
        at.reduce(Rows::worse).unwrap_or(Rows::Undefined)
    }
}

/// The points for the data of an instance.
pub(crate) fn of_instance(setup: &Setup, key: &[Program], data: &[Option<f64>]) -> Choice {
    let mut around = Around::new(&setup.meaning, data.to_vec());
    let data = around.free_point(0.0);
    beside(setup, key, &mut around, &data)
}

/// Points with these data.
fn beside(
    setup: &Setup,
    key: &[Program],
    around: &mut Around<'_>,
    data: &[Precise],
) -> Vec<Vec<Precise>> {
    let factors = factors(setup, key, data);
    let points = (0..2 * key.len() + SPARE).map(|_| {
        let mut point = around.point_beside(data, 0.6);
        let slots = point.iter_mut().zip(&factors);
        for (value, factor) in slots.filter(|(_, own)| **own != 1.0) {
            *value = Precise::exact(value.high() * factor);
        }
        point
    });
    points.collect()
}

/// Data within `spread` decades of typical ones, where the constraints hold.
fn data(around: &mut Around<'_>, spread: f64) -> Vec<Precise> {
    let mut spreads = (0..MAX_DRAWS).map(|draw| spread * (1.0 - draw as f64 / MAX_DRAWS as f64));
    let found = spreads.find_map(|spread| around.point(spread, false, false));
    found.unwrap_or_else(|| around.free_point(0.0))
}

/// For each slot the factor that brings its term to the size of the key; 1 for all but time derivatives.
fn factors(setup: &Setup, key: &[Program], point: &[Precise]) -> Vec<f64> {
    let mut factors = vec![1.0; point.len()];
    let mut room = Registers::default();
    let mut value = |program: &Program, point: &[Precise]| value_in(&mut room, program, point);
    let whole: Vec<f64> = key.iter().map(|program| value(program, point)).collect();
    let mut still = point.to_vec();
    for (place, input) in setup.meaning.inputs.iter().enumerate() {
        let slots = place * ORDERS + 1..(place + 1) * ORDERS;
        for slot in slots.filter(|_| input.is_moving) {
            still[slot] = Precise::exact(0.0);
            let shares = key.iter().zip(&whole).map(|(program, whole)| {
                let (term, size) = ((whole - value(program, &still)).abs(), whole.abs());
                if size > 0.0 { term / size } else { 0.0 }
            });
            let share = shares.fold(0.0, f64::max);
            still[slot] = point[slot];
            if share.is_finite() && share > 0.0 {
                factors[slot] = (1.0 / share).clamp(1.0 / MAX_FACTOR, MAX_FACTOR);
            }
        }
    }
    factors
}

pub(crate) fn value(program: &Program, point: &[Precise]) -> f64 {
    value_in(&mut Registers::default(), program, point)
}

fn value_in(room: &mut Registers<Approx<f64>>, program: &Program, point: &[Precise]) -> f64 {
    let outcome = program.run(point, room);
    let number = outcome
        .ok()
        .and_then(|outcome| outcome.numbers().next().map(|number| number.value));
    number.unwrap_or(f64::NAN)
}
