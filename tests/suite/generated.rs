//! What the suite makes for the book: it is compared with what is committed, and `UPDATE_BOOK=1 cargo test --test suite`
//! writes it anew.

use std::fs;
use std::path::Path;

/// Compares a file with what it should hold, or writes it.
pub(crate) fn compare(path: impl AsRef<Path>, text: &str) {
    let path = path.as_ref();
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    if fs::read_to_string(&file).is_ok_and(|found| found == text) {
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
    assert!(
        std::env::var_os("UPDATE_BOOK").is_some(),
        "{} is stale; `UPDATE_BOOK=1 cargo test --test suite{filter}` writes it anew",
        path.display()
    );
    let folder = file.parent().expect("it lies in a folder");
    fs::create_dir_all(folder).expect("the folder can be made");
    fs::write(&file, text).expect("the file can be written");
}

/// The same for the part of a file between two marks.
pub(crate) fn compare_between(path: impl AsRef<Path>, [begin, end]: [&str; 2], part: &str) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(path.as_ref());
    let text = fs::read_to_string(file).expect("the file can be read");
    let (before, rest) = text.split_once(begin).expect("the part begins");
    let (_, after) = rest.split_once(end).expect("the part ends");
    compare(path, &format!("{before}{begin}{part}{end}{after}"));
}
