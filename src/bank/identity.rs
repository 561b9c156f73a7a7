//! What an item is called, and which text of it is meant.

use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::Value as Json;
use sha2::{Digest, Sha256};

use crate::source::{FromJson, Misfit};

/// The identity of an item: its path in the bank without extension, `ch4/p1-rolling-disk-hub-moment`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct ItemId(Arc<str>);

/// The text of an item file: the first 8 hexadecimal digits of its SHA-256 with LF line ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Revision([u8; 4]);

impl ItemId {
    /// The chapter of questions that stand in a blueprint.
    pub(crate) const OWN: &str = "own";

    /// The identity of the item in the file `path`, such as `ch4/p1-disk.toml`; `None` for other paths.
    ///
    /// ```
    /// use vibank::bank::ItemId;
    /// let id = ItemId::of_path("ch4/p1-disk.toml").unwrap();
    /// assert_eq!((id.chapter(), id.slug()), ("ch4", "p1-disk"));
    /// assert!(ItemId::of_path("ch4/P1 disk.toml").is_none());
    /// ```
    pub fn of_path(path: &str) -> Option<Self> {
        let stem = path.strip_suffix(".toml")?;
        let (chapter, slug) = stem.split_once('/')?;
        (is_word(chapter) && is_word(slug)).then(|| Self(stem.into()))
    }

    /// The identity of this text.
    fn of_text(text: &str) -> Option<Self> {
        Self::of_path(&format!("{text}.toml"))
    }

    /// The folder.
    pub fn chapter(&self) -> &str {
        self.0.split_once('/').map_or("", |(chapter, _)| chapter)
    }

    /// Whether it is that of a question which stands in a blueprint, and in no bank.
    pub fn is_own(&self) -> bool {
        self.chapter() == Self::OWN
    }

    /// The name within its chapter.
    pub fn slug(&self) -> &str {
        self.0.split_once('/').map_or("", |(_, slug)| slug)
    }

    /// The whole path.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

/// Whether a word may stand in an identity.
fn is_word(word: &str) -> bool {
    !word.is_empty()
        && word.len() <= 80
        && word
            .bytes()
            .all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-')
}

impl Revision {
    /// The revision of a file with this text.
    ///
    /// ```
    /// use vibank::bank::Revision;
    /// // SHA-256 of the empty text.
    /// assert_eq!(Revision::of("").to_string(), "e3b0c442");
    /// assert_eq!(Revision::of("a\r\n"), Revision::of("a\n"));
    /// ```
    pub fn of(text: &str) -> Self {
        let mut hash = Sha256::new();
        if text.contains('\r') {
            hash.update(text.replace("\r\n", "\n"));
        } else {
            hash.update(text);
        }
        let digest = hash.finalize();
        Self([digest[0], digest[1], digest[2], digest[3]])
    }
}

impl fmt::Display for ItemId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl fmt::Display for Revision {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0
            .iter()
            .try_for_each(|byte| write!(formatter, "{byte:02x}"))
    }
}

impl From<ItemId> for String {
    fn from(id: ItemId) -> Self {
        id.0.as_ref().to_owned()
    }
}

impl TryFrom<String> for ItemId {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        Self::of_text(&text).ok_or_else(|| {
            format!(
                "`{}` is not an item, expected `chapter/name`",
                text.escape_debug()
            )
        })
    }
}

impl From<Revision> for String {
    fn from(revision: Revision) -> Self {
        revision.to_string()
    }
}

impl FromJson for ItemId {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let text = String::from_json(json)?;
        Self::of_text(&text).ok_or(Misfit::Expected("`chapter/name`"))
    }
}

impl FromJson for Revision {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        Self::try_from(String::from_json(json)?).map_err(|_| Misfit::Expected("a revision"))
    }
}

impl TryFrom<String> for Revision {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let value = u32::from_str_radix(&text, 16)
            .ok()
            .filter(|_| text.len() == 8);
        value
            .map(|value| Self(value.to_be_bytes()))
            .ok_or_else(|| format!("`{text}` is not a revision"))
    }
}
