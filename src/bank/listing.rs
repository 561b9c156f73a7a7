//! What a list of items shows of each, and the committed one of the bank that comes with the program.

use serde::{Deserialize, Serialize};

use super::{ItemId, Revision, Template};

/// What a list shows of an item, and what items are chosen by.
///
/// Its fields are those of `vibank list --format json`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Listing {
    /// Its identity.
    pub id: ItemId,
    /// The text it was read from.
    pub revision: Revision,
    /// The title that lists and pages show.
    pub title: String,
    /// Where it comes from.
    pub source: String,
    /// Words of the bank's vocabulary.
    pub topics: Vec<String>,
    /// Difficulty, 1 to 3.
    pub level: u8,
    /// Expected working time.
    pub minutes: u32,
    /// What is asked.
    pub parts: Vec<ListedPart>,
    /// How many instances its grids allow.
    pub instances: u64,
}

/// A part in a list.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ListedPart {
    /// Its identity in the item.
    pub id: String,
    /// The name of its kind of answer.
    pub kind: String,
}

/// The items of the bank that comes with the program, a row each, made from it by the test suite.
const EMBEDDED: &str = include_str!("listings.jsonl");

impl Listing {
    /// What a list shows of a template.
    pub fn of(item: &Template) -> Self {
        let topics = item.about.topics.iter().map(|topic| topic.value.clone());
        let parts = item.parts.iter().map(|part| ListedPart {
            id: part.id.clone(),
            kind: part.answer.kind().name().to_owned(),
        });
        Self {
            id: item.id.clone(),
            revision: item.revision,
            title: item.about.title.clone(),
            source: item.about.source.clone(),
            topics: topics.collect(),
            level: item.about.level,
            minutes: item.minutes(),
            parts: parts.collect(),
            instances: item.instances(),
        }
    }

    /// The committed rows of the bank that comes with the program; each holds for the revision that it names.
    ///
    /// ```
    /// use vibank::bank::Listing;
    /// let row = Listing::embedded().find(|row| row.id.as_str() == "ch3/e5-log-decrement");
    /// assert!(row.is_some_and(|row| !row.title.is_empty()));
    /// ```
    pub fn embedded() -> impl Iterator<Item = Self> {
        let rows = EMBEDDED.lines().filter(|line| !line.is_empty());
        rows.filter_map(|line| serde_json::from_str(line).ok())
    }
}
