//! Exports: questions in the formats of course platforms, one file each.
//!
//! A platform marks by its own means, so that an export carries what those can hold and names the rest: `held` says for
//! each part what that is, `words` has the texts, and each format is a file.

mod cloze;
mod held;
mod moodle;
mod pictures;
mod qti;
mod units;
mod words;

pub use moodle::Moodle;
pub use qti::{Canvas, Qti, Version};

use crate::document::Formulas;
use crate::message::Language;
use crate::scene::Data;
use crate::worksheet::{Sheet, SheetQuestion};

/// What is wanted of an export, whatever its format.
#[derive(Clone, Debug, Default)]
pub struct Wish {
    /// The title of the whole.
    pub title: String,
    /// The tag of the language in which the program's own words stand; English where it is empty or not spoken.
    pub language: String,
    /// How data are shown.
    pub data: Data,
    /// How formulas are written.
    pub formulas: Formulas,
    /// Whether parts that do not fit become essays with the key for whoever marks them.
    pub has_essays: bool,
    /// Whether a question for one number takes units, where the platform can read them.
    pub has_units: bool,
}

impl Wish {
    fn spoken(&self) -> Language {
        Language::of(&self.language).unwrap_or_default()
    }
}

/// What an export holds.
#[derive(Clone, Debug, Default)]
pub struct ExportTally {
    /// How many questions were written.
    pub questions: usize,
    /// How many boxes they have that the platform marks.
    pub boxes: usize,
    /// The parts that the platform cannot mark, each once.
    pub unfit: Vec<Unfit>,
}

/// A part that a platform cannot mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unfit {
    /// The identity of the item, `chapter/name`.
    pub item: String,
    /// The identifier of the part.
    pub part: String,
    /// Why the platform cannot have it.
    pub reason: &'static str,
}

/// A file of questions while it is written.
pub trait Export {
    /// Begins the variants of a question, of which a student gets one: its path below the title.
    fn category(&mut self, path: &[&str]);

    /// Adds a question of a sheet to the category, under its number in the whole export.
    fn add(&mut self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>, number: usize);

    /// What was written so far.
    fn tally(&self) -> &ExportTally;

    /// The bytes of the file.
    ///
    /// # Errors
    ///
    /// If an archive cannot hold it.
    fn finish(self: Box<Self>) -> std::io::Result<Vec<u8>>;
}
