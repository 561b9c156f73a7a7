//! A normal form of formulas: sums of products with exact coefficients.
//!
//! A formula becomes a polynomial with fractions as coefficients over *atoms*: names and their time
//! derivatives, functions whose arguments are in normal form, and sums that stand in denominators or
//! under roots. Products of sums are multiplied out, powers of one atom are collected, common
//! denominators cancel where the division is exact, and sin² + cos² = 1 is used where it shortens.
//! No sign of a name is assumed, so `sqrt(x^2)` stays.
//!
//! [`Normal`] tells whether two formulas are equal, takes them apart by coordinates, divides common
//! factors out, and writes them back as a textbook orders them ([`Order`]).

mod cancel;
mod harmonic;
mod inner;
mod power;
mod read;
mod term;
#[cfg(test)]
mod tests;
mod trigonometry;
mod write;

pub use harmonic::Harmonic;
pub use write::Order;
pub use write::sum_of_signed_terms;

use super::{SymbolicError, Variable};
use crate::expr::{Expr, Name, differentiate, time_derivative};
use crate::work;
use term::{Atom, Monomial, Polynomial, fits, settle};
use vibank_dynamics::numerics::{Rational, SortedSet};

/// Elementary products and sums that one normal form may cost.
const MAX_WORK: usize = 500_000;

/// Units of work of an elementary product: it allocates.
const UNITS: u64 = 10;

/// What is left of the bound on a calculation.
#[derive(Debug)]
struct Work {
    left: usize,
}

impl Work {
    fn new() -> Self {
        Self { left: MAX_WORK }
    }

    fn spend(&mut self, amount: usize) -> Result<(), SymbolicError> {
        work::spend(UNITS * amount as u64)?;
        self.left = self
            .left
            .checked_sub(amount)
            .ok_or(SymbolicError::TooLarge)?;
        Ok(())
    }
}

/// A formula as a sum of products with exact coefficients.
///
/// ```
/// use vibank_formula::expr::{Expr, Name, Normal, Order};
/// let [a, b] = [Expr::name("a"), Expr::name("b")];
/// let square = Normal::of(&(a.clone() + b.clone()).squared()).unwrap();
/// let expanded = a.clone().squared() + Expr::number(2) * a * b.clone() + b.squared();
/// assert!(square.is_equal(&Normal::of(&expanded).unwrap()).unwrap());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Normal(Polynomial);

