//! Reads inequalities and intervals.

use super::bound::Ends;
use super::set::{End, Set, SetPiece};
use super::subject::BoundedSubject;
use crate::answer::{Example, Misfit, Unreadable, Why};
use crate::response::{Bounding, Condition, Passage, RangeError, Ranges, Said};
use crate::unit::Unit;

/// Why a response is no set.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// It cannot be read.
    Unread(Box<Unreadable>),
    /// A bound is of another dimension.
    Misfit(Box<Misfit>),
}

impl From<Unreadable> for Refusal {
    fn from(why: Unreadable) -> Self {
        Self::Unread(Box::new(why))
    }
}

impl From<Why> for Refusal {
    fn from(why: Why) -> Self {
        Unreadable::of(why).into()
    }
}

impl From<Misfit> for Refusal {
    fn from(misfit: Misfit) -> Self {
        Self::Misfit(Box::new(misfit))
    }
}

pub(crate) type Read<T> = Result<T, Refusal>;

/// With an example of what can be typed.
pub(crate) fn like_interval(why: Why) -> Unreadable {
    Unreadable::of(why).like(Example::Interval)
}

/// The set that a response is.
pub(crate) fn read(ends: &Ends<'_>, response: Passage<'_>) -> Read<Set> {
    // A number without a unit has that of the next one.
    let mut unit = None;
    let groups = match Ranges::read(response, ends.mark, &ends.setup.asked).map_err(unread)? {
        Ranges::SideBySide(conditions) => {
            let sets = conditions.iter().rev();
            let sets = sets.map(|condition| set_of(ends, condition, &mut unit));
            return side_by_side(&sets.collect::<Read<Vec<Set>>>()?);
        }
        Ranges::Union(groups) => groups,
    };
    let mut pieces = Vec::new();
    for group in groups.iter().rev() {
        let sets = group.conditions.iter().rev();
        let sets = sets
            .map(|condition| set_of(ends, condition, &mut unit))
            .collect::<Read<Vec<Set>>>()?;
        let are_met = sets.iter().all(|set| !set.0.is_empty());
        let is_bounded = |set: &Set| {
            let mut ends = set.0.iter().flat_map(|piece| piece.0);
            !set.0.is_empty() && ends.all(|end| end.value.is_finite())
        };
        // `[1, 2) and (3, 4]` lists both.
        let are_listed = !group.is_common && sets.len() > 1 && sets.iter().all(is_bounded);
        let listed: Vec<SetPiece> = sets.iter().flat_map(|set| set.0.clone()).collect();
        let common = sets.into_iter().reduce(|all, own| all.common(&own));
        let common = common.unwrap_or_default();
        if are_listed && common.0.is_empty() {
            pieces.extend(listed);
            continue;
        }
        if are_met && common.0.is_empty() {
            return Err(Why::NoneSatisfies(group.typed.into()).into());
        }
        pieces.extend(common.0);
    }
    Ok(Set::of(pieces))
}

/// The set that a condition says.
fn set_of(ends: &Ends<'_>, condition: &Condition<'_>, unit: &mut Option<Unit>) -> Read<Set> {
    for own in &condition.units {
        *unit = Some(ends.unit_behind(*own)?);
    }
    match &condition.said {
        Said::Chain { sides, signs } => chain(ends, sides, signs, unit),
        Said::Interval {
            subject,
            ends: typed,
            open,
        } => interval(ends, *subject, *typed, *open, unit),
        Said::Within { bound, open } => {
            let [is_open, _] = ends.said_open(open.map(|open| [open; 2]));
            let high = ends.end(*bound, is_open, unit)?;
            let low = End {
                value: -high.value,
                ..high
            };
            Ok(Set::of(vec![one(SetPiece([low, high]))?]))
        }
    }
}

