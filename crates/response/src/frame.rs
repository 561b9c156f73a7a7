//! What stands around a list: a symbol before it, a factor or divisor, a sign of transposition, a unit.

use super::before_unit::{gathered, with_unit};
use super::letters::greek_word;
use super::list::{Reader, Wanted};
use super::signs::{is_digit, is_of_name};
use super::words::MODULES;
use super::{Trouble, TypedError};
use vibank_formula::expr::{Expr, Kind, Operator};
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// What stands around a list.
pub(crate) struct Frame {
    /// What multiplies all entries.
    pub(crate) factor: Option<Expr>,
    pub(crate) is_transposed: bool,
    /// Whether `diag` stands before it.
    pub(crate) is_diagonal: bool,
    pub(crate) unit: Option<Unit>,
}

impl Reader<'_> {
    /// What stands in a piece around the list in it.
    pub(crate) fn frame(&self, piece: Span, list: Span) -> Result<Frame, TypedError> {
        let (start, end, list) = (piece.range().start, piece.range().end, list.range());
        let before = self.text[..list.start].trim_end();
        let plain = without_diagonal(before);
        let is_diagonal = plain.len() < before.len();
        let plain = self.without_free_factor(plain, start);
        let after = self.text[list.end..end].trim_start();
        let behind = without_transposition(after);
        // The text with a one in place of the list, all else where it was.
        let mut rest = plain.to_owned();
        pad(&mut rest, list.start);
        rest.push_str("(1");
        pad(&mut rest, list.end - 1);
        rest.push(')');
        pad(&mut rest, end - behind.len());
        rest.push_str(behind);
        let (factor, unit) = self.factor_and_unit(&rest, start, list)?;
        Ok(Frame {
            factor,
            is_transposed: behind.len() < after.len(),
            is_diagonal,
            unit,
        })
    }

    /// What stands before a list, without a letter that is not a name where a factor is free.
    fn without_free_factor<'t>(&self, before: &'t str, start: usize) -> &'t str {
        let Some(own) = before
            .get(start..)
            .filter(|_| self.wanted == Wanted::Direction)
        else {
            return before;
        };
        let own = without_times(own).trim_end();
        let mut chars = own.chars();
        // `transpose` is not a letter.
        let letter = own.split('_').next().unwrap_or(own);
        let letter = letter.trim_end_matches(is_digit);
        let is_letter =
            letter.chars().count() == 1 || greek_word(letter.trim_start_matches('\\')).is_some();
        let is_factor = is_letter
            && chars.all(|char| is_of_name(char) || "{}\\".contains(char))
            && self.formula_in(own, Span::new(0, own.len())).is_err();
        if is_factor { &before[..start] } else { before }
    }

    /// The factor and the unit of a list in whose place a one stands. Letters that are both are a unit where it fits
    /// what is asked, else symbols.
    fn factor_and_unit(
        &self,
        rest: &str,
        start: usize,
        list: std::ops::Range<usize>,
    ) -> Result<(Option<Expr>, Option<Unit>), TypedError> {
        let one = list.start + 1;
        let factor = |rest: &str| {
            let whole = self.formula_in(rest, Span::new(start, rest.len()))?;
            let mut readings = [whole.value].into_iter().chain(whole.others);
            let factor = readings.find_map(|whole| cofactor(&whole, one));
            factor.ok_or(TypedError::new(Trouble::LeftOver, start, rest.len()))
        };
        let units = units_around(rest, start, list);
        let beside = |(place, unit): &(Span, Unit)| {
            let mut bare = rest.to_owned();
            bare.replace_range(place.range(), &" ".repeat(place.range().len()));
            Some((factor(&bare).ok()?, Some(*unit)))
        };
        let mut own = units.iter().filter(|(_, unit)| self.is_asked(unit));
        let found = match own.find_map(beside) {
            Some(found) => found,
            None => match factor(rest) {
                Ok(factor) => (factor, None),
                Err(error) => units.iter().find_map(beside).ok_or(error)?,
            },
        };
        let is_one = found.0.as_number() == Some(vibank_dynamics::numerics::Rational::ONE);
        Ok((Some(found.0).filter(|_| !is_one), found.1))
    }
}

/// The places that may be a unit before or after a list, the longest after it first.
fn units_around(rest: &str, start: usize, list: std::ops::Range<usize>) -> Vec<(Span, Unit)> {
    let behind = &rest[list.end..];
    let whole = behind.trim().trim_start_matches(TIMES).trim();
    let whole = whole.strip_prefix("in ").unwrap_or(whole);
    let whole = whole.trim_matches(['[', ']']).trim();
    let mut units = Vec::new();
    if let Some(unit) = Unit::read(whole).ok().filter(|_| !whole.is_empty()) {
        units.push((Span::new(list.end, rest.len()), gathered(unit)));
    }
    for (formula, unit) in with_unit(behind) {
        let formula = without_times(formula);
        units.push((Span::new(list.end + formula.len(), rest.len()), unit));
    }
    let before = without_times(&rest[start..list.start]);
    for (formula, unit) in with_unit(before) {
        units.push((Span::new(start + formula.len(), start + before.len()), unit));
    }
    units
}

