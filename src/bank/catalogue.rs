//! The catalogue: all items of a bank.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, OnceLock};

use sha2::{Digest, Sha256};

use super::folder::{BankFile, Chapter};
use super::{ItemId, Revision, Template};
#[cfg(feature = "render")]
use super::{Listing, folder::FolderError, load::read};
use crate::diagnostic::Finding;
use crate::source::{Source, nearest};

/// All items of a bank; a file is read when somebody asks for its item.
#[derive(Debug, Default)]
pub struct Catalogue {
    /// What the bank says of itself.
    pub bank: BankFile,
    /// Its chapters by number.
    pub chapters: Vec<Chapter>,
    entries: Vec<CatalogueEntry>,
    by_id: BTreeMap<Arc<str>, usize>,
    /// Whether its items were taken out of their bank, so that nobody knows its topics.
    is_loose: bool,
    /// What a list shows of items, where it was made out before.
    #[cfg(feature = "render")]
    listings: BTreeMap<ItemId, Listing>,
}

/// The file of an item, and what came of reading it.
#[derive(Debug)]
pub(crate) struct CatalogueEntry {
    pub(crate) id: ItemId,
    pub(crate) file: File,
    /// Made out when it is asked for: a digest of all items takes longer than reading one.
    pub(crate) revision: OnceLock<Revision>,
    reading: OnceLock<ItemReading>,
}

/// Where the text of an item is.
#[cfg_attr(
    not(feature = "render"),
    expect(dead_code, reason = "files belong to the command line")
)]
pub(crate) enum File {
    /// At hand.
    Text(Source),
    /// In a file that is opened when its item is asked for.
    Unopened { path: Arc<str>, open: Arc<Open> },
}

/// Opens the file at a path inside the bank: its text, or why there is none.
pub type Open = dyn Fn(&str) -> Result<String, Box<Finding>> + Send + Sync;

#[derive(Debug, Default)]
pub(crate) struct ItemReading {
    /// None where something is wrong with it.
    pub(crate) template: Option<Template>,
    pub(crate) findings: Vec<Finding>,
}

#[cfg(feature = "render")]
impl CatalogueEntry {
    fn new(id: ItemId, file: File) -> Self {
        Self {
            id,
            file,
            revision: OnceLock::new(),
            reading: OnceLock::new(),
        }
    }
}

impl CatalogueEntry {
    /// The revision of its text; one that cannot be read has that of no text.
    fn revision(&self) -> Revision {
        *self.revision.get_or_init(|| {
            let source = self.file.source();
            Revision::of(source.as_ref().map_or("", |source| &source.text))
        })
    }
}

impl File {
    /// Its text; a file is opened each time.
    pub(crate) fn source(&self) -> Result<Source, Box<Finding>> {
        match self {
            Self::Text(source) => Ok(source.clone()),
            Self::Unopened { path, open } => Ok(Source::new(Arc::clone(path), open(path)?)),
        }
    }

    /// The file, for a finding that says nothing of its text.
    #[cfg(feature = "render")]
    fn named(&self) -> Source {
        match self {
            Self::Text(source) => source.clone(),
            Self::Unopened { path, .. } => Source::new(Arc::clone(path), ""),
        }
    }
}

impl fmt::Debug for File {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Text(Source { path, .. }) | Self::Unopened { path, .. }) = self;
        formatter.write_str(path)
    }
}

#[cfg(feature = "render")]
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

    /// Takes rows of a list that was made before, so that these items need not be read for one. A row of another revision
    /// than that of the item does not count.
    pub fn know(&mut self, rows: impl IntoIterator<Item = Listing>) {
        self.listings
            .extend(rows.into_iter().map(|row| (row.id.clone(), row)));
    }

    /// What a list shows of an item whose row is known; another one has to be read for it. No file is opened for that: a row
    /// counts until its item is read and turns out to have another text.
    pub fn listing(&self, id: &ItemId) -> Option<&Listing> {
        let row = self.listings.get(id)?;
        let entry = &self.entries[*self.by_id.get(id.as_str())?];
        let revision = match entry.file {
            File::Text(_) => Some(entry.revision()),
            File::Unopened { .. } => entry.revision.get().copied(),
        };
        revision
            .is_none_or(|revision| revision == row.revision)
            .then_some(row)
    }
}

