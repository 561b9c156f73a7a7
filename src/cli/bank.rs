//! The bank that a command works on: the one that comes with the program, or a folder.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;
use vibank::bank::{Catalogue, ItemId, Listing, Open, embedded};
use vibank::diagnostic::{Finding, Severity};
use vibank::source::{Problem, Source, Span};
use vibank::worksheet::Blueprint;

use super::index::{Index, Stamp};
use super::report::Reporter;
use super::{Failure, Outcome, counted, file_kind, files};

/// The options that select the bank a command works on.
#[derive(clap::Args, Default)]
pub(crate) struct BankArgument {
    /// A folder with a bank of your own, in place of the one that comes with the program.
    #[arg(long, value_name = "FOLDER")]
    bank: Option<PathBuf>,
    /// Read all items of the folder anew, and keep no index of it.
    #[arg(long, requires = "bank")]
    no_index: bool,
}

impl BankArgument {
    /// The catalogue, without reading items anew that the index knows, and what is wrong with the other files. What a
    /// list shows is known of the bank that comes with the program, and of a folder by its index.
    pub(crate) fn unread(&self) -> Result<(Catalogue, Vec<Finding>), Failure> {
        let found = self.found()?;
        let (mut catalogue, findings) = open(&found, &[]);
        if self.bank.is_none() {
            catalogue.know(Listing::embedded());
        } else if let Some(mut index) = self.index(&found) {
            look(&catalogue, &found, &mut index);
            catalogue.know(index.listings(&found.items));
            index.save(&found.items);
        }
        Ok((catalogue, findings))
    }

    /// The catalogue with further files, each with its path inside the bank; one of a known path takes its place. No item
    /// is read.
    pub(crate) fn open(
        &self,
        further: &[(String, String)],
    ) -> Result<(Catalogue, Vec<Finding>), Failure> {
        Ok(open(&self.found()?, further))
    }

    /// The catalogue, its items to be read when they are asked for. Errors in a folder are reported in one line, since they
    /// hide items: those that its index does not know are read for it.
    pub(crate) fn catalogue(&self) -> Result<Catalogue, Failure> {
        let found = self.found()?;
        let (catalogue, mut findings) = open(&found, &[]);
        if self.bank.is_none() {
            return Ok(catalogue);
        }
        if let Some(mut index) = self.index(&found) {
            let further = look(&catalogue, &found, &mut index);
            index.save(&found.items);
            warn(errors(&findings) + further);
        } else {
            read_all(&catalogue);
            findings.append(&mut catalogue.findings());
            warn(errors(&findings));
        }
        Ok(catalogue)
    }

    /// The same with the questions of a blueprint's own, where one is given.
    pub(crate) fn catalogue_with(&self, blueprint: Option<&Path>) -> Result<Catalogue, Failure> {
        let Some(path) = blueprint else {
            return self.catalogue();
        };
        let source = file_kind::blueprint(path)?;
        let blueprint = match Blueprint::read(&source) {
            Ok(blueprint) => blueprint,
            Err(findings) => return Err(refusal(&findings)),
        };
        let own = blueprint.own_questions().map(|own| {
            let path = format!("{}.toml", own.item.id);
            (path, own.item.source.text.to_string())
        });
        let (catalogue, findings) = self.open(&own.collect::<Vec<_>>())?;
        warn(errors(&findings));
        Ok(catalogue)
    }

    /// What of its files to look at for changes: all of them and their folders; none for the bank of the program.
    pub(crate) fn watched(&self) -> Vec<PathBuf> {
        let (Some(folder), Ok(found)) = (&self.bank, self.found()) else {
            return self.bank.iter().cloned().collect();
        };
        let items = found.items.iter().map(|(id, _)| format!("{id}.toml"));
        let others = found.texts.iter().map(|(path, _)| path.clone());
        let mut all: Vec<PathBuf> = items.chain(others).map(|path| folder.join(path)).collect();
        let folders: BTreeSet<PathBuf> = all
            .iter()
            .filter_map(|file| file.parent().map(Path::to_owned))
            .collect();
        all.push(folder.clone());
        all.extend(folders);
        all
    }

    /// Names the bank in the commands that the help of findings gives, so that they can be pasted and run.
    pub(crate) fn name_in_help(&self, findings: &mut [Finding]) {
        let Some(folder) = &self.bank else { return };
        let folder = folder.display().to_string();
        let folder = if folder
            .chars()
            .all(|sign| sign.is_alphanumeric() || "/\\._-:".contains(sign))
        {
            folder
        } else {
            format!("'{folder}'")
        };
        for help in findings
            .iter_mut()
            .filter_map(|finding| finding.help.as_mut())
        {
            for command in ["`vibank solve ", "`vibank mark "] {
                *help = help.replace(command, &format!("{command}--bank {folder} "));
            }
        }
    }

    fn found(&self) -> Result<BankFiles, Failure> {
        let mut found = BankFiles::default();
        match &self.bank {
            Some(folder) => {
                found.folder.clone_from(folder);
                found.collect(folder, "")?;
            }
            None => {
                let files = embedded().into_iter();
                found.texts = files
                    .map(|(path, text)| (path.to_owned(), Cow::Borrowed(text)))
                    .collect();
            }
        }
        Ok(found)
    }

    fn index(&self, found: &BankFiles) -> Option<Index> {
        let bank = found.texts.iter().find(|(path, _)| path == "bank.toml");
        (!self.no_index)
            .then(|| Index::of(&found.folder, bank.map_or("", |(_, text)| text)))
            .flatten()
    }
}

