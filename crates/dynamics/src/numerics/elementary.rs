//! Elementary functions with the same bits on every machine.
//!
//! The functions of the standard library come from the platform and differ in their last digit; these are those of the
//! crate [`libm`], written in Rust alone, with errors below one unit in the last place (two for the hyperbolic ones).

macro_rules! portable {
    ($($(#[$doc:meta])* $name:ident = $source:ident;)*) => {
        $(
            $(#[$doc])*
            #[inline]
            pub fn $name(x: f64) -> f64 {
                libm::$source(x)
            }
        )*
    };
}

portable! {
    /// Sine of an angle in radians.
    sin = sin;
    /// Cosine of an angle in radians.
    cos = cos;
    /// Tangent of an angle in radians.
    tan = tan;
    /// Angle in [-π/2, π/2] whose sine is `x`; NaN outside [-1, 1].
    asin = asin;
    /// Angle in [0, π] whose cosine is `x`; NaN outside [-1, 1].
    acos = acos;
    /// Angle in (-π/2, π/2) whose tangent is `x`.
    atan = atan;
    /// Hyperbolic sine.
    sinh = sinh;
    /// Hyperbolic cosine.
    cosh = cosh;
    /// Hyperbolic tangent.
    tanh = tanh;
    /// Inverse hyperbolic sine.
    asinh = asinh;
    /// Inverse hyperbolic cosine; NaN below 1.
    acosh = acosh;
    /// Inverse hyperbolic tangent; NaN outside [-1, 1].
    atanh = atanh;
    /// Exponential e^x.
    exp = exp;
    /// Power of two, 2^x.
    exp2 = exp2;
    /// e^x - 1 without cancellation at small `x`.
    expm1 = expm1;
    /// Natural logarithm; NaN below 0.
    ln = log;
    /// ln(1 + x) without cancellation at small `x`.
    ln_1p = log1p;
    /// Logarithm to the base 10.
    log10 = log10;
    /// Logarithm to the base 2.
    log2 = log2;
    /// Cube root, also of negative numbers.
    cbrt = cbrt;
}

/// Sine and cosine of an angle in radians, in this order.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Angle of the point (x, y) in [-π, π], correct in all quadrants.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Length of the vector (x, y), without overflow of the squares.
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    libm::hypot(x, y)
}

/// Power x^y.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// Power x^n with an integer exponent, to the last digit for any `n`.
///
/// # Examples
///
/// ```
/// assert_eq!(vibank_dynamics::numerics::powi(10.0, -3), 1e-3);
/// ```
#[inline]
pub fn powi(x: f64, n: i32) -> f64 {
    libm::pow(x, f64::from(n))
}

/// x times 2^n, rounded once.
///
/// # Examples
///
/// ```
/// assert_eq!(vibank_dynamics::numerics::scale_by_power_of_two(3.0, 4), 48.0);
/// ```
#[inline]
pub fn scale_by_power_of_two(x: f64, n: i32) -> f64 {
    // The exponents of normal numbers: then 2^n is one of binary64, and the product rounds once.
    const BIAS: i32 = 1023;
    if (1 - BIAS..=BIAS).contains(&n) {
        x * f64::from_bits(((n + BIAS) as u64) << 52)
    } else {
        libm::scalbn(x, n)
    }
}

/// Exponent of the leading bit: the integer `e` with 2^e <= |x| < 2^(e+1).
///
/// Zero gives `i32::MIN`, infinities and NaN give `i32::MAX`.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::binary_exponent;
///
/// assert_eq!(binary_exponent(1.0), 0);
/// assert_eq!(binary_exponent(-0.75), -1);
/// assert_eq!(binary_exponent(5e-324), -1074);
/// ```
#[inline]
pub fn binary_exponent(x: f64) -> i32 {
    let magnitude = x.to_bits() & !(1 << 63);
    match (magnitude >> 52) as i32 {
        0 if magnitude == 0 => i32::MIN,
        0 => -1011 - magnitude.leading_zeros() as i32,
        0x7ff => i32::MAX,
        biased => biased - 1023,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn binary_exponent_covers_all_magnitudes() {
        assert_eq!(binary_exponent(f64::MIN_POSITIVE), -1022);
        assert_eq!(binary_exponent(f64::MIN_POSITIVE / 2.0), -1023);
        assert_eq!(binary_exponent(f64::MAX), 1023);
        assert_eq!(binary_exponent(0.0), i32::MIN);
        assert_eq!(binary_exponent(f64::NAN), i32::MAX);
    }

    #[test]
    fn integer_powers_are_exact_where_they_can_be() {
        assert_eq!(powi(3.0, 20), 3_486_784_401.0);
        assert_eq!(powi(2.0, -1074), 5e-324);
        assert_eq!(powi(0.0, 0), 1.0);
    }
}
