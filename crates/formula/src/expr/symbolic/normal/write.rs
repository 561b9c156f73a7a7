//! Sums of products written back as formulas, in the order of a textbook.

use std::cell::RefCell;
use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::inner::Inner;
use super::power::primitive;
use super::term::{Atom, Monomial, Polynomial};
use crate::expr::{Expr, Function, Kind, Name, Operator};
use vibank_dynamics::numerics::{Rational, SortedMap, SortedSet};

/// In which order a normal form is written.
///
/// Terms are collected by what moves (coordinates, their derivatives and `t`): the highest derivative
/// first, then velocities, coordinates, functions of time, constants; coordinates in their own order.
/// In a product, numbers come first, then names by rank, functions, and what moves last.
#[derive(Clone, Debug, Default)]
pub struct Order {
    moving: Vec<Name>,
    ranks: SortedMap<Name, usize>,
    is_descending: bool,
}

impl Order {
    /// All names alike, in the order of their letters.
    pub fn new() -> Self {
        Self::default()
    }

    /// These names are coordinates, in this order.
    #[must_use]
    pub fn moving(mut self, names: impl IntoIterator<Item = Name>) -> Self {
        self.moving = names.into_iter().collect();
        self
    }

    /// In products, these names come in this order, before all others.
    #[must_use]
    pub fn ranked(mut self, names: impl IntoIterator<Item = Name>) -> Self {
        self.ranks = names.into_iter().zip(0..).collect();
        self
    }

    /// Higher powers of a coordinate come before lower ones, as in energies and characteristic equations;
    /// without it, linear terms come before nonlinear ones, as in equations of motion.
    #[must_use]
    pub fn descending(mut self) -> Self {
        self.is_descending = true;
        self
    }

    fn moving_index(&self, name: &Name) -> Option<usize> {
        self.moving.iter().position(|own| own == name)
    }

    fn moving_names(&self) -> SortedSet<Name> {
        let time = Name::new("t");
        self.moving.iter().cloned().chain([time]).collect()
    }
}

/// Writes sums in one order, each that stands in others once.
///
/// A sum within a function is looked at several times (for its sign, for its place), and so would be written a number
/// of times that doubles with each function around it.
struct NormalWriter<'o> {
    order: &'o Order,
    /// By where they stand in memory: what is written outlives the writer.
    written: RefCell<SortedMap<*const Polynomial, Expr>>,
}

impl<'o> NormalWriter<'o> {
    fn of(order: &'o Order) -> Self {
        Self {
            order,
            written: RefCell::default(),
        }
    }

    /// A sum that stands in others.
    fn inner(&self, own: &Inner) -> Expr {
        let place = own.address();
        let known = self.written.borrow().get(&place).cloned();
        known.unwrap_or_else(|| {
            let written = collected_sum(own, self);
            self.written.borrow_mut().insert(place, written.clone());
            written
        })
    }
}

/// Where a factor stands in a product.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum FactorPlace {
    Measure,
    Root,
    Constant,
    Name(usize, Name),
    Other,
    Position(usize, u8),
    Function,
    Acceleration(usize, u8),
}

/// How a term ranks among the others: by the highest derivative in it, the coordinate that bears it,
/// whether that stands alone, and the powers in it.
type Rank = (Reverse<Option<u8>>, usize, bool, Reverse<Monomial>);

/// The sum, collected by what moves.
pub(crate) fn sum(sum: &Polynomial, order: &Order) -> Expr {
    collected_sum(sum, &NormalWriter::of(order))
}

/// A sum inside a function or denominator; it does not begin with a sign if it can be helped.
pub(crate) fn bracket(own: &Polynomial, order: &Order) -> Expr {
    let writer = NormalWriter::of(order);
    unsigned(own, collected_sum(own, &writer), &writer)
}

