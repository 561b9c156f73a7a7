//! A number with a bound on its error.

use std::cmp::Ordering;

use super::{Doubt, Precise, Real, Scalar, Undefined};
use crate::expr::Function;
use vibank_dynamics::numerics;

/// A number and a running bound on its error: the exact number lies within `value ± bound`.
///
/// The bound follows the data (a decimal is off by half a unit in the last place) and every operation (running error
/// analysis). Two numbers within their bounds count as equal, and one within its bound of an integer as that number.
///
/// # Examples
///
/// ```
/// use std::cmp::Ordering;
/// use vibank_formula::expr::{Approx, Doubt, Precise, Scalar};
/// use vibank_dynamics::numerics::Rational;
///
/// let decimal = |text| Approx::<f64>::of(&Precise::from(Rational::from_decimal(text).unwrap()));
/// let sum = decimal("0.1").add(&decimal("0.2"));
/// assert!(sum.value != 0.3);
///
/// let mut doubt = Doubt::default();
/// assert_eq!(sum.compare(&decimal("0.3"), &mut doubt), Ordering::Equal);
/// assert!(doubt.is_open);
/// ```
///
/// # References
///
/// N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., SIAM 2002, section 3.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approx<T> {
    /// The number.
    pub value: T,
    /// Bound on its error, at least 0.
    pub bound: f64,
}

/// Bounds are sums of rounded numbers: where they decide they are taken a little larger.
const SLACK: f64 = 1.0 + 1e-9;
/// Products below this may have lost digits to underflow.
const UNDERFLOW: f64 = 1e-280;
/// Whole powers up to this are repeated products.
// As products they keep exact numbers exact.
const MAX_PRODUCT_LENGTH: u32 = 4;
/// The natural logarithm of 10, rounded down.
const LN_10: f64 = 2.302_585_092_994_045;

impl<T: Real> Approx<T> {
    /// A number with a bound on its error.
    #[inline]
    pub fn new(value: T, bound: f64) -> Self {
        Self { value, bound }
    }

    /// A number without error.
    #[inline]
    pub fn certain(value: T) -> Self {
        Self::new(value, 0.0)
    }

    /// Its size, rounded to binary64.
    #[inline]
    fn size(&self) -> f64 {
        self.value.to_f64().abs()
    }

    /// Its size at least, given its error.
    #[inline]
    fn least(&self) -> f64 {
        self.size() - self.bound
    }

    /// Bound on the error of its sine or cosine that its own error makes.
    fn bound_of_sine(&self) -> f64 {
        if self.size() <= T::MAX_ANGLE {
            self.bound.min(2.0)
        } else {
            2.0
        }
    }

    /// Whether it cannot be told from zero.
    #[inline]
    fn is_zero(&self) -> bool {
        self.size() <= self.bound * SLACK
    }

    /// Whether it is below zero, beyond its error.
    #[inline]
    fn is_negative(&self) -> bool {
        self.value.to_f64() < 0.0 && !self.is_zero()
    }

    /// The value of a function whose own error is a unit or two in the last place.
    #[inline]
    fn function(value: T, bound: f64) -> Self {
        Self::new(value, bound + T::FUNCTION * value.to_f64().abs())
    }

    /// The integer from which it cannot be told, if there is one.
    #[inline]
    fn whole_value(&self) -> Option<T> {
        let nearest = (self.value + T::of_pair(0.5, 0.0)).floor();
        let off = (self.value - nearest).to_f64().abs();
        (off <= self.bound * SLACK).then_some(nearest)
    }

    /// Largest integer that is not above.
    fn floor(&self, doubt: &mut Doubt) -> Self {
        Self::certain(match self.whole_value() {
            Some(whole) => {
                doubt.note(self.bound);
                whole
            }
            None => self.value.floor(),
        })
    }

    fn shifted(&self, by: f64) -> Self {
        Self::new(self.value + T::of_pair(by, 0.0), self.bound)
    }

    /// Nearest integer, halves away from zero.
    fn round(&self, doubt: &mut Doubt) -> Self {
        if self.value.to_f64() < 0.0 {
            return self.negate().round(doubt).negate();
        }
        self.shifted(0.5).floor(doubt)
    }

