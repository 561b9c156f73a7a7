//! What a run says when all is marked.

use vibank::answer::Verdict;
use vibank::output::{Decided, Lost};

use super::analysis::Analysis;
use super::changes::Changes;
use super::{gradebook, standings};
use crate::cli::folder::Folder;
use crate::cli::sheet::PROGRAM;
use crate::cli::table::Dialect;
use crate::cli::{Failure, counted};

/// Changed marks that are printed; all are in `changes.csv`.
const MAX_CHANGES: usize = 40;

/// The marks that differ from those of an earlier run.
pub(crate) struct Earlier {
    pub(crate) rows: Vec<String>,
    /// The program that marked then.
    program: Option<String>,
}

impl Earlier {
    /// Writes the table of changes.
    pub(crate) fn of(changes: Changes, out: &Folder, dialect: Dialect) -> Result<Self, Failure> {
        let program = changes.program.clone();
        let rows = changes.finish(out, dialect)?;
        Ok(Self { rows, program })
    }

    pub(crate) fn tell(&self) {
        let other = self.program.as_ref().filter(|before| *before != PROGRAM);
        let before = other.map_or_else(String::new, |before| {
            format!(", which {before} marked; this is {PROGRAM}")
        });
        let count = self.rows.len();
        let differ = if count == 1 { "differs" } else { "differ" };
        let marks = counted(count, "mark");
        println!("{marks} {differ} from the earlier run{before}");
        for row in self.rows.iter().take(MAX_CHANGES) {
            println!("  {row}");
        }
        if count > MAX_CHANGES {
            println!("  and {} more, in changes.csv", count - MAX_CHANGES);
        }
    }
}

/// What was decided, each with the marks that it has changed.
pub(crate) fn decided(decided: &[Decided]) {
    if decided.is_empty() {
        return;
    }
    let changed: usize = decided.iter().map(|own| own.changed.len()).sum();
    let have = if decided.len() == 1 { "has" } else { "have" };
    let decisions = counted(decided.len(), "decision");
    println!("{decisions} {have} changed {}", counted(changed, "mark"));
    // Each has room for some of its marks, however many the first of them has changed.
    let room = (MAX_CHANGES / decided.len()).max(3);
    let mut left = MAX_CHANGES;
    for own in decided.iter().filter(|own| !own.who.is_empty()) {
        println!("  {}: {}, by {}", own.subject, own.words, own.who);
        let shown = own.changed.len().min(room).min(left);
        for mark in &own.changed[..shown] {
            let student = if mark.student.is_empty() {
                ""
            } else {
                &format!(" ({})", mark.student)
            };
            let place = format!("{}{}", mark.question, mark.letter);
            println!("    {}{student} {place}: {}", mark.code, mark);
        }
        if shown < own.changed.len() {
            println!(
                "    and {} more, in decisions.csv",
                own.changed.len() - shown
            );
        }
        left -= shown;
    }
}

/// The students whom a gradebook cannot name.
pub(crate) fn gradebook_lacks(unknown: &[String], column: &str) {
    if !unknown.is_empty() {
        eprintln!(
            "not in `{}`, since the class list has no `{column}` for them: {}",
            gradebook::FILE,
            unknown.join(", ")
        );
    }
}

/// Items that the bank has in another form now.
pub(crate) fn items_moved_on(changed: &[String], accepts: bool, has_earlier: bool) {
    if changed.is_empty() {
        return;
    }
    let list = changed.join(", ");
    if !accepts {
        eprintln!(
            "marked as handed out, though the bank has moved on: {list}; `--accept-revisions` marks with its items"
        );
        return;
    }
    eprintln!("marked with changed items: {list}");
    if !has_earlier {
        eprintln!(
            "there are no earlier marks to compare with; give them with `--compare results.json`"
        );
    }
}

/// The files of a run.
pub(crate) struct WrittenFiles<'a> {
    pub(crate) out: &'a Folder,
    pub(crate) analysis: &'a Analysis,
    /// The name of the table of marks.
    pub(crate) marks: &'static str,
    pub(crate) has_gradebook: bool,
    pub(crate) has_changes: bool,
    pub(crate) has_groups: bool,
    pub(crate) has_decisions: bool,
    pub(crate) makes_feedback: bool,
}

/// Most students who are named in a line.
const MAX_NAMED: usize = 12;

