//! Complex numbers as people type them, and how they are marked: `3 - 4i ohm`, `-100j ohm`, `5 ohm at -53 deg`, `5∠-53°`.

use super::super::{
    Answered, Credit, Decades, Example, Key, KeyValue, Marker, Marking, Misfit, Mistaken, Negated,
    Reading, Remark, Slip, Trial, Unreadable, Why,
};
use super::arithmetic::{Arithmetic, LONGEST};
use super::{doubt, read};
use crate::expr::{Expr, Form, Kind};
use crate::math::Math;
use crate::numerics::{Complex, powi};
use crate::response::cut;
use crate::source::Span;
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

/// With an example of a complex number.
fn like_complex(why: Why) -> Unreadable {
    Unreadable::of(why).like(Example::Complex)
}

/// A complex number that is right, and how far from it is right, too.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    pub(super) value: Complex,
    pub(super) bound: f64,
    pub(super) half: f64,
}

/// A prepared key.
pub(super) struct Numbers {
    pub(super) unit: Unit,
    pub(super) form: Form,
    pub(super) digits: u32,
    pub(super) mark: DecimalMark,
    pub(super) targets: Vec<Target>,
    pub(super) mistakes: Vec<Mistaken>,
    pub(super) is_list: bool,
    pub(super) is_ordered: bool,
}

/// A typed number in SI units; without a unit that of the answer was taken.
struct Typed {
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

/// The complex number that a text is, before its unit; the unit, where one is written.
fn number(text: &str, mark: DecimalMark) -> Result<(Complex, Option<Unit>, Expr), Unreadable> {
    let polar = ["∠", " at ", " cis ", "\\angle"]
        .iter()
        .find_map(|sign| text.split_once(sign));
    if let Some((modulus, angle)) = polar {
        return of_polar(modulus, angle, mark);
    }
    if let Some(question) = doubt::question(text, mark) {
        return Err(question);
    }
    // `4iΩ`, `4*I`.
    let spaced = text.replace("iΩ", "i Ω").replace("jΩ", "j Ω");
    let text = spaced.replace("*I", "*i");
    let text = text.as_str();
    let arithmetic = Arithmetic::read(text.trim(), mark, true)
        .or_else(|error| Arithmetic::read(&once(text).ok_or(error)?, mark, true))
        .map_err(|_| like_complex(Why::Form))?;
    let value = arithmetic.value().and_then(|value| value.as_complex());
    let value = value.ok_or_else(|| like_complex(Why::Form))?;
    Ok((value, arithmetic.unit, arithmetic.expr))
}

/// A text with its unit at the end alone, where it stands behind both parts, `3 ohm + 4i ohm`.
fn once(text: &str) -> Option<String> {
    let text = text.trim();
    let start = text.rfind(|char: char| !char.is_alphabetic())?;
    let unit = text[start..].trim_start_matches(|char: char| !char.is_alphabetic());
    let before = &text[..text.len() - unit.len()];
    let is_repeated = Unit::read(unit).is_ok() && before.contains(unit);
    is_repeated.then(|| format!("({}) {unit}", before.replace(unit, "")))
}

/// The complex number and the unit that a text is, as a response would be read.
pub(in crate::answer) fn complex_number(text: &str) -> Option<(Complex, Option<Unit>)> {
    let is_short = text.len() <= LONGEST;
    let (value, unit, _) = number(text, DecimalMark::Point).ok().filter(|_| is_short)?;
    Some((value, unit))
}

/// Modulus and angle; the unit stands behind either.
fn of_polar(
    modulus: &str,
    angle: &str,
    mark: DecimalMark,
) -> Result<(Complex, Option<Unit>, Expr), Unreadable> {
    let (angle, behind) = match angle.find('°') {
        Some(at) => angle.split_at(at + '°'.len_utf8()),
        None => (angle, ""),
    };
    let modulus = read::quantity(&format!("{} {}", modulus.trim(), behind.trim()), mark)?;
    let angle = read::quantity(angle, mark)?;
    if angle.unit.is_one() && angle.value.to_f64().abs() > std::f64::consts::TAU {
        return Err(Why::AngleWithoutUnit(angle.value.to_string()).into());
    }
    let radian = Unit::parse("rad").unwrap_or(Unit::ONE);
    let radians = angle.si_for(&radian).map_err(|_| Why::AngleUnit)?;
    let unit = Some(modulus.unit).filter(|unit| !unit.is_one());
    let value = Complex::from_polar(modulus.value.to_f64(), radians);
    let number = |decimal: &Decimal| {
        crate::numerics::Rational::from_decimal(&decimal.to_string())
            .map_or_else(|| Expr::number(0), Expr::number)
    };
    let imaginary = Expr::constant(crate::expr::Constant::ImaginaryUnit);
    let angle = if angle.unit.is_one() {
        number(&angle.value)
    } else {
        crate::numerics::Rational::from_decimal(&angle.value.to_string()).map_or_else(
            || Expr::number(0),
            |value| Expr::derived(Kind::Measure(value, Box::new(angle.unit))),
        )
    };
    let power = Expr::constant(crate::expr::Constant::E).power(imaginary * angle);
    Ok((value, unit, number(&modulus.value) * power))
}

impl Numbers {
    fn read(&self, text: &str) -> Result<Typed, Box<Marking>> {
        let (value, stated, expr) =
            number(text, self.mark).map_err(|why| Box::new(Marking::unreadable(why)))?;
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
        Ok(Typed {
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

    /// Where the numbers of a response stand.
    fn places(&self, response: &str) -> Result<Vec<Span>, Unreadable> {
        let start = response.rfind('=').map_or(0, |at| at + 1);
        let all = Span::new(start, response.len());
        let values = cut(response, Span::new(0, response.len()), &[',', ';']);
        let are_named = values.len() > 1
            && values
                .iter()
                .all(|place| response[place.range()].contains('='));
        if are_named && !self.is_list {
            return Err(like_complex(Why::SeveralComplex));
        }
        Ok(match (self.is_list, response.contains(';')) {
            (false, _) => vec![all],
            (true, true) => cut(response, all, &[';']),
            (true, false) => cut(response, all, &[',']),
        })
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
        let set = |part: f64| match Decimal::rounded(part, self.digits) {
            Some(decimal) => Quantity::new(decimal, Unit::ONE).math(self.mark),
            None => Math::text("out of range"),
        };
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

impl Marker for Numbers {
    fn trials(&self) -> Vec<Trial> {
        self.made_up()
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

    fn mark(&self, response: &str) -> Marking {
        if response.len() > LONGEST {
            return Marking::unreadable(Why::TooLong);
        }
        let places = match self.places(response) {
            Ok(places) => places,
            Err(why) => return Marking::unreadable(why),
        };
        let mut items = Vec::new();
        for place in places {
            match self.read(&response[place.range()]) {
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
