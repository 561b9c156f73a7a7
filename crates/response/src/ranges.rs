//! What a response says of the values of a quantity: intervals, chains of inequalities, ranges in words.
//!
//! ```text
//! ranges    = [ "for" | "if" | … ] union | "{" side ( "|" | ":" ) union "}" | chain { ( "," | ";" ) chain }
//! union     = common { ( "∪" | "or" | "," between brackets ) common }
//! common    = condition { ( "∩" | "and" ) condition }
//! condition = chain | interval | "(" condition ")" [ unit ]
//! chain     = side relation side { relation side }
//! interval  = [ side ( "∈" | "=" | ":" ) ] ( "[" | "(" | "]" ) side ( "," | ";" ) side ( "]" | ")" | "[" ) [ unit ]
//!           | [ side ] "from" side "to" side | [ side ] "between" side "and" side | side "…" side
//! ```

mod bound;
mod marks;
mod said;

use std::ops::Range;

pub use self::bound::AskedBound;
use self::marks::{CALLS, INTERSECTION, Mark, Marked, marks};
use self::said::{condition_said, in_words, without_said_ends};
use super::answering::without_condition;
use super::list::{cut, cut_where, trimmed};
use super::signs::is_between_digits;
use super::words::ENDS;
use super::{MAX_LENGTH, Passage, Wording};
use vibank_formula::unit::DecimalMark;
use vibank_source::Span;

/// The values that a response leaves to a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Ranges<'t> {
    /// Those that meet all conditions of a group.
    Union(Vec<Group<'t>>),
    /// Inequalities that nothing joins.
    SideBySide(Vec<Condition<'t>>),
}

/// Conditions that hold together.
#[derive(Clone, Debug, PartialEq)]
pub struct Group<'t> {
    /// All of them.
    pub typed: Passage<'t>,
    /// Whether the sign of an intersection stands in it; `and` may list, too.
    pub is_common: bool,
    /// At least one.
    pub conditions: Vec<Condition<'t>>,
}

/// A condition, with the units that come after brackets around it.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition<'t> {
    /// The outermost first.
    pub units: Vec<Passage<'t>>,
    /// The chain, interval or set within the brackets.
    pub said: Said<'t>,
}

/// What a condition says.
#[derive(Clone, Debug, PartialEq)]
pub enum Said<'t> {
    /// Sides with one sign fewer between them; before the sign of one bound nothing may stand.
    Chain {
        /// What is compared.
        sides: Vec<Passage<'t>>,
        /// The signs in between.
        signs: Vec<Bounding>,
    },
    /// That something lies within an interval.
    Interval {
        /// What lies there, if that is said.
        subject: Option<Passage<'t>>,
        /// The lower and the upper end.
        ends: [Passage<'t>; 2],
        /// Whether each end is left out; none where words do not say.
        open: Option<[bool; 2]>,
    },
    /// That something lies as far on either side of zero at most, `±3 mm`.
    Within {
        /// How far.
        bound: Passage<'t>,
        /// Whether that is left out; none where words do not say.
        open: Option<bool>,
    },
}

/// A sign between sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounding {
    /// Whether the side before it is the lower one.
    pub is_less: bool,
    /// Whether equality is left out.
    pub is_open: bool,
}

/// Why a response says nothing of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RangeError<'t> {
    /// The response has more pieces than are looked at.
    TooLong,
    /// Nothing stands where a condition is expected.
    Missing,
    /// What neither a sign nor a bracket makes a condition of.
    NoCondition(Passage<'t>),
    /// The bracket of an interval is missing.
    Bracket,
    /// An interval has another number of ends than two.
    TwoEnds,
}

type Read<'t, T> = Result<T, RangeError<'t>>;

