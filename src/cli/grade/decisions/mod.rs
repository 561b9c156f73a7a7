//! What was decided about marks after the sheets were handed out, whichever file says it.
//!
//! `decisions.toml` stands beside the manifest: each decision is about a part of an item and says who decided it and why.
//! A table of overrides ([`table`]) settles single marks, row by row. Both come to the same [`Decision`]s, of which a
//! [`Ruling`] says what holds for one part of one sheet.

mod correct;
pub(crate) mod file;
mod log;
pub(crate) mod table;

use std::collections::{BTreeMap, BTreeSet};

use vibank::answer::Credit;
use vibank::grade::{Place, rounded};
use vibank::numerics::Rational;
use vibank::source::Value;
use vibank::worksheet::{Marks, Subject, Void};

use super::undecided::AlikeAnswers;
use crate::cli::Failure;

pub(crate) use self::correct::Corrected;
pub(crate) use self::correct::corrected;
pub(crate) use self::log::{Log, write};

/// The code that stands for all sheets.
pub(crate) const ALL: &str = "*";

/// Something that was decided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Decision {
    /// The file and line that say it.
    place: String,
    /// What it is about, in words.
    subject: String,
    /// What was decided, in words.
    words: String,
    /// Who decided it; may be empty.
    who: String,
    /// Why; may be empty.
    why: String,
    effect: Effect,
    /// What is reported to the student.
    pub(crate) feedback: Option<String>,
    /// What it would be about, if nothing of the kind was handed out.
    unknown: String,
    /// The part, as it is named where it has too many points.
    part: String,
    is_claimed: bool,
    /// The points of the part, where more were given.
    exceeded: Option<Rational>,
}

/// What was decided.
#[derive(Clone, Debug, PartialEq)]
enum Effect {
    /// What is marked in place of what was handed in, or the points.
    Settle {
        response: Option<String>,
        points: Option<Rational>,
    },
    /// The part does not count as it was answered.
    Void(Void),
    /// These answers are worth this much.
    Accept(Vec<String>, Credit),
    /// The key is this value of an item file.
    Key(Value),
}

/// All that was decided about a run.
#[derive(Debug, Default)]
pub(crate) struct Decisions {
    all: Vec<Decision>,
    /// Those that settle a part of one sheet.
    places: BTreeMap<Place, usize>,
    /// The same by the item and the id of the part.
    parts: BTreeMap<Subject, usize>,
    /// For all sheets with the same words.
    alike: BTreeMap<AlikeAnswers, usize>,
    /// For all sheets with an item, by its name and the id or letter of the part.
    items: BTreeMap<(String, String), usize>,
    /// Those that hold beside the ones that settle, by item and part.
    rules: BTreeMap<(String, String), Vec<DecisionRule>>,
    /// The lines of decisions for all sheets by the number of a question alone.
    by_number: Vec<(usize, String)>,
    /// Rules for marks in place of those of the blueprint.
    pub(crate) marks: Option<Marks>,
}

/// The code of the sheet for which a decision holds, all without one, and its number.
type DecisionRule = (Option<String>, usize);

/// A part of one sheet, as a decision names it.
fn subject(place: &Place, alike: &AlikeAnswers) -> Subject {
    Subject {
        sheet: Some(place.code.clone()),
        item: alike.item.clone(),
        part: alike.id.clone(),
    }
}

/// What was decided about one part of one sheet, by the numbers of the decisions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ruling<'a> {
    /// What settles it.
    pub(crate) settled: Option<&'a Decision>,
    /// What is worth something beside the key.
    pub(crate) accepted: Vec<Accepted<'a>>,
    /// That it does not count as it was answered.
    pub(crate) void: Option<(&'a Decision, Void)>,
    /// The numbers of those that hold whatever was answered, from 0.
    pub(crate) numbers: Vec<usize>,
    /// Whether one of them is about this sheet alone, so that somebody has looked at it.
    pub(crate) is_own: bool,
}

/// Answers that are worth something beside the key.
#[derive(Clone, Debug)]
pub(crate) struct Accepted<'a> {
    /// The number of the decision, from 0.
    pub(crate) number: usize,
    pub(crate) decision: &'a Decision,
    pub(crate) texts: &'a [String],
    pub(crate) credit: Credit,
}

impl Ruling<'_> {
    /// Whether nothing was decided.
    pub(crate) fn is_empty(&self) -> bool {
        self.numbers.is_empty() && self.accepted.is_empty()
    }
}

impl Decision {
    /// What is marked in place of what was handed in.
    pub(crate) fn response(&self) -> Option<&str> {
        match &self.effect {
            Effect::Settle { response, .. } => response.as_deref(),
            _ => None,
        }
    }

    /// The points, where they are settled.
    pub(crate) fn points(&self) -> Option<Rational> {
        match &self.effect {
            Effect::Settle { points, .. } => *points,
            _ => None,
        }
    }

