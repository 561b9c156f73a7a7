//! `vibank grade MANIFEST RESPONSES`

mod analysis;
mod answered;
mod census;
mod changes;
mod decisions;
mod gradebook;
mod hand;
mod handed;
mod items;
mod journal;
mod layout;
mod manifest;
mod marking;
mod outcome;
mod part;
mod parts;
mod said;
mod standings;
mod tables;
mod undecided;

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use rayon::prelude::*;
use vibank::grade::{Place, Responses, RowError};
use vibank::message::Language;
use vibank::output::{Decided, Lost, MarkedRun, WRITERS};
use vibank::worksheet::{Absence, Marks, VariantEntry};

pub(crate) use self::items::Items as RunItems;
pub(crate) use self::journal::is_journal;
pub(crate) use self::manifest::{manifest, solution};
pub(crate) use self::parts::is_part;

use self::analysis::Analysis;
use self::census::Census;
use self::changes::Changes;
use self::decisions::{Corrected, Decisions, Log};
use self::gradebook::Gradebook;
use self::handed::Handed;
use self::items::Items;
use self::journal::Journal;
use self::layout::Layout;
use self::manifest::Sheets;
use self::marking::Marker;
use self::outcome::SheetOutcome;
use self::parts::Parts;
use self::said::{Earlier, WrittenFiles, gradebook_lacks, items_moved_on, needs_a_look};
use self::standings::Class;
use self::tables::Tables;
use self::undecided::{AlikeAnswers, Undecided};
use super::bank::BankArgument;
use super::folder::Folder;
use super::platform::Which;
use super::saved::{self, Saved};
use super::shard::Shard;
use super::table::Dialect;
use super::table::workbook::{self, XLSX};
use super::{Failure, counted, file_kind, files, progress};

/// Mark the responses to the sheets of a run: marks, reasons, a feedback page for each sheet, item analysis.
///
/// What could not be read is not decided: it comes first in the report, sums show what hangs on it
/// (`14.95 + ?2.5`), and `unreadable.csv`, filled in and given with `--overrides`, settles it. A run that was interrupted goes on where it stopped.
///
/// Example: vibank grade midterm/manifest.json midterm/responses.csv --out midterm/marks
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The manifest of the run, or its folder; the manifest of an export; for a report on a SCORM package the package.
    #[arg(value_parser = file_kind::manifest())]
    manifest: PathBuf,
    /// The responses, as CSV or JSON; a report as Moodle, Canvas or a scanner writes it; or a folder of the files that
    /// the pages of `vibank form` save.
    responses: PathBuf,
    /// The blueprint of a package, if that asks questions of its own.
    #[arg(long, value_name = "FILE")]
    blueprint: Option<PathBuf>,
    /// The folder to write to; `marks` beside the manifest if left out.
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// A CSV file that settles single marks: code, question, part, and response, points or feedback.
    #[arg(long, value_name = "FILE")]
    overrides: Option<PathBuf>,
    /// A file of decisions, each with who decided it and why; `decisions.toml` beside the manifest if left out.
    #[arg(long, value_name = "FILE")]
    decisions: Option<PathBuf>,
    /// Show codes alone, no names and ids, in all that is written; groups stay.
    #[arg(long, conflicts_with = "gradebook")]
    anonymous: bool,
    /// Mark with the items of the bank where they have changed since the sheets were made; changed marks are listed.
    #[arg(long)]
    accept_revisions: bool,
    /// The folder or `results.json` of an earlier run, to list changed marks; that in the output folder if omitted.
    #[arg(long, value_name = "OLD")]
    compare: Option<PathBuf>,
    /// Mark one part of the sheets, such as 2/4, for machines that share the work; then a run without it joins the parts.
    #[arg(long, value_name = "I/N", default_value_t)]
    shard: Shard,
    #[arg(long, value_name = "FORMAT", default_value = "html", help = feedback_formats())]
    feedback: String,
    /// Write no feedback pages.
    #[arg(long, conflicts_with = "feedback")]
    no_feedback: bool,
    /// Which of several attempts of a student counts in the report of a platform, or of the tries at a part of a package.
    #[arg(long, value_name = "WHICH", default_value = "last")]
    attempt: Which,
    /// Also write the marks as the gradebook of a platform imports them.
    #[arg(long, value_name = "PLATFORM")]
    gradebook: Option<gradebook::GradebookPlatform>,
    /// The column of the class list by which that platform knows students.
    #[arg(
        long,
        value_name = "COLUMN",
        default_value = "id",
        requires = "gradebook"
    )]
    gradebook_id: String,
    #[command(flatten)]
    bank: BankArgument,
}