impl Catalogue {
    /// The identities of all items, also of those that cannot be used, by chapter and name.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = &ItemId> {
        self.entries.iter().map(|entry| &entry.id)
    }

    /// The items that can be used, by chapter and name.
    pub fn items(&self) -> impl Iterator<Item = &Template> {
        self.entries
            .iter()
            .filter_map(|entry| self.reading(entry).template.as_ref())
    }

    /// The item of this identity.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::bank::{Catalogue, embedded};
    ///
    /// // No other item is read.
    /// let (catalogue, _) = Catalogue::open(embedded());
    /// let item = catalogue.find("ch3/e5-log-decrement").unwrap();
    /// assert!(item.part("T_p").is_some());
    /// # }
    /// ```
    pub fn find(&self, id: &str) -> Option<&Template> {
        let entry = &self.entries[*self.by_id.get(id)?];
        self.reading(entry).template.as_ref()
    }

    /// The items of these identities that can be used; no other is read.
    pub fn items_among(&self, wants: impl Fn(&ItemId) -> bool) -> impl Iterator<Item = &Template> {
        let wanted = self.entries.iter().filter(move |entry| wants(&entry.id));
        wanted.filter_map(|entry| self.reading(entry).template.as_ref())
    }

    /// The revision of an item, which is not read for it.
    pub fn revision(&self, id: &str) -> Option<Revision> {
        let entry = &self.entries[*self.by_id.get(id)?];
        Some(entry.revision())
    }

    /// Whether the bank has an item of this identity; where [`find`](Self::find) has none, its file has findings.
    pub fn has(&self, id: &str) -> bool {
        self.by_id.contains_key(id)
    }

    /// Reads an item and keeps nothing of it, for who looks at one item of a large bank after the other: its template,
    /// if it can be used, and what is wrong with its file.
    pub fn read_apart(&self, id: &ItemId) -> (Option<Template>, Vec<Finding>) {
        let place = self.by_id.get(id.as_str());
        let reading = place.map(|place| read(&self.entries[*place], Some(&self.bank)));
        let reading = reading.unwrap_or_default();
        (reading.template, reading.findings)
    }

    /// What is wrong with the files of these items.
    #[cfg(feature = "render")]
    fn item_findings(&self, wants: impl Fn(&ItemId) -> bool) -> Vec<Finding> {
        let wanted = self.entries.iter().filter(|entry| wants(&entry.id));
        let findings = wanted.flat_map(|entry| &self.reading(entry).findings);
        findings.cloned().collect()
    }

    fn reading<'c>(&'c self, entry: &'c CatalogueEntry) -> &'c ItemReading {
        entry
            .reading
            .get_or_init(|| read(entry, (!self.is_loose).then_some(&self.bank)))
    }

    /// The identity that is nearest to a mistyped one; its beginning is enough, with the chapter or without it.
    pub fn nearest(&self, id: &str) -> Option<&str> {
        let mut ids = self.ids().map(ItemId::as_str);
        let begins = |known: &str| {
            let slug = known.split_once('/').map_or(known, |(_, slug)| slug);
            known.starts_with(id) || slug.starts_with(id)
        };
        let begun = ids.find(|known| !id.is_empty() && begins(known));
        begun.or_else(|| nearest(id, self.ids().map(ItemId::as_str)))
    }

    /// A digest over the identities and revisions of all items.
    pub fn digest(&self) -> String {
        let mut hash = Sha256::new();
        for entry in &self.entries {
            hash.update(format!("{} {}\n", entry.id, entry.revision()));
        }
        hash.finalize()
            .iter()
            .take(8)
            .map(|byte| format!("{byte:02x}"))
            .collect()
    }
}

/// Without the readers of texts no catalogue has an entry.
#[cfg(not(feature = "render"))]
fn read(_: &CatalogueEntry, _: Option<&BankFile>) -> ItemReading {
    ItemReading::default()
}

/// A key under which `p10` comes after `p9`.
#[cfg(feature = "render")]
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