    fn sign(&self, doubt: &mut Doubt) -> Self {
        if self.is_zero() {
            doubt.note(self.bound);
            return Self::exact(0.0);
        }
        Self::exact(self.value.to_f64().signum())
    }

    /// x − n ⌊x/n⌋, exactly 0 where x/n cannot be told from an integer.
    fn modulo(&self, other: &Self, doubt: &mut Doubt) -> Result<Self, Undefined> {
        let quotient = self.divide(other)?;
        if quotient.whole_value().is_some() {
            doubt.note(quotient.bound);
            return Ok(Self::exact(0.0));
        }
        let whole = Self::certain(quotient.value.floor());
        Ok(self.subtract(&other.multiply(&whole)))
    }

    fn sqrt(&self, doubt: &mut Doubt) -> Result<Self, Undefined> {
        if self.is_negative() {
            return Err(Undefined::RootOfNegative);
        }
        if self.value.to_f64() <= 0.0 {
            doubt.note(self.bound);
            return Ok(Self::new(T::of_pair(0.0, 0.0), self.bound.sqrt()));
        }
        let root = self.value.sqrt();
        let size = root.to_f64();
        // The root of a square stays exact, so that `floor(sqrt(4))` is no doubt.
        if self.bound == 0.0 && root.exact_product(root) == (self.value, true) {
            return Ok(Self::certain(root));
        }
        // √(x + b) - √x is below b/√x, and also below √b, which is less near zero.
        let inherited = (self.bound / size).min(self.bound.sqrt());
        Ok(Self::new(root, inherited + T::ROUNDOFF * size))
    }

    fn ln(&self) -> Result<Self, Undefined> {
        if self.is_negative() {
            return Err(Undefined::LogarithmOfNegative);
        }
        if self.is_zero() {
            return Err(Undefined::LogarithmOfZero);
        }
        Ok(Self::function(self.value.ln(), self.bound / self.least()))
    }

    fn log10(&self) -> Result<Self, Undefined> {
        let inherited = self.ln()?.bound / LN_10;
        Ok(Self::function(self.value.log10(), inherited))
    }

    fn exp(&self) -> Self {
        let value = self.value.exp();
        let size = value.to_f64() + f64::MIN_POSITIVE;
        Self::function(value, size * growth(self.bound))
    }

    fn tan(&self) -> Result<Self, Undefined> {
        let value = self.value.tan();
        let size = value.to_f64().abs();
        // Within its error of a pole the tangent has no value.
        if self.bound * (1.0 + size) > 0.25 {
            return Err(Undefined::DivisionByZero);
        }
        Ok(Self::function(
            value,
            2.0 * (1.0 + size * size) * self.bound,
        ))
    }

    /// A number of [−1, 1], to which what lies outside by less than its error is moved.
    fn of_unit_interval(&self, function: Function, doubt: &mut Doubt) -> Result<T, Undefined> {
        if self.size() <= 1.0 && self.value.abs() <= T::of_pair(1.0, 0.0) {
            return Ok(self.value);
        }
        if self.least() > 1.0 {
            return Err(Undefined::OutsideDomain(function));
        }
        doubt.note(self.bound);
        Ok(T::of_pair(self.value.to_f64().signum(), 0.0))
    }

    /// Inverse sine and cosine: their slope is 1/√(1 − x²), their way from the end of the domain below 1.6 √(2h).
    fn arc(
        &self,
        function: Function,
        of: fn(T) -> T,
        doubt: &mut Doubt,
    ) -> Result<Self, Undefined> {
        let x = self.of_unit_interval(function, doubt)?;
        let worst = self.size() + self.bound;
        let inherited = if worst < 1.0 {
            self.bound / ((1.0 - worst) * (1.0 + worst)).sqrt()
        } else {
            f64::INFINITY
        };
        let whole_way = 1.6 * (2.0 * (1.0 - self.size()).abs() + 2.0 * self.bound).sqrt();
        let inherited = if self.bound == 0.0 {
            0.0
        } else {
            inherited.min(whole_way)
        };
        Ok(Self::function(of(x), inherited))
    }