impl<'t> Ranges<'t> {
    /// Reads a response to a question of these words whose numbers have this decimal sign.
    ///
    /// # Errors
    ///
    /// Where it is something else.
    pub fn read(passage: Passage<'t>, mark: DecimalMark, asked: &Wording) -> Read<'t, Self> {
        let text = passage.text();
        if text.len() > MAX_LENGTH {
            return Err(RangeError::TooLong);
        }
        let text = without_condition(text);
        let (bare, open) = without_said_ends(text);
        // `from 0.2 (excluded) to 0.5 (included)` says it of each.
        let says_each = ENDS.iter().any(|(words, _)| bare.contains(words));
        let (text, open) = if says_each {
            (text, None)
        } else {
            (bare, open)
        };
        let mut ranges = Self::bare(text, mark, asked)?;
        match open {
            Some(is_open) if !ranges.open(is_open) => Err(RangeError::Bracket),
            _ => Ok(ranges),
        }
    }

    /// Leaves out both ends of the only condition, or keeps them, as words say; whether its signs allow it.
    fn open(&mut self, is_out: bool) -> bool {
        let Self::Union(groups) = self else {
            return false;
        };
        let [Group { conditions, .. }] = &mut groups[..] else {
            return false;
        };
        let [condition] = &mut conditions[..] else {
            return false;
        };
        match &mut condition.said {
            Said::Chain { signs, .. } => {
                // `≤` keeps its end.
                let fits = signs.iter().all(|sign| sign.is_open || !is_out);
                signs.iter_mut().for_each(|sign| sign.is_open = is_out);
                fits
            }
            Said::Interval { open, .. } => {
                let fits = open.is_none_or(|open| !is_out || open == [true; 2]);
                *open = Some([is_out; 2]);
                fits
            }
            Said::Within { open, .. } => {
                *open = Some(is_out);
                true
            }
        }
    }

    fn bare(text: &'t str, mark: DecimalMark, asked: &Wording) -> Read<'t, Self> {
        let end = text.trim_end_matches(|char: char| char.is_whitespace() || ".,;".contains(char));
        let mut text = without_brackets(end.trim());
        text = condition_of_set(text).unwrap_or(text);
        text = condition_said(text, asked);
        // What programs write around several.
        let mut calls = ["Union(", "And(", "Or("].iter();
        let called = calls.find_map(|call| text.strip_prefix(call)?.strip_suffix(')'));
        text = called.unwrap_or(text);
        let marks = marks(text);
        if let Some(groups) = in_words(text, &marks) {
            return Ok(Self::Union(groups));
        }
        let reader = Reader { text, marks, mark };
        let all = Span::new(0, text.len());
        if let Some(pieces) = reader.side_by_side(all) {
            let conditions = pieces.into_iter().map(|piece| reader.condition(piece));
            return conditions.collect::<Read<'t, _>>().map(Self::SideBySide);
        }
        let groups = reader.parted(all, |mark| mark == Mark::Or).into_iter();
        let groups = groups.map(|span| {
            let conditions = reader.parted(span, |mark| mark == Mark::And).into_iter();
            let typed = &text[span.range()];
            Ok(Group {
                typed: Passage::of(typed),
                is_common: typed.contains(INTERSECTION),
                conditions: conditions
                    .map(|span| reader.condition(span))
                    .collect::<Read<'t, _>>()?,
            })
        });
        groups.collect::<Read<'t, _>>().map(Self::Union)
    }
}

struct Reader<'t> {
    text: &'t str,
    marks: Vec<Marked>,
    mark: DecimalMark,
}

impl<'t> Reader<'t> {
    fn side(&self, range: Range<usize>) -> Passage<'t> {
        Passage::of(&self.text[range])
    }

    fn within(&self, span: Span) -> impl Iterator<Item = &Marked> {
        let (start, end) = (span.range().start, span.range().end);
        self.marks
            .iter()
            .filter(move |own| start <= own.at.start && own.at.end <= end)
    }

    /// The pieces of a part between marks.
    fn parted(&self, span: Span, parts: impl Fn(Mark) -> bool) -> Vec<Span> {
        let (mut pieces, mut start) = (Vec::new(), span.range().start);
        for own in self.within(span).filter(|own| parts(own.mark)) {
            pieces.push(Span::new(start, own.at.start));
            start = own.at.end;
        }
        pieces.push(Span::new(start, span.range().end));
        pieces
    }

    fn relates(&self, span: Span) -> bool {
        self.within(span)
            .any(|own| matches!(own.mark, Mark::Sign(_)))
    }

