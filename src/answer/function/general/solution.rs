//! What was typed as a general solution, made ready to be compared with the equations.

use super::Setup;
use super::complex::{self, Parts};
use crate::answer::{Unreadable, Why};
use crate::expr::{Equation, Expr, Kind, Name, Program};
use crate::numerics::{Rational, SortedMap};

/// A typed solution as programs, by coordinate.
pub(crate) struct TypedSolution {
    pub(crate) positions: Vec<Program>,
    pub(crate) velocities: Vec<Program>,
    pub(crate) accelerations: Vec<Program>,
    pub(crate) residuals: Vec<Program>,
    /// Left minus right of the equations with positions as inputs.
    pub(crate) bare: Vec<Program>,
    /// The constants that occur in it, as places.
    pub(crate) used: Vec<usize>,
    /// The largest share of one of its decimal numbers that rounding may have taken; zero where it has none.
    pub(crate) rounding: f64,
}

impl TypedSolution {
    /// A response as one solution of real numbers, or as two, the real and the imaginary part of one of complex
    /// numbers.
    ///
    /// # Errors
    ///
    /// Why the response has no derivatives that can be compared.
    pub(crate) fn all(setup: &Setup, typed: &[Expr]) -> Result<Vec<Self>, Unreadable> {
        let none = || Unreadable::of(Why::Undifferentiable);
        let solution = |typed: &[Expr]| Self::of(setup, typed).ok_or_else(none);
        if !typed.iter().any(complex::is_complex) {
            return Ok(vec![solution(typed)?]);
        }
        let own = used(setup, typed);
        let phases: Vec<Name> = typed.iter().flat_map(complex::phases).collect();
        let names = own.iter().map(|place| &setup.constants[*place]);
        let free = (0..setup.constants.len()).filter(|place| !own.contains(place));
        let partners = free.map(|place| setup.constants[place].clone());
        let complex: SortedMap<Name, Name> = names
            .filter(|name| !phases.contains(name))
            .cloned()
            .zip(partners)
            .collect();
        let parts: Vec<Parts> = typed
            .iter()
            .map(|formula| Parts::of(formula, &complex))
            .collect::<Option<_>>()
            .ok_or_else(none)?;
        let size = |own: &Parts| own.real.size() + own.imaginary.as_ref().map_or(0, Expr::size);
        if parts.iter().map(size).sum::<u32>() > complex::MAX_SIZE {
            return Err(Why::TooLong.into());
        }
        let real: Vec<Expr> = parts.iter().map(|own| own.real.clone()).collect();
        let imaginary: Vec<Expr> = parts
            .into_iter()
            .map(|own| own.imaginary.unwrap_or_else(|| Expr::number(0)))
            .collect();
        let mut solutions = vec![solution(&real)?];
        if !imaginary.iter().all(Expr::is_zero) {
            solutions.push(solution(&imaginary)?);
        }
        Ok(solutions)
    }

    fn of(setup: &Setup, typed: &[Expr]) -> Option<Self> {
        let coordinates = setup.coordinates.iter().cloned();
        let replaced: SortedMap<Name, Expr> = coordinates.zip(typed.iter().cloned()).collect();
        let none = SortedMap::new();
        let mut rounding = 0.0_f64;
        for expr in typed {
            expr.walk(&mut |node| {
                if let Kind::Number(value) = node.kind() {
                    rounding = rounding.max(rounding_of(*value));
                }
            });
        }
        let all = |exprs: &[Expr], replaced| -> Option<Vec<Program>> {
            exprs
                .iter()
                .map(|expr| setup.meaning.compile(expr, replaced).ok())
                .collect()
        };
        let differences: Vec<Expr> = setup.equations.iter().map(Equation::difference).collect();
        let rates = |order| {
            let names = setup.coordinates.iter().cloned();
            names
                .map(|name| Expr::name(name).prime(order))
                .collect::<Vec<_>>()
        };
        Some(Self {
            used: used(setup, typed),
            positions: all(typed, &none)?,
            velocities: all(&rates(1), &replaced)?,
            accelerations: all(&rates(2), &replaced)?,
            residuals: all(&differences, &replaced)?,
            bare: all(&differences, &none)?,
            rounding,
        })
    }
}

/// The constants that occur in a response, as places.
pub(crate) fn used(setup: &Setup, typed: &[Expr]) -> Vec<usize> {
    let names: Vec<_> = typed.iter().map(Expr::names).collect();
    let used = (0..setup.constants.len()).filter(|place| {
        let mut names = names.iter();
        names.any(|names| names.uses(&setup.constants[*place]))
    });
    used.collect()
}

/// The share of a number by which rounding moved it at most, half a unit of its last decimal; at least that of four
/// figures, and at most that of three. Zero for an integer.
fn rounding_of(value: Rational) -> f64 {
    const MOST_DECIMALS: i32 = 12;
    if value.is_integer() {
        return 0.0;
    }
    let number = value.to_f64().abs();
    let places = (1..=MOST_DECIMALS)
        .find(|places| {
            let shifted = number * crate::numerics::powi(10.0, *places);
            (shifted - shifted.round()).abs() <= 1e-9 * shifted
        })
        .unwrap_or(MOST_DECIMALS);
    let half = 0.5 * crate::numerics::powi(10.0, -places);
    (half / number).clamp(0.0005, 0.005)
}
