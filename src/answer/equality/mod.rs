//! Whether two formulas are the same function.
//!
//! 1. Rational formulas that differ [modulo two primes](residue) are different; those that agree are the same
//!    unless the points find them different.
//! 2. All formulas are evaluated at points that are drawn around typical data of the item, a decade to either side, where
//!    the [constraints](domain) of the item hold: at real numbers between the steps of the grid, at integers where a
//!    datum is one by its meaning. A datum that is negative on the sheet stays so; one that may be negative, and letters
//!    without data, have both signs. Nothing else of a sheet counts: the same formula has the same verdict on all.
//!    Each value comes with a running bound on the rounding errors.
//!    At a point two values are the same where they differ by less than four times the sum of their bounds,
//!    and the bounds are small; where the bounds are not, the point is computed again with twice the digits,
//!    and then passed over. Values that differ by more than their bounds are different, however near: only
//!    decimals of ten digits and more may stand for a constant.
//! 3. A point where the answer has no value and the key has one counts against it; two such points decide.
//! 4. What is the same there is compared at [complex points](complex) nearby.
//! 5. Where no point decides, formulas that agree with roots and functions as fresh variables are the same.
//!
//! So a coefficient off by a millionth is found, while an expanded power passes that loses most of its digits.
//! The points follow from a fixed seed: a verdict can be repeated.

mod complex;
mod domain;
mod draw;
mod drawn;
mod judge;
mod residue;

use std::sync::Arc;

pub(crate) use self::domain::Condition;
use self::draw::Ties;
pub(crate) use self::draw::{Around, Draws};
pub(crate) use self::drawn::{BySigns, Signs};
pub use self::drawn::{Drawn, Sampling};
use self::judge::{AtPoint, DIFFERENT, Rooms};
use self::residue::Residue;
use super::meaning::Meaning;
use crate::expr::{CompileError, Expr, Field, Kind, Name, Precise, Program, Registers};
use crate::numerics::SortedMap;

/// Points at which formulas are compared.
// At a random point two different analytic formulas agree with probability zero; the others guard against points at
// which a formula has no value or no digits left.
const POINTS: usize = 8;
/// Points that are drawn, so that some may be passed over.
const DRAWN: usize = 12;
/// Points that have to decide.
const MIN_COUNT: usize = 4;
/// Draws until as many points have a key.
// Twenty for each point that is drawn.
const MAX_DRAWS: usize = 240;
/// Half the width of the draws, in decades: what holds for the data holds for data ten times as large or small, as long
/// as the constraints of the item do.
const WIDEST: f64 = 1.0;
/// A decimal with as many digits may stand for a constant that has no end.
const LONG: i128 = 1_000_000_000;

/// A formula made ready to be compared.
#[derive(Debug)]
pub(crate) struct Comparable {
    program: Program,
    complex: Option<Program>,
    residue: Option<Residue>,
    has_long_decimals: bool,
}

impl Comparable {
    /// A formula in the names of an item; `replaced` stand in for names.
    pub(crate) fn of(
        meaning: &Meaning,
        expr: &Expr,
        replaced: &SortedMap<Name, Expr>,
    ) -> Result<Self, CompileError> {
        let mut has_long_decimals = false;
        expr.walk(&mut |node| {
            if let Kind::Number(value) = node.kind() {
                has_long_decimals |= value.numerator().abs().max(value.denominator()) >= LONG;
            }
        });
        let residue = Residue::of(meaning, expr, replaced);
        let is_rational = residue.is_some_and(Residue::is_rational);
        Ok(Self {
            program: meaning.compile(expr, replaced)?,
            complex: (!is_rational)
                .then(|| complex::program(meaning, expr, replaced))
                .flatten(),
            residue,
            has_long_decimals,
        })
    }

    /// Whether its values are complex numbers.
    pub(crate) fn is_complex(&self) -> bool {
        self.program.form().field == Field::Complex
    }

    /// Whether another function comes near this one, within a part of it, for data of an instance and any values of
    /// what is none.
    pub(crate) fn is_near(
        &self,
        other: &Self,
        meaning: &Meaning,
        data: Vec<Option<f64>>,
        part: f64,
    ) -> bool {
        let mut around = Around::new(meaning, data);
        let (data, mut rooms) = (around.free_point(0.0), Rooms::default());
        let mut points = (0..MIN_COUNT).map(|_| around.point_beside(&data, 0.6));
        points.all(
            |point| match rooms.at(&self.program, &other.program, &point) {
                AtPoint::Same | AtPoint::Close { .. } => true,
                AtPoint::Different { part: own, .. } => own <= part,
                AtPoint::Undefined | AtPoint::Undecided => false,
            },
        )
    }

    fn residues(&self, other: &Self) -> Option<bool> {
        self.residue?.same(other.residue?)
    }

    fn is_rational_beside(&self, other: &Self) -> bool {
        let is_rational = |formula: &Self| formula.residue.is_some_and(Residue::is_rational);
        is_rational(self) && is_rational(other)
    }
}

/// The points at which answers are compared with a key.
#[derive(Debug)]
pub(crate) struct Points {
    points: Vec<Arc<[Precise]>>,
    ties: Ties,
}