/// Sheets that are marked at once; memory holds no more.
const CHUNK: usize = 256;

pub(crate) fn run(arguments: &Arguments) -> Result<super::Outcome, Failure> {
    let blueprint = arguments.blueprint.as_deref();
    let catalogue = arguments.bank.catalogue_with(blueprint)?;
    let beside = arguments.manifest.parent().unwrap_or(Path::new("."));
    let out = match &arguments.out {
        Some(out) => Folder::at(out),
        None => Folder::within(beside, "marks")?,
    };
    // The manifest first: without it nothing else matters.
    drop(files::open(&arguments.manifest)?);
    out.hold()?;
    let mut faults = Vec::new();
    let mut decisions = Decisions::default();
    if let Some(path) = &arguments.overrides {
        faults.extend(decisions::table::read(&mut decisions, path)?);
    }
    let file = decisions::file::find(arguments.decisions.as_deref(), &arguments.manifest);
    let stated = file.as_deref().map(decisions::file::read).transpose()?;
    let handed = Handed::read(arguments, &catalogue, &decisions)?;
    faults.extend(handed.faults.iter().cloned());
    let names = handed.names.clone();
    // Opened twice: the census has to see all sheets before the first one is marked, and memory holds a chunk
    // of them.
    let open = || handed.sheets(&arguments.manifest);
    let census = Census::take(&mut open()?, &catalogue, arguments.accept_revisions)?;
    let gradebook = arguments
        .gradebook
        .map(|own| Gradebook::new(own, &arguments.gradebook_id, &census.known_by))
        .transpose()?;
    let codes = &census.handed_out.codes;
    faults.extend(Saved::foreign(&names, |code| codes.contains(code)));
    decisions.check(&census.handed_out.questions)?;
    if let Some(stated) = &stated {
        let repeated = decisions::file::add(&mut decisions, stated, &census.handed_out)?;
        faults.extend(repeated);
    }
    let corrected = decisions::corrected(&decisions, &census.items, &census.used)?;
    let sheets = open()?;
    let marks = decisions
        .marks
        .clone()
        .or_else(|| sheets.head.marks.clone());
    let marks = marks.unwrap_or_default();
    let shard = arguments.shard;
    let input = input(arguments, file.as_deref(), &sheets, &catalogue.digest())?;
    let changes = changes(arguments, &out)?;
    let dialect = Dialect::new(sheets.head.csv, sheets.head.decimal);
    let has_book = has_book(&sheets.head.formats);
    let journal = Journal::open(&out, shard, &input)?;
    let parts = shard.is_whole().then(|| Parts::in_folder(&out, &input));
    let share = handed.share(shard, &census.sheets);
    let tables = || {
        Tables::begin(
            &out,
            census.columns,
            census.has_hand,
            marks.clone(),
            dialect,
            has_book,
        )
    };
    let mut job = GradeJob {
        journal,
        parts: parts.transpose()?.flatten(),
        share,
        pages: Layout::of(&sheets, "html", &[])?,
        feedback: Layout::of(&sheets, &arguments.feedback, &census.students)?,
        tables: shard.is_whole().then(tables).transpose()?,
        class: Class::new(marks.clone()),
        log: Log::default(),
        dialect,
        changes,
        analysis: Analysis::default(),
        gradebook,
        unprinted: Mutex::default(),
        undecided: Undecided::default(),
        arguments,
        items: &census.items,
        corrected: &corrected,
        marks: &marks,
        out: &out,
        sheets,
        takes_points: handed.is_typed(),
        has_class: !census.students.is_empty(),
        leaves_absent_out: !census.students.is_empty()
            && handed.is_typed()
            && marks.absent == Absence::LeftOut,
        responses: handed.responses,
        decisions,
    };
    job.mark()?;
    if !shard.is_whole() {
        return job.finish_part(shard);
    }
    // What is of another run was reported by the names of its files.
    let unclaimed = job.responses.unclaimed().into_iter();
    let unclaimed = unclaimed.filter(|error| match error {
        RowError::Unknown { place, .. } => {
            !names.contains_key(&place.code) || census.handed_out.codes.contains(&place.code)
        }
        _ => true,
    });
    faults.extend(unclaimed.map(|error| saved::said(&error, &names)));
    faults.extend(job.decisions.doubts());
    job.finish(&faults, &census.changed)
}

