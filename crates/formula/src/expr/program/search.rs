//! Roots over any kind of number.

use super::machine::Stop;
use crate::expr::{Doubt, Function, Scalar, Undefined};

/// A function of one number over an interval.
pub(crate) trait SearchedFunction<S> {
    /// The ends of the interval.
    fn ends(&self) -> [S; 2];

    /// The value at a place.
    fn value(&mut self, x: &S) -> Result<S, Stop>;
}

/// Most steps of a search for a root: bisection alone settles the digits of double-double within these.
const MAX_STEPS: usize = 250;

/// Two places, and the values there.
struct SearchBracket<S> {
    x: [S; 2],
    f: [S; 2],
}

/// The zero of a function between two places where its signs differ.
///
/// Chandrupatla's method: inverse quadratic interpolation where three points allow it, bisection elsewhere.
///
/// # References
///
/// T. R. Chandrupatla, Advances in Engineering Software 28 (1997) 145.
pub(crate) fn root<S: Scalar>(curve: &mut impl SearchedFunction<S>) -> Result<S, Stop> {
    let x = curve.ends();
    let f = [curve.value(&x[0])?, curve.value(&x[1])?];
    for (x, f) in x.iter().zip(&f) {
        if sign(f) == 0 {
            return Ok(x.clone());
        }
    }
    if sign(&f[0]) == sign(&f[1]) {
        return Err(Stop::Here(Undefined::NoSignChange));
    }
    let mut bracket = SearchBracket { x, f };
    let start = bracket.width();
    let mut third: Option<(S, S)> = None;
    for _ in 0..MAX_STEPS {
        let part = third
            .as_ref()
            .map_or(0.5, |third| bracket.interpolated(third));
        let width = bracket.x[1].subtract(&bracket.x[0]);
        let scale = bracket.x[0].to_f64().abs().max(bracket.x[1].to_f64().abs());
        let size = width.to_f64().abs();
        let smallest = 4.0 * S::ROUNDOFF * scale;
        // A root at zero has no size; there the interval that was given is the scale.
        if size <= smallest || size <= S::ROUNDOFF * S::ROUNDOFF * start {
            break;
        }
        // Nearer to an end the place would round to it, and the bracket would not shrink.
        let part = part.clamp(0.5 * smallest / size, 1.0 - 0.5 * smallest / size);
        let x = bracket.x[0].add(&width.multiply(&S::exact(part))).centre();
        let f = curve.value(&x)?;
        if sign(&f) == 0 {
            return enclosed(curve, &bracket, x, &f);
        }
        third = Some(bracket.replace(x, f));
    }
    let x = bracket.x[0].clone();
    let f = bracket.f[0].clone();
    enclosed(curve, &bracket, x, &f)
}

/// The zero with a bound beyond which, on both sides, the function has its signs beyond doubt.
///
/// The first guess of the bound is what the value there and the slope imply.
fn enclosed<S: Scalar>(
    curve: &mut impl SearchedFunction<S>,
    bracket: &SearchBracket<S>,
    x: S,
    f: &S,
) -> Result<S, Stop> {
    let [low, high] = curve.ends();
    let length = high.subtract(&low).to_f64().abs();
    let slope = slope(curve, &x, 1e-6 * length);
    let guess = if slope > 0.0 {
        1.1 * (f.to_f64().abs() + f.bound()) / slope
    } else {
        bracket.width()
    };
    let least = (4.0 * S::ROUNDOFF * x.to_f64().abs()).max(S::ROUNDOFF * S::ROUNDOFF * length);
    let mut bound = guess.max(least);
    while bound < length {
        let sides = [-bound, bound].map(|side| within(&x.add(&S::exact(side)), &low, &high));
        let signs = [
            sign(&curve.value(&sides[0])?),
            sign(&curve.value(&sides[1])?),
        ];
        if signs[0] * signs[1] < 0 {
            break;
        }
        bound *= 8.0;
    }
    Ok(x.widened(bound))
}

/// A place moved into the interval.
fn within<S: Scalar>(x: &S, low: &S, high: &S) -> S {
    let place = x.centre();
    let (first, last) = if low.to_f64() <= high.to_f64() {
        (low, high)
    } else {
        (high, low)
    };
    if place.subtract(first).to_f64() < 0.0 {
        return first.clone();
    }
    if place.subtract(last).to_f64() > 0.0 {
        return last.clone();
    }
    place
}

/// The size of the slope near a place, from two values inside the interval.
fn slope<S: Scalar>(curve: &mut impl SearchedFunction<S>, x: &S, reach: f64) -> f64 {
    let [low, high] = curve.ends();
    let (first, last) = (
        low.to_f64().min(high.to_f64()),
        low.to_f64().max(high.to_f64()),
    );
    let around = [-1.0, 1.0].map(|side| (x.to_f64() + side * reach).clamp(first, last));
    let values = around.map(|x| curve.value(&S::exact(x)).map(|f| f.to_f64()));
    match values {
        [Ok(a), Ok(b)] if around[0] < around[1] => ((b - a) / (around[1] - around[0])).abs(),
        _ => 0.0,
    }
}

impl<S: Scalar> SearchBracket<S> {
    fn width(&self) -> f64 {
        self.x[1].subtract(&self.x[0]).to_f64().abs()
    }

    /// Puts a new place first, and keeps the side on which the sign changes; what falls out.
    fn replace(&mut self, x: S, f: S) -> (S, S) {
        let same = sign(&f) == sign(&self.f[0]);
        let mut dropped = (x, f);
        if !same {
            // The first place becomes the second.
            self.x.swap(0, 1);
            self.f.swap(0, 1);
        }
        std::mem::swap(&mut self.x[0], &mut dropped.0);
        std::mem::swap(&mut self.f[0], &mut dropped.1);
        dropped
    }

    /// The part of the interval at which the inverse quadratic through three points is zero; half where it may not serve.
    fn interpolated(&self, (third_x, third_f): &(S, S)) -> f64 {
        let [x1, x2] = [&self.x[0], &self.x[1]].map(Scalar::to_f64);
        let [f1, f2] = [&self.f[0], &self.f[1]].map(Scalar::to_f64);
        let (x3, f3) = (third_x.to_f64(), third_f.to_f64());
        // Differences of places are taken with all digits.
        let span = self.x[1].subtract(&self.x[0]).to_f64();
        let beyond = third_x.subtract(&self.x[0]).to_f64();
        let xi = (x1 - x2) / (x3 - x2);
        let phi = (f1 - f2) / (f3 - f2);
        let serves = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        let part =
            f1 / (f2 - f1) * f3 / (f2 - f3) + beyond / span * f1 / (f3 - f1) * f2 / (f3 - f2);
        if serves && part.is_finite() {
            part
        } else {
            0.5
        }
    }
}

/// −1, 0 or 1; 0 where the number cannot be told from zero.
fn sign<S: Scalar>(f: &S) -> i8 {
    match f.unary(Function::Sign, &mut Doubt::default()) {
        Ok(sign) => sign.to_f64() as i8,
        Err(_) => 0,
    }
}
