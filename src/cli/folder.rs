//! The folder that a run writes to: the one place where paths for output are made.
//!
//! Names come from manifests and blueprints, so each is checked: nothing leaves the folder, and no link in it is
//! followed, neither to a file nor to a folder. What is written is the owner's alone, since it holds marks, keys and
//! names; it is written under a name that nobody can guess, and moved to its place when it is complete.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::Failure;
use super::files::{self, Access, unwritable};

/// A folder that a run writes to.
#[derive(Clone, Debug)]
pub(crate) struct Folder {
    root: PathBuf,
}

/// What an interrupted run leaves of a file, to be gone on with.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Left {
    /// How many of its bytes count.
    pub(crate) length: u64,
    /// The name of the draft, which stands beside the file.
    pub(crate) draft: String,
}

impl Folder {
    /// The folder `root`, whether it is there or not.
    pub(crate) fn at(root: &Path) -> Self {
        let is_here = root.as_os_str().is_empty();
        Self {
            root: if is_here { Path::new(".") } else { root }.to_owned(),
        }
    }

    /// A folder that a run makes within its own, unless somebody has put a link in its place.
    pub(crate) fn within(run: &Path, name: &str) -> Result<Self, Failure> {
        Self::at(run).path(name)?;
        Ok(Self::at(&run.join(name)))
    }

    /// Makes the folder if it is not there.
    pub(crate) fn make(&self) -> Result<(), Failure> {
        self.hold()?;
        make_private(&self.root).map_err(unwritable(&self.root))
    }

    /// Refuses a file in place of the folder, before there is something to write.
    pub(crate) fn hold(&self) -> Result<(), Failure> {
        if self.root.is_file() {
            let shown = self.root.display();
            return Err(Failure::new(format!("`{shown}` is a file, not a folder"))
                .help("name a folder with `--out`; it is made if it is not there"));
        }
        Ok(())
    }

    /// The folder itself.
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// The path of a file in it, by its name with `/` between folders.
    ///
    /// Anything but a plain name is refused, and whatever is behind a link.
    pub(crate) fn path(&self, name: &str) -> Result<PathBuf, Failure> {
        if !is_plain(name) {
            return Err(Failure::new(format!(
                "`{}` cannot be the name of a file in `{}`",
                name.escape_debug(),
                self.root.display()
            ))
            .help("give the manifest as `vibank sheet` wrote it"));
        }
        let mut path = self.root.clone();
        for step in name.split('/') {
            path.push(step);
            let found = fs::symlink_metadata(&path);
            if found.is_ok_and(|found| found.file_type().is_symlink()) {
                return Err(Failure::new(format!(
                    "`{}` is a link, and none is followed",
                    path.display()
                ))
                .help("remove the link, or give another folder with `--out`"));
            }
        }
        Ok(path)
    }

    /// Begins a file. Dropped before it is finished it leaves nothing behind.
    pub(crate) fn begin(&self, name: &str) -> Result<Draft, Failure> {
        let path = self.path(name)?;
        let folder = path.parent().unwrap_or(&self.root);
        make_private(folder).map_err(unwritable(&path))?;
        let own = path.file_name().unwrap_or_default().to_string_lossy();
        let draft = files::new_draft(folder, &own, Access::Private).map_err(unwritable(&path))?;
        // Kept under its own name: whether it is removed is for the drop to say, as an interrupted run may go
        // on with it.
        let (file, draft) = draft
            .keep()
            .map_err(|error| unwritable(&path)(error.error))?;
        Ok(Draft {
            path,
            draft,
            file: Some(BufWriter::with_capacity(1 << 16, file)),
            length: 0,
            digest: Some(Sha256::new()),
            stays: false,
        })
    }

    /// Goes on with a file of which an interrupted run has left something; begins it where nothing is left.
    ///
    /// It stays when the program ends before it is finished, so that a later run can go on.
    pub(crate) fn go_on(&self, name: &str, left: Option<&Left>) -> Result<Draft, Failure> {
        let Some(left) = left else {
            let mut draft = self.begin(name)?;
            draft.stays = true;
            return Ok(draft);
        };
        let path = self.path(name)?;
        let draft = self.left(name, left).ok_or_else(|| {
            unwritable(&path)(io::Error::other("what an interrupted run has left is gone"))
        })?;
        let mut file = open_own(&draft).map_err(unwritable(&path))?;
        files::claim(&file);
        // What was written after the last note in the ledger may be half a sheet.
        file.set_len(left.length).map_err(unwritable(&path))?;
        // The state of a hash is nowhere kept, so that what is there is read once more.
        let digest = files::hash(&mut file).map_err(unwritable(&path))?;
        file.seek(SeekFrom::End(0)).map_err(unwritable(&path))?;
        Ok(Draft {
            path,
            draft,
            file: Some(BufWriter::with_capacity(1 << 16, file)),
            length: left.length,
            digest: Some(digest),
            stays: true,
        })
    }

