//! How far a run has come, kept beside what it writes, so that an interrupted run can be gone on with.

use std::collections::BTreeMap;
use std::fs;
use std::io::{Seek, Write};

use serde::{Deserialize, Serialize};

use super::print;
use crate::cli::Failure;
use crate::cli::folder::{self, Folder, Left};
use crate::cli::shard::Shard;

/// How far a run has come.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Mark {
    /// Sheets of its share that are written.
    pub(crate) done: usize,
    /// What is left of each file then, by its name.
    pub(crate) files: BTreeMap<String, Left>,
}

impl Mark {
    /// What is left of a file.
    pub(crate) fn left(&self, name: &str) -> Option<&Left> {
        self.files.get(name)
    }
}

/// One line of the ledger.
#[derive(Serialize, Deserialize)]
struct Line {
    inputs: String,
    #[serde(flatten)]
    mark: Mark,
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

/// The ledger of a run; while it is open no other run writes to the folder.
pub(crate) struct Ledger {
    folder: Folder,
    name: String,
    file: fs::File,
    inputs: String,
}

impl Ledger {
    /// Opens the ledger of a folder, and tells how far an interrupted run with the same inputs has come.
    ///
    /// What another run has left is removed, and what an interrupted one has left without noting it.
    pub(crate) fn open(
        folder: &Folder,
        shard: Shard,
        inputs: &str,
    ) -> Result<(Self, Mark), Failure> {
        let name = shard.named(".sheet", "run");
        let shown = folder.root().display();
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot write `{name}` in `{shown}`: {error}"))
        };
        let Some(mut file) = folder.claim(&name)? else {
            return Err(Failure::new(format!("another run writes to `{shown}`"))
                .help("wait for it, or give another folder with `--out`"));
        };
        // A ledger that is no text is none.
        let text = folder::text(&file);
        let lines = text
            .split_inclusive('\n')
            .filter(|line| line.ends_with('\n'));
        let last = lines
            .filter_map(|line| serde_json::from_str::<Line>(line).ok())
            .next_back();
        let is_whole = |line: &Line| {
            let mut files = line.mark.files.iter();
            line.inputs == inputs && files.all(|(name, left)| folder.left(name, left).is_some())
        };
        let mark = match last {
            Some(line) if is_whole(&line) => line.mark,
            Some(line) => {
                let files = line.mark.files.iter();
                let stale = files.filter_map(|(name, left)| {
                    folder.left(
                        name,
                        &Left {
                            length: 0,
                            ..left.clone()
                        },
                    )
                });
                stale.for_each(|draft| drop(fs::remove_file(draft)));
                Mark::default()
            }
            None => Mark::default(),
        };
        file.set_len(0).and_then(|()| file.rewind()).map_err(fail)?;
        let mut ledger = Self {
            folder: folder.clone(),
            name,
            file,
            inputs: inputs.to_owned(),
        };
        ledger.note(mark.clone())?;
        if shard.is_whole() && !ledger.has_company() {
            let drafts = mark.files.values().map(|left| left.draft.clone());
            folder.sweep(&FOLDERS, &drafts.collect());
        }
        Ok((ledger, mark))
    }

    /// Whether parts of the run are being made at the same time, whose drafts are none of ours.
    fn has_company(&self) -> bool {
        let names = self.folder.names("");
        let mut others = names
            .iter()
            .filter(|name| name.starts_with(".sheet-") && name.ends_with(".run"));
        others.any(|name| !matches!(self.folder.claim(name), Ok(Some(_))))
    }

    /// Notes how far the run has come; its drafts have been flushed.
    pub(crate) fn note(&mut self, mark: Mark) -> Result<(), Failure> {
        let inputs = self.inputs.clone();
        let mut line = serde_json::to_string(&Line { inputs, mark }).expect("a mark is plain data");
        line.push('\n');
        let written = self.file.write_all(line.as_bytes());
        written.map_err(|error| {
            let (name, root) = (&self.name, self.folder.root().display());
            Failure::new(format!("cannot write `{name}` in `{root}`: {error}"))
        })
    }

    /// The run is complete.
    pub(crate) fn close(self) {
        let _ = self.folder.remove(&self.name);
    }
}
