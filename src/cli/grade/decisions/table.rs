//! Overrides: a table in which a teacher settles what could not be read, and changes any other mark.
//!
//! CSV with the columns `code`, `question`, `part`, and any of `response` (what to read instead), `points` and
//! `feedback`; `who` and `why` say who settled it and why. A code `*` stands for all sheets: with `item` for all that ask
//! this item, whichever number it has there, and the part of this `id` or letter; with `given` too for those that gave
//! these words to it. Without `item` the question has to be the same on all sheets. Other columns are ignored. The file
//! `unreadable.csv` of a grading run is such a file, with the last three columns to be filled in.

use std::collections::BTreeMap;
use std::path::Path;

use vibank::grade::Place;
use vibank::numerics::Rational;
use vibank::seed::Variant;

use super::{ALL, Decision, Decisions, Effect};
use crate::cli::grade::outcome::fraction;
use crate::cli::grade::undecided::AlikeAnswers;
use crate::cli::table::Table;
use crate::cli::{Failure, responses};

/// What a row settles, as it stands there.
struct Settled<'a> {
    line: usize,
    response: Option<&'a str>,
    points: Option<&'a str>,
    feedback: Option<&'a str>,
    who: &'a str,
    why: &'a str,
}

/// Reads a table into decisions; what is wrong with single rows is reported, and the rest counts.
pub(crate) fn read(decisions: &mut Decisions, path: &Path) -> Result<Vec<String>, Failure> {
    let table = Table::read(path)?;
    let names: Vec<String> = table
        .headings
        .iter()
        .map(|name| name.to_lowercase())
        .collect();
    let column = |name: &str| names.iter().position(|found| found == name);
    let [Some(code), Some(question), Some(part)] = ["code", "question", "part"].map(column) else {
        return Err(
            Failure::new(format!("`{}` settles nothing", path.display())).help(
                "the header needs `code`, `question`, `part`, and any of `response`, `points`, `feedback`",
            ),
        );
    };
    let [response, points, feedback] = ["response", "points", "feedback"].map(column);
    let words = ["item", "id", "given"].map(column);
    let [who, why] = ["who", "reason"].map(column);
    let mut faults = Vec::new();
    for row in table.rows(&|row| responses::begins_sheet(row, code) || row.cell(code) == ALL) {
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
        let settled = Settled {
            line,
            response: filled(response),
            points: filled(points),
            feedback: filled(feedback),
            who: filled(who).unwrap_or_default(),
            why: filled(why).unwrap_or_default(),
        };
        if settled.is_empty() {
            continue;
        }
        let fault = match field(question).parse() {
            _ if field(code) == ALL && words.iter().all(|at| filled(*at).is_some()) => {
                let [item, id, given] = words.map(|at| filled(at).unwrap_or_default());
                settle_alike(decisions, AlikeAnswers::new(item, id, given), &settled).err()
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
                    settle_item(decisions, (item, part), &settled).err()
                }
            }
            Err(_) => Some(format!("question `{}` is not a number", field(question))),
            Ok(question) => {
                let place = Place {
                    code: printed(field(code)),
                    question,
                    part: field(part).to_lowercase(),
                };
                settle_place(decisions, place, &settled).err()
            }
        };
        faults.extend(fault.map(|fault| format!("overrides, line {line}: {fault}")));
    }
    Ok(faults)
}

/// Settles all answers with these words.
fn settle_alike(
    decisions: &mut Decisions,
    alike: AlikeAnswers,
    settled: &Settled<'_>,
) -> Result<(), String> {
    let (item, id) = (&alike.item, &alike.id);
    let decision = settled.decision(
        format!("`{id}` of `{item}`, where this was answered"),
        format!("`{id}`"),
        format!("nobody gave this answer to part `{id}` of `{item}`"),
    )?;
    settle(&mut decisions.all, &mut decisions.alike, alike, decision)
}

/// Settles a part of an item on all sheets.
fn settle_item(
    decisions: &mut Decisions,
    name: (String, String),
    settled: &Settled<'_>,
) -> Result<(), String> {
    let (item, part) = &name;
    let decision = settled.decision(
        format!("`{part}` of `{item}`"),
        format!("`{part}`"),
        format!("no part `{part}` of `{item}` was handed out"),
    )?;
    settle(&mut decisions.all, &mut decisions.items, name, decision)
}

/// Settles a part by the number of its question.
fn settle_place(
    decisions: &mut Decisions,
    place: Place,
    settled: &Settled<'_>,
) -> Result<(), String> {
    let Place {
        code,
        question,
        part,
    } = &place;
    let decision = settled.decision(
        if code == ALL {
            format!("{question}{part}")
        } else {
            format!("{question}{part} of sheet {code}")
        },
        format!("{question}{part}"),
        format!("no part {question}{part} of a sheet {code} was handed out"),
    )?;
    if code == ALL {
        decisions
            .by_number
            .push((*question, decision.place.clone()));
    }
    settle(&mut decisions.all, &mut decisions.places, place, decision)
}

/// Keeps a decision; one that replaces another is diagnosed.
pub(crate) fn settle<K: Ord>(
    all: &mut Vec<Decision>,
    decisions: &mut BTreeMap<K, usize>,
    key: K,
    decision: Decision,
) -> Result<(), String> {
    let number = all.len();
    all.push(decision);
    let Some(earlier) = decisions.insert(key, number) else {
        return Ok(());
    };
    let place = all[earlier].place.clone();
    // What does not count any more is no doubt either.
    all[earlier].is_claimed = true;
    let place = place.strip_prefix("overrides, ").unwrap_or(&place);
    Err(format!(
        "this part was already settled in {place}; the last one counts"
    ))
}

impl Settled<'_> {
    fn is_empty(&self) -> bool {
        [self.response, self.points, self.feedback]
            .iter()
            .all(Option::is_none)
    }

    /// The decision; one that cannot be read is diagnosed.
    fn decision(&self, subject: String, part: String, unknown: String) -> Result<Decision, String> {
        let points = match self
            .points
            .map(|text| (text, fraction(&text.replace(',', "."))))
        {
            None => None,
            Some((_, Some(points))) if points >= Rational::ZERO => Some(points),
            Some((text, _)) => return Err(format!("`{text}` is not a number of points")),
        };
        let words = match (self.response, self.points) {
            (Some(response), None) => format!("read as `{response}`"),
            (_, Some(points)) => format!("{points} points"),
            (None, None) => "reported to the student".to_owned(),
        };
        Ok(Decision {
            place: format!("overrides, line {}", self.line),
            subject,
            words,
            who: self.who.to_owned(),
            why: self.why.to_owned(),
            effect: Effect::Settle {
                response: self.response.map(str::to_owned),
                points,
            },
            feedback: self.feedback.map(str::to_owned),
            unknown,
            part,
            is_claimed: false,
            exceeded: None,
        })
    }
}

/// A code as it is printed.
fn printed(code: &str) -> String {
    code.parse::<Variant>()
        .map_or_else(|_| code.to_uppercase(), |variant| variant.to_string())
}
