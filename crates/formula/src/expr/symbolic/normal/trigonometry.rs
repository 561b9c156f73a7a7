//! Functions of one argument: signs and special angles, sums of angles, and sin² + cos² = 1.

use std::collections::BTreeMap;

use super::inner::Inner;
use super::power::common_divisor;
use super::term::{Atom, Monomial, Polynomial, fits, settled};
use super::{SymbolicError, Work};
use crate::expr::{Constant, Function};
use vibank_dynamics::numerics::Rational;

/// Sines and cosines of whole multiples of an angle are taken apart up to this multiple.
const MAX_MULTIPLE: i128 = 8;

/// Sums are searched for terms that combine up to this number of terms.
// The search begins anew with each pair that was joined, so that its time grows with the square.
const MAX_TERMS_COMBINED: usize = 200;

/// A function of one argument in normal form, with signs and constants taken out.
pub(crate) fn call(
    function: Function,
    argument: Polynomial,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    if argument.is_zero()
        && let Some(value) = at_zero(function)
    {
        return Ok(Polynomial::number(value.into()));
    }
    if matches!(function, Function::Sin | Function::Cos)
        && let Some(shifted) = without_quarter_turns(function, &argument, work)?
    {
        return Ok(shifted);
    }
    if matches!(function, Function::Abs | Function::Sign)
        && let Some(value) = argument.as_number()
    {
        let sign = Rational::from(value.numerator().signum() as i32);
        return Ok(Polynomial::number(match function {
            Function::Abs => value.abs(),
            _ => sign,
        }));
    }
    // By the sign of the leading term, so that sin(a - b) and -sin(b - a) come to one form.
    let is_negative = argument
        .leading()
        .is_some_and(|(_, leading)| leading.is_negative());
    let of = |argument: Polynomial| Polynomial::atom(Atom::Call(function, vec![argument.into()]));
    Ok(match parity(function) {
        Parity::Odd if is_negative => of(argument.negated()).negated(),
        Parity::Even if is_negative => of(argument.negated()),
        _ => of(argument),
    })
}

fn at_zero(function: Function) -> Option<i32> {
    match function {
        Function::Sin
        | Function::Tan
        | Function::Asin
        | Function::Atan
        | Function::Sinh
        | Function::Tanh
        | Function::Asinh
        | Function::Atanh
        | Function::Abs
        | Function::Sign
        | Function::Re
        | Function::Im
        | Function::Conj
        | Function::Floor
        | Function::Ceil
        | Function::Round => Some(0),
        Function::Cos | Function::Cosh | Function::Exp => Some(1),
        _ => None,
    }
}

enum Parity {
    Even,
    Odd,
    Neither,
}

fn parity(function: Function) -> Parity {
    match function {
        Function::Sin
        | Function::Tan
        | Function::Asin
        | Function::Atan
        | Function::Sinh
        | Function::Tanh
        | Function::Asinh
        | Function::Atanh
        | Function::Sign
        | Function::Re
        | Function::Im
        | Function::Conj => Parity::Odd,
        Function::Cos | Function::Cosh | Function::Abs => Parity::Even,
        _ => Parity::Neither,
    }
}

/// A sine or cosine whose angle holds quarter turns, and the values at multiples of π/6.
fn without_quarter_turns(
    function: Function,
    angle: &Polynomial,
    work: &mut Work,
) -> Result<Option<Polynomial>, SymbolicError> {
    let pi = Monomial::of(Atom::Constant(Constant::Pi), Rational::ONE);
    let Some(share) = angle.0.get(&pi).copied() else {
        return Ok(None);
    };
    let mut rest = angle.clone();
    rest.0.remove(&pi);
    let quarters = fits(share.checked_mul(Rational::from(2)))?;
    if !quarters.is_integer() {
        return Ok(match (rest.is_zero(), function) {
            (true, Function::Sin) => sine_of_twelfths(share).map(Polynomial::number),
            (true, _) => Rational::new(1, 2)
                .and_then(|half| half.checked_sub(share))
                .and_then(sine_of_twelfths)
                .map(Polynomial::number),
            (false, _) => None,
        });
    }
    // cos(u) is sin(u + π/2): both are sines of quarter turns.
    let shift = i128::from(function == Function::Cos);
    let turns = (quarters.numerator() + shift).rem_euclid(4);
    let kind = match turns % 2 {
        0 => Function::Sin,
        _ => Function::Cos,
    };
    let value = call(kind, rest, work)?;
    Ok(Some(if turns >= 2 { value.negated() } else { value }))
}

