//! The catalogue: all items of a bank that can be used.

use std::collections::BTreeMap;
use std::sync::Arc;

use sha2::{Digest, Sha256};

use super::Template;
use super::folder::{BankFile, Chapter};
use crate::source::nearest;

/// All items of a bank that can be used.
#[derive(Debug, Default)]
pub struct Catalogue {
    /// What the bank says of itself.
    pub bank: BankFile,
    /// Its chapters by number.
    pub chapters: Vec<Chapter>,
    pub(super) items: Vec<Template>,
    pub(super) by_id: BTreeMap<Arc<str>, usize>,
}

impl Catalogue {
    /// The items, by chapter and name.
    pub fn items(&self) -> &[Template] {
        &self.items
    }

    /// The item of this identity.
    pub fn find(&self, id: &str) -> Option<&Template> {
        self.by_id.get(id).map(|at| &self.items[*at])
    }

    /// The identity that is nearest to a mistyped one; the slug alone is enough.
    pub fn nearest(&self, id: &str) -> Option<&str> {
        let ids = || self.items.iter().map(|item| item.id.as_str());
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
        for item in &self.items {
            hash.update(format!("{} {}\n", item.id, item.revision));
        }
        hash.finalize()
            .iter()
            .take(8)
            .map(|byte| format!("{byte:02x}"))
            .collect()
    }
}
