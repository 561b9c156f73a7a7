//! Comparison with a tolerance, by the traits of `approx`.
//!
//! Complex numbers are compared by the modulus of their difference, as vectors are: a small imaginary part has no
//! relative accuracy of its own. The two numbers of a state have different units and are compared one by one.

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::numerics::{Complex, Dd};
use crate::vibration::State;

/// ```
/// use approx::assert_relative_eq;
/// use vibank_dynamics::numerics::Complex;
///
/// let root = Complex::new(-4.0, 0.0).sqrt();
/// assert_relative_eq!(root * root, Complex::new(-4.0, 0.0));
/// ```
impl AbsDiffEq for Complex {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        f64::EPSILON
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self == other || (*self - *other).abs() <= epsilon
    }
}

impl RelativeEq for Complex {
    fn default_max_relative() -> f64 {
        f64::EPSILON
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        let size = self.abs().max(other.abs());
        self.abs_diff_eq(other, epsilon.max(max_relative * size))
    }
}

impl UlpsEq for Complex {
    fn default_max_ulps() -> u32 {
        f64::default_max_ulps()
    }

    fn ulps_eq(&self, other: &Self, epsilon: f64, max_ulps: u32) -> bool {
        self.re.ulps_eq(&other.re, epsilon, max_ulps)
            && self.im.ulps_eq(&other.im, epsilon, max_ulps)
    }
}

/// Units in the last place of the lower number mean nothing: double-double numbers have no `UlpsEq`.
///
/// ```
/// use approx::assert_relative_eq;
/// use vibank_dynamics::numerics::Dd;
///
/// assert_relative_eq!(Dd::quotient(1.0, 3.0) * 3.0, Dd::ONE);
/// ```
impl AbsDiffEq for Dd {
    type Epsilon = f64;

    /// 2⁻¹⁰⁴, twice the bound on the relative error of one operation.
    fn default_epsilon() -> f64 {
        f64::EPSILON * f64::EPSILON
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self == other || (*self - *other).abs().hi() <= epsilon
    }
}

impl RelativeEq for Dd {
    fn default_max_relative() -> f64 {
        Self::default_epsilon()
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        let size = self.abs().hi().max(other.abs().hi());
        self.abs_diff_eq(other, epsilon.max(max_relative * size))
    }
}

/// ```
/// use approx::assert_ulps_eq;
/// use vibank_dynamics::State;
///
/// let state = State { position: 0.1 + 0.2, velocity: -1.0 };
/// assert_ulps_eq!(state, State { position: 0.3, velocity: -1.0 });
/// ```
impl AbsDiffEq for State {
    type Epsilon = f64;

    fn default_epsilon() -> f64 {
        f64::EPSILON
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        self.position.abs_diff_eq(&other.position, epsilon)
            && self.velocity.abs_diff_eq(&other.velocity, epsilon)
    }
}

impl RelativeEq for State {
    fn default_max_relative() -> f64 {
        f64::EPSILON
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        let pairs = [
            (self.position, other.position),
            (self.velocity, other.velocity),
        ];
        pairs
            .iter()
            .all(|(own, other)| own.relative_eq(other, epsilon, max_relative))
    }
}

impl UlpsEq for State {
    fn default_max_ulps() -> u32 {
        f64::default_max_ulps()
    }

    fn ulps_eq(&self, other: &Self, epsilon: f64, max_ulps: u32) -> bool {
        self.position.ulps_eq(&other.position, epsilon, max_ulps)
            && self.velocity.ulps_eq(&other.velocity, epsilon, max_ulps)
    }
}
