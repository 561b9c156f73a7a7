//! Items from the texts of their files.

use std::collections::BTreeMap;

use super::catalogue::{CatalogueEntry, ItemReading};
use super::folder::BankFile;
use super::{ItemId, Revision, Template, bounds, own, read};
use crate::diagnostic::Finding;
use crate::source::{Problems, Source, toml};

/// Reads the file of an item.
pub(crate) fn read(entry: &CatalogueEntry, bank: Option<&BankFile>) -> ItemReading {
    let source = match entry.file.source() {
        Ok(source) => source,
        Err(finding) => {
            return ItemReading {
                template: None,
                findings: vec![*finding],
            };
        }
    };
    // That of the text which is read: the file may be another by the time somebody asks for it.
    let revision = *entry.revision.get_or_init(|| Revision::of(&source.text));
    let topics = bank.map(|bank| &bank.topics);
    let (template, findings) = read_text(entry.id.clone(), revision, &source, topics);
    ItemReading { template, findings }
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
