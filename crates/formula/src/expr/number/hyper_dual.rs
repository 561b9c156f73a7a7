//! Numbers that carry two first derivatives and the mixed second one.

use std::cmp::Ordering;

use super::{Doubt, Precise, Scalar, Undefined};
use crate::expr::Function;
use vibank_dynamics::numerics;

/// `a + b ε₁ + c ε₂ + d ε₁ε₂` with ε₁² = ε₂² = 0: a program run over these gives exact second derivatives.
///
/// Seed one input with ε₁ and one with ε₂; then `both` of the result is the second derivative by the two, free of
/// truncation error. Pieces (`abs`, `sign`, `floor`, `min`, …) are differentiated by pieces.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Expr, HyperDual, Inputs, Program, Registers, Slots, Undefined};
///
/// struct At(f64);
/// impl Inputs<HyperDual> for At {
///     fn input(&self, _slot: u32) -> Result<HyperDual, Undefined> {
///         Ok(HyperDual { value: self.0, first: 1.0, second: 1.0, both: 0.0 })
///     }
/// }
/// let program = Program::compile(&Expr::read("x^3")?, &Slots(&["x"]))?;
/// let mut room = Registers::default();
/// let outcome = program.run(&At(2.0), &mut room)?;
/// let result = outcome.numbers().next().unwrap();
/// assert_eq!((result.value, result.first, result.both), (8.0, 12.0, 12.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # References
///
/// J. A. Fike, J. J. Alonso, The development of hyper-dual numbers for exact second-derivative calculations, AIAA
/// 2011-886.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HyperDual {
    /// The number.
    pub value: f64,
    /// Derivative by what is seeded with ε₁.
    pub first: f64,
    /// Derivative by what is seeded with ε₂.
    pub second: f64,
    /// Second derivative by both.
    pub both: f64,
}

/// A function of two numbers with its derivatives at a place.
struct Bivariate {
    value: f64,
    /// By the first and by the second argument.
    slopes: [f64; 2],
    /// By the first twice, by both, by the second twice.
    curvatures: [f64; 3],
}

impl HyperDual {
    /// A number that does not vary.
    pub fn constant(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    fn is_constant(&self) -> bool {
        self.first == 0.0 && self.second == 0.0 && self.both == 0.0
    }

    /// A function of the number, from its value and first two derivatives.
    fn chained(&self, value: f64, slope: f64, curvature: f64) -> Self {
        // What does not vary stays so, even where the function is infinitely steep.
        let scaled = |part: f64| if part == 0.0 { 0.0 } else { slope * part };
        let product = self.first * self.second;
        let curved = if product == 0.0 {
            0.0
        } else {
            curvature * product
        };
        Self {
            value,
            first: scaled(self.first),
            second: scaled(self.second),
            both: scaled(self.both) + curved,
        }
    }

    fn combined(&self, other: &Self, f: &Bivariate) -> Self {
        let [fu, fv] = f.slopes;
        let [fuu, fuv, fvv] = f.curvatures;
        Self {
            value: f.value,
            first: fu * self.first + fv * other.first,
            second: fu * self.second + fv * other.second,
            both: fu * self.both
                + fv * other.both
                + fuu * self.first * self.second
                + fuv * (self.first * other.second + other.first * self.second)
                + fvv * other.first * other.second,
        }
    }

    /// u^p with a constant exponent.
    fn power_constant(&self, exponent: f64) -> Self {
        let x = self.value;
        self.chained(
            numerics::pow(x, exponent),
            exponent * numerics::pow(x, exponent - 1.0),
            exponent * (exponent - 1.0) * numerics::pow(x, exponent - 2.0),
        )
    }
}

impl Scalar for HyperDual {
    // Of the value, as in binary64: searches stop by it, and the work of a step is weighed by it.
    const ROUNDOFF: f64 = f64::EPSILON / 2.0;

    fn of(precise: &Precise) -> Self {
        Self::constant(precise.high())
    }

    fn add(&self, other: &Self) -> Self {
        Self {
            value: self.value + other.value,
            first: self.first + other.first,
            second: self.second + other.second,
            both: self.both + other.both,
        }
    }

    fn subtract(&self, other: &Self) -> Self {
        self.add(&other.negate())
    }

