//! Exponentials and logarithms of small numbers.

use super::Dd;
use super::constants::{
    EXPM1_OF_32NDS, EXPM1_OF_32NDS_CENTRE, INVERSE_FACTORIALS, LN_2_PARTS, LN_2_REST,
};
use crate::numerics::elementary::{exp, ln_1p};
use crate::numerics::exact::two_sum;

/// The integer next to a number below 2^51: the sum rounds to its unit.
#[inline]
fn nearest_integer(x: f64) -> f64 {
    // Halfway up the numbers whose unit is one, so that a negative number does not leave them either.
    const UNIT_ONE: f64 = 6_755_399_441_055_744.0; // 3/2 2^52
    (x + UNIT_ONE) - UNIT_ONE
}

/// Beyond this magnitude the exponential leaves the range of `f64`.
// e^750 is 5e325 and e^-750 is 2e-326: both are out of range, also for the smallest subnormal number.
const EXPONENT_LIMIT: f64 = 750.0;

/// The limit of the exponential where the argument is out of its range or no number.
pub(crate) fn exponent_out_of_range(x: Dd) -> Option<Dd> {
    (x.hi.abs() >= EXPONENT_LIMIT || x.is_nan()).then(|| Dd::from(exp(x.hi)))
}

/// The nearest n to x/ln 2, and x - n ln 2. The products that count are exact, and so is the first difference.
pub(crate) fn halvings(x: Dd) -> (i32, Dd) {
    let n = nearest_integer(x.hi * std::f64::consts::LOG2_E);
    if n == 0.0 {
        return (0, x);
    }
    let (high, low) = two_sum(x.hi - n * LN_2_PARTS[0], x.lo);
    let (high, error) = two_sum(high, -n * LN_2_PARTS[1]);
    let rest = Dd::sum(high, error + (low - n * LN_2_REST.hi));
    (n as i32, rest)
}

/// e^x - 1 for |x| <= 0.35: from that of the nearest 32nd, which is tabulated, and of what is left.
pub(crate) fn small_expm1(x: Dd) -> Dd {
    let nearest = nearest_integer(x.hi * 32.0);
    let rest = tiny_expm1(x - nearest / 32.0);
    let sum = if nearest == 0.0 {
        rest
    } else {
        let tabulated = EXPM1_OF_32NDS[(nearest + EXPM1_OF_32NDS_CENTRE) as usize];
        rest.times_plus(tabulated + 1.0, tabulated)
    };
    Dd::normalized(sum.hi, sum.lo)
}

/// Taylor series of e^x - 1 for |x| <= 1/64. Terms below u of the sum are formed in `f64`, even and odd ones side by side.
fn tiny_expm1(x: Dd) -> Dd {
    // The next term is (1/64)^13/14! = 4e-35 of the sum, less than 2^-106.
    const LAST: usize = 13;
    // (1/64)^7/8! = 6e-18 of the sum, less than 2^-53.
    const FIRST_SHORT: usize = 8;
    let square = x.square();
    let every_other = |last: usize| {
        (FIRST_SHORT..=last)
            .rev()
            .step_by(2)
            .fold(0.0, |sum, n| sum * square.hi + INVERSE_FACTORIALS[n].hi)
    };
    let tail = every_other(LAST - 1) + x.hi * every_other(LAST);
    let last = FIRST_SHORT - 1;
    let start = INVERSE_FACTORIALS[last] + tail * x.hi;
    let sum = (2..last)
        .rev()
        .fold(start, |sum, n| sum.times_plus(x, INVERSE_FACTORIALS[n]));
    sum.times_plus(square, x)
}

/// ln(1 + x) for |x| < 0.75: one Newton step of third order from the value in `f64`.
pub(crate) fn small_ln_1p(x: Dd) -> Dd {
    let start = ln_1p(x.hi);
    let power = Dd::from(start).expm1();
    let step = (x - power) / (power + 1.0);
    step - step.square() * 0.5 + start
}
