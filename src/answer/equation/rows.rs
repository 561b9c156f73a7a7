//! Whether equations follow from one another: their row spaces, by values at points.
//!
//! For fixed data each equation is a row of the values of its left side less its right side at points
//! that differ in all unknowns and in time. An equation follows from others, with factors made of data,
//! if its row is a combination of theirs; random points tell different functions apart.

use crate::expr::{Precise, Program};

/// A rest below this part of a row is rounding.
const ROUNDING: f64 = 1e-11;

/// How typed equations compare with a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rows {
    /// Each follows from the other.
    Same,
    /// All follow from the key, but not the key from them.
    Fewer {
        /// How many are independent.
        found: usize,
        /// How many the key has.
        needed: usize,
    },
    /// They do not follow from the key.
    Different,
    /// They have no value at some of the points.
    Undefined,
}

impl Rows {
    pub(crate) fn of(key: &[&Program], typed: &[&Program], points: &[Vec<Precise>]) -> Self {
        let space = RowSpace::of(key, points);
        space.map_or(Self::Undefined, |space| space.compare(typed, points))
    }

    /// How many of these equations are independent; none if they have no value at some point.
    pub(crate) fn rank(programs: &[Program], points: &[Vec<Precise>]) -> Option<usize> {
        let mut basis = Basis::default();
        for program in programs {
            basis.add(&row(program, points)?);
        }
        Some(basis.rows.len())
    }

    /// The verdict that decides of two for different data.
    pub(crate) fn worse(self, other: Self) -> Self {
        match (self, other) {
            (Self::Undefined, other) => other,
            (own, Self::Undefined | Self::Same) => own,
            (Self::Same, other) => other,
            (Self::Different, _) | (_, Self::Different) => Self::Different,
            (own, _) => own,
        }
    }
}

/// What follows from equations for fixed data.
#[derive(Debug)]
pub(crate) struct RowSpace(Basis);

impl RowSpace {
    /// What follows from a key; none where it has no value at one of the points.
    pub(crate) fn of(key: &[&Program], points: &[Vec<Precise>]) -> Option<Self> {
        let mut basis = Basis::default();
        for row in rows(key, points)? {
            basis.add(&row);
        }
        Some(Self(basis))
    }

    /// How typed equations compare with the key at the same points.
    pub(crate) fn compare(&self, typed: &[&Program], points: &[Vec<Precise>]) -> Rows {
        let (basis, needed) = (&self.0, self.0.rows.len());
        // As many rows as points would span everything.
        let typed = rows(typed, points).filter(|_| needed + 2 <= points.len());
        let Some(typed) = typed else {
            return Rows::Undefined;
        };
        let mut own = Basis::default();
        for row in &typed {
            if basis.rest(row).1 {
                return Rows::Different;
            }
            own.add(row);
        }
        match own.rows.len() {
            found if found == needed => Rows::Same,
            found => Rows::Fewer { found, needed },
        }
    }
}

/// A row of values with a bound on their errors, both divided by the largest value.
struct ScaledRow {
    values: Vec<f64>,
    bound: f64,
}

fn rows(programs: &[&Program], points: &[Vec<Precise>]) -> Option<Vec<ScaledRow>> {
    programs
        .iter()
        .map(|program| row(program, points))
        .collect()
}

fn row(program: &Program, points: &[Vec<Precise>]) -> Option<ScaledRow> {
    let points: Vec<&[Precise]> = points.iter().map(Vec::as_slice).collect();
    let found = program.sweep(program.slots()).doubles(&points).ok()?;
    let mut values: Vec<f64> = found.iter().map(|own| own.value).collect();
    let bound = found.iter().fold(0.0_f64, |most, own| most.max(own.bound));
    let largest = values
        .iter()
        .fold(0.0_f64, |largest, value| largest.max(value.abs()));
    if largest == 0.0 {
        return Some(ScaledRow { values, bound: 0.0 });
    }
    for value in &mut values {
        *value /= largest;
    }
    Some(ScaledRow {
        values,
        bound: bound / largest,
    })
}

/// Orthonormal rows.
#[derive(Debug, Default)]
struct Basis {
    rows: Vec<Vec<f64>>,
}

impl Basis {
    /// What is left of a row, and whether that is more than rounding.
    fn rest(&self, row: &ScaledRow) -> (Vec<f64>, bool) {
        let mut rest = row.values.clone();
        // Twice, so that what cancels leaves no rounding behind.
        for _ in 0..2 {
            for own in &self.rows {
                let share = dot(own, &rest);
                rest.iter_mut()
                    .zip(own)
                    .for_each(|(value, own)| *value -= share * own);
            }
        }
        let limit = (ROUNDING + 40.0 * row.bound) * (rest.len() as f64).sqrt();
        let is_more = dot(&rest, &rest).sqrt() > limit;
        (rest, is_more)
    }

    fn add(&mut self, row: &ScaledRow) {
        let (mut rest, is_more) = self.rest(row);
        if is_more {
            let length = dot(&rest, &rest).sqrt();
            for value in &mut rest {
                *value /= length;
            }
            self.rows.push(rest);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