    fn acosh(&self, doubt: &mut Doubt) -> Result<Self, Undefined> {
        let above = self.shifted(-1.0);
        if above.is_negative() {
            return Err(Undefined::OutsideDomain(Function::Acosh));
        }
        if above.value.to_f64() <= 0.0 {
            doubt.note(self.bound);
            return Ok(Self::new(
                T::of_pair(0.0, 0.0),
                (2.0 * self.bound).sqrt() * SLACK,
            ));
        }
        let (height, least) = (above.size() + self.bound, above.least());
        let slope = if least > 0.0 {
            self.bound / (least * (2.0 + least)).sqrt()
        } else {
            f64::INFINITY
        };
        Ok(Self::function(
            self.value.acosh(),
            slope.min((2.0 * height).sqrt() * SLACK),
        ))
    }

    fn atanh(&self) -> Result<Self, Undefined> {
        let worst = self.size() + self.bound;
        if worst >= 1.0 {
            return Err(Undefined::OutsideDomain(Function::Atanh));
        }
        let inherited = self.bound / ((1.0 - worst) * (1.0 + worst));
        Ok(Self::function(self.value.atanh(), inherited))
    }

    /// K(m), by the complement 1 − m.
    fn elliptic_k(&self) -> Result<Self, Undefined> {
        let complement = Self::exact(1.0).subtract(self);
        complement.elliptic_km1(Function::EllipticK)
    }

    /// K(1 − p) = π / (2 agm(1, √p)), whose slope is at most K/(2p).
    fn elliptic_km1(&self, function: Function) -> Result<Self, Undefined> {
        let least = self.value.to_f64() - self.bound;
        if least <= 0.0 {
            return Err(Undefined::OutsideDomain(function));
        }
        let one = T::of_pair(1.0, 0.0);
        let mean = arithmetic_geometric_mean(one, self.value.sqrt());
        let value = T::PI / (mean + mean);
        let slope = value.to_f64() / (2.0 * least);
        // Each step of the mean is rounded twice.
        let rounding = T::ROUNDOFF * 20.0 * value.to_f64();
        Ok(Self::new(value, slope * self.bound + rounding))
    }

    fn atan2(&self, x: &Self, doubt: &mut Doubt) -> Result<Self, Undefined> {
        let radius = self.value.hypot(x.value).to_f64();
        let bounds = self.bound + x.bound;
        let least = radius - bounds;
        if least <= 0.0 {
            return Err(Undefined::OutsideDomain(Function::Atan2));
        }
        if self.is_zero() && x.value.to_f64() < 0.0 {
            // On the cut the angle is +π.
            doubt.note(self.bound);
            return Ok(Self::function(T::PI, bounds / least));
        }
        Ok(Self::function(self.value.atan2(x.value), bounds / least))
    }

    /// The larger or smaller number, as sure as the less sure one.
    fn extreme(&self, other: &Self, wanted: Ordering) -> Self {
        let order = self.value.partial_cmp(&other.value);
        let value = if order == Some(wanted) {
            self.value
        } else {
            other.value
        };
        let overlap =
            (self.value - other.value).to_f64().abs() <= (self.bound + other.bound) * SLACK;
        let chosen = if order == Some(wanted) { self } else { other };
        Self::new(
            value,
            if overlap {
                self.bound.max(other.bound)
            } else {
                chosen.bound
            },
        )
    }

    /// xⁿ for x > 0 or a whole n; `exponent` is the size of the exponent and `log_error` its error times |ln x|.
    fn power_value(&self, value: T, exponent: f64, log_error: f64) -> Self {
        let relative = growth(exponent * self.bound / self.least() + log_error);
        let size = value.to_f64().abs() + f64::MIN_POSITIVE;
        Self::function(value, size * (relative + T::power_rounding(size)))
    }
}

impl<T: Real> Scalar for Approx<T> {
    // That of the numbers beneath; what bounds themselves lose to rounding is in `SLACK`.
    const ROUNDOFF: f64 = T::ROUNDOFF;
    const SEARCHES: bool = T::SEARCHES;

    fn of(precise: &Precise) -> Self {
        let value = T::of_pair(precise.high(), precise.low());
        Self::new(value, precise.rest() + T::dropped(precise.low()))
    }

    #[inline]
    fn add(&self, other: &Self) -> Self {
        let bound = self.bound + other.bound;
        if bound == 0.0 {
            let (sum, is_exact) = self.value.exact_sum(other.value);
            return rounded(sum, is_exact);
        }
        let sum = self.value + other.value;
        Self::new(sum, bound + T::ROUNDOFF * sum.to_f64().abs())
    }

