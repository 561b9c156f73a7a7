//! Items with keys that were found to be wrong, as they are marked now.

use std::collections::{BTreeMap, BTreeSet};

use vibank::bank::{ItemId, Revision, Template};
use vibank::source::Value;

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
    for own in used {
        let (mut keys, mut place) = (Vec::new(), "");
        for ((item, part), rules) in &decisions.rules {
            let all = rules.iter().map(|(_, number)| &decisions.all[*number]);
            let last = all.rev().find_map(|decision| match &decision.effect {
                Effect::Key(key) => Some((decision, key)),
                _ => None,
            });
            // The item is read again with all of them: one after the other would forget those before.
            if let Some((decision, key)) = last.filter(|_| own.0.as_str() == item) {
                keys.push((part.as_str(), key));
                place = &decision.place;
                check(own, &keys[keys.len() - 1..], place, items)?;
            }
        }
        if !keys.is_empty() {
            corrected.insert(own.clone(), check(own, &keys, place, items)?);
        }
    }
    Ok(corrected)
}

/// An item with these keys; that it cannot have them is said with the place of the last one.
fn check(
    own: &(ItemId, Revision),
    keys: &[(&str, &Value)],
    place: &str,
    items: &Items<'_>,
) -> Result<Template, Failure> {
    items.find(&own.0, own.1)?.with_keys(keys).map_err(|error| {
        Failure::new(format!("{place}: {error}"))
            .help("write the key as the item file would, such as `key = \"sqrt(k/m)\"`")
    })
}
