//! Loading a bank from the texts of its files.

use super::catalogue::Catalogue;
use super::folder::{BankFile, Chapter};
use super::{ItemId, Revision, read};
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
    #[error("`{item}` builds on `{after}`, which is no item of this bank")]
    After {
        item: String,
        after: String,
        nearest: Option<String>,
        span: crate::source::Span,
    },
}

impl Catalogue {
    /// Reads the files of a bank, each with its path inside the bank; what is wrong is told, the rest serves.
    pub fn load<'f>(files: impl IntoIterator<Item = (&'f str, &'f str)>) -> (Self, Vec<Finding>) {
        let mut sources: Vec<Source> = files
            .into_iter()
            .map(|(path, text)| Source::new(path, text))
            .collect();
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
        catalogue.arrange(&mut findings);
        Finding::sort(&mut findings);
        (catalogue, findings)
    }

    fn add(&mut self, source: &Source, findings: &mut Vec<Finding>) {
        if let Some(folder) = source.path.strip_suffix("/_chapter.toml") {
            let (chapter, mut found) = Chapter::read(folder, source);
            findings.append(&mut found);
            self.chapters.push(chapter);
        } else if &*source.path != "bank.toml" {
            match ItemId::of_path(&source.path) {
                Some(id) => {
                    let problems = Problems::default();
                    let item = read::Item {
                        id,
                        revision: Revision::of(&source.text),
                        source,
                        tree: &toml::read(source, &problems),
                        topics: Some(&self.bank.topics),
                    };
                    let (template, mut found) = read::item(item, &problems, &mut read::Parsers);
                    findings.append(&mut found);
                    self.items.extend(template);
                }
                None => findings.push(Finding::of(
                    &FolderError::Path(source.path.to_string()),
                    source,
                )),
            }
        }
    }

    /// Sorts items by chapter and name, and looks up what they build on.
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
        self.items
            .sort_by_cached_key(|item| (place(&item.id), natural(item.id.as_str())));
        self.by_id = self
            .items
            .iter()
            .enumerate()
            .map(|(at, item)| (item.id.as_str().into(), at))
            .collect();
        for item in &self.items {
            if place(&item.id).is_none() {
                let error = FolderError::NoChapterFile(item.id.chapter().to_owned());
                findings.push(Finding::of(&error, &item.source));
            }
            for after in item
                .about
                .after
                .iter()
                .filter(|after| !self.by_id.contains_key(after.value.as_str()))
            {
                let nearest = self.nearest(&after.value).map(str::to_owned);
                let (item_id, id) = (item.id.to_string(), after.value.clone());
                let error = FolderError::After {
                    item: item_id,
                    after: id,
                    nearest,
                    span: after.span,
                };
                findings.push(Finding::of(&error, &item.source));
            }
        }
    }
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