fn collected_sum(sum: &Polynomial, writer: &NormalWriter<'_>) -> Expr {
    let order = writer.order;
    let moving = order.moving_names();
    let mut groups: BTreeMap<Monomial, Polynomial> = BTreeMap::new();
    for (monomial, coefficient) in &sum.0 {
        let (part, rest): (Vec<_>, Vec<_>) = monomial
            .0
            .iter()
            .cloned()
            .partition(|(atom, _)| atom.mentions(&moving));
        let group = groups.entry(Monomial(part)).or_default();
        group.0.insert(Monomial(rest), *coefficient);
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    vibank_dynamics::numerics::sort_by_key(&mut groups, |(part, _)| rank(part, order));
    let constants = groups
        .iter()
        .position(|(part, _)| part.is_one())
        .map(|at| groups.remove(at));
    let moving_terms = groups
        .iter()
        .map(|(part, group)| collected(group, part, writer));
    let constant_terms = constants
        .iter()
        .flat_map(|(_, group)| separate_terms(group, writer));
    sum_of_signed_terms(moving_terms.chain(constant_terms))
}

/// The terms joined by their signs; each comes with whether it is subtracted.
pub fn sum_of_signed_terms(terms: impl IntoIterator<Item = (bool, Expr)>) -> Expr {
    let mut sum: Option<Expr> = None;
    for (is_negative, term) in terms {
        sum = Some(match (sum, is_negative) {
            (None, false) => term,
            (None, true) => negated_product(&term),
            (Some(sum), false) => binary(Operator::Add, sum, term),
            (Some(sum), true) => binary(Operator::Subtract, sum, term),
        });
    }
    sum.unwrap_or_else(|| Expr::number(0))
}

/// A sign in front binds to the first factor of a product, as it does when it is read.
fn negated_product(expr: &Expr) -> Expr {
    match expr.kind() {
        Kind::Binary(operator @ (Operator::Multiply | Operator::Divide), first, rest) => {
            binary(*operator, negated_product(first), rest.clone())
        }
        _ => Expr::derived(Kind::Negate(expr.clone())),
    }
}

fn binary(operator: Operator, left: Expr, right: Expr) -> Expr {
    Expr::derived(Kind::Binary(operator, left, right))
}

/// The rank of a term by the part of it that moves.
fn rank(part: &Monomial, order: &Order) -> Rank {
    let heights = part.0.iter().filter_map(|(atom, _)| {
        if let Atom::Variable(variable) = atom {
            let index = order.moving_index(&variable.name)?;
            return Some((Reverse(Some(variable.order)), index));
        }
        let index = order
            .moving
            .iter()
            .position(|name| atom.mentions(&SortedSet::from([name.clone()])))?;
        Some((Reverse(Some(0)), index))
    });
    let highest = heights.min();
    let (height, index) = highest.unwrap_or((Reverse(None), usize::MAX));
    let is_alone =
        matches!(part.0.as_slice(), [(Atom::Variable(_), exponent)] if *exponent == Rational::ONE);
    (
        height,
        index,
        !is_alone && !order.is_descending,
        Reverse(part.clone()),
    )
}

/// A group of terms with the same moving part, as one product.
fn collected(group: &Polynomial, part: &Monomial, writer: &NormalWriter<'_>) -> (bool, Expr) {
    let order = writer.order;
    if let Some((monomial, coefficient)) = group.as_term() {
        let all = monomial.times(part).unwrap_or_else(|_| monomial.clone());
        return (
            coefficient.is_negative(),
            product(coefficient.abs(), &all, None, writer),
        );
    }
    let (content, below, mut rest) = parted(group);
    let mut is_negative = content.is_negative();
    let first = sorted_terms(&rest, order).first().map(|term| term.1);
    if first.is_some_and(Rational::is_negative) {
        rest = rest.negated();
        is_negative = !is_negative;
    }
    let first = sorted_terms(&rest, order)
        .first()
        .map(|(monomial, _)| sorted_factors(monomial, order));
    let place = first.and_then(|factors| factors.into_iter().next());
    let sum = BracketedSum {
        place: place.map_or(FactorPlace::Root, |(place, ..)| place),
        sum: sum_of_signed_terms(separate_terms(&rest, writer)),
    };
    let all = below.times(part).unwrap_or_else(|_| below.clone());
    (is_negative, product(content.abs(), &all, Some(sum), writer))
}

/// A coefficient of several terms as number, common denominator and sum in brackets.
fn parted(group: &Polynomial) -> (Rational, Monomial, Polynomial) {
    let whole = || (Rational::ONE, Monomial::default(), group.clone());
    let Ok((content, common, _)) = primitive(group) else {
        return whole();
    };
    // A number before a bracket has to leave bare names in it, or be whole: `2*x/3 + y/2` is read more easily
    // than `(4*x + 3*y)/6`.
    let is_worth_it = group.0.values().all(|own| own.abs() == content.abs())
        || content.is_integer() && content.abs() != Rational::ONE;
    let content = if is_worth_it {
        content.abs()
    } else {
        Rational::ONE
    };
    let is_below = |(atom, exponent): &(Atom, Rational)| {
        matches!(atom, Atom::Base(_)) && exponent.is_negative()
    };
    let below = if leaves_single_names(group, &common) {
        common
    } else {
        Monomial(common.0.into_iter().filter(is_below).collect())
    };
    let (up, divisor) = (below.inverse(), Rational::ONE.checked_div(content));
    let mut rest = Polynomial::default();
    for (monomial, own) in &group.0 {
        let coefficient = divisor.and_then(|divisor| own.checked_mul(divisor));
        let (Some(coefficient), Ok(monomial)) = (coefficient, monomial.times(&up)) else {
            return whole();
        };
        rest.0.insert(monomial, coefficient);
    }
    (content, below, rest)
}

/// Whether dividing by what all terms have in common leaves a sum of single names, as in `(m1 + m2)*g`.
fn leaves_single_names(group: &Polynomial, common: &Monomial) -> bool {
    let up = common.inverse();
    !common.is_one()
        && group.0.keys().all(|monomial| {
            let rest = monomial.times(&up);
            rest.is_ok_and(|rest| match rest.0.as_slice() {
                [] => true,
                [(Atom::Variable(_), exponent)] => *exponent == Rational::ONE,
                _ => false,
            })
        })
}

/// Each term with its sign, positive ones first.
fn separate_terms(sum: &Polynomial, writer: &NormalWriter<'_>) -> Vec<(bool, Expr)> {
    sorted_terms(sum, writer.order)
        .into_iter()
        .map(|(monomial, coefficient)| {
            let term = product(coefficient.abs(), monomial, None, writer);
            (coefficient.is_negative(), term)
        })
        .collect()
}

fn sorted_terms<'a>(sum: &'a Polynomial, order: &Order) -> Vec<(&'a Monomial, Rational)> {
    let keyed = sum.0.iter().map(|(monomial, own)| {
        let factors = sorted_factors(monomial, order);
        let places: Vec<_> = factors.into_iter().map(|(place, ..)| place).collect();
        ((own.is_negative(), places), (monomial, *own))
    });
    let mut terms: Vec<_> = keyed.collect();
    vibank_dynamics::numerics::sort_by(&mut terms, |a, b| a.0.cmp(&b.0));
    terms.into_iter().map(|(_, term)| term).collect()
}

