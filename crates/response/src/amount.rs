//! A formula of numbers with units in it, as a formula of bare numbers and the unit of the whole.
//!
//! A unit belongs to the number that it comes after. One that stands last serves the numbers before it that have
//! none, as in `3 - 4i ohm` and `400 - 238 mm`; with `3 mm + 4i m` each number has its own.

use super::{Trouble, ValueTrouble};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{
    Constant, Expr, Function, Kind, Operator, Program, Slots, Value, Workspace,
};
use vibank_formula::unit::{Decimal, Dimension, Unit};

/// A number with its unit, and what else may have been meant.
#[derive(Clone, Debug)]
pub struct Amount {
    /// What stands before the unit.
    pub number: Number,
    /// None is written where it is [`Unit::ONE`].
    pub unit: Unit,
    /// Other readings, the likelier first.
    pub others: Vec<Amount>,
    /// Whether the rules for products without signs say which of the readings is meant.
    pub is_by_rule: bool,
}

/// What was typed as a number.
#[derive(Clone, Debug)]
pub enum Number {
    /// As it was typed.
    Decimal(Decimal),
    /// A formula of bare numbers.
    Formula(Expr),
}

impl Amount {
    pub(crate) fn decimal(value: Decimal, unit: Unit) -> Self {
        Self {
            number: Number::Decimal(value),
            unit,
            others: Vec::new(),
            is_by_rule: false,
        }
    }

    /// A fraction, or an integer.
    pub(crate) fn ratio(value: Rational, unit: Unit) -> Self {
        let whole = Some(value).filter(|value| value.denominator() == 1);
        let decimal = whole.and_then(|whole| Decimal::parse(&whole.numerator().to_string()).ok());
        let number = decimal.map_or_else(|| Number::Formula(Expr::number(value)), Number::Decimal);
        Self {
            number,
            unit,
            others: Vec::new(),
            is_by_rule: false,
        }
    }

    /// What a formula of numbers is in a unit.
    pub fn of_formula(formula: Expr, unit: Unit) -> Self {
        Self {
            number: Number::Formula(formula),
            unit,
            others: Vec::new(),
            is_by_rule: false,
        }
    }

    /// The value in its unit, if there is one; none where nothing of it is known, `sin(1e99)`.
    pub fn value(&self) -> Option<Value> {
        match &self.number {
            Number::Decimal(decimal) => Some(Value::real(decimal.to_f64(), 0.0)),
            Number::Formula(expr) => {
                let program = Program::compile(expr, &Slots(&[])).ok()?;
                let none: [vibank_formula::expr::Precise; 0] = [];
                let value = program.evaluate(&none, &mut Workspace::default());
                value.ok().filter(is_known)
            }
        }
    }
}

/// Whether numbers are larger than their errors, or both are as good as zero.
fn is_known(value: &Value) -> bool {
    // Far beyond the seventy digits with which a difference that should vanish is computed.
    const NOTHING: f64 = 1e-12;
    let mut numbers = value.numbers().iter().zip(value.bounds());
    numbers.all(|(number, bound)| *bound <= number.abs().max(NOTHING))
}

pub(crate) type Split = (Expr, Option<Unit>);

/// A formula as a bare one and its unit.
///
/// # Errors
///
/// Where units do not fit together.
pub(crate) fn split(formula: &Expr) -> Result<Amount, Trouble> {
    let (expr, unit) = parts(formula)?;
    Ok(Amount::of_formula(expr, unit.unwrap_or(Unit::ONE)))
}

fn parts(formula: &Expr) -> Result<Split, Trouble> {
    let span = formula.span();
    let binary = |operator, left, right| Expr::new(Kind::Binary(operator, left, right), span);
    Ok(match formula.kind() {
        Kind::Measure(value, unit) => (Expr::new(Kind::Number(*value), span), Some(**unit)),
        Kind::Negate(inner) => {
            let (inner, unit) = parts(inner)?;
            (Expr::new(Kind::Negate(inner), span), unit)
        }
        Kind::Binary(operator @ (Operator::Add | Operator::Subtract), left, right) => {
            let (left, right, unit) = joined(parts(left)?, parts(right)?)?;
            (binary(*operator, left, right), unit)
        }
        Kind::Binary(Operator::Multiply, left, right) => {
            let ((left, own), (right, other)) = (parts(left)?, parts(right)?);
            let unit = match (own, other) {
                (Some(own), Some(other)) => Some(
                    own.times(&other)
                        .ok_or(Trouble::Value(ValueTrouble::Units))?,
                ),
                (own, other) => own.or(other),
            };
            // A unit is a factor of one.
            match (left.as_number(), right.as_number()) {
                (_, Some(Rational::ONE)) if other.is_some() => (left, unit),
                (Some(Rational::ONE), _) if own.is_some() => (right, unit),
                _ => (binary(Operator::Multiply, left, right), unit),
            }
        }
        Kind::Binary(Operator::Divide, left, right) => {
            let ((left, own), (right, other)) = (parts(left)?, parts(right)?);
            let unit = match other {
                Some(other) => {
                    let inverse = other
                        .pow(vibank_formula::unit::Rational::ONE.negated())
                        .ok_or(Trouble::Value(ValueTrouble::Units))?;
                    let unit = own.map_or(Some(inverse), |own| own.times(&inverse));
                    Some(unit.ok_or(Trouble::Value(ValueTrouble::Units))?)
                }
                None => own,
            };
            match right.as_number() {
                Some(Rational::ONE) if other.is_some() => (left, unit),
                _ => (binary(Operator::Divide, left, right), unit),
            }
        }
        Kind::Binary(Operator::Power, base, exponent) => {
            let ((base, unit), (exponent, other)) = (parts(base)?, parts(exponent)?);
            // `e^(i 53°)`.
            let exponent = match other {
                None => exponent,
                Some(angle) if is_angle(&angle) => converted(exponent, &angle, &Unit::radian())?,
                Some(_) => return Err(Trouble::Value(ValueTrouble::Units)),
            };
            let unit = unit
                .map(|unit| raised(&unit, exponent.as_number()))
                .transpose()?;
            (binary(Operator::Power, base, exponent), unit)
        }
        Kind::Call(function, arguments) => called(*function, arguments, formula)?,
        _ => (formula.clone(), None),
    })
}

