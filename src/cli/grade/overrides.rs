//! Overrides: a file in which a teacher settles what could not be read, and changes any other mark.
//!
//! CSV with the columns `code`, `question`, `part`, and any of `response` (what to read instead), `points` and
//! `feedback`. A code `*` stands for all sheets: with `item` for all that ask this item, whichever number it has there,
//! and the part of this `id` or letter; with `given` too for those that gave these words to it. Without `item` the
//! question has to be the same on all sheets. Other columns are ignored. The file `unreadable.csv` of a grading run is such a file, with the
//! last three columns to be filled in.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use vibank::grade::{Place, rounded};
use vibank::numerics::Rational;
use vibank::seed::Variant;

use super::outcome::fraction;
use super::undecided::Alike;
use crate::cli::table::{Row, Table};
use crate::cli::{Failure, responses};

/// What a teacher decided about a part.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Override {
    line: usize,
    is_claimed: bool,
    /// The points of the part, where more were given.
    exceeded: Option<Rational>,
    /// What is marked in place of what was handed in.
    pub(super) response: Option<String>,
    pub(super) points: Option<Rational>,
    /// What the student is told.
    pub(super) feedback: Option<String>,
}

/// The decisions of a file.
#[derive(Debug, Default)]
pub(super) struct Overrides {
    places: BTreeMap<Place, Override>,
    /// For all sheets with the same words.
    alike: BTreeMap<Alike, Override>,
    /// For all sheets with an item, by its name and the id or letter of the part.
    items: BTreeMap<(String, String), Override>,
}

/// The code that stands for all sheets.
pub(super) const ALL: &str = "*";

impl Overrides {
    /// Reads a file; what is wrong with single lines is told, and the rest counts.
    pub(super) fn read(path: &Path) -> Result<(Self, Vec<String>), Failure> {
        let table = Table::read(path)?;
        let names: Vec<String> = table
            .headings
            .iter()
            .map(|name| name.to_lowercase())
            .collect();
        let column = |name: &str| names.iter().position(|found| found == name);
        let [Some(code), Some(question), Some(part)] = ["code", "question", "part"].map(column)
        else {
            return Err(
                Failure::new(format!("`{}` settles nothing", path.display())).help(
                    "the header needs `code`, `question`, `part`, and any of `response`, `points`, `feedback`",
                ),
            );
        };
        let [response, points, feedback] = ["response", "points", "feedback"].map(column);
        let words = ["item", "id", "given"].map(column);
        let (mut overrides, mut faults) = (Self::default(), Vec::new());
        let begins_row =
            |row: &Row<'_>| responses::begins_sheet(row, code) || row.cell(code) == ALL;
        for row in table.rows(&begins_row) {
            let row = match row {
                Ok(row) => row,
                Err(fault) => {
                    faults.push(format!("overrides, {fault}; this line was left out"));
                    continue;
                }
            };
            let line = row.line;
            let field = |at: usize| row.cell(at);
            let filled = |at: Option<usize>| at.map(field).filter(|text| !text.is_empty());
            let decided = [response, points, feedback].map(filled);
            if decided.iter().all(Option::is_none) {
                continue;
            }
            let fault = match field(question).parse() {
                _ if field(code) == ALL && words.iter().all(|at| filled(*at).is_some()) => {
                    let [item, id, given] = words.map(|at| filled(at).unwrap_or_default());
                    let alike = Alike::new(item, id, given);
                    settle(&mut overrides.alike, alike, line, decided).err()
                }
                _ if field(code) == ALL && filled(words[0]).is_some() => {
                    let item = filled(words[0]).unwrap_or_default().to_owned();
                    let part =
                        filled(words[1]).map_or_else(|| field(part).to_lowercase(), str::to_owned);
                    if part.is_empty() {
                        Some(format!(
                            "no `part` and no `id` says which part of `{item}` is meant"
                        ))
                    } else {
                        settle(&mut overrides.items, (item, part), line, decided).err()
                    }
                }
                Err(_) => Some(format!("question `{}` is no number", field(question))),
                Ok(question) => {
                    let place = Place {
                        code: printed(field(code)),
                        question,
                        part: field(part).to_lowercase(),
                    };
                    settle(&mut overrides.places, place, line, decided).err()
                }
            };
            faults.extend(fault.map(|fault| format!("overrides, line {line}: {fault}")));
        }
        Ok((overrides, faults))
    }

    /// What was decided about a part: for its own sheet, else for all with these words, else for all.
    pub(super) fn find(&self, place: &Place, alike: &Alike) -> Option<&Override> {
        let own = self.places.get(place);
        own.or_else(|| self.alike.get(alike))
            .or_else(|| {
                named(place, alike)
                    .iter()
                    .find_map(|name| self.items.get(name))
            })
            .or_else(|| self.places.get(&everywhere(place)))
    }

