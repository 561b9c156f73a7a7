//! The item analysis of a grading run as a page for teachers.

use serde::Serialize;

use super::layouts::OutputError;
use super::marks::{MarkedRun, MarksView};
use super::pages::{Pages, Run};
use super::quoted;
use super::words::{ReportWords, filled};
use crate::report::{Common, CommonMistake, Distribution, PartSummary, Summary};

/// A report with what has to be looked at first.
#[derive(Clone, Copy, Debug)]
pub struct Analysed<'a> {
    /// The statistics.
    pub summary: &'a Summary,
    /// Responses that could not be read, like ones together.
    pub lost: &'a [Lost],
    /// How many responses could not be read.
    pub unreadable: u64,
    /// How many spare sheets nobody has used, which the statistics leave out.
    pub unused: usize,
    /// How many students answered nothing and count as absent, whom the statistics leave out.
    pub absent: usize,
    /// Rows that were left out, each with its line.
    pub faults: &'a [String],
    /// The marks of the sheets, where there is more to say of them than points.
    pub marks: Option<&'a MarkedRun>,
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

/// A mark before and after a decision; points that are not decided come after a question mark.
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
    why: Vec<quoted::MessagePiece<'a>>,
    times: usize,
    who: Vec<String>,
}

impl<'a> LostView<'a> {
    fn of(lost: &'a Lost) -> Self {
        // The table of decisions has all words, a page shows where they begin.
        Self {
            place: format!("{}{}", lost.question, lost.letter),
            response: lost.response.chars().take(200).collect(),
            why: quoted::pieces(&lost.why),
            times: lost.sheets.len(),
            who: lost.sheets.iter().map(who).collect(),
        }
    }
}

/// Who a sheet belongs to, and its code.
fn who(sheet: &LostSheet) -> String {
    match sheet.who() {
        who if who.is_empty() => sheet.code.clone(),
        who => format!("{who} ({})", sheet.code),
    }
}

#[derive(Serialize)]
struct ReportPage<'a> {
    run: &'a Run,
    sheets: usize,
    unused: String,
    absent: String,
    lost: Vec<LostView<'a>>,
    unreadable: u64,
    undecided: String,
    undecided_note: Vec<quoted::MessagePiece<'a>>,
    faults: Vec<Vec<quoted::MessagePiece<'a>>>,
    marks: Option<MarksView>,
    decided: Vec<DecidedView<'a>>,
    more_decided: Vec<quoted::MessagePiece<'a>>,
    facts: Vec<[String; 2]>,
    bars: Vec<Bar>,
    parts: Vec<ReportPartView<'a>>,
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
struct ReportPartView<'a> {
    places: String,
    item: &'a str,
    part: &'a str,
    title: &'a str,
    asked: u64,
    /// Widths of the pieces of the bar in percent: right, partial, wrong, unreadable, missing.
    pieces: Vec<ReportPiece<'a>>,
    facility: String,
    discrimination: String,
    hint: &'a str,
    follow_through: String,
    mistakes: Vec<Counted>,
    others: &'a [Common],
}

#[derive(Serialize)]
struct ReportPiece<'a> {
    verdict: &'static str,
    /// The verdict in words.
    words: &'a str,
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

/// The page of an item analysis.
///
/// # Errors
///
/// [`OutputError::Page`].
pub fn report_page(pages: &Pages, analysed: &Analysed<'_>) -> Result<String, OutputError> {
    let summary = analysed.summary;
    let words = &pages.run.words.report;
    let more_decided = analysed.decided.len().saturating_sub(MAX_DECIDED);
    let more = filled(&words.more_decided, &[("count", &more_decided.to_string())]);
    let page = ReportPage {
        run: &pages.run,
        sheets: summary.sheets,
        unused: match analysed.unused {
            0 => String::new(),
            count => filled(&words.unused, &[("count", &count.to_string())]),
        },
        absent: match analysed.absent {
            0 => String::new(),
            count => filled(&words.absent, &[("count", &count.to_string())]),
        },
        lost: analysed.lost.iter().map(LostView::of).collect(),
        unreadable: analysed.unreadable,
        undecided: filled(
            &words.undecided,
            &[("count", &analysed.unreadable.to_string())],
        ),
        undecided_note: quoted::pieces(&words.undecided_note),
        faults: analysed
            .faults
            .iter()
            .map(|fault| quoted::pieces(fault))
            .collect(),
        marks: analysed.marks.map(|marks| marks.view(&pages.run)),
        decided: analysed
            .decided
            .iter()
            .take(MAX_DECIDED)
            .map(|own| decided(pages, own))
            .collect(),
        more_decided: if more_decided > 0 {
            quoted::pieces(&more)
        } else {
            Vec::new()
        },
        facts: facts(pages, summary),
        bars: summary.shares.as_ref().map_or(Vec::new(), bars),
        parts: summary.parts.iter().map(|own| part(pages, own)).collect(),
    };
    pages.layouts.fill("report", &page)
}

fn decided<'a>(pages: &Pages, decided: &'a Decided) -> DecidedView<'a> {
    let report = &pages.run.words.report;
    let mut counts: Vec<(String, usize)> = Vec::new();
    for mark in &decided.changed {
        let words = pages.run.marked(&mark.words(&report.mark));
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
        more: match more {
            0 => String::new(),
            more => filled(&report.other_changes, &[("count", &more.to_string())]),
        },
    }
}

