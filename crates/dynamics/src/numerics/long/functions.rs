//! Elementary functions of long numbers: arguments are made small, then series are summed.

use super::{BITS, Long};

const LN_2: Long = Long {
    is_negative: false,
    words: [
        0x8a0d_175b_8baa_fa2b,
        0x40f3_4326_7298_b62d,
        0xc9e3_b398_03f2_f6af,
        0xb172_17f7_d1cf_79ab,
    ],
    exponent: -256,
};

/// π/2 as a sum of three parts of 192 bits, whose products with numbers of 53 bits are exact.
const HALF_PI: [Long; 3] = [
    Long {
        is_negative: false,
        words: [
            0,
            0x2902_4e08_8a67_cc74,
            0xc4c6_628b_80dc_1cd1,
            0xc90f_daa2_2168_c234,
        ],
        exponent: -255,
    },
    Long {
        is_negative: false,
        words: [
            0,
            0xe546_6cf3_4e90_c6cc,
            0x5282_1e63_8d01_377b,
            0x82ef_a98e_c4e6_c894,
        ],
        exponent: -453,
    },
    Long {
        is_negative: false,
        words: [
            0,
            0x16d5_d989_79fb_1bd1,
            0x84d5_b5b5_4709_1792,
            0xac29_b7c9_7c50_dd3f,
        ],
        exponent: -649,
    },
];

/// Halvings of the argument of an exponential before its series.
// An argument of at most ln 2/2 takes over forty terms to 256 bits, its 256th part some twenty.
const HALVINGS: i32 = 8;

/// Beyond this an exponential leaves the range of binary64 by far, and is taken there.
const MAX_EXPONENT: f64 = 1e5;

fn one() -> Long {
    Long::from(1.0)
}

/// Sums `first · (1 + f₁ (1 + f₂ (…)))`, `factor(term, n)` giving the term after, until terms no longer count.
fn series(first: Long, factor: impl Fn(Long, u64) -> Long) -> Long {
    let (mut sum, mut term) = (first, first);
    for n in 1.. {
        term = factor(term, n);
        if term.is_zero() || term.magnitude() < sum.magnitude() - BITS {
            break;
        }
        sum = sum + term;
    }
    sum
}

impl Long {
    /// Exponential.
    #[must_use]
    pub fn exp(self) -> Self {
        let rounded = self.to_f64().clamp(-MAX_EXPONENT, MAX_EXPONENT);
        let turns = (rounded / std::f64::consts::LN_2).round();
        if self.abs() > Self::from(MAX_EXPONENT) {
            return one().shifted(turns as i32);
        }
        let rest = self - LN_2 * Self::from(turns);
        let mut power = rest.shifted(-HALVINGS).short_expm1();
        // (1 + p)² - 1 keeps the digits of small powers.
        for _ in 0..HALVINGS {
            power = power.shifted(1) + power * power;
        }
        (one() + power).shifted(turns as i32)
    }

    /// e^x − 1 by its series.
    fn short_expm1(self) -> Self {
        series(self, |term, n| (term * self).over(n + 1))
    }

    /// The natural logarithm of a positive number.
    #[must_use]
    pub fn ln(self) -> Self {
        let mut exponent = self.magnitude();
        let mut mantissa = self.shifted(-exponent);
        if mantissa.to_f64() > std::f64::consts::SQRT_2 {
            mantissa = mantissa.shifted(-1);
            exponent += 1;
        }
        let fraction = ((mantissa - one()) / (mantissa + one()))
            .short_atanh()
            .shifted(1);
        LN_2 * Self::from(f64::from(exponent)) + fraction
    }

    /// Decimal logarithm of a positive number.
    #[must_use]
    pub fn log10(self) -> Self {
        self.ln() / Self::from(10.0).ln()
    }

    /// Its series, for numbers up to 1/2.
    fn short_atanh(self) -> Self {
        self.odd_series(self * self)
    }

    /// `x + x q/3 + x q²/5 + …`.
    fn odd_series(self, q: Self) -> Self {
        let mut sum = self;
        let mut power = self;
        for n in 1.. {
            power = power * q;
            let term = power.over(2 * n + 1);
            if term.is_zero() || term.magnitude() < sum.magnitude() - BITS {
                break;
            }
            sum = sum + term;
        }
        sum
    }

