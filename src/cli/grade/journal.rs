//! The journal of a run: what was marked so far, so that an interrupted run goes on where it stopped.
//!
//! Its first line names the input; each further line is a sheet that was marked and whose page is written. It is
//! removed when the tables are complete; that of a part of a run becomes the part.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufRead, BufReader};

use super::outcome::SheetOutcome;
use super::parts::{self, PartEnd};
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::journal_file::JournalFile;
use crate::cli::shard::Shard;

/// The journal of a run; while it is open no other run marks into the folder.
pub(crate) struct Journal {
    shard: Shard,
    file: JournalFile,
    /// What an earlier run of the same input marked, in its order.
    earlier: BufReader<File>,
    done: usize,
}

/// How the name of a journal begins, and how it ends.
const NAME: (&str, &str) = (".grading", "jsonl");

/// Whether a file is the journal of a run or of a part of one.
pub(crate) fn is_journal(name: &str) -> bool {
    name == Shard::default().named(NAME.0, NAME.1) || Shard::of_name(name, NAME.0, NAME.1).is_some()
}

impl Journal {
    /// Opens the journal of a folder; what was marked from another input is forgotten, and what an interrupted run has
    /// left beside it is removed.
    pub(crate) fn open(folder: &Folder, shard: Shard, input: &str) -> Result<Self, Failure> {
        let name = shard.named(NAME.0, NAME.1);
        let Some(mut file) = JournalFile::claim(folder, name.clone())? else {
            let shown = folder.root().display();
            return Err(Failure::new(format!("another run marks into `{shown}`"))
                .help("wait for it, or give another folder with `--out`"));
        };
        if shard.is_whole() && !file.has_company(is_journal) {
            folder.sweep(&["", "feedback"], &BTreeSet::new());
        }
        let done = if file.head()?.is_some_and(|head| head == input) {
            file.go_on(|line| serde_json::from_str::<SheetOutcome>(line).is_ok())?
        } else {
            file.begin(input)?;
            0
        };
        let mut earlier = BufReader::new(folder.open(&name)?);
        earlier.skip_until(b'\n').map_err(|error| {
            let shown = folder.root().display();
            Failure::new(format!("cannot read `{name}` in `{shown}`: {error}"))
        })?;
        Ok(Self {
            shard,
            file,
            earlier,
            done,
        })
    }

    /// How many sheets were marked by an earlier run.
    pub(crate) fn done(&self) -> usize {
        self.done
    }

    /// The next sheet that an earlier run marked.
    pub(crate) fn next(&mut self) -> Option<SheetOutcome> {
        let mut line = String::new();
        if self.done == 0 {
            return None;
        }
        self.earlier.read_line(&mut line).ok()?;
        self.done -= 1;
        serde_json::from_str(&line).ok()
    }

    /// Notes sheets that were marked and whose pages are written.
    pub(crate) fn note(&mut self, outcomes: &[SheetOutcome]) -> Result<(), Failure> {
        self.file.add(outcomes)
    }

    /// Removes the journal of a run that is complete.
    pub(crate) fn finish(self) {
        self.file.remove();
    }

    /// Makes the journal of this many sheets the part that was marked, in place of an earlier one; its name is returned.
    pub(crate) fn become_part(mut self, sheets: usize) -> Result<String, Failure> {
        self.file.add(&[PartEnd { end: sheets }])?;
        self.file.sync()?;
        let name = parts::name(self.shard);
        self.file.rename(&name)?;
        Ok(name)
    }
}
