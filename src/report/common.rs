//! What occurs most often, counted in bounded memory.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::bank::{Part, Passage};
use crate::message::Language;

/// Something that occurred so often.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Common {
    /// What it was.
    pub what: String,
    /// How often.
    pub count: u64,
}

/// A mistake that has a name.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CommonMistake {
    /// The code of the reason.
    pub code: String,
    /// The sentence or the tag of the mistake.
    pub what: String,
    /// How often.
    pub count: u64,
}

/// Counts; of things that first occur when the list is full nothing is kept.
#[derive(Clone, Debug, Default)]
pub(crate) struct Counts(BTreeMap<String, u64>);

/// Different things that are counted.
const MAX_COUNT: usize = 1000;

impl Counts {
    pub(crate) fn add(&mut self, what: &str) {
        if let Some(count) = self.0.get_mut(what) {
            *count += 1;
        } else if self.0.len() < MAX_COUNT {
            self.0.insert(what.to_owned(), 1);
        }
    }

    /// The commonest that occurred at least so often, at most this many; ties in the order of their names.
    pub(crate) fn commonest(&self, least: u64, most: usize) -> Vec<Common> {
        let often = self.0.iter().filter(|(_, count)| **count >= least);
        let mut all: Vec<Common> = often
            .map(|(what, count)| Common {
                what: what.clone(),
                count: *count,
            })
            .collect();
        all.sort_by(|a, b| b.count.cmp(&a.count).then_with(|| a.what.cmp(&b.what)));
        all.truncate(most);
        all
    }
}

impl CommonMistake {
    /// A mistake of a part: one that its item names, or a slip that marking names.
    pub(crate) fn of(common: Common, part: Option<&Part>) -> Self {
        let number = common
            .what
            .strip_prefix("mistake-")
            .and_then(|number| number.parse::<usize>().ok());
        let named = number.and_then(|number| part?.mistakes.get(number.checked_sub(1)?));
        let what = match named {
            Some(mistake) => text(&mistake.feedback),
            None => {
                let slip = Language::default().slip(&common.what);
                slip.unwrap_or(&common.what).to_owned()
            }
        };
        Self {
            code: common.what,
            what,
            count: common.count,
        }
    }
}

/// A text of an item in words; what depends on the data stays open.
fn text(passage: &Passage) -> String {
    let pieces = passage
        .pieces
        .iter()
        .map(|piece| piece.document.plain(&Vec::new()));
    pieces.collect::<Vec<_>>().join(" ").replace('□', "…")
}