    /// What is left of an angle without the nearest multiple of a right angle, and that multiple modulo four.
    fn reduced(self) -> (Self, i32) {
        let turns = (self.to_f64() / std::f64::consts::FRAC_PI_2).round();
        let rest = HALF_PI
            .into_iter()
            .fold(self, |rest, part| rest - part * Self::from(turns));
        (rest, turns.rem_euclid(4.0) as i32)
    }

    /// Sine.
    #[must_use]
    pub fn sin(self) -> Self {
        let (rest, quarter) = self.reduced();
        let value = if quarter % 2 == 0 {
            rest.short_sin()
        } else {
            rest.short_cos()
        };
        if quarter < 2 { value } else { -value }
    }

    /// Cosine.
    #[must_use]
    pub fn cos(self) -> Self {
        let (rest, quarter) = self.reduced();
        let value = if quarter % 2 == 0 {
            rest.short_cos()
        } else {
            rest.short_sin()
        };
        if quarter == 0 || quarter == 3 {
            value
        } else {
            -value
        }
    }

    /// Tangent.
    #[must_use]
    pub fn tan(self) -> Self {
        self.sin() / self.cos()
    }

    fn short_sin(self) -> Self {
        let square = -(self * self);
        series(self, |term, n| (term * square).over(2 * n * (2 * n + 1)))
    }

    fn short_cos(self) -> Self {
        let square = -(self * self);
        series(one(), |term, n| (term * square).over(2 * n * (2 * n - 1)))
    }

    /// Inverse tangent.
    #[must_use]
    pub fn atan(self) -> Self {
        if self.abs() > one() {
            let right_angle = Self::PI.shifted(-1);
            let right_angle = if self.is_negative {
                -right_angle
            } else {
                right_angle
            };
            return right_angle - (one() / self).atan();
        }
        // At 1 the series hardly converges; at the tangent of an eighth of the angle each term adds 6.7 bits.
        const HALVINGS: i32 = 3;
        let halved = (0..HALVINGS).fold(self, |x, _| x / (one() + (one() + x * x).sqrt()));
        halved.odd_series(-(halved * halved)).shifted(HALVINGS)
    }

