//! Two functions at one point: the same, different, or not to be told apart.

use crate::expr::{Approx, Field, Precise, Program, Registers, Scalar};
use crate::numerics::Dd;

/// Values that differ by more than this part are different, whatever their decimals.
// π as a pocket calculator shows it, 3.141592654, is off by 1.3e-10 of it.
pub(crate) const DIFFERENT: f64 = 1e-9;
/// Bounds below this part of a value leave no doubt in binary64.
// A thousandth of `DIFFERENT`; with wider bounds double-double decides.
const SURE: f64 = 1e-12;

/// How two functions compare at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum AtPoint {
    /// They are equal within their bounds, which are small.
    Same,
    /// They differ, by less than a billionth, as the decimals of a constant may.
    Close { part: f64 },
    /// They differ.
    Different { part: f64, ratio: Option<f64> },
    /// The second has no value.
    Undefined,
    /// Their bounds are too wide to tell.
    Undecided,
}

/// Registers for both functions, with the usual digits and with twice as many.
#[derive(Default)]
pub(crate) struct Rooms {
    pub(crate) first: Registers<Approx<f64>>,
    second: Registers<Approx<f64>>,
    wide_first: Registers<Approx<Dd>>,
    wide_second: Registers<Approx<Dd>>,
}

impl Rooms {
    /// Compares a function with a key where the key has a value.
    pub(crate) fn at(&mut self, key: &Program, other: &Program, point: &[Precise]) -> AtPoint {
        let quick = judge(key, other, point, SURE, &mut self.first, &mut self.second);
        if !matches!(quick, AtPoint::Undecided | AtPoint::Undefined) {
            return quick;
        }
        let (first, second) = (&mut self.wide_first, &mut self.wide_second);
        judge(key, other, point, 0.25 * DIFFERENT, first, second)
    }
}

/// Compares two values; bounds above `sure` of them decide nothing.
fn judge<S: Scalar>(
    key: &Program,
    other: &Program,
    point: &[Precise],
    sure: f64,
    first: &mut Registers<S>,
    second: &mut Registers<S>,
) -> AtPoint {
    // Without a value of the key, or where it hangs on a tie, the point says nothing.
    let Ok(reference) = key.run(point, first) else {
        return AtPoint::Undecided;
    };
    let Ok(typed) = other.run(point, second) else {
        return AtPoint::Undefined;
    };
    if reference.is_open || typed.is_open {
        return AtPoint::Undecided;
    }
    let (Some(a), Some(b)) = (
        Complex::of(key, reference.numbers()),
        Complex::of(other, typed.numbers()),
    ) else {
        return AtPoint::Undecided;
    };
    let difference = a.distance(&b);
    let (size, bound) = (a.size(), a.bound() + b.bound());
    if difference.is_nan() || bound.is_nan() {
        return AtPoint::Undecided;
    }
    if difference <= 4.0 * bound {
        let is_sure = bound <= sure * size || bound == 0.0;
        return if is_sure {
            AtPoint::Same
        } else {
            AtPoint::Undecided
        };
    }
    let part = difference / size.max(f64::MIN_POSITIVE);
    if part <= DIFFERENT {
        return AtPoint::Close { part };
    }
    let ratio = (size > 0.0).then(|| a.ratio_of(&b)).flatten();
    AtPoint::Different { part, ratio }
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

    /// The real factor between this value and the other, if there is one.
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
