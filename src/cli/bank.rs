//! The bank that a command works on: the one that comes with the program, or a folder.

use std::path::{Path, PathBuf};

use rayon::prelude::*;
use vibank::bank::{Catalogue, ItemId, Listing, embedded};
use vibank::diagnostic::{Finding, Severity};
use vibank::source::{Problem, Source, Span};

use super::report::Reporter;
use super::{Failure, Outcome, files};

/// Which bank.
#[derive(clap::Args)]
pub(crate) struct BankArgument {
    /// A folder with a bank of your own, in place of the one that comes with the program.
    #[arg(long, value_name = "FOLDER")]
    bank: Option<PathBuf>,
}

impl BankArgument {
    /// The catalogue and all findings.
    fn load(&self) -> Result<(Catalogue, Vec<Finding>), Failure> {
        let (catalogue, mut findings) = self.open(&[])?;
        read_all(&catalogue);
        findings.append(&mut catalogue.findings());
        Finding::sort(&mut findings);
        Ok((catalogue, findings))
    }

    /// The catalogue, of which no item is read, and what is wrong with the other files. What a list shows of the bank that
    /// comes with the program is known without reading it.
    pub(crate) fn unread(&self) -> Result<(Catalogue, Vec<Finding>), Failure> {
        let (mut catalogue, findings) = self.open(&[])?;
        if self.bank.is_none() {
            catalogue.know(Listing::embedded());
        }
        Ok((catalogue, findings))
    }

    /// The catalogue with further files, each with its path inside the bank; one of a known path takes its place. No item
    /// is read.
    pub(crate) fn open(
        &self,
        further: &[(String, String)],
    ) -> Result<(Catalogue, Vec<Finding>), Failure> {
        let mut found = Found::default();
        if let Some(folder) = &self.bank {
            found.collect(folder, "")?;
        }
        let embedded = if self.bank.is_none() {
            embedded()
        } else {
            Vec::new()
        };
        let own = found
            .texts
            .iter()
            .map(|(path, text)| (path.as_str(), text.as_str()));
        let known: Vec<(&str, &str)> = embedded
            .into_iter()
            .chain(own)
            .filter(|(path, _)| further.iter().all(|(given, _)| given != path))
            .collect();
        let chapters: Vec<String> = further
            .iter()
            .filter_map(|(path, _)| Some(format!("{}/_chapter.toml", path.split_once('/')?.0)))
            .filter(|chapter| known.iter().all(|(path, _)| path != chapter))
            .collect();
        let chapters = chapters.iter().map(|path| (path.as_str(), CHAPTER));
        let further = further
            .iter()
            .map(|(path, text)| (path.as_str(), text.as_str()));
        let texts = known.into_iter().chain(chapters).chain(further);
        let (catalogue, mut findings) = Catalogue::open(texts);
        findings.append(&mut found.unreadable);
        Ok((catalogue, findings))
    }

    /// The catalogue, its items to be read when they are asked for. Those of a folder are read at once: errors in them are
    /// told in one line, since they hide items.
    pub(crate) fn catalogue(&self) -> Result<Catalogue, Failure> {
        if self.bank.is_none() {
            return Ok(self.open(&[])?.0);
        }
        let (catalogue, findings) = self.load()?;
        warn(errors(&findings));
        Ok(catalogue)
    }
}

/// How many findings are errors.
pub(crate) fn errors(findings: &[Finding]) -> usize {
    let errors = findings.iter();
    errors
        .filter(|finding| finding.severity == Severity::Error)
        .count()
}

/// Says in one line that a bank has errors, since they hide items.
pub(crate) fn warn(errors: usize) {
    if errors > 0 {
        eprintln!("warning: {errors} errors in the bank, `vibank check` shows them");
    }
}

/// Reads all items, on all cores.
pub(crate) fn read_all(catalogue: &Catalogue) {
    let ids: Vec<&ItemId> = catalogue.ids().collect();
    ids.par_iter().for_each(|id| {
        catalogue.find(id.as_str());
    });
}