    /// Notes that its part was handed out, with this many points.
    fn claim(&mut self, most: Rational) {
        self.is_claimed = true;
        if self.points().is_some_and(|points| points > most) {
            self.exceeded = Some(most);
        }
    }

    /// What looks like a slip.
    fn doubt(&self) -> Option<String> {
        if !self.is_claimed {
            return Some(self.unknown.clone());
        }
        let (points, most) = (self.points()?, self.exceeded?);
        Some(format!(
            "{} points were given for part {}, which has {}; they count as given",
            rounded(points),
            self.part,
            rounded(most)
        ))
    }
}

impl Decisions {
    /// Whether nothing was decided.
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// What holds for a part: what settles it for its own sheet, else for all with these words, else for all; and what
    /// holds beside that.
    pub(crate) fn ruling(&self, place: &Place, alike: &AlikeAnswers) -> Ruling<'_> {
        let settled = self.settling(place, alike);
        let mut ruling = Ruling {
            settled: settled.map(|number| &self.all[number]),
            numbers: settled.into_iter().collect(),
            is_own: self.is_about(place, alike),
            ..Ruling::default()
        };
        let rules = self.rules.get(&(alike.item.clone(), alike.id.clone()));
        for (code, number) in rules.into_iter().flatten() {
            if code.as_ref().is_some_and(|code| *code != place.code) {
                continue;
            }
            ruling.is_own |= code.is_some();
            let decision = &self.all[*number];
            match &decision.effect {
                Effect::Void(void) => ruling.void = ruling.void.or(Some((decision, *void))),
                Effect::Accept(texts, credit) => {
                    ruling.accepted.push(Accepted {
                        number: *number,
                        decision,
                        texts,
                        credit: *credit,
                    });
                    continue;
                }
                Effect::Settle { .. } | Effect::Key(_) => {}
            }
            ruling.numbers.push(*number);
        }
        ruling
    }

    /// Whether a part of this sheet alone is settled.
    fn is_about(&self, place: &Place, alike: &AlikeAnswers) -> bool {
        self.places.contains_key(place) || self.parts.contains_key(&subject(place, alike))
    }

    fn settling(&self, place: &Place, alike: &AlikeAnswers) -> Option<usize> {
        let own = self.places.get(place);
        own.or_else(|| self.parts.get(&subject(place, alike)))
            .or_else(|| self.alike.get(alike))
            .or_else(|| {
                named(place, alike)
                    .iter()
                    .find_map(|name| self.items.get(name))
            })
            .or_else(|| self.places.get(&everywhere(place)))
            .copied()
    }

    /// Refuses a decision for all sheets by the number of a question that is another one on others.
    pub(crate) fn check(&self, asked: &BTreeMap<usize, BTreeSet<String>>) -> Result<(), Failure> {
        for (number, place) in &self.by_number {
            let items = asked.get(number).filter(|items| items.len() > 1);
            let Some(items) = items else { continue };
            let names: Vec<String> = items
                .iter()
                .take(3)
                .map(|item| format!("`{item}`"))
                .collect();
            let names = names.join(", ");
            let failure = Failure::new(format!(
                "{place}: question {number} is not the same on all sheets: {names}"
            ));
            return Err(failure.help(
                "name what is meant in the columns `item` and `id`, such as those of `unreadable.csv`; the number then does not matter",
            ));
        }
        Ok(())
    }

    /// Notes that a part was handed out, with this many points at most.
    pub(crate) fn claim(&mut self, place: &Place, alike: &AlikeAnswers, most: Rational) {
        let mut found: Vec<usize> = [
            self.places.get(place),
            self.alike.get(alike),
            self.places.get(&everywhere(place)),
        ]
        .into_iter()
        .flatten()
        .copied()
        .collect();
        let names = named(place, alike);
        found.extend(names.iter().filter_map(|name| self.items.get(name)));
        for number in found {
            self.all[number].claim(most);
        }
        let ruling = self.ruling(place, alike);
        let accepted = ruling.accepted.iter().map(|own| own.number);
        let all: Vec<usize> = ruling.numbers.iter().copied().chain(accepted).collect();
        for number in all {
            self.all[number].claim(most);
        }
    }

    /// What looks like a slip, by file and line: a decision about a part that was not handed out, or more points than it
    /// has.
    pub(crate) fn doubts(&self) -> Vec<String> {
        let doubts = self.all.iter().filter_map(|decision| {
            let doubt = decision.doubt()?;
            Some(format!("{}: {doubt}", decision.place))
        });
        doubts.collect()
    }
}

/// The names by which a part of an item is decided upon for all: its id, and its letter.
fn named(place: &Place, alike: &AlikeAnswers) -> [(String, String); 2] {
    [&alike.id, &place.part].map(|part| (alike.item.clone(), part.clone()))
}

/// The same part on all sheets.
fn everywhere(place: &Place) -> Place {
    Place {
        code: ALL.to_owned(),
        ..place.clone()
    }
}
