//! Sums of products with exact coefficients.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::inner::Inner;
use super::{SymbolicError, Work, power};
use crate::expr::{Constant, Expr, Function, Kind, Name, Variable};
use crate::work;
use vibank_dynamics::numerics::{Rational, SortedSet};

/// What the normal form does not look into further.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Atom {
    /// `pi`, `e`, `i`.
    Constant(Constant),
    /// A name or a time derivative of it.
    Variable(Variable),
    /// A function of arguments in normal form.
    Call(Function, Vec<Inner>),
    /// A base that cannot be multiplied out: a sum in a denominator, or whatever stands under a root.
    /// Its exponent is negative or not whole.
    Base(Inner),
    /// A power whose exponent is not a number: the base and the exponent.
    Power(Inner, Inner),
    /// Anything else, compared by how it is written.
    Opaque(Opaque),
}

impl Atom {
    /// Whether one of these names stands in it.
    pub(crate) fn mentions(&self, names: &SortedSet<Name>) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::Variable(variable) => names.contains(&variable.name),
            Self::Call(_, arguments) => arguments.iter().any(|sum| sum.mentions(names)),
            Self::Base(sum) => sum.mentions(names),
            Self::Power(base, exponent) => base.mentions(names) || exponent.mentions(names),
            Self::Opaque(opaque) => {
                let mut found = false;
                opaque.expr.walk(&mut |node| {
                    found |= matches!(node.kind(), Kind::Name(name) if names.contains(name));
                });
                found
            }
        }
    }

    /// Whether this variable stands in it, with just this order of derivative where that can be told.
    pub(crate) fn contains(&self, variable: &Variable) -> bool {
        let inside = |sum: &Polynomial| {
            let mut monomials = sum.0.keys();
            monomials.any(|monomial| monomial.0.iter().any(|(atom, _)| atom.contains(variable)))
        };
        match self {
            Self::Constant(_) => false,
            Self::Variable(own) => own == variable,
            Self::Call(_, arguments) => arguments.iter().any(|sum| inside(sum)),
            Self::Base(sum) => inside(sum),
            Self::Power(base, exponent) => inside(base) || inside(exponent),
            Self::Opaque(_) => self.mentions(&SortedSet::from([variable.name.clone()])),
        }
    }

    /// Whether such a variable stands in it; of what is kept as it is written, whether its name does.
    pub(crate) fn any_variable(&self, is_wanted: &dyn Fn(&Variable) -> bool) -> bool {
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

    /// How many atoms stand in each other, this one included.
    pub(crate) fn depth(&self) -> u32 {
        let inner = match self {
            Self::Constant(_) | Self::Variable(_) | Self::Opaque(_) => 0,
            Self::Call(_, arguments) => arguments.iter().map(Inner::depth).max().unwrap_or(0),
            Self::Base(base) => base.depth(),
            Self::Power(base, exponent) => base.depth().max(exponent.depth()),
        };
        inner.saturating_add(1)
    }
}

/// A formula that is kept as it stands.
#[derive(Clone, Debug)]
pub(crate) struct Opaque {
    pub(crate) expr: Expr,
    text: String,
}

impl Opaque {
    pub(crate) fn of(expr: &Expr) -> Self {
        Self {
            expr: expr.clone(),
            text: expr.to_string(),
        }
    }
}

impl PartialEq for Opaque {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Eq for Opaque {}

impl PartialOrd for Opaque {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Opaque {
    fn cmp(&self, other: &Self) -> Ordering {
        self.text.cmp(&other.text)
    }
}

/// A product of powers of atoms, in the order of the atoms, without zero exponents.
///
/// The order is lexicographic in the exponents and so is kept by multiplication, as division needs it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Monomial(pub(crate) Vec<(Atom, Rational)>);

impl Monomial {
    pub(crate) fn of(atom: Atom, exponent: Rational) -> Self {
        Self(vec![(atom, exponent)])
    }

