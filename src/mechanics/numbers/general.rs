//! The general solution of the linearized equations, with free constants.

use super::{Numbers, Unavailable, modal, steady};
use crate::expr::{Expr, Function, Kind, Operator};
use crate::numerics::Rational;

/// Numbers in a general solution are rounded to this many significant digits.
const DIGITS: usize = 6;

/// Components below this part of the largest are none.
const NOTHING: f64 = 1e-12;

/// How one mode moves, with two free constants `a` and `b`.
enum ModeCourse {
    /// `a + b t`.
    Rigid,
    /// `e^(−λt) (a cos ωt + b sin ωt)`.
    Oscillating { decay: f64, frequency: f64 },
    /// `(a + b t) e^(−λt)`.
    Critical { decay: f64 },
    /// `a e^(r₁t) + b e^(r₂t)`.
    Creeping { rates: [f64; 2] },
}

pub(crate) fn motion(numbers: &Numbers) -> Result<Vec<Expr>, Unavailable> {
    let size = numbers.model.degrees_of_freedom();
    let mut sums: Vec<Vec<(f64, Expr)>> = vec![Vec::new(); size];
    add_modes(numbers, &mut sums)?;
    for harmonic in numbers.excitation()? {
        let amplitudes = steady::amplitudes(numbers, harmonic)?;
        let angle = || timed(harmonic.frequency);
        for (sum, amplitude) in sums.iter_mut().zip(amplitudes) {
            sum.push((amplitude.re, Expr::call(Function::Cos, [angle()])));
            sum.push((-amplitude.im, Expr::call(Function::Sin, [angle()])));
        }
    }
    for (sum, rest) in sums.iter_mut().zip(numbers.equilibrium()?) {
        sum.push((*rest, Expr::number(1)));
    }
    Ok(sums.iter().map(|sum| written_sum(sum)).collect())
}

fn add_modes(numbers: &Numbers, sums: &mut [Vec<(f64, Expr)>]) -> Result<(), Unavailable> {
    let modes = numbers.modes()?;
    let dampings = modal::dampings(numbers)?;
    for (mode, damping) in dampings.into_iter().enumerate() {
        let frequency = modes
            .natural_angular_frequency(mode)
            .ok_or(Unavailable::Unstable)?;
        let index = if modes.count() == 1 {
            String::new()
        } else {
            (mode + 1).to_string()
        };
        let motion = course(frequency, damping).written(&index);
        let shape = modes.mode_shape(mode);
        let largest = shape
            .iter()
            .fold(0.0, |largest: f64, own| largest.max(own.abs()));
        let is_something = |own: &&f64| own.abs() > NOTHING * largest;
        let first = shape.iter().find(is_something).copied().unwrap_or(1.0);
        for (sum, component) in sums.iter_mut().zip(&shape) {
            if is_something(&component) {
                sum.push((component / first, motion.clone()));
            }
        }
    }
    Ok(())
}

/// The free motion of a mode with `p'' + c p' + ω² p = 0`.
fn course(frequency: f64, damping: f64) -> ModeCourse {
    let decay = 0.5 * damping;
    let square = (frequency - decay) * (frequency + decay);
    if frequency == 0.0 && damping == 0.0 {
        return ModeCourse::Rigid;
    }
    if square.abs() <= 1e-13 * frequency * frequency {
        return ModeCourse::Critical { decay };
    }
    if square > 0.0 {
        return ModeCourse::Oscillating {
            decay,
            frequency: square.sqrt(),
        };
    }
    let fast = -(decay + (-square).sqrt());
    let slow = frequency * frequency / fast;
    ModeCourse::Creeping {
        rates: [slow, fast],
    }
}

impl ModeCourse {
    fn written(&self, index: &str) -> Expr {
        let a = || Expr::name(format!("A{index}").as_str());
        let b = || Expr::name(format!("B{index}").as_str());
        let decaying = |rate: f64| Expr::call(Function::Exp, [timed(-rate)]);
        match self {
            Self::Rigid => a() + b() * Expr::name("t"),
            Self::Critical { decay } => (a() + b() * Expr::name("t")) * decaying(*decay),
            Self::Creeping { rates } => a() * decaying(-rates[0]) + b() * decaying(-rates[1]),
            Self::Oscillating { decay, frequency } => {
                let swing = a() * Expr::call(Function::Cos, [timed(*frequency)])
                    + b() * Expr::call(Function::Sin, [timed(*frequency)]);
                if *decay == 0.0 {
                    swing
                } else {
                    decaying(*decay) * swing
                }
            }
        }
    }
}

/// `rate*t`.
fn timed(rate: f64) -> Expr {
    rounded(rate) * Expr::name("t")
}

/// A number to six significant digits.
fn rounded(number: f64) -> Expr {
    let text = format!("{number:.*e}", DIGITS - 1);
    Rational::from_decimal(&text).map_or_else(|| Expr::number(0), Expr::number)
}

/// Factors and what they multiply, without the terms that are nothing beside the others.
fn written_sum(terms: &[(f64, Expr)]) -> Expr {
    let terms = terms
        .iter()
        .filter(|(factor, _)| rounded(*factor).as_number() != Some(Rational::ZERO));
    terms.fold(Expr::number(0), |sum, (factor, term)| {
        let size = rounded(factor.abs());
        let term = match term.as_number() {
            Some(_) => size,
            None if is_sum(term) && size.is_one() => term.clone(),
            None => size * term.clone(),
        };
        if *factor < 0.0 {
            sum - term
        } else {
            sum + term
        }
    })
}

/// Whether a formula is a sum.
fn is_sum(expr: &Expr) -> bool {
    matches!(
        expr.kind(),
        Kind::Binary(Operator::Add | Operator::Subtract, ..)
    )
}