fn sorted_factors(monomial: &Monomial, order: &Order) -> Vec<(FactorPlace, Atom, Rational)> {
    let mut factors: Vec<_> = monomial
        .0
        .iter()
        .map(|(atom, exponent)| (place(atom, order), atom.clone(), *exponent))
        .collect();
    vibank_dynamics::numerics::sort_by(&mut factors, Ord::cmp);
    factors
}

fn place(atom: &Atom, order: &Order) -> FactorPlace {
    match atom {
        Atom::Opaque(opaque) if matches!(opaque.expr.kind(), Kind::Measure(..)) => {
            FactorPlace::Measure
        }
        Atom::Constant(_) => FactorPlace::Constant,
        Atom::Variable(variable) => match order.moving_index(&variable.name) {
            Some(index) if variable.order >= 2 => FactorPlace::Acceleration(index, variable.order),
            Some(index) => FactorPlace::Position(index, variable.order),
            None => {
                let rank = order.ranks.get(&variable.name).copied();
                FactorPlace::Name(rank.unwrap_or(usize::MAX), variable.name.clone())
            }
        },
        Atom::Base(base) if base.as_number().is_some() => FactorPlace::Root,
        _ if atom.mentions(&order.moving_names()) => FactorPlace::Function,
        _ => FactorPlace::Other,
    }
}