/// sin(share π) where it is a fraction and no multiple of a quarter turn: ±1/2.
fn sine_of_twelfths(share: Rational) -> Option<Rational> {
    let sixths = share.checked_mul(Rational::from(6))?;
    if !sixths.is_integer() {
        return None;
    }
    match sixths.numerator().rem_euclid(12) {
        1 | 5 => Rational::new(1, 2),
        7 | 11 => Rational::new(-1, 2),
        _ => None,
    }
}

/// What is substituted for an atom, if anything is.
type Change<'a> = dyn FnMut(&Atom, &mut Work) -> Result<Option<Polynomial>, SymbolicError> + 'a;

/// Puts another sum in for atoms, wherever `change` has one.
fn with_atoms_changed(
    polynomial: &Polynomial,
    work: &mut Work,
    change: &mut Change<'_>,
) -> Result<Polynomial, SymbolicError> {
    let mut sum = Polynomial::default();
    for (monomial, coefficient) in &polynomial.0 {
        work.spend(1 + monomial.0.len())?;
        let mut product = Polynomial::number(*coefficient);
        for (atom, exponent) in &monomial.0 {
            let factor = if let Some(changed) = change(atom, work)? {
                changed.power(*exponent, work)?
            } else {
                settled(Monomial::of(atom.clone(), *exponent), work)?
            };
            product = product.times(&factor, work)?;
        }
        sum = sum.plus(product)?;
    }
    Ok(sum)
}

/// Sines and cosines of sums and of multiples written in those of single angles.
pub(crate) fn with_angles_apart(
    polynomial: &Polynomial,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    // In one unit: with sin 2x and sin x as atoms of their own, sin 2x - 2 sin x cos x would not vanish.
    let mut units = BTreeMap::new();
    collect_angles(polynomial, &mut units);
    with_angles_in(polynomial, &units, work)
}

/// The greatest common divisor of the multiples in which each angle occurs.
fn collect_angles(polynomial: &Polynomial, units: &mut BTreeMap<Monomial, Rational>) {
    for atom in polynomial.0.keys().flat_map(|monomial| &monomial.0) {
        match &atom.0 {
            Atom::Call(Function::Sin | Function::Cos, arguments) => {
                for (angle, multiple) in arguments.iter().flat_map(|sum| &sum.0) {
                    let unit = units
                        .get(angle)
                        .and_then(|unit| common_divisor(*unit, multiple.abs()))
                        .unwrap_or(multiple.abs());
                    units.insert(angle.clone(), unit);
                }
            }
            Atom::Base(sum) => collect_angles(sum, units),
            _ => {}
        }
    }
}

fn with_angles_in(
    polynomial: &Polynomial,
    units: &BTreeMap<Monomial, Rational>,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    with_atoms_changed(polynomial, work, &mut |atom, work| match atom {
        Atom::Call(Function::Sin, arguments) => {
            Ok(Some(sine_and_cosine(&arguments[0], units, work)?.0))
        }
        Atom::Call(Function::Cos, arguments) => {
            Ok(Some(sine_and_cosine(&arguments[0], units, work)?.1))
        }
        Atom::Base(sum) => Ok(Some(with_angles_in(sum, units, work)?)),
        _ => Ok(None),
    })
}

/// sin² replaced by 1 − cos² everywhere.
pub(crate) fn with_sines_reduced(
    polynomial: &Polynomial,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let mut sum = polynomial.clone();
    for angle in squared_angles(polynomial) {
        sum = with_square_replaced(&sum, [Function::Sin, Function::Cos], &angle, work)?;
    }
    Ok(sum)
}

