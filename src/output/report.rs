//! The item analysis of a grading run as a page for teachers.

use serde::Serialize;

use super::layouts::OutputError;
use super::marks::{Marked, MarksView};
use super::pages::{Pages, Run};
use super::quoted;
use crate::report::{Common, Distribution, PartSummary, Summary};

/// A report with what has to be looked at first.
#[derive(Clone, Copy, Debug)]
pub struct Analysed<'a> {
    /// The statistics.
    pub summary: &'a Summary,
    /// Responses that could not be read, like ones together.
    pub lost: &'a [Lost],
    /// How many responses could not be read.
    pub unreadable: u64,
    /// Rows that were left out, each with its line.
    pub faults: &'a [String],
    /// The marks of the sheets, where there is more to say of them than points.
    pub marks: Option<&'a Marked>,
    /// What was decided after the sheets were handed out.
    pub decided: &'a [Decided],
}

/// A decision, and what it has changed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Decided {
    /// The file and line that say it.
    pub place: String,
    /// What it is about.
    pub subject: String,
    /// What was decided.
    pub words: String,
    /// Who decided it; may be empty.
    pub who: String,
    /// Why; may be empty.
    pub why: String,
    /// The marks that are others without it.
    pub changed: Vec<DecidedMark>,
}

/// A mark before and after a decision; points that are not decided stand behind a question mark.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct DecidedMark {
    /// Code of the sheet.
    pub code: String,
    /// Identity of the student; may be empty.
    pub student: String,
    /// Number of the question.
    pub question: usize,
    /// Letter of the part.
    pub letter: String,
    /// Its points without the decision.
    pub points_before: String,
    /// What could be reached without it.
    pub max_before: String,
    /// What was given for it, with the decision.
    pub points: String,
    /// What can be reached.
    pub max: String,
}

/// Responses to one part of an item that could not be read, and are alike.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Lost {
    /// Number of the question on the first of the sheets.
    pub question: usize,
    /// Letter of the part there.
    pub letter: String,
    /// The identity of the item, `chapter/name`.
    pub item: String,
    /// The part of the item.
    pub id: String,
    /// What was answered.
    pub response: String,
    /// Why it could not be read.
    pub why: String,
    /// Whether it is work that a person marks.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub by_hand: bool,
    /// Whose they are.
    pub sheets: Vec<LostSheet>,
}

/// A sheet with an answer that could not be read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LostSheet {
    /// The code of the sheet, as it was typed.
    pub code: String,
    /// Identity of the student; may be empty.
    pub student: String,
    /// Name of the student; may be empty.
    pub name: String,
}

impl LostSheet {
    /// Whose it is: name and identity, as far as they are known.
    pub fn who(&self) -> String {
        let words = [&*self.name, &*self.student].into_iter();
        words
            .filter(|word| !word.is_empty())
            .collect::<Vec<_>>()
            .join(" ")
    }
}

/// A row of the list.
#[derive(Serialize)]
struct LostView<'a> {
    place: String,
    response: String,
    why: Vec<quoted::Piece<'a>>,
    times: usize,
    who: Vec<String>,
}

impl<'a> LostView<'a> {
    fn of(lost: &'a Lost) -> Self {
        // The table of decisions has all words, a page shows where they begin.
        let who = |sheet: &LostSheet| match sheet.who() {
            who if who.is_empty() => sheet.code.clone(),
            who => format!("{who} ({})", sheet.code),
        };
        Self {
            place: format!("{}{}", lost.question, lost.letter),
            response: lost.response.chars().take(200).collect(),
            why: quoted::pieces(&lost.why),
            times: lost.sheets.len(),
            who: lost.sheets.iter().map(who).collect(),
        }
    }
}

