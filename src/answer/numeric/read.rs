//! Numbers with units as people type them.

use super::arithmetic::{Arithmetic, is_arithmetic};
use crate::expr::{Expr, PlainNotation};
use crate::math::Math;
use crate::unit::{Decimal, DecimalMark, ErrorKind, Quantity};

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
    let value = after_equals(response);
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

/// The items of a list; a unit at the end of the last one serves for all that have none.
pub(super) fn list(response: &str, mark: DecimalMark) -> Result<Vec<Number>, String> {
    const MOST_ITEMS: usize = 100;
    const LONGEST: usize = 2_000;
    if response.len() > LONGEST {
        return Err("This is too long to be read.".to_owned());
    }
    let inner = after_equals(response)
        .trim_matches(|sign: char| sign.is_whitespace() || "[]{}".contains(sign));
    let inner = unwrapped(inner);
    let pieces = separated(inner, mark);
    if pieces.len() > MOST_ITEMS {
        return Err(format!("A list has at most {MOST_ITEMS} numbers."));
    }
    let mut items = pieces
        .into_iter()
        .map(|piece| number(piece, mark))
        .collect::<Result<Vec<_>, _>>()?;
    if let Some(unit) = items.last().map(|last| last.quantity.unit) {
        items
            .iter_mut()
            .filter(|item| item.quantity.unit.is_one())
            .for_each(|item| item.quantity.unit = unit);
    }
    Ok(items)
}

/// Without the round brackets around the whole list.
fn unwrapped(text: &str) -> &str {
    let inner = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let is_one_pair = |inner: &&str| {
        let mut depth = 0_i32;
        inner.chars().all(|char| {
            depth += match char {
                '(' => 1,
                ')' => -1,
                _ => 0,
            };
            depth >= 0
        })
    };
    inner.filter(is_one_pair).unwrap_or(text)
}

/// What stands behind the last equals sign.
fn after_equals(response: &str) -> &str {
    let value = response.rsplit(['=', '≈']).next().unwrap_or(response);
    let value = value.trim();
    // The dollar signs around LaTeX; those before an equals sign leave one behind.
    let inner = value.strip_prefix('$').unwrap_or(value);
    let has_closing = inner.len() < value.len() || response.trim_start().starts_with('$');
    match inner.strip_suffix('$') {
        Some(inner) if has_closing => inner.trim(),
        _ => value,
    }
}

/// Cut at semicolons, at the words `and` and `or`, or at commas that cannot be decimal signs.
fn separated(text: &str, mark: DecimalMark) -> Vec<&str> {
    if text.contains(';') {
        return kept(text.split(';'));
    }
    let pieces = text
        .split(" and ")
        .flat_map(|piece| piece.split(" or "))
        .collect::<Vec<_>>();
    // Between spaced commas or words, a comma between digits is a decimal sign.
    let comma = if mark == DecimalMark::Comma || text.contains(", ") || pieces.len() > 1 {
        ", "
    } else {
        ","
    };
    kept(pieces.into_iter().flat_map(|piece| piece.split(comma)))
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
