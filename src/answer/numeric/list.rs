//! Lists of numbers as people type them, and how they are marked: `5; 8.7 rad/s`, `0, ±180°`, `ω1 = 5, ω2 = 8.7`.

use super::super::{Credit, Marking, Remark, Slip, Unreadable, Why};
use super::marker::Numbers;
use super::read::{Number, number};
use super::sides::{self, Sides, index, names};
use super::target::{Typed, pair};
use crate::numerics::Rational;
use crate::response::{cut, first_bracket};
use crate::source::Span;
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

/// The most numbers of a list.
const MOST_ITEMS: usize = 100;
/// The longest list, in bytes.
const LONGEST: usize = 2_000;

/// The numbers of a list where `count` are asked; numbers whose names have indices come in their order. A unit at
/// the end of the last one, or behind the bracket, serves for all that have none.
///
/// # Errors
///
/// What cannot be read, and why.
pub(super) fn list(
    response: &str,
    count: usize,
    mark: DecimalMark,
) -> Result<Vec<Number>, Unreadable> {
    if response.len() > LONGEST {
        return Err(Why::TooLong.into());
    }
    let response = response
        .trim()
        .replace('\n', "; ")
        .replace("\\{", "{")
        .replace("\\}", "}");
    let response = sides::plain(&response);
    // `ω1, ω2 = 5, 8.7` has one equals sign for all, else each number has its own.
    let (labels, all) = match sides::equal_sides(&response)[..] {
        [before, all] if names(before).is_some() => (names(before).unwrap_or_default(), all),
        _ => (Vec::new(), response.trim().trim_start_matches('=')),
    };
    let (inner, unit) = unframed(all);
    let is_framed = inner.len() < all.trim().len();
    let pieces = match separated(inner, mark)[..] {
        [one] if is_framed && are_decimals(one, mark) => one.split_whitespace().collect(),
        _ => separated(inner, mark),
    };
    if pieces.len() > MOST_ITEMS {
        return Err(Why::MostNumbers(MOST_ITEMS).into());
    }
    let mut items: Vec<(Option<u32>, Number)> = Vec::new();
    for piece in &pieces {
        let label = index(Sides::of(piece)?.name());
        items.extend(
            both_signs(piece, mark)?
                .into_iter()
                .map(|item| (label, item)),
        );
    }
    if has_tight_comma(inner, mark) && items.len() != count {
        return Err(Why::TightComma.into());
    }
    if labels.len() == items.len() {
        for (item, label) in items.iter_mut().zip(labels) {
            item.0 = index(label);
        }
    }
    let unit = unit.or_else(|| items.last().map(|(_, last)| last.quantity.unit));
    if let Some(unit) = unit {
        items
            .iter_mut()
            .filter(|(_, item)| item.quantity.unit.is_one())
            .for_each(|(_, item)| item.quantity.unit = unit);
    }
    if items.iter().all(|(label, _)| label.is_some()) {
        items.sort_by_key(|(label, _)| *label);
    }
    Ok(items.into_iter().map(|(_, item)| item).collect())
}

