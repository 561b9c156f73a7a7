//! Reading files with a bound, and writing a single file that somebody named.
//!
//! What a run writes into its folder goes through [`super::folder`].

use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

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
    // Excel writes the mark before UTF-8, where it would become part of the first heading.
    Ok(text
        .strip_prefix('\u{feff}')
        .map_or_else(|| text.clone(), str::to_owned))
}

/// The bytes of a file.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let file = open(path)?;
    let mut bytes = Vec::new();
    // One byte more tells a file that is too large from one that fits exactly.
    file.take(LIMIT + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable(path))?;
    if bytes.len() as u64 > LIMIT {
        return Err(Failure::new(format!(
            "`{}` is larger than {} MiB",
            path.display(),
            LIMIT >> 20
        )));
    }
    Ok(bytes)
}

/// Opens a file to be read: a pipe or a device has no end to wait for, and a folder no bytes.
pub(crate) fn open(path: &Path) -> Result<fs::File, Failure> {
    let kind = fs::metadata(path).map_err(unreadable(path))?.file_type();
    if !kind.is_file() {
        let (what, help) = if kind.is_dir() {
            ("a folder", "give a file in it")
        } else {
            (
                "a pipe or a device",
                "save what it gives to a file, and give that",
            )
        };
        let shown = path.display();
        return Err(Failure::new(format!("`{shown}` is {what}, not a file")).help(help));
    }
    fs::File::open(path).map_err(unreadable(path))
}

/// Who may read a file that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Access {
    /// Whoever the system lets read new files.
    Usual,
    /// The owner alone, where the system knows that.
    Private,
}

/// Writes a file so that it is there whole or not at all; its folder is made. A pipe or a device, such as `/dev/null`,
/// takes the bytes and stays what it is.
pub(crate) fn write(path: &Path, content: &[u8], access: Access) -> Result<(), Failure> {
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => {
            let failure = Failure::new(format!("`{}` is a folder, not a file", path.display()));
            return Err(failure.help("name a file in it"));
        }
        Ok(there) if !there.is_file() => {
            let file = fs::OpenOptions::new().write(true).open(path);
            return file
                .and_then(|mut file| file.write_all(content))
                .map_err(unwritable(path));
        }
        _ => {}
    }
    let folder = folder_of(path);
    fs::create_dir_all(folder).map_err(unwritable(path))?;
    let draft = whole_draft(folder, &file_name(path), content, access).map_err(unwritable(path))?;
    draft
        .persist(path)
        .map_err(|error| unwritable(path)(error.error))?;
    Ok(())
}

/// Writes a file that is not there yet, whole or not at all; its folder is made.
///
/// One that somebody has written in the meantime stays as it is: of two secrets the first may be in use.
pub(crate) fn write_new(path: &Path, content: &[u8], access: Access) -> Result<(), Failure> {
    let folder = folder_of(path);
    fs::create_dir_all(folder).map_err(unwritable(path))?;
    let draft = whole_draft(folder, &file_name(path), content, access).map_err(unwritable(path))?;
    match draft.persist_noclobber(path) {
        Ok(_) => Ok(()),
        Err(error) if error.error.kind() == io::ErrorKind::AlreadyExists => Err(exists(path)),
        Err(error) => Err(unwritable(path)(error.error)),
    }
}

/// A file of this name is there, and stays.
pub(crate) fn exists(path: &Path) -> Failure {
    Failure::new(format!("`{}` exists already", path.display())).help("choose another name")
}