/// What a formula multiplies the one at a place by; `None` where it is not a multiple of it.
fn cofactor(formula: &Expr, one: usize) -> Option<Expr> {
    match formula.kind() {
        Kind::Number(_) if formula.span().range().start == one => Some(Expr::number(1)),
        Kind::Negate(inner) => Some(-cofactor(inner, one)?),
        Kind::Binary(Operator::Multiply, left, right) => match cofactor(left, one) {
            Some(left) => Some(left * right.clone()),
            None => Some(left.clone() * cofactor(right, one)?),
        },
        Kind::Binary(Operator::Divide, left, right) => Some(cofactor(left, one)? / right.clone()),
        _ => None,
    }
}

fn pad(text: &mut String, length: usize) {
    while text.len() < length {
        text.push(' ');
    }
}

const TIMES: char = '*';

fn without_times(text: &str) -> &str {
    text.trim_end().trim_end_matches(TIMES)
}

/// A sum of vectors without the signs that make columns of them, `(1, 2)^T cos(2t) + …`; all places stay.
pub(crate) fn without_transpositions(text: &str) -> String {
    let mut plain = text.to_owned();
    for sign in RAISED {
        for bracket in [')', ']', '}'] {
            let from = format!("{bracket}{sign}");
            plain = plain.replace(&from, &format!("{bracket:<0$}", 1 + sign.len()));
        }
    }
    plain
}

/// Signs of transposition that can be nothing else.
const RAISED: &[&str] = &[
    "^{\\mathrm{T}}",
    "^{\\mathrm T}",
    "^\\mathrm{T}",
    "^\\mathsf{T}",
    "^{\\top}",
    "^\\top",
    "^\\intercal",
    "^{T}",
    "^T",
    "ᵀ",
];

/// Signs of transposition after a list or its name alone: after a number `^t` is an exponent.
const BEHIND_LISTS: &[&str] = &["^t", ".transpose()", ".T"];

/// What follows a sign of transposition, `^T` or `'`.
fn without_transposition(text: &str) -> &str {
    let mut signs = RAISED.iter().chain(BEHIND_LISTS).chain(&["'"]);
    let rest = signs.find_map(|sign| text.strip_prefix(sign));
    rest.map_or(text, str::trim_start)
}

/// Whether what stands before an equals sign names the transpose of what is asked, `K^T =`.
pub(crate) fn is_transposed_name(label: &str) -> bool {
    let name = label.trim_end_matches(['=', ':', '≈', ' ']);
    let mut signs = RAISED.iter().chain(BEHIND_LISTS);
    signs.any(|sign| name.ends_with(sign))
}

/// What stands before the name of the function that makes a diagonal matrix of a list.
fn without_diagonal(before: &str) -> &str {
    const NAMES: [&str; 5] = [
        "\\operatorname{diag}",
        "\\mathrm{diag}",
        "\\text{diag}",
        "DiagonalMatrix",
        "diag",
    ];
    match NAMES.iter().find_map(|name| before.strip_suffix(name)) {
        Some(rest) => without_module(rest.strip_suffix('\\').unwrap_or(rest)),
        None => before,
    }
}

/// What stands before the name of a module of Python.
pub(crate) fn without_module(before: &str) -> &str {
    /// Of matrices alone.
    const OF_MATRICES: [&str; 2] = ["Matrix.", "la."];
    let mut rest = before;
    let modules = MODULES.iter().chain(&OF_MATRICES);
    while let Some(own) = modules.clone().find_map(|module| rest.strip_suffix(module)) {
        rest = own;
    }
    rest
}

/// The brackets that stand in no other in a part of a text, each with what it holds.
pub(crate) fn groups(text: &str, span: Span) -> Vec<Span> {
    let (mut groups, mut depth, mut start) = (Vec::new(), 0_usize, 0);
    for (at, char) in text[span.range()].char_indices() {
        let at = span.range().start + at;
        match char {
            '(' | '[' | '{' => {
                start = if depth == 0 { at } else { start };
                depth += 1;
            }
            ')' | ']' | '}' if depth > 0 => {
                depth -= 1;
                if depth == 0 {
                    groups.push(Span::new(start, at + 1));
                }
            }
            _ => {}
        }
    }
    groups
}

/// Whether the bracket with which a text begins is closed by this one.
fn are_partners(text: &str, close: char) -> bool {
    let open = match close {
        ')' => '(',
        ']' => '[',
        _ => '{',
    };
    text.starts_with(open)
}

/// What is wrong where a bracket has no partner.
pub(crate) fn balanced(text: &str) -> Result<(), TypedError> {
    let mut open = Vec::new();
    for (at, char) in text.char_indices() {
        let alone = match char {
            '(' | '[' | '{' => {
                open.push(at);
                false
            }
            // `[1, 2)` is a range of numbers, and no list.
            ')' | ']' | '}' => open
                .pop()
                .is_none_or(|own| !are_partners(&text[own..], char)),
            _ => false,
        };
        if alone {
            return Err(TypedError::new(Trouble::Bracket, at, at + 1));
        }
    }
    match open.first() {
        Some(at) => Err(TypedError::new(Trouble::Bracket, *at, at + 1)),
        None => Ok(()),
    }
}