/// Numbers about all sheets, each with its name.
fn facts(pages: &Pages, summary: &Summary) -> Vec<[String; 2]> {
    let words = &pages.run.words.report;
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push([name.to_owned(), value]);
    let percents = |ends: [f64; 2]| {
        let [from, to] = ends.map(percent);
        filled(&words.to, &[("from", &from), ("to", &to)])
    };
    if let Some(shares) = &summary.shares {
        fact(&words.mean, percent(shares.mean));
        if let Some(deviation) = shares.deviation {
            fact(&words.standard_deviation, percent(deviation));
        }
        fact(&words.median, percent(shares.median));
        let quartiles = [shares.lower_quartile, shares.upper_quartile];
        fact(&words.middle_half, percents(quartiles));
        fact(&words.range, percents([shares.lowest, shares.highest]));
    }
    let reliability = summary.reliability;
    let reliability = reliability.map(|alpha| pages.run.marked(&signed(alpha)));
    fact(
        &words.reliability,
        reliability.unwrap_or_else(|| words.no_reliability.clone()),
    );
    if summary.undecided > 0 {
        let [count, all] = [summary.undecided, summary.sheets].map(|own| own.to_string());
        let sheets = filled(&words.left_out, &[("count", &count), ("all", &all)]);
        fact(&words.not_decided, sheets);
    }
    if let Some(error) = summary.measurement_error {
        let points = pages.run.marked(&format!("{error:.1}"));
        fact(&words.error, pages.run.words.points(&points, false));
    }
    facts
}

fn part<'a>(pages: &'a Pages, part: &'a PartSummary) -> ReportPartView<'a> {
    let words = &pages.run.words.report;
    let counts = [
        ("right", &*words.right, part.right),
        ("partial", &words.partial, part.partial),
        ("wrong", &words.wrong, part.wrong),
        ("unreadable", &words.unreadable, part.unreadable),
        ("missing", &words.missing, part.missing),
    ];
    let mut x = 0.0;
    let pieces =
        counts
            .into_iter()
            .filter(|(_, _, count)| *count > 0)
            .map(|(verdict, words, count)| {
                let width = (count as f64 / part.asked as f64 * 1000.0).round() / 10.0;
                let piece = ReportPiece {
                    verdict,
                    words,
                    x,
                    width,
                    count,
                };
                x += width;
                piece
            });
    let discrimination = part
        .discrimination
        .map(|own| pages.run.marked(&signed(own)));
    ReportPartView {
        places: part.places.join(", "),
        item: &part.item,
        part: &part.part,
        title: &part.title,
        asked: part.asked,
        pieces: pieces.collect(),
        facility: part.facility.map_or_else(|| "–".to_owned(), percent),
        discrimination: discrimination.unwrap_or_else(|| "–".to_owned()),
        hint: hint(part, words),
        follow_through: match part.follow_through {
            0 => String::new(),
            count => filled(&words.follow_through, &[("count", &count.to_string())]),
        },
        mistakes: part
            .mistakes
            .iter()
            .map(|own| counted(pages, own))
            .collect(),
        others: &part.others,
    }
}

/// A mistake in the words of its item, a slip in the language of the page.
fn counted(pages: &Pages, mistake: &CommonMistake) -> Counted {
    let slip = pages.run.spoken().slip(&mistake.code);
    Counted {
        what: slip.unwrap_or(&mistake.what).to_owned(),
        count: mistake.count,
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
    subject: Vec<quoted::MessagePiece<'a>>,
    words: Vec<quoted::MessagePiece<'a>>,
    who: &'a str,
    why: &'a str,
    times: usize,
    /// How often which mark became which.
    changes: Vec<String>,
    /// How many other changes there are.
    more: String,
}

impl DecidedMark {
    /// `0 of 2 → 2 of 2`, as a phrase says points and what can be reached.
    fn words(&self, phrase: &str) -> String {
        let before = [("points", &*self.points_before), ("max", &self.max_before)];
        let now = [("points", &*self.points), ("max", &self.max)];
        format!("{} → {}", filled(phrase, &before), filled(phrase, &now))
    }
}

impl std::fmt::Display for DecidedMark {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.words("{points} of {max}"))
    }
}

fn bars(shares: &Distribution) -> Vec<Bar> {
    let most = shares.tenths.iter().copied().max().unwrap_or(1).max(1) as f64;
    let bars = shares.tenths.iter().enumerate().map(|(tenth, count)| {
        let height = (HEIGHT * *count as f64 / most * 10.0).round() / 10.0;
        Bar {
            x: tenth as u32 * 20,
            y: HEIGHT - height,
            height,
            count: *count,
            from: tenth as u32 * 10,
        }
    });
    bars.collect()
}

/// What a teacher may want to look at; the bounds are the customary ones of classical test theory.
fn hint<'w>(part: &PartSummary, words: &'w ReportWords) -> &'w str {
    // Of ten students the standard error of a facility of a half is 0.16: of fewer it says nothing.
    const FEW: u64 = 10;
    let (facility, discrimination) = (
        part.facility.unwrap_or(0.5),
        part.discrimination.unwrap_or(1.0),
    );
    if part.asked < FEW {
        ""
    } else if discrimination < 0.0 {
        &words.negative
    } else if facility < 0.2 {
        &words.very_hard
    } else if facility > 0.9 {
        &words.very_easy
    } else if discrimination < 0.15 {
        &words.hardly_discriminates
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
