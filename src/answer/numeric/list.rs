//! Lists of numbers as people type them, and how they are marked: `5; 8.7 rad/s`, `0, ±180°`, `ω1 = 5, ω2 = 8.7`.

use super::marker::Numbers;
use super::read::{Setting, TypedNumber, number, statement};
use super::slip::slip;
use super::target::{Typed, pair};
use super::words::angles;
use crate::answer::{Credit, Example, Marking, Remark, Slip, Unreadable, Why};
use crate::numerics::Rational;
use crate::response::{Label, Part, Passage, Style, Trouble, Values};
use crate::unit::{DecimalMark, Unit};

/// Numbers as they were typed.
pub(crate) struct List {
    pub(crate) items: Vec<TypedNumber>,
    /// Whether they are two with one distance from their mean, `6.8 ± 1.8`, of which neither is the first.
    pub(crate) are_about_mean: bool,
}

/// The most numbers of a list.
const MAX_ITEMS: usize = 100;

/// The numbers of a list where `count` are asked; numbers whose names have indices come in their order, and frequencies
/// have to ascend in it where the question gives no other. A unit at
/// the end of the last one, or after the bracket, serves for all that have none.
///
/// # Errors
///
/// What cannot be read, and why.
pub(crate) fn list(
    response: Passage<'_>,
    count: usize,
    is_ordered: bool,
    setting: Setting<'_>,
) -> Result<List, Unreadable> {
    let Some(ranked) = response.in_said_order(count) else {
        return unranked(response, count, is_ordered, setting);
    };
    let list = unranked(ranked.passage(), count, is_ordered, setting)?;
    // The lower one is the first, and by custom that of the mode in phase.
    let sizes = list.items.iter().map(|item| item.quantity.si());
    if sizes.is_sorted() {
        Ok(list)
    } else {
        Err(Why::LabelsInOtherOrder.into())
    }
}

/// The same where no words say which value is which.
fn unranked(
    response: Passage<'_>,
    count: usize,
    is_ordered: bool,
    setting: Setting<'_>,
) -> Result<List, Unreadable> {
    let mark = setting.mark;
    let values = parted(response, mark, false, count)?;
    if let Some(bracket) = values.lone_bracket() {
        return Err(Unreadable::at(bracket, Why::Formula(Trouble::Bracket)));
    }
    let all = values.all();
    // `ω1, ω2 = 5, 8.7` has one equals sign for all, else each number has its own.
    let whole = values.statement(&all).sides;
    let (labels, all) = match &whole[..] {
        [before, behind] => match values.names(before) {
            Some(names) => (names, behind.clone()),
            None => (Vec::new(), all),
        },
        [only] => (Vec::new(), only.clone()),
        _ => (Vec::new(), all),
    };
    let (inner, unit) = unframed(&values, &all);
    let is_framed = inner != all;
    let (pieces, is_ascending) = pieces_of(&values, &inner, is_framed, count)?;
    if pieces.is_empty() {
        return Err(Unreadable::of(Why::Form).like(Example::Number));
    }
    if pieces.len() > MAX_ITEMS {
        return Err(Why::MostNumbers(MAX_ITEMS).into());
    }
    let is_frequency = pieces
        .iter()
        .map(|piece| values.statement(piece).sides[0].clone())
        .chain(labels.first().cloned())
        .any(|name| values.passage(&name).is_frequency());
    let mut items: Vec<(Option<u32>, TypedNumber)> = Vec::new();
    let (mut named, mut are_about_mean) = (Vec::new(), false);
    for piece in &pieces {
        let first = &values.statement(piece).sides[0];
        let label = values.index(first).filter(|_| values.is_name(first));
        if label.is_some() {
            let name = Label::of_passage(values.passage(first));
            if named.contains(&name) {
                return Err(Unreadable::at(values.passage(first), Why::LabelTwice));
            }
            named.push(name);
        }
        let both = both_signs(&values, piece, pieces.len() == 1 && count == 2, setting)?;
        are_about_mean |= pieces.len() == 1 && both.len() == 2;
        items.extend(both.into_iter().map(|item| (label, item)));
    }
    if values.has_tight_comma(&inner)
        && mark == DecimalMark::Point
        && !values.has(&inner, ';')
        && items.len() != count
    {
        return Err(Why::TightComma.into());
    }
    if labels.len() == items.len() {
        for (item, label) in items.iter_mut().zip(&labels) {
            item.0 = values.index(label);
        }
    }
    // Beside `14,82` the comma of `9,502` is a decimal sign, too: nobody writes both in one list.
    if values.has(&inner, ';') && values.has_decimal_comma(&inner) && mark == DecimalMark::Point {
        let all = items.iter_mut().map(|(_, item)| item);
        all.filter(|item| !item.is_by_rule && item.arithmetic.is_none())
            .for_each(|item| item.others.clear());
    }
    let unit = unit.or_else(|| items.last().map(|(_, last)| last.quantity.unit));
    if let Some(unit) = unit {
        give(&mut items, unit);
    }
    if items.iter().all(|(label, _)| label.is_some()) {
        // In another order the last of them may have a unit, which the others do not share: `ω2 = 9 Hz, ω1 = 5`.
        if let Some((asked, _)) = setting.steps
            && items.iter().any(|(_, item)| !item.quantity.unit.is_one())
        {
            give(&mut items, *asked);
        }
        crate::numerics::sort_by_key(&mut items, |(label, _)| *label);
        let sizes = items.iter().map(|(_, item)| item.quantity.si());
        if !is_ordered && is_frequency && !sizes.is_sorted() {
            return Err(Why::LabelsInOtherOrder.into());
        }
    }
    let items: Vec<TypedNumber> = items.into_iter().map(|(_, item)| item).collect();
    // `5 < 3` says what is not so.
    if is_ascending && !items.iter().map(|item| item.quantity.si()).is_sorted() {
        return Err(Why::LabelsInOtherOrder.into());
    }
    Ok(List {
        items,
        are_about_mean,
    })
}