    /// Refuses a decision for all sheets by the number of a question that is another one on others.
    pub(super) fn check(&self, asked: &BTreeMap<usize, BTreeSet<String>>) -> Result<(), Failure> {
        for (place, decision) in self.places.iter().filter(|(place, _)| place.code == ALL) {
            let items = asked.get(&place.question).filter(|items| items.len() > 1);
            let Some(items) = items else { continue };
            let (line, number) = (decision.line, place.question);
            let names: Vec<String> = items
                .iter()
                .take(3)
                .map(|item| format!("`{item}`"))
                .collect();
            let names = names.join(", ");
            let failure = Failure::new(format!(
                "overrides, line {line}: question {number} is not the same on all sheets: {names}"
            ));
            return Err(failure.help(
                "name what is meant in the columns `item` and `id`, such as those of `unreadable.csv`; the number then does not matter",
            ));
        }
        Ok(())
    }

    /// Notes that a part was handed out, with so many points at most.
    pub(super) fn claim(&mut self, place: &Place, alike: &Alike, most: Rational) {
        let decisions = [self.places.get_mut(place), self.alike.get_mut(alike)];
        decisions
            .into_iter()
            .flatten()
            .for_each(|decision| decision.claim(most));
        if let Some(decision) = self.places.get_mut(&everywhere(place)) {
            decision.claim(most);
        }
        for name in named(place, alike) {
            if let Some(decision) = self.items.get_mut(&name) {
                decision.claim(most);
            }
        }
    }

    /// What looks like a slip, by line: a decision about a part that was not handed out, or more points than it has.
    pub(super) fn doubts(&self) -> Vec<String> {
        let places = self.places.iter().map(|(place, decision)| {
            let Place {
                code,
                question,
                part,
            } = place;
            let unknown = format!("no part {question}{part} of a sheet {code} was handed out");
            (decision, format!("{question}{part}"), unknown)
        });
        let alike = self.alike.iter().map(|(alike, decision)| {
            let Alike { item, id, .. } = alike;
            let unknown = format!("nobody gave this answer to part `{id}` of `{item}`");
            (decision, format!("`{id}`"), unknown)
        });
        let items = self.items.iter().map(|((item, part), decision)| {
            let unknown = format!("no part `{part}` of `{item}` was handed out");
            (decision, format!("`{part}`"), unknown)
        });
        let mut doubts: Vec<(usize, String)> = places
            .chain(alike)
            .chain(items)
            .filter_map(|(decision, part, unknown)| {
                Some((decision.line, decision.doubt(&part, unknown)?))
            })
            .collect();
        doubts.sort();
        let told = doubts.into_iter();
        told.map(|(line, doubt)| format!("overrides, line {line}: {doubt}"))
            .collect()
    }
}

/// The names by which a part of an item is decided upon for all: its id, and its letter.
fn named(place: &Place, alike: &Alike) -> [(String, String); 2] {
    [&alike.id, &place.part].map(|part| (alike.item.clone(), part.clone()))
}

/// The same part on all sheets.
fn everywhere(place: &Place) -> Place {
    Place {
        code: ALL.to_owned(),
        ..place.clone()
    }
}

/// Keeps a decision; one that cannot be read, or replaces another, is diagnosed.
fn settle<K: Ord>(
    decisions: &mut BTreeMap<K, Override>,
    place: K,
    line: usize,
    decided: [Option<&str>; 3],
) -> Result<(), String> {
    let [response, points, feedback] = decided;
    let points = match points.map(|text| (text, fraction(&text.replace(',', ".")))) {
        None => None,
        Some((_, Some(points))) if points >= Rational::ZERO => Some(points),
        Some((text, _)) => return Err(format!("`{text}` is no number of points")),
    };
    let decision = Override {
        line,
        is_claimed: false,
        exceeded: None,
        response: response.map(str::to_owned),
        points,
        feedback: feedback.map(str::to_owned),
    };
    match decisions.insert(place, decision) {
        Some(earlier) => Err(format!(
            "this part was already settled in line {}; the last one counts",
            earlier.line
        )),
        None => Ok(()),
    }
}

impl Override {
    /// Notes that its part was handed out, with so many points.
    fn claim(&mut self, most: Rational) {
        self.is_claimed = true;
        if self.points.is_some_and(|points| points > most) {
            self.exceeded = Some(most);
        }
    }

    fn doubt(&self, part: &str, unknown: String) -> Option<String> {
        if !self.is_claimed {
            return Some(unknown);
        }
        let (points, most) = (self.points?, self.exceeded?);
        Some(format!(
            "{} points were given for part {part}, which has {}; they count as given",
            rounded(points),
            rounded(most)
        ))
    }
}

/// A code as it is printed.
fn printed(code: &str) -> String {
    code.parse::<Variant>()
        .map_or_else(|_| code.to_uppercase(), |variant| variant.to_string())
}
