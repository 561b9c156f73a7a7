//! Numbers with units as people type them.

use super::super::typed::{cut, first_bracket};
use super::arithmetic::{Arithmetic, is_arithmetic};
use crate::expr::{Expr, PlainNotation};
use crate::math::Math;
use crate::source::Span;
use crate::unit::{Decimal, DecimalMark, ErrorKind, Quantity, Unit};

/// A number with its unit as it was typed.
#[derive(Clone, Debug)]
pub(super) struct Number {
    pub(super) quantity: Quantity,
    /// What was typed instead of a decimal.
    pub(super) arithmetic: Option<Expr>,
}

impl Number {
    /// Typeset; arithmetic with what it comes to.
    pub(super) fn math(&self, mark: DecimalMark) -> Math {
        const DIGITS: u32 = 5;
        let Some(expr) = &self.arithmetic else {
            return self.quantity.math(mark);
        };
        let value = self.quantity.value.to_f64();
        let rounded = Decimal::rounded(value, DIGITS).unwrap_or(self.quantity.value);
        let short = Decimal::shortest(rounded.to_f64()).unwrap_or(rounded);
        let is_exact = short.to_f64() == value;
        Math::row([
            expr.typeset(&PlainNotation),
            Math::relation(if is_exact { "=" } else { "≈" }),
            Quantity::new(short, self.quantity.unit).math(mark),
        ])
    }

    /// In the formula language.
    pub(super) fn text(&self) -> String {
        match &self.arithmetic {
            None => self.quantity.to_string(),
            Some(expr) if self.quantity.unit.is_one() => expr.to_string(),
            Some(expr) => format!("({expr}) {}", self.quantity.unit),
        }
    }
}

/// The number that a response is, after a symbol and an equals sign that may stand before it.
///
/// # Errors
///
/// A sentence that says what cannot be read and what to type instead.
pub(super) fn number(response: &str, mark: DecimalMark) -> Result<Number, String> {
    let value = unenclosed(after_equals(response));
    if has_two_signs(value) {
        return Err(format!("`{value}` begins with two signs: give one number."));
    }
    let error = match Quantity::read(value, mark) {
        Ok(quantity) => {
            return Ok(Number {
                quantity,
                arithmetic: None,
            });
        }
        Err(error) => error,
    };
    let is_plain = matches!(
        error.kind,
        ErrorKind::AmbiguousComma { .. } | ErrorKind::TooLong { .. } | ErrorKind::OutOfRange
    );
    if !is_plain && is_arithmetic(value) {
        match computed(value, mark) {
            Ok(number) => return Ok(number),
            // A decimal with a unit that cannot be read is told by its unit.
            Err(words) if !is_number_then_unit(value, mark) => return Err(words),
            Err(_) => {}
        }
    }
    Err(explained(value, &error))
}

/// The quantity that a response is.
///
/// # Errors
///
/// As for [`number`].
pub(crate) fn quantity(response: &str, mark: DecimalMark) -> Result<Quantity, String> {
    number(response, mark).map(|number| number.quantity)
}

/// What arithmetic comes to.
fn computed(text: &str, mark: DecimalMark) -> Result<Number, String> {
    let arithmetic = Arithmetic::read(text, mark, false)?;
    let value = arithmetic.value().and_then(|value| value.as_real());
    let decimal = value.and_then(Decimal::shortest);
    let decimal = decimal.ok_or_else(|| format!("`{}` has no value.", text.trim()))?;
    let unit = arithmetic.unit.unwrap_or(crate::unit::Unit::ONE);
    Ok(Number {
        quantity: Quantity::new(decimal, unit),
        arithmetic: Some(arithmetic.expr),
    })
}

/// Whether a text begins with a decimal that a letter follows, so that the rest can only be its unit.
fn is_number_then_unit(text: &str, mark: DecimalMark) -> bool {
    Decimal::read(text, mark).is_ok_and(|(_, length)| {
        let rest = text.get(length..).unwrap_or_default().trim_start();
        rest.starts_with(char::is_alphabetic) && !rest.starts_with("pi") && !rest.starts_with('π')
    })
}

fn explained(value: &str, error: &crate::unit::Error) -> String {
    let place = value
        .get(error.span.clone())
        .filter(|place| !place.is_empty() && *place != value);
    let mut message = match place {
        Some(place) => format!("At `{place}`: {error}."),
        None => format!("{}.", capital(&error.to_string())),
    };
    if let Some(help) = error.help() {
        message.push(' ');
        message.push_str(&capital(&help));
        message.push('.');
    } else {
        message.push_str(" Type a number and its unit, for example `15.8 rad/s` or `1.6e-2 m`.");
    }
    message
}

/// The items of a list; a unit at the end of the last one, or behind the bracket, serves for all that have none.
pub(super) fn list(response: &str, mark: DecimalMark) -> Result<Vec<Number>, String> {
    const MOST_ITEMS: usize = 100;
    const LONGEST: usize = 2_000;
    if response.len() > LONGEST {
        return Err("This is too long to be read.".to_owned());
    }
    let response = response.trim().replace('\n', "; ");
    let (inner, unit) = unframed(after_equals(&response));
    let mut pieces = separated(inner, mark);
    if pieces.len() == 1 && response.matches('=').count() > 1 {
        // `a = 1, b = 2`: each has an equals sign of its own.
        pieces = separated(&response, mark);
    }
    if pieces.len() > MOST_ITEMS {
        return Err(format!("A list has at most {MOST_ITEMS} numbers."));
    }
    let mut items = Vec::new();
    for piece in pieces {
        items.extend(both_signs(piece, mark)?);
    }
    let unit = unit.or_else(|| items.last().map(|last| last.quantity.unit));
    if let Some(unit) = unit {
        items
            .iter_mut()
            .filter(|item| item.quantity.unit.is_one())
            .for_each(|item| item.quantity.unit = unit);
    }
    Ok(items)
}

