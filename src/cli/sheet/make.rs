//! Making the sheets: all are chosen, then written by all cores and kept in the order of the run.
//!
//! A sheet is written when it is taken, never before: what repeats an earlier one leaves no trace. While a chunk of sheets
//! is written, the one before is kept.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;

use indicatif::ProgressBar;
use rayon::prelude::*;
use vibank::seed::Variant;
use vibank::worksheet::{
    Candidate, Chooser, Fairness, FileNames, Fixed, Plan, QuestionEntry, Sheet, SheetError,
    Student, VariantEntry, file_stem,
};

use super::format::{Format, WrittenSheet};
use super::known::AlikeSheets;
use super::ledger::{Ledger, RunMark};
use super::outputs::{Finished, Outputs, write_fairness};
use super::print::{PrintJob, Prints};
use crate::cli::folder::Folder;
use crate::cli::record::{self, Record};
use crate::cli::{Failure, progress};

/// Sheets that are made at once; memory holds no more than three times as many.
const CHUNK: usize = 64;

/// What making a sheet needs to know.
pub(crate) struct Job<'a, 'c> {
    pub(crate) plan: &'a Plan<'c>,
    pub(crate) students: &'a [Student],
    /// How many sheets the whole run has.
    pub(crate) count: usize,
    /// Whether nothing that is written names a student.
    pub(crate) has_pseudonyms: bool,
    /// What students have already, by identity.
    pub(crate) fixed: BTreeMap<String, Fixed>,
    /// What students had on an earlier sheet and do not get again, by identity.
    pub(crate) earlier: BTreeMap<String, Vec<QuestionEntry>>,
    pub(crate) formats: &'a [Format],
    pub(crate) known: AlikeSheets<'a>,
    pub(crate) out: &'a Folder,
    pub(crate) layouts: Option<&'a Path>,
    /// Whether it is the whole run, so that it can be reported how alike the variants are, and all can be printed.
    pub(crate) is_whole: bool,
}

/// Where sheets are kept.
pub(crate) struct Store<'f> {
    pub(crate) ledger: Ledger,
    pub(crate) outputs: Outputs<'f>,
    pub(crate) record: Record,
}

/// What a run made.
pub(crate) struct Made {
    pub(crate) sheets: usize,
    pub(crate) unchanged: usize,
    pub(crate) rejected: u64,
    /// The item whose data were not suitable most often, with how often.
    pub(crate) unsuitable: Option<(String, u64)>,
    /// Sheets on which a wrong method may come within a tolerance.
    pub(crate) lenient: u64,
    pub(crate) fairness: Fairness,
    /// Files that could not be printed, and why.
    pub(crate) unprinted: Vec<String>,
    /// All variants of the run, by place.
    pub(crate) variants: Vec<Variant>,
    /// What to report of them, each with what it is.
    pub(crate) shown: Vec<(String, &'static str)>,
}

struct Page {
    entry: VariantEntry,
    is_kept: bool,
    written: Vec<WrittenSheet>,
}

impl Job<'_, '_> {
    /// Makes the sheets of a share, from where an interrupted run has stopped.
    ///
    /// All variants are chosen first, which takes a small share of the time: who goes first is not who is written first.
    pub(crate) fn make(
        &self,
        share: Range<usize>,
        mark: &RunMark,
        mut store: Store<'_>,
    ) -> Result<Made, Failure> {
        // What is taken depends on what was taken before: with a list on all of it, else on what comes before.
        let count = if self.students.is_empty() {
            share.end
        } else {
            self.count
        };
        let mut chooser = Chooser::new(self.plan, self.students, self.fixed.clone())
            .without(self.earlier.clone());
        if self.has_pseudonyms {
            chooser = chooser.with_pseudonyms();
        }
        choose(&mut chooser, count)?;
        let variants: Vec<Variant> = chooser.taken().collect();
        let bar = progress::bar(share.len() as u64, "sheets");
        let mut made = Made {
            sheets: share.len(),
            unchanged: 0,
            rejected: chooser.rejected(),
            unsuitable: chooser
                .unsuitable()
                .first()
                .map(|(item, count)| ((*item).to_owned(), *count)),
            lenient: chooser.lenient(),
            fairness: chooser.fairness().clone(),
            unprinted: Vec::new(),
            shown: Vec::new(),
            variants: variants.clone(),
        };
        bar.inc(mark.done as u64);
        let mut pages = Vec::new();
        let mut begin = share.start + mark.done;
        while begin < share.end || !pages.is_empty() {
            let end = share.end.min(begin + CHUNK);
            let (kept, written) = rayon::join(
                || store.keep(pages, begin - share.start, &mut made),
                || self.pages(begin..end, &variants, chooser.gave_way(), &bar),
            );
            kept?;
            (pages, begin) = (written?, end);
        }
        bar.finish_and_clear();
        let prints = self.prints(&variants)?;
        let fairness = self
            .is_whole
            .then(|| write_fairness(self.plan, self.layouts, &made.fairness, self.out));
        store.finish(
            self.out,
            prints,
            fairness.transpose()?,
            self.plan,
            &mut made,
        )?;
        Ok(made)
    }

    /// Writes the sheets at some places.
    fn pages(
        &self,
        places: Range<usize>,
        variants: &[Variant],
        gave_way: &BTreeSet<u64>,
        bar: &ProgressBar,
    ) -> Result<Vec<Page>, Failure> {
        places
            .into_par_iter()
            .map(|place| {
                let student = self
                    .students
                    .get(place)
                    .filter(|_| !self.has_pseudonyms)
                    .cloned();
                let sheet = Sheet::draw(self.plan, variants[place], student);
                let sheet = sheet.map_err(|error| refuse(&error))?;
                let page = self.page(&sheet, place, gave_way.contains(&(place as u64)))?;
                bar.inc(1);
                Ok(page)
            })
            .collect()
    }