    #[inline]
    fn subtract(&self, other: &Self) -> Self {
        self.add(&other.negate())
    }

    #[inline]
    fn multiply(&self, other: &Self) -> Self {
        if self.bound + other.bound == 0.0 {
            let (product, is_exact) = self.value.exact_product(other.value);
            let size = product.to_f64().abs();
            let is_zero = self.size() == 0.0 || other.size() == 0.0;
            return rounded(product, is_exact && (size > UNDERFLOW || is_zero));
        }
        let product = self.value * other.value;
        let inherited =
            self.size() * other.bound + other.size() * self.bound + self.bound * other.bound;
        Self::new(
            product,
            // What underflow takes is no part of the product.
            inherited + T::ROUNDOFF * product.to_f64().abs() + f64::MIN_POSITIVE,
        )
    }

    #[inline]
    fn divide(&self, other: &Self) -> Result<Self, Undefined> {
        if other.is_zero() {
            return Err(Undefined::DivisionByZero);
        }
        let quotient = self.value / other.value;
        let size = quotient.to_f64().abs();
        if self.bound + other.bound == 0.0 {
            let (back, is_exact) = quotient.exact_product(other.value);
            return Ok(rounded(
                quotient,
                is_exact && back == self.value && back.to_f64().abs() > UNDERFLOW
                    || self.size() == 0.0,
            ));
        }
        let inherited = (self.bound + size * other.bound) / other.least();
        Ok(Self::new(
            quotient,
            inherited + T::ROUNDOFF * size + f64::MIN_POSITIVE,
        ))
    }

    #[inline]
    fn negate(&self) -> Self {
        Self::new(-self.value, self.bound)
    }

    fn power_whole(&self, exponent: i32) -> Result<Self, Undefined> {
        let times = exponent.unsigned_abs();
        if times <= MAX_PRODUCT_LENGTH {
            let power = (1..times).fold(*self, |power, _| power.multiply(self));
            return match exponent {
                0 => Ok(Self::exact(1.0)),
                1.. => Ok(power),
                _ => Self::exact(1.0).divide(&power),
            };
        }
        if self.is_zero() {
            if exponent < 0 {
                return Err(Undefined::DivisionByZero);
            }
            let bound = numerics::powi(self.size() + self.bound, exponent);
            return Ok(Self::new(self.value.powi(exponent), bound));
        }
        let value = self.value.powi(exponent);
        if self.bound == 0.0 && (self.size() == 1.0) {
            return Ok(Self::certain(value));
        }
        Ok(self.power_value(value, f64::from(times), 0.0))
    }

    fn power(&self, exponent: &Self, doubt: &mut Doubt) -> Result<Self, Undefined> {
        if self.is_zero() {
            let sign = exponent.sign(doubt).value.to_f64();
            if sign < 0.0 {
                return Err(Undefined::DivisionByZero);
            }
            if sign == 0.0 {
                return Ok(Self::exact(1.0));
            }
            let reach = numerics::pow(self.size() + self.bound, exponent.least().max(0.0));
            let bound = if self.bound == 0.0 { 0.0 } else { reach };
            return Ok(Self::new(T::of_pair(0.0, 0.0), bound));
        }
        if let Some(whole) = exponent.whole_value()
            && whole.to_f64().abs() <= f64::from(i32::MAX)
            && (exponent.bound == 0.0 || self.is_negative())
        {
            doubt.note(exponent.bound);
            return self.power_whole(whole.to_f64() as i32);
        }
        if self.is_negative() {
            return Err(Undefined::PowerOfNegative);
        }
        let log = numerics::ln(self.size()).abs() + self.bound / self.least();
        let value = self.value.pow(exponent.value);
        Ok(self.power_value(
            value,
            exponent.size() + exponent.bound,
            log * exponent.bound,
        ))
    }

