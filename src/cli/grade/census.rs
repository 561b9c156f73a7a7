//! What a manifest holds, seen before anything is marked.

use std::collections::{BTreeMap, BTreeSet};

use vibank::bank::Catalogue;

use super::manifest::Sheets;
use super::tables::Column;
use crate::cli::Failure;

/// What a manifest holds.
pub(super) struct Census {
    pub(super) sheets: usize,
    /// All parts, in the order of the sheets.
    pub(super) columns: Vec<Column>,
    /// Items whose text is another one than when the sheets were made.
    pub(super) changed: Vec<String>,
}

impl Census {
    /// Looks through all sheets; changed items are refused unless they are accepted, all at once.
    pub(super) fn take(
        sheets: &mut Sheets,
        catalogue: &Catalogue,
        accepts: bool,
    ) -> Result<Self, Failure> {
        let mut census = Self {
            sheets: 0,
            columns: Vec::new(),
            changed: Vec::new(),
        };
        let mut columns = BTreeSet::new();
        let mut changed = BTreeMap::new();
        let mut codes = BTreeSet::new();
        loop {
            let chunk = sheets.chunk(super::CHUNK)?;
            if chunk.is_empty() {
                break;
            }
            census.sheets += chunk.len();
            for variant in &chunk {
                if !codes.insert(variant.code.clone()) {
                    let code = &variant.code;
                    let failure = Failure::new(format!("the manifest has the sheet {code} twice"));
                    return Err(failure.help("give the `manifest.json` as `vibank sheet` wrote it"));
                }
            }
            for question in chunk.iter().flat_map(|variant| &variant.questions) {
                for part in &question.parts {
                    columns.insert((question.number, part.letter.len(), part.letter.clone()));
                }
                let found = catalogue
                    .find(question.item.as_str())
                    .map(|item| item.revision);
                if found != Some(question.revision) {
                    let now = found.map_or_else(
                        || "no such item".to_owned(),
                        |own| format!("revision {own}"),
                    );
                    changed.insert(
                        question.item.to_string(),
                        format!("revision {}, the bank has {now}", question.revision),
                    );
                }
            }
        }
        census.columns = columns
            .into_iter()
            .map(|(question, _, letter)| (question, letter))
            .collect();
        census.changed = changed.keys().cloned().collect();
        if !changed.is_empty() && !accepts {
            let list: Vec<String> = changed
                .iter()
                .map(|(item, how)| format!("`{item}` ({how})"))
                .collect();
            return Err(Failure::new(format!(
                "items have changed since the sheets were made: {}",
                list.join(", ")
            ))
            .help("mark with the bank of that time (`--bank`), or add `--accept-revisions`"));
        }
        Ok(census)
    }
}
