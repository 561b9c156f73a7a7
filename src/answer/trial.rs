//! Responses that a kind makes up to test itself: the suite marks them for every part of the bank.

use super::{Marking, Reason, Verdict};
use crate::unit::{Decimal, Unit};

/// A response with what it has to come to.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// What it has to come to.
    pub nature: Nature,
    /// What is typed.
    pub response: String,
}

/// What a made-up response has to come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    /// It is marked right.
    Right,
    /// Right, but only just.
    Borderline,
    /// Not right.
    Wrong,
    /// Not right, for its dimension.
    WrongUnit,
    /// Not to be read.
    Unreadable,
}

impl Trial {
    pub(crate) fn new(nature: Nature, response: impl Into<String>) -> Self {
        Self {
            nature,
            response: response.into(),
        }
    }

    /// Whether a marking of the response is in order.
    pub fn admits(&self, marking: &Marking) -> bool {
        let is_named = matches!(marking.reason(), Reason::Mistake(_));
        match self.nature {
            Nature::Right | Nature::Borderline => marking.verdict == Verdict::Right,
            // A named mistake may be worth everything.
            Nature::Wrong => {
                is_named || matches!(marking.verdict, Verdict::Wrong | Verdict::Partial)
            }
            Nature::WrongUnit => {
                let is_refused = marking.verdict == Verdict::Unreadable;
                is_named || is_refused || marking.reasons().contains(&Reason::Dimension)
            }
            Nature::Unreadable => marking.verdict == Verdict::Unreadable,
        }
    }
}

/// Figures in which made-up numbers are written.
const FIGURES: u32 = 15;

/// A number as it is typed.
pub(crate) fn typed(number: f64) -> String {
    Decimal::rounded(number, FIGURES).map_or_else(|| "0".to_owned(), |decimal| decimal.to_string())
}

/// A unit of another dimension than this one.
pub(crate) fn other_unit(unit: &Unit) -> &'static str {
    let is_other =
        |text: &&str| Unit::parse(text).is_ok_and(|other| other.dimension() != unit.dimension());
    ["kg", "m"].into_iter().find(is_other).unwrap_or("A")
}
