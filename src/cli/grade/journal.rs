//! The journal of a run: what was marked so far, so that an interrupted run goes on where it stopped.
//!
//! Its first line names the input; each further line is a sheet that was marked and whose page is written. It is
//! removed when the tables are complete; that of a part of a run becomes the part.

use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};

use super::outcome::Outcome;
use super::parts::{self, End};
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::shard::Shard;

/// The journal of a run; while it is open no other run marks into the folder.
pub(super) struct Journal {
    folder: Folder,
    shard: Shard,
    name: String,
    /// What an earlier run of the same input marked, in its order.
    earlier: Option<BufReader<File>>,
    file: BufWriter<File>,
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
    pub(super) fn open(folder: &Folder, shard: Shard, input: &str) -> Result<Self, Failure> {
        let name = shard.named(NAME.0, NAME.1);
        let shown = folder.root().display();
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot write `{name}` in `{shown}`: {error}"))
        };
        let Some(mut file) = folder.claim(&name)? else {
            return Err(Failure::new(format!("another run marks into `{shown}`"))
                .help("wait for it, or give another folder with `--out`"));
        };
        if shard.is_whole() && !has_company(folder, &name) {
            folder.sweep(&["", "feedback"], &std::collections::BTreeSet::new());
        }
        let (end, done) = sound(&file, input).map_err(fail)?;
        file.set_len(end).map_err(fail)?;
        file.seek(SeekFrom::End(0)).map_err(fail)?;
        if end == 0 {
            writeln!(file, "{input}").map_err(fail)?;
        }
        let mut earlier = BufReader::new(folder.open(&name)?);
        earlier.read_line(&mut String::new()).map_err(fail)?;
        Ok(Self {
            earlier: Some(earlier).filter(|_| done > 0),
            file: BufWriter::new(file),
            folder: folder.clone(),
            shard,
            name,
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
        let flushed = written.and_then(|()| self.file.flush());
        flushed.map_err(|error| self.unwritable(&error))
    }

    fn unwritable(&self, error: &std::io::Error) -> Failure {
        let (name, shown) = (&self.name, self.folder.root().display());
        Failure::new(format!("cannot write `{name}` in `{shown}`: {error}"))
    }

    /// Removes the journal of a run that is complete.
    pub(super) fn finish(self) {
        drop(self.file);
        let _ = self.folder.remove(&self.name);
    }

    /// Makes the journal the part of so many sheets that was marked, in place of an earlier one; its name is returned.
    pub(super) fn become_part(mut self, sheets: usize) -> Result<String, Failure> {
        let end = serde_json::to_string(&End { end: sheets }).expect("a number is plain data");
        let written = writeln!(self.file, "{end}").and_then(|()| self.file.flush());
        let kept = written.and_then(|()| self.file.get_ref().sync_data());
        kept.map_err(|error| self.unwritable(&error))?;
        let name = parts::name(self.shard);
        self.folder.remove(&name)?;
        self.folder.rename(&self.name, &name)?;
        Ok(name)
    }
}

/// Whether parts of a run are being marked into the same folder, whose drafts are none of ours.
fn has_company(folder: &Folder, own: &str) -> bool {
    let names = folder.names("");
    let mut others = names.iter().filter(|name| is_journal(name) && *name != own);
    others.any(|name| !matches!(folder.claim(name), Ok(Some(_))))
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
