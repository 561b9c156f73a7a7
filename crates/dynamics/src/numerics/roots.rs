//! Zeros of a function of one variable.

use thiserror::Error;

/// Why no zero was found.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RootError {
    /// The function has the same sign at both ends.
    #[error("the function has the same sign at {lower} and at {upper}")]
    NotBracketed {
        /// Lower end of the interval.
        lower: f64,
        /// Upper end of the interval.
        upper: f64,
    },
    /// The function is undefined inside the interval, or an end of the interval is infinite.
    #[error("the function is undefined at {at}")]
    Undefined {
        /// The place.
        at: f64,
    },
}

/// A zero of `f` between two places where its signs differ, to the absolute `tolerance` or to the last digit.
///
/// The interval shrinks by interpolation, truncation and projection: superlinearly on smooth functions and never slower
/// than bisection plus one step, whatever the function. A tolerance of zero asks for two neighbouring numbers.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::{bracketed_root, cos};
///
/// let fixed_point = bracketed_root(|x| cos(x) - x, 0.0, 1.0, 0.0).unwrap();
/// assert_eq!(fixed_point, 0.7390851332151607);
/// ```
///
/// # Errors
///
/// [`RootError::NotBracketed`] where the signs at the ends agree, [`RootError::Undefined`] where `f` gives NaN.
///
/// # References
///
/// I. F. D. Oliveira, R. H. C. Takahashi, ACM TOMS 47:5 (2020).
pub fn bracketed_root(
    f: impl FnMut(f64) -> f64,
    lower: f64,
    upper: f64,
    tolerance: f64,
) -> Result<f64, RootError> {
    let mut f = f;
    let mut value = |at: f64| {
        Some(f(at))
            .filter(|y| !y.is_nan())
            .ok_or(RootError::Undefined { at })
    };
    let (start, end) = (
        BracketEnd {
            x: lower,
            y: value(lower)?,
        },
        BracketEnd {
            x: upper,
            y: value(upper)?,
        },
    );
    for known in [start, end] {
        if known.y == 0.0 {
            return Ok(known.x);
        }
    }
    if start.y.is_sign_negative() == end.y.is_sign_negative() {
        return Err(RootError::NotBracketed { lower, upper });
    }
    let mut bracket = SignBracket::new(start, end, tolerance);
    while let Some(at) = bracket.next() {
        bracket.cut(BracketEnd {
            x: at,
            y: value(at)?,
        });
    }
    Ok(bracket.best())
}

#[derive(Clone, Copy)]
struct BracketEnd {
    x: f64,
    y: f64,
}

/// Two places where the signs differ, and how far from the middle the next one may lie.
struct SignBracket {
    low: BracketEnd,
    high: BracketEnd,
    tolerance: f64,
    truncation: f64,
    radius: f64,
}

impl SignBracket {
    fn new(start: BracketEnd, end: BracketEnd, tolerance: f64) -> Self {
        let (low, high) = if start.x <= end.x {
            (start, end)
        } else {
            (end, start)
        };
        // Halved first: the length of an interval across all numbers would overflow.
        let half = 0.5 * high.x - 0.5 * low.x;
        Self {
            low,
            high,
            tolerance: tolerance.max(0.0),
            // The authors' parameters: κ1 = 0.2/(b - a), κ2 = 2, and n0 = 1, the one step more than bisection
            // takes.
            truncation: 0.1 / half,
            radius: 2.0 * half,
        }
    }

    /// The next place to look at; none if the interval is as small as asked or cannot be split.
    fn next(&mut self) -> Option<f64> {
        let half = 0.5 * self.high.x - 0.5 * self.low.x;
        let middle = self.low.x + half;
        self.radius *= 0.5;
        // With neighbouring numbers the middle rounds to an end, and no tolerance would ever be met.
        if half <= self.tolerance || middle <= self.low.x || middle >= self.high.x {
            return None;
        }
        let slack = (self.radius * 2.0 - half).max(0.0);
        let secant = self.secant().unwrap_or(middle);
        let side = (middle - secant).signum();
        let step = 4.0 * self.truncation * half * half;
        let truncated = if step <= (middle - secant).abs() {
            secant + side * step
        } else {
            middle
        };
        let projected = if (truncated - middle).abs() <= slack {
            truncated
        } else {
            middle - side * slack
        };
        Some(if projected > self.low.x && projected < self.high.x {
            projected
        } else {
            middle
        })
    }

    /// Where the chord crosses zero.
    fn secant(&self) -> Option<f64> {
        let share = self.low.y / (self.low.y - self.high.y);
        let x = self.low.x + share * (self.high.x - self.low.x);
        // A function may be infinite at an end, as a tangent is; then the chord says nothing, and the middle
        // serves.
        x.is_finite().then_some(x)
    }

    fn cut(&mut self, at: BracketEnd) {
        if at.y == 0.0 {
            (self.low, self.high) = (at, at);
        } else if at.y.is_sign_negative() == self.low.y.is_sign_negative() {
            self.low = at;
        } else {
            self.high = at;
        }
    }

    /// The end where the function is smaller.
    fn best(&self) -> f64 {
        if self.low.y.abs() <= self.high.y.abs() {
            self.low.x
        } else {
            self.high.x
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{exp, powi};

    /// The zero and the number of evaluations.
    fn counted(f: impl Fn(f64) -> f64, lower: f64, upper: f64) -> (f64, usize) {
        let mut count = 0;
        let root = bracketed_root(
            |x| {
                count += 1;
                f(x)
            },
            lower,
            upper,
            0.0,
        );
        (root.unwrap(), count)
    }

    #[test]
    fn smooth_functions_take_few_evaluations() {
        let (root, count) = counted(|x| x * x - 2.0, 0.0, 2.0);
        assert!((root - std::f64::consts::SQRT_2).abs() < 4e-16);
        assert!(count < 20, "{count}");
    }

    #[test]
    fn hostile_functions_end_like_bisection() {
        for (f, root) in [
            ((|x| powi(x - 0.7, 9)) as fn(f64) -> f64, 0.7),
            (|x| if x < 0.3 { -1e-300 } else { 1e300 }, 0.3),
            (|x| exp(700.0 * x) - 1.0 + 1e-9, 0.0),
        ] {
            let (found, count) = counted(f, -1.0, 1.0);
            assert!((found - root).abs() < 1e-4, "{found} {root}");
            assert!(count < 1200, "{count}");
        }
    }

    #[test]
    fn wrong_intervals_are_refused() {
        assert!(matches!(
            bracketed_root(|x| x * x + 1.0, -1.0, 1.0, 0.0),
            Err(RootError::NotBracketed { .. })
        ));
        assert!(matches!(
            bracketed_root(|_| f64::NAN, -1.0, 1.0, 0.0),
            Err(RootError::Undefined { .. })
        ));
        assert_eq!(bracketed_root(|x| x, 0.0, 1.0, 0.0), Ok(0.0));
        assert!(matches!(
            bracketed_root(|x| x, f64::NEG_INFINITY, 1.0, 0.0),
            Err(RootError::Undefined { .. })
        ));
    }
}
