//! Numbers with units as people type them.

use super::super::{Example, Unreadable, Why};
use super::arithmetic::{Arithmetic, is_arithmetic};
use super::doubt::{question, short};
use super::sides::{self, Sides};
use crate::expr::{Expr, PlainNotation};
use crate::math::Math;
use crate::response::first_bracket;
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

/// The number that a response is, beside its name and what it is said to equal.
///
/// # Errors
///
/// What cannot be read, and why.
pub(super) fn number(response: &str, mark: DecimalMark) -> Result<Number, Unreadable> {
    if sides::is_alone(response) {
        return alone(response, mark);
    }
    let response = sides::plain(response);
    let sides = Sides::of(&response)?;
    let number = alone(sides.value(), mark)?;
    sides.check(&number, mark, |side| alone(side, mark).ok())?;
    Ok(number)
}

/// The number that a text is.
fn alone(text: &str, mark: DecimalMark) -> Result<Number, Unreadable> {
    let value = unenclosed(unmarked(text));
    if has_two_signs(value) {
        return Err(Why::TwoSigns(short(value)).into());
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
    if let Some(question) = question(value, mark) {
        return Err(question);
    }
    let is_plain = matches!(
        error.kind,
        ErrorKind::AmbiguousComma { .. } | ErrorKind::TooLong { .. } | ErrorKind::OutOfRange
    );
    if is_plain || !is_arithmetic(value) {
        return Err(explained(value, &error));
    }
    computed(value, mark).or_else(|words| {
        summed(value, mark).ok_or_else(|| {
            // A decimal with a unit that cannot be read is told by its unit.
            if is_number_then_unit(value, mark) {
                explained(value, &error)
            } else {
                words
            }
        })
    })
}

/// The quantity that a response is.
///
/// # Errors
///
/// As for [`number`].
pub(crate) fn quantity(response: &str, mark: DecimalMark) -> Result<Quantity, Unreadable> {
    number(response, mark).map(|number| number.quantity)
}

/// What arithmetic comes to.
fn computed(text: &str, mark: DecimalMark) -> Result<Number, Unreadable> {
    let arithmetic = Arithmetic::read(text, mark, false)?;
    let value = arithmetic.value().and_then(|value| value.as_real());
    let decimal = value.and_then(Decimal::shortest);
    let decimal = decimal.ok_or_else(|| Why::NoValue(short(text)))?;
    let unit = arithmetic.unit.unwrap_or(Unit::ONE);
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

fn explained(value: &str, error: &crate::unit::Error) -> Unreadable {
    if let Some(counted) = counted(value) {
        return Why::Counted(counted.to_owned()).into();
    }
    let place = value
        .get(error.span.clone())
        .filter(|place| !place.is_empty() && *place != value);
    let why = Why::Quantity(error.clone());
    let unreadable = match place {
        Some(place) => Unreadable::at(short(place), why),
        None => why.into(),
    };
    if error.help().is_some() {
        unreadable
    } else {
        unreadable.like(Example::Number)
    }
}

/// The sum of several numbers that have their own units, `50 N/m + 25 N/m`, in the unit of the first.
fn summed(text: &str, mark: DecimalMark) -> Option<Number> {
    let is_spaced = |at: usize| text[..at].ends_with(' ');
    let mut terms = Vec::new();
    let (mut start, mut is_less) = (0, false);
    for (at, char) in text.char_indices().chain([(text.len(), '+')]) {
        if "+-−–".contains(char) && (at == text.len() || at > 0 && is_spaced(at)) {
            let term = Quantity::read(text[start..at].trim_end(), mark).ok()?;
            terms.push((is_less, term));
            (start, is_less) = (at + char.len_utf8(), char != '+');
        }
    }
    let unit = terms.first()?.1.unit;
    let mut sum = 0.0;
    for (is_less, term) in &terms {
        let has_unit = !unit.is_one() && !term.unit.is_one();
        let value = unit.of_si(term.si_for(&unit).ok().filter(|_| has_unit)?);
        sum += if *is_less { -value } else { value };
    }
    let quantity = Quantity::new(Decimal::shortest(sum)?, unit);
    (terms.len() > 1).then_some(Number {
        quantity,
        arithmetic: None,
    })
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

/// Without marks behind a number: the end of a sentence, and the sign of a number that has no unit.
fn unmarked(text: &str) -> &str {
    let text = text.trim();
    let text = match text.strip_suffix('.') {
        Some(rest) if rest.contains('.') => rest,
        _ => text,
    };
    ["[-]", "(-)", "[–]", "[1]"]
        .iter()
        .find_map(|sign| text.strip_suffix(sign))
        .map_or(text, str::trim_end)
}

/// The word for what is counted, behind a number: `2 periods`.
fn counted(value: &str) -> Option<&str> {
    const WORDS: [&str; 16] = [
        "period",
        "periods",
        "oscillation",
        "oscillations",
        "vibrations",
        "swings",
        "times",
        "dof",
        "dofs",
        "degree of freedom",
        "degrees of freedom",
        "half-cycles",
        "half cycles",
        "modes",
        "coordinates",
        "positions",
    ];
    let word = value.trim_start_matches(|char: char| !char.is_alphabetic());
    WORDS
        .contains(&word.to_lowercase().as_str())
        .then_some(word)
}