#[derive(Serialize)]
struct Page<'a> {
    run: &'a Run,
    sheets: usize,
    lost: Vec<LostView<'a>>,
    unreadable: u64,
    faults: Vec<Vec<quoted::Piece<'a>>>,
    marks: Option<MarksView>,
    decided: Vec<DecidedView<'a>>,
    more_decided: usize,
    facts: Vec<[String; 2]>,
    bars: Vec<Bar>,
    parts: Vec<PartView<'a>>,
}

/// A bar of the histogram, in the units of its picture.
#[derive(Serialize)]
struct Bar {
    x: u32,
    y: f64,
    height: f64,
    count: u64,
    from: u32,
}

#[derive(Serialize)]
struct PartView<'a> {
    places: String,
    item: &'a str,
    part: &'a str,
    title: &'a str,
    asked: u64,
    /// Widths of the pieces of the bar in percent: right, partial, wrong, unreadable, missing.
    pieces: Vec<Piece>,
    facility: String,
    discrimination: String,
    hint: &'static str,
    follow_through: u64,
    mistakes: Vec<Counted>,
    others: &'a [Common],
}

#[derive(Serialize)]
struct Piece {
    verdict: &'static str,
    x: f64,
    width: f64,
    count: u64,
}

#[derive(Serialize)]
struct Counted {
    what: String,
    count: u64,
}

/// Height of the histogram, in the units of its picture.
const HEIGHT: f64 = 60.0;

impl Pages {
    /// The page of an item analysis.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn report(&self, analysed: &Analysed<'_>) -> Result<String, OutputError> {
        let summary = analysed.summary;
        let page = Page {
            run: &self.run,
            sheets: summary.sheets,
            lost: analysed.lost.iter().map(LostView::of).collect(),
            unreadable: analysed.unreadable,
            faults: analysed
                .faults
                .iter()
                .map(|fault| quoted::pieces(fault))
                .collect(),
            marks: analysed.marks.map(|marks| marks.view(&self.run)),
            decided: analysed
                .decided
                .iter()
                .take(MAX_DECIDED)
                .map(|own| self.decided(own))
                .collect(),
            more_decided: analysed.decided.len().saturating_sub(MAX_DECIDED),
            facts: facts(summary),
            bars: summary.shares.as_ref().map_or(Vec::new(), bars),
            parts: summary.parts.iter().map(part).collect(),
        };
        self.layouts.fill("report", &page)
    }

    fn decided<'a>(&self, decided: &'a Decided) -> DecidedView<'a> {
        let mut counts: Vec<(String, usize)> = Vec::new();
        for mark in &decided.changed {
            let words = self.run.marked(&mark.words());
            match counts.iter_mut().find(|(own, _)| *own == words) {
                Some((_, count)) => *count += 1,
                None => counts.push((words, 1)),
            }
        }
        counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let more = counts.len().saturating_sub(MAX_CHANGES);
        counts.truncate(MAX_CHANGES);
        DecidedView {
            place: &decided.place,
            subject: quoted::pieces(&decided.subject),
            words: quoted::pieces(&decided.words),
            who: &decided.who,
            why: &decided.why,
            times: decided.changed.len(),
            changes: counts
                .into_iter()
                .map(|(words, count)| format!("{count}× {words}"))
                .collect(),
            more,
        }
    }
}

/// Decisions that the page lists; the table of decisions has all.
const MAX_DECIDED: usize = 100;

/// Different changes that the page lists of a decision.
const MAX_CHANGES: usize = 6;

/// A decision as a layout shows it.
#[derive(Serialize)]
struct DecidedView<'a> {
    place: &'a str,
    subject: Vec<quoted::Piece<'a>>,
    words: Vec<quoted::Piece<'a>>,
    who: &'a str,
    why: &'a str,
    times: usize,
    /// How often which mark became which.
    changes: Vec<String>,
    more: usize,
}

impl DecidedMark {
    /// The change in one phrase, such as `0 of 2 → 2 of 2`.
    pub fn words(&self) -> String {
        let Self {
            points_before,
            max_before,
            points,
            max,
            ..
        } = self;
        format!("{points_before} of {max_before} → {points} of {max}")
    }
}