/// A sum within a product, and where it stands in it: where its first name would.
struct BracketedSum {
    place: FactorPlace,
    sum: Expr,
}

/// A number, the powers of a monomial and perhaps a sum in brackets, as one product or fraction.
fn product(
    number: Rational,
    monomial: &Monomial,
    bracket: Option<BracketedSum>,
    writer: &NormalWriter<'_>,
) -> Expr {
    let order = writer.order;
    let (mut above, mut below) = (Vec::new(), Vec::new());
    let (mut number, mut bracket) = (number, bracket);
    for (place, atom, exponent) in sorted_factors(monomial, order) {
        if let Some(measure) = measure(number, &atom, exponent) {
            number = Rational::ONE;
            above.push(measure);
            continue;
        }
        if bracket.as_ref().is_some_and(|own| own.place <= place) {
            above.extend(bracket.take().map(|own| own.sum));
        }
        let side = if exponent.is_negative() {
            &mut below
        } else {
            &mut above
        };
        side.push(power(&atom, exponent.abs(), writer));
    }
    above.extend(bracket.map(|own| own.sum));
    if below.is_empty() {
        let fraction = (number != Rational::ONE || above.is_empty()).then(|| fraction(number));
        return multiplied(fraction.into_iter().chain(above));
    }
    let counted = |value: i128| Rational::new(value, 1).filter(|own| *own != Rational::ONE);
    let number_above = counted(number.numerator()).map(fraction);
    let number_below = counted(number.denominator()).map(fraction);
    let (fixed, moving) = split_moving(above, order);
    let moves_below = below.iter().any(|factor| moves(factor, order));
    let below = multiplied(number_below.into_iter().chain(below));
    if moves_below || fixed.is_empty() && number_above.is_none() {
        let above = number_above.into_iter().chain(fixed).chain(moving);
        return binary(Operator::Divide, multiplied(above), below);
    }
    let above = multiplied(number_above.into_iter().chain(fixed));
    let coefficient = binary(Operator::Divide, above, below);
    multiplied(std::iter::once(coefficient).chain(moving))
}

/// A number and a unit as one: 2 times 1 kg is 2 kg.
fn measure(number: Rational, atom: &Atom, exponent: Rational) -> Option<Expr> {
    let Atom::Opaque(opaque) = atom else {
        return None;
    };
    let Kind::Measure(one, unit) = opaque.expr.kind() else {
        return None;
    };
    // A unit comes after a decimal, and a third of a kilogram has none that ends.
    let ends = [2, 5]
        .into_iter()
        .fold(number.denominator(), |mut rest, prime| {
            while rest % prime == 0 {
                rest /= prime;
            }
            rest
        })
        == 1;
    (ends && *one == Rational::ONE && exponent == Rational::ONE)
        .then(|| Expr::derived(Kind::Measure(number, unit.clone())))
}

/// What moves comes after the fraction of its coefficient.
fn split_moving(factors: Vec<Expr>, order: &Order) -> (Vec<Expr>, Vec<Expr>) {
    factors
        .into_iter()
        .partition(|factor| !moves(factor, order))
}

fn moves(expr: &Expr, order: &Order) -> bool {
    let names = order.moving_names();
    let mut found = false;
    expr.walk(&mut |node| {
        found |= matches!(node.kind(), Kind::Name(name) if names.contains(name));
    });
    found
}