    fn multiply(&self, other: &Self) -> Self {
        Self {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value + self.value * other.second,
            both: self.both * other.value
                + self.first * other.second
                + self.second * other.first
                + self.value * other.both,
        }
    }

    fn divide(&self, other: &Self) -> Result<Self, Undefined> {
        if other.value == 0.0 {
            return Err(Undefined::DivisionByZero);
        }
        if other.is_constant() {
            return Ok(Self {
                value: self.value / other.value,
                first: self.first / other.value,
                second: self.second / other.value,
                both: self.both / other.value,
            });
        }
        let inverse = 1.0 / other.value;
        let square = inverse * inverse;
        let reciprocal = other.chained(inverse, -square, 2.0 * square * inverse);
        Ok(Self {
            value: self.value / other.value,
            ..self.multiply(&reciprocal)
        })
    }

    fn negate(&self) -> Self {
        Self {
            value: -self.value,
            first: -self.first,
            second: -self.second,
            both: -self.both,
        }
    }

    fn power_whole(&self, exponent: i32) -> Result<Self, Undefined> {
        if exponent < 0 && self.value == 0.0 {
            return Err(Undefined::DivisionByZero);
        }
        let power = |lower: i32| numerics::powi(self.value, exponent - lower);
        let n = f64::from(exponent);
        // The factors vanish with the exponent, before a negative power of zero is taken.
        let slope = if exponent == 0 { 0.0 } else { n * power(1) };
        let curvature = match exponent {
            0 | 1 => 0.0,
            _ => n * (n - 1.0) * power(2),
        };
        Ok(self.chained(power(0), slope, curvature))
    }

    fn power(&self, exponent: &Self, _doubt: &mut Doubt) -> Result<Self, Undefined> {
        let whole = exponent.value;
        // Also of numbers below zero, which have no other powers.
        if exponent.is_constant() && whole == whole.round() && whole.abs() < 1e9 {
            return self.power_whole(whole as i32);
        }
        if self.value < 0.0 {
            return Err(Undefined::PowerOfNegative);
        }
        if exponent.is_constant() {
            if self.value == 0.0 && exponent.value < 0.0 {
                return Err(Undefined::DivisionByZero);
            }
            return Ok(self.power_constant(exponent.value));
        }
        if self.value == 0.0 {
            return Err(Undefined::LogarithmOfZero);
        }
        let (x, p) = (self.value, exponent.value);
        let (power, log) = (numerics::pow(x, p), numerics::ln(x));
        Ok(self.combined(
            exponent,
            &Bivariate {
                value: power,
                slopes: [p * power / x, log * power],
                curvatures: [
                    p * (p - 1.0) * power / (x * x),
                    (1.0 + p * log) * power / x,
                    log * log * power,
                ],
            },
        ))
    }

    fn unary(&self, function: Function, _doubt: &mut Doubt) -> Result<Self, Undefined> {
        let x = self.value;
        check_domain(function, x)?;
        let [value, slope, curvature] = derivatives(function, x);
        Ok(self.chained(value, slope, curvature))
    }

    fn binary(
        &self,
        function: Function,
        other: &Self,
        doubt: &mut Doubt,
    ) -> Result<Self, Undefined> {
        let (u, v) = (self.value, other.value);
        match function {
            Function::Min => Ok(if u <= v { *self } else { *other }),
            Function::Max => Ok(if u >= v { *self } else { *other }),
            Function::Mod => {
                let whole = self.divide(other)?.unary(Function::Floor, doubt)?;
                Ok(self.subtract(&other.multiply(&whole)))
            }
            Function::Hypot => {
                let squares = self.multiply(self).add(&other.multiply(other));
                let root = squares.unary(Function::Sqrt, doubt)?;
                Ok(Self {
                    value: numerics::hypot(u, v),
                    ..root
                })
            }
            _ => {
                let square = u * u + v * v;
                if square == 0.0 {
                    return Err(Undefined::OutsideDomain(function));
                }
                let quartic = square * square;
                Ok(self.combined(
                    other,
                    &Bivariate {
                        value: numerics::atan2(u, v),
                        slopes: [v / square, -u / square],
                        curvatures: [
                            -2.0 * u * v / quartic,
                            (u * u - v * v) / quartic,
                            2.0 * u * v / quartic,
                        ],
                    },
                ))
            }
        }
    }