    fn page(&self, sheet: &Sheet<'_>, place: usize, gave_way: bool) -> Result<Page, Failure> {
        let mut entry = VariantEntry {
            gave_way,
            ..record::entry(sheet)
        };
        let stem = self.stem(sheet, place);
        let is_split = self.formats.iter().any(Format::is_split);
        let held = is_split
            .then(|| self.known.files(self.out, &entry))
            .flatten()
            .filter(|files| are_named(files, &stem));
        // Even a sheet that is kept is written for the files of the whole run, which hold all sheets.
        let is_kept = held.is_some();
        let formats = self.formats.iter();
        let written = formats
            .map(|format| format.write(sheet, &stem, is_kept, self.out))
            .collect::<Result<_, _>>()?;
        entry.files = held.cloned().unwrap_or_default();
        Ok(Page {
            entry,
            is_kept,
            written,
        })
    }

    /// The name of the files of a sheet.
    fn stem(&self, sheet: &Sheet<'_>, place: usize) -> String {
        let code = sheet.variant.to_string();
        let print = self.plan.blueprint.print.as_ref();
        let names_students = print.is_some_and(|print| print.files == FileNames::Student);
        if names_students && !self.named().is_empty() {
            file_stem(place, self.count, sheet.student.as_ref(), &code)
        } else {
            code
        }
    }

    /// The students that pages may name.
    fn named(&self) -> &[Student] {
        if self.has_pseudonyms {
            &[]
        } else {
            self.students
        }
    }

    /// What is made for the printer, where it is wanted and all sheets are there.
    fn prints(&self, variants: &[Variant]) -> Result<Prints, Failure> {
        let Some(printing) = self.plan.blueprint.print.as_ref().filter(|_| self.is_whole) else {
            return Ok(Prints::default());
        };
        let job = PrintJob {
            plan: self.plan,
            printing,
            students: self.named(),
            variants,
            formats: self.formats,
            out: self.out,
        };
        job.make()
    }
}

/// Whether files that are a sheet's own have this name; figures have the names of what they show.
fn are_named(files: &BTreeMap<String, String>, stem: &str) -> bool {
    let mut own = files.keys().filter(|file| !file.starts_with("figures/"));
    own.all(|file| Path::new(file).file_stem().is_some_and(|own| own == stem))
}

/// Chooses the variant of each of `count` places.
fn choose(chooser: &mut Chooser<'_, '_>, count: usize) -> Result<(), Failure> {
    let order = chooser.order(count);
    let propose = |chooser: &Chooser<'_, '_>, places: &[u64]| {
        let candidates = places.par_iter().map(|place| candidate(chooser, *place, 0));
        candidates.collect::<Result<Vec<_>, Failure>>()
    };
    for places in order.chunks(CHUNK) {
        // One that repeats another of them gives way to the next attempt.
        // Proposals of a chunk know nothing of each other; they are taken one by one, so that the number of
        // cores does not matter.
        for mut own in propose(chooser, places)? {
            while !chooser.take(&own) {
                own = candidate(chooser, own.index(), own.next_attempt())?;
            }
        }
    }
    Ok(())
}

fn candidate(chooser: &Chooser<'_, '_>, index: u64, from: u64) -> Result<Candidate, Failure> {
    chooser.propose(index, from).map_err(|error| refuse(&error))
}

impl Store<'_> {
    /// Keeps some sheets; after them `done` are written.
    fn keep(&mut self, pages: Vec<Page>, done: usize, made: &mut Made) -> Result<(), Failure> {
        if pages.is_empty() {
            return Ok(());
        }
        let mut tables = self.outputs.tables();
        for page in pages {
            let mut entry = page.entry;
            made.unchanged += usize::from(page.is_kept);
            self.outputs
                .add(page.written, &mut entry, &mut tables, &mut made.unprinted)?;
            self.record.add(&entry)?;
        }
        self.outputs.add_tables(&tables)?;
        let mut files = self.outputs.flush()?;
        files.extend(self.record.flush()?);
        self.ledger.note(&RunMark { done, files })
    }

    /// Completes all files, the manifest last.
    fn finish(
        self,
        out: &Folder,
        prints: Prints,
        fairness: Option<Finished>,
        plan: &Plan<'_>,
        made: &mut Made,
    ) -> Result<(), Failure> {
        let mut digests = prints.files;
        made.unprinted.extend(prints.unprinted);
        for finished in self
            .outputs
            .finish(out, &mut made.unprinted)?
            .into_iter()
            .chain(fairness)
        {
            digests.extend(finished.digests);
            made.shown.push((finished.name, finished.what));
        }
        made.shown.extend(prints.shown);
        let items = plan.used(&made.fairness);
        made.shown.extend(self.record.finish(&items, &digests)?);
        self.ledger.close();
        Ok(())
    }
}

/// A run that cannot be made.
pub(crate) fn refuse(error: &SheetError) -> Failure {
    let way = match error {
        SheetError::Shared { .. } => {
            "widen its range in the item, fix another value with `set`, or ask another item"
        }
        _ => "loosen the constraints of the item, or fix other data with `set`",
    };
    Failure::of(error).help(way)
}
