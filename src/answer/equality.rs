//! Whether two formulas are the same function.
//!
//! Both are evaluated at points that are drawn around the data of the instance, over a decade and a half,
//! with both signs where a name may be negative, and with a running bound on the rounding errors. At a
//! point two values are the same where they differ by less than four times the sum of their bounds, and
//! different where they differ by more than 1e-9 of their size; in between they are computed again with
//! twice the digits. So a coefficient off by a millionth is found, while an expanded power passes that
//! loses most of its digits in binary64.
//!
//! A point where one of the two has no value counts against the answer; two such points decide.
//! The points follow from a fixed seed: a verdict can be repeated.

use super::meaning::{Meaning, ORDERS};
use crate::expr::{Approx, Field, Precise, Program, Registers, Scalar};
use crate::numerics::{Dd, pow};
use crate::quantity::Evaluation;

/// Points at which formulas are compared.
const POINTS: usize = 8;
/// Draws until as many points have a key.
const MOST_DRAWS: usize = 120;
/// Values that differ by more than this part are different.
const DIFFERENT: f64 = 1e-9;
/// Bounds below this part of a value leave no doubt.
const SURE: f64 = 1e-12;
/// Half the width of the draws, in decades.
const WIDEST: f64 = 0.75;

/// The points at which answers are compared with a key.
#[derive(Debug)]
pub(super) struct Points(Vec<Vec<Precise>>);

/// How two functions compare.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Comparison {
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
}

/// Numbers from a fixed seed (SplitMix64).
pub(super) struct Draws(u64);

impl Draws {
    pub(super) fn new() -> Self {
        Self(0x5eed_0f70_1234_abcd)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// A number from −1 to 1.
    pub(super) fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The inputs around the data of an instance.
pub(super) struct Around<'a> {
    meaning: &'a Meaning,
    centres: Vec<Option<f64>>,
    draws: Draws,
}

impl<'a> Around<'a> {
    pub(super) fn new(meaning: &'a Meaning, evaluation: &Evaluation<'_>) -> Self {
        let centres = (0..meaning.inputs.len())
            .map(|place| meaning.value(place, evaluation))
            .collect();
        Self {
            meaning,
            centres,
            draws: Draws::new(),
        }
    }

    /// A point within `spread` decades of the data; data keep their sign unless `flips`, and pure whole data stay whole
    /// if asked for.
    pub(super) fn point(&mut self, spread: f64, flips: bool, keeps_whole: bool) -> Vec<Precise> {
        let mut point = Vec::with_capacity(self.centres.len() * ORDERS);
        for (input, centre) in self.meaning.inputs.iter().zip(&self.centres) {
            for order in 0..ORDERS {
                if order > 0 && !input.is_moving {
                    point.push(Precise::exact(0.0));
                    continue;
                }
                let size = centre.map_or(0.6, f64::abs);
                let size = if size == 0.0 { 1.0 } else { size };
                let mut value = size * pow(10.0, spread * self.draws.signed());
                let is_negative = match centre {
                    Some(centre) if !(flips && input.is_signed) => *centre < 0.0,
                    _ => input.is_signed && self.draws.signed() < 0.0,
                };
                if keeps_whole && centre.is_some_and(|centre| centre == centre.round()) {
                    value = value.round().max(1.0);
                }
                point.push(Precise::exact(if is_negative { -value } else { value }));
            }
        }
        point
    }
}

impl Points {
    /// Points around the data of an instance at which all of these have values.
    pub(super) fn around(
        meaning: &Meaning,
        evaluation: &Evaluation<'_>,
        keys: &[&Program],
    ) -> Self {
        let mut around = Around::new(meaning, evaluation);
        let mut rooms = Rooms::default();
        let mut points = Vec::new();
        for attempt in 0..MOST_DRAWS {
            // What has no value far from the data may have one near to them.
            let share = attempt as f64 / MOST_DRAWS as f64;
            let spread = WIDEST * (1.0 - share).max(0.02);
            let point = around.point(spread, share < 0.5, attempt % 4 == 3 || share > 0.6);
            let is_defined = keys
                .iter()
                .all(|key| key.run(&point[..], &mut rooms.first).is_ok());
            if is_defined {
                points.push(point);
            }
            if points.len() == POINTS {
                break;
            }
        }
        Self(points)
    }

