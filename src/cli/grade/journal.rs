//! The journal of a run: what was marked so far, so that an interrupted run goes on where it stopped.
//!
//! Its first line names the input; each further line is a sheet that was marked and whose page is written. It is
//! removed when the tables are complete.

use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};

use super::outcome::Outcome;
use crate::cli::Failure;
use crate::cli::folder::Folder;

/// The journal of a run; while it is open no other run marks into the folder.
pub(super) struct Journal {
    folder: Folder,
    /// What an earlier run of the same input marked, in its order.
    earlier: Option<BufReader<File>>,
    file: BufWriter<File>,
    done: usize,
}

/// The name of the journal.
const NAME: &str = ".grading.jsonl";

impl Journal {
    /// Opens the journal of a folder; what was marked from another input is forgotten, and what an interrupted run has
    /// left beside it is removed.
    pub(super) fn open(folder: &Folder, input: &str) -> Result<Self, Failure> {
        let shown = folder.root().display();
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot write `{NAME}` in `{shown}`: {error}"))
        };
        let Some(mut file) = folder.claim(NAME)? else {
            return Err(Failure::new(format!("another run marks into `{shown}`"))
                .help("wait for it, or give another folder with `--out`"));
        };
        folder.sweep(&["", "feedback"], &std::collections::BTreeSet::new());
        let (end, done) = sound(&file, input).map_err(fail)?;
        file.set_len(end).map_err(fail)?;
        file.seek(SeekFrom::End(0)).map_err(fail)?;
        if end == 0 {
            writeln!(file, "{input}").map_err(fail)?;
        }
        let mut earlier = BufReader::new(folder.open(NAME)?);
        earlier.read_line(&mut String::new()).map_err(fail)?;
        Ok(Self {
            earlier: Some(earlier).filter(|_| done > 0),
            file: BufWriter::new(file),
            folder: folder.clone(),
            done,
        })
    }

    /// How many sheets were marked by an earlier run.
    pub(super) fn done(&self) -> usize {
        self.done
    }

    /// The next sheet that an earlier run marked.
    pub(super) fn next(&mut self) -> Option<Outcome> {
        let mut line = String::new();
        let earlier = self.earlier.as_mut().filter(|_| self.done > 0)?;
        earlier.read_line(&mut line).ok()?;
        self.done -= 1;
        serde_json::from_str(&line).ok()
    }

    /// Notes sheets that were marked and whose pages are written.
    pub(super) fn note(&mut self, outcomes: &[Outcome]) -> Result<(), Failure> {
        let written = outcomes.iter().try_for_each(|outcome| {
            serde_json::to_writer(&mut self.file, outcome)?;
            self.file.write_all(b"\n")
        });
        written.and_then(|()| self.file.flush()).map_err(|error| {
            let shown = self.folder.root().display();
            Failure::new(format!("cannot write `{NAME}` in `{shown}`: {error}"))
        })
    }

    /// Removes the journal of a run that is complete.
    pub(super) fn finish(self) {
        drop(self.file);
        let _ = self.folder.remove(NAME);
    }
}

/// Up to where a journal is sound and of this input, and how many sheets stand in it.
fn sound(mut file: &File, input: &str) -> std::io::Result<(u64, usize)> {
    file.seek(SeekFrom::Start(0))?;
    let mut reader = BufReader::new(file);
    let mut line = String::new();
    let mut end = reader.read_line(&mut line)? as u64;
    if line.trim_end() != input || !line.ends_with('\n') {
        return Ok((0, 0));
    }
    let mut done = 0;
    loop {
        line.clear();
        let length = reader.read_line(&mut line).unwrap_or(0);
        // The last line may have been cut off in the middle.
        if length == 0 || !line.ends_with('\n') || serde_json::from_str::<Outcome>(&line).is_err() {
            return Ok((end, done));
        }
        end += length as u64;
        done += 1;
    }
}
