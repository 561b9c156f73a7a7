//! The manifest of a run: what is needed to mark its sheets years later.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::marks::Marks;
use super::paper::Paper;
use crate::answer::Doubt;
use crate::bank::{ItemId, Revision};
use crate::scene::Data;
use crate::seed::Variant;

/// The version of the manifest that this program writes and reads.
pub const FORMAT: u32 = 1;

/// How tables are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Csv {
    /// With commas and decimal points, as programs read them.
    #[default]
    Plain,
    /// With a mark of byte order, semicolons and the decimal sign of the class, as spreadsheets open them.
    Excel,
}

/// What one run made. It contains what the answers follow from, so it is confidential.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// Version of this format.
    pub format: u32,
    /// Program and version that wrote it.
    pub program: String,
    /// The bank of the items.
    pub bank: BankStamp,
    /// The blueprint that the run was made from.
    pub blueprint: FileStamp,
    /// Title of the sheet.
    pub title: String,
    /// How data are shown.
    pub data: Data,
    /// Language of the texts.
    pub language: String,
    /// Decimal sign.
    pub decimal: char,
    /// What becomes of answers with two readings; on paper nobody can be asked.
    #[serde(default = "benefit")]
    pub doubt: Doubt,
    /// The share of the points for an answer in another form than the one that is asked; items decide where it is `null`.
    /// It was nothing before there was this key.
    #[serde(default = "nothing")]
    pub other_form: Option<f64>,
    /// What becomes of the points of a sheet, where that was stated when the sheets were made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub marks: Option<Marks>,
    /// How its tables are written.
    #[serde(default)]
    pub csv: Csv,
    /// The paper of its sheets, on which feedback and report are printed, too.
    #[serde(default)]
    pub paper: Paper,
    /// Whether the seeds are keyed with a secret.
    pub keyed: bool,
    /// Which part of the run this is, `1/1` for all of it.
    pub shard: String,
    /// Digest of everything the run depends on: same digest, same bytes.
    #[serde(default)]
    pub inputs: String,
    /// Digest of what pages depend on beside the entries of their sheets.
    #[serde(default)]
    pub look: String,
    /// The formats that were made.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub formats: Vec<String>,
    /// Digest of what shapes the bytes of PDF files: the press that printed them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub press: Option<String>,
    /// The fonts in which names are printed that the press has no letters for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fonts: Vec<FileStamp>,
    /// The sheets, in order.
    pub variants: Vec<VariantEntry>,
    /// The files of the items that were used, by identity: marking reads these, whatever becomes of the bank.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub items: BTreeMap<String, String>,
    /// Digest of the form for the answers as it was written.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub form: String,
    /// The files of the run that belong to no single sheet, each with its digest; the form, which is filled in, is left out.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
}

/// How doubts of earlier manifests are settled, which do not say.
fn benefit() -> Doubt {
    Doubt::Benefit
}

#[expect(clippy::unnecessary_wraps, reason = "the type of the field")]
fn nothing() -> Option<f64> {
    Some(0.0)
}

/// A bank, by title and digest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BankStamp {
    /// The title of the bank.
    pub title: String,
    /// Digest over the revisions of its items.
    pub digest: String,
}

/// A file, by path and digest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileStamp {
    /// Its name.
    pub path: String,
    /// SHA-256 of its bytes.
    pub digest: String,
}

/// One sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VariantEntry {
    /// The code that is printed on the sheet.
    pub code: String,
    /// The seed of the variant.
    pub seed: u64,
    /// The row of the class list, if there is one.
    pub student: Option<BTreeMap<String, String>>,
    /// Whether it is not the student's first variant, since that repeats what another student has.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub gave_way: bool,
    /// The files made for it, each with its digest; one that could not be printed has none.
    pub files: BTreeMap<String, String>,
    /// Where it stands in the files that it shares with other sheets: its first byte there, and how many are its own.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub pages: BTreeMap<String, (u64, u64)>,
    /// The questions in the order of the sheet.
    pub questions: Vec<QuestionEntry>,
}

/// One question of a sheet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct QuestionEntry {
    /// Its number on the sheet, from 1.
    pub number: usize,
    /// The identity of the item, `chapter/name`.
    pub item: ItemId,
    /// The text of the item that was used.
    pub revision: Revision,
    /// The seed of the instance.
    pub seed: u64,
    /// The points that can be reached.
    pub points: f64,
    /// Whether its points are beyond those of the sheet.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub bonus: bool,
    /// Its section, of which the best questions may count; empty if it is in none.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub section: String,
    /// The data as printed.
    pub values: BTreeMap<String, String>,
    /// The parts that are asked, in their order.
    pub parts: Vec<PartEntry>,
}

/// One part of a question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartEntry {
    /// Its letter on the sheet.
    pub letter: String,
    /// Its identity in the item.
    pub id: String,
    /// Its kind of answer.
    pub kind: String,
    /// The unit asked for; empty if none.
    pub unit: String,
    /// The points that can be reached.
    pub points: f64,
    /// The options of a choice, in the order printed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub options: Vec<String>,
}

/// Why an entry of a manifest cannot be one.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EntryError {
    /// Not as codes are printed.
    #[error("`{0}` is not a code of a sheet")]
    Code(String),
    /// Not as the parts of a sheet are lettered.
    #[error("`{0}` is not a letter of a part")]
    Letter(String),
    /// Not as parts are named in items.
    #[error("`{0}` is not a name of a part")]
    Part(String),
    /// Not as many as a part can have.
    #[error("{0} is not a number of points from 0 to 1000000")]
    Points(String),
}

impl VariantEntry {
    /// Whether its code, letters and names have the form that this program gives them; they become names of files and
    /// cells of tables.
    ///
    /// # Errors
    ///
    /// [`EntryError`] for the first that has not.
    pub fn check(&self) -> Result<(), EntryError> {
        let shown = |text: &str| text.chars().take(40).flat_map(char::escape_debug).collect();
        let code = self.code.parse::<Variant>().ok();
        if code.is_none_or(|code| code.to_string() != self.code) {
            return Err(EntryError::Code(shown(&self.code)));
        }
        for part in self.questions.iter().flat_map(|question| &question.parts) {
            let number = part
                .letter
                .trim_start_matches(|char: char| char.is_ascii_lowercase());
            let is_letter = (1..=4).contains(&(part.letter.len() - number.len()))
                && number.len() <= 3
                && number.bytes().all(|byte| byte.is_ascii_digit());
            if !is_letter {
                return Err(EntryError::Letter(shown(&part.letter)));
            }
            let is_name = !part.id.is_empty()
                && part.id.len() <= 200
                && !part.id.contains(|char: char| char.is_control());
            if !is_name {
                return Err(EntryError::Part(shown(&part.id)));
            }
            if !(0.0..=1e6).contains(&part.points) {
                return Err(EntryError::Points(part.points.to_string()));
            }
        }
        Ok(())
    }
}
