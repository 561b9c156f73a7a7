//! The signs and words of ranges, with their places.

use std::ops::Range;

use super::Bounding;

/// A sign or word that makes ranges of what stands around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Or,
    And,
    Sign(Bounding),
    /// What says that a value lies in a set, `∈` or `in`.
    Element,
    Bracket(char),
}

/// A mark with its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Marked {
    pub(crate) mark: Mark,
    pub(crate) at: Range<usize>,
}

/// The sign of what two sets have in common.
pub(crate) const INTERSECTION: char = '∩';

/// Calls of programs for intervals, and whether each end is left out.
pub(crate) const CALLS: [(&str, [bool; 2]); 7] = [
    ("Interval.open(", [true, true]),
    ("Interval.Lopen(", [true, false]),
    ("Interval.Ropen(", [false, true]),
    ("Interval(", [false, false]),
    ("RealRange(", [false, false]),
    ("Interval[{", [false, false]),
    ("Interval[", [false, false]),
];

/// Words between spaces that join.
const JOINTS: [(&str, Mark); 7] = [
    ("and also", Mark::And),
    ("but", Mark::And),
    ("union", Mark::Or),
    ("or", Mark::Or),
    ("and", Mark::And),
    ("&", Mark::And),
    ("in", Mark::Element),
];

/// The marks of a text.
pub(crate) fn marks(text: &str) -> Vec<Marked> {
    let mut marks: Vec<Marked> = Vec::new();
    let mut at = 0;
    while let Some(char) = text[at..].chars().next() {
        let found = mark(text, at, char, marks.last());
        let length = found.map_or(char.len_utf8(), |(_, length)| length);
        marks.extend(found.map(|(mark, length)| Marked {
            mark,
            at: at..at + length,
        }));
        at += length;
    }
    marks
}

/// The mark at a place, with its length.
fn mark(text: &str, at: usize, char: char, before: Option<&Marked>) -> Option<(Mark, usize)> {
    let width = char.len_utf8();
    let rest = &text[at + width..];
    let sign = |is_less, is_open| Mark::Sign(Bounding { is_less, is_open });
    // What stands between two intervals joins them.
    let is_between = || {
        let is_behind = before.is_some_and(|own| {
            matches!(own.mark, Mark::Bracket(')' | ']' | '['))
                && text[own.at.end..at].trim().is_empty()
        });
        is_behind && begins_interval(rest)
    };
    let mark = match char {
        '<' => sign(true, true),
        '≤' => sign(true, false),
        '>' => sign(false, true),
        '≥' => sign(false, false),
        '∪' => Mark::Or,
        INTERSECTION => Mark::And,
        '∈' => Mark::Element,
        '(' | ')' | '[' | ']' | '{' | '}' => Mark::Bracket(char),
        '|' if rest.starts_with('|') => return Some((Mark::Or, 2)),
        ',' | ';' | 'U' | 'u' if is_between() => Mark::Or,
        // `[0, 1[ m U ]2, 3] m`
        'U' if text[..at].ends_with(' ') && rest.starts_with(' ') && begins_interval(rest) => {
            Mark::Or
        }
        _ => {
            if !(text[..at].is_empty() || text[..at].ends_with(' ')) {
                return None;
            }
            let mut joints = JOINTS
                .iter()
                .filter(|(word, _)| text[at..].starts_with(word));
            let joint = joints.find(|(word, _)| {
                let behind = &text[at + word.len()..];
                // `everything but [0, 1]` joins nothing.
                let joins = *word != "but" || behind.trim_start().starts_with(['<', '>', '≤', '≥']);
                (behind.is_empty() || behind.starts_with(' ')) && joins
            });
            return joint.map(|(word, mark)| (*mark, word.len()));
        }
    };
    Some((mark, width))
}

/// Whether an interval begins a text.
fn begins_interval(text: &str) -> bool {
    let text = text.trim_start();
    text.starts_with(['(', '[', ']']) || CALLS.iter().any(|(name, _)| text.starts_with(name))
}