/// The number that an item of a list is, or the two that it is with `±`.
fn both_signs(piece: &str, mark: DecimalMark) -> Result<Vec<Number>, Unreadable> {
    let all = Sides::of(piece)?;
    let size = ["±", "+-", "+/-", "\\pm"]
        .iter()
        .find_map(|sign| all.value().strip_prefix(sign));
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

/// Without the brackets around a whole list, and the unit that stands behind them.
fn unframed(text: &str) -> (&str, Option<Unit>) {
    let Some(close) = first_bracket(text) else {
        return (text, None);
    };
    let (inner, behind) = (&text[1..close], text[close + 1..].trim());
    let is_list = || separated(inner, DecimalMark::Point).len() > 1;
    if behind.is_empty() {
        (inner, None)
    } else if behind.starts_with(|char: char| char.is_alphabetic() || char == '°') && is_list() {
        Unit::read(behind).map_or((text, None), |unit| (inner, Some(unit)))
    } else {
        (text, None)
    }
}

/// Cut at semicolons, at the words `and` and `or`, or at commas that cannot be decimal signs; none in brackets.
fn separated(text: &str, mark: DecimalMark) -> Vec<&str> {
    let all = Span::new(0, text.len());
    if text.contains(';') {
        let places = cut(text, all, &[';']);
        return kept(places.into_iter().map(|place| &text[place.range()]));
    }
    let pieces: Vec<&str> = text
        .split(" and ")
        .flat_map(|piece| piece.split(" or "))
        .collect();
    // Between spaced commas or words, a comma between digits is a decimal sign.
    let needs_space = mark == DecimalMark::Comma || text.contains(", ") || pieces.len() > 1;
    kept(
        pieces
            .into_iter()
            .flat_map(|piece| at_commas(piece, needs_space)),
    )
}

/// Whether spaces alone part numbers that have no unit, `[5 8.7]`.
fn are_decimals(text: &str, mark: DecimalMark) -> bool {
    let is_decimal =
        |word: &str| Decimal::read(word, mark).is_ok_and(|(_, length)| length == word.len());
    let words = || text.split_whitespace();
    // `1 200` is one number.
    words().count() > 1
        && words().all(is_decimal)
        && Decimal::read(text, mark).is_ok_and(|(_, length)| length < text.len())
}

/// The pieces of a text between commas outside of brackets, or between those with a space behind.
fn at_commas(text: &str, needs_space: bool) -> Vec<&str> {
    let (mut pieces, mut start) = (Vec::new(), 0);
    for place in cut(text, Span::new(0, text.len()), &[',']) {
        let end = place.range().end;
        let is_end = end == text.len() || text[end + 1..].trim().is_empty();
        if is_end || !needs_space || text[end + 1..].starts_with(' ') {
            pieces.push(&text[start..end]);
            start = (end + 1).min(text.len());
        }
    }
    pieces
}

/// Whether a comma stands between two digits where it is not known to be a decimal sign.
fn has_tight_comma(text: &str, mark: DecimalMark) -> bool {
    let is_digit = |char: char| char.is_ascii_digit();
    mark == DecimalMark::Point
        && !text.contains(';')
        && text
            .match_indices(',')
            .any(|(at, _)| text[..at].ends_with(is_digit) && text[at + 1..].starts_with(is_digit))
}

fn kept<'t>(pieces: impl Iterator<Item = &'t str>) -> Vec<&'t str> {
    let pieces = pieces.map(str::trim);
    pieces.filter(|piece| !piece.is_empty()).collect()
}

impl Numbers {
    /// Marks the numbers of a list.
    pub(super) fn mark_list(&self, items: &[Number]) -> Marking {
        let mut typed = Vec::with_capacity(items.len());
        for item in items {
            match self.si(&item.quantity) {
                Ok(value) => typed.push(value),
                Err(_) => return self.wrong_dimension(item),
            }
        }
        if let Some(why) = typed.iter().find_map(|value| self.absurd(*value)) {
            return Marking::unreadable(why);
        }
        let numbers: Vec<f64> = typed.iter().map(|value| value.hi()).collect();
        let reading = Self::reading(items, &numbers, self.mark);
        let matched = pair(&self.targets, &typed, self.modulo, self.is_ordered);
        let (expected, given) = (self.targets.len(), typed.len());
        let is_bare = |item: &Number| item.quantity.unit.is_one() && !item.quantity.value.is_zero();
        if matched == expected && given == expected {
            let mut marking = Marking::right(reading);
            if !self.unit.is_one() && items.iter().any(is_bare) {
                marking.say_taken(&self.unit);
            }
            return marking;
        }
        if let Some(marking) = self.mistake(&reading, items, &typed) {
            return marking;
        }
        let surplus = given.saturating_sub(expected);
        let share = Rational::new(matched.saturating_sub(surplus) as i128, expected as i128);
        let credit = share.and_then(Credit::new).unwrap_or(Credit::NONE);
        let unit = items.last().map_or(Unit::ONE, |last| last.quantity.unit);
        let slip = self.slip(&typed, &unit);
        let slip = slip.unwrap_or_else(|| self.counted(&typed, matched));
        Marking::read(reading, credit, Remark::from(slip))
    }

    /// How many numbers of a list are right.
    fn counted(&self, typed: &[Typed], matched: usize) -> Slip {
        let (of, given) = (self.targets.len(), typed.len());
        let right = pair(&self.targets, typed, self.modulo, false);
        Slip::Counted {
            right,
            of,
            surplus: (given > of).then_some(given),
            is_order_wrong: right != matched,
        }
    }
}
