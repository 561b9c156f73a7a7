//! The items that sheets are marked with: those that the run kept, so that a bank may move on.

use std::collections::BTreeMap;

use vibank::bank::{Catalogue, ItemId, Revision, Template};

use crate::cli::Failure;

/// The items of a run.
pub(crate) struct Items<'c> {
    /// Those that manifests hold, one catalogue for each manifest.
    kept: Vec<Catalogue>,
    bank: &'c Catalogue,
    /// Whether those of the bank count where they are others.
    prefers_bank: bool,
}

impl<'c> Items<'c> {
    /// The items that manifests hold, by identity, and those of the bank.
    pub(crate) fn of(
        kept: &[BTreeMap<String, String>],
        bank: &'c Catalogue,
        prefers_bank: bool,
    ) -> Self {
        Self {
            kept: kept
                .iter()
                .map(|items| {
                    let paths: Vec<(String, &String)> = items
                        .iter()
                        .map(|(id, text)| (format!("{id}.toml"), text))
                        .collect();
                    let files = paths
                        .iter()
                        .map(|(path, text)| (path.as_str(), text.as_str()));
                    Catalogue::of_items(files)
                })
                .collect(),
            bank,
            prefers_bank,
        }
    }

    /// The item as it was handed out: its text has the revision that is stated, wherever it comes from.
    pub(crate) fn find(&self, id: &ItemId, revision: Revision) -> Result<&Template, Failure> {
        let bank = self.bank.find(id.as_str());
        if let Some(own) = bank.filter(|own| self.prefers_bank || own.revision == revision) {
            return Ok(own);
        }
        let mut kept = self.kept.iter().filter_map(|items| items.find(id.as_str()));
        if let Some(own) = kept.find(|own| own.revision == revision) {
            return Ok(own);
        }
        let now = bank.map_or_else(
            || "the bank has no such item".to_owned(),
            |own| format!("the bank has revision {}", own.revision),
        );
        Err(Failure::new(format!(
            "`{id}` has changed since the sheets were made: they have revision {revision}, {now}"
        ))
        .help("mark with the bank of that time (`--bank`), or add `--accept-revisions`"))
    }

    /// An item of this name, as it was handed out if that is known: for its title and the texts of its mistakes.
    pub(crate) fn named(&self, id: &str) -> Option<&Template> {
        let bank = self.bank.find(id);
        let mut kept = self.kept.iter().filter_map(|items| {
            // What the bank has as it was is at hand.
            let same = bank.filter(|own| items.revision(id) == Some(own.revision));
            same.or_else(|| items.find(id))
        });
        if self.prefers_bank {
            return bank.or_else(|| kept.next());
        }
        kept.next().or(bank)
    }

    /// Whether the bank has another text of an item; questions of a blueprint's own it never had.
    pub(crate) fn has_moved_on(&self, id: &ItemId, revision: Revision) -> bool {
        let bank = self.bank.find(id.as_str());
        bank.map_or(!id.is_own(), |own| own.revision != revision)
    }
}
