//! Derivatives and values at zero, term by term.
//!
//! Where the variables in question stand in powers alone, as they do in the energies of linear systems, nothing has
//! to be written as a formula and read again.

use std::collections::BTreeSet;

use super::term::{Atom, Monomial, Polynomial, fits, settle};
use super::{Normal, Order, SymbolicError, Work};
use crate::expr::{Expr, Kind, Name, Variable, differentiate, time_derivative};
use vibank_dynamics::numerics::Rational;

impl Normal {
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

    /// The partial derivative, where the variable stands in no function, and below in powers alone.
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
    pub fn time_derivative(&self, moving: &BTreeSet<Name>) -> Result<Self, SymbolicError> {
        let moves = |name: &Name| name.as_str() == "t" || moving.contains(name);
        let is_varying = |atom: &Atom| match atom {
            Atom::Variable(own) => own.name.as_str() == "t" || own.order > 0 && !moves(&own.name),
            other => other.any_variable(&|own| own.order > 0 || moves(&own.name)),
        };
        if self.atoms().any(is_varying) {
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
            let is_hidden = |(atom, exponent): &(Atom, Rational)| match atom {
                Atom::Variable(own) => exponent.is_negative() && is_zero(own),
                other => other.any_variable(is_zero),
            };
            if monomial.0.iter().any(is_hidden) {
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
}

impl Atom {
    /// Whether such a variable stands in it; of what is kept as it is written, whether its name does.
    fn any_variable(&self, is_wanted: &dyn Fn(&Variable) -> bool) -> bool {
        let inside = |sum: &Polynomial| {
            let mut factors = sum.0.keys().flat_map(|monomial| &monomial.0);
            factors.any(|(atom, _)| atom.any_variable(is_wanted))
        };
        match self {
            Self::Constant(_) => false,
            Self::Variable(own) => is_wanted(own),
            Self::Call(_, arguments) => arguments.iter().any(|sum| inside(sum)),
            Self::Base(sum) => inside(sum),
            Self::Power(base, exponent) => inside(base) || inside(exponent),
            Self::Opaque(opaque) => {
                let mut found = false;
                opaque.expr.walk(&mut |node| {
                    if let Kind::Name(name) = node.kind() {
                        found |= (0..=2).any(|order| is_wanted(&Variable::of(name, order)));
                    }
                });
                found
            }
        }
    }
}