impl Normal {
    /// The normal form of a formula.
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`], [`SymbolicError::Undefined`] for a division by zero, and the errors
    /// of derivatives that stand in the formula.
    pub fn of(expr: &Expr) -> Result<Self, SymbolicError> {
        let work = &mut Work::new();
        Self::finished(read::polynomial(expr, work)?, work)
    }

    /// What cancels is cancelled, and angles are combined.
    fn finished(sum: Polynomial, work: &mut Work) -> Result<Self, SymbolicError> {
        let cancelled = cancel::cancelled(sum, work)?;
        Ok(Self(trigonometry::with_angles_combined(cancelled, work)?))
    }

    /// Whether it is zero as it stands; [`Self::is_equal`] looks further.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Its value if it is a pure number.
    pub fn as_number(&self) -> Option<Rational> {
        self.0.as_number()
    }

    /// Whether both are the same function: their difference vanishes over a common denominator, with
    /// sines and cosines of sums taken apart and sin² replaced by 1 − cos².
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`].
    pub fn is_equal(&self, other: &Self) -> Result<bool, SymbolicError> {
        let work = &mut Work::new();
        let difference = self.0.clone().plus(other.0.clone().negated())?;
        Ok(cancel::canonical(&difference, work)?.is_zero())
    }

    /// The number of its terms.
    pub fn terms(&self) -> usize {
        self.0.0.len()
    }

    /// The sum.
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`], as for all operations here.
    pub fn plus(&self, other: &Self) -> Result<Self, SymbolicError> {
        Ok(Self(self.0.clone().plus(other.0.clone())?))
    }

    /// The product.
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`].
    pub fn times(&self, other: &Self) -> Result<Self, SymbolicError> {
        let work = &mut Work::new();
        let product = self.0.times(&other.0, work)?;
        Ok(Self(cancel::cancelled(product, work)?))
    }

    /// The opposite.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self(self.0.clone().negated())
    }

    /// The exact quotient, or a fraction with the divisor below where there is none.
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`], [`SymbolicError::Undefined`] for a division by zero.
    pub fn over(&self, divisor: &Self) -> Result<Self, SymbolicError> {
        let work = &mut Work::new();
        if let Some(exact) = self.0.divided_by(&divisor.0, work)? {
            return Ok(Self(exact));
        }
        let inverse = divisor.0.power(-Rational::ONE, work)?;
        let quotient = self.0.times(&inverse, work)?;
        Ok(Self(cancel::cancelled(quotient, work)?))
    }

    /// The terms apart by the powers of one variable: exponent and coefficient, ascending; nothing
    /// where the variable also stands inside a function or in a denominator that is a sum.
    pub fn powers_of(&self, variable: &Variable) -> Option<Vec<(Rational, Self)>> {
        let atom = Atom::Variable(variable.clone());
        let mut powers: Vec<(Rational, Polynomial)> = Vec::new();
        for (monomial, coefficient) in &self.0.0 {
            let (exponent, rest) = (monomial.exponent(&atom), monomial.without(&atom));
            if rest.0.iter().any(|(own, _)| own.contains(variable)) {
                return None;
            }
            let at = match powers.binary_search_by(|(own, _)| own.cmp(&exponent)) {
                Ok(at) => at,
                Err(at) => {
                    powers.insert(at, (exponent, Polynomial::default()));
                    at
                }
            };
            powers[at].1.0.insert(rest, *coefficient);
        }
        let powers = powers.into_iter();
        Some(
            powers
                .map(|(exponent, sum)| (exponent, Self(sum)))
                .collect(),
        )
    }

    /// The highest sum of exponents of these variables in a term; nothing where it is not a polynomial in them.
    pub fn degree_in(&self, variables: &[Variable]) -> Option<u32> {
        let mut degree = 0;
        for monomial in self.0.0.keys() {
            let mut sum = Rational::ZERO;
            for (atom, exponent) in &monomial.0 {
                match atom {
                    Atom::Variable(own) if variables.contains(own) => {
                        sum = sum
                            .checked_add(*exponent)
                            .filter(|_| !exponent.is_negative())?;
                    }
                    _ if variables.iter().any(|variable| atom.contains(variable)) => return None,
                    _ => {}
                }
            }
            let whole = Some(sum.numerator()).filter(|_| sum.is_integer())?;
            degree = degree.max(u32::try_from(whole).ok()?);
        }
        Some(degree)
    }

    /// Whether all coefficients are negative, so that it is negative for positive names.
    pub fn has_negative_coefficients_alone(&self) -> bool {
        !self.is_zero() && self.0.0.values().all(|own| own.is_negative())
    }

    /// The coefficient of a variable and the rest, where it stands to the first power at most.
    pub fn linear_in(&self, variable: &Variable) -> Option<(Self, Self)> {
        let (mut slope, mut rest) = (Self(Polynomial::default()), Self(Polynomial::default()));
        for (exponent, coefficient) in self.powers_of(variable)? {
            match exponent {
                _ if exponent.is_zero() => rest = coefficient,
                _ if exponent == Rational::ONE => slope = coefficient,
                _ => return None,
            }
        }
        Some((slope, rest))
    }

    /// The terms in which one of these names stands (also primed, or within functions), and the others.
    pub fn split_by(&self, names: &SortedSet<Name>) -> (Self, Self) {
        let (with, without) = self
            .0
            .0
            .iter()
            .map(|(monomial, own)| (monomial.clone(), *own))
            .partition(|(monomial, _)| monomial.0.iter().any(|(atom, _)| atom.mentions(names)));
        (Self(Polynomial(with)), Self(Polynomial(without)))
    }

    /// Whether a name stands in it, also primed.
    pub fn mentions(&self, name: &Name) -> bool {
        self.mentions_any(&SortedSet::from([name.clone()]))
    }

    /// Whether one of these names stands in it, also primed.
    pub fn mentions_any(&self, names: &SortedSet<Name>) -> bool {
        self.0.mentions(names)
    }

    /// The factor common to all terms and what is left: the number that leaves whole coefficients
    /// without common divisor (negative if the leading term is), and the names common to all terms.
    /// Names that are `kept` stay in the terms.
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`].
    pub fn without_common_factor(
        &self,
        kept: &SortedSet<Name>,
    ) -> Result<(Self, Self), SymbolicError> {
        if self.is_zero() {
            return Ok((Self(Polynomial::one()), self.clone()));
        }
        let work = &mut Work::new();
        let (content, common, _) = power::primitive(&self.0)?;
        let factors = common
            .0
            .into_iter()
            .filter(|(atom, _)| !atom.mentions(kept));
        let factor = Polynomial::term(Monomial(factors.collect()), content.abs());
        let inverse = factor.power(-Rational::ONE, work)?;
        let rest = cancel::cancelled(self.0.times(&inverse, work)?, work)?;
        Ok((Self(factor), Self(rest)))
    }

    /// It as a formula, with the order of a textbook.
    pub fn to_expr(&self, order: &Order) -> Expr {
        write::sum(&self.0, order)
    }

    /// It as a formula that begins with a positive term if it has one, as a sum in brackets does.
    pub fn to_bracket(&self, order: &Order) -> Expr {
        write::bracket(&self.0, order)
    }

    /// The partial derivative.
    ///
    /// ```
    /// use vibank_formula::expr::{Expr, Normal, Variable};
    /// let energy = Normal::of(&Expr::read("1/2*k*x^2 + m*g*x")?)?;
    /// let force = Normal::of(&Expr::read("k*x + m*g")?)?;
    /// assert_eq!(energy.derivative(&Variable::from("x"))?, force);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of [`differentiate`] and [`Self::of`].
    pub fn derivative(&self, by: &Variable) -> Result<Self, SymbolicError> {
        match self.derivative_by_terms(by)? {
            Some(derivative) => Ok(derivative),
            None => Self::of(&differentiate(&self.to_expr(&Order::new()), by.clone())?),
        }
    }

    /// The partial derivative of a formula whose normal form this is; what is wrong with it has its place there.
    ///
    /// # Errors
    ///
    /// Those of [`differentiate`] and [`Self::of`].
    pub fn derivative_of(&self, formula: &Expr, by: &Variable) -> Result<Self, SymbolicError> {
        match self.derivative_by_terms(by)? {
            Some(derivative) => Ok(derivative),
            None => Self::of(&differentiate(formula, by.clone())?),
        }
    }

    /// The partial derivative, where the variable stands in no function, and below in powers alone, as it does in the
    /// energies of linear systems: nothing has to be written as a formula and read again.
    fn derivative_by_terms(&self, by: &Variable) -> Result<Option<Self>, SymbolicError> {
        let own = Atom::Variable(by.clone());
        if self.atoms().any(|atom| *atom != own && atom.contains(by)) {
            return Ok(None);
        }
        let work = &mut Work::new();
        let mut sum = Polynomial::default();
        for (monomial, coefficient) in &self.0.0 {
            let exponent = monomial.exponent(&own);
            if !exponent.is_zero() {
                let factor = fits(coefficient.checked_mul(exponent))?;
                let lower = Monomial::of(own.clone(), -Rational::ONE);
                settle(monomial.times(&lower)?, factor, &mut sum, work)?;
            }
        }
        Self::finished(sum, work).map(Some)
    }

    /// The total derivative by time, where these names move: see [`time_derivative`].
    ///
    /// # Errors
    ///
    /// Those of [`time_derivative`] and [`Self::of`].
    pub fn time_derivative(&self, moving: &SortedSet<Name>) -> Result<Self, SymbolicError> {
        let moves = |name: &Name| name.as_str() == "t" || moving.contains(name);
        let is_varying = self.atoms().any(|atom| match atom {
            Atom::Variable(own) => own.name.as_str() == "t" || own.order > 0 && !moves(&own.name),
            other => other.any_variable(&|own| own.order > 0 || moves(&own.name)),
        });
        if is_varying {
            let formula = self.to_expr(&Order::new());
            return Self::of(&time_derivative(&formula, moving)?);
        }
        let work = &mut Work::new();
        let mut sum = Polynomial::default();
        for (monomial, coefficient) in &self.0.0 {
            for (atom, exponent) in &monomial.0 {
                let Atom::Variable(own) = atom else { continue };
                if !moves(&own.name) {
                    continue;
                }
                let rate = Atom::Variable(Variable::of(&own.name, own.order.saturating_add(1)));
                let factor = fits(coefficient.checked_mul(*exponent))?;
                let lower = monomial.times(&Monomial::of(atom.clone(), -Rational::ONE))?;
                let term = lower.times(&Monomial::of(rate, Rational::ONE))?;
                settle(term, factor, &mut sum, work)?;
            }
        }
        Self::finished(sum, work)
    }

    /// The value where these variables are zero; nothing where one of them stands within a function, or below.
    pub fn where_zero(&self, is_zero: &dyn Fn(&Variable) -> bool) -> Option<Self> {
        let vanishes = |(atom, _): &(Atom, Rational)| match atom {
            Atom::Variable(own) => is_zero(own),
            _ => false,
        };
        let mut kept = Polynomial::default();
        for (monomial, coefficient) in &self.0.0 {
            let is_hidden = monomial.0.iter().any(|(atom, exponent)| match atom {
                Atom::Variable(own) => exponent.is_negative() && is_zero(own),
                other => other.any_variable(is_zero),
            });
            if is_hidden {
                return None;
            }
            if !monomial.0.iter().any(vanishes) {
                kept.0.insert(monomial.clone(), *coefficient);
            }
        }
        Self::finished(kept, &mut Work::new()).ok()
    }

    /// All factors of all terms.
    fn atoms(&self) -> impl Iterator<Item = &Atom> {
        let factors = self.0.0.keys().flat_map(|monomial| &monomial.0);
        factors.map(|(atom, _)| atom)
    }

    /// The part without time, and the harmonics of a function of time; nothing if it has other terms.
    ///
    /// ```
    /// use vibank_formula::expr::{Expr, Name, Normal};
    /// let force = Expr::read("F0*sin(Omega*t + phi) + m*g")?;
    /// let (constant, harmonics) = Normal::of(&force)?.harmonics(&Name::new("t"))?.unwrap();
    /// assert!(constant.is_equal(&Normal::of(&Expr::read("m*g")?)?)?);
    /// assert!(harmonics[0].is_sine);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`SymbolicError::TooLarge`].
    pub fn harmonics(&self, time: &Name) -> Result<Option<(Self, Vec<Harmonic>)>, SymbolicError> {
        harmonic::apart(self, time)
    }
}
