//! Arithmetic instead of a decimal: `1/3`, `2*pi rad/s`, `sqrt(2)/2 m`, `3 - 4i ohm`.
//!
//! What is read is a formula of numbers alone with a unit behind it. The unit is the shortest end of the text
//! before which a formula stands: `3/4 m/s` is three quarters of a metre per second, `1/2 m` half a metre.
//! What might be something else is asked back: `19-21` may be a range, `2e` may lack its exponent.

use std::sync::LazyLock;

use super::super::{Example, Unreadable, Why};
use super::doubt::{short, trailing_number};
use crate::expr::{Constant, Expr, Kind, Operator, Precise, Program, Slots, Value, Workspace};
use crate::response::{self, Lexicon, Manner, Trouble, Typed, TypedError};
use crate::unit::{DecimalMark, Unit};

/// Longest text that is read, in bytes.
pub(super) const LONGEST: usize = 200;

/// Functions and constants, but no names.
static NUMBERS: LazyLock<Lexicon> = LazyLock::new(Lexicon::new);

/// A formula of numbers with the unit behind it.
#[derive(Clone, Debug)]
pub(super) struct Arithmetic {
    pub(super) expr: Expr,
    pub(super) unit: Option<Unit>,
}

/// Whether a text has more than a decimal and a unit: an operator, a root, a constant.
pub(super) fn is_arithmetic(text: &str) -> bool {
    let has_word = [
        "pi", "sqrt", "sin", "cos", "tan", "exp", "ln", "log", "frac",
    ]
    .iter()
    .any(|word| text.contains(word));
    has_word || text.contains(|sign: char| "+*/⁄·×⋅÷xX^()√π±∓-−–½¼¾²³⁴⁻".contains(sign))
}

impl Arithmetic {
    /// Reads a formula of numbers and its unit.
    ///
    /// # Errors
    ///
    /// What cannot be read, and why.
    pub(super) fn read(
        text: &str,
        mark: DecimalMark,
        is_complex: bool,
    ) -> Result<Self, Unreadable> {
        if text.len() > LONGEST {
            return Err(Why::TooLong.into());
        }
        let plain = plain(text);
        let text = plain.as_str();
        let manner = Manner {
            comma_is_decimal: mark == DecimalMark::Comma || !has_arguments(text),
            has_imaginary_unit: is_complex,
        };
        let formula = |text: &str| response::formula(text, &NUMBERS, manner);
        if let Some(angle) = Self::in_degrees(text, formula) {
            return angle.checked(text);
        }
        let mut error = match formula(text) {
            Ok(typed) => {
                return Self {
                    expr: typed.value,
                    unit: None,
                }
                .checked(text);
            }
            Err(error) => error,
        };
        for (number, unit) in response::with_unit(text) {
            match formula(number) {
                Ok(typed) => {
                    return Self {
                        expr: typed.value,
                        unit: Some(unit),
                    }
                    .checked(number);
                }
                // What sticks at the unit sticks before it.
                Err(before) if error.span.range().start >= number.len() => error = before,
                Err(_) => {}
            }
        }
        let place = short(text.get(error.span.range()).unwrap_or_default());
        Err(match error.trouble {
            Trouble::Unknown { .. } | Trouble::NotAllowed(_) if !place.is_empty() => {
                Unreadable::at(place, Why::Letters)
            }
            Trouble::Unit => Unreadable::at(place, Why::UnitNotLast),
            Trouble::Unknown { .. } | Trouble::NotAllowed(_) => Why::Form.into(),
            _ => error.remark(text),
        }
        .like(Example::UnitLast))
    }

    /// Arithmetic with degrees as its last sign, `397.4/2°` and `-180 + 18.7 deg`; where another number has
    /// its own, or π tells that it is in radians, the sign belongs to the last number alone.
    fn in_degrees(
        text: &str,
        formula: impl Fn(&str) -> Result<Typed<Expr>, TypedError>,
    ) -> Option<Self> {
        const SIGNS: [&str; 6] = ["°", "degrees", "degree", "deg", "^\\circ", "^{\\circ}"];
        let number = SIGNS
            .iter()
            .find_map(|sign| text.trim().strip_suffix(sign))?;
        let expr = formula(number).ok()?.value;
        let mut is_bare = true;
        expr.walk(&mut |node| {
            is_bare &= !matches!(
                node.kind(),
                Kind::Measure(..) | Kind::Constant(Constant::Pi)
            );
        });
        is_bare.then(|| Self {
            expr,
            unit: Unit::parse("deg").ok(),
        })
    }