/// The help of `--feedback`, with the formats that there are.
fn feedback_formats() -> String {
    let names: Vec<&str> = WRITERS.iter().map(|writer| writer.name()).collect();
    let known = names.join(", ");
    format!("The format of the feedback pages, as of sheets: {known}")
}

/// Whether the marks are written as a workbook, too.
fn has_book(formats: &[String]) -> bool {
    let is_wanted = formats.iter().any(|format| format == XLSX);
    if is_wanted && !workbook::IS_BUILT_IN {
        eprintln!(
            "`marks.xlsx` is not written, since this program was built without the feature `xlsx`; `marks.csv` has the same marks"
        );
    }
    is_wanted && workbook::IS_BUILT_IN
}

/// What the marks are compared with: those of an earlier run, or those that the folder holds.
fn changes(arguments: &Arguments, out: &Folder) -> Result<Option<Changes>, Failure> {
    match &arguments.compare {
        Some(path) => Ok(Some(Changes::since(path)?)),
        None if out.has("results.json") => Ok(Some(Changes::since(&out.path("results.json")?)?)),
        None => Ok(None),
    }
}

/// What the outcome depends on, in one line.
fn input(
    arguments: &Arguments,
    decisions: Option<&Path>,
    sheets: &Sheets,
    bank: &str,
) -> Result<String, Failure> {
    let overrides = arguments
        .overrides
        .as_deref()
        .map(files::digest_of)
        .transpose()?;
    let decisions = decisions.map(files::digest_of).transpose()?;
    let earlier: Vec<String> = sheets
        .earlier()
        .iter()
        .map(|path| files::digest_of(path))
        .collect::<Result<_, _>>()?;
    let earlier = earlier.concat();
    Ok(format!(
        "vibank {} {}{earlier} {} {} {} {bank} {} {} {} {} {}",
        env!("CARGO_PKG_VERSION"),
        files::digest_of(&arguments.manifest)?,
        saved::digest(&arguments.responses)?,
        overrides.as_deref().unwrap_or("-"),
        decisions.as_deref().unwrap_or("-"),
        arguments.accept_revisions,
        arguments.no_feedback,
        arguments.feedback,
        arguments.attempt.name(),
        arguments.anonymous,
    ))
}

/// A sheet without what says whose it is.
fn anonymous(variant: &VariantEntry) -> VariantEntry {
    let mut variant = variant.clone();
    if let Some(student) = &mut variant.student {
        student.retain(|column, _| column == "group");
    }
    variant
}

/// One run.
struct GradeJob<'a> {
    arguments: &'a Arguments,
    items: &'a Items<'a>,
    corrected: &'a Corrected,
    marks: &'a Marks,
    out: &'a Folder,
    sheets: Sheets,
    responses: Responses,
    /// Whether these are what a teacher typed.
    takes_points: bool,
    /// Whether sheets are those of students, and others are spare.
    has_class: bool,
    /// Whether students without any answer were absent.
    leaves_absent_out: bool,
    decisions: Decisions,
    journal: Journal,
    /// What was marked apart and is joined.
    parts: Option<Parts>,
    /// The places of the sheets that are marked.
    share: Range<usize>,
    pages: Layout,
    feedback: Layout,
    /// Those of the whole run.
    tables: Option<Tables>,
    dialect: Dialect,
    changes: Option<Changes>,
    analysis: Analysis,
    class: Class,
    log: Log,
    /// The gradebook of a platform, where it is wanted.
    gradebook: Option<Gradebook>,
    /// Feedback pages that could not be printed, and why.
    unprinted: Mutex<Vec<String>>,
    undecided: Undecided,
}