    /// The draft of a file that an interrupted run has left, if it is there as far as it counts.
    pub(crate) fn left(&self, name: &str, left: &Left) -> Option<PathBuf> {
        let path = self.path(name).ok()?;
        let own = path.file_name()?.to_string_lossy().into_owned();
        let is_draft = is_plain(&left.draft)
            && !left.draft.contains('/')
            && left.draft.starts_with(&format!(".{own}."))
            && left.draft.ends_with(files::DRAFT);
        let draft = is_draft.then(|| path.with_file_name(&left.draft))?;
        let found = fs::symlink_metadata(&draft).ok()?;
        (found.is_file() && found.len() >= left.length).then_some(draft)
    }

    /// Writes a file so that it is there whole or not at all; its digest is returned.
    pub(crate) fn write(&self, name: &str, content: &[u8]) -> Result<String, Failure> {
        let mut draft = self.begin(name)?;
        draft.write(content)?;
        draft.finish()
    }

    /// A file to be read.
    pub(crate) fn open(&self, name: &str) -> Result<fs::File, Failure> {
        files::open(&self.path(name)?)
    }

    /// Whether something of this name is there.
    pub(crate) fn has(&self, name: &str) -> bool {
        is_plain(name) && fs::symlink_metadata(self.root.join(name)).is_ok()
    }

    /// Whether a file is there and has this digest.
    pub(crate) fn is_intact(&self, name: &str, digest: &str) -> bool {
        let file = self.open(name);

        file.is_ok_and(|mut file| {
            files::hash(&mut file).is_ok_and(|found| files::hexadecimal(found) == digest)
        })
    }

    /// Removes a file, if it is there.
    pub(crate) fn remove(&self, name: &str) -> Result<(), Failure> {
        let path = self.path(name)?;
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(Failure::new(format!(
                "cannot remove `{}`: {error}",
                path.display()
            ))),
            _ => Ok(()),
        }
    }

    /// Moves a file or a folder to another name, which must be free.
    pub(crate) fn rename(&self, from: &str, to: &str) -> Result<(), Failure> {
        let (from, to) = (self.path(from)?, self.path(to)?);
        if fs::symlink_metadata(&to).is_ok() {
            return Err(unwritable(&to)(io::ErrorKind::AlreadyExists.into()));
        }
        make_private(to.parent().unwrap_or(&self.root)).map_err(unwritable(&to))?;
        fs::rename(&from, &to).map_err(unwritable(&to))
    }

    /// The names of what stands in one of its folders, `""` for itself, in order.
    pub(crate) fn names(&self, inside: &str) -> Vec<String> {
        let folder = if inside.is_empty() {
            Ok(self.root.clone())
        } else {
            self.path(inside)
        };
        let entries = folder.ok().and_then(|folder| fs::read_dir(folder).ok());
        let mut names: Vec<String> = entries
            .into_iter()
            .flatten()
            .flatten()
            .filter_map(|entry| entry.file_name().into_string().ok())
            .collect();
        // In the order of names, and not that of the disk, which differs between machines.
        names.sort();
        names
    }

    /// Removes the drafts that interrupted runs have left in its folders `inside`, but those that are gone on with.
    ///
    /// A link is removed itself, not what it points to; a draft that a program still writes to stays.
    pub(crate) fn sweep(&self, inside: &[&str], kept: &BTreeSet<String>) {
        for folder in inside {
            let is_left = |name: &String| name.starts_with('.') && name.ends_with(files::DRAFT);
            for name in self.names(folder).into_iter().filter(is_left) {
                if !kept.contains(&name) {
                    files::discard(&self.root.join(folder).join(name));
                }
            }
        }
    }

    /// A file for the run alone, which other runs find by its name, and which nobody else writes to while it is open.
    ///
    /// `None` where another run has it.
    pub(crate) fn claim(&self, name: &str) -> Result<Option<fs::File>, Failure> {
        let path = self.path(name)?;
        let opened = make_private(&self.root).and_then(|()| own(&path));
        let file = opened.map_err(unwritable(&path))?;
        // The system gives a lock back when its process ends, however that ends: nothing is left to clean up.
        Ok(file.try_lock().is_ok().then_some(file))
    }
}

/// A file that is written piece by piece beside its place, and moved there when it is complete.
pub(crate) struct Draft {
    path: PathBuf,
    draft: PathBuf,
    file: Option<BufWriter<fs::File>>,
    length: u64,
    /// None where nobody asks for it.
    digest: Option<Sha256>,
    /// Whether it stays where it is when it is dropped unfinished, to be gone on with.
    stays: bool,
}

