//! Ways for the fuzz campaign to the readers of files that belong to the command line; see `fuzz/`.

use std::path::PathBuf;
use std::sync::LazyLock;

use vibank::worksheet::Columns;

use super::{Failure, class_list, files, grade, responses};

/// A class list, as `sheet` reads it: the number of students, or the message.
pub fn class_list(bytes: &[u8]) -> Result<usize, String> {
    let students = class_list::read(&input(bytes, "csv"), &Columns::default());
    students
        .map(|students| students.len())
        .map_err(|failure| message(&failure))
}

/// Responses, as `grade` reads them: the number of faults, or the message.
pub fn responses(bytes: &[u8]) -> Result<usize, String> {
    let end = if bytes.starts_with(b"[") {
        "json"
    } else {
        "csv"
    };
    let read = responses::read(&input(bytes, end));
    read.map(|handed| handed.faults())
        .map_err(|failure| message(&failure))
}

/// A manifest, as `grade` reads it: the number of sheets, or the message.
pub fn manifest(bytes: &[u8]) -> Result<usize, String> {
    let read = grade::manifest(&input(bytes, "manifest.json"));
    read.map(|manifest| manifest.variants.len())
        .map_err(|failure| message(&failure))
}

/// A failure as it is printed, which says something.
fn message(failure: &Failure) -> String {
    let message = failure.to_string();
    assert!(!message.trim().is_empty(), "a failure without words");
    message
}

/// A file with this content, the same in the whole campaign: the readers take paths.
fn input(bytes: &[u8], end: &str) -> PathBuf {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        let memory = PathBuf::from("/dev/shm");
        let folder = if memory.is_dir() {
            memory
        } else {
            std::env::temp_dir()
        };
        folder.join(format!("vibank-fuzz-{}", std::process::id()))
    });
    let path = FOLDER.join(end);
    let written = files::write(&path, bytes, files::Access::Private);
    assert!(written.is_ok(), "no room for inputs of the campaign");
    path
}