fn chain(
    ends: &Ends<'_>,
    sides: &[Passage<'_>],
    signs: &[Bounding],
    unit: &mut Option<Unit>,
) -> Read<Set> {
    // `≥ 0.3` speaks of what is asked.
    let is_left_out = signs.len() == 1 && sides[0].is_empty();
    let variable = is_left_out.then_some((0, BoundedSubject::Variable));
    // The unit that stands last serves the numbers before it.
    let behind = |at: usize| {
        let mut own = *unit;
        // A longer chain is refused whatever its units are.
        let behind = sides.get(at + 1..).filter(|_| sides.len() <= 3);
        for side in behind.into_iter().flatten().rev() {
            // What is wrong with a bound is reported where it is read.
            let _ = ends.number(*side, &mut own);
        }
        own
    };
    let mut subjects = sides
        .iter()
        .enumerate()
        .map(|(at, side)| (at, BoundedSubject::of(ends, *side, behind(at))));
    let subject = variable.or_else(|| subjects.find_map(|(at, own)| Some((at, own?))));
    let Some((place, subject)) = subject else {
        return Err(without_subject(ends, sides).into());
    };
    if place > 1 || place + 2 < sides.len() {
        return Err(like_interval(Why::LongChain).into());
    }
    let mut piece = SetPiece([End::none(0), End::none(1)]);
    for (at, sign) in signs.iter().enumerate().rev() {
        // Each sign bounds the subject by what stands on its other side.
        let (bound, is_less) = if at >= place {
            (sides[at + 1], sign.is_less)
        } else {
            (sides[at], !sign.is_less)
        };
        let end = usize::from(is_less);
        let own = subject.end(ends, bound, sign.is_open, unit)?;
        if piece.0[end].value.is_finite() {
            return Err(like_interval(Why::SameWay).into());
        }
        piece.0[end] = own;
    }
    Ok(subject.where_it_is_in(one(piece)?))
}

fn interval(
    ends: &Ends<'_>,
    subject: Option<Passage<'_>>,
    [low, high]: [Passage<'_>; 2],
    open: Option<[bool; 2]>,
    unit: &mut Option<Unit>,
) -> Read<Set> {
    let subject = match subject {
        None => BoundedSubject::Variable,
        Some(name) => BoundedSubject::of(ends, name, *unit).ok_or_else(|| {
            let symbol = ends.setup.symbol.plain();
            Unreadable::at(name, Why::BeforeInterval(symbol))
        })?,
    };
    let [is_open_low, is_open_high] = ends.said_open(open);
    let high = ends.end(high, is_open_high, unit)?;
    let low = ends.end(low, is_open_low, unit)?;
    Ok(subject.where_it_is_in(one(SetPiece([low, high]))?))
}

/// What is said of an inequality without what is asked.
fn without_subject(ends: &Ends<'_>, sides: &[Passage<'_>]) -> Unreadable {
    let (symbol, variable) = (ends.setup.symbol.plain(), &ends.setup.variable);
    let formulas = sides.iter().map(|side| ends.formula(*side));
    let (mut is_there, mut trouble) = (false, None);
    for formula in formulas {
        match formula {
            Ok(formula) => is_there |= formula.names().uses(variable),
            Err(why) => trouble = Some(why),
        }
    }
    match trouble {
        _ if is_there => like_interval(Why::SolveForDistance(symbol)),
        Some(why) => why,
        None => like_interval(Why::NotInInequality(symbol)),
    }
}

/// Why a response says nothing of values.
fn unread(error: RangeError<'_>) -> Refusal {
    let why = match error {
        RangeError::TooLong => return Why::TooLong.into(),
        RangeError::NoCondition(side) => {
            return Unreadable::at(side, Why::NoInterval)
                .like(Example::Interval)
                .into();
        }
        RangeError::Missing => Why::Form,
        RangeError::Bracket => Why::IntervalBracket,
        RangeError::TwoEnds => Why::TwoEnds,
    };
    like_interval(why).into()
}

/// What inequalities side by side mean together. `x > 1, x < 3` holds for both, since everything would satisfy one of
/// them; `x < 1, x > 3` holds for one of them, since nothing satisfies both. Where neither is so, one has to ask.
fn side_by_side(sets: &[Set]) -> Read<Set> {
    // The last one is that which is asked for, in numbers after letters.
    if let [others @ .., last] = sets
        && others.iter().all(|own| last.is_same_as(own))
    {
        return Ok(last.clone());
    }
    let common = sets
        .iter()
        .cloned()
        .reduce(|all, own| all.common(&own))
        .unwrap_or_default();
    let either = Set::of(sets.iter().flat_map(|set| set.0.clone()).collect());
    let is_all =
        matches!(&either.0[..], [SetPiece(ends)] if ends.iter().all(|end| !end.value.is_finite()));
    match (is_all, common.0.is_empty()) {
        (true, false) => Ok(common),
        (false, true) => Ok(either),
        _ => Err(Why::JoinInequalities.into()),
    }
}

/// One interval; bounds in the wrong order are none.
fn one(piece: SetPiece) -> Result<SetPiece, Unreadable> {
    let [low, high] = piece.0;
    if low.value > high.value {
        return Err(like_interval(Why::BoundsOrder));
    }
    Ok(piece)
}
