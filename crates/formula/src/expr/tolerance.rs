//! Comparison with a tolerance, by the traits of `approx`.
//!
//! A [`Decimal`](crate::unit::Decimal) is exact and has none; a quantity is compared by its value in SI units.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::expr::Value;
use crate::unit::Quantity;

/// The values of two quantities as they are held by one that is declared in the unit of the second: 1 Hz is 2π rad/s.
/// None where the dimensions differ.
fn in_si(one: &Quantity, other: &Quantity) -> Option<(f64, f64)> {
    let conversion = one.conversion(&other.unit).ok()?;
    Some((conversion.apply_decimal(&one.value), other.si()))
}

/// ```
/// use approx::{assert_abs_diff_eq, assert_relative_eq, assert_relative_ne};
/// use vibank_formula::Quantity;
///
/// let quantity = |text| Quantity::parse(text).unwrap();
/// assert_relative_eq!(quantity("120 rpm"), quantity("2 Hz"));
/// assert_relative_eq!(quantity("1 Hz"), quantity("6.283 rad/s"), max_relative = 1e-4);
/// assert_abs_diff_eq!(quantity("12.5 cm"), quantity("0.126 m"), epsilon = 2e-3);
/// assert_relative_ne!(quantity("1 m"), quantity("1 s"));
/// ```
impl AbsDiffEq for Quantity {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        f64::EPSILON
    }

    /// `epsilon` is in the SI unit of the second quantity. Quantities of different dimensions are never equal.
    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        in_si(self, other).is_some_and(|(own, other)| own.abs_diff_eq(&other, epsilon))
    }
}

impl RelativeEq for Quantity {
    fn default_max_relative() -> f64 {
        f64::EPSILON
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        in_si(self, other)
            .is_some_and(|(own, other)| own.relative_eq(&other, epsilon, max_relative))
    }
}

impl UlpsEq for Quantity {
    fn default_max_ulps() -> u32 {
        f64::default_max_ulps()
    }

    fn ulps_eq(&self, other: &Self, epsilon: f64, max_ulps: u32) -> bool {
        in_si(self, other).is_some_and(|(own, other)| own.ulps_eq(&other, epsilon, max_ulps))
    }
}

/// Entry by entry; values of different forms are never equal, and the bounds on their errors are not looked at.
///
/// ```
/// use approx::assert_ulps_eq;
/// use vibank_formula::expr::Value;
///
/// assert_ulps_eq!(Value::real(0.1 + 0.2, 1e-16), Value::real(0.3, 0.0));
/// ```
impl AbsDiffEq for Value {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        f64::EPSILON
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self.form() == other.form() && self.numbers().abs_diff_eq(other.numbers(), epsilon)
    }
}

impl RelativeEq for Value {
    fn default_max_relative() -> f64 {
        f64::EPSILON
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        self.form() == other.form()
            && self
                .numbers()
                .relative_eq(other.numbers(), epsilon, max_relative)
    }
}

impl UlpsEq for Value {
    fn default_max_ulps() -> u32 {
        f64::default_max_ulps()
    }

    fn ulps_eq(&self, other: &Self, epsilon: f64, max_ulps: u32) -> bool {
        self.form() == other.form() && self.numbers().ulps_eq(other.numbers(), epsilon, max_ulps)
    }
}