    /// Compares a function with a key.
    pub(super) fn compare(&self, key: &Program, other: &Program) -> Comparison {
        let mut rooms = Rooms::default();
        let (mut part, mut undefined, mut is_same) = (0.0_f64, 0, true);
        let mut ratio = Ratio::Unknown;
        for point in &self.0 {
            match rooms.at(key, other, point) {
                AtPoint::Same => ratio = ratio.with(1.0),
                AtPoint::Undefined => undefined += 1,
                AtPoint::Different { difference, own } => {
                    is_same = false;
                    part = part.max(difference);
                    ratio = match own {
                        Some(own) => ratio.with(own),
                        None => Ratio::Varies,
                    };
                }
            }
        }
        if undefined >= 2 || self.0.is_empty() || undefined == self.0.len() {
            return Comparison::Undefined;
        }
        if is_same {
            return Comparison::Same;
        }
        let ratio = match ratio {
            Ratio::One(ratio) => Some(ratio),
            _ => None,
        };
        Comparison::Different { ratio, part }
    }
}

enum Ratio {
    Unknown,
    One(f64),
    Varies,
}

impl Ratio {
    fn with(self, other: f64) -> Self {
        match self {
            Self::Unknown => Self::One(other),
            Self::One(own) if (own - other).abs() <= DIFFERENT * own.abs() => Self::One(own),
            _ => Self::Varies,
        }
    }
}

enum AtPoint {
    Same,
    Different { difference: f64, own: Option<f64> },
    Undefined,
}

#[derive(Default)]
struct Rooms {
    first: Registers<Approx<f64>>,
    second: Registers<Approx<f64>>,
    wide_first: Registers<Approx<Dd>>,
    wide_second: Registers<Approx<Dd>>,
}

impl Rooms {
    fn at(&mut self, key: &Program, other: &Program, point: &[Precise]) -> AtPoint {
        let quick = judge(key, other, point, &mut self.first, &mut self.second);
        match quick {
            Some(Judgement { is_sure: true, at }) => at,
            _ => match judge(
                key,
                other,
                point,
                &mut self.wide_first,
                &mut self.wide_second,
            ) {
                Some(Judgement { at, .. }) => at,
                // The key has no value with more digits: the point says nothing.
                None => AtPoint::Undefined,
            },
        }
    }
}

struct Judgement {
    is_sure: bool,
    at: AtPoint,
}

/// Compares two values at a point; `None` where the key has none.
fn judge<S: Scalar>(
    key: &Program,
    other: &Program,
    point: &[Precise],
    first: &mut Registers<S>,
    second: &mut Registers<S>,
) -> Option<Judgement> {
    let reference = key.run(point, first).ok()?;
    let Ok(typed) = other.run(point, second) else {
        return Some(Judgement {
            is_sure: false,
            at: AtPoint::Undefined,
        });
    };
    let a = Complex::of(key, reference.numbers())?;
    let b = Complex::of(other, typed.numbers())?;
    let difference = a.distance(&b);
    let (size, bound) = (a.size(), a.bound() + b.bound());
    let is_within = difference <= 4.0 * bound;
    let is_different = difference > DIFFERENT * size && !is_within;
    let is_sure =
        is_different || is_within && bound <= SURE * size || difference == 0.0 && bound == 0.0;
    let at = if is_different {
        let own = (size > 0.0).then(|| a.ratio_of(&b)).flatten();
        AtPoint::Different {
            difference: difference / size.max(f64::MIN_POSITIVE),
            own,
        }
    } else {
        AtPoint::Same
    };
    Some(Judgement { is_sure, at })
}

/// A real or complex value.
struct Complex<S> {
    re: S,
    im: S,
}

impl<S: Scalar> Complex<S> {
    fn of<'a>(program: &Program, mut numbers: impl Iterator<Item = &'a S>) -> Option<Self>
    where
        S: 'a,
    {
        let re = numbers.next()?.clone();
        let im = match program.form().field {
            Field::Complex => numbers.next()?.clone(),
            _ => S::exact(0.0),
        };
        Some(Self { re, im })
    }

    fn size(&self) -> f64 {
        self.re.to_f64().abs() + self.im.to_f64().abs()
    }

    fn bound(&self) -> f64 {
        self.re.bound() + self.im.bound()
    }

    fn distance(&self, other: &Self) -> f64 {
        self.re.subtract(&other.re).to_f64().abs() + self.im.subtract(&other.im).to_f64().abs()
    }

    /// The real number of which the other is so many times this.
    fn ratio_of(&self, other: &Self) -> Option<f64> {
        let (a, b) = (
            (self.re.to_f64(), self.im.to_f64()),
            (other.re.to_f64(), other.im.to_f64()),
        );
        let size = a.0 * a.0 + a.1 * a.1;
        let (re, im) = (
            (b.0 * a.0 + b.1 * a.1) / size,
            (b.1 * a.0 - b.0 * a.1) / size,
        );
        (im.abs() <= DIFFERENT * re.abs()).then_some(re)
    }
}
