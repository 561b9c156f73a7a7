//! A bank from the texts of its files.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::catalogue::{Catalogue, CatalogueEntry, File, Open, Reading};
use super::folder::{BankFile, Chapter};
use super::{ItemId, Revision, Template, bounds, own, read};
use crate::diagnostic::{Code, Diagnose, Finding, Label, Severity};
use crate::source::{Problems, Source, toml};

/// What is wrong with the folder of a bank.
#[derive(Debug, thiserror::Error)]
enum FolderError {
    #[error("the bank has no `bank.toml`")]
    NoBankFile,
    #[error("the chapter `{0}` has no `_chapter.toml`")]
    NoChapterFile(String),
    #[error("`{0}` cannot be the name of an item")]
    Path(String),
    #[error("`{item}` builds on `{after}`, which is not an item of this bank")]
    After {
        item: String,
        after: String,
        nearest: Option<String>,
        span: crate::source::Span,
    },
}

impl Catalogue {
    /// Opens a bank and reads all its items; what is wrong is reported, the rest serves.
    pub fn load<'f>(files: impl IntoIterator<Item = (&'f str, &'f str)>) -> (Self, Vec<Finding>) {
        let (catalogue, mut findings) = Self::open(files);
        findings.append(&mut catalogue.findings());
        Finding::sort(&mut findings);
        (catalogue, findings)
    }

    /// Takes the files of a bank, each with its path inside the bank, and reads those that are not items.
    pub fn open<'f>(files: impl IntoIterator<Item = (&'f str, &'f str)>) -> (Self, Vec<Finding>) {
        Self::open_beside(
            files,
            [],
            &(Arc::new(|_: &str| Ok(String::new())) as Arc<Open>),
        )
    }

    /// The same beside items whose files, at these paths inside the bank, are not opened before somebody asks for them,
    /// and anew each time.
    pub fn open_beside<'f>(
        files: impl IntoIterator<Item = (&'f str, &'f str)>,
        unopened: impl IntoIterator<Item = ItemId>,
        open: &Arc<Open>,
    ) -> (Self, Vec<Finding>) {
        let mut sources: Vec<Source> = files
            .into_iter()
            .map(|(path, text)| Source::new(path, text))
            .collect();
        // Findings come in the same order, whatever the one in which a disk lists its files.
        sources.sort_by(|a, b| a.path.cmp(&b.path));
        let mut findings = Vec::new();
        let mut catalogue = Self::default();
        match sources.iter().find(|source| &*source.path == "bank.toml") {
            Some(source) => {
                let (bank, mut found) = BankFile::read(source);
                findings.append(&mut found);
                catalogue.bank = bank;
            }
            None => findings.push(Finding::of(
                &FolderError::NoBankFile,
                &Source::new("bank.toml", ""),
            )),
        }
        for source in &sources {
            catalogue.add(source, &mut findings);
        }
        let unopened = unopened.into_iter().map(|id| {
            let path = format!("{id}.toml").into();
            let open = Arc::clone(open);
            CatalogueEntry::new(id, File::Unopened { path, open })
        });
        catalogue.entries.extend(unopened);
        catalogue.arrange(&mut findings);
        Finding::sort(&mut findings);
        (catalogue, findings)
    }

    /// Items that were taken out of their bank: files without `bank.toml` and chapters, each with its path inside the
    /// bank. A run keeps those that it used.
    pub fn of_items<'f>(files: impl IntoIterator<Item = (&'f str, &'f str)>) -> Self {
        let (catalogue, _) = Self::open(files);
        Self {
            is_loose: true,
            ..catalogue
        }
    }

    /// What is wrong with the items, all of which are read for it.
    pub fn findings(&self) -> Vec<Finding> {
        self.findings_among(|_| true)
    }

    /// What is wrong with these items; no others are read.
    pub fn findings_among(&self, wants: impl Fn(&ItemId) -> bool) -> Vec<Finding> {
        let mut findings = self.item_findings(&wants);
        for item in self.items_among(&wants) {
            for after in item
                .about
                .after
                .iter()
                .filter(|after| !self.has(&after.value))
            {
                let error = FolderError::After {
                    item: item.id.to_string(),
                    after: after.value.clone(),
                    nearest: self.nearest(&after.value).map(str::to_owned),
                    span: after.span,
                };
                findings.push(Finding::of(&error, &item.source));
            }
        }
        Finding::sort(&mut findings);
        findings
    }

    fn add(&mut self, source: &Source, findings: &mut Vec<Finding>) {
        if let Some(folder) = source.path.strip_suffix("/_chapter.toml") {
            let (chapter, mut found) = Chapter::read(folder, source);
            findings.append(&mut found);
            self.chapters.push(chapter);
        } else if &*source.path != "bank.toml" {
            match ItemId::of_path(&source.path) {
                Some(id) => self
                    .entries
                    .push(CatalogueEntry::new(id, File::Text(source.clone()))),
                None => findings.push(Finding::of(
                    &FolderError::Path(source.path.to_string()),
                    source,
                )),
            }
        }
    }

    /// Sorts items by chapter and name.
    fn arrange(&mut self, findings: &mut Vec<Finding>) {
        self.chapters.sort_by(|a, b| {
            a.number
                .cmp(&b.number)
                .then_with(|| a.folder.cmp(&b.folder))
        });
        let place = |id: &ItemId| {
            self.chapters
                .iter()
                .position(|chapter| chapter.folder == id.chapter())
        };
        self.entries
            .sort_by_cached_key(|entry| (place(&entry.id), natural(entry.id.as_str())));
        self.by_id = self
            .entries
            .iter()
            .enumerate()
            .map(|(at, entry)| (entry.id.as_str().into(), at))
            .collect();
        for entry in self
            .entries
            .iter()
            .filter(|entry| place(&entry.id).is_none())
        {
            let error = FolderError::NoChapterFile(entry.id.chapter().to_owned());
            findings.push(Finding::of(&error, &entry.file.named()));
        }
    }
}