/// Numbers about all sheets, each with its name.
fn facts(summary: &Summary) -> Vec<[String; 2]> {
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push([name.to_owned(), value]);
    if let Some(shares) = &summary.shares {
        fact("mean", percent(shares.mean));
        if let Some(deviation) = shares.deviation {
            fact("standard deviation", percent(deviation));
        }
        fact("median", percent(shares.median));
        let quartiles = [shares.lower_quartile, shares.upper_quartile].map(percent);
        fact("middle half", quartiles.join(" to "));
        fact(
            "range",
            [shares.lowest, shares.highest].map(percent).join(" to "),
        );
    }
    match summary.reliability {
        Some(alpha) => fact("reliability (Cronbach’s α)", signed(alpha)),
        None => fact(
            "reliability",
            "needs the same parts on all sheets".to_owned(),
        ),
    }
    if summary.undecided > 0 {
        let sheets = format!(
            "on {} of {} sheets; their open parts are left out, and the sheets of the reliability",
            summary.undecided, summary.sheets
        );
        fact("not yet decided", sheets);
    }
    if let Some(error) = summary.measurement_error {
        fact("error of measurement", format!("{error:.1} points"));
    }
    facts
}

fn bars(shares: &Distribution) -> Vec<Bar> {
    let most = shares.tenths.iter().copied().max().unwrap_or(1).max(1) as f64;
    let bar = |(tenth, count): (usize, &u64)| {
        let height = (HEIGHT * *count as f64 / most * 10.0).round() / 10.0;
        Bar {
            x: tenth as u32 * 20,
            y: HEIGHT - height,
            height,
            count: *count,
            from: tenth as u32 * 10,
        }
    };
    shares.tenths.iter().enumerate().map(bar).collect()
}

fn part(part: &PartSummary) -> PartView<'_> {
    let counts = [
        ("right", part.right),
        ("partial", part.partial),
        ("wrong", part.wrong),
        ("unreadable", part.unreadable),
        ("missing", part.missing),
    ];
    let mut x = 0.0;
    let pieces = counts
        .into_iter()
        .filter(|(_, count)| *count > 0)
        .map(|(verdict, count)| {
            let width = (count as f64 / part.asked as f64 * 1000.0).round() / 10.0;
            let piece = Piece {
                verdict,
                x,
                width,
                count,
            };
            x += width;
            piece
        });
    PartView {
        places: part.places.join(", "),
        item: &part.item,
        part: &part.part,
        title: &part.title,
        asked: part.asked,
        pieces: pieces.collect(),
        facility: part.facility.map_or_else(|| "–".to_owned(), percent),
        discrimination: part.discrimination.map_or_else(|| "–".to_owned(), signed),
        hint: hint(part),
        follow_through: part.follow_through,
        mistakes: part
            .mistakes
            .iter()
            .map(|mistake| Counted {
                what: mistake.what.clone(),
                count: mistake.count,
            })
            .collect(),
        others: &part.others,
    }
}

/// What a teacher may want to look at; the bounds are the customary ones of classical test theory.
fn hint(part: &PartSummary) -> &'static str {
    // Of ten students the standard error of a facility of a half is 0.16: of fewer it says nothing.
    const FEW: u64 = 10;
    let (facility, discrimination) = (
        part.facility.unwrap_or(0.5),
        part.discrimination.unwrap_or(1.0),
    );
    if part.asked < FEW {
        ""
    } else if discrimination < 0.0 {
        "strong students fared worse than weak ones: look at the text and the key"
    } else if facility < 0.2 {
        "very hard"
    } else if facility > 0.9 {
        "very easy"
    } else if discrimination < 0.15 {
        "hardly tells students apart"
    } else {
        ""
    }
}

/// A coefficient in two decimals.
fn signed(value: f64) -> String {
    format!("{value:.2}").replace('-', "−")
}

fn percent(share: f64) -> String {
    format!("{:.0} %", share * 100.0)
}
