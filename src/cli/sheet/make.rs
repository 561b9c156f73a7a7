//! Making the sheets: chosen in order, written by all cores, kept in order.
//!
//! A sheet is written when it is taken, never before: what repeats an earlier one leaves no trace. While a chunk of sheets
//! is written, the one before is kept and the one after is proposed.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use indicatif::ProgressBar;
use rayon::prelude::*;
use vibank::worksheet::{
    Candidate, Chooser, Fairness, Plan, Sheet, SheetError, Student, VariantEntry,
};

use super::known::Alike;
use super::ledger::{Ledger, Mark};
use super::outputs::{Finished, Format, Outputs, Written, write_fairness};
use crate::cli::record::{self, Record};
use crate::cli::{Failure, progress};

/// Sheets that are made at once; memory holds no more than three times as many.
const CHUNK: usize = 64;

/// What making a sheet needs to know.
pub(super) struct Job<'a, 'c> {
    pub(super) plan: &'a Plan<'c>,
    pub(super) students: &'a [Student],
    pub(super) formats: &'a [Format],
    pub(super) known: Alike<'a>,
    pub(super) out: &'a Path,
    pub(super) layouts: Option<&'a Path>,
    /// Whether all variants are there, so that it can be told how alike they are.
    pub(super) tell_fairness: bool,
}

/// Where sheets are kept.
pub(super) struct Store<'f> {
    pub(super) ledger: Ledger,
    pub(super) outputs: Outputs<'f>,
    pub(super) record: Record,
}

/// What a run made.
pub(super) struct Made {
    pub(super) sheets: usize,
    pub(super) unchanged: usize,
    pub(super) rejected: u64,
    pub(super) fairness: Fairness,
    /// Files that could not be printed, and why.
    pub(super) unprinted: Vec<String>,
    /// What to report of them, each with what it is.
    pub(super) shown: Vec<(String, &'static str)>,
}

struct Page {
    entry: VariantEntry,
    is_kept: bool,
    written: Vec<Written>,
}

impl Job<'_, '_> {
    /// Makes the sheets of a share, from where an interrupted run has stopped.
    ///
    /// All sheets before are chosen again, which is quick, since what is taken depends on what was taken before.
    pub(super) fn make(
        &self,
        share: Range<usize>,
        mark: &Mark,
        mut store: Store<'_>,
    ) -> Result<Made, Failure> {
        let bar = progress::bar(share.len() as u64, "sheets");
        let mut chooser = Chooser::new(self.plan, self.students);
        let first = share.start + mark.done;
        let mut made = Made {
            sheets: share.len(),
            unchanged: 0,
            rejected: 0,
            fairness: Fairness::default(),
            unprinted: Vec::new(),
            shown: Vec::new(),
        };
        bar.inc(mark.done as u64);
        let mut candidates = propose(&chooser, chunk(0, first, share.end))?;
        let (mut taken, mut written, mut pages) = (0, 0, Vec::new());
        while !(candidates.is_empty() && pages.is_empty()) {
            let own = settle(&mut chooser, candidates)?;
            taken += own.len();
            let next = chunk(taken, first, share.end);
            let (kept, (own, proposed)) = rayon::join(
                || store.keep(pages, written, &mut made),
                || rayon::join(|| self.pages(own, first, &bar), || propose(&chooser, next)),
            );
            kept?;
            (pages, candidates) = (own?, proposed?);
            written = taken.saturating_sub(share.start);
        }
        bar.finish_and_clear();
        made.rejected = chooser.rejected();
        made.fairness = chooser.fairness().clone();
        let fairness = self
            .tell_fairness
            .then(|| write_fairness(self.plan, self.layouts, &made.fairness, self.out));
        store.finish(fairness.transpose()?, &mut made)?;
        Ok(made)
    }

    /// Writes the sheets of some candidates, but those before the place `first`, which are another run's or an earlier
    /// one's.
    fn pages(
        &self,
        candidates: Vec<Candidate>,
        first: usize,
        bar: &ProgressBar,
    ) -> Result<Vec<Page>, Failure> {
        let is_own = |candidate: &Candidate| candidate.index() as usize >= first;
        let write = |candidate: Candidate| {
            let student = self.students.get(candidate.index() as usize).cloned();
            let sheet = Sheet::draw(self.plan, candidate.variant(), student);
            let page = self.page(&sheet.map_err(|error| refuse(&error))?)?;
            bar.inc(1);
            Ok(page)
        };
        candidates
            .into_par_iter()
            .filter(is_own)
            .map(write)
            .collect()
    }

    fn page(&self, sheet: &Sheet<'_>) -> Result<Page, Failure> {
        let mut entry = record::entry(sheet);
        let is_split = self.formats.iter().any(Format::is_split);
        let held = is_split
            .then(|| self.known.files(self.out, &entry))
            .flatten();
        let is_kept = held.is_some();
        let formats = self.formats.iter();
        let written = formats
            .map(|format| format.write(sheet, is_kept, self.out))
            .collect::<Result<_, _>>()?;
        entry.files = held.cloned().unwrap_or_default();
        Ok(Page {
            entry,
            is_kept,
            written,
        })
    }
}

/// Looks for a suitable seed for each of some places.
fn propose(chooser: &Chooser<'_, '_>, places: Range<usize>) -> Result<Vec<Candidate>, Failure> {
    let propose = |place: usize| candidate(chooser, place as u64, 0);
    places.into_par_iter().map(propose).collect()
}

/// Takes candidates in order; one that repeats another of them gives way to the next attempt.
fn settle(
    chooser: &mut Chooser<'_, '_>,
    candidates: Vec<Candidate>,
) -> Result<Vec<Candidate>, Failure> {
    let mut taken = Vec::with_capacity(candidates.len());
    for mut own in candidates {
        while !chooser.take(&own) {
            own = candidate(chooser, own.index(), own.next_attempt())?;
        }
        taken.push(own);
    }
    Ok(taken)
}

fn candidate(chooser: &Chooser<'_, '_>, index: u64, from: u64) -> Result<Candidate, Failure> {
    chooser.propose(index, from).map_err(|error| refuse(&error))
}

/// The next places from `done` on: whole chunks from `first`, so that a run that goes on has the same ones.
fn chunk(done: usize, first: usize, end: usize) -> Range<usize> {
    let last = if done < first {
        first.min(done + CHUNK)
    } else {
        done + CHUNK
    };
    done..last.min(end)
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
            let files = self
                .outputs
                .add(page.written, &mut tables, &mut made.unprinted)?;
            entry.files.extend(files);
            self.record.add(&entry)?;
        }
        self.outputs.add_tables(&tables)?;
        let mut bytes = self.outputs.flush()?;
        bytes.extend(self.record.flush()?);
        self.ledger.note(Mark { done, bytes })
    }

    /// Completes all files, the manifest last.
    fn finish(self, fairness: Option<Finished>, made: &mut Made) -> Result<(), Failure> {
        let mut digests = BTreeMap::new();
        for finished in self
            .outputs
            .finish(&mut made.unprinted)?
            .into_iter()
            .chain(fairness)
        {
            if let Some(digest) = finished.digest {
                digests.insert(finished.name.clone(), digest);
            }
            made.shown.push((finished.name, finished.what));
        }
        made.shown.extend(self.record.finish(&digests)?);
        self.ledger.close();
        Ok(())
    }
}

/// A run that cannot be made.
pub(super) fn refuse(error: &SheetError) -> Failure {
    Failure::new(error.to_string())
        .help("loosen the constraints of the item, or fix other data with `set`")
}
