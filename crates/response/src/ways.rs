//! The readings of a text: where it can be read in two ways, a parser takes that of the rule or departs from it.

use std::collections::VecDeque;

use super::{Typed, TypedError};

/// Most readings that are tried.
const MAX_READINGS: usize = 48;

/// What can be read in two ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Doubtful {
    /// How far a divisor goes, `k/2m`.
    Divisor,
    /// Whether a unit belongs to a divisor, `1/0.2s`.
    Unit,
    /// How far an argument goes, `sin 2 t`, `√k/m`.
    Argument,
    /// How far an exponent goes, `e^-λ t`, `a^1/2`.
    Exponent,
    /// Whether a comma is a decimal sign, `max(5,1)`.
    Comma,
}

/// The ways that a parser takes where there are two.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ways {
    /// What it reads against the rule wherever it is met, as people do who know another rule.
    against: Option<Doubtful>,
    /// The places, in the order in which they are met, where it departs from the rule; ascending.
    departures: Vec<usize>,
    met: Vec<Doubtful>,
}

impl Ways {
    /// Whether to take a way that the rule would take or not.
    pub(crate) fn choose(&mut self, what: Doubtful, by_rule: bool) -> bool {
        let departs = self.departures.binary_search(&self.met.len()).is_ok();
        self.met.push(what);
        by_rule != (departs || self.against == Some(what))
    }

    /// The ways that read against the rule what is met more than once.
    fn conventions(&self) -> impl Iterator<Item = Self> {
        let often = |what: &Doubtful| self.met.iter().filter(|met| *met == what).count() > 1;
        let all = [Doubtful::Divisor, Doubtful::Argument].into_iter();
        all.filter(often).map(|what| Self {
            against: Some(what),
            ..Self::default()
        })
    }

    /// The ways with one departure more, after the last.
    fn further(&self) -> impl Iterator<Item = Self> {
        let first = self.departures.last().map_or(0, |last| last + 1);
        (first..self.met.len()).map(|place| Self {
            departures: [&self.departures[..], &[place]].concat(),
            ..Self::default()
        })
    }
}

/// What is read by the rules and otherwise: one convention for the whole text first, then the fewest departures.
pub(crate) fn readings<T: PartialEq>(
    parse: impl Fn(&mut Ways) -> Result<T, TypedError>,
) -> Result<Typed<T>, TypedError> {
    let mut ways = Ways::default();
    let value = parse(&mut ways)?;
    let mut others: Vec<T> = Vec::new();
    let mut keep = |other: Result<T, TypedError>| {
        let is_new = |other: &T| *other != value && !others.contains(other);
        others.extend(other.ok().filter(is_new));
    };
    for mut convention in ways.conventions() {
        keep(parse(&mut convention));
    }
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
        keep(other);
    }
    Ok(Typed { value, others })
}