impl WrittenFiles<'_> {
    /// How many verdicts of each kind there are, and what is in which file.
    pub(crate) fn tell(&self) {
        let file = |name: &str, what: &str| {
            println!("  {:<28} {what}", self.out.root().join(name).display());
        };
        let counts: Vec<String> = self
            .analysis
            .verdicts()
            .map(|(verdict, count)| match verdict {
                Verdict::Unreadable => (count - self.analysis.open(), verdict.name()),
                _ => (count, verdict.name()),
            })
            .chain([(self.analysis.open(), "open")])
            .filter(|(count, _)| *count > 0)
            .map(|(count, name)| format!("{count} {name}"))
            .collect();
        let sheets = counted(self.analysis.marked(), "sheet");
        println!("{sheets}: {}", counts.join(", "));
        match self.analysis.unused() {
            0 => {}
            1 => println!("1 spare sheet has no answer, and is in no statistics"),
            count => println!("{count} spare sheets have no answer, and are in no statistics"),
        }
        match &self.analysis.absent()[..] {
            [] => {}
            [one] => println!("1 student has no answer and counts as absent: {one}"),
            all => {
                let named = all[..all.len().min(MAX_NAMED)].join(", ");
                let others = match all.len().saturating_sub(MAX_NAMED) {
                    0 => String::new(),
                    count => format!(" and {count} more"),
                };
                println!(
                    "{} students have no answer and count as absent: {named}{others}",
                    all.len()
                );
            }
        }
        if self.analysis.count(Verdict::Unreadable) > 0 {
            file(
                "unreadable.csv",
                "what is not decided, like answers in one row; fill it in and give it with `--overrides`",
            );
        }
        file(
            "report.html",
            "item analysis; report.json and report.csv for programs",
        );
        file(self.marks, "one row a sheet");
        if self.has_gradebook {
            file(
                gradebook::FILE,
                "for the gradebook of the platform, without the marks that are not decided",
            );
        }
        file(
            "details.csv",
            "one row a part, with reading and reasons; results.json for programs",
        );
        if self.has_groups {
            file(standings::FILE, "mean, median, spread and passes by group");
        }
        if self.has_decisions {
            file(
                "decisions.csv",
                "what was decided, and the marks it has changed",
            );
        }
        if self.has_changes {
            file("changes.csv", "marks that differ from the earlier run");
        }
        if self.makes_feedback {
            file("feedback", "a page for each sheet");
        }
    }
}

/// What needs a teacher's eye, on standard error.
pub(crate) fn needs_a_look(analysis: &Analysis, lost: &[Lost], faults: &[String]) {
    let unreadable = analysis.count(Verdict::Unreadable) - analysis.open();
    let are = |count: u64| if count == 1 { "is" } else { "are" };
    let title = format!(
        "{unreadable} could not be read, and {} not yet decided:",
        are(unreadable)
    );
    let of = |by_hand: bool| lost.iter().filter(move |lost| lost.by_hand == by_hand);
    listed(&title, &mut of(false).map(line_of), of(false).count());
    let open = analysis.open();
    let wrong = || of(true).filter(|lost| !lost.response.is_empty());
    if open > 0 {
        eprintln!(
            "{} {} open: a person marks them, and gives the points with the responses",
            counted(open as usize, "part"),
            are(open)
        );
    }
    listed(
        "points that could not be read:",
        &mut wrong().map(|lost| lost.why.clone()),
        wrong().count(),
    );
    listed(
        "rows to look at:",
        &mut faults.iter().cloned(),
        faults.len(),
    );
}

/// Lines under a title, as many as a screen shows.
fn listed(title: &str, lines: &mut dyn Iterator<Item = String>, count: usize) {
    // About what a screen shows at once; the tables have all of them.
    const MAX_COUNT: usize = 40;
    if count == 0 {
        return;
    }
    eprintln!("{title}");
    lines.take(MAX_COUNT).for_each(|line| eprintln!("  {line}"));
    if count > MAX_COUNT {
        eprintln!("  and {} more", count - MAX_COUNT);
    }
}

/// Answers that are alike, in a line.
fn line_of(lost: &Lost) -> String {
    let response: String = lost
        .response
        .chars()
        .take(60)
        .filter(|char| !char.is_control())
        .collect();
    let place = format!("{}{}", lost.question, lost.letter);
    match lost.sheets.as_slice() {
        [one] => format!("{} {place} {}: `{response}`", one.code, one.who()).replace(" : ", ": "),
        sheets => format!("{} times {place}: `{response}`", sheets.len()),
    }
}
