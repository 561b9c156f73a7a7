//! Points: exact fractions, rounded where they are printed and nowhere else.

use crate::answer::{Marking, Verdict};
use crate::numerics::Rational;

/// The points of a marking, of this many.
pub fn of_marking(marking: &Marking, of: Rational) -> Rational {
    match marking.verdict {
        Verdict::Missing | Verdict::Unreadable => Rational::ZERO,
        _ => marking
            .credit
            .share()
            .checked_mul(of)
            .unwrap_or(Rational::ZERO),
    }
}

/// Points of which some are not decided yet, `14.95 + ?2.5`.
///
/// ```
/// use vibank::grade::standing;
/// use vibank::numerics::Rational;
///
/// let points = |a, b| Rational::new(a, b).unwrap();
/// assert_eq!(standing(points(299, 20), points(5, 2)), "14.95 + ?2.5");
/// assert_eq!(standing(points(299, 20), points(0, 1)), "14.95");
/// ```
pub fn standing(points: Rational, undecided: Rational) -> String {
    let points = rounded(points);
    if undecided.is_zero() {
        points
    } else {
        format!("{points} + ?{}", rounded(undecided))
    }
}

/// Points as a decimal of at most two places, halves rounded up.
///
/// ```
/// use vibank::grade::rounded;
/// use vibank::numerics::Rational;
///
/// let points = |a, b| rounded(Rational::new(a, b).unwrap());
/// assert_eq!([points(5, 3), points(5, 2), points(4, 1), points(1, 200)], ["1.67", "2.5", "4", "0.01"]);
/// ```
pub fn rounded(points: Rational) -> String {
    let (numerator, denominator) = (points.numerator(), points.denominator());
    let hundredths = numerator
        .checked_mul(200)
        .and_then(|doubled| doubled.checked_add(denominator))
        .map(|doubled| doubled.div_euclid(2 * denominator));
    let Some(hundredths) = hundredths else {
        return points.to_f64().to_string();
    };
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, rest) = (hundredths.abs() / 100, hundredths.abs() % 100);
    match (rest / 10, rest % 10) {
        (0, 0) => format!("{sign}{whole}"),
        (tenths, 0) => format!("{sign}{whole}.{tenths}"),
        _ => format!("{sign}{whole}.{rest:02}"),
    }
}
