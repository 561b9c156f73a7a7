//! What an item says of itself.

use crate::answer::Credit;
use crate::source::{Table, Text};

/// The `[item]` table.
#[derive(Clone, Debug)]
pub struct About {
    /// The title that lists and pages show.
    pub title: String,
    /// Where it comes from.
    pub source: String,
    /// Words of the bank's vocabulary.
    pub topics: Vec<Text>,
    /// Difficulty, 1 to 3.
    pub level: u8,
    /// Expected working time in minutes; else the sum over the kinds of its parts.
    pub minutes: Option<u32>,
    /// What a right value is worth where a formula is asked, and the reverse.
    pub other_form: Option<Credit>,
    /// Items that it builds on.
    pub after: Vec<Text>,
    /// Significant figures in which computed values are printed.
    pub digits: u8,
    /// Guards and lints that are lifted on purpose.
    pub allow: Vec<Text>,
    /// For the teacher.
    pub notes: Option<Text>,
}

/// What `allow` may lift.
pub(crate) const LIFTABLE: &[&str] = &[
    "repeated-frequencies",
    "near-critical",
    "near-resonance",
    "large-angle",
    "few-instances",
    "single-route",
];

impl About {
    /// Reads the table; what is missing is noted and left empty.
    pub(crate) fn read(table: Table<'_>) -> Self {
        let text = |key| {
            table
                .required_text(key)
                .map(|text| text.value)
                .unwrap_or_default()
        };
        let about = Self {
            title: text("title"),
            source: text("source"),
            topics: table.texts("topics"),
            level: table.integer("level", "1, 2 or 3", 1..=3).unwrap_or(1) as u8,
            minutes: table
                .integer("minutes", "an integer from 1 to 600", 1..=600)
                .map(|minutes| minutes as u32),
            other_form: Credit::of_table(&table, "other_form"),
            after: table.texts("after"),
            digits: table
                .integer("digits", "an integer from 1 to 12", 1..=12)
                .unwrap_or(3) as u8,
            allow: table.texts("allow"),
            notes: table.text("notes"),
        };
        table.finish();
        about
    }

    /// Whether this guard or lint is lifted.
    pub fn allows(&self, name: &str) -> bool {
        self.allow.iter().any(|allowed| allowed.value == name)
    }
}