    /// Inequalities that commas or semicolons part, and nothing joins.
    fn side_by_side(&self, all: Span) -> Option<Vec<Span>> {
        let mut pieces = cut_where(self.text, all, |at, char| {
            matches!(char, ';' | '\n') || char == ',' && !is_between_digits(self.text, at)
        });
        for piece in &mut pieces {
            let text = self.text[piece.range()].trim_start();
            let mut words = ["so ", "hence ", "thus ", "= "].into_iter();
            if let Some(behind) = words.find_map(|word| text.strip_prefix(word)) {
                *piece = Span::new(piece.range().end - behind.len(), piece.range().end);
            }
        }
        // `μ_min = 0.2, μ ≥ 0.2` says the bound before.
        if pieces.len() > 1 && pieces.iter().any(|piece| self.relates(*piece)) {
            pieces.retain(|own| self.relates(*own) || !self.text[own.range()].contains('='));
        }
        let is_all = pieces.len() == 1 && pieces[0] != all;
        let mut marks = self.marks.iter();
        let are_joined = marks.any(|own| matches!(own.mark, Mark::Or | Mark::And));
        let are_all =
            (pieces.len() > 1 || is_all) && pieces.iter().all(|piece| self.relates(*piece));
        (are_all && !are_joined).then_some(pieces)
    }

    fn condition(&self, span: Span) -> Read<'t, Condition<'t>> {
        // `x < 3 m, or x > 5 m`
        let length = self.text[span.range()]
            .trim_end()
            .trim_end_matches(',')
            .len();
        let span = Span::new(span.range().start, span.range().start + length);
        let (mut span, mut units) = (trimmed(self.text, span), Vec::new());
        if span.range().is_empty() {
            return Err(RangeError::Missing);
        }
        while let Some((inner, behind)) = self.unbracketed(span) {
            units.extend(Some(self.side(behind)).filter(|unit| !unit.is_empty()));
            span = inner;
        }
        let signs = self.within(span).filter_map(|own| match own.mark {
            Mark::Sign(sign) => Some(sign),
            _ => None,
        });
        let signs: Vec<Bounding> = signs.collect();
        let said = if signs.is_empty() {
            self.interval(span, &mut units)?
        } else {
            let sides = self.parted(span, |mark| matches!(mark, Mark::Sign(_)));
            let sides = sides.into_iter().map(|side| self.side(side.range()));
            let sides: Vec<Passage<'t>> = sides.collect();
            match (&sides[..], &signs[..]) {
                // `above 0.2 up to 0.5`, `x > 0.2 up to 0.5`
                ([subject, low, high], [above, upto]) if !above.is_less && upto.is_less => {
                    Said::Interval {
                        subject: Some(*subject).filter(|subject| !subject.is_empty()),
                        ends: [*low, *high],
                        open: Some([above.is_open, upto.is_open]),
                    }
                }
                _ => Said::Chain { sides, signs },
            }
        };
        Ok(Condition { units, said })
    }

    /// What stands in brackets around a whole condition, and what follows them.
    fn unbracketed(&self, span: Span) -> Option<(Span, Range<usize>)> {
        let start = span.range().start;
        let mut depth = 0_usize;
        let close = self.within(span).find(|own| {
            match own.mark {
                Mark::Bracket('(' | '[') => depth += 1,
                Mark::Bracket(')' | ']') => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth == 0
        })?;
        let opens = self.text[start..].starts_with('(') && close.at.start > start;
        let (inner, behind) = (
            Span::new(start + 1, close.at.start.max(start + 1)),
            close.at.end..span.range().end,
        );
        let is_whole =
            opens && self.relates(inner) && !self.relates(Span::new(behind.start, behind.end));
        is_whole.then(|| (trimmed(self.text, inner), behind))
    }

    /// `[a, b)`, `]a; b]`, `x in [a, b]`, and the calls of programs for such.
    fn interval(&self, span: Span, units: &mut Vec<Passage<'t>>) -> Read<'t, Said<'t>> {
        let (start, end) = (span.range().start, span.range().end);
        if let Some(called) = self.called(span) {
            return called;
        }
        let mut marks = self.within(span);
        let open = marks.find(|own| matches!(own.mark, Mark::Bracket('[' | '(' | ']')));
        let Some(open) = open else {
            return self
                .value(span)
                .ok_or(RangeError::NoCondition(self.side(span.range())));
        };
        let closing = marks.filter(|own| matches!(own.mark, Mark::Bracket(']' | ')' | '[')));
        let close = closing.last().ok_or(RangeError::Bracket)?;
        let unit = self.side(close.at.end..end);
        units.extend(Some(unit).filter(|unit| !unit.is_empty()));
        Ok(Said::Interval {
            subject: self.subject(start..open.at.start),
            ends: self.ends(Span::new(open.at.end, close.at.start))?,
            open: Some([
                open.mark != Mark::Bracket('['),
                close.mark != Mark::Bracket(']'),
            ]),
        })
    }

    /// The one value that is given beside a range, `x < 3 m or x = 3 m`.
    fn value(&self, span: Span) -> Option<Said<'t>> {
        let text = &self.text[span.range()];
        let (subject, value) = text.split_once('=').filter(|_| relates(self.text))?;
        let value = Passage::of(value);
        Some(Said::Interval {
            subject: Some(Passage::of(subject)),
            ends: [value, value],
            open: Some([false, false]),
        })
    }

