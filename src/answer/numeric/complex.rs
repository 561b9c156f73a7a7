//! Complex numbers as people type them, and how they are marked: `3 - 4i ohm`, `-100j ohm`, `5 ohm at -53 deg`, `5∠-53°`.

use std::sync::Arc;

use super::list::{parted, without_empty_ends};
use super::read::explained;
use super::trial;
use crate::answer::settle::{Candidate, Rule, settle};
use crate::answer::steps::Steps;
use crate::answer::{
    Answered, Credit, Decades, Doubt, Echo, Example, Key, KeyValue, Marker, Marking, Misfit,
    Mistaken, Negated, Reading, Remark, Slip, Trial, Unreadable, Why,
};
use crate::expr::{Constant, Expr, Form, Kind};
use crate::math::Math;
use crate::numerics::{Complex, Rational, powi};
use crate::response::{Amount, Folded, Number as Typed, Part, Passage, Style, Values};
use crate::unit::{DecimalMark, Unit};

/// With an example of a complex number.
fn like_complex(why: Why) -> Unreadable {
    Unreadable::of(why).like(Example::Complex)
}

/// A complex number that is right, and how far from it is right, too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    pub(crate) value: Complex,
    pub(crate) bound: f64,
    pub(crate) half: f64,
}

/// A prepared key.
pub(crate) struct ComplexNumbers {
    pub(crate) unit: Unit,
    pub(crate) form: Form,
    pub(crate) digits: u32,
    pub(crate) mark: DecimalMark,
    /// What steps may be written in.
    pub(crate) steps: Arc<Steps>,
    pub(crate) doubt: Doubt,
    pub(crate) targets: Vec<Target>,
    pub(crate) mistakes: Vec<Mistaken>,
    pub(crate) is_list: bool,
    pub(crate) is_ordered: bool,
}

/// A typed number in SI units; without a unit that of the answer was taken.
struct GivenNumber {
    value: Complex,
    math: Math,
    text: String,
    /// Whether it has no unit where one is due.
    is_bare: bool,
}

impl Target {
    fn accepts(&self, typed: Complex) -> bool {
        let slack = self.bound + 4.0 * f64::EPSILON * self.value.abs();
        (typed - self.value).abs() <= self.half + slack
    }
}

/// Whether a number fits but for a power of ten.
fn is_off_by_ten(target: &Target, typed: Complex) -> bool {
    let fits = |power| {
        let factor = powi(10.0, power);
        target.accepts(Complex::new(typed.re * factor, typed.im * factor))
    };
    (1..=9).any(|power| fits(power) || fits(-power))
}

/// A complex number as it was typed: before its unit, with the unit where one is written, and as a formula.
type WrittenComplex = (Complex, Option<Unit>, Expr);

/// Which reading is taken of numbers that may be meant otherwise: one convention holds for the whole response.
#[derive(Clone, Copy, PartialEq)]
enum Convention {
    Conventional,
    Other,
}

/// The complex number that a part of a response is.
fn number(values: &Values<'_>, part: &Part, way: Convention) -> Result<WrittenComplex, Unreadable> {
    // `(5∠53°) ohm`
    if let Some((inner, behind)) = values.front_bracket(part)
        && values.polar(&inner).is_some()
        && let Some(unit) = values.unit(&behind)
    {
        let (value, own, formula) = number(values, &inner, way)?;
        return Ok((value, own.or(Some(unit)), formula));
    }
    if let Some((modulus, angle)) = values.polar(part) {
        return of_polar(values, &modulus, &angle, way);
    }
    let amount = amount(values, part, way)?;
    let value = amount.value().and_then(|value| value.as_complex());
    let value = value.ok_or_else(|| like_complex(Why::Form))?;
    Ok((value, stated(&amount), formula(&amount)))
}

/// The amount that a part is.
fn amount(values: &Values<'_>, part: &Part, way: Convention) -> Result<Amount, Unreadable> {
    let mut amount = values
        .amount(part)
        .map_err(|error| explained(&error, values, values.passage(part)).like(Example::Complex))?;
    if way == Convention::Other && !amount.others.is_empty() {
        amount = amount.others.swap_remove(0);
    }
    Ok(amount)
}

/// The unit that is written with an amount.
fn stated(amount: &Amount) -> Option<Unit> {
    Some(amount.unit).filter(|unit| !unit.is_one())
}

