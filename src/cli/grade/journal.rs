//! The journal of a run: what was marked so far, so that an interrupted run goes on where it stopped.
//!
//! Its first line names the input; each further line is a sheet that was marked and whose page is written. It is
//! removed when the tables are complete.

use std::fs::{self, File, OpenOptions};
use std::io::{BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::outcome::Outcome;
use crate::cli::Failure;

/// The journal of a run.
pub(super) struct Journal {
    path: PathBuf,
    /// What an earlier run of the same input marked, in its order.
    earlier: Option<BufReader<File>>,
    file: BufWriter<File>,
    done: usize,
}

impl Journal {
    /// Opens the journal of a folder; what was marked from another input is forgotten.
    pub(super) fn open(out: &Path, input: &str) -> Result<Self, Failure> {
        let path = out.join(".grading.jsonl");
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot write `{}`: {error}", path.display()))
        };
        fs::create_dir_all(out).map_err(fail)?;
        let mut file = OpenOptions::new()
            .read(true)
            .append(true)
            .create(true)
            .open(&path)
            .map_err(fail)?;
        let (end, done) = sound(&file, input).map_err(fail)?;
        file.set_len(end).map_err(fail)?;
        if end == 0 {
            writeln!(file, "{input}").map_err(fail)?;
        }
        let mut earlier = BufReader::new(File::open(&path).map_err(fail)?);
        earlier.read_line(&mut String::new()).map_err(fail)?;
        Ok(Self {
            earlier: Some(earlier).filter(|_| done > 0),
            file: BufWriter::new(file),
            path,
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
            Failure::new(format!("cannot write `{}`: {error}", self.path.display()))
        })
    }

    /// Removes the journal of a run that is complete.
    pub(super) fn finish(self) {
        drop(self.file);
        let _ = fs::remove_file(&self.path);
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
