//! Formulas modulo two primes.
//!
//! A rational function of the data takes a random value modulo a large prime where the data do, and two
//! different ones agree there with a probability of their degree over the prime (Schwartz 1980, Zippel 1979).
//! Nothing is rounded: rational formulas, of whatever size and however ill-conditioned, are told apart. They may
//! still be different where they agree, since a number that both primes divide vanishes: points have the last word.
//! π is a variable like any other, as it satisfies no rational equation.
//!
//! Roots and transcendental functions stand for fresh variables, the same for the same argument (Gonnet 1984).
//! Formulas that agree then are equal; those that do not may be equal all the same.

use super::draw::mixed;
use crate::answer::meaning::Meaning;
use crate::expr::{Binder, Binding, Constant, Expr, Kind, Name, Operator, Variable, fold};
use crate::numerics::{Rational, SortedMap};
use crate::unit::{Decimal, Quantity, Unit};

/// Points, each with a prime of its own.
const TRIALS: usize = 2;
/// By how much the primes are less than 2^61.
const BELOW: [u64; TRIALS] = [1, 31];
// So near to a power of two that reduction is a shift and a sum, and so small that the sum of two residues
// fits into 64 bits.
const PRIMES: [u64; TRIALS] = [(1 << 61) - BELOW[0], (1 << 61) - BELOW[1]];
/// Most nodes that are visited, substituted names included.
const MAX_NODES: usize = 4_000;
/// Deepest formula, substituted names included.
const MAX_DEPTH: usize = 300;
/// Largest exponent.
const MAX_POWER: i128 = 10_000;

/// The values of a formula at the points.
type Values = [u64; TRIALS];

/// A formula modulo the primes at fixed points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Residue {
    values: Values,
    /// Whether it is a rational function, so that another value is another function.
    is_rational: bool,
}

impl Residue {
    /// That of a formula, if it has one.
    pub(crate) fn of(
        meaning: &Meaning,
        expr: &Expr,
        replaced: &SortedMap<Name, Expr>,
    ) -> Option<Self> {
        let mut reader = Reader {
            meaning,
            replaced,
            is_rational: true,
            nodes: 0,
        };
        let values = reader.values(expr, 0)?;
        Some(Self {
            values,
            is_rational: reader.is_rational,
        })
    }

    /// Whether two formulas are the same, where that can be decided.
    pub(crate) fn same(self, other: Self) -> Option<bool> {
        if self.is_rational && other.is_rational {
            return Some(self.values == other.values);
        }
        (self.values == other.values).then_some(true)
    }

    /// Whether both are rational, so that the verdict is certain.
    pub(crate) fn is_rational(self) -> bool {
        self.is_rational
    }
}

struct Reader<'a> {
    meaning: &'a Meaning,
    replaced: &'a SortedMap<Name, Expr>,
    is_rational: bool,
    nodes: usize,
}

impl Reader<'_> {
    fn values(&mut self, expr: &Expr, depth: usize) -> Option<Values> {
        self.nodes += 1;
        if self.nodes > MAX_NODES || depth > MAX_DEPTH {
            return None;
        }
        let next = depth + 1;
        match expr.kind() {
            Kind::Number(value) => number(*value),
            Kind::Measure(value, unit) if is_coherent(unit) => number(*value),
            Kind::Constant(Constant::Pi) => Some(fresh("pi", &[])),
            Kind::Name(name) => self.named(&Variable::of(name, 0), next),
            Kind::Prime(inner, order) => match inner.kind() {
                Kind::Name(name) => self.named(&Variable::of(name, *order), next),
                _ => None,
            },
            Kind::Negate(inner) => Some(negated(self.values(inner, next)?)),
            Kind::Binary(Operator::Power, base, exponent) => self.power(base, exponent, next),
            Kind::Binary(operator, a, b) => {
                let (a, b) = (self.values(a, next)?, self.values(b, next)?);
                match operator {
                    Operator::Add => Some(each(a, b, add)),
                    Operator::Subtract => Some(each(a, negated(b), add)),
                    Operator::Multiply => Some(each(a, b, times)),
                    Operator::Divide => Some(each(a, inverse(b)?, times)),
                    Operator::Power => None,
                }
            }
            Kind::Call(function, arguments) => {
                let arguments = arguments.iter().map(|argument| self.values(argument, next));
                let arguments = arguments.collect::<Option<Vec<_>>>()?;
                self.is_rational = false;
                Some(fresh(function.name(), &arguments))
            }
            _ => None,
        }
    }

    fn named(&mut self, variable: &Variable, depth: usize) -> Option<Values> {
        match self.meaning.bound(self.replaced).name(variable, &[])? {
            Binding::Input { slot, .. } => Some(fresh("slot", &[[u64::from(slot); TRIALS]])),
            Binding::Formula(formula) => self.values(&formula, depth),
            Binding::Motion(_) => None,
        }
    }

    fn power(&mut self, base: &Expr, exponent: &Expr, depth: usize) -> Option<Values> {
        if let Some(exponent) = fold(exponent) {
            let (above, below) = (exponent.numerator(), exponent.denominator());
            if above.abs() > MAX_POWER {
                return None;
            }
            let base = self.values(base, depth)?;
            let root = match below {
                1 => base,
                2 => self.irrational("sqrt", &[base]),
                // The root as a letter of its own: `x^(2/3)` is its square, so that powers of one root still
                // meet.
                _ => self.irrational("root", &[base, whole(below)]),
            };
            return raised(root, above);
        }
        let exponent = self.values(exponent, depth)?;
        if *base.kind() == Kind::Constant(Constant::E) {
            return Some(self.irrational("exp", &[exponent]));
        }
        let base = self.values(base, depth)?;
        Some(self.irrational("power", &[base, exponent]))
    }

    fn irrational(&mut self, function: &str, arguments: &[Values]) -> Values {
        self.is_rational = false;
        fresh(function, arguments)
    }
}

