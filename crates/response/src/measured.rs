//! Functions of numbers with units in them: `0.5 m cos(5 rad/s t - 0.9 rad)`, `146 mm e^(-t) + 54 mm e^(-9 t)`, and
//! those with one unit after the whole, `0.5 cos(2 t) - 2 sin(t) mm`, `… in mm`.
//!
//! A unit in an argument makes that a pure number, in SI units as bare numbers are.

use super::amount::{Split, converted, has_pi, raised};
use super::lexer::tokens;
use super::parser::Parser;
use super::token::{Item, Token};
use super::ways::readings;
use super::{Lexicon, MAX_LENGTH, Manner, Trouble, Typed, TypedError, ValueTrouble};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Expr, Function, Kind, Operator};
use vibank_formula::unit::{DecimalMark, Dimension, Unit};
use vibank_source::Span;

/// A function without its units, and the unit of the whole.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// A formula of bare numbers.
    pub formula: Expr,
    /// None where units stand in its arguments alone.
    pub unit: Option<Unit>,
}

/// The function with units in it that a text is; only names of the lexicon stand in it.
///
/// # Errors
///
/// What cannot be read, that no unit stands in it, or [`ValueTrouble::UnitOfOne`] and [`ValueTrouble::Units`] where the
/// terms have no common unit.
pub(crate) fn measured(
    text: &str,
    lexicon: &Lexicon,
    has_imaginary_unit: bool,
) -> Result<Typed<Measured>, TypedError> {
    if text.len() > MAX_LENGTH {
        return Err(TypedError::new(Trouble::TooLong, MAX_LENGTH, text.len()));
    }
    let manner = Manner {
        comma_is_decimal: true,
        has_imaginary_unit,
        values: Some(DecimalMark::Point),
        ..Manner::default()
    };
    let tokens = tokens(text, 0, text.len(), lexicon, manner)?;
    let whole = Span::new(0, text.len());
    let mut items = tokens.iter().map(|token| &token.item);
    let missing = TypedError {
        trouble: Trouble::Value(ValueTrouble::Missing),
        span: whole,
    };
    let last = last_unit(&tokens);
    let (bare, is_bracketed) = last.map_or((&tokens[..], false), |(before, _, is)| (before, is));
    // After the whole it stands behind the time, too: `25.9 sin 8.49t cm`.
    let is_apart = is_bracketed || tokens.last().is_some_and(|last| last.is_spaced);
    let values = if is_apart { bare } else { &tokens };
    if !items.any(|item| matches!(item, Item::Unit(_))) || !are_after_values(values) {
        return Err(missing);
    }
    let read = |tokens: &[Token]| {
        let formula = readings(|ways| Parser::of_terms(tokens, text.len(), ways).whole_formula())?;
        let of = |formula: &Expr| terms(formula).map(|(formula, unit)| Measured { formula, unit });
        let value = of(&formula.value).map_err(|trouble| TypedError {
            trouble,
            span: whole,
        })?;
        let others = formula.others.iter().filter_map(|other| of(other).ok());
        Ok(Typed {
            value,
            others: others.collect(),
        })
    };
    // Of the whole it is if no term has one of its own.
    if let Some((before, unit, _)) = last
        && let Ok(bare) = read(before)
        && bare.value.unit.is_none()
    {
        let others = bare.others.into_iter().filter(|own| own.unit.is_none());
        let of = |own: Measured| Measured {
            unit: Some(unit),
            ..own
        };
        return Ok(Typed {
            value: of(bare.value),
            others: others.map(of).collect(),
        });
    }
    read(&tokens)
}

/// The tokens before the unit that stands last, and before the comma, bracket or word `in` that introduces it; whether it
/// stands in brackets.
fn last_unit(tokens: &[Token]) -> Option<(&[Token], Unit, bool)> {
    let sign = |token: &Token| match token.item {
        Item::Sign(sign) => Some(sign),
        _ => None,
    };
    let (last, before) = tokens.split_last()?;
    let is_bracketed = matches!(sign(last), Some(')' | ']'));
    let (last, before) = if is_bracketed {
        before.split_last()?
    } else {
        (last, before)
    };
    let Item::Unit(unit) = &last.item else {
        return None;
    };
    let (mut before, is_introduced) = match before {
        [before @ .., word] if word.item == Item::Word("in") => (before, true),
        _ => (before, false),
    };
    if is_bracketed {
        let (open, own) = before.split_last()?;
        before = matches!(sign(open), Some('(' | '[')).then_some(own)?;
    }
    if let [own @ .., comma] = before
        && (is_introduced || is_bracketed)
        && sign(comma) == Some(',')
    {
        before = own;
    }
    (!before.is_empty()).then_some((before, **unit, is_bracketed))
}

