//! How far a run has come, kept beside what it writes, so that an interrupted run can be gone on with.

use std::collections::BTreeMap;
use std::fs;
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::shard::Shard;
use crate::cli::Failure;
use crate::cli::files::Draft;

/// How far a run has come.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Mark {
    /// Sheets of its share that are written.
    pub(crate) done: usize,
    /// The length of each draft then, by the name of its file.
    pub(crate) bytes: BTreeMap<String, u64>,
}

impl Mark {
    /// How much of a draft is to be kept.
    pub(crate) fn length(&self, name: &str) -> u64 {
        self.bytes.get(name).copied().unwrap_or(0)
    }
}

/// One line of the ledger.
#[derive(Serialize, Deserialize)]
struct Line {
    inputs: String,
    #[serde(flatten)]
    mark: Mark,
}

/// The ledger of a run; while it is open no other run writes to the folder.
pub(crate) struct Ledger {
    path: PathBuf,
    file: fs::File,
    inputs: String,
}

impl Ledger {
    /// Opens the ledger of a folder, and tells how far an interrupted run with the same inputs has come.
    ///
    /// What another run has left is removed.
    pub(crate) fn open(out: &Path, shard: Shard, inputs: &str) -> Result<(Self, Mark), Failure> {
        let path = out.join(shard.named(".sheet", "run"));
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot write `{}`: {error}", path.display()))
        };
        fs::create_dir_all(out).map_err(fail)?;
        let mut options = fs::OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(&path).map_err(fail)?;
        if file.try_lock().is_err() {
            let folder = out.display();
            return Err(Failure::new(format!("another run writes to `{folder}`"))
                .help("wait for it, or give another folder with `--out`"));
        }
        let mut text = String::new();
        // A ledger that is no text is none.
        let _ = file.read_to_string(&mut text);
        let lines = text
            .split_inclusive('\n')
            .filter(|line| line.ends_with('\n'));
        let last = lines
            .filter_map(|line| serde_json::from_str::<Line>(line).ok())
            .next_back();
        let is_whole = |line: &Line| {
            let mut bytes = line.mark.bytes.iter();
            line.inputs == inputs
                && bytes.all(|(name, length)| Draft::left(&out.join(name)) >= *length)
        };
        let mark = match last {
            Some(line) if is_whole(&line) => line.mark,
            Some(line) => {
                line.mark
                    .bytes
                    .keys()
                    .for_each(|name| Draft::discard(&out.join(name)));
                Mark::default()
            }
            None => Mark::default(),
        };
        file.set_len(0).and_then(|()| file.rewind()).map_err(fail)?;
        let mut ledger = Self {
            path,
            file,
            inputs: inputs.to_owned(),
        };
        ledger.note(mark.clone())?;
        Ok((ledger, mark))
    }

    /// Notes how far the run has come; its drafts have been flushed.
    pub(crate) fn note(&mut self, mark: Mark) -> Result<(), Failure> {
        let inputs = self.inputs.clone();
        let mut line = serde_json::to_string(&Line { inputs, mark }).expect("a mark is plain data");
        line.push('\n');
        let written = self.file.write_all(line.as_bytes());
        written.map_err(|error| {
            Failure::new(format!("cannot write `{}`: {error}", self.path.display()))
        })
    }

    /// The run is complete.
    pub(crate) fn close(self) {
        let _ = fs::remove_file(&self.path);
    }
}
