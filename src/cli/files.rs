//! Reading with a bound, writing without half-written files.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

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

/// A file that is written piece by piece beside its place, and moved there when it is complete.
///
/// One that is dropped before leaves nothing behind.
pub(crate) struct Draft {
    path: PathBuf,
    draft: PathBuf,
    file: Option<io::BufWriter<fs::File>>,
    digest: Sha256,
}

impl Draft {
    /// Begins the file that will stand at `path`; its folder is made.
    pub(crate) fn begin(path: &Path) -> Result<Self, Failure> {
        let folder = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
            .unwrap_or(Path::new("."));
        fs::create_dir_all(folder).map_err(|error| unwritable(path, &error))?;
        let name = path
            .file_name()
            .map(|name| name.to_string_lossy().into_owned())
            .unwrap_or_default();
        let draft = folder.join(format!(".{name}.{}.part", std::process::id()));
        let file = fs::File::create(&draft).map_err(|error| unwritable(path, &error))?;
        Ok(Self {
            path: path.to_owned(),
            draft,
            file: Some(io::BufWriter::new(file)),
            digest: Sha256::new(),
        })
    }

    /// Writes a piece.
    pub(crate) fn write(&mut self, piece: &[u8]) -> Result<(), Failure> {
        self.digest.update(piece);
        let file = self
            .file
            .as_mut()
            .expect("a draft is open until it is finished");
        file.write_all(piece)
            .map_err(|error| unwritable(&self.path, &error))
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
        if self.file.is_some() || self.draft.exists() {
            let _ = fs::remove_file(&self.draft);
        }
    }
}

/// SHA-256 of some bytes, in hexadecimal digits.
pub(crate) fn digest(bytes: &[u8]) -> String {
    hexadecimal(Sha256::new_with_prefix(bytes))
}

fn hexadecimal(hash: Sha256) -> String {
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

fn unwritable(path: &Path, error: &io::Error) -> Failure {
    Failure::new(format!("cannot write `{}`: {error}", path.display()))
}