/// A unit to the power of a number.
pub(crate) fn raised(unit: &Unit, exponent: Option<Rational>) -> Result<Unit, Trouble> {
    let part = |part: i128| i32::try_from(part).ok();
    let power = exponent.and_then(|power| {
        vibank_formula::unit::Rational::new(part(power.numerator())?, part(power.denominator())?)
    });
    power
        .and_then(|power| unit.pow(power))
        .ok_or(Trouble::Value(ValueTrouble::Units))
}

/// Two terms in one unit. One that stands last serves both; with π a bare number is an angle in radians.
fn joined(
    (left, own): Split,
    (right, other): Split,
) -> Result<(Expr, Expr, Option<Unit>), Trouble> {
    match (own, other) {
        (None, None) => Ok((left, right, None)),
        (Some(own), Some(other)) => Ok((left, converted(right, &other, &own)?, Some(own))),
        (None, Some(unit)) if has_pi(&left) && is_angle(&unit) => {
            let radian = Unit::radian();
            Ok((left, converted(right, &unit, &radian)?, Some(radian)))
        }
        (None, Some(unit)) => Ok((left, right, Some(unit))),
        (Some(unit), None) if has_pi(&right) && is_angle(&unit) => {
            let right = converted(right, &Unit::radian(), &unit)?;
            Ok((left, right, Some(unit)))
        }
        (Some(_), None) if right.as_number() == Some(Rational::ZERO) => Ok((left, right, own)),
        (Some(unit), None) if is_angle(&unit) => Err(Trouble::Value(ValueTrouble::MixedAngles)),
        (Some(_), None) => Err(Trouble::Value(ValueTrouble::UnitOfOne)),
    }
}

/// A number in one unit as one in another.
pub(crate) fn converted(number: Expr, from: &Unit, to: &Unit) -> Result<Expr, Trouble> {
    if from == to {
        return Ok(number);
    }
    let conversion = from
        .conversion(to)
        .map_err(|_| Trouble::Value(ValueTrouble::Units))?;
    // Exactly so.
    if *from == Unit::degree() && *to == Unit::radian() {
        return Ok(number * Expr::constant(Constant::Pi) / Expr::number(180));
    }
    if *to == Unit::degree() && *from == Unit::radian() {
        return Ok(number * Expr::number(180) / Expr::constant(Constant::Pi));
    }
    let factor = to.of_si(conversion.apply(1.0));
    // An hour has 3600 s: a second is the quotient, and no decimal.
    let parts = (1.0 / factor).round();
    let is_whole = parts > 1.0 && (parts * factor - 1.0).abs() <= f64::EPSILON;
    if let Some(parts) = Decimal::shortest(parts).filter(|_| is_whole)
        && let Some(parts) = Rational::from_decimal(&parts.to_string())
    {
        return Ok(number / Expr::number(parts));
    }
    let factor =
        Decimal::shortest(factor).and_then(|factor| Rational::from_decimal(&factor.to_string()));
    Ok(number * Expr::number(factor.ok_or(Trouble::Value(ValueTrouble::Units))?))
}

/// A function of numbers with units.
fn called(function: Function, arguments: &[Expr], formula: &Expr) -> Result<Split, Trouble> {
    let mut split = Vec::with_capacity(arguments.len());
    for argument in arguments {
        split.push(parts(argument)?);
    }
    let call = |arguments| Expr::new(Kind::Call(function, arguments), formula.span());
    if split.iter().all(|(_, unit)| unit.is_none()) {
        let bare = split.into_iter().map(|(argument, _)| argument);
        return Ok((call(bare.collect()), None));
    }
    let first = split
        .iter()
        .find_map(|(_, unit)| *unit)
        .unwrap_or(Unit::ONE);
    let in_one_unit = |unit: &Unit| {
        let bare = split.iter().map(|(argument, own)| match own {
            Some(own) => converted(argument.clone(), own, unit),
            None => Ok(argument.clone()),
        });
        bare.collect::<Result<Vec<Expr>, Trouble>>()
    };
    match function {
        Function::Sqrt => {
            let half = Rational::new(1, 2);
            let unit = raised(&first, half)?;
            Ok((call(in_one_unit(&first)?), Some(unit)))
        }
        Function::Abs | Function::Hypot | Function::Min | Function::Max => {
            // A unit after the last number serves all.
            Ok((call(in_one_unit(&first)?), Some(first)))
        }
        Function::Atan2 | Function::Sign => Ok((call(in_one_unit(&first)?), None)),
        _ if first.dimension() == Dimension::PURE => {
            Ok((call(in_one_unit(&Unit::radian())?), None))
        }
        _ => Err(Trouble::Value(ValueTrouble::Units)),
    }
}

fn is_angle(unit: &Unit) -> bool {
    unit.dimension().is_pure() && !unit.is_one()
}

/// Whether π stands in a formula.
pub fn has_pi(expr: &Expr) -> bool {
    let mut is_there = false;
    expr.walk(&mut |node| is_there |= *node.kind() == Kind::Constant(Constant::Pi));
    is_there
}