    /// What stands before an interval, without the sign that says that it lies there.
    fn subject(&self, lead: Range<usize>) -> Option<Passage<'t>> {
        let lead = Span::new(lead.start, lead.end);
        let element = self
            .within(lead)
            .filter(|own| own.mark == Mark::Element)
            .last();
        let end = element
            .filter(|own| self.side(own.at.end..lead.range().end).is_empty())
            .map_or(lead.range().end, |own| own.at.start);
        let typed = self.side(lead.range());
        let own = self.text[lead.range().start..end].trim_end();
        let own = Passage::of(own.trim_end_matches(['=', ':']));
        (!typed.is_empty()).then_some(own)
    }

    /// The two ends of an interval: a comma parts them unless a semicolon does.
    fn ends(&self, body: Span) -> Read<'t, [Passage<'t>; 2]> {
        let mut ends = cut(self.text, body, &[';']);
        if ends.len() == 1 {
            let spaced = self.text[body.range()].find(", ");
            ends = match spaced.filter(|_| self.mark == DecimalMark::Comma) {
                Some(at) => {
                    let at = body.range().start + at;
                    vec![
                        Span::new(body.range().start, at),
                        Span::new(at + 1, body.range().end),
                    ]
                }
                None => cut(self.text, body, &[',']),
            };
        }
        match ends[..] {
            [low, high] => Ok([low, high].map(|end| self.side(end.range()))),
            _ => Err(RangeError::TwoEnds),
        }
    }

    /// `Interval(0.2, oo)` of SymPy, `Interval[{0.2, 1}]` of Mathematica, `RealRange(Open(0.2), 1)` of Maple.
    fn called(&self, span: Span) -> Option<Read<'t, Said<'t>>> {
        let text = &self.text[span.range()];
        let start = span.range().start;
        let found = CALLS
            .iter()
            .find_map(|(name, open)| Some((start + text.find(name)?, *name, *open)));
        let (at, name, mut open) = found?;
        let body = at + name.len();
        let close = super::fold::arguments_of_call(&self.text[body..span.range().end]).0?;
        let ends = match self.ends(Span::new(body, body + close)) {
            Ok(ends) => ends,
            Err(error) => return Some(Err(error)),
        };
        let opened = |end: Passage<'t>| {
            Some(Passage::of(
                end.text().strip_prefix("Open(")?.strip_suffix(')')?,
            ))
        };
        for (end, open) in ends.iter().zip(&mut open) {
            *open |= opened(*end).is_some();
        }
        Some(Ok(Said::Interval {
            subject: self.subject(start..at),
            ends: ends.map(|end| opened(end).unwrap_or(end)),
            open: Some(open),
        }))
    }
}

/// An answer without the brackets around all of it.
fn without_brackets(text: &str) -> &str {
    let inner = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let inner = inner.filter(|inner| relates(inner) && !inner.contains(['(', ')']));
    inner.unwrap_or(text)
}

fn relates(text: &str) -> bool {
    text.contains(['<', '>', '≤', '≥'])
}

/// The condition of a set in braces, `{x | 0 < x < 3}`.
fn condition_of_set(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('{')?.strip_suffix('}')?;
    let (element, condition) = inner.split_once(['|', ':'])?;
    (!relates(element) && (relates(condition) || condition.contains('∈'))).then_some(condition)
}
