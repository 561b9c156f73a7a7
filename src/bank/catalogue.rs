//! The catalogue: all items of a bank.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Arc, OnceLock};

use sha2::{Digest, Sha256};

use super::folder::{BankFile, Chapter};
#[cfg(feature = "render")]
use super::load::read;
use super::{ItemId, Revision, Template};
use crate::diagnostic::Finding;
use crate::source::{Source, nearest};

/// All items of a bank; a file is read when somebody asks for its item.
#[derive(Debug, Default)]
pub struct Catalogue {
    /// What the bank says of itself.
    pub bank: BankFile,
    /// Its chapters by number.
    pub chapters: Vec<Chapter>,
    pub(crate) entries: Vec<CatalogueEntry>,
    pub(crate) by_id: BTreeMap<Arc<str>, usize>,
    /// Whether its items were taken out of their bank, so that nobody knows its topics.
    pub(crate) is_loose: bool,
    /// What a list shows of items, where it was made out before.
    #[cfg(feature = "render")]
    pub(crate) listings: BTreeMap<ItemId, super::Listing>,
}

/// The file of an item, and what came of reading it.
#[derive(Debug)]
pub(crate) struct CatalogueEntry {
    pub(crate) id: ItemId,
    pub(crate) file: File,
    /// Made out when it is asked for: a digest of all items takes longer than reading one.
    pub(crate) revision: OnceLock<Revision>,
    reading: OnceLock<Reading>,
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
pub(crate) struct Reading {
    /// None where something is wrong with it.
    pub(crate) template: Option<Template>,
    pub(crate) findings: Vec<Finding>,
}

#[cfg(feature = "render")]
impl CatalogueEntry {
    pub(crate) fn new(id: ItemId, file: File) -> Self {
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
    pub(crate) fn revision(&self) -> Revision {
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
    pub(crate) fn named(&self) -> Source {
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
    pub(crate) fn item_findings(&self, wants: impl Fn(&ItemId) -> bool) -> Vec<Finding> {
        let wanted = self.entries.iter().filter(|entry| wants(&entry.id));
        let findings = wanted.flat_map(|entry| &self.reading(entry).findings);
        findings.cloned().collect()
    }

    fn reading<'c>(&'c self, entry: &'c CatalogueEntry) -> &'c Reading {
        entry
            .reading
            .get_or_init(|| read(entry, (!self.is_loose).then_some(&self.bank)))
    }

    /// The identity that is nearest to a mistyped one; the slug alone is enough.
    pub fn nearest(&self, id: &str) -> Option<&str> {
        let ids = || self.ids().map(ItemId::as_str);
        let by_slug = ids().find(|known| {
            known
                .split_once('/')
                .is_some_and(|(_, slug)| slug == id || slug.starts_with(id))
        });
        by_slug.or_else(|| nearest(id, ids()))
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
fn read(_: &CatalogueEntry, _: Option<&BankFile>) -> Reading {
    Reading::default()
}
