//! Reading with a bound, writing without half-written files.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use sha2::{Digest, Sha256};

use super::Failure;

/// No input file of vibank is larger than this.
const LIMIT: u64 = 64 << 20;

/// The text of a file; a mark of byte order is dropped.
pub(crate) fn read(path: &Path) -> Result<String, Failure> {
    let bytes = read_bytes(path)?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..at]
            .iter()
            .filter(|byte| **byte == b'\n')
            .count()
            + 1;
        Failure::new(format!("`{}` is not UTF-8 at line {line}", path.display()))
            .help("save the file as UTF-8")
    })?;
    Ok(text
        .strip_prefix('\u{feff}')
        .map_or_else(|| text.clone(), str::to_owned))
}

/// The bytes of a file.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let fail =
        |error: io::Error| Failure::new(format!("cannot read `{}`: {error}", path.display()));
    let file = fs::File::open(path).map_err(fail)?;
    let mut bytes = Vec::new();
    file.take(LIMIT + 1).read_to_end(&mut bytes).map_err(fail)?;
    if bytes.len() as u64 > LIMIT {
        return Err(Failure::new(format!(
            "`{}` is larger than {} MiB",
            path.display(),
            LIMIT >> 20
        )));
    }
    Ok(bytes)
}

/// Writes a file so that it is there whole or not at all.
pub(crate) fn write(path: &Path, content: &[u8]) -> Result<(), Failure> {
    let mut draft = Draft::begin(path)?;
    draft.write(content)?;
    draft.finish().map(|_| ())
}

/// Drafts of files that are written at once, for their names.
static DRAFTS: AtomicU64 = AtomicU64::new(0);

/// A file that is written piece by piece beside its place, and moved there when it is complete.
pub(crate) struct Draft {
    path: PathBuf,
    draft: PathBuf,
    file: Option<io::BufWriter<fs::File>>,
    length: u64,
    digest: Sha256,
    /// Whether it stays where it is when it is dropped unfinished, to be gone on with.
    stays: bool,
}

impl Draft {
    /// Begins the file that will stand at `path`; its folder is made.
    ///
    /// Dropped before it is finished it leaves nothing behind.
    pub(crate) fn begin(path: &Path) -> Result<Self, Failure> {
        let number = DRAFTS.fetch_add(1, Ordering::Relaxed);
        let draft = beside(path, &format!("{}-{number}.part", std::process::id()));
        make_folder(path)?;
        let file = fs::File::create(&draft).map_err(|error| unwritable(path, &error))?;
        Ok(Self::over(path, draft, file, false))
    }

    /// Goes on with the file that will stand at `path` after its first `length` bytes; what was written beyond is
    /// dropped.
    ///
    /// It stays when the program ends before it is finished, so that a later run can go on.
    pub(crate) fn go_on(path: &Path, length: u64) -> Result<Self, Failure> {
        let fail = |error: io::Error| unwritable(path, &error);
        let draft = beside(path, "part");
        make_folder(path)?;
        let mut options = fs::OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut file = options.open(&draft).map_err(fail)?;
        file.set_len(length).map_err(fail)?;
        let digest = hash(&mut file).map_err(fail)?;
        let mut going = Self::over(path, draft, file, true);
        (going.length, going.digest) = (length, digest);
        Ok(going)
    }

    /// How much of the file that will stand at `path` an earlier run has left.
    pub(crate) fn left(path: &Path) -> u64 {
        fs::metadata(beside(path, "part")).map_or(0, |file| file.len())
    }

    /// Removes what an earlier run has left of the file that would stand at `path`.
    pub(crate) fn discard(path: &Path) {
        let _ = fs::remove_file(beside(path, "part"));
    }

    fn over(path: &Path, draft: PathBuf, file: fs::File, stays: bool) -> Self {
        Self {
            path: path.to_owned(),
            draft,
            file: Some(io::BufWriter::with_capacity(1 << 16, file)),
            length: 0,
            digest: Sha256::new(),
            stays,
        }
    }

    /// Writes a piece.
    pub(crate) fn write(&mut self, piece: &[u8]) -> Result<(), Failure> {
        self.digest.update(piece);
        self.length += piece.len() as u64;
        let file = self.open();
        file.write_all(piece)
            .map_err(|error| unwritable(&self.path, &error))
    }

    /// Hands everything to the system; how long the file is now.
    pub(crate) fn flush(&mut self) -> Result<u64, Failure> {
        let flushed = self.open().flush();
        flushed.map_err(|error| unwritable(&self.path, &error))?;
        Ok(self.length)
    }

    fn open(&mut self) -> &mut io::BufWriter<fs::File> {
        self.file
            .as_mut()
            .expect("a draft is open until it is finished")
    }

    /// All that was written, which is not moved to its place.
    pub(crate) fn take(mut self) -> Result<String, Failure> {
        self.flush()?;
        self.stays = false;
        read(&self.draft)
    }

    /// Moves the file to its place; its digest is told.
    pub(crate) fn finish(mut self) -> Result<String, Failure> {
        let file = self.file.take().expect("a draft is finished once");
        let done = file
            .into_inner()
            .map_err(io::IntoInnerError::into_error)
            .and_then(|file| file.sync_data());
        done.and_then(|()| fs::rename(&self.draft, &self.path))
            .map_err(|error| unwritable(&self.path, &error))?;
        Ok(hexadecimal(self.digest.clone()))
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

/// Where the draft of a file stands: beside it and hidden.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{ending}"))
}

fn make_folder(path: &Path) -> Result<(), Failure> {
    let folder = path.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(folder).map_err(|error| unwritable(path, &error))
}

/// The hash over what is left to read of a file.
fn hash(file: &mut fs::File) -> io::Result<Sha256> {
    let mut digest = Sha256::new();
    io::copy(file, &mut Hashing(&mut digest))?;
    Ok(digest)
}

/// Feeds a hash with what is written.
struct Hashing<'a>(&'a mut Sha256);

impl Write for Hashing<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Whether a file is there and has this digest.
pub(crate) fn is_intact(path: &Path, digest: &str) -> bool {
    let hashed = fs::File::open(path).and_then(|mut file| hash(&mut file));
    hashed.is_ok_and(|found| hexadecimal(found) == digest)
}

/// SHA-256 of some bytes, in hexadecimal digits.
pub(crate) fn digest(bytes: &[u8]) -> String {
    hexadecimal(Sha256::new_with_prefix(bytes))
}

/// SHA-256 of a file of any size, in hexadecimal digits.
pub(crate) fn digest_of(path: &Path) -> Result<String, Failure> {
    let hashed = fs::File::open(path).and_then(|mut file| hash(&mut file));
    hashed
        .map(hexadecimal)
        .map_err(|error| Failure::new(format!("cannot read `{}`: {error}", path.display())))
}

/// The digits of a hash.
pub(crate) fn hexadecimal(hash: Sha256) -> String {
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

fn unwritable(path: &Path, error: &io::Error) -> Failure {
    Failure::new(format!("cannot write `{}`: {error}", path.display()))
}
