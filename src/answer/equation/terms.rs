//! Equations taken apart into terms: the coefficient of each unknown and of its time derivatives.

use super::Setup;
use crate::answer::meaning::ORDERS;
use crate::expr::{Approx, Precise, Program, Registers};

/// A term: an unknown or a time derivative of one, or what stands without unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Term {
    Unknown { place: usize, order: usize },
    Rest,
}

/// How a term depends on what it is a term in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Nature {
    /// In proportion.
    Linear,
    /// By its sign alone, as dry friction.
    Sign,
    /// In another way, as the sine of an angle.
    Curved,
}

/// The coefficients of an equation for one choice of data.
#[derive(Clone, Debug)]
pub(crate) struct Coefficients {
    /// What each term adds where its unknown is 1 and all others are 0; for the rest, the value where all are 0.
    pub(crate) values: Vec<f64>,
    /// The same for a small unknown, by its size.
    pub(crate) slopes: Vec<f64>,
}

/// Coefficients that differ by more than this part are different.
const DIFFERENT: f64 = 1e-9;
/// A small motion, at which a sine is its angle to less than [`DIFFERENT`]; how far it may be from it all the same.
const SMALL: f64 = 1e-5;
// A slope over so small a step has lost five of its sixteen digits.
const NEARLY: f64 = 1e-6;

/// The terms that equations in these unknowns can have.
pub(crate) fn terms(setup: &Setup) -> Vec<Term> {
    let mut terms = Vec::new();
    for name in &setup.unknowns {
        if let Some(place) = setup.meaning.place(name) {
            terms.extend((0..3).rev().map(|order| Term::Unknown { place, order }));
        }
    }
    terms.push(Term::Rest);
    terms
}

impl Coefficients {
    /// Those of an equation at a point, whose unknowns do not matter.
    pub(crate) fn of(program: &Program, terms: &[Term], point: &[Precise]) -> Option<Self> {
        let mut zero = point.to_vec();
        for term in terms {
            if let Term::Unknown { place, .. } = term {
                zero[place * ORDERS..(place + 1) * ORDERS].fill(Precise::exact(0.0));
            }
        }
        let mut room = Registers::<Approx<f64>>::default();
        let rest = value(program, &zero, &mut room)?;
        let (mut values, mut slopes) = (Vec::new(), Vec::new());
        for term in terms {
            let Term::Unknown { place, order } = term else {
                values.push(rest);
                slopes.push(rest);
                continue;
            };
            let slot = place * ORDERS + order;
            let mut moved = |size: f64| {
                zero[slot] = Precise::exact(size);
                let moved = value(program, &zero, &mut room);
                zero[slot] = Precise::exact(0.0);
                let difference = moved? - rest;
                // Over a step of 1e-5 the rounding of a large rest would pass for a slope.
                let is_rounding = difference.abs() <= 1e-13 * rest.abs();
                Some(if is_rounding { 0.0 } else { difference / size })
            };
            values.push(moved(1.0)?);
            slopes.push(moved(SMALL)?);
        }
        Some(Self { values, slopes })
    }

    /// How the term of this place depends on its unknown.
    pub(crate) fn nature(&self, place: usize) -> Nature {
        let (value, slope) = (self.values[place], self.slopes[place]);
        if (value - slope).abs() <= NEARLY * slope.abs() {
            Nature::Linear
        } else if (value - SMALL * slope).abs() <= NEARLY * value.abs() {
            Nature::Sign
        } else {
            Nature::Curved
        }
    }

    /// Those of the same equation for small motions.
    pub(crate) fn linearized(&self) -> Self {
        Self {
            values: self.slopes.clone(),
            slopes: self.slopes.clone(),
        }
    }

    /// Whether these are those for small motions.
    pub(crate) fn are_linearized(&self) -> bool {
        self.values == self.slopes
    }

    /// Whether these are a multiple of others but for rounding, each number by less than this part of it.
    pub(crate) fn are_nearly(&self, other: &Self, part: f64) -> bool {
        let pairs = || self.values.iter().zip(&other.values);
        let agree = |scale: f64| {
            // Two numbers are rounded, this one and that of the scale.
            let is_near =
                |(own, other): (&f64, &f64)| (own - scale * other).abs() <= 2.0 * part * own.abs();
            pairs().all(is_near)
        };
        let mut scales = pairs().filter(|(own, other)| **own != 0.0 && **other != 0.0);
        self.is_linear() && other.is_linear() && scales.any(|(own, other)| agree(own / other))
    }

    /// Whether no term is curved.
    pub(crate) fn is_linear(&self) -> bool {
        (0..self.values.len()).all(|place| self.nature(place) != Nature::Curved)
    }
}

/// The value at a point; what cannot be distinguished from zero is zero.
fn value(program: &Program, point: &[Precise], room: &mut Registers<Approx<f64>>) -> Option<f64> {
    let outcome = program.run(point, room).ok()?;
    let number = outcome.numbers().next()?;
    let is_zero = number.value.abs() <= 8.0 * number.bound;
    Some(if is_zero { 0.0 } else { number.value })
}

/// The factor between two equations under which most terms agree.
#[derive(Clone, Debug)]
pub(crate) struct Match {
    /// A term that agrees.
    pub(crate) reference: usize,
    /// The terms that do not.
    pub(crate) differing: Vec<usize>,
    /// The second equation over the first.
    pub(crate) scale: f64,
    /// How many terms agree that are there.
    agreeing: usize,
}

impl Match {
    /// The best match of two lists of coefficients; among equals, that without a factor.
    pub(crate) fn of(own: &[f64], found: &[f64]) -> Option<Self> {
        let mut best: Option<Self> = None;
        for reference in 0..own.len() {
            if own[reference] == 0.0 || found[reference] == 0.0 {
                continue;
            }
            let scale = found[reference] / own[reference];
            let agrees = |place: &usize| is_same(scale * own[*place], found[*place]);
            let candidate = Self {
                reference,
                differing: (0..own.len()).filter(|place| !agrees(place)).collect(),
                scale,
                agreeing: (0..own.len())
                    .filter(|place| own[*place] != 0.0 && agrees(place))
                    .count(),
            };
            if best.as_ref().is_none_or(|best| candidate.is_better(best)) {
                best = Some(candidate);
            }
        }
        best
    }

    fn is_better(&self, other: &Self) -> bool {
        // Inertia is rarely what is wrong: rather than with another sign the equation is as it was typed.
        let rank = |of: &Self| (of.differing.len(), !of.is_plain(), of.scale < 0.0);
        rank(self) < rank(other)
    }

    /// Whether the equations are written without a factor between them.
    pub(crate) fn is_plain(&self) -> bool {
        is_same(self.scale.abs(), 1.0)
    }

    /// Whether enough agrees to tell what does not.
    pub(crate) fn is_telling(&self) -> bool {
        match self.differing.len() {
            0 | 1 => true,
            2 => self.is_plain() || self.agreeing >= 2,
            _ => false,
        }
    }
}

/// Whether two coefficients are one number.
pub(crate) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= DIFFERENT * a.abs().max(b.abs())
}

/// Whether two slopes agree as far as a small motion can tell.
pub(crate) fn is_nearly(a: f64, b: f64) -> bool {
    (a - b).abs() <= NEARLY * a.abs().max(b.abs())
}