/// Gives numbers without a unit this one.
fn give(items: &mut [(Option<u32>, TypedNumber)], unit: Unit) {
    let bare = items
        .iter_mut()
        .filter(|(_, item)| item.quantity.unit.is_one());
    bare.for_each(|(_, item)| item.quantity.unit = unit);
}

/// The numbers of a list, each with what belongs to it, and whether they are said to ascend.
fn pieces_of(
    values: &Values<'_>,
    inner: &Part,
    is_framed: bool,
    count: usize,
) -> Result<(Vec<Part>, bool), Unreadable> {
    // `[5 8.7]`; without brackets `5 8.7` alone is two numbers where two are asked, and `5 000` may be one.
    let is_list = |pieces: &Vec<Part>| {
        let mut bare = pieces
            .iter()
            .skip(1)
            .map(|piece| values.without_unit(piece));
        is_framed
            || pieces.len() == count
                && !bare.any(|piece| values.passage(&piece).is_group_of_digits())
    };
    let spaced = values.spaced(inner).filter(is_list);
    // `5 / 8.7` is no quotient where two are asked.
    let amounts = || {
        let amounts = [values.spaced_amounts(inner), values.slashed(inner)];
        let mut amounts = amounts.into_iter().flatten();
        amounts.find(|pieces| pieces.len() == count)
    };
    let pieces: Vec<Part> = match spaced.or_else(amounts) {
        Some(pieces) => pieces,
        None => values.statements(inner),
    };
    let ascending = pieces
        .first()
        .filter(|_| pieces.len() == 1)
        .and_then(|only| values.ascending(only));
    let is_ascending = ascending.is_some();
    let pieces = without_empty_ends(values, ascending.unwrap_or(pieces))?;
    let bare = |piece: Part| match values.back_bracket(&piece) {
        Some((value, said)) if values.passage(&said).is_remark() => value,
        _ => piece,
    };
    Ok((pieces.into_iter().map(bare).collect(), is_ascending))
}

/// The pieces of a list without what is empty after its last sign.
pub(crate) fn without_empty_ends(
    values: &Values<'_>,
    pieces: Vec<Part>,
) -> Result<Vec<Part>, Unreadable> {
    if pieces.iter().any(|piece| values.is_gap(piece)) {
        return Err(Why::EmptyPlace.into());
    }
    Ok(pieces
        .into_iter()
        .filter(|piece| !piece.is_empty())
        .collect())
}

/// The values of a list of which `count` are asked. A comma between digits parts them, unless something else does, or two
/// are asked and stand at one distance from their mean, `6,83 ± 1,83`.
pub(crate) fn parted(
    response: Passage<'_>,
    mark: DecimalMark,
    is_complex: bool,
    count: usize,
) -> Result<Values<'_>, Unreadable> {
    let read = |comma_is_decimal| {
        let style = Style {
            mark,
            comma_is_decimal,
            is_complex,
        };
        Values::read(response, style).map_err(|error| Unreadable::typed(&error, response))
    };
    let values = read(true)?;
    let are_about_mean = || {
        let whole = values.statement(&values.all()).sides;
        let signs = whole.last().and_then(|value| values.both_signs(value));
        count == 2 && signs.is_some_and(|(_, is_first)| !is_first)
    };
    let are_apart = || {
        let all = values.all();
        let mut ways = [values.spaced(&all), values.slashed(&all)].into_iter();
        ways.any(|pieces| pieces.is_some_and(|pieces| pieces.len() == count))
    };
    if mark == DecimalMark::Comma || values.is_parted() || are_about_mean() || are_apart() {
        return Ok(values);
    }
    read(false)
}