/// What the report says beside its statistics.
struct Findings<'a> {
    lost: &'a [Lost],
    faults: &'a [String],
    marks: Option<&'a MarkedRun>,
    decided: &'a [Decided],
}

impl GradeJob<'_> {
    fn mark(&mut self) -> Result<(), Failure> {
        let bar = progress::bar(self.share.len() as u64, "sheets");
        if self.journal.done() > 0 {
            let were = if self.journal.done() == 1 {
                "was"
            } else {
                "were"
            };
            eprintln!(
                "{} {were} marked before the interruption",
                counted(self.journal.done(), "sheet")
            );
        }
        let mut begin = 0;
        while begin < self.share.end {
            let mut chunk = self.sheets.chunk(CHUNK)?;
            let places = begin..begin + chunk.len();
            begin = places.end;
            // What comes before and after its share is marked by others.
            chunk.truncate(self.share.end.saturating_sub(places.start).min(chunk.len()));
            chunk.drain(
                ..self
                    .share
                    .start
                    .saturating_sub(places.start)
                    .min(chunk.len()),
            );
            let outcomes = match &mut self.parts {
                Some(parts) => parts.take(&chunk)?,
                None => self.marked(&chunk)?,
            };
            outcomes
                .iter()
                .try_for_each(|outcome| self.count(outcome))?;
            bar.inc(chunk.len() as u64);
        }
        bar.finish_and_clear();
        self.parts.take().map_or(Ok(()), Parts::finish)
    }

    /// What comes out for sheets, of which an interrupted run may have marked the first ones.
    fn marked(&mut self, chunk: &[VariantEntry]) -> Result<Vec<SheetOutcome>, Failure> {
        let mut outcomes = Vec::with_capacity(chunk.len());
        while outcomes.len() < chunk.len()
            && let Some(outcome) = self.journal.next()
        {
            outcomes.push(outcome);
        }
        let fresh = self.chunk(&chunk[outcomes.len()..])?;
        self.journal.note(&fresh)?;
        outcomes.extend(fresh);
        Ok(outcomes)
    }

    /// Marks sheets and writes their pages.
    fn chunk(&self, variants: &[VariantEntry]) -> Result<Vec<SheetOutcome>, Failure> {
        let marker = Marker {
            items: self.items,
            decimal: self.sheets.decimal,
            language: Language::of(&self.sheets.head.language).unwrap_or_default(),
            doubt: self.sheets.doubt,
            other_form: self.sheets.other_form,
            responses: &self.responses,
            corrected: self.corrected,
            marks: self.marks,
            decisions: &self.decisions,
            takes_points: self.takes_points,
        };
        let marked = variants.par_iter().map(|variant| {
            let (outcome, feedback) = if self.arguments.anonymous {
                marker.sheet(&anonymous(variant))?
            } else {
                marker.sheet(variant)?
            };
            if self.makes_feedback() {
                let layout = &self.feedback;
                let extension = layout.pages.writer().extension();
                let name = format!("{}.{extension}", variant.code);
                match layout.file(&feedback)? {
                    Ok(file) => {
                        self.out.write(&format!("feedback/{name}"), &file)?;
                    }
                    Err(why) => {
                        let line = format!("`feedback/{name}` could not be printed: {why}");
                        self.unprinted().push(line);
                    }
                }
            }
            Ok(outcome)
        });
        marked.collect()
    }

    /// Whether feedback pages are wanted and can be made.
    fn makes_feedback(&self) -> bool {
        !self.arguments.no_feedback && self.feedback.missing.is_none()
    }

    fn unprinted(&self) -> MutexGuard<'_, Vec<String>> {
        self.unprinted
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    fn count(&mut self, outcome: &SheetOutcome) -> Result<(), Failure> {
        let Some(tables) = &mut self.tables else {
            return Ok(());
        };
        let is_absent = self.leaves_absent_out && outcome.unanswered;
        tables.add(outcome, is_absent)?;
        if self.has_class && outcome.is_unused() {
            self.analysis.leave_out();
        } else if is_absent {
            self.analysis.leave_absent_out(outcome);
            if let Some(gradebook) = &mut self.gradebook {
                gradebook.add(outcome, is_absent);
            }
        } else {
            self.analysis.add(outcome);
            self.undecided.add(outcome);
            self.class.add(outcome);
            if let Some(gradebook) = &mut self.gradebook {
                gradebook.add(outcome, is_absent);
            }
        }
        if !is_absent {
            self.log.add(outcome);
        }
        if let Some(changes) = &mut self.changes {
            changes.add(outcome);
        }
        for part in &outcome.parts {
            let place = Place {
                code: outcome.code.clone(),
                question: part.question,
                part: part.letter.clone(),
            };
            self.responses.claim(&place);
            if !self.decisions.is_empty() {
                let alike = AlikeAnswers::of(part);
                self.decisions.claim(&place, &alike, part.max.0);
            }
        }
        Ok(())
    }

    /// Keeps what was marked, to be joined with the other parts.
    fn finish_part(self, shard: Shard) -> Result<super::Outcome, Failure> {
        let unprinted = std::mem::take(&mut *self.unprinted());
        let part = self.journal.become_part(self.share.len())?;
        let sheets = counted(self.share.len(), "sheet");
        println!("{sheets} marked, part {shard}");
        println!(
            "  {:<28} joined with the other parts by the same command without `--shard`",
            self.out.root().join(part).display()
        );
        Ok(self.feedback.ending(&unprinted))
    }

    /// Writes what all sheets together give, and says what came out, in the order in which it is read.
    fn finish(mut self, faults: &[String], changed: &[String]) -> Result<super::Outcome, Failure> {
        let makes_feedback = self.makes_feedback();
        let unprinted = std::mem::take(&mut *self.unprinted());
        let changes = self.changes.take();
        let earlier = changes
            .map(|changes| Earlier::of(changes, self.out, self.dialect))
            .transpose()?;
        let undecided = std::mem::take(&mut self.undecided);
        let lost = undecided.groups();
        undecided::write(&lost, self.out, self.dialect)?;
        let marked = self.class.marked();
        if let Some(marked) = &marked {
            Class::write(marked, self.out, self.dialect)?;
        }
        let decided = std::mem::take(&mut self.log).decided(&self.decisions);
        if !self.decisions.is_empty() {
            decisions::write(&decided, self.out, self.dialect)?;
        }
        let findings = Findings {
            lost: &lost,
            faults,
            marks: marked.as_ref(),
            decided: &decided,
        };
        self.analysis
            .write(self.out, self.items, &self.pages, self.dialect, &findings)?;
        let marks = match self.tables.take() {
            Some(tables) => tables.finish(self.out)?,
            None => "",
        };
        // Only now: until all tables are written, an interrupted run goes on from the parts.
        Parts::remove(self.out);
        let has_gradebook = match self.gradebook.take() {
            Some(gradebook) => {
                let unknown = gradebook.finish(self.out, &self.sheets.head.title)?;
                gradebook_lacks(&unknown, &self.arguments.gradebook_id);
                true
            }
            None => false,
        };
        // After all that was written from it: while the journal stands, everything can be made again.
        self.journal.finish();
        needs_a_look(&self.analysis, &lost, faults);
        items_moved_on(changed, self.arguments.accept_revisions, earlier.is_some());
        said::decided(&decided);
        if let Some(earlier) = &earlier {
            earlier.tell();
        }
        let has_changes = earlier.is_some_and(|earlier| !earlier.rows.is_empty());
        WrittenFiles {
            out: self.out,
            analysis: &self.analysis,
            marks,
            has_gradebook,
            has_changes,
            has_groups: marked.is_some(),
            has_decisions: !decided.is_empty(),
            makes_feedback,
        }
        .tell();
        let ending = self.feedback.ending(&unprinted);
        Ok(if faults.is_empty() {
            ending
        } else {
            super::Outcome::Findings
        })
    }
}