impl Draft {
    /// The same for a file whose digest nobody asks for.
    pub(crate) fn without_digest(mut self) -> Self {
        self.digest = None;
        self
    }

    /// Writes a piece.
    pub(crate) fn write(&mut self, piece: &[u8]) -> Result<(), Failure> {
        if let Some(digest) = &mut self.digest {
            digest.update(piece);
        }
        self.length += piece.len() as u64;
        self.open().write_all(piece).map_err(unwritable(&self.path))
    }

    /// How many bytes were written.
    pub(crate) fn length(&self) -> u64 {
        self.length
    }

    /// Hands everything to the system; what a later run would go on with.
    pub(crate) fn flush(&mut self) -> Result<Left, Failure> {
        self.open().flush().map_err(unwritable(&self.path))?;
        let draft = self.draft.file_name().unwrap_or_default();
        Ok(Left {
            length: self.length,
            draft: draft.to_string_lossy().into_owned(),
        })
    }

    fn open(&mut self) -> &mut BufWriter<fs::File> {
        self.file
            .as_mut()
            .expect("a draft is open until it is finished")
    }

    /// All that was written, which is not moved to its place.
    pub(crate) fn take(mut self) -> Result<String, Failure> {
        self.flush()?;
        self.stays = false;
        files::read(&self.draft)
    }

    /// Moves the file to its place; its digest is returned, which is empty where nobody asks for it.
    pub(crate) fn finish(mut self) -> Result<String, Failure> {
        let file = self.file.take().expect("a draft is finished once");
        file.into_inner()
            .map_err(io::IntoInnerError::into_error)
            // On the disk before the name points to it: a crash in between must not leave an empty file under
            // a good name.
            .and_then(|file| file.sync_data())
            .and_then(|()| fs::rename(&self.draft, &self.path))
            .map_err(unwritable(&self.path))?;
        let digest = self.digest.take();
        Ok(digest.map_or_else(String::new, files::hexadecimal))
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // After `finish` the draft has moved, and there is nothing to remove.
        if !self.stays && (self.file.is_some() || self.draft.exists()) {
            let _ = fs::remove_file(&self.draft);
        }
    }
}

/// Whether a name consists of plain steps: none leads up, to a root, a drive or a device, or breaks a line.
pub(crate) fn is_plain(name: &str) -> bool {
    /// Longest name of a file on the usual systems, less what a draft adds.
    const MAX_LENGTH: usize = 200;
    name.split('/').all(|step| {
        !matches!(step, "" | "." | "..")
            && step.len() <= MAX_LENGTH
            // What Windows does not take in names is refused everywhere, so that a manifest serves on any
            // machine.
            && !step.contains(|char: char| char.is_control() || "\\:*?\"<>|".contains(char))
            // Windows drops these, and two names would be one file.
            && !step.ends_with(['.', ' '])
    })
}

/// Makes a folder with those that it stands in: its owner's alone where the system knows that.
fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::DirBuilderExt;
        builder.mode(0o700);
    }
    builder.create(folder)
}

/// Opens a file of the run for reading and writing, or makes it.
fn own(path: &Path) -> io::Result<fs::File> {
    let mut options = fs::OpenOptions::new();
    options.read(true).write(true).create_new(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.mode(0o600);
    }
    match options.open(path) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => open_own(path),
        opened => opened,
    }
}

/// Opens a file that an earlier run has left, for reading and writing: no link, and no second name of another file.
fn open_own(path: &Path) -> io::Result<fs::File> {
    let seen = fs::symlink_metadata(path)?;
    let foreign = || io::Error::other("it is a link, or no file that a run has left; remove it");
    if !seen.is_file() {
        return Err(foreign());
    }
    let file = fs::OpenOptions::new().read(true).write(true).open(path)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        // The one that was looked at, not what was slipped in since.
        let opened = file.metadata()?;
        let is_same = (opened.dev(), opened.ino()) == (seen.dev(), seen.ino());
        if !is_same || opened.nlink() != 1 {
            return Err(foreign());
        }
    }
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::is_plain;

    #[test]
    fn names_that_leave_the_folder_are_refused() {
        for name in [
            "sheets.html",
            "sheets/3PZ-HEN-YFB.html",
            "marks/feedback/a.html",
        ] {
            assert!(is_plain(name), "{name}");
        }
        let long = "x".repeat(201);
        for name in [
            "", ".", "..", "../x", "a/../b", "/abs/x", "a//b", "a/", "C:x", "a\\..\\b", "a\0b",
            "a\nb", "nul.", &long,
        ] {
            assert!(!is_plain(name), "{name:?}");
        }
    }
}