    fn unary(&self, function: Function, doubt: &mut Doubt) -> Result<Self, Undefined> {
        let (x, bound) = (self.value, self.bound);
        Ok(match function {
            Function::Sqrt => self.sqrt(doubt)?,
            Function::Exp => self.exp(),
            Function::Ln => self.ln()?,
            Function::Log10 => self.log10()?,
            Function::Sin => Self::function(x.sin(), self.bound_of_sine()),
            Function::Cos => Self::function(x.cos(), self.bound_of_sine()),
            Function::Tan => self.tan()?,
            Function::Asin => self.arc(function, T::asin, doubt)?,
            Function::Acos => self.arc(function, T::acos, doubt)?,
            Function::Atan => {
                let least = self.least().max(0.0);
                Self::function(x.atan(), bound / (1.0 + least * least))
            }
            Function::Sinh => hyperbolic(x.sinh(), bound),
            Function::Cosh => hyperbolic(x.cosh(), bound),
            Function::Tanh => Self::function(x.tanh(), bound).widened(T::FUNCTION),
            Function::Asinh => {
                let value = x.asinh();
                let rounding = T::FUNCTION * value.to_f64().abs();
                Self::function(value, bound / self.least().max(1.0) + rounding)
            }
            Function::Acosh => self.acosh(doubt)?,
            Function::Atanh => self.atanh()?,
            Function::Abs => Self::new(x.abs(), bound),
            Function::Sign => self.sign(doubt),
            Function::Floor => self.floor(doubt),
            Function::Ceil => self.negate().floor(doubt).negate(),
            Function::Round => self.round(doubt),
            Function::EllipticK => self.elliptic_k()?,
            Function::EllipticKm1 => self.elliptic_km1(function)?,
            _ => return Err(Undefined::OutsideDomain(function)),
        })
    }

    fn binary(
        &self,
        function: Function,
        other: &Self,
        doubt: &mut Doubt,
    ) -> Result<Self, Undefined> {
        Ok(match function {
            Function::Atan2 => self.atan2(other, doubt)?,
            Function::Hypot => {
                Self::function(self.value.hypot(other.value), self.bound + other.bound)
            }
            Function::Mod => self.modulo(other, doubt)?,
            Function::Min => self.extreme(other, Ordering::Less),
            Function::Max => self.extreme(other, Ordering::Greater),
            _ => return Err(Undefined::OutsideDomain(function)),
        })
    }

    #[inline]
    fn compare(&self, other: &Self, doubt: &mut Doubt) -> Ordering {
        let bound = self.bound + other.bound;
        if self.value == other.value {
            doubt.note(bound);
            return Ordering::Equal;
        }
        if (self.value - other.value).to_f64().abs() <= bound * SLACK {
            doubt.note(bound);
            return Ordering::Equal;
        }
        if self.value < other.value {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }

    #[inline]
    fn to_f64(&self) -> f64 {
        self.value.to_f64()
    }

    #[inline]
    fn bound(&self) -> f64 {
        self.bound
    }

    fn widened(&self, more: f64) -> Self {
        Self::new(self.value, self.bound + more)
    }

    fn centre(&self) -> Self {
        Self::certain(self.value)
    }
}

/// The result of one operation on exact numbers.
#[inline]
fn rounded<T: Real>(value: T, is_exact: bool) -> Approx<T> {
    let bound = if is_exact {
        0.0
    } else {
        T::ROUNDOFF * value.to_f64().abs() + f64::MIN_POSITIVE
    };
    Approx::new(value, bound)
}

/// e^x − 1 for x ≥ 0, from above.
#[inline]
fn growth(x: f64) -> f64 {
    if x < 0.1 {
        x * (1.0 + x)
    } else {
        numerics::expm1(x)
    }
}

/// A hyperbolic sine or cosine: its slope is below 1 plus its size, its own error two units in the last place.
fn hyperbolic<T: Real>(value: T, bound: f64) -> Approx<T> {
    let size = value.to_f64().abs();
    Approx::function(value, (1.0 + size) * growth(bound) + T::FUNCTION * size)
}

/// Converges quadratically; six steps serve for a ratio of 1e16, eleven for one of 1e160 with the digits of long numbers.
fn arithmetic_geometric_mean<T: Real>(mut a: T, mut b: T) -> T {
    let half = T::of_pair(0.5, 0.0);
    for _ in 0..12 {
        if (a - b).to_f64().abs() <= T::ROUNDOFF * a.to_f64().abs() {
            break;
        }
        (a, b) = ((a + b) * half, (a * b).sqrt());
    }
    a
}
