//! What the suite makes for the book: it is compared with what is committed, and `UPDATE_BOOK=1 cargo test --test suite`
//! writes it anew.

use std::fs;
use std::path::{Path, PathBuf};

/// Compares a file with what it should hold, or writes it.
pub(crate) fn compare(path: impl AsRef<Path>, text: &str) {
    compare_all([(path.as_ref().to_owned(), text.to_owned())]);
}

/// The same for several files: all that are stale are named.
pub(crate) fn compare_all(files: impl IntoIterator<Item = (PathBuf, String)>) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let is_fresh = |(path, text): &(PathBuf, String)| {
        fs::read_to_string(root.join(path)).is_ok_and(|found| found == *text)
    };
    let stale = files.into_iter().filter(|own| !is_fresh(own));
    let stale: Vec<(PathBuf, String)> = stale.collect();
    if std::env::var_os("UPDATE_BOOK").is_some() {
        for (path, text) in stale {
            let file = root.join(path);
            let folder = file.parent().expect("it lies in a folder");
            fs::create_dir_all(folder).expect("the folder can be made");
            fs::write(&file, text).expect("the file can be written");
        }
        return;
    }
    // The name of the test; those that are named so make pages, pictures and lists in seconds, all at once.
    let thread = std::thread::current();
    let filter = match thread.name() {
        Some(test) if test.ends_with("fresh") => " fresh".to_owned(),
        // One test after the other runs on a thread that bears no test's name.
        Some("main") | None => String::new(),
        Some(test) => format!(" {test}"),
    };
    let names: Vec<_> = stale
        .iter()
        .map(|(path, _)| path.display().to_string())
        .collect();
    assert!(
        names.is_empty(),
        "stale: {}; `UPDATE_BOOK=1 cargo test --test suite{filter}` writes what is stale anew",
        names.join(", ")
    );
}

/// The same for the part of a file between two marks.
pub(crate) fn compare_between(path: impl AsRef<Path>, [begin, end]: [&str; 2], part: &str) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(path.as_ref());
    let text = fs::read_to_string(file).expect("the file can be read");
    let (before, rest) = text.split_once(begin).expect("the part begins");
    let (_, after) = rest.split_once(end).expect("the part ends");
    compare(path, &format!("{before}{begin}{part}{end}{after}"));
}
