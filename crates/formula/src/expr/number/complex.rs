//! Complex functions of pairs of numbers.
//!
//! Principal values throughout; the bounds of the parts follow from those of the real operations.

use super::{Doubt, Scalar, Undefined};
use crate::expr::Function;

/// Real and imaginary part.
pub(crate) type ComplexPair<S> = (S, S);

type ComplexResult<S> = Result<ComplexPair<S>, Undefined>;

pub(crate) fn add<S: Scalar>(a: &ComplexPair<S>, b: &ComplexPair<S>) -> ComplexPair<S> {
    (a.0.add(&b.0), a.1.add(&b.1))
}

pub(crate) fn subtract<S: Scalar>(a: &ComplexPair<S>, b: &ComplexPair<S>) -> ComplexPair<S> {
    (a.0.subtract(&b.0), a.1.subtract(&b.1))
}

pub(crate) fn multiply<S: Scalar>(a: &ComplexPair<S>, b: &ComplexPair<S>) -> ComplexPair<S> {
    (
        a.0.multiply(&b.0).subtract(&a.1.multiply(&b.1)),
        a.0.multiply(&b.1).add(&a.1.multiply(&b.0)),
    )
}

/// The quotient, by the part of the divisor that is larger, so that no square leaves the range (Smith 1962).
pub(crate) fn divide<S: Scalar>(a: &ComplexPair<S>, b: &ComplexPair<S>) -> ComplexResult<S> {
    if b.0.to_f64().abs() >= b.1.to_f64().abs() {
        let ratio = b.1.divide(&b.0)?;
        let scale = b.0.add(&b.1.multiply(&ratio));
        let real = a.0.add(&a.1.multiply(&ratio)).divide(&scale)?;
        let imaginary = a.1.subtract(&a.0.multiply(&ratio)).divide(&scale)?;
        return Ok((real, imaginary));
    }
    let ratio = b.0.divide(&b.1)?;
    let scale = b.1.add(&b.0.multiply(&ratio));
    let real = a.0.multiply(&ratio).add(&a.1).divide(&scale)?;
    let imaginary = a.1.multiply(&ratio).subtract(&a.0).divide(&scale)?;
    Ok((real, imaginary))
}

fn negate<S: Scalar>(z: &ComplexPair<S>) -> ComplexPair<S> {
    (z.0.negate(), z.1.negate())
}

/// i z.
fn times_i<S: Scalar>(z: &ComplexPair<S>) -> ComplexPair<S> {
    (z.1.negate(), z.0.clone())
}

fn halved<S: Scalar>(z: &ComplexPair<S>) -> ComplexPair<S> {
    let half = S::exact(0.5);
    (z.0.multiply(&half), z.1.multiply(&half))
}

fn one<S: Scalar>() -> ComplexPair<S> {
    (S::exact(1.0), S::exact(0.0))
}

/// The power; with a whole exponent by repeated products, else e^(w ln z).
pub(crate) fn power<S: Scalar>(
    z: &ComplexPair<S>,
    w: &ComplexPair<S>,
    doubt: &mut Doubt,
) -> ComplexResult<S> {
    if is_zero(z) {
        let sign = w.0.unary(Function::Sign, doubt)?.to_f64();
        return match sign {
            1.0 => Ok((S::exact(0.0), S::exact(0.0))),
            0.0 if is_zero(w) => Ok(one()),
            _ => Err(Undefined::DivisionByZero),
        };
    }
    let exponent = w.0.to_f64();
    let is_whole = w.1.to_f64() == 0.0 && w.0.bound() + w.1.bound() == 0.0;
    if is_whole && exponent == exponent.floor() && exponent.abs() <= 1e6 {
        return power_whole(z, exponent as i32);
    }
    exp(&multiply(w, &ln(z, doubt)?), doubt)
}

/// The power with a whole exponent, by squaring.
pub(crate) fn power_whole<S: Scalar>(z: &ComplexPair<S>, exponent: i32) -> ComplexResult<S> {
    let (mut power, mut square, mut rest) = (one(), z.clone(), exponent.unsigned_abs());
    while rest > 0 {
        if rest % 2 == 1 {
            power = multiply(&power, &square);
        }
        rest /= 2;
        if rest > 0 {
            square = multiply(&square, &square);
        }
    }
    if exponent < 0 {
        divide(&one(), &power)
    } else {
        Ok(power)
    }
}

/// Whether both parts cannot be told from zero.
fn is_zero<S: Scalar>(z: &ComplexPair<S>) -> bool {
    z.0.to_f64().abs() <= z.0.bound() && z.1.to_f64().abs() <= z.1.bound()
}