/// The angles whose sine or cosine stands at least squared.
fn squared_angles(polynomial: &Polynomial) -> Vec<Inner> {
    let factors = polynomial.0.keys().flat_map(|monomial| &monomial.0);
    let mut angles: Vec<_> = factors
        .filter(|(_, exponent)| *exponent >= Rational::from(2))
        .filter_map(|(atom, _)| match atom {
            Atom::Call(Function::Sin | Function::Cos, arguments) => Some(arguments[0].clone()),
            _ => None,
        })
        .collect();
    vibank_dynamics::numerics::sort_by(&mut angles, Ord::cmp);
    angles.dedup();
    angles
}

/// f(angle)² replaced by 1 − g(angle)².
fn with_square_replaced(
    polynomial: &Polynomial,
    [from, to]: [Function; 2],
    angle: &Inner,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let square = Atom::Call(from, vec![angle.clone()]);
    let other = Monomial::of(Atom::Call(to, vec![angle.clone()]), Rational::from(2));
    let one_less = Polynomial::one().plus(Polynomial::term(other, -Rational::ONE))?;
    let mut sum = Polynomial::default();
    for (monomial, coefficient) in &polynomial.0 {
        let exponent = monomial.exponent(&square);
        if exponent < Rational::from(2) || !exponent.is_integer() {
            sum.insert(monomial.clone(), *coefficient)?;
            continue;
        }
        let pairs = u32::try_from(exponent.numerator() / 2).unwrap_or(u32::MAX);
        let mut rest = monomial.without(&square);
        if exponent.numerator() % 2 == 1 {
            rest = rest.times(&Monomial::of(square.clone(), Rational::ONE))?;
        }
        let product = Polynomial::term(rest, *coefficient);
        sum = sum.plus(product.times(&one_less.raised(pairs, work)?, work)?)?;
    }
    Ok(sum)
}

/// The shortest form by sin² + cos² = 1, and products of two angles as one of their sum or difference
/// where that joins two terms.
pub(crate) fn with_angles_combined(
    polynomial: Polynomial,
    work: &mut Work,
) -> Result<Polynomial, SymbolicError> {
    let mut sum = polynomial;
    for angle in squared_angles(&sum) {
        for pair in [
            [Function::Sin, Function::Cos],
            [Function::Cos, Function::Sin],
        ] {
            let replaced = with_square_replaced(&sum, pair, &angle, work)?;
            if replaced.0.len() < sum.0.len() {
                sum = replaced;
            }
        }
    }
    while let Some(shorter) = with_two_terms_joined(&sum, work)? {
        sum = shorter;
    }
    Ok(sum)
}

/// cos a cos b ± sin a sin b and sin a cos b ± cos a sin b as one term, if there are such two.
fn with_two_terms_joined(
    polynomial: &Polynomial,
    work: &mut Work,
) -> Result<Option<Polynomial>, SymbolicError> {
    if polynomial.0.len() > MAX_TERMS_COMBINED {
        return Ok(None);
    }
    for (monomial, coefficient) in &polynomial.0 {
        for [first, second] in pairs_of_angles(monomial) {
            work.spend(1 + monomial.0.len())?;
            let partner =
                first
                    .conjugate()
                    .times_with(&second.conjugate(), monomial, [&first, &second])?;
            let Some(other) = polynomial.0.get(&partner).filter(|_| partner != *monomial) else {
                continue;
            };
            let Some(joined) = joined([&first, &second], *coefficient, *other, work)? else {
                continue;
            };
            let rest = without_both(monomial, [&first, &second])?;
            let mut sum = polynomial.clone();
            sum.0.remove(monomial);
            sum.0.remove(&partner);
            let term = Polynomial::term(rest, *coefficient).times(&joined, work)?;
            return Ok(Some(sum.plus(term)?));
        }
    }
    Ok(None)
}

/// A sine or cosine that is a factor of a term.
#[derive(Clone)]
struct TrigonometricFactor {
    is_sine: bool,
    angle: Inner,
}

impl TrigonometricFactor {
    fn atom(&self) -> Atom {
        let function = if self.is_sine {
            Function::Sin
        } else {
            Function::Cos
        };
        Atom::Call(function, vec![self.angle.clone()])
    }

    /// The cosine for a sine, and the other way round.
    fn conjugate(&self) -> Self {
        Self {
            is_sine: !self.is_sine,
            angle: self.angle.clone(),
        }
    }