    /// Angle of the point (x, y), called on y.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let right_angle = Self::PI.shifted(-1);
        if self.abs() > x.abs() {
            let angle = right_angle - (x / self.abs()).atan();
            return if self.is_negative { -angle } else { angle };
        }
        if x.is_zero() {
            return Self::ZERO;
        }
        let angle = (self / x).atan();
        match (x.is_negative, self.is_negative) {
            (false, _) => angle,
            (true, false) => angle + Self::PI,
            (true, true) => angle - Self::PI,
        }
    }

    /// `√(1 − x²)`.
    fn leg(self) -> Self {
        ((one() - self) * (one() + self)).sqrt()
    }

    /// Inverse sine, of numbers up to one in size.
    #[must_use]
    pub fn asin(self) -> Self {
        self.atan2(self.leg())
    }

    /// Inverse cosine, of numbers up to one in size.
    #[must_use]
    pub fn acos(self) -> Self {
        self.leg().atan2(self)
    }

    /// Hyperbolic sine.
    #[must_use]
    pub fn sinh(self) -> Self {
        if self.abs() < one() {
            let square = self * self;
            return series(self, |term, n| (term * square).over(2 * n * (2 * n + 1)));
        }
        let power = self.exp();
        (power - one() / power).shifted(-1)
    }

    /// Hyperbolic cosine.
    #[must_use]
    pub fn cosh(self) -> Self {
        let power = self.exp();
        (power + one() / power).shifted(-1)
    }

    /// Hyperbolic tangent.
    #[must_use]
    pub fn tanh(self) -> Self {
        // Beyond, it is ±1 to the last bit.
        const FLAT: f64 = 100.0;
        let rounded = self.to_f64();
        if rounded.abs() > FLAT {
            return Self::from(rounded.signum());
        }
        self.sinh() / self.cosh()
    }

    /// Inverse hyperbolic sine.
    #[must_use]
    pub fn asinh(self) -> Self {
        let root = (one() + self * self).sqrt();
        if self.abs() < Self::from(0.5) {
            return (self / root).short_atanh();
        }
        let size = (self.abs() + root).ln();
        if self.is_negative { -size } else { size }
    }

    /// Inverse hyperbolic cosine, of numbers from one up.
    #[must_use]
    pub fn acosh(self) -> Self {
        let root = ((self - one()) * (self + one())).sqrt();
        // Near 1 the sum is near 1, and its logarithm would lose digits.
        if self < Self::from(1.5) {
            return (root / self).atanh();
        }
        (self + root).ln()
    }

    /// Inverse hyperbolic tangent, of numbers below one in size.
    #[must_use]
    pub fn atanh(self) -> Self {
        if self.abs() < Self::from(0.5) {
            return self.short_atanh();
        }
        ((one() + self) / (one() - self)).ln().shifted(-1)
    }

    /// Length of a vector.
    #[must_use]
    pub fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }

    /// The power of a positive number.
    #[must_use]
    pub fn pow(self, exponent: Self) -> Self {
        (self.ln() * exponent).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A decimal, to the last bits.
    fn decimal(text: &str) -> Long {
        let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
        let digits = mantissa.trim_start_matches('-').replace('.', "");
        let decimals = mantissa.split_once('.').map_or(0, |(_, part)| part.len());
        let whole = digits.bytes().fold(Long::ZERO, |sum, digit| {
            sum * Long::from(10.0) + Long::from(f64::from(digit - b'0'))
        });
        let power = power.parse::<i32>().unwrap() - decimals as i32;
        let value = whole * Long::from(10.0).powi(power);
        if mantissa.starts_with('-') {
            -value
        } else {
            value
        }
    }

    fn assert_near(name: &str, found: Long, expected: &str) {
        let expected = decimal(expected);
        let error = ((found - expected) / expected).abs();
        assert!(error.to_f64() < 1e-70, "{name}: {:e}", error.to_f64());
    }

    /// Functions, arguments and values to 74 digits by mpmath: `nstr(f(mpf(x)), 74)`.
    const VALUES: &str = include_str!("values.txt");

    fn function(name: &str) -> fn(Long) -> Long {
        match name {
            "exp" => Long::exp,
            "ln" => Long::ln,
            "log10" => Long::log10,
            "sin" => Long::sin,
            "cos" => Long::cos,
            "tan" => Long::tan,
            "atan" => Long::atan,
            "asin" => Long::asin,
            "acos" => Long::acos,
            "sinh" => Long::sinh,
            "cosh" => Long::cosh,
            "tanh" => Long::tanh,
            "asinh" => Long::asinh,
            "acosh" => Long::acosh,
            "atanh" => Long::atanh,
            "sqrt" => Long::sqrt,
            other => panic!("there is no {other}"),
        }
    }

    #[test]
    fn functions_agree_to_seventy_digits() {
        for line in VALUES.lines() {
            let [name, x, expected] = line.split(' ').collect::<Vec<_>>()[..] else {
                panic!("{line}");
            };
            let x = x.parse::<f64>().unwrap();
            assert_near(line, function(name)(Long::from(x)), expected);
        }
    }

    #[test]
    fn roundings_and_conversions() {
        for x in [0.0, 1.0, -2.5, 1e-300, 5e-324, 1.797e308, 0.1] {
            assert_eq!(Long::from(x).to_f64(), x);
        }
        for (x, floor) in [
            (2.5, 2.0),
            (-2.5, -3.0),
            (0.3, 0.0),
            (-0.3, -1.0),
            (4.0, 4.0),
            (-4.0, -4.0),
        ] {
            assert_eq!(Long::from(x).floor().to_f64(), floor, "{x}");
        }
        let third = Long::from(1.0) / Long::from(3.0);
        assert!((third * Long::from(3.0) - Long::from(1.0)).abs().to_f64() < 1e-75);
        let tiny = (Long::from(1.0) + Long::from(1e-60)) - Long::from(1.0);
        assert!((tiny.to_f64() / 1e-60 - 1.0).abs() < 1e-15);
    }
}