/// A complex function of one complex number.
pub(crate) fn unary<S: Scalar>(
    function: Function,
    z: &ComplexPair<S>,
    doubt: &mut Doubt,
) -> ComplexResult<S> {
    match function {
        Function::Sqrt => sqrt(z, doubt),
        Function::Exp => exp(z, doubt),
        Function::Ln => ln(z, doubt),
        Function::Log10 => divide(
            &ln(z, doubt)?,
            &ln(&(S::exact(10.0), S::exact(0.0)), doubt)?,
        ),
        Function::Sin => sin(z, doubt),
        Function::Cos => cos(z, doubt),
        Function::Tan => divide(&sin(z, doubt)?, &cos(z, doubt)?),
        // sinh z = -i sin(iz), and kin.
        Function::Sinh => Ok(negate(&times_i(&sin(&times_i(z), doubt)?))),
        Function::Cosh => cos(&times_i(z), doubt),
        Function::Tanh => {
            let rotated = times_i(z);
            let tangent = divide(&sin(&rotated, doubt)?, &cos(&rotated, doubt)?)?;
            Ok(negate(&times_i(&tangent)))
        }
        Function::Asin => Ok(negate(&times_i(&asinh(&times_i(z), doubt)?))),
        Function::Acos => {
            let arc = negate(&times_i(&asinh(&times_i(z), doubt)?));
            let quarter = S::exact(0.0).unary(Function::Acos, doubt)?;
            Ok((quarter.subtract(&arc.0), arc.1.negate()))
        }
        Function::Atan => Ok(negate(&times_i(&atanh(&times_i(z), doubt)?))),
        Function::Asinh => asinh(z, doubt),
        Function::Acosh => {
            let below = sqrt(&subtract(z, &one()), doubt)?;
            let above = sqrt(&add(z, &one()), doubt)?;
            ln(&add(z, &multiply(&above, &below)), doubt)
        }
        Function::Atanh => atanh(z, doubt),
        _ => Err(Undefined::OutsideDomain(function)),
    }
}

/// √z with its cut along the negative reals, by the part that does not cancel.
fn sqrt<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    if is_zero(z) {
        let bound = (z.0.bound() + z.1.bound()).sqrt();
        return Ok((S::exact(0.0).widened(bound), S::exact(0.0).widened(bound)));
    }
    let modulus = z.0.binary(Function::Hypot, &z.1, doubt)?;
    let size = z.0.unary(Function::Abs, doubt)?;
    let half = S::exact(0.5);
    let large = modulus
        .add(&size)
        .multiply(&half)
        .unary(Function::Sqrt, doubt)?;
    let small = z.1.multiply(&half).divide(&large)?;
    if z.0.to_f64() >= 0.0 {
        return Ok((large, small));
    }
    let is_below = z.1.to_f64() < -z.1.bound();
    // On the cut the sign of the root hangs on the side, which more digits may tell.
    if !is_below && z.1.to_f64() <= z.1.bound() {
        doubt.note(z.1.bound());
    }
    let real = small.unary(Function::Abs, doubt)?;
    Ok((real, if is_below { large.negate() } else { large }))
}

fn exp<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    let growth = z.0.unary(Function::Exp, doubt)?;
    Ok((
        growth.multiply(&z.1.unary(Function::Cos, doubt)?),
        growth.multiply(&z.1.unary(Function::Sin, doubt)?),
    ))
}

fn ln<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    if is_zero(z) {
        return Err(Undefined::LogarithmOfZero);
    }
    let modulus = z.0.binary(Function::Hypot, &z.1, doubt)?;
    Ok((
        modulus.unary(Function::Ln, doubt)?,
        z.1.binary(Function::Atan2, &z.0, doubt)?,
    ))
}

/// sin(x + iy) = sin x cosh y + i cos x sinh y.
fn sin<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    let (sine, cosine) = (
        z.0.unary(Function::Sin, doubt)?,
        z.0.unary(Function::Cos, doubt)?,
    );
    Ok((
        sine.multiply(&z.1.unary(Function::Cosh, doubt)?),
        cosine.multiply(&z.1.unary(Function::Sinh, doubt)?),
    ))
}

/// cos(x + iy) = cos x cosh y - i sin x sinh y.
fn cos<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    let (sine, cosine) = (
        z.0.unary(Function::Sin, doubt)?,
        z.0.unary(Function::Cos, doubt)?,
    );
    Ok((
        cosine.multiply(&z.1.unary(Function::Cosh, doubt)?),
        sine.multiply(&z.1.unary(Function::Sinh, doubt)?).negate(),
    ))
}

/// ln(z + √(z² + 1)).
fn asinh<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    // The function is odd; on the right half-plane the sum does not cancel.
    if z.0.to_f64() < 0.0 {
        return Ok(negate(&asinh(&negate(z), doubt)?));
    }
    let root = sqrt(&add(&multiply(z, z), &one()), doubt)?;
    ln(&add(z, &root), doubt)
}

/// (ln(1 + z) - ln(1 - z))/2.
fn atanh<S: Scalar>(z: &ComplexPair<S>, doubt: &mut Doubt) -> ComplexResult<S> {
    let above = ln(&add(&one(), z), doubt)?;
    let below = ln(&subtract(&one(), z), doubt)?;
    Ok(halved(&subtract(&above, &below)))
}
