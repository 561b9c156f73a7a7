//! How far a run has come, kept beside what it writes, so that an interrupted run can be gone on with.

use std::collections::BTreeMap;
use std::fs;

use serde::{Deserialize, Serialize};

use super::print;
use crate::cli::Failure;
use crate::cli::folder::{Folder, Left};
use crate::cli::journal_file::JournalFile;
use crate::cli::shard::Shard;

/// How far a run has come.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct RunMark {
    /// Sheets of its share that are written.
    pub(crate) done: usize,
    /// What is left of each file then, by its name.
    pub(crate) files: BTreeMap<String, Left>,
}

impl RunMark {
    /// What is left of a file.
    pub(crate) fn left(&self, name: &str) -> Option<&Left> {
        self.files.get(name)
    }
}

/// The folders that a run writes drafts to.
const FOLDERS: [&str; 7] = [
    "",
    "sheets",
    "keys",
    "solutions",
    "figures",
    "manifests",
    print::FOLDER,
];

/// The ledger of a run: its inputs, then a mark a line; while it is open no other run writes to the folder.
pub(crate) struct Ledger(JournalFile);

impl Ledger {
    /// Opens the ledger of a folder, and reports how far an interrupted run with the same inputs has come.
    ///
    /// What another run has left is removed, and what an interrupted one has left without noting it.
    pub(crate) fn open(
        folder: &Folder,
        shard: Shard,
        inputs: &str,
    ) -> Result<(Self, RunMark), Failure> {
        let Some(mut file) = JournalFile::claim(folder, shard.named(".sheet", "run"))? else {
            let shown = folder.root().display();
            return Err(Failure::new(format!("another run writes to `{shown}`"))
                .help("wait for it, or give another folder with `--out`"));
        };
        let is_same = file.head()?.is_some_and(|head| head == inputs);
        let mut last = RunMark::default();
        file.go_on(|line| serde_json::from_str(line).map(|mark| last = mark).is_ok())?;
        let is_whole = |mark: &RunMark| {
            let mut files = mark.files.iter();
            files.all(|(name, left)| folder.left(name, left).is_some())
        };
        let mark = if is_same && is_whole(&last) {
            last
        } else {
            discard(folder, &last);
            RunMark::default()
        };
        file.begin(inputs)?;
        if shard.is_whole()
            && !file.has_company(|name| name.starts_with(".sheet-") && name.ends_with(".run"))
        {
            let drafts = mark.files.values().map(|left| left.draft.clone());
            folder.sweep(&FOLDERS, &drafts.collect());
        }
        let mut ledger = Self(file);
        ledger.note(&mark)?;
        Ok((ledger, mark))
    }

    /// Notes how far the run has come; its drafts have been flushed.
    pub(crate) fn note(&mut self, mark: &RunMark) -> Result<(), Failure> {
        self.0.add(&[mark])
    }

    /// The run is complete.
    pub(crate) fn close(self) {
        self.0.remove();
    }
}

/// Removes what a run with other inputs has left, however long it is.
fn discard(folder: &Folder, mark: &RunMark) {
    for (name, left) in &mark.files {
        let any = Left {
            length: 0,
            ..left.clone()
        };
        if let Some(draft) = folder.left(name, &any) {
            let _ = fs::remove_file(draft);
        }
    }
}