/// The number that an item of a list is, or the two that it is with `±`, which only a list of one may have within: of
/// several `5 ± 0.1` would be a spread.
fn both_signs(
    values: &Values<'_>,
    piece: &Part,
    is_alone: bool,
    setting: Setting<'_>,
) -> Result<Vec<TypedNumber>, Unreadable> {
    let sides = values.statement(piece).sides;
    let signs = sides.last().and_then(|value| values.both_signs(value));
    match signs.filter(|(_, is_first)| *is_first || is_alone) {
        Some((both, _)) => both
            .iter()
            .map(|own| number(own.passage(), setting))
            .collect(),
        None => Ok(vec![statement(values, piece, setting)?]),
    }
}

/// Without the brackets around a whole list, `([5, 8.7])` included, and the unit that comes after them.
fn unframed(values: &Values<'_>, part: &Part) -> (Part, Option<Unit>) {
    let (inner, unit) = unbracketed(values, part);
    if inner == *part || values.unbracketed(&inner).is_none() {
        return (inner, unit);
    }
    let (innermost, own) = unbracketed(values, &inner);
    (innermost, unit.or(own))
}

fn unbracketed(values: &Values<'_>, part: &Part) -> (Part, Option<Unit>) {
    match values.front_bracket(part) {
        Some((inner, behind)) if behind.is_empty() => (inner, None),
        Some((inner, behind))
            if values.statements(&inner).len() > 1
                || values.spaced(&inner).is_some()
                || values.unbracketed(&inner).is_some() =>
        {
            match values.unit(&behind) {
                Some(unit) => (inner, Some(unit)),
                None => (part.clone(), None),
            }
        }
        _ => (part.clone(), None),
    }
}

/// Marks the numbers of a list.
pub(crate) fn mark_list(key: &Numbers, items: &[TypedNumber], is_ordered: bool) -> Marking {
    let mut typed = Vec::with_capacity(items.len());
    for item in items {
        match key.si(&item.quantity) {
            Ok(value) => typed.push(value),
            Err(_) => return key.wrong_dimension(item),
        }
    }
    let misread = items
        .iter()
        .find_map(|item| angles(&item.quantity.unit, &key.unit));
    if let Some(why) = misread.or_else(|| typed.iter().find_map(|value| key.absurd(*value))) {
        return Marking::unreadable(why);
    }
    let numbers: Vec<f64> = typed.iter().map(|value| value.hi()).collect();
    let reading = Numbers::reading(items, &numbers, key.mark);
    let matched = pair(&key.targets, &typed, key.modulo, is_ordered);
    let (expected, given) = (key.targets.len(), typed.len());
    let is_bare =
        |item: &TypedNumber| item.quantity.unit.is_one() && !item.quantity.value.is_zero();
    if matched == expected && given == expected {
        let mut marking = Marking::right(reading);
        if !key.unit.is_one() && items.iter().any(is_bare) {
            marking.say_taken(&key.unit);
        }
        return marking;
    }
    if let Some(marking) = key.mistake(&reading, items, &typed) {
        return marking;
    }
    let surplus = given.saturating_sub(expected);
    let share = Rational::new(matched.saturating_sub(surplus) as i128, expected as i128);
    let credit = share.and_then(Credit::new).unwrap_or(Credit::NONE);
    let unit = items.last().map_or(Unit::ONE, |last| last.quantity.unit);
    let slip = slip(key, &typed, &unit);
    let slip = slip.unwrap_or_else(|| counted(key, &typed, matched));
    Marking::read(reading, credit, Remark::from(slip))
}

/// How many numbers of a list are right.
fn counted(key: &Numbers, typed: &[Typed], matched: usize) -> Slip {
    let (of, given) = (key.targets.len(), typed.len());
    let right = pair(&key.targets, typed, key.modulo, false);
    Slip::Counted {
        right,
        of,
        surplus: (given > of).then_some(given),
        is_order_wrong: right != matched,
    }
}
