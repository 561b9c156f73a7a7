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
