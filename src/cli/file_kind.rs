//! The kinds of files that a command is given: a file in the place of another kind is named, and a folder stands for the
//! manifest in it.

use std::path::{Path, PathBuf};

use clap::builder::{PathBufValueParser, TypedValueParser};

use vibank::source::Source;

use super::{Failure, files};

/// A kind of file that this program reads or writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    /// The manifest of a run.
    Manifest,
    /// A blueprint, from which sheets are made.
    Blueprint,
    /// Answers by sheets.
    Answers,
    /// Another table.
    Table,
    /// An archive: a package or a workbook.
    Archive,
    /// A page for browsers.
    Page,
}

impl FileKind {
    /// What a file seems to be by its beginning.
    fn of(bytes: &[u8]) -> Option<Self> {
        /// Enough for the headings of any table and the first keys of any file.
        const BEGINNING: usize = 4096;
        if bytes.starts_with(b"PK\x03\x04") {
            return Some(Self::Archive);
        }
        let beginning = String::from_utf8_lossy(&bytes[..bytes.len().min(BEGINNING)]);
        let beginning = beginning.trim_start_matches('\u{feff}').trim_start();
        if beginning.starts_with('{') && beginning.contains("\"program\"") {
            return Some(Self::Manifest);
        }
        if beginning.starts_with('<') {
            return Some(Self::Page);
        }
        let mut lines = beginning.lines().map(str::trim);
        let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'))?;
        if first.starts_with('[') || first.contains('=') {
            return beginning
                .contains("[[question]]")
                .then_some(Self::Blueprint);
        }
        let cells: Vec<String> = first
            .split([',', ';', '\t'])
            .map(|cell| cell.trim_matches('"').to_lowercase())
            .collect();
        match cells.len() {
            1 => None,
            _ if cells.iter().any(|cell| cell == "response") => Some(Self::Answers),
            _ => Some(Self::Table),
        }
    }

    /// What a file seems to be; nothing where it cannot be read.
    pub(crate) fn of_file(path: &Path) -> Option<Self> {
        Self::of(&files::read_bytes(path).ok()?)
    }

    /// With its article.
    fn words(self) -> &'static str {
        match self {
            Self::Manifest => "the manifest of a run",
            Self::Blueprint => "a blueprint",
            Self::Answers => "a table of answers",
            Self::Table => "a table",
            Self::Archive => "an archive",
            Self::Page => "a page",
        }
    }
}

/// A failure of a file that is not a manifest.
pub(crate) fn not_a_manifest(path: &Path, why: &str) -> Failure {
    let shown = path.display();
    match FileKind::of_file(path) {
        Some(FileKind::Blueprint) => Failure::new(format!("`{shown}` is a blueprint, not a manifest"))
            .help(format!(
                "make the sheets with `vibank sheet {shown}`, and give the `manifest.json` that it writes"
            )),
        Some(kind) if kind != FileKind::Manifest => {
            Failure::new(format!("`{shown}` is {}, not a manifest", kind.words()))
                .help("give the `manifest.json` that `vibank sheet` wrote, then the answers")
        }
        _ => {
            // What the reader of JSON says of a list is about its own types.
            let bytes = files::read_bytes(path).unwrap_or_default();
            let why = match bytes.trim_ascii_start().first() {
                Some(b'{') => why,
                _ => "it is not one JSON object",
            };
            Failure::new(format!("`{shown}` is not a manifest: {why}"))
                .help("give the `manifest.json` that `vibank sheet` wrote")
        }
    }
}

/// A failure of a file that is not a list of answers.
pub(crate) fn not_answers(path: &Path, why: &str) -> Failure {
    let shown = path.display();
    match FileKind::of_file(path) {
        Some(FileKind::Manifest) => Failure::new(format!(
            "`{shown}` is the manifest of a run, not a list of answers"
        ))
        .help("give the manifest first and then the answers"),
        Some(kind @ (FileKind::Blueprint | FileKind::Page)) => Failure::new(format!(
            "`{shown}` is {}, not a list of answers",
            kind.words()
        ))
        .help("give the `responses.csv` that `vibank sheet` wrote, filled in"),
        _ => Failure::new(format!("`{shown}` is not a list of responses: {why}"))
            .help("give an array of objects with `code`, `question`, `part` and `response`"),
    }
}