/// The folder in which a file stands.
fn folder_of(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// A draft with all that the file will hold, in the same folder, since a file is moved in one step within a file system
/// only. What interrupted runs have left of this file is removed.
fn whole_draft(
    folder: &Path,
    name: &str,
    content: &[u8],
    access: Access,
) -> io::Result<tempfile::NamedTempFile> {
    let entries = fs::read_dir(folder);
    for entry in entries.into_iter().flatten().flatten() {
        if is_draft(&entry.file_name().to_string_lossy(), name) {
            discard(&entry.path());
        }
    }
    let mut draft = new_draft(folder, name, access)?;
    draft.write_all(content)?;
    // Else a crash after the move may leave the new name with nothing behind it.
    draft.as_file().sync_data()?;
    Ok(draft)
}

/// Whether a file is a draft of the file `of`, by its name.
pub(crate) fn is_draft(name: &str, of: &str) -> bool {
    let middle = name.strip_prefix('.').and_then(|rest| {
        rest.strip_prefix(of)?
            .strip_prefix('.')?
            .strip_suffix(DRAFT)
    });
    middle.is_some_and(|middle| {
        !middle.is_empty() && middle.chars().all(|char| char.is_ascii_alphanumeric())
    })
}

/// Removes a draft that no program writes to any more; of a link the link itself.
pub(crate) fn discard(draft: &Path) {
    let is_file = fs::symlink_metadata(draft).is_ok_and(|found| found.is_file());
    if is_file && is_claimed(draft) {
        return;
    }
    let _ = fs::remove_file(draft);
}

/// Keeps a draft from being taken for what an interrupted run has left: the system gives the lock back when the program
/// ends, however that ends.
pub(crate) fn claim(draft: &fs::File) {
    // Elsewhere a lock keeps the program itself from reading the file, and an open file cannot be removed.
    #[cfg(unix)]
    let _ = draft.try_lock();
    #[cfg(not(unix))]
    let _ = draft;
}

fn is_claimed(draft: &Path) -> bool {
    #[cfg(unix)]
    return fs::File::open(draft)
        .is_ok_and(|file| matches!(file.try_lock(), Err(fs::TryLockError::WouldBlock)));
    #[cfg(not(unix))]
    return false;
}

/// A new file with a name that nobody can guess, beside the file `name` that it will become.
pub(crate) fn new_draft(
    folder: &Path,
    name: &str,
    access: Access,
) -> io::Result<tempfile::NamedTempFile> {
    let prefix = format!(".{name}.");
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix).suffix(DRAFT);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = match access {
            // Less what the user's mask takes off.
            Access::Usual => 0o666,
            Access::Private => 0o600,
        };
        builder.permissions(fs::Permissions::from_mode(mode));
    }
    #[cfg(not(unix))]
    let _ = access;
    let draft = builder.tempfile_in(folder)?;
    claim(draft.as_file());
    Ok(draft)
}

/// Whether somebody besides its owner can read or write a file, where the system knows that.
pub(crate) fn is_open_to_others(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        fs::metadata(path).is_ok_and(|own| own.is_file() && own.permissions().mode() & 0o077 != 0)
    }
    #[cfg(not(unix))]
    {
        let _ = path;
        false
    }
}

/// How the names of drafts end.
pub(crate) const DRAFT: &str = ".part";

fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// The hash over what is left to read of a file.
pub(crate) fn hash(file: &mut fs::File) -> io::Result<Sha256> {
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

/// SHA-256 of some bytes, in hexadecimal digits.
pub(crate) fn digest(bytes: &[u8]) -> String {
    hexadecimal(Sha256::new_with_prefix(bytes))
}

/// SHA-256 of a file of any size, in hexadecimal digits.
pub(crate) fn digest_of(path: &Path) -> Result<String, Failure> {
    hash(&mut open(path)?)
        .map(hexadecimal)
        .map_err(unreadable(path))
}

/// The digits of a hash.
pub(crate) fn hexadecimal(hash: Sha256) -> String {
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// The failure that comes of an error in writing a file.
pub(crate) fn unwritable(path: &Path) -> impl Fn(io::Error) -> Failure {
    move |error| {
        let (why, help) = match error.kind() {
            io::ErrorKind::PermissionDenied => {
                ("you may not write there", "choose a folder of your own")
            }
            io::ErrorKind::ReadOnlyFilesystem => (
                "nothing can be written there",
                "choose a folder of your own",
            ),
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => (
                "there is no room left",
                "make room, and give the same command again",
            ),
            _ => return Failure::new(format!("cannot write `{}`: {error}", path.display())),
        };
        Failure::new(format!("cannot write `{}`: {why}", path.display())).help(help)
    }
}

/// The failure that comes of an error in reading a file or a folder.
pub(crate) fn unreadable(path: &Path) -> impl Fn(io::Error) -> Failure {
    move |error| Failure::new(format!("cannot read `{}`: {error}", path.display()))
}