/// An amount as a formula of bare numbers.
fn formula(amount: &Amount) -> Expr {
    match &amount.number {
        Typed::Formula(formula) => formula.clone(),
        Typed::Decimal(decimal) => Rational::from_decimal(&decimal.to_string())
            .map_or_else(|| Expr::number(0), Expr::number),
    }
}

/// The complex number and the unit that a text is, as a response would be read.
pub(crate) fn complex_number(text: &str) -> Option<(Complex, Option<Unit>)> {
    let folded = Folded::of(text).ok()?;
    let style = Style {
        mark: DecimalMark::Point,
        comma_is_decimal: true,
        is_complex: true,
    };
    let values = Values::read(folded.passage(), style).ok()?;
    let (value, unit, _) = number(&values, &values.all(), Convention::Conventional).ok()?;
    Some((value, unit))
}

/// Modulus and angle; the unit comes after either.
fn of_polar(
    values: &Values<'_>,
    modulus: &Part,
    angle: &Part,
    way: Convention,
) -> Result<WrittenComplex, Unreadable> {
    let (angle, mut behind) = values.unit_behind_angle(angle);
    let size = amount(values, modulus, way)?;
    let mut turn = amount(values, &angle, way)?;
    let is_of_angle = |unit: &Unit| unit.conversion(&Unit::radian()).is_ok();
    // `100∠-π/2 ohm`
    if !is_of_angle(&turn.unit) && behind.is_none() && size.unit.is_one() {
        behind = Some(std::mem::replace(&mut turn.unit, Unit::ONE));
    }
    let real = |amount: &Amount| amount.value().and_then(|value| value.as_real());
    let (Some(_), Some(turns)) = (real(&size), real(&turn)) else {
        return Err(like_complex(Why::Form));
    };
    if turn.unit.is_one() && turns.abs() > std::f64::consts::TAU {
        return Err(Why::AngleWithoutUnit(formula(&turn).to_string()).into());
    }
    if !is_of_angle(&turn.unit) {
        return Err(Why::AngleUnit.into());
    }
    let unit = stated(&size).or(behind);
    let imaginary = Expr::constant(Constant::ImaginaryUnit);
    let angle = match formula(&turn) {
        own if turn.unit.is_one() => own,
        own => {
            let one = Kind::Measure(Rational::ONE, Box::new(turn.unit));
            match own.as_number() {
                Some(number) => Expr::derived(Kind::Measure(number, Box::new(turn.unit))),
                None => own * Expr::derived(one),
            }
        }
    };
    let power = Expr::constant(Constant::E).power(imaginary * angle);
    let whole = formula(&size) * power;
    let value = Amount::of_formula(whole.clone(), Unit::ONE).value();
    let value = value.and_then(|value| value.as_complex());
    Ok((value.ok_or_else(|| like_complex(Why::Form))?, unit, whole))
}

/// The side of a statement that is neither the name of its value nor another form of it: `Z^2`, `|Z|`, `Re(Z)`, `5`.
fn unclear<'s>(
    values: &Values<'_>,
    sides: &'s [Part],
    last: &Part,
    (asked, steps): (&Unit, &Steps),
) -> Option<&'s Part> {
    /// Forms of one number may be rounded.
    const SHARE: f64 = 0.01;
    let is_name = |side: &Part| values.is_name(side) && !values.passage(side).is_made_of_complex();
    let value = |side: &Part| number(values, side, Convention::Conventional).ok();
    let is_step = |side: &Part| steps.are_in(values.passage(side));
    let is_led = sides
        .first()
        .is_some_and(|side| is_name(side) || is_step(side));
    let is_clear = |side: &Part| match (value(side), value(last)) {
        // `1/(iΩC)` has letters of the question, no ohm and coulomb.
        (Some((_, Some(unit), _)), _) if is_led && unit.dimension() != asked.dimension() => true,
        (Some((own, ..)), Some((other, ..))) => (own - other).abs() <= SHARE * other.abs(),
        (None, _) => is_led && !values.goes_on_in_words(side),
        _ => false,
    };
    sides.iter().find(|side| !is_name(side) && !is_clear(side))
}

