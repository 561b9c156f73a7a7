//! Reads inequalities and intervals.

use std::cell::Cell;

use super::Setup;
use super::set::{End, Set, SetPiece};
use super::spelling::{normalized, spelt, unbracketed};
use super::subject::BoundedSubject;
use crate::answer::{Example, Misfit, Unreadable, Why};
use crate::expr::Precise;
use crate::response::{cut, cut_where};
use crate::source::Span;
use crate::unit::{DecimalMark, Unit};

/// Reads sets for an instance.
pub(crate) struct Ends<'a> {
    pub(crate) setup: &'a Setup,
    pub(crate) data: &'a [Precise],
    pub(crate) mark: DecimalMark,
    /// Whether numbers that may be meant otherwise are, `1,250` as a decimal or in thousands.
    pub(crate) is_otherwise: bool,
    /// Whether a number may be meant otherwise; noted while a set is read.
    pub(crate) is_doubtful: Cell<bool>,
}

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

/// Longest response that is read, in bytes.
const MAX_LENGTH: usize = 2_000;

/// With an example of what can be typed.
pub(crate) fn like_interval(why: Why) -> Unreadable {
    Unreadable::of(why).like(Example::Interval)
}

/// A sign between sides, given as `<`-like or `>`-like and whether its end is left out.
#[derive(Clone, Copy)]
struct Sign {
    is_less: bool,
    is_open: bool,
}

