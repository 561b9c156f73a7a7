//! A journal: lines of JSON after a first line that says of what, appended as a run goes, so that an interrupted run is
//! gone on with. The ledger of `sheet`, the journal of `grade` and that of `enter` are such files.

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};

use serde::Serialize;

use super::Failure;
use super::files::unwritable;
use super::folder::Folder;

/// A journal; while it is open no other run has it.
pub(crate) struct JournalFile {
    folder: Folder,
    name: String,
    file: BufWriter<File>,
}

impl JournalFile {
    /// The journal of this name; `None` where another run has it.
    pub(crate) fn claim(folder: &Folder, name: String) -> Result<Option<Self>, Failure> {
        Ok(folder.claim(&name)?.map(|file| Self {
            folder: folder.clone(),
            name,
            file: BufWriter::new(file),
        }))
    }

    /// Its first line, if it has one that is whole.
    pub(crate) fn head(&self) -> Result<Option<String>, Failure> {
        let mut reader = self.reader()?;
        let head = line(&mut reader).map_err(self.unwritable())?;
        Ok(head.map(|line| line.trim_end().to_owned()))
    }

    /// Goes on after the lines, after the first, that are whole and are taken; how many there are. The rest is cut
    /// off: its first line may have been interrupted in the middle.
    pub(crate) fn go_on(&mut self, mut take: impl FnMut(&str) -> bool) -> Result<usize, Failure> {
        let mut reader = self.reader()?;
        let mut end = line(&mut reader)
            .map_err(self.unwritable())?
            .map_or(0, |head| head.len());
        let mut count = 0;
        while let Some(own) = line(&mut reader)
            .map_err(self.unwritable())?
            .filter(|own| take(own))
        {
            end += own.len();
            count += 1;
        }
        self.cut(end as u64)?;
        Ok(count)
    }

    /// Begins anew, with a first line.
    pub(crate) fn begin(&mut self, head: &str) -> Result<(), Failure> {
        self.cut(0)?;
        let written = writeln!(self.file, "{head}").and_then(|()| self.file.flush());
        written.map_err(self.unwritable())
    }

    /// Appends lines, and hands them to the system.
    pub(crate) fn add<T: Serialize>(&mut self, lines: &[T]) -> Result<(), Failure> {
        let written = lines.iter().try_for_each(|line| {
            serde_json::to_writer(&mut self.file, line)?;
            self.file.write_all(b"\n")
        });
        let flushed = written.and_then(|()| self.file.flush());
        flushed.map_err(self.unwritable())
    }

    /// Waits until what was appended is on the disk.
    pub(crate) fn sync(&self) -> Result<(), Failure> {
        self.file.get_ref().sync_data().map_err(self.unwritable())
    }

    /// Removes it: the run is complete.
    pub(crate) fn remove(self) {
        drop(self.file);
        let _ = self.folder.remove(&self.name);
    }

    /// Gives it another name, in place of a file that has it.
    pub(crate) fn rename(self, name: &str) -> Result<(), Failure> {
        self.folder.remove(name)?;
        self.folder.rename(&self.name, name)
    }

    /// Whether runs have other journals of this kind in the folder, whose drafts are none of ours.
    pub(crate) fn has_company(&self, is_journal: impl Fn(&str) -> bool) -> bool {
        let names = self.folder.names("");
        let mut others = names
            .iter()
            .filter(|name| is_journal(name) && **name != self.name);
        others.any(|name| !matches!(self.folder.claim(name), Ok(Some(_))))
    }

    fn reader(&self) -> Result<BufReader<&File>, Failure> {
        let mut file = self.file.get_ref();
        file.seek(SeekFrom::Start(0)).map_err(self.unwritable())?;
        Ok(BufReader::new(file))
    }

    fn cut(&mut self, end: u64) -> Result<(), Failure> {
        let mut file = self.file.get_ref();
        let cut = file.set_len(end).and_then(|()| file.seek(SeekFrom::End(0)));
        cut.map(drop).map_err(self.unwritable())
    }

    fn unwritable(&self) -> impl Fn(io::Error) -> Failure {
        let path = self.folder.root().join(&self.name);
        move |error| unwritable(&path)(error)
    }
}

/// The next line with its end; `None` where it is cut off, is no text, or there is none.
fn line(reader: &mut impl BufRead) -> io::Result<Option<String>> {
    let mut line = Vec::new();
    reader.read_until(b'\n', &mut line)?;
    let text = String::from_utf8(line).ok();
    Ok(text.filter(|line| line.ends_with('\n')))
}