/// What a list shows of the items that can be used, and the number of errors in all of them.
///
/// An item that is not known is read, looked at and dropped, so that a large bank takes no more memory than its rows.
pub(crate) fn listings(catalogue: &Catalogue) -> (Vec<Listing>, usize) {
    let ids: Vec<&ItemId> = catalogue.ids().collect();
    let looked = ids.par_iter().map(|id| match catalogue.listing(id) {
        Some(row) => (Some(row.clone()), 0),
        None => {
            let (item, findings) = catalogue.read_apart(id);
            (item.as_ref().map(Listing::of), errors(&findings))
        }
    });
    let looked: Vec<(Option<Listing>, usize)> = looked.collect();
    let errors = looked.iter().map(|(_, errors)| errors).sum();
    (
        looked.into_iter().filter_map(|(row, _)| row).collect(),
        errors,
    )
}

/// Stands in for the chapter of a file that is looked at by itself.
const CHAPTER: &str = "title = \"Files\"\nnumber = 99\n";

/// The TOML files of a folder.
#[derive(Default)]
struct Found {
    /// Each with its path inside the folder.
    texts: Vec<(String, String)>,
    /// Those that are no text; they do not hide the others.
    unreadable: Vec<Finding>,
}

impl Found {
    /// The TOML files below a folder that stands at `inside`; what is hidden is left out.
    fn collect(&mut self, folder: &Path, inside: &str) -> Result<(), Failure> {
        const MOST_FILES: usize = 10_000;
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot read `{}`: {error}", folder.display()))
        };
        let mut entries = std::fs::read_dir(folder)
            .map_err(fail)?
            .collect::<Result<Vec<_>, _>>()
            .map_err(fail)?;
        entries.sort_by_key(std::fs::DirEntry::file_name);
        for entry in entries {
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = if inside.is_empty() {
                name.clone()
            } else {
                format!("{inside}/{name}")
            };
            let kind = entry.file_type().map_err(fail)?;
            if kind.is_dir() && !name.starts_with('.') && path.matches('/').count() < 3 {
                self.collect(&entry.path(), &path)?;
            } else if kind.is_file() && name.ends_with(".toml") {
                self.add(path, files::read_bytes(&entry.path())?);
            }
            if self.texts.len() > MOST_FILES {
                return Err(Failure::new(format!(
                    "`{}` has more than {MOST_FILES} files",
                    folder.display()
                )));
            }
        }
        Ok(())
    }

    fn add(&mut self, path: String, bytes: Vec<u8>) {
        match String::from_utf8(bytes) {
            Ok(text) => self
                .texts
                .push((path, text.trim_start_matches('\u{feff}').to_owned())),
            Err(error) => self.unreadable.push(no_text(path, error.as_bytes())),
        }
    }
}

/// The finding about a file that is not UTF-8.
fn no_text(path: String, bytes: &[u8]) -> Finding {
    let text = String::from_utf8_lossy(bytes);
    let place = text.find('\u{fffd}').unwrap_or_default();
    let problem = Problem::Syntax {
        message: "these bytes are not UTF-8".to_owned(),
        span: Span::new(place, place + 3),
    };
    let mut finding = Finding::of(&problem, &Source::new(path, text.into_owned()));
    finding.help = Some("save the file as UTF-8".to_owned());
    finding
}

/// Prints findings of a file that cannot be used.
pub(crate) fn refuse(findings: &[Finding]) -> Result<Outcome, Failure> {
    print(findings);
    let count = findings.len();
    Err(Failure::new(format!(
        "{count} finding{}",
        if count == 1 { "" } else { "s" }
    )))
}

/// Prints findings to standard error.
pub(crate) fn print(findings: &[Finding]) {
    let reporter = Reporter::for_stderr();
    for finding in findings {
        eprintln!("{}\n", reporter.draw(finding));
    }
}