    fn compare(&self, other: &Self, _doubt: &mut Doubt) -> Ordering {
        self.value.total_cmp(&other.value)
    }

    fn to_f64(&self) -> f64 {
        self.value
    }

    fn bound(&self) -> f64 {
        0.0
    }

    fn widened(&self, _more: f64) -> Self {
        *self
    }

    fn centre(&self) -> Self {
        *self
    }
}

fn check_domain(function: Function, x: f64) -> Result<(), Undefined> {
    match function {
        Function::Sqrt if x < 0.0 => Err(Undefined::RootOfNegative),
        Function::Ln | Function::Log10 if x == 0.0 => Err(Undefined::LogarithmOfZero),
        Function::Ln | Function::Log10 if x < 0.0 => Err(Undefined::LogarithmOfNegative),
        Function::Asin | Function::Acos if x.abs() > 1.0 => Err(Undefined::OutsideDomain(function)),
        Function::Acosh if x < 1.0 => Err(Undefined::OutsideDomain(function)),
        Function::Atanh if x.abs() >= 1.0 => Err(Undefined::OutsideDomain(function)),
        // The derivative of K is no function of this language.
        Function::EllipticK | Function::EllipticKm1 => Err(Undefined::OutsideDomain(function)),
        _ => Ok(()),
    }
}

/// Value, first and second derivative.
fn derivatives(function: Function, x: f64) -> [f64; 3] {
    match function {
        Function::Sqrt => {
            let root = x.sqrt();
            [root, 0.5 / root, -0.25 / (x * root)]
        }
        Function::Exp => [numerics::exp(x); 3],
        Function::Ln => [numerics::ln(x), 1.0 / x, -1.0 / (x * x)],
        Function::Log10 => {
            let scale = 1.0 / numerics::ln(10.0);
            [numerics::log10(x), scale / x, -scale / (x * x)]
        }
        Function::Sin => {
            let (sine, cosine) = numerics::sin_cos(x);
            [sine, cosine, -sine]
        }
        Function::Cos => {
            let (sine, cosine) = numerics::sin_cos(x);
            [cosine, -sine, -cosine]
        }
        Function::Tan => {
            let tangent = numerics::tan(x);
            let slope = 1.0 + tangent * tangent;
            [tangent, slope, 2.0 * tangent * slope]
        }
        Function::Asin => {
            let slope = 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
            [numerics::asin(x), slope, x * slope * slope * slope]
        }
        Function::Acos => {
            let slope = 1.0 / ((1.0 - x) * (1.0 + x)).sqrt();
            [numerics::acos(x), -slope, -x * slope * slope * slope]
        }
        Function::Atan => {
            let slope = 1.0 / (1.0 + x * x);
            [numerics::atan(x), slope, -2.0 * x * slope * slope]
        }
        Function::Sinh => [numerics::sinh(x), numerics::cosh(x), numerics::sinh(x)],
        Function::Cosh => [numerics::cosh(x), numerics::sinh(x), numerics::cosh(x)],
        Function::Tanh => {
            let tangent = numerics::tanh(x);
            let slope = 1.0 - tangent * tangent;
            [tangent, slope, -2.0 * tangent * slope]
        }
        Function::Asinh => {
            let slope = 1.0 / (1.0 + x * x).sqrt();
            [numerics::asinh(x), slope, -x * slope * slope * slope]
        }
        Function::Acosh => {
            let slope = 1.0 / ((x - 1.0) * (x + 1.0)).sqrt();
            [numerics::acosh(x), slope, -x * slope * slope * slope]
        }
        Function::Atanh => {
            let slope = 1.0 / ((1.0 - x) * (1.0 + x));
            [numerics::atanh(x), slope, 2.0 * x * slope * slope]
        }
        Function::Abs => [x.abs(), sign(x), 0.0],
        Function::Sign => [sign(x), 0.0, 0.0],
        Function::Floor => [x.floor(), 0.0, 0.0],
        Function::Ceil => [x.ceil(), 0.0, 0.0],
        Function::Round => [x.round(), 0.0, 0.0],
        _ => [x, 1.0, 0.0],
    }
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}