/// Whether each unit comes after a number, a bracket or another unit, or divides: letters elsewhere are names.
fn are_after_values(tokens: &[Token]) -> bool {
    tokens.iter().enumerate().all(|(at, token)| {
        let before = |count: usize| at.checked_sub(count).map(|at| &tokens[at].item);
        // `0.3 t m`, where nothing more belongs to the term.
        let is_end = matches!(
            tokens.get(at + 1).map(|next| &next.item),
            None | Some(Item::Sign('+' | '-' | ')'))
        );
        let is_time = matches!(before(1), Some(Item::Leaf(leaf)) if has_time(leaf));
        if is_end && is_time {
            return true;
        }
        let is_factor = before(1) == Some(&Item::Sign('*'));
        let is_behind_value = matches!(
            before(if is_factor { 2 } else { 1 }),
            Some(
                Item::Number(_)
                    | Item::Power(_)
                    | Item::Unit(_)
                    | Item::Sign(')' | ']' | '}' | '/')
                    | Item::Word("in")
            )
        );
        // `H(t)` is a function of its own.
        let is_called = matches!(
            &tokens[at + 1..],
            [open, argument, close, ..]
                if open.item == Item::Sign('(')
                    && !open.is_spaced
                    && matches!(argument.item, Item::Leaf(_))
                    && close.item == Item::Sign(')')
        );
        !matches!(token.item, Item::Unit(_)) || is_behind_value && !is_called
    })
}

/// A sum without the units of its terms, which all have the same one, or none has.
fn terms(formula: &Expr) -> Result<Split, Trouble> {
    let span = formula.span();
    Ok(match formula.kind() {
        Kind::Measure(value, unit) => (Expr::new(Kind::Number(*value), span), Some(**unit)),
        Kind::Negate(inner) => {
            let (inner, unit) = terms(inner)?;
            (Expr::new(Kind::Negate(inner), span), unit)
        }
        Kind::Binary(operator, left, right) => {
            let (left, right, unit) = operation(*operator, left, right)?;
            let formula = match (left, right) {
                (Some(left), Some(right)) => Expr::new(Kind::Binary(*operator, left, right), span),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => Expr::number(1),
            };
            (formula, unit)
        }
        Kind::Call(function, arguments) => {
            if let (Function::Sqrt | Function::Abs, [argument]) = (function, &arguments[..]) {
                let (argument, unit) = terms(argument)?;
                let unit = match (function, unit) {
                    (Function::Sqrt, Some(unit)) => Some(raised(&unit, Rational::new(1, 2))?),
                    (_, unit) => unit,
                };
                return Ok((Expr::new(Kind::Call(*function, vec![argument]), span), unit));
            }
            let bare = arguments.iter().map(argument).collect::<Result<_, _>>()?;
            (Expr::new(Kind::Call(*function, bare), span), None)
        }
        _ => (formula.clone(), None),
    })
}

/// The operands of an operation, none for one that is a unit alone, and the unit of what comes out.
type Operands = (Option<Expr>, Option<Expr>, Option<Unit>);

/// An operation without the units of its operands.
fn operation(operator: Operator, left: &Expr, right: &Expr) -> Result<Operands, Trouble> {
    let units = || Trouble::Value(ValueTrouble::Units);
    let is_one = |operand: &Expr| operand.as_number() == Some(Rational::ONE);
    if operator == Operator::Power {
        let (base, unit) = terms(left)?;
        let exponent = argument(right)?;
        let unit = unit
            .map(|unit| raised(&unit, exponent.as_number()))
            .transpose()?;
        let is_unit = unit.is_some() && is_one(&base);
        return Ok(if is_unit {
            (None, None, unit)
        } else {
            (Some(base), Some(exponent), unit)
        });
    }
    let ((left, own), (right, other)) = (terms(left)?, terms(right)?);
    let is_zero = |operand: &Expr| operand.as_number() == Some(Rational::ZERO);
    Ok(match (operator, own, other) {
        (_, None, None) => (Some(left), Some(right), None),
        (Operator::Multiply, own, other) => {
            let unit = match (own, other) {
                (Some(own), Some(other)) => Some(own.times(&other).ok_or_else(units)?),
                (own, other) => own.or(other),
            };
            // A unit is a factor of one.
            let (is_left, is_right) = (
                own.is_some() && is_one(&left),
                other.is_some() && is_one(&right),
            );
            let right = (!is_right).then_some(right);
            ((!is_left || right.is_none()).then_some(left), right, unit)
        }
        (Operator::Divide, own, other) => {
            let is_unit = other.is_some() && is_one(&right);
            let below = other
                .map(|unit| raised(&unit, Some(Rational::from(-1))))
                .transpose()?;
            let unit = match (own, below) {
                (Some(own), Some(below)) => Some(own.times(&below).ok_or_else(units)?),
                (own, below) => own.or(below),
            };
            (Some(left), (!is_unit).then_some(right), unit)
        }
        (_, Some(own), Some(other)) => {
            // `0.3 m/s t + 0.02 m sin(5 t)`: the time has its unit, too.
            let timed = |term: &Expr, unit: &Unit| {
                let second = Unit::parse("s").ok().filter(|_| has_time(term))?;
                unit.times(&second)
            };
            let is_same = own.dimension() == other.dimension();
            if !is_same
                && let Some(timed) = timed(&left, &own)
                && timed.dimension() == other.dimension()
            {
                let left = converted(left, &timed, &other)?;
                return Ok((Some(left), Some(right), Some(other)));
            }
            let other = match timed(&right, &other).filter(|_| !is_same) {
                Some(timed) => timed,
                None => other,
            };
            (Some(left), Some(converted(right, &other, &own)?), Some(own))
        }
        (_, Some(_), None) if is_zero(&right) => (Some(left), None, own),
        (_, None, Some(_)) if is_zero(&left) && operator == Operator::Add => {
            (None, Some(right), other)
        }
        _ => return Err(Trouble::Value(ValueTrouble::UnitOfOne)),
    })
}