impl ComplexNumbers {
    fn read(
        &self,
        values: &Values<'_>,
        part: &Part,
        way: Convention,
    ) -> Result<GivenNumber, Box<Marking>> {
        let (value, stated, expr) =
            number(values, part, way).map_err(|words| Box::new(Marking::unreadable(words)))?;
        let unit = stated.unwrap_or(self.unit);
        let formula = expr.typeset(&crate::expr::PlainNotation);
        let (math, text) = if unit.is_one() {
            (formula, expr.to_string())
        } else {
            let math = Math::row([formula.fenced("(", ")"), Math::thin_space(), unit.math()]);
            (math, format!("({expr}) {}", unit.text()))
        };
        if unit.dimension() != self.unit.dimension() {
            let reading = Reading {
                math,
                text,
                answered: Answered::Complex(Vec::new()),
            };
            let misfit = Remark::from(Misfit::UnitOf(self.unit));
            return Err(Box::new(Marking::wrong(reading, misfit)));
        }
        let value = Complex::new(unit.to_si(value.re), unit.to_si(value.im));
        let is_bare = stated.is_none() && !self.unit.is_one() && value != Complex::new(0.0, 0.0);
        Ok(GivenNumber {
            value,
            math,
            text,
            is_bare,
        })
    }

    fn accepted(&self, keys: &[Target], typed: &[Complex]) -> usize {
        if self.is_ordered {
            return keys
                .iter()
                .zip(typed)
                .filter(|(key, typed)| key.accepts(**typed))
                .count();
        }
        let mut free: Vec<Complex> = typed.to_vec();
        let mut count = 0;
        for key in keys {
            // The nearest one: targets are far apart where a list makes sense.
            let nearest = (0..free.len()).min_by(|a, b| {
                (free[*a] - key.value)
                    .abs()
                    .total_cmp(&(free[*b] - key.value).abs())
            });
            if let Some(place) = nearest.filter(|place| key.accepts(free[*place])) {
                free.swap_remove(place);
                count += 1;
            }
        }
        count
    }

    /// The numbers of a response, each as a part of it.
    fn parts(&self, values: &Values<'_>) -> Result<Vec<Part>, Unreadable> {
        let mut all = values.all();
        if self.is_list
            && let Some((inner, behind)) = values.front_bracket(&all)
            && behind.is_empty()
            && values.statements(&inner).len() > 1
        {
            all = inner;
        }
        let pieces = match values.polar(&all) {
            Some(_) if !self.is_list => vec![all],
            _ => values.statements(&all),
        };
        let pieces = without_empty_ends(values, pieces)?;
        if pieces.is_empty() || !self.is_list && pieces.len() > 1 {
            return Err(like_complex(Why::SeveralComplex));
        }
        let mut parts = Vec::with_capacity(pieces.len());
        for piece in pieces {
            let statement = values.statement(&piece);
            if let Some(sign) = statement.unequal {
                return Err(
                    Unreadable::at(sign.to_string(), Why::Inequality).like(Example::Complex)
                );
            }
            let mut sides = statement.sides;
            let last = sides.pop();
            if let Some(side) = last
                .as_ref()
                .and_then(|last| unclear(values, &sides, last, (&self.unit, &self.steps)))
            {
                return Err(Unreadable::at(values.passage(side), Why::UnclearSide));
            }
            parts.extend(last);
        }
        Ok(parts)
    }

    /// A slip that one number alone gives away.
    fn slip(&self, values: &[Complex]) -> Option<Slip> {
        let ([target], [value]) = (&self.targets[..], values) else {
            return None;
        };
        if target.accepts(value.conjugate()) {
            Some(Slip::Sign(Negated::Imaginary))
        } else if target.accepts(-*value) {
            Some(Slip::Sign(Negated::Whole))
        } else if is_off_by_ten(target, *value) {
            Some(Slip::PowerOfTen(Decades::Prefix))
        } else {
            let has_size = (value.abs() - target.value.abs()).abs() <= target.half;
            has_size.then_some(Slip::Angle)
        }
    }

    fn printed(&self, value: Complex) -> Math {
        let (re, im) = (self.unit.of_si(value.re), self.unit.of_si(value.im));
        let set = |part: f64| Key::rounded(part, self.digits, Unit::ONE, self.mark);
        let is_sum = re != 0.0 || im == 0.0;
        let number = Math::complex(is_sum.then(|| set(re)), im < 0.0, set(im.abs()));
        if self.unit.is_one() {
            return number;
        }
        let number = if is_sum {
            number.fenced("(", ")")
        } else {
            number
        };
        Math::row([number, Math::thin_space(), self.unit.math()])
    }
}

