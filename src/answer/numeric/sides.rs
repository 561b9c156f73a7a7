//! What stands beside a value: a name and an equals sign, `ω = 7.78 rad/s`, or a chain of what is equal,
//! `ω = sqrt(60.5) = 7.78 rad/s`.

use std::borrow::Cow;

use super::super::{Example, Unreadable, Why};
use super::doubt::short;
use super::read::Number;
use crate::response::{cut, first_bracket};
use crate::source::Span;
use crate::unit::{DecimalMark, Quantity, Unit};

/// The parts of a chain of equal sides.
pub(super) struct Sides<'t> {
    all: Vec<&'t str>,
    value: usize,
}

/// Whether a response has no sign that parts sides.
pub(super) fn is_alone(response: &str) -> bool {
    let parts = |char| {
        matches!(
            char,
            '=' | ':'
                | '<'
                | '>'
                | '≤'
                | '≥'
                | '≠'
                | '⩽'
                | '≈'
                | '≃'
                | '≅'
                | '≐'
                | '≡'
                | '\\'
        )
    };
    !response.contains(parts)
}

/// One sign for all that says equal, nearly so, or by definition.
pub(super) fn plain(response: &str) -> Cow<'_, str> {
    const EQUAL: [&str; 9] = ["\\approx", "\\simeq", ":=", "==", "≈", "≃", "≅", "≐", "≡"];
    if EQUAL.iter().any(|sign| response.contains(sign)) {
        let each = |text: String, sign: &&str| text.replace(sign, "=");
        Cow::Owned(EQUAL.iter().fold(response.to_owned(), each))
    } else {
        Cow::Borrowed(response)
    }
}

impl<'t> Sides<'t> {
    /// Cuts a response at its equals signs.
    ///
    /// # Errors
    ///
    /// What to type instead of an inequality.
    pub(super) fn of(response: &'t str) -> Result<Self, Unreadable> {
        if let Some(sign) = unequal(response) {
            return Err(Unreadable::at(sign, Why::Inequality).like(Example::OneValue));
        }
        let mut all = equal_sides(response);
        if let Some((name, value)) = all.last().and_then(|last| last.split_once(':'))
            && is_name(name)
        {
            all.pop();
            all.extend([name.trim(), value.trim()]);
        }
        let has_number = |side: &str| {
            side.contains(|char: char| char.is_ascii_digit() || "π∞½¼¾√".contains(char))
                || side.contains("pi")
        };
        let value = all
            .iter()
            .rposition(|side| has_number(side) && !is_name(side));
        let value = value.unwrap_or(all.len() - 1);
        Ok(Self { all, value })
    }

    /// The last side that is a value.
    pub(super) fn value(&self) -> &'t str {
        self.all[self.value]
    }

    /// The name that is given to the value; empty without one.
    pub(super) fn name(&self) -> &'t str {
        let first = self.all[0];
        if is_name(first) { first } else { "" }
    }

    /// Checks that the other sides are names, the same number, or formulas between a name and the value.
    ///
    /// # Errors
    ///
    /// Which side is something else, and what to type instead.
    pub(super) fn check(
        &self,
        number: &Number,
        mark: DecimalMark,
        read: impl Fn(&str) -> Option<Number>,
    ) -> Result<(), Unreadable> {
        if let Some(unit) = unit_of(self.name()).filter(|_| number.quantity.unit.is_one()) {
            return Err(Why::UnitBesideName {
                value: short(self.value()),
                unit: unit.to_owned(),
            }
            .into());
        }
        let others = self.all.iter().enumerate();
        for (at, side) in others.filter(|(at, side)| *at != self.value && !is_name(side)) {
            let is_between = 0 < at && at < self.value && is_name(self.all[0]);
            match read(side) {
                Some(other) if are_equal(number, &other) => {}
                Some(_) => {
                    return Err(Why::UnequalSides(short(side), short(self.value())).into());
                }
                None if is_between && !has_several(side, mark) => {}
                None => {
                    return Err(Unreadable::at(short(side), Why::UnclearSide));
                }
            }
        }
        Ok(())
    }
}

/// The sides of the equals signs outside of brackets, at least one.
pub(super) fn equal_sides(response: &str) -> Vec<&str> {
    let places = cut(response, Span::new(0, response.len()), &['=']);
    let mut sides: Vec<&str> = places
        .into_iter()
        .map(|place| response[place.range()].trim())
        .filter(|side| !side.is_empty())
        .collect();
    if sides.is_empty() {
        sides.push("");
    }
    sides
}

/// A sign for what is not equal.
fn unequal(response: &str) -> Option<&'static str> {
    const SIGNS: [&str; 17] = [
        "<=", ">=", "=<", "=>", "!=", "=/=", "/=", "not =", "\\leq", "\\geq", "\\neq", "<", ">",
        "≤", "≥", "≠", "⩽",
    ];
    SIGNS.into_iter().find(|sign| response.contains(sign))
}

