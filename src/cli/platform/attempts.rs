//! Which of the attempts of a student counts.

use std::collections::BTreeMap;

use super::ColumnAnswer;
use super::origin::Interaction;
use super::sheets::TakenAttempt;

/// Which of several attempts of a student counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Which {
    /// The earliest by its time, or by its place in the file where times are absent.
    First,
    /// The latest, likewise.
    Last,
    /// The one with the most points, the later one of equals.
    Best,
}

impl Which {
    /// What it is called in messages.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Last => "last",
            Self::Best => "best",
        }
    }

    /// Whether a try at a part of a package counts in place of one that is known: what the page has said that it is
    /// worth decides on the best, the later one of equals.
    pub(super) fn replaces(
        self,
        own: &Interaction,
        answer: &ColumnAnswer,
        (known, known_answer): (&Interaction, &ColumnAnswer),
    ) -> bool {
        let is_later = own.attempt >= known.attempt;
        match self {
            Self::First => !is_later,
            Self::Last => is_later,
            Self::Best => match answer.result.partial_cmp(&known_answer.result) {
                Some(std::cmp::Ordering::Equal) | None => is_later,
                Some(order) => order.is_gt(),
            },
        }
    }

    /// The attempts that count, in the order in which their students come first; `points` are asked for the best only.
    pub(crate) fn choose<P: PartialOrd>(
        self,
        attempts: Vec<TakenAttempt>,
        points: &[P],
    ) -> Vec<TakenAttempt> {
        let mut students: BTreeMap<String, usize> = BTreeMap::new();
        let mut chosen: Vec<(usize, TakenAttempt)> = Vec::new();
        for (at, taken) in attempts.into_iter().enumerate() {
            let Some(place) = students.get(taken.student()).copied() else {
                students.insert(taken.student().to_owned(), chosen.len());
                chosen.push((at, taken));
                continue;
            };
            let (known, first) = &chosen[place];
            let is_later = taken.is_after(first);
            let replaces = match self {
                Self::First => !is_later,
                Self::Last => is_later,
                Self::Best => match points[at].partial_cmp(&points[*known]) {
                    Some(std::cmp::Ordering::Equal) | None => is_later,
                    Some(order) => order.is_gt(),
                },
            };
            if replaces {
                chosen[place] = (at, taken);
            }
        }
        chosen.into_iter().map(|(_, taken)| taken).collect()
    }
}