/// The text of a blueprint with its path; a file that is surely something else is a failure.
pub(crate) fn blueprint(path: &Path) -> Result<Source, Failure> {
    let text = files::read(path)?;
    match FileKind::of(text.as_bytes()) {
        Some(
            kind @ (FileKind::Manifest | FileKind::Answers | FileKind::Table | FileKind::Page),
        ) => {
            Err(
                Failure::new(format!("`{}` is {}, not a blueprint", path.display(), kind.words()))
                    .help("give a blueprint, `exam.toml`, which names its class list under `students`; `vibank new exam exam.toml` begins one"),
            )
        }
        _ => Ok(Source::new(path.display().to_string(), text)),
    }
}

/// A failure where a text is surely neither an item nor a blueprint.
pub(crate) fn not_of_authors(path: &Path, text: &str) -> Option<Failure> {
    let kind = FileKind::of(text.as_bytes()).filter(|kind| *kind != FileKind::Blueprint)?;
    let shown = path.display();
    let what = kind.words();
    let failure = Failure::new(format!("`{shown}` is {what}, not an item or a blueprint"));
    Some(failure.help("give files of items, chapters and blueprints, which end with `.toml`"))
}

/// A failure where a file of another kind, or the folder of a run, stands in the place of an item.
pub(crate) fn not_an_item(wanted: &str) -> Option<Failure> {
    let path = of_run(PathBuf::from(wanted));
    let shown = path.display();
    let kind = FileKind::of_file(&path)?;
    Some(Failure::new(format!("`{shown}` is {}, not an item", kind.words())).help(match kind {
        FileKind::Manifest => {
            format!("`vibank show CODE --manifest {shown}` shows the sheet of a code")
        }
        FileKind::Blueprint => format!(
            "`vibank show CODE --blueprint {shown}` shows the sheet of a code, `vibank preview {shown}` all of them"
        ),
        FileKind::Archive => {
            format!("`vibank show --learner ID {shown}` shows what a learner has in a package")
        }
        FileKind::Answers | FileKind::Table | FileKind::Page => {
            "`vibank list` shows all items".to_owned()
        }
    }))
}

/// The manifest in the folder of a run; any other path as it is.
fn of_run(path: PathBuf) -> PathBuf {
    let within = path.join("manifest.json");
    // Of a folder that may not be looked into, the reader says so.
    let is_missing = matches!(within.try_exists(), Ok(false));
    if path.is_dir() && !is_missing {
        within
    } else {
        path
    }
}

/// Reads the path of a manifest from the command line: of the folder of a run the manifest in it.
pub(crate) fn manifest() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().map(of_run)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_known_by_their_beginning() {
        let kind = |text: &str| FileKind::of(text.as_bytes());
        assert_eq!(
            kind("\u{feff}code;student;response\nABC;;\n"),
            Some(FileKind::Answers)
        );
        assert_eq!(kind("Student ID,Name\n1,A\n"), Some(FileKind::Table));
        assert_eq!(
            kind("# An exam\ntitle = \"Of 1, 2, 3\"\n[[question]]\nitem = \"a/b\"\n"),
            Some(FileKind::Blueprint)
        );
        assert_eq!(
            kind("{\"format\":1,\"program\":\"vibank\"}"),
            Some(FileKind::Manifest)
        );
        assert_eq!(kind("<!DOCTYPE html>\n<html>"), Some(FileKind::Page));
        assert_eq!(kind("PK\u{3}\u{4}"), Some(FileKind::Archive));
        assert_eq!(kind(""), None);
        assert_eq!(kind("[{\"code\":\"A\"}]"), None);
        assert_eq!(kind("title = 'A'\n"), None);
    }
}