    /// Refuses what might be meant otherwise; an angle in degrees is one in radians.
    fn checked(mut self, text: &str) -> Result<Self, Unreadable> {
        let (mut bare, mut powers, mut has_infinity) = (0, 0, false);
        self.expr.walk(&mut |node| match node.kind() {
            Kind::Constant(Constant::E) => bare += 1,
            Kind::Constant(Constant::Infinity) => has_infinity = true,
            Kind::Binary(Operator::Power, base, _)
                if *base.kind() == Kind::Constant(Constant::E) =>
            {
                powers += 1;
            }
            _ => {}
        });
        if bare > powers {
            return Err(Why::ExponentMissing(text.trim().to_owned()).into());
        }
        if has_infinity {
            return Err(Unreadable::of(Why::Form).like(Example::UnitLast));
        }
        if let Kind::Binary(Operator::Subtract, a, b) = self.expr.kind() {
            let is_plain = |side: &Expr| {
                side.as_number().is_some() || matches!(side.kind(), Kind::Measure(..))
            };
            let text = text.trim();
            if is_plain(a) && is_plain(b) && !text.contains([' ', '(']) {
                return Err(Why::RangeOrDifference(text.to_owned()).into());
            }
        }
        if mixes_degrees(&self.expr) {
            return Err(Why::MixedDegrees.into());
        }
        if is_in_degrees(&self.expr) {
            match self.unit {
                None => self.unit = Unit::parse("rad").ok(),
                Some(_) => return Err(Unreadable::of(Why::TwoUnits).like(Example::UnitLast)),
            }
        }
        Ok(self)
    }

    /// The value, if there is one.
    pub(super) fn value(&self) -> Option<Value> {
        let program = Program::compile(&self.expr, &Slots(&[])).ok()?;
        let none: [Precise; 0] = [];
        program.evaluate(&none, &mut Workspace::default()).ok()
    }
}

/// Whether an angle in degrees is added to a number without a unit; with π it is one in radians.
fn mixes_degrees(expr: &Expr) -> bool {
    let mut is_mixed = false;
    expr.walk(&mut |node| {
        if let Kind::Binary(Operator::Add | Operator::Subtract, left, right) = node.kind() {
            let is_bare = |side: &Expr| !is_in_degrees(side) && !has_pi(side);
            is_mixed |=
                is_in_degrees(left) && is_bare(right) || is_bare(left) && is_in_degrees(right);
        }
    });
    is_mixed
}

/// Whether π stands in a formula.
pub(super) fn has_pi(expr: &Expr) -> bool {
    let mut is_there = false;
    expr.walk(&mut |node| is_there |= *node.kind() == Kind::Constant(Constant::Pi));
    is_there
}

/// With small letters for π, and `×` for the letter between two numbers.
fn plain(text: &str) -> String {
    let text = text.replace("Pi", "pi").replace("PI", "pi");
    let is_digit = |char: char| char.is_ascii_digit();
    let crossed = text.char_indices().map(|(at, char)| {
        let is_between = || {
            !matches!(trailing_number(text[..at].trim_end()), "" | "0")
                && text[at + 1..].trim_start().starts_with(is_digit)
        };
        if matches!(char, 'x' | 'X') && is_between() {
            '×'
        } else {
            char
        }
    });
    crossed.collect()
}

/// Whether a text calls a function of several numbers.
fn has_arguments(text: &str) -> bool {
    ["atan2", "hypot", "min", "max"]
        .iter()
        .any(|name| text.contains(&format!("{name}(")))
}

/// Whether a value is an angle in degrees; one that stands in a function or exponent leaves no unit.
fn is_in_degrees(expr: &Expr) -> bool {
    match expr.kind() {
        Kind::Measure(..) => true,
        Kind::Negate(inner) => is_in_degrees(inner),
        Kind::Binary(Operator::Power, base, _) => is_in_degrees(base),
        Kind::Binary(_, left, right) => is_in_degrees(left) || is_in_degrees(right),
        _ => false,
    }
}