/// The number that an item of a list is, or the two that it is with `±`.
fn both_signs(piece: &str, mark: DecimalMark) -> Result<Vec<Number>, String> {
    let value = after_equals(piece);
    if is_followed_by_name(piece, mark) {
        return Err(format!(
            "At `{piece}`: separate the numbers by semicolons, as in `5; 8.7`."
        ));
    }
    let size = ["±", "+-", "+/-", "\\pm"]
        .iter()
        .find_map(|sign| value.strip_prefix(sign));
    let Some(size) = size else {
        return Ok(vec![number(piece, mark)?]);
    };
    let plus = number(size, mark)?;
    let minus = Number {
        quantity: Quantity::new(plus.quantity.value.negated(), plus.quantity.unit),
        arithmetic: plus.arithmetic.clone().map(|expr| -expr),
    };
    Ok(vec![plus, minus])
}

/// Whether the next name stands behind a number without a separator, `a = 5 b = 8`.
fn is_followed_by_name(piece: &str, mark: DecimalMark) -> bool {
    let sides: Vec<&str> = piece.split('=').collect();
    sides.len() > 2
        && sides[1..sides.len() - 1].iter().any(|side| {
            let parts = side.trim().rsplit_once(char::is_whitespace);
            parts.is_some_and(|(number, name)| {
                name.starts_with(char::is_alphabetic)
                    && Quantity::read(number, mark).is_ok()
                    && Quantity::read(side.trim(), mark).is_err()
            })
        })
}

/// Without the brackets around a whole list, and the unit that stands behind them.
fn unframed(text: &str) -> (&str, Option<Unit>) {
    let Some(close) = first_bracket(text) else {
        return (text, None);
    };
    let (inner, behind) = (&text[1..close], text[close + 1..].trim());
    let is_list = || separated(inner, DecimalMark::Point).len() > 1;
    if behind.is_empty() {
        (inner, None)
    } else if behind.starts_with(char::is_alphabetic) && is_list() {
        Unit::read(behind).map_or((text, None), |unit| (inner, Some(unit)))
    } else {
        (text, None)
    }
}

/// Without brackets or dollars around the whole of a number and its unit.
fn unenclosed(text: &str) -> &str {
    let inner = text
        .strip_prefix('$')
        .and_then(|text| text.strip_suffix('$'));
    let text = inner.map_or(text, str::trim);
    match first_bracket(text) {
        Some(close) if close + 1 == text.len() && text.starts_with('(') => text[1..close].trim(),
        _ => text,
    }
}

/// Whether two signs stand before a number.
fn has_two_signs(text: &str) -> bool {
    let is_sign = |char: char| "+-−–±∓".contains(char);
    let mut signs = text.chars().filter(|char| !char.is_whitespace());
    signs.next().is_some_and(is_sign) && signs.next().is_some_and(is_sign)
}

/// What stands behind the last equals sign, or behind a name with a colon; the last that has a number in it.
fn after_equals(response: &str) -> &str {
    let has_number = |side: &&str| {
        side.contains(|char: char| char.is_ascii_digit() || "π∞½¼¾√".contains(char))
            || side.contains("pi")
    };
    let sides = || response.rsplit(['=', '≈']).map(str::trim);
    let value = sides().next().filter(has_number).or_else(|| {
        sides().find(|side| has_number(side) && !side.starts_with(char::is_alphabetic))
    });
    let value = value.or_else(|| sides().next()).unwrap_or(response);
    match value.split_once(':') {
        Some((name, value)) if name.starts_with(char::is_alphabetic) => value.trim(),
        _ => value,
    }
}

/// Cut at semicolons, at the words `and` and `or`, or at commas that cannot be decimal signs; none in brackets.
fn separated(text: &str, mark: DecimalMark) -> Vec<&str> {
    let all = Span::new(0, text.len());
    if text.contains(';') {
        return kept(
            cut(text, all, &[';'])
                .into_iter()
                .map(|place| &text[place.range()]),
        );
    }
    let pieces = text
        .split(" and ")
        .flat_map(|piece| piece.split(" or "))
        .collect::<Vec<_>>();
    // Between spaced commas or words, a comma between digits is a decimal sign.
    let needs_space = mark == DecimalMark::Comma || text.contains(", ") || pieces.len() > 1;
    kept(
        pieces
            .into_iter()
            .flat_map(|piece| at_commas(piece, needs_space)),
    )
}

/// The pieces of a text between commas outside of brackets, or between those with a space behind.
fn at_commas(text: &str, needs_space: bool) -> Vec<&str> {
    let (mut pieces, mut start) = (Vec::new(), 0);
    for place in cut(text, Span::new(0, text.len()), &[',']) {
        let end = place.range().end;
        if end == text.len() || !needs_space || text[end + 1..].starts_with(' ') {
            pieces.push(&text[start..end]);
            start = end + 1;
        }
    }
    pieces
}

fn kept<'t>(pieces: impl Iterator<Item = &'t str>) -> Vec<&'t str> {
    let pieces = pieces.map(str::trim);
    pieces.filter(|piece| !piece.is_empty()).collect()
}

fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().chain(letters).collect()
    })
}
