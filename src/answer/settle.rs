//! What becomes of a response with more than one reading: the one function that chooses, when an answer is submitted.

use serde_json::Value as Json;

use super::{Marking, Note, Verdict, Why};
use crate::source::{FromJson, Misfit};

/// What to do where readings of a response have different verdicts.
///
/// | response to 15.811 rad/s | `benefit` | `ask` | `undecided` |
/// | --- | --- | --- | --- |
/// | `15,811 rad/s` | right, with a remark | handed back with both readings | to the teacher |
/// | `17,300 rad/s` | wrong | wrong | wrong |
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    serde::Serialize,
    serde::Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum Doubt {
    /// The reading that is right counts, with a remark: on paper nobody can be asked.
    Benefit,
    /// The response is handed back with its readings, and no attempt is spent.
    #[default]
    Ask,
    /// It goes to the teacher.
    Undecided,
}

impl Doubt {
    /// The policies.
    pub const ALL: [Self; 3] = [Self::Benefit, Self::Ask, Self::Undecided];

    /// Its name, as in blueprints and requests.
    pub fn name(self) -> &'static str {
        match self {
            Self::Benefit => "benefit",
            Self::Ask => "ask",
            Self::Undecided => "undecided",
        }
    }

    /// The policy with this name.
    ///
    /// ```
    /// use vibank::answer::Doubt;
    /// assert_eq!(Doubt::of_name("ask"), Some(Doubt::Ask));
    /// ```
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|own| own.name() == name)
    }
}

impl FromJson for Doubt {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let name = String::from_json(json)?;
        Self::of_name(&name).ok_or(Misfit::Expected("a policy of doubt"))
    }
}

/// A reading of a response: how it is shown, and what it comes to.
pub(crate) struct Candidate {
    pub(crate) shown: String,
    pub(crate) marking: Marking,
}

/// Whether the rules that students are given say which of several readings is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rule {
    /// They do, as for products without signs: by them the conventional reading is right without a doubt.
    Stated,
    /// Nothing decides it, as for three digits after a comma.
    None,
}

/// The most readings of a response that are looked at, the conventional one among them.
const MAX_READINGS: usize = 4;

/// The marking of a response by those of its readings, the conventional one first.
/// If none is right, or all come to the same, the first counts.
pub(crate) fn settle(
    doubt: Doubt,
    rule: Rule,
    first: Candidate,
    others: impl IntoIterator<Item = Candidate>,
) -> Marking {
    if rule == Rule::Stated && first.marking.verdict == Verdict::Right {
        return first.marking;
    }
    // What cannot be marked, as an angle of many turns, was not meant.
    let is_read = |reading: &Candidate| reading.marking.verdict != Verdict::Unreadable;
    let mut others = others.into_iter().take(MAX_READINGS - 1).filter(is_read);
    let first = if is_read(&first) {
        first
    } else {
        others.next().unwrap_or(first)
    };
    let differing = others.filter(|other| other.marking.verdict != first.marking.verdict);
    // The best of them, and the first of several that are as good.
    let Some(other) = differing.reduce(|best, other| {
        if other.marking.credit > best.marking.credit {
            other
        } else {
            best
        }
    }) else {
        return first.marking;
    };
    match doubt {
        Doubt::Benefit => {
            let is_better = other.marking.credit > first.marking.credit;
            let (taken, left) = if is_better {
                (other, first)
            } else {
                (first, other)
            };
            let mut marking = taken.marking;
            if marking.verdict == Verdict::Right || is_better {
                let note = Note::TakenAs {
                    taken: taken.shown,
                    other: left.shown,
                };
                marking.remarks.push(note.into());
            }
            marking
        }
        // An unreadable response goes to whoever marks.
        Doubt::Ask | Doubt::Undecided => {
            Marking::unreadable(Why::TwoReadings(first.shown, other.shown))
        }
    }
}

/// The same by [`Rule::Stated`]: the reading is written out only where it is not right.
pub(crate) fn settle_by_rule(
    doubt: Doubt,
    marking: Marking,
    shown: impl FnOnce() -> String,
    others: impl IntoIterator<Item = Candidate>,
) -> Marking {
    if marking.verdict == Verdict::Right {
        return marking;
    }
    let shown = shown();
    settle(doubt, Rule::Stated, Candidate { shown, marking }, others)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::{Answered, Credit, Reading};
    use crate::math::Math;

    fn candidate(shown: &str, credit: Credit) -> Candidate {
        let reading = Reading {
            math: Math::text(shown),
            text: shown.to_owned(),
            answered: Answered::Complex(Vec::new()),
        };
        Candidate {
            shown: shown.to_owned(),
            marking: Marking::read(reading, credit, None),
        }
    }

    fn verdict(doubt: Doubt, first: Credit, other: Credit) -> Verdict {
        settle(
            doubt,
            Rule::None,
            candidate("1.25", first),
            vec![candidate("1250", other)],
        )
        .verdict
    }

    #[test]
    fn a_doubt_is_settled_by_its_policy() {
        let (none, full) = (Credit::NONE, Credit::FULL);
        for (doubt, first, other, due) in [
            (Doubt::Benefit, none, full, Verdict::Right),
            (Doubt::Benefit, full, none, Verdict::Right),
            (Doubt::Benefit, none, none, Verdict::Wrong),
            (Doubt::Ask, none, full, Verdict::Unreadable),
            (Doubt::Ask, full, none, Verdict::Unreadable),
            (Doubt::Ask, full, full, Verdict::Right),
            (Doubt::Ask, none, none, Verdict::Wrong),
            (Doubt::Undecided, none, full, Verdict::Unreadable),
            (Doubt::Undecided, none, none, Verdict::Wrong),
        ] {
            assert_eq!(verdict(doubt, first, other), due, "{doubt:?}");
        }
    }

    #[test]
    fn a_reading_that_cannot_be_marked_was_not_meant() {
        let unreadable = |shown: &str| Candidate {
            shown: shown.to_owned(),
            marking: Marking::unreadable(Why::Form),
        };
        let of = |first, other| settle(Doubt::Ask, Rule::None, first, vec![other]).verdict;
        let right = || candidate("-90", Credit::FULL);
        assert_eq!(of(right(), unreadable("-90000")), Verdict::Right);
        assert_eq!(of(unreadable("-90000"), right()), Verdict::Right);
    }

    #[test]
    fn a_stated_rule_leaves_no_doubt_about_what_is_right_by_it() {
        let of = |first, other| {
            let other = vec![candidate("k/m*2", other)];
            settle(Doubt::Ask, Rule::Stated, candidate("k/(m*2)", first), other).verdict
        };
        assert_eq!(of(Credit::FULL, Credit::NONE), Verdict::Right);
        assert_eq!(of(Credit::NONE, Credit::FULL), Verdict::Unreadable);
    }

    #[test]
    fn what_is_given_the_benefit_says_so() {
        let marking = settle(
            Doubt::Benefit,
            Rule::None,
            candidate("1.25", Credit::NONE),
            vec![candidate("1250", Credit::FULL)],
        );
        let said = format!("{:?}", marking.remarks);
        assert!(said.contains("TakenAs"), "{said}");
    }
}