/// The factors side by side, 1 for none.
fn multiplied(factors: impl IntoIterator<Item = Expr>) -> Expr {
    factors
        .into_iter()
        .reduce(|product, factor| binary(Operator::Multiply, product, factor))
        .unwrap_or_else(|| Expr::number(1))
}

/// A fraction as it is written: `5/6` is a quotient of integers.
fn fraction(value: Rational) -> Expr {
    if value.is_integer() {
        return whole(value.numerator());
    }
    binary(
        Operator::Divide,
        whole(value.numerator()),
        whole(value.denominator()),
    )
}

/// An integer as a formula.
fn whole(value: i128) -> Expr {
    let number = Rational::new(value, 1).unwrap_or(Rational::ZERO);
    Expr::derived(Kind::Number(number))
}

/// A power of an atom with a positive exponent.
fn power(atom: &Atom, exponent: Rational, writer: &NormalWriter<'_>) -> Expr {
    let base = atom_expr(atom, writer);
    if exponent == Rational::ONE {
        return base;
    }
    if exponent.numerator() == 1 && exponent.denominator() == 2 {
        return Expr::call(Function::Sqrt, [base]);
    }
    binary(Operator::Power, base, fraction(exponent))
}

fn atom_expr(atom: &Atom, writer: &NormalWriter<'_>) -> Expr {
    let bracket = |own: &Inner| unsigned(own, writer.inner(own), writer);
    match atom {
        Atom::Constant(constant) => Expr::constant(*constant),
        Atom::Variable(variable) => variable.to_expr(),
        Atom::Call(function, arguments) => {
            let is_even = matches!(function, Function::Cos | Function::Cosh | Function::Abs);
            let arguments: Vec<_> = arguments
                .iter()
                .map(|own| {
                    // The cosine of an angle is that of its opposite, of which one begins without a sign.
                    if is_even && begins_with_sign(&writer.inner(own)) {
                        let opposite = (**own).clone().negated();
                        return unsigned(&opposite, collected_sum(&opposite, writer), writer);
                    }
                    bracket(own)
                })
                .collect();
            Expr::call(*function, arguments)
        }
        Atom::Base(base) => bracket(base),
        Atom::Power(base, exponent) => binary(Operator::Power, bracket(base), bracket(exponent)),
        Atom::Opaque(opaque) => opaque.expr.clone(),
    }
}

/// A sum that was written, with a positive term first if it has one.
fn unsigned(own: &Polynomial, written: Expr, writer: &NormalWriter<'_>) -> Expr {
    if !begins_with_sign(&written) {
        return written;
    }
    let (negative, positive): (Vec<_>, Vec<_>) = own
        .0
        .iter()
        .partition(|(_, coefficient)| coefficient.is_negative());
    if positive.is_empty() {
        return written;
    }
    let part = |terms: Vec<(&Monomial, &Rational)>| {
        let terms = terms
            .into_iter()
            .map(|(monomial, own)| (monomial.clone(), own.abs()));
        let mut part = Polynomial::default();
        part.0.extend(terms);
        collected_sum(&part, writer)
    };
    let negative = terms_of(&part(negative));
    let first = part(positive);
    negative
        .into_iter()
        .fold(first, |sum, term| binary(Operator::Subtract, sum, term))
}

/// The terms of a written sum without signs.
fn terms_of(expr: &Expr) -> Vec<Expr> {
    match expr.kind() {
        Kind::Binary(Operator::Add, a, b) => {
            let mut terms = terms_of(a);
            terms.push(b.clone());
            terms
        }
        _ => vec![expr.clone()],
    }
}

fn begins_with_sign(expr: &Expr) -> bool {
    match expr.kind() {
        Kind::Negate(_) => true,
        Kind::Binary(_, first, _) => begins_with_sign(first),
        _ => false,
    }
}