    pub(crate) fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    /// What comparing its atoms may take: each may be looked into down to its end.
    fn depths(&self) -> u64 {
        self.0.iter().map(|(atom, _)| u64::from(atom.depth())).sum()
    }

    /// The exponent of an atom, 0 where it does not stand.
    pub(crate) fn exponent(&self, atom: &Atom) -> Rational {
        self.0
            .binary_search_by(|(own, _)| own.cmp(atom))
            .map_or(Rational::ZERO, |at| self.0[at].1)
    }

    /// The product, before any power is multiplied out.
    pub(crate) fn times(&self, other: &Self) -> Result<Self, SymbolicError> {
        let mut product = Vec::with_capacity(self.0.len() + other.0.len());
        let (mut left, mut right) = (self.0.iter().peekable(), other.0.iter().peekable());
        while let (Some(a), Some(b)) = (left.peek(), right.peek()) {
            match a.0.cmp(&b.0) {
                Ordering::Less => product.extend(left.next().cloned()),
                Ordering::Greater => product.extend(right.next().cloned()),
                Ordering::Equal => {
                    let exponent = fits(a.1.checked_add(b.1))?;
                    if !exponent.is_zero() {
                        product.push((a.0.clone(), exponent));
                    }
                    left.next();
                    right.next();
                }
            }
        }
        product.extend(left.cloned());
        product.extend(right.cloned());
        Ok(Self(product))
    }

    /// The power with a whole exponent.
    pub(crate) fn power(&self, exponent: Rational) -> Result<Self, SymbolicError> {
        let factors = self
            .0
            .iter()
            .map(|(atom, own)| Ok((atom.clone(), fits(own.checked_mul(exponent))?)))
            .collect::<Result<_, SymbolicError>>()?;
        Ok(Self(factors))
    }

    /// The reciprocal.
    pub(crate) fn inverse(&self) -> Self {
        let factors = self.0.iter();
        Self(factors.map(|(atom, own)| (atom.clone(), -*own)).collect())
    }

    /// The same without one atom.
    pub(crate) fn without(&self, atom: &Atom) -> Self {
        let factors = self.0.iter();
        Self(factors.filter(|(own, _)| own != atom).cloned().collect())
    }

    /// What both have in common: each atom with the smaller exponent.
    pub(crate) fn common(&self, other: &Self) -> Self {
        let mut factors = Vec::new();
        for (atom, own) in &self.0 {
            let least = (*own).min(other.exponent(atom));
            if !least.is_zero() {
                factors.push((atom.clone(), least));
            }
        }
        // What stands below in the other term alone has the exponent 0 here, and the smaller one is the
        // negative.
        for (atom, theirs) in &other.0 {
            if theirs.is_negative() && self.exponent(atom).is_zero() {
                factors.push((atom.clone(), *theirs));
            }
        }
        vibank_dynamics::numerics::sort_by(&mut factors, |a, b| a.0.cmp(&b.0));
        Self(factors)
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        let (mut left, mut right) = (self.0.iter(), other.0.iter());
        loop {
            match (left.next(), right.next()) {
                (None, None) => return Ordering::Equal,
                (Some(a), None) => return a.1.cmp(&Rational::ZERO),
                (None, Some(b)) => return Rational::ZERO.cmp(&b.1),
                (Some(a), Some(b)) => match a.0.cmp(&b.0) {
                    Ordering::Less => return a.1.cmp(&Rational::ZERO),
                    Ordering::Greater => return Rational::ZERO.cmp(&b.1),
                    Ordering::Equal if a.1 != b.1 => return a.1.cmp(&b.1),
                    Ordering::Equal => {}
                },
            }
        }
    }
}

/// A sum of monomials with exact coefficients, none of them zero.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Polynomial(pub(crate) BTreeMap<Monomial, Rational>);

impl Polynomial {
    pub(crate) fn number(value: Rational) -> Self {
        Self::term(Monomial::default(), value)
    }

    pub(crate) fn one() -> Self {
        Self::number(Rational::ONE)
    }

    pub(crate) fn atom(atom: Atom) -> Self {
        Self::term(Monomial::of(atom, Rational::ONE), Rational::ONE)
    }