impl Marker for ComplexNumbers {
    fn trials(&self) -> Vec<Trial> {
        trial::of_complex_numbers(self)
    }

    fn key(&self) -> Key {
        let mut row = Vec::new();
        for target in &self.targets {
            if !row.is_empty() {
                row.push(Math::punctuation(";"));
            }
            row.push(self.printed(target.value));
        }
        Key {
            math: Math::row(row),
            accepted: None,
            value: KeyValue::Numbers {
                form: self.form,
                si: self
                    .targets
                    .iter()
                    .flat_map(|target| [target.value.re, target.value.im])
                    .collect(),
            },
        }
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let values = self.values(response)?;
        let parts = self.parts(&values)?;
        let of = |way| Echo::of_marking(self.judged(&values, &parts, way));
        let (first, other) = (of(Convention::Conventional)?, of(Convention::Other)?);
        let other = Some(other.reading.math).filter(|other| *other != first.reading.math);
        Ok(Echo { other, ..first })
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let read = self.values(response);
        let read = read.and_then(|values| self.parts(&values).map(|parts| (values, parts)));
        let (values, parts) = match read {
            Ok(read) => read,
            Err(help) => return Marking::unreadable(help),
        };
        let candidate = |way| {
            let marking = self.judged(&values, &parts, way);
            let read = marking.reading.as_ref();
            let shown = read.map_or_else(String::new, |reading| reading.math.plain());
            Candidate { shown, marking }
        };
        let first = candidate(Convention::Conventional);
        let other = candidate(Convention::Other);
        let is_doubtful = other.shown != first.shown;
        settle(self.doubt, Rule::None, first, is_doubtful.then_some(other))
    }
}

impl ComplexNumbers {
    fn values<'r>(&self, response: Passage<'r>) -> Result<Values<'r>, Unreadable> {
        if self.is_list {
            return parted(response, self.mark, true, self.targets.len());
        }
        let style = Style {
            mark: self.mark,
            comma_is_decimal: true,
            is_complex: true,
        };
        Values::read(response, style).map_err(|error| Unreadable::typed(&error, response))
    }

    /// The marking of one reading of the parts of a response.
    fn judged(&self, values: &Values<'_>, parts: &[Part], way: Convention) -> Marking {
        let mut items = Vec::new();
        for part in parts {
            match self.read(values, part, way) {
                Ok(typed) => items.push(typed),
                Err(marking) => return *marking,
            }
        }
        let values: Vec<Complex> = items.iter().map(|item| item.value).collect();
        let mut row = Vec::new();
        for item in &items {
            if !row.is_empty() {
                row.push(Math::punctuation(";"));
            }
            row.push(item.math.clone());
        }
        let reading = Reading {
            math: Math::row(row),
            text: items
                .iter()
                .map(|item| item.text.as_str())
                .collect::<Vec<_>>()
                .join("; "),
            answered: Answered::Complex(values.clone()),
        };
        let found = self.accepted(&self.targets, &values);
        if found == self.targets.len() && values.len() == found {
            let mut marking = Marking::right(reading);
            if items.iter().any(|item| item.is_bare) {
                marking.say_taken(&self.unit);
            }
            return marking;
        }
        for mistaken in &self.mistakes {
            let Some(value) = mistaken.values.first() else {
                continue;
            };
            let given: Vec<Target> = (0..value.shape().len())
                .zip(&self.targets)
                .map(|(entry, target)| Target {
                    value: value.entry(entry),
                    ..*target
                })
                .collect();
            if given.len() == values.len() && self.accepted(&given, &values) == given.len() {
                return Marking::mistake(reading, mistaken.number, mistaken.credit);
            }
        }
        if self.is_list && found > 0 {
            let most = self.targets.len().max(values.len()) as i128;
            let credit = crate::numerics::Rational::new(found as i128, most).and_then(Credit::new);
            let counted = Slip::CountedComplex {
                right: found,
                of: self.targets.len(),
            };
            let credit = credit.unwrap_or(Credit::NONE);
            return Marking::read(reading, credit, Remark::from(counted));
        }
        let slip = self.slip(&values);
        Marking::wrong(reading, slip.map(Remark::from))
    }
}