/// The catalogue of what was found, with further files.
fn open(found: &BankFiles, further: &[(String, String)]) -> (Catalogue, Vec<Finding>) {
    let is_given = |path: &str| further.iter().any(|(given, _)| given == path);
    let texts = found.texts.iter();
    let known: Vec<(&str, &str)> = texts
        .map(|(path, text)| (path.as_str(), text.as_ref()))
        .filter(|(path, _)| !is_given(path))
        .collect();
    let chapters: Vec<String> = further
        .iter()
        .filter_map(|(path, _)| Some(format!("{}/_chapter.toml", path.split_once('/')?.0)))
        .filter(|chapter| known.iter().all(|(path, _)| path != chapter))
        .collect();
    let chapters = chapters.iter().map(|path| (path.as_str(), CHAPTER));
    let given = further.iter();
    let given = given.map(|(path, text)| (path.as_str(), text.as_str()));
    let texts = known.into_iter().chain(chapters).chain(given);
    let items = found.items.iter().map(|(id, _)| id);
    let items = items.filter(|id| further.is_empty() || !is_given(&format!("{id}.toml")));
    let folder = found.folder.clone();
    let opened: Arc<Open> = Arc::new(move |path: &str| text(&folder.join(path), path));
    let (catalogue, mut findings) = Catalogue::open_beside(texts, items.cloned(), &opened);
    findings.extend(found.unreadable.iter().cloned());
    (catalogue, findings)
}

/// Reads the items of a folder that its index does not know, on all cores, and notes them; how many errors they have.
fn look(catalogue: &Catalogue, found: &BankFiles, index: &mut Index) -> usize {
    let unknown = found.items.iter();
    let unknown: Vec<&ItemId> = unknown
        .filter(|(id, stamp)| !index.knows(id, stamp))
        .map(|(id, _)| id)
        .collect();
    let looked = unknown.par_iter().map(|id| {
        let (item, findings) = catalogue.read_apart(id);
        (item.as_ref().map(Listing::of), errors(&findings))
    });
    let looked: Vec<(Option<Listing>, usize)> = looked.collect();
    for (listing, errors) in &looked {
        if let (Some(listing), 0) = (listing, errors) {
            index.note(listing);
        }
    }
    looked.iter().map(|(_, errors)| errors).sum()
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
        let stated = counted(errors, "error");
        let shown = if errors == 1 { "it" } else { "them" };
        eprintln!("warning: {stated} in the bank, `vibank check` shows {shown}");
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
struct BankFiles {
    folder: PathBuf,
    /// What is no item, each with its path inside the folder; of the bank that comes with the program, everything.
    texts: Vec<(String, Cow<'static, str>)>,
    /// Items, which are not opened yet.
    items: Vec<(ItemId, Stamp)>,
    /// What is no text; it does not hide the others.
    unreadable: Vec<Finding>,
}

impl BankFiles {
    /// The TOML files below a folder that stands at `inside`; what is hidden is left out.
    fn collect(&mut self, folder: &Path, inside: &str) -> Result<(), Failure> {
        // Each takes some hundred bytes of memory.
        const MAX_FILES: usize = 100_000;
        let mut entries = std::fs::read_dir(folder)
            .map_err(files::unreadable(folder))?
            .collect::<Result<Vec<_>, _>>()
            .map_err(files::unreadable(folder))?;
        entries.sort_by_cached_key(std::fs::DirEntry::file_name);
        for entry in entries {
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = if inside.is_empty() {
                name.clone()
            } else {
                format!("{inside}/{name}")
            };
            let kind = entry.file_type().map_err(files::unreadable(folder))?;
            if kind.is_dir() && !name.starts_with('.') && path.matches('/').count() < 3 {
                self.collect(&entry.path(), &path)?;
            } else if kind.is_file() && name.ends_with(".toml") {
                match ItemId::of_path(&path) {
                    // A file that is gone by now is missed when it is opened.
                    Some(id) => self.items.push((
                        id,
                        entry
                            .metadata()
                            .map_or_else(|_| Stamp::default(), |metadata| Stamp::of(&metadata)),
                    )),
                    None => match text(&entry.path(), &path) {
                        Ok(text) => self.texts.push((path, text.into())),
                        Err(finding) => self.unreadable.push(*finding),
                    },
                }
            }
            if self.texts.len() + self.items.len() > MAX_FILES {
                return Err(Failure::new(format!(
                    "`{}` has more than {MAX_FILES} files",
                    folder.display()
                )));
            }
        }
        Ok(())
    }
}

/// The text of a file of a bank, which has a path inside it.
fn text(file: &Path, path: &str) -> Result<String, Box<Finding>> {
    let bytes = files::read_bytes(file).map_err(|failure| {
        let problem = Problem::Syntax {
            message: failure.to_string(),
            span: Span::NONE,
        };
        Box::new(Finding::of(&problem, &Source::new(path, "")))
    })?;
    match String::from_utf8(bytes) {
        Ok(text) => Ok(text.trim_start_matches('\u{feff}').to_owned()),
        Err(error) => Err(Box::new(no_text(path.to_owned(), error.as_bytes()))),
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
    Err(refusal(findings))
}

/// The failure after findings that are printed.
fn refusal(findings: &[Finding]) -> Failure {
    print(findings);
    let count = findings.len();
    Failure::new(format!(
        "{count} finding{}",
        if count == 1 { "" } else { "s" }
    ))
}

/// Prints findings to standard error.
pub(crate) fn print(findings: &[Finding]) {
    let reporter = Reporter::for_stderr();
    for finding in findings {
        // With the colours of the reporter, which shows nothing of the file that would steer the terminal.
        let _ = writeln!(io::stderr().lock(), "{}\n", reporter.draw(finding));
    }
}