/// Whether a side only names a quantity: `ω_0`, `x(0.5 s)`, `natural frequency`.
pub(super) fn is_name(side: &str) -> bool {
    const FUNCTIONS: [&str; 19] = [
        "sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "asin", "acos", "atan", "arcsin",
        "arccos", "arctan", "sqrt", "exp", "ln", "log", "frac", "pi",
    ];
    let side = side.trim().trim_end_matches('~').trim_end();
    let letters = side.strip_prefix('\\').unwrap_or(side);
    let word = letters
        .split(|char: char| !char.is_ascii_alphabetic())
        .next();
    let begins = side.starts_with(|char: char| char.is_alphabetic() || "\\|∠".contains(char))
        && !side.starts_with('π')
        && !word.is_some_and(|word| FUNCTIONS.contains(&word.to_ascii_lowercase().as_str()));
    let mut depth = 0_usize;
    begins
        && side.chars().all(|char| {
            match char {
                '(' | '{' => depth += 1,
                ')' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth > 0 || !"+-−–*·×⋅∙/÷⁄^√⁰¹²³⁴⁵⁶⁷⁸⁹⁻½¼¾°%,;[".contains(char)
        })
}

/// The unit that stands beside a name, `f (Hz)` and `φ in deg`; one letter may be an argument.
fn unit_of(name: &str) -> Option<&str> {
    let behind = name.rsplit_once(" in ").map(|(_, unit)| unit);
    let within = || {
        name.strip_suffix(')')?
            .rsplit_once('(')
            .map(|(_, unit)| unit)
    };
    let unit = behind.or_else(within)?.trim();
    (unit.len() > 1 && Unit::read(unit).is_ok()).then_some(unit)
}

/// The names that a text lists, `ω1, ω2`, alone or in brackets; nothing if it is something else.
pub(super) fn names(text: &str) -> Option<Vec<&str>> {
    let text = text.trim();
    let inner = match first_bracket(text) {
        Some(close) if close + 1 == text.len() => &text[1..close],
        _ => text,
    };
    let places = cut(inner, Span::new(0, inner.len()), &[',', ';']);
    let names: Vec<&str> = places
        .into_iter()
        .flat_map(|place| inner[place.range()].split(" and "))
        .map(str::trim)
        .collect();
    // `ω1,2` has two.
    let is_number = |name: &str| name.bytes().all(|byte| byte.is_ascii_digit());
    let is_listed = |name: &&str| is_name(name) || !name.is_empty() && is_number(name);
    (is_name(names[0]) && names.iter().all(is_listed)).then_some(names)
}

/// The number in the index of a name, `2` of `ω_2`.
pub(super) fn index(name: &str) -> Option<u32> {
    let name = name.trim_end_matches('}');
    let digits: Vec<u32> = name
        .chars()
        .rev()
        .map_while(|char| match char {
            '₀'..='₉' => Some(u32::from(char) - u32::from('₀')),
            _ => char.to_digit(10),
        })
        .collect();
    let value = |sum: u32, digit: &u32| sum.checked_mul(10)?.checked_add(*digit);
    let whole = digits.iter().rev().try_fold(0, value);
    whole.filter(|_| !digits.is_empty())
}

/// Whether a side holds more than one statement: `9, k`, or `9 k` before another equals sign.
fn has_several(side: &str, mark: DecimalMark) -> bool {
    let is_list = cut(side, Span::new(0, side.len()), &[',', ';']).len() > 1;
    is_list || ends_with_name(side, mark)
}

/// Whether a name stands behind a number with its unit, `5 m b`.
pub(super) fn ends_with_name(side: &str, mark: DecimalMark) -> bool {
    let parts = side.trim().rsplit_once(char::is_whitespace);
    parts.is_some_and(|(number, name)| {
        name.starts_with(char::is_alphabetic)
            && Quantity::read(number, mark).is_ok()
            && Quantity::read(side.trim(), mark).is_err()
    })
}

/// Whether two numbers differ by no more than their rounding.
fn are_equal(one: &Number, other: &Number) -> bool {
    const SHARE: f64 = 0.01;
    let last_place = |number: &Number| match &number.arithmetic {
        Some(_) => 0.0,
        None => number.quantity.value.last_place().to_f64(),
    };
    let are_near =
        |a: f64, b: f64, places: f64| (a - b).abs() <= SHARE * a.abs().max(b.abs()) + 0.5 * places;
    let (a, b) = (&one.quantity, &other.quantity);
    let (place, other_place) = (last_place(one), last_place(other));
    let are_bare = a.unit.is_one() || b.unit.is_one();
    let is_same_number = || are_near(a.value.to_f64(), b.value.to_f64(), place.max(other_place));
    are_bare && is_same_number()
        || b.conversion(&a.unit).is_ok_and(|conversion| {
            let places = a.unit.to_si(place).max(conversion.apply(other_place));
            are_near(a.si(), conversion.apply_decimal(&b.value), places)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_told_from_formulas() {
        for name in [
            "ω",
            "\\omega_{0}",
            "x(0.5 s)",
            "x'",
            "f_n1",
            "natural frequency",
            "|Z|",
            "T_d",
        ] {
            assert!(is_name(name), "{name}");
        }
        for formula in [
            "2ω",
            "-ω",
            "ω²",
            "ω^2",
            "sqrt(ω)",
            "sin φ",
            "sinφ",
            "φ/2",
            "k m + 1",
            "pi",
            "π",
            "7.78",
            "a, b",
            "\\frac{a}{b}",
            "Log(x)",
        ] {
            assert!(!is_name(formula), "{formula}");
        }
    }

    #[test]
    fn names_have_indices() {
        for (name, number) in [("ω_2", 2), ("ω₁", 1), ("\\omega_{12}", 12), ("f10", 10)] {
            assert_eq!(index(name), Some(number), "{name}");
        }
        assert_eq!(index("ω"), None);
        assert_eq!(names("(ω1, ω2)"), Some(vec!["ω1", "ω2"]));
        assert_eq!(names("ω1,2"), Some(vec!["ω1", "2"]));
        assert_eq!(names("5; ω2"), None);
    }
}