/// Whether the time is a factor of a term.
fn has_time(term: &Expr) -> bool {
    match term.kind() {
        Kind::Name(name) => name.as_str() == "t",
        Kind::Negate(inner) => has_time(inner),
        Kind::Binary(Operator::Multiply, left, right) => has_time(left) || has_time(right),
        Kind::Binary(Operator::Divide, above, _) => has_time(above),
        _ => false,
    }
}

/// An argument of a function or an exponent as a pure number: without the units of angles, and of rates beside a time
/// that is in seconds. Degrees stay, since a formula can have them.
fn argument(formula: &Expr) -> Result<Expr, Trouble> {
    if let Some(degrees) = degrees(formula) {
        return Ok(degrees);
    }
    let span = formula.span();
    match formula.kind() {
        Kind::Negate(inner) => return Ok(Expr::new(Kind::Negate(argument(inner)?), span)),
        Kind::Binary(operator @ (Operator::Add | Operator::Subtract), left, right) => {
            let (left, right) = (argument(left)?, argument(right)?);
            return Ok(Expr::new(Kind::Binary(*operator, left, right), span));
        }
        // `2 (5 rad/s t - 30°)`
        Kind::Binary(Operator::Multiply, left, right) if is_bare(left) && is_sum(right) => {
            let right = argument(right)?;
            return Ok(Expr::new(
                Kind::Binary(Operator::Multiply, left.clone(), right),
                span,
            ));
        }
        Kind::Binary(operator @ (Operator::Multiply | Operator::Divide), left, right)
            if is_sum(left) && is_bare(right) =>
        {
            let left = argument(left)?;
            return Ok(Expr::new(
                Kind::Binary(*operator, left, right.clone()),
                span,
            ));
        }
        _ => {}
    }
    let (bare, unit) = terms(formula)?;
    let Some(unit) = unit else {
        return Ok(bare);
    };
    let is_rate = unit.dimension() == Dimension::TIME.inverse();
    if unit.dimension() == Dimension::PURE && !unit.counts_cycles() {
        return converted(bare, &unit, &Unit::radian());
    }
    if is_rate && (!unit.counts_cycles() || has_pi(&bare)) && unit.to_si(1.0) == 1.0 {
        return Ok(bare);
    }
    if is_rate && !unit.counts_cycles() {
        let radians = Unit::parse("rad/s").map_err(|_| Trouble::Value(ValueTrouble::Units))?;
        return converted(bare, &unit, &radians);
    }
    Err(Trouble::Value(ValueTrouble::UnitOfArgument))
}

/// A number of degrees.
fn degrees(formula: &Expr) -> Option<Expr> {
    let (number, unit) = match formula.kind() {
        Kind::Binary(Operator::Multiply, number, unit) => (number.as_number()?, unit),
        _ => (Rational::ONE, formula),
    };
    match unit.kind() {
        Kind::Measure(own, unit) if **unit == Unit::degree() => {
            let number = number.checked_mul(*own)?;
            Some(Expr::new(
                Kind::Measure(number, unit.clone()),
                formula.span(),
            ))
        }
        _ => None,
    }
}

fn is_sum(formula: &Expr) -> bool {
    matches!(
        formula.kind(),
        Kind::Binary(Operator::Add | Operator::Subtract, ..)
    )
}

/// Whether no unit stands in a formula.
fn is_bare(formula: &Expr) -> bool {
    let mut is_bare = true;
    formula.walk(&mut |node| is_bare &= !matches!(node.kind(), Kind::Measure(..)));
    is_bare
}

