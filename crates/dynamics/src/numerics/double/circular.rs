//! Sine and cosine of small angles, and the angles of the axes.

use super::Dd;
use super::constants::INVERSE_FACTORIALS;
use crate::numerics::elementary::sin;

/// Taylor series of the sine for |x| <= π/4.
pub(crate) fn small_sin(x: Dd) -> Dd {
    x + x * x.square() * alternating::<3>(x.square())
}

/// Taylor series of the cosine for |x| <= π/4.
pub(crate) fn small_cos(x: Dd) -> Dd {
    let square = x.square();
    square * alternating::<2>(square) + 1.0
}

/// -1/n! + x/(n+2)! - x²/(n+4)! + ... to 1/29!. Terms below u of the sum are formed in `f64`.
fn alternating<const FIRST: usize>(x: Dd) -> Dd {
    // At π/4 the term of 1/17! is 6e-17 of the sine, less than 2^-53; that of 1/18! is 2e-18 of the
    // cosine.
    const SHORT: usize = 17;
    let odd = FIRST & 1;
    let sign = |n: usize| if (n - odd) & 2 == 0 { 1.0 } else { -1.0 };
    let orders = |from: usize, to: usize| (from..to).filter(move |n| n & 1 == odd).rev();
    let tail = orders(SHORT, 30).fold(0.0, |sum, n| {
        sum * x.hi + sign(n) * INVERSE_FACTORIALS[n].hi
    });
    orders(FIRST, SHORT).fold(Dd::from(tail), |sum, n| {
        let term = INVERSE_FACTORIALS[n];
        sum.times_plus(x, if sign(n) < 0.0 { -term } else { term })
    })
}

/// sin x and 1 - cos x: three terms of their series below 2^-9, where the next are below u.
#[inline]
pub(crate) fn small_angle(x: f64) -> (f64, f64) {
    if x.abs() < 0.002 {
        let square = x * x;
        let sine = x - x * square * (1.0 / 6.0 - square / 120.0);
        (
            sine,
            square * (0.5 - square * (1.0 / 24.0 - square / 720.0)),
        )
    } else {
        let half = sin(0.5 * x);
        (sin(x), 2.0 * half * half)
    }
}

/// The multiple of π/4 that was rounded to this angle, or the angle itself.
pub(crate) fn on_axis(angle: f64) -> Dd {
    // On an axis the angle is known: a rounded π would be carried on with 53 bits.
    let eighths = angle / Dd::FRAC_PI_4.hi;
    if eighths == eighths.trunc() {
        Dd::FRAC_PI_4 * eighths
    } else {
        Dd::from(angle)
    }
}