/// Reads the file of an item.
pub(crate) fn read(entry: &CatalogueEntry, bank: Option<&BankFile>) -> Reading {
    let source = match entry.file.source() {
        Ok(source) => source,
        Err(finding) => {
            return Reading {
                template: None,
                findings: vec![*finding],
            };
        }
    };
    // That of the text which is read: the file may be another by the time somebody asks for it.
    let revision = *entry.revision.get_or_init(|| Revision::of(&source.text));
    let topics = bank.map(|bank| &bank.topics);
    let (template, findings) = read_text(entry.id.clone(), revision, &source, topics);
    Reading { template, findings }
}

/// Reads the text of an item, or of a question of a blueprint.
pub(crate) fn read_text(
    id: ItemId,
    revision: Revision,
    source: &Source,
    topics: Option<&BTreeMap<String, String>>,
) -> (Option<Template>, Vec<Finding>) {
    let found = source.text.len();
    if found > bounds::MAX_FILE {
        return (
            None,
            vec![Finding::of(&bounds::Excess::File { found }, source)],
        );
    }
    let problems = Problems::default();
    let item = read::Item {
        id,
        revision,
        source,
        tree: &own::in_form(toml::read(source, &problems)),
        topics,
    };
    read::item(item, &problems, &mut read::Parsers)
}

/// A key under which `p10` comes after `p9`.
fn natural(text: &str) -> Vec<(u64, String)> {
    let mut key = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let word = rest
            .find(|letter: char| letter.is_ascii_digit())
            .unwrap_or(rest.len());
        let (letters, tail) = rest.split_at(word);
        let digits = tail
            .find(|letter: char| !letter.is_ascii_digit())
            .unwrap_or(tail.len());
        key.push((0, letters.to_owned()));
        key.push((tail[..digits].parse().unwrap_or(u64::MAX), String::new()));
        rest = &tail[digits..];
    }
    key
}

impl Diagnose for FolderError {
    fn code(&self) -> Code {
        Code::FOLDER
    }

    fn severity(&self) -> Severity {
        match self {
            Self::NoBankFile | Self::Path(_) => Severity::Error,
            Self::NoChapterFile(_) | Self::After { .. } => Severity::Warning,
        }
    }

    fn labels(&self) -> Vec<Label> {
        match self {
            Self::After { span, .. } => vec![Label {
                span: *span,
                text: String::new(),
            }],
            _ => Vec::new(),
        }
    }

    fn help(&self) -> Option<String> {
        match self {
            Self::NoBankFile => Some("add one with `format = 1` and a `title`".to_owned()),
            Self::NoChapterFile(_) => Some("add one with a `title` and a `number`".to_owned()),
            Self::Path(_) => {
                Some("name it `chapter/slug.toml` in small letters, digits and hyphens".to_owned())
            }
            Self::After { nearest, .. } => nearest
                .as_ref()
                .map(|near| format!("did you mean `{near}`?")),
        }
    }
}