    pub(crate) fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let mut sum = Self::default();
        if !coefficient.is_zero() {
            sum.0.insert(monomial, coefficient);
        }
        sum
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Its value if it is a number.
    pub(crate) fn as_number(&self) -> Option<Rational> {
        match self.0.len() {
            0 => Some(Rational::ZERO),
            _ => self
                .as_term()
                .filter(|term| term.0.is_one())
                .map(|term| term.1),
        }
    }

    /// Its only term, if it has one.
    pub(crate) fn as_term(&self) -> Option<(&Monomial, Rational)> {
        let mut terms = self.0.iter();
        let (monomial, coefficient) = terms.next()?;
        terms.next().is_none().then_some((monomial, *coefficient))
    }

    /// Its greatest term in the order of monomials.
    pub(crate) fn leading(&self) -> Option<(&Monomial, Rational)> {
        let (monomial, coefficient) = self.0.last_key_value()?;
        Some((monomial, *coefficient))
    }

    /// Adds one term.
    pub(crate) fn insert(
        &mut self,
        monomial: Monomial,
        coefficient: Rational,
    ) -> Result<(), SymbolicError> {
        match self.0.entry(monomial) {
            Entry::Vacant(free) if !coefficient.is_zero() => {
                free.insert(coefficient);
            }
            Entry::Vacant(_) => {}
            Entry::Occupied(mut taken) => {
                let sum = fits(taken.get().checked_add(coefficient))?;
                if sum.is_zero() {
                    taken.remove();
                } else {
                    taken.insert(sum);
                }
            }
        }
        Ok(())
    }

    pub(crate) fn plus(mut self, other: Self) -> Result<Self, SymbolicError> {
        if self.is_zero() {
            return Ok(other);
        }
        for (monomial, coefficient) in other.0 {
            self.insert(monomial, coefficient)?;
        }
        Ok(self)
    }

    pub(crate) fn negated(mut self) -> Self {
        for own in self.0.values_mut() {
            *own = -*own;
        }
        self
    }

    pub(crate) fn scaled(mut self, factor: Rational) -> Result<Self, SymbolicError> {
        if factor.is_zero() {
            return Ok(Self::default());
        }
        for own in self.0.values_mut() {
            *own = fits(own.checked_mul(factor))?;
        }
        Ok(self)
    }

    pub(crate) fn times(&self, other: &Self, work: &mut Work) -> Result<Self, SymbolicError> {
        let mut product = Self::default();
        for (left, a) in &self.0 {
            for (right, b) in &other.0 {
                work.spend(1 + left.0.len() + right.0.len())?;
                work::spend(left.depths() + right.depths())?;
                let coefficient = fits(a.checked_mul(*b))?;
                settle(left.times(right)?, coefficient, &mut product, work)?;
            }
        }
        Ok(product)
    }

    /// The power with an exact exponent.
    pub(crate) fn power(&self, exponent: Rational, work: &mut Work) -> Result<Self, SymbolicError> {
        power::of(self, exponent, work)
    }

    /// The power with a whole exponent that is not negative.
    pub(crate) fn raised(&self, exponent: u32, work: &mut Work) -> Result<Self, SymbolicError> {
        // One factor after the other: squaring would multiply two long sums, which takes more products of
        // terms.
        let mut power = Self::one();
        for _ in 0..exponent {
            power = power.times(self, work)?;
        }
        Ok(power)
    }

    /// The exact quotient, or nothing where the division leaves a rest.
    pub(crate) fn divided_by(
        &self,
        divisor: &Self,
        work: &mut Work,
    ) -> Result<Option<Self>, SymbolicError> {
        let Some((lead, scale)) = divisor.leading() else {
            return Ok(None);
        };
        let (lead, mut rest, mut quotient) = (lead.inverse(), self.clone(), Self::default());
        // An exact quotient has at most as many terms as its products allow; what needs more has a rest.
        for _ in 0..self.0.len() * 2 + 8 {
            let Some((monomial, coefficient)) = rest.leading() else {
                return Ok(Some(quotient));
            };
            let factor = fits(coefficient.checked_div(scale))?;
            let monomial = monomial.times(&lead)?;
            let step = Self::term(monomial.clone(), factor);
            quotient.insert(monomial, factor)?;
            rest = rest.plus(step.times(divisor, work)?.negated())?;
        }
        Ok(None)
    }