    /// The term with these two factors in place of the old ones.
    fn times_with(
        &self,
        other: &Self,
        monomial: &Monomial,
        old: [&Self; 2],
    ) -> Result<Monomial, SymbolicError> {
        let rest = without_both(monomial, old)?;
        let new = Monomial::of(self.atom(), Rational::ONE);
        rest.times(&new.times(&Monomial::of(other.atom(), Rational::ONE))?)
    }
}

/// The term divided by two of its factors.
fn without_both(
    monomial: &Monomial,
    factors: [&TrigonometricFactor; 2],
) -> Result<Monomial, SymbolicError> {
    monomial
        .times(&Monomial::of(factors[0].atom(), -Rational::ONE))?
        .times(&Monomial::of(factors[1].atom(), -Rational::ONE))
}

/// All pairs of sines and cosines of different angles in a term.
fn pairs_of_angles(monomial: &Monomial) -> Vec<[TrigonometricFactor; 2]> {
    let factors: Vec<_> = monomial
        .0
        .iter()
        .filter(|(_, exponent)| exponent.is_integer() && !exponent.is_negative())
        .filter_map(|(atom, _)| match atom {
            Atom::Call(function @ (Function::Sin | Function::Cos), arguments) => {
                Some(TrigonometricFactor {
                    is_sine: *function == Function::Sin,
                    angle: arguments[0].clone(),
                })
            }
            _ => None,
        })
        // Six make fifteen pairs, each of which takes a look-up of its partner.
        .take(6)
        .collect();
    let mut pairs = Vec::new();
    for (at, first) in factors.iter().enumerate() {
        for second in &factors[at + 1..] {
            if first.angle != second.angle {
                pairs.push([first.clone(), second.clone()]);
            }
        }
    }
    pairs
}

/// `f(a) g(b)` and, with equal or opposite coefficient, its conjugate as one sine or cosine.
fn joined(
    [first, second]: [&TrigonometricFactor; 2],
    coefficient: Rational,
    other: Rational,
    work: &mut Work,
) -> Result<Option<Polynomial>, SymbolicError> {
    let same = match other {
        _ if other == coefficient => true,
        _ if other == -coefficient => false,
        _ => return Ok(None),
    };
    let (a, b) = ((*first.angle).clone(), (*second.angle).clone());
    Ok(Some(match (first.is_sine, second.is_sine) {
        // cos a cos b ± sin a sin b = cos(a ∓ b), and the same with the other sign in front.
        (false, false) => call(Function::Cos, a.plus(signed(b, !same))?, work)?,
        (true, true) => call(Function::Cos, a.plus(signed(b, !same))?, work)?
            .scaled(Rational::from(if same { 1 } else { -1 }))?,
        // sin a cos b ± cos a sin b = sin(a ± b).
        (true, false) => call(Function::Sin, a.plus(signed(b, same))?, work)?,
        (false, true) => call(Function::Sin, signed(a, same).plus(b)?, work)?,
    }))
}

fn signed(sum: Polynomial, is_positive: bool) -> Polynomial {
    if is_positive { sum } else { sum.negated() }
}

/// The sine and cosine of a sum of multiples of single angles, by the addition theorem.
fn sine_and_cosine(
    angle: &Polynomial,
    units: &BTreeMap<Monomial, Rational>,
    work: &mut Work,
) -> Result<(Polynomial, Polynomial), SymbolicError> {
    let (mut sine, mut cosine) = (Polynomial::default(), Polynomial::one());
    for (single, multiple) in &angle.0 {
        let unit = units.get(single).copied().unwrap_or(*multiple);
        let times = fits(multiple.checked_div(unit))?;
        let (unit, times) = if times.is_integer() && times.abs().numerator() <= MAX_MULTIPLE {
            (unit, times.numerator())
        } else {
            (*multiple, 1)
        };
        let part = Polynomial::term(single.clone(), unit);
        let s = call(Function::Sin, part.clone(), work)?;
        let c = call(Function::Cos, part, work)?;
        let s = if times < 0 { s.negated() } else { s };
        for _ in 0..times.abs() {
            let next = sine.times(&c, work)?.plus(cosine.times(&s, work)?)?;
            cosine = cosine
                .times(&c, work)?
                .plus(sine.times(&s, work)?.negated())?;
            sine = next;
        }
    }
    Ok((sine, cosine))
}