#[cfg(test)]
mod tests {
    use super::*;
    use vibank_formula::expr::Name;
    use vibank_notation::symbol;

    fn read(typed: &str) -> Result<Measured, TypedError> {
        let mut lexicon = Lexicon::new();
        lexicon.allow(&Name::new("t"), symbol("t"), false);
        measured(typed, &lexicon, false).map(|typed| typed.value)
    }

    #[test]
    fn units_stand_after_terms_or_after_the_whole() {
        for (typed, formula, unit) in [
            (
                "146 mm e^(-t) + 54.1 mm e^(-9 t)",
                "146*e^(-t) + 54.1*e^(-9*t)",
                "mm",
            ),
            ("1.5e-5 m cos(2 t)", "0.000015*cos(2*t)", "m"),
            ("(0.5 m)exp(-t)", "0.5*exp(-t)", "m"),
            ("0.5*m*exp(-t)", "0.5*exp(-t)", "m"),
            (
                "0.5 m (cos(2 t) + 3 sin(2 t))",
                "0.5*(cos(2*t) + 3*sin(2*t))",
                "m",
            ),
            (
                "2 (0.1 cos(2 t) + 3 sin(2 t)) cm",
                "2*(0.1*cos(2*t) + 3*sin(2*t))",
                "cm",
            ),
            (
                "0.5 cos(2 t) m - 2 sin(t) m",
                "0.5*cos(2*t) - 2*sin(t)",
                "m",
            ),
            ("0.5m cos(2 t)", "0.5*cos(2*t)", "m"),
            (
                "0.5 cos(2 t) - 2 sin(t) mm",
                "0.5*cos(2*t) - 2*sin(t)",
                "mm",
            ),
            ("0.5 cos(2 t) in mm", "0.5*cos(2*t)", "mm"),
            (
                "20 mm cos(2 t) + 1 cm sin(2 t)",
                "20*cos(2*t) + 10*sin(2*t)",
                "mm",
            ),
            ("0.2 m t/s", "0.2*t", "m/s"),
            ("0.2 t m + 3 m sin(t)", "0.2*t + 3*sin(t)", "m"),
            ("3 mm sin(t) + 0.2 m/s t", "3*sin(t) + 200*t", "mm"),
            ("3 m sin(t) - 0.2 m/s t", "3*sin(t) - 0.2*t", "m"),
            ("3 m/s * t + 2 m sin(t)", "3*t + 2*sin(t)", "m"),
            ("0.5 m cos(5 rad/s t - 0.9 rad)", "0.5*cos(5*t - 0.9)", "m"),
            (
                "0.5 m cos(5 rad/s * t - 30°)",
                "0.5*cos(5*t - 30[deg])",
                "m",
            ),
        ] {
            let found = read(typed).unwrap_or_else(|error| panic!("{typed}: {error:?}"));
            assert_eq!(
                found.formula.to_string(),
                Expr::read(formula).unwrap().to_string(),
                "{typed}"
            );
            assert_eq!(found.unit, Some(Unit::parse(unit).unwrap()), "{typed}");
        }
    }

    #[test]
    fn units_of_arguments_are_none_of_the_whole() {
        for (typed, formula) in [
            ("0.5 e^(-0.75 s^-1 t)", "0.5*e^(-0.75*t)"),
            ("0.5 e^(-0.75 s⁻¹ t)", "0.5*e^(-0.75*t)"),
            ("cos(5 rad/s t)", "cos(5*t)"),
            ("e^(-t/s)", "e^(-t)"),
            ("cos(4 t - 0.9 rad)", "cos(4*t - 0.9)"),
            ("cos(2 pi 3 Hz t)", "cos(2*pi*3*t)"),
            ("cos(2 (5 rad/s t - 30°))", "cos(2*(5*t - 30[deg]))"),
            ("sin(300 rad/min t)", "sin(300*t/60)"),
        ] {
            let found = read(typed).unwrap_or_else(|error| panic!("{typed}: {error:?}"));
            assert_eq!(
                found.formula.to_string(),
                Expr::read(formula).unwrap().to_string(),
                "{typed}"
            );
            assert_eq!(found.unit, None, "{typed}");
        }
    }

    #[test]
    fn what_has_no_unit_of_its_own_is_refused() {
        for typed in [
            "0.5 cos(2 t)",
            "0.5 mm e^(-t) + 2 sin(t)",
            "m cos(t)",
            "2 m/s sin(t) + 3 m cos(t)",
            "2 m/s^2 t + 3 m cos(t)",
            "cos(3 Hz t)",
            "cos(2 m t)",
            "2 t",
        ] {
            assert!(read(typed).is_err(), "{typed}");
        }
    }
}