/// Whether a unit has the factor one.
fn is_coherent(unit: &Unit) -> bool {
    Quantity::new(Decimal::from(1_u32), *unit).si_pair() == (1.0, 0.0)
}

/// A number modulo the primes.
fn number(value: Rational) -> Option<Values> {
    let below = inverse(whole(value.denominator()))?;
    Some(each(whole(value.numerator()), below, times))
}

fn whole(value: i128) -> Values {
    PRIMES.map(|prime| value.rem_euclid(i128::from(prime)) as u64)
}

/// A random number for each trial that follows from a word and numbers.
fn fresh(word: &str, of: &[Values]) -> Values {
    let mut values = [0; TRIALS];
    for (trial, value) in values.iter_mut().enumerate() {
        let mut bits = mixed(0x9e37_79b9_7f4a_7c15 ^ trial as u64);
        for byte in word.bytes() {
            bits = mixed(bits ^ u64::from(byte));
        }
        for argument in of {
            bits = mixed(bits.wrapping_add(1) ^ argument[trial]);
        }
        *value = bits % PRIMES[trial];
    }
    values
}

fn each(a: Values, b: Values, of: fn(u64, u64, usize) -> u64) -> Values {
    std::array::from_fn(|trial| of(a[trial], b[trial], trial))
}

fn add(a: u64, b: u64, trial: usize) -> u64 {
    let sum = a + b;
    if sum >= PRIMES[trial] {
        sum - PRIMES[trial]
    } else {
        sum
    }
}

fn negated(a: Values) -> Values {
    each([0; TRIALS], a, |_, value, trial| {
        if value == 0 { 0 } else { PRIMES[trial] - value }
    })
}

/// The product; 2^61 is as much as the prime is below it.
fn times(a: u64, b: u64, trial: usize) -> u64 {
    // The low 61 bits. The first fold brings 122 bits to 66, the second one to less than twice the prime.
    const LOW: u128 = (1 << 61) - 1;
    let folded = |value: u128| (value & LOW) + (value >> 61) * u128::from(BELOW[trial]);
    let product = folded(folded(u128::from(a) * u128::from(b))) as u64;
    if product >= PRIMES[trial] {
        product - PRIMES[trial]
    } else {
        product
    }
}

/// One over each; `None` for zero.
fn inverse(a: Values) -> Option<Values> {
    let is_zero = a.contains(&0);
    (!is_zero).then(|| {
        each(a, PRIMES, |value, prime, trial| {
            power(value, prime - 2, trial)
        })
    })
}

fn raised(a: Values, exponent: i128) -> Option<Values> {
    let base = if exponent < 0 { inverse(a)? } else { a };
    let exponent = exponent.unsigned_abs() as u64;
    Some(each(base, [exponent; TRIALS], power))
}

fn power(mut base: u64, mut exponent: u64, trial: usize) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = times(result, base, trial);
        }
        base = times(base, base, trial);
        exponent >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_is_that_of_a_field() {
        let a = [123_456_789, PRIMES[1] - 1];
        assert_eq!(each(a, inverse(a).expect("not zero"), times), [1, 1]);
        assert_eq!(each(a, negated(a), add), [0, 0]);
        assert_eq!(raised(a, 3), Some(each(each(a, a, times), a, times)));
        assert_eq!(raised(a, 0), Some([1, 1]));
        assert_eq!(inverse([1, 0]), None);
        for trial in 0..TRIALS {
            let last = PRIMES[trial] - 1;
            assert_eq!(times(last, last, trial), 1);
            assert_eq!(power(3, last, trial), 1, "Fermat");
        }
    }

    #[test]
    fn fractions_are_exact() {
        let of = |above, below| number(Rational::new(above, below).expect("a fraction"));
        let third = of(1, 3).expect("a number");
        assert_eq!(each(third, [3; TRIALS], times), [1; TRIALS]);
        assert_eq!(of(-2, 4), of(1, -2));
        assert_ne!(of(1, 3), of(333_333, 1_000_000));
    }

    #[test]
    fn no_prime_alone_makes_a_number_vanish() {
        for prime in PRIMES {
            assert_ne!(whole(i128::from(prime)), [0; TRIALS]);
        }
    }
}