impl Ends<'_> {
    /// The set that a response is.
    pub(crate) fn read(&self, response: &str) -> Read<Set> {
        if response.len() > MAX_LENGTH {
            return Err(Why::TooLong.into());
        }
        let text = normalized(response, self.setup.is_strict);
        let inequalities = inequalities(&text);
        // A number without a unit has that of the next one.
        let mut unit = None;
        if inequalities.len() > 1 {
            let sets = inequalities.iter().rev();
            let sets = sets.map(|piece| self.condition(text[piece.range()].trim(), &mut unit));
            return side_by_side(&sets.collect::<Read<Vec<Set>>>()?);
        }
        let mut pieces = Vec::new();
        for part in text.rsplit('∪') {
            let conditions = part.rsplit('∩').map(str::trim);
            let sets = conditions
                .map(|condition| self.condition(condition, &mut unit))
                .collect::<Read<Vec<Set>>>()?;
            let are_met = sets.iter().all(|set| !set.0.is_empty());
            let common = sets.into_iter().reduce(|all, own| all.common(&own));
            let common = common.unwrap_or_default();
            if are_met && common.0.is_empty() {
                return Err(Why::NoneSatisfies(spelt(part)).into());
            }
            pieces.extend(common.0);
        }
        Ok(Set::of(pieces))
    }

    /// An interval in brackets, or a chain of inequalities.
    fn condition(&self, text: &str, unit: &mut Option<Unit>) -> Read<Set> {
        if text.is_empty() {
            return Err(like_interval(Why::Form).into());
        }
        let mut text = text;
        while let Some((inner, behind)) = unbracketed(text) {
            if !behind.is_empty() {
                *unit = Some(self.unit_behind(behind)?);
            }
            text = inner;
        }
        let signs: Vec<(usize, char)> = text
            .char_indices()
            .filter(|(_, char)| "<>≤≥".contains(*char))
            .collect();
        if signs.is_empty() {
            return self.bracketed(text, unit);
        }
        let mut sides = Vec::new();
        let mut start = 0;
        for (at, char) in &signs {
            sides.push(text[start..*at].trim());
            start = at + char.len_utf8();
        }
        sides.push(text[start..].trim());
        let signs: Vec<Sign> = signs
            .iter()
            .map(|(_, char)| Sign {
                is_less: "<≤".contains(*char),
                is_open: "<>".contains(*char),
            })
            .collect();
        if signs.len() == 1 && sides[0].is_empty() {
            // `≥ 0.3` speaks of what is asked.
            sides[0] = self.setup.variable.as_str();
        }
        let subjects = sides.iter().map(|side| self.subject(side));
        let Some((place, subject)) = subjects
            .enumerate()
            .find_map(|(at, subject)| Some((at, subject?)))
        else {
            return Err(self.without_subject(&sides).into());
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
            let value = self.side(bound, unit)?;
            let own = End {
                value,
                is_open: sign.is_open || !value.is_finite(),
            };
            let end = usize::from(is_less);
            if piece.0[end].value.is_finite() {
                return Err(like_interval(Why::SameWay).into());
            }
            piece.0[end] = own;
        }
        Ok(subject.where_it_is_in(one(piece)?))
    }

    /// `[a, b)`, `]a; b]`, `x in [a, b]`.
    fn bracketed(&self, text: &str, unit: &mut Option<Unit>) -> Read<Set> {
        let start = text
            .find(['[', '(', ']'])
            .ok_or_else(|| Unreadable::at(text, Why::NoInterval).like(Example::Interval))?;
        let lead = text[..start].trim();
        let subject = match lead.trim_end_matches(['∈', '=', ':']).trim() {
            "" if lead.is_empty() => BoundedSubject::Variable,
            name => self.subject(name).ok_or_else(|| {
                let symbol = self.setup.symbol.plain();
                Unreadable::at(spelt(lead), Why::BeforeInterval(symbol))
            })?,
        };
        let inner = text[start..].trim();
        let (unit_text, inner) = match inner.rfind([']', ')', '[']) {
            Some(end) if end > 0 => (inner[end + 1..].trim(), &inner[..=end]),
            _ => return Err(like_interval(Why::IntervalBracket).into()),
        };
        if !unit_text.is_empty() {
            *unit = Some(self.unit_behind(unit_text)?);
        }
        let mut ends = inner.chars();
        let (first, last) = (ends.next(), ends.next_back());
        let body = ends.as_str();
        let (is_open_low, is_open_high) = (first != Some('['), last != Some(']'));
        let all = Span::new(0, body.len());
        let mut sides = cut(body, all, &[';']);
        if sides.len() == 1 {
            let is_comma_decimal = self.mark == DecimalMark::Comma;
            sides = if is_comma_decimal && body.contains(", ") {
                body.find(", ").map_or(sides, |at| {
                    vec![Span::new(0, at), Span::new(at + 1, body.len())]
                })
            } else {
                cut(body, all, &[','])
            };
        }
        let [low, high] = sides[..] else {
            return Err(like_interval(Why::TwoEnds).into());
        };
        let high = self.side(body[high.range()].trim(), unit)?;
        let low = self.side(body[low.range()].trim(), unit)?;
        let piece = SetPiece([
            End {
                value: low,
                is_open: is_open_low || !low.is_finite(),
            },
            End {
                value: high,
                is_open: is_open_high || !high.is_finite(),
            },
        ]);
        Ok(subject.where_it_is_in(one(piece)?))
    }

    /// The unit that comes after a bracket.
    fn unit_behind(&self, text: &str) -> Read<Unit> {
        let one = format!("1 {text}");
        // A unit of another dimension is reported as that of a bound is.
        self.number(&one, &mut None)?;
        let one = self.quantity(&one).filter(|one| !one.unit.is_one());
        let one = one.ok_or_else(|| Unreadable::at(text, Why::NoUnit).like(Example::Interval))?;
        Ok(one.unit)
    }

    /// What is said of an inequality without what is asked.
    fn without_subject(&self, sides: &[&str]) -> Unreadable {
        let (symbol, variable) = (self.setup.symbol.plain(), &self.setup.variable);
        let formulas = sides.iter().map(|side| self.formula(side));
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
}

/// The inequalities that stand side by side, parted by commas or semicolons; none where it is anything else.
fn inequalities(text: &str) -> Vec<Span> {
    let is_digit = |char: char| char.is_ascii_digit();
    let pieces = cut_where(text, Span::new(0, text.len()), |at, char| {
        let is_decimal = || text[..at].ends_with(is_digit) && text[at + 1..].starts_with(is_digit);
        char == ';' || char == ',' && !is_decimal()
    });
    let is_relation = |piece: &Span| text[piece.range()].contains(['<', '>', '≤', '≥']);
    let are_joined = text.contains(['∪', '∩']);
    if are_joined || !pieces.iter().all(is_relation) {
        return Vec::new();
    }
    pieces
}

/// What inequalities side by side mean together. `x > 1, x < 3` holds for both, since everything would satisfy one of
/// them; `x < 1, x > 3` holds for one of them, since nothing satisfies both. Where neither is so, one has to ask.
fn side_by_side(sets: &[Set]) -> Read<Set> {
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
