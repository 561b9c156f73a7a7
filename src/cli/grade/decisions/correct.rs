//! Items with keys that were found to be wrong, as they are marked now.

use std::collections::{BTreeMap, BTreeSet};

use vibank::bank::{ItemId, Revision, Template};

use super::{Decisions, Effect};
use crate::cli::Failure;
use crate::cli::grade::items::Items;

/// Items with corrected keys, by identity and text.
pub(crate) type Corrected = BTreeMap<(ItemId, Revision), Template>;

/// The items that were handed out with keys that were corrected.
pub(crate) fn corrected(
    decisions: &Decisions,
    items: &Items<'_>,
    used: &BTreeSet<(ItemId, Revision)>,
) -> Result<Corrected, Failure> {
    let mut corrected = Corrected::new();
    for ((item, part), rules) in &decisions.rules {
        for (_, number) in rules {
            let decision = &decisions.all[*number];
            let Effect::Key(key) = &decision.effect else {
                continue;
            };
            for own in used.iter().filter(|(own, _)| own.as_str() == item) {
                let before = match corrected.get(own) {
                    Some(before) => before,
                    None => items.find(&own.0, own.1)?,
                };
                let template = before.with_key(part, key).map_err(|error| {
                    Failure::new(format!("{}: {error}", decision.place))
                        .help("write the key as the item file would, such as `key = \"sqrt(k/m)\"`")
                })?;
                corrected.insert(own.clone(), template);
            }
        }
    }
    Ok(corrected)
}
