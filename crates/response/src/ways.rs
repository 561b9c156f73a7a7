//! The readings of a text: where it can be read in two ways, a parser takes that of the rule or departs from it.

use std::collections::VecDeque;

use super::{Typed, TypedError};

/// Most readings that are tried.
const MAX_READINGS: usize = 48;

/// The ways that a parser takes where there are two.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ways {
    /// The places, in the order in which they are met, where it departs from the rule; ascending.
    departures: Vec<usize>,
    met: usize,
}

impl Ways {
    /// Whether to take a way that the rule would take or not.
    pub(crate) fn choose(&mut self, by_rule: bool) -> bool {
        let departs = self.departures.binary_search(&self.met).is_ok();
        self.met += 1;
        by_rule != departs
    }

    /// The ways with one departure more, after the last.
    fn further(&self) -> impl Iterator<Item = Self> {
        let first = self.departures.last().map_or(0, |last| last + 1);
        (first..self.met).map(|place| Self {
            departures: [&self.departures[..], &[place]].concat(),
            met: 0,
        })
    }
}

/// What is read by the rules and otherwise, the fewest departures first.
pub(crate) fn readings<T: PartialEq>(
    parse: impl Fn(&mut Ways) -> Result<T, TypedError>,
) -> Result<Typed<T>, TypedError> {
    let mut ways = Ways::default();
    let value = parse(&mut ways)?;
    let mut others: Vec<T> = Vec::new();
    let mut open: VecDeque<Ways> = ways.further().take(MAX_READINGS).collect();
    for _ in 0..MAX_READINGS {
        let Some(mut ways) = open.pop_front() else {
            break;
        };
        let other = parse(&mut ways);
        open.extend(
            ways.further()
                .take(MAX_READINGS - open.len().min(MAX_READINGS)),
        );
        others.extend(
            other
                .ok()
                .filter(|other| *other != value && !others.contains(other)),
        );
    }
    Ok(Typed { value, others })
}