/// How two functions compare.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Comparison {
    /// They are the same.
    Same,
    /// They differ.
    Different {
        /// The second over the first, if that is the same number at all points.
        ratio: Option<f64>,
        /// The largest difference as a part of the first.
        part: f64,
    },
    /// The second has no value where the first has one.
    Undefined,
    /// Neither the same nor different: all digits are lost when it is computed.
    Undecided,
}

impl Points {
    /// Points around typical data of an item, with these signs, at which all of the keys have values.
    pub(crate) fn around(
        meaning: &Meaning,
        sampling: &Sampling<'_>,
        signs: &Signs,
        keys: &[&Comparable],
    ) -> Self {
        let mut rooms = Rooms::default();
        let mut is_defined = |point: &Arc<[Precise]>| {
            let mut keys = keys.iter();
            keys.all(|key| key.program.run(&point[..], &mut rooms.first).is_ok())
        };
        let mut points = Vec::new();
        let mut around = sampling.around(meaning, signs, |point| {
            points.extend(is_defined(point).then(|| Arc::clone(point)));
            points.len() == DRAWN
        });
        // Constraints that hardly any data meet leave no points: then those around the data have to do.
        for attempt in 0..MAX_DRAWS {
            if points.len() >= MIN_COUNT {
                break;
            }
            let point = around.free_point(WIDEST * (1.0 - attempt as f64 / MAX_DRAWS as f64));
            points.extend(Some(point.into()).filter(&mut is_defined));
        }
        let ties = around.ties();
        Self { points, ties }
    }

    /// Whether all of some conditions hold at one of the points.
    pub(crate) fn meet(&self, conditions: &[Condition]) -> bool {
        let mut room = Registers::default();
        let mut points = self.points.iter();
        points.any(|point| {
            let mut all = conditions.iter();
            all.all(|condition| condition.holds(point, &mut room))
        })
    }

    /// Compares a function with a key.
    pub(crate) fn compare(&self, key: &Comparable, other: &Comparable) -> Comparison {
        // What is equal to something else is no variable of its own: then points alone decide.
        let is_tied = self.ties.is_some_equal;
        let residues = key.residues(other).filter(|same| *same || !is_tied);
        // Modulo a prime nothing knows that two letters are tied.
        let is_certain = key.is_rational_beside(other) && !is_tied;
        let sampled = self.sample(key, other);
        let is_found_different = sampled.differs || sampled.is_close;
        if is_certain && residues == Some(true) && !is_found_different {
            return Comparison::Same;
        }
        if sampled.decided() < MIN_COUNT.min(self.points.len()) || self.points.is_empty() {
            return match residues {
                Some(true) if !is_found_different => Comparison::Same,
                _ if sampled.undefined > 0 => Comparison::Undefined,
                _ => Comparison::Undecided,
            };
        }
        if sampled.undefined >= 2 || sampled.undefined == sampled.decided() {
            return Comparison::Undefined;
        }
        let is_different = sampled.differs
            || (sampled.is_close || is_certain) && !other.has_long_decimals
            || !is_tied && self.differ_off_the_axis(key, other);
        if !is_different {
            return Comparison::Same;
        }
        Comparison::Different {
            ratio: sampled.ratio(),
            part: sampled.part,
        }
    }

    fn sample(&self, key: &Comparable, other: &Comparable) -> Sampled {
        let mut rooms = Rooms::default();
        let mut sampled = Sampled::default();
        for point in &self.points {
            sampled.take(rooms.at(&key.program, &other.program, point));
            if sampled.decided() == POINTS {
                break;
            }
        }
        sampled
    }

    fn differ_off_the_axis(&self, key: &Comparable, other: &Comparable) -> bool {
        match (&key.complex, &other.complex) {
            (Some(key), Some(other)) => {
                complex::differ(key, other, &self.points, &self.ties.are_integers)
            }
            _ => false,
        }
    }
}

/// What the points say together.
#[derive(Debug, Default)]
struct Sampled {
    same: usize,
    other: usize,
    undefined: usize,
    differs: bool,
    is_close: bool,
    part: f64,
    ratios: Vec<f64>,
}

impl Sampled {
    fn take(&mut self, at: AtPoint) {
        match at {
            AtPoint::Same => {
                self.same += 1;
                self.ratios.push(1.0);
            }
            AtPoint::Close { part } => {
                self.other += 1;
                self.is_close = true;
                self.part = self.part.max(part);
                self.ratios.push(1.0);
            }
            AtPoint::Different { part, ratio } => {
                self.other += 1;
                self.differs = true;
                self.part = self.part.max(part);
                self.ratios.push(ratio.unwrap_or(f64::NAN));
            }
            AtPoint::Undefined => self.undefined += 1,
            AtPoint::Undecided => {}
        }
    }

    fn decided(&self) -> usize {
        self.same + self.other + self.undefined
    }

    /// The ratio, if it is one at all points.
    fn ratio(&self) -> Option<f64> {
        let first = *self.ratios.first()?;
        let is_one = |own: &f64| (own - first).abs() <= DIFFERENT * first.abs();
        self.ratios.iter().all(is_one).then_some(first)
    }
}
