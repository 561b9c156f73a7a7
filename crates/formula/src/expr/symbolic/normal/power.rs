//! Powers of sums and products, and what all terms of a sum have in common.

use super::inner::Inner;
use super::term::{Atom, Monomial, Polynomial, fits, settled};
use super::{SymbolicError, Work};
use crate::expr::Constant;
use vibank_dynamics::numerics::Rational;

/// The largest whole exponent to which a sum is multiplied out.
const MAX_EXPONENT: i128 = 64;

/// Numbers under roots are taken apart by divisors up to this one; what is left counts as a prime.
const MAX_DIVISOR: i128 = 1_000;

pub(crate) fn of(
    polynomial: &Polynomial,
    exponent: Rational,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    if exponent.is_zero() {
        return Ok(Polynomial::one());
    }
    if polynomial.is_zero() {
        return if exponent.is_negative() {
            Err(SymbolicError::Undefined)
        } else {
            Ok(polynomial.clone())
        };
    }
    if exponent.abs().numerator() > MAX_EXPONENT * exponent.denominator() {
        return Err(SymbolicError::TooLarge);
    }
    if let Some(number) = polynomial.as_number() {
        return power_of_number(number, exponent, work);
    }
    if !exponent.is_integer() {
        return root(polynomial, exponent, work);
    }
    if let Some((monomial, coefficient)) = polynomial.as_term() {
        let scale = power_of_number(coefficient, exponent, work)?;
        return settled(monomial.power(exponent)?, work)?.times(&scale, work);
    }
    if !exponent.is_negative() {
        let whole = exponent.numerator();
        return polynomial.raised(u32::try_from(whole).unwrap_or(u32::MAX), work);
    }
    let (content, common, rest) = primitive(polynomial)?;
    let outside = of(&Polynomial::term(common, content), exponent, work)?;
    let base = Atom::Base(Inner::from(rest));
    Polynomial::term(Monomial::of(base, exponent), Rational::ONE).times(&outside, work)
}

/// A power that is not whole: of the positive numbers in front, and of all the rest as one base,
/// because a root may not be split without knowing signs.
fn root(
    polynomial: &Polynomial,
    exponent: Rational,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let content = content(polynomial)?;
    let mut rest = polynomial
        .clone()
        .scaled(fits(Rational::ONE.checked_div(content))?)?;
    let mut outside = power_of_number(content, exponent, work)?;
    if let Some((monomial, coefficient)) = rest.as_term() {
        let (positive, others): (Vec<_>, Vec<_>) = monomial
            .0
            .iter()
            .cloned()
            .partition(|(atom, _)| is_positive(atom));
        let positive = Polynomial::term(Monomial(positive).power(exponent)?, Rational::ONE);
        outside = outside.times(&positive, work)?;
        rest = Polynomial::term(Monomial(others), coefficient);
        if let Some(sign) = rest.as_number() {
            return outside.times(&power_of_number(sign, exponent, work)?, work);
        }
    }
    kept(rest, exponent, work)?.times(&outside, work)
}

/// A power as it stands.
fn kept(
    base: Polynomial,
    exponent: Rational,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    settled(Monomial::of(Atom::Base(Inner::from(base)), exponent), work)
}

/// The positive number that divides all coefficients and leaves integers without common divisor.
fn content(polynomial: &Polynomial) -> Result<Rational, SymbolicError> {
    let mut coefficients = polynomial.0.values();
    let first = coefficients.next().copied().unwrap_or(Rational::ONE).abs();
    coefficients.try_fold(first, |common, own| fits(common_divisor(common, own.abs())))
}

/// The product of atoms that stands in all terms, with negative exponents taken along.
fn common_monomial(polynomial: &Polynomial) -> Monomial {
    let mut monomials = polynomial.0.keys();
    let first = monomials.next().cloned().unwrap_or_default();
    monomials.fold(first, |common, own| common.common(own))
}

/// Number, monomial and rest whose product it is; the rest has whole coefficients without common
/// divisor, no common atom, and a positive leading term.
pub(crate) fn primitive(
    polynomial: &Polynomial,
) -> Result<(Rational, Monomial, Polynomial), SymbolicError> {
    let mut content = content(polynomial)?;
    if polynomial
        .leading()
        .is_some_and(|(_, leading)| leading.is_negative())
    {
        content = -content;
    }
    let common = common_monomial(polynomial);
    let (divisor, inverse) = (fits(Rational::ONE.checked_div(content))?, common.inverse());
    let mut rest = Polynomial::default();
    for (monomial, coefficient) in &polynomial.0 {
        let coefficient = fits(coefficient.checked_mul(divisor))?;
        rest.insert(monomial.times(&inverse)?, coefficient)?;
    }
    Ok((content, common, rest))
}

fn is_positive(atom: &Atom) -> bool {
    // Names may have any sign, and the root of a product is that of its factors for positive ones alone.
    matches!(atom, Atom::Constant(Constant::Pi | Constant::E))
}

/// The greatest fraction that goes into both an integer number of times.
pub(crate) fn common_divisor(a: Rational, b: Rational) -> Option<Rational> {
    let left = a.numerator().checked_mul(b.denominator())?;
    let right = b.numerator().checked_mul(a.denominator())?;
    Rational::new(
        gcd(left, right),
        a.denominator().checked_mul(b.denominator())?,
    )
}

/// The greatest common divisor.
fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// A power of a pure number, with roots of primes as bases: `12^(1/2)` is `2*3^(1/2)`.
fn power_of_number(
    number: Rational,
    exponent: Rational,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    if exponent.is_integer() {
        let power = i32::try_from(exponent.numerator()).ok();
        let value = power.and_then(|power| number.checked_pow(power));
        return Ok(Polynomial::number(fits(value)?));
    }
    let mut product = Polynomial::one();
    let mut magnitude = number;
    if number.is_negative() {
        magnitude = -number;
        product = product.times(&root_of(-Rational::ONE, exponent, work)?, work)?;
    }
    for (prime, count) in prime_factors(magnitude.numerator()).into_iter().chain(
        prime_factors(magnitude.denominator())
            .into_iter()
            .map(|(p, n)| (p, -n)),
    ) {
        let count = fits(Rational::new(count, 1).and_then(|count| exponent.checked_mul(count)))?;
        product = product.times(&root_of(fits(Rational::new(prime, 1))?, count, work)?, work)?;
    }
    Ok(product)
}

fn root_of(
    number: Rational,
    exponent: Rational,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    if number == -Rational::ONE && exponent.denominator() == 2 {
        let unit = Monomial::of(Atom::Constant(Constant::ImaginaryUnit), Rational::ONE);
        let turns = Rational::new(exponent.numerator(), 1);
        return settled(unit.power(fits(turns)?)?, work);
    }
    kept(Polynomial::number(number), exponent, work)
}

/// Prime factors with their multiplicities, as far as trial division goes.
fn prime_factors(mut number: i128) -> Vec<(i128, i128)> {
    let mut factors = Vec::new();
    let mut divisor = 2;
    while divisor <= MAX_DIVISOR && divisor * divisor <= number {
        let mut count = 0;
        while number % divisor == 0 {
            number /= divisor;
            count += 1;
        }
        if count > 0 {
            factors.push((divisor, count));
        }
        divisor += 1;
    }
    if number > 1 {
        factors.push((number, 1));
    }
    factors
}
