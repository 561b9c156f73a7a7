//! The bank that comes with the program.

use include_dir::{Dir, include_dir};

static BANK: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/bank");

/// The files of the bank that comes with the program, each with its path inside the bank.
///
/// ```
/// let (catalogue, findings) = vibank::bank::Catalogue::load(vibank::bank::embedded());
/// assert!(catalogue.items().next().is_some());
/// # let _ = findings;
/// ```
pub fn embedded() -> Vec<(&'static str, &'static str)> {
    let mut files = Vec::new();
    collect(&BANK, &mut files);
    files
}

/// The chapters of the course that comes with the program, in order: the name of each, and its text.
///
/// ```
/// let course = vibank::bank::course();
/// assert!(course.iter().all(|(_, text)| text.starts_with("# ")));
/// ```
pub fn course() -> Vec<(&'static str, &'static str)> {
    let files = BANK.get_dir("course").into_iter().flat_map(Dir::files);
    let mut chapters: Vec<_> = files
        .filter_map(|file| Some((file.path().to_str()?, file.contents_utf8()?)))
        .collect();
    chapters.sort_unstable();
    chapters
}

fn collect(folder: &'static Dir<'static>, files: &mut Vec<(&'static str, &'static str)>) {
    for file in folder.files() {
        if let (Some(path), Some(text)) = (file.path().to_str(), file.contents_utf8())
            && path.ends_with(".toml")
        {
            files.push((path, text));
        }
    }
    folder.dirs().for_each(|inner| collect(inner, files));
}
