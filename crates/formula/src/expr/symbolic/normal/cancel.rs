//! What cancels in sums of products: denominators, and what equal functions come to.

use super::inner::Inner;
use super::term::{Atom, Monomial, Polynomial, settle};
use super::{SymbolicError, Work, trigonometry};
use vibank_dynamics::numerics::{Rational, SortedSet};

/// Each sum that stands in denominators is divided out of the terms over it where that is exact.
pub(crate) fn cancelled(
    polynomial: Polynomial,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let mut sum = polynomial;
    for base in denominators(&sum) {
        sum = cancelled_by(sum, &base, work)?;
    }
    Ok(sum)
}

fn cancelled_by(
    polynomial: Polynomial,
    base: &Inner,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let atom = Atom::Base(base.clone());
    let (mut over, mut rest) = (Polynomial::default(), Polynomial::default());
    for (monomial, coefficient) in polynomial.0 {
        let side = if monomial.exponent(&atom).is_negative() {
            &mut over
        } else {
            &mut rest
        };
        side.insert(monomial, coefficient)?;
    }
    // Terms over different powers are brought over the highest of them before they are divided.
    while let Some(least) = over.0.keys().map(|own| own.exponent(&atom)).min() {
        let up = Monomial::of(atom.clone(), -least);
        let numerator = over.times(&Polynomial::term(up, Rational::ONE), work)?;
        let Some(quotient) = numerator.divided_by(base, work)? else {
            break;
        };
        let exponent = least
            .checked_add(Rational::ONE)
            .ok_or(SymbolicError::TooLarge)?;
        let below = if exponent.is_zero() {
            Polynomial::one()
        } else {
            Polynomial::term(Monomial::of(atom.clone(), exponent), Rational::ONE)
        };
        over = quotient.times(&below, work)?;
        if !exponent.is_negative() {
            break;
        }
    }
    over.plus(rest)
}

/// The sums that stand in denominators.
fn denominators(polynomial: &Polynomial) -> SortedSet<Inner> {
    let factors = polynomial.0.keys().flat_map(|monomial| &monomial.0);
    let bases = factors
        .filter(|(_, exponent)| exponent.is_negative())
        .filter_map(|(atom, _)| match atom {
            Atom::Base(base) if base.as_number().is_none() => Some(base.clone()),
            _ => None,
        });
    bases.collect()
}

/// The form in which equal functions are the same: denominators cleared, angles taken apart, sin²
/// replaced. Only whether it is zero has a meaning for the original.
pub(crate) fn canonical(
    polynomial: &Polynomial,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let mut sum = trigonometry::with_angles_apart(polynomial, work)?;
    // Clearing one denominator can bring up another that stood within it.
    for _ in 0..16 {
        let Some(base) = denominators(&sum).into_iter().next() else {
            break;
        };
        let atom = Atom::Base(base);
        let exponents = sum.0.keys().map(|monomial| monomial.exponent(&atom));
        let least = exponents.min().unwrap_or(Rational::ZERO);
        let mut cleared = Polynomial::default();
        for (monomial, coefficient) in sum.0 {
            work.spend(1 + monomial.0.len())?;
            let raised = monomial.times(&Monomial::of(atom.clone(), -least))?;
            settle(raised, coefficient, &mut cleared, work)?;
        }
        sum = cleared;
    }
    trigonometry::with_sines_reduced(&sum, work)
}