    pub(crate) fn mentions(&self, names: &SortedSet<Name>) -> bool {
        let mut monomials = self.0.keys();
        monomials.any(|monomial| monomial.0.iter().any(|(atom, _)| atom.mentions(names)))
    }
}

/// The number, or the error for one that does not fit.
pub(crate) fn fits(value: Option<Rational>) -> Result<Rational, SymbolicError> {
    value.ok_or(SymbolicError::TooLarge)
}

/// A product that may hold powers that can be multiplied out by now.
pub(crate) fn settled(monomial: Monomial, work: &mut Work) -> Result<Polynomial, SymbolicError> {
    let mut sum = Polynomial::default();
    settle(monomial, Rational::ONE, &mut sum, work)?;
    Ok(sum)
}

/// Adds a term whose product may hold powers that can be multiplied out by now.
pub(crate) fn settle(
    mut monomial: Monomial,
    mut coefficient: Rational,
    sum: &mut Polynomial,
    work: &mut Work,
) -> Result<(), SymbolicError> {
    if monomial.0.iter().all(is_settled) {
        return sum.insert(monomial, coefficient);
    }
    let mut factors: Vec<(Inner, u32)> = Vec::new();
    let mut kept = Vec::with_capacity(monomial.0.len());
    for (atom, exponent) in monomial.0.drain(..) {
        match &atom {
            Atom::Constant(Constant::ImaginaryUnit) if exponent.is_integer() => {
                let turns = exponent.numerator().rem_euclid(4);
                if turns >= 2 {
                    coefficient = -coefficient;
                }
                if turns % 2 == 1 {
                    kept.push((atom, Rational::ONE));
                }
            }
            Atom::Base(base) => {
                // A root times itself may be a sum again, `√(a + b)²`, which then has to be multiplied out.
                let whole = whole_part(base, exponent);
                if let Some(number) = base.as_number() {
                    let power = i32::try_from(whole)
                        .ok()
                        .and_then(|n| number.checked_pow(n));
                    coefficient = fits(power.and_then(|power| coefficient.checked_mul(power)))?;
                } else if whole > 0 {
                    let whole = u32::try_from(whole).map_err(|_| SymbolicError::TooLarge)?;
                    factors.push((base.clone(), whole));
                }
                let rest = Rational::new(whole, 1).and_then(|whole| exponent.checked_sub(whole));
                let rest = fits(rest)?;
                if !rest.is_zero() {
                    kept.push((atom, rest));
                }
            }
            _ => kept.push((atom, exponent)),
        }
    }
    let kept = Monomial(kept);
    if factors.is_empty() {
        return sum.insert(kept, coefficient);
    }
    let mut product = Polynomial::term(kept, coefficient);
    for (base, exponent) in factors {
        product = product.times(&base.raised(exponent, work)?, work)?;
    }
    for (monomial, coefficient) in product.0 {
        sum.insert(monomial, coefficient)?;
    }
    Ok(())
}

/// Whether a factor of a term is neither a sum nor the imaginary unit.
fn is_settled((atom, _): &(Atom, Rational)) -> bool {
    !matches!(
        atom,
        Atom::Base(_) | Atom::Constant(Constant::ImaginaryUnit)
    )
}

/// The part of an exponent that is multiplied out: all whole powers of a number, so that its root
/// has an exponent between 0 and 1; positive ones of a sum; whole ones of a product.
fn whole_part(base: &Polynomial, exponent: Rational) -> i128 {
    let floor = exponent.numerator().div_euclid(exponent.denominator());
    if base.as_number().is_some() {
        return floor;
    }
    floor.max(0)
}
