//! The rules of a page in a course: how often one may answer, what is said and when, and what passes.

use serde::{Deserialize, Serialize};

use super::blueprint::{BlueprintError, Faults};
use crate::source::{Data, Table};

/// When a page says what an answer is worth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Feedback {
    /// After each answer.
    #[default]
    #[serde(rename = "at once")]
    AtOnce,
    /// After all answers were submitted.
    #[serde(rename = "after submitting")]
    AfterSubmitting,
    /// Not before, and not after submitting.
    #[serde(rename = "never")]
    Never,
}

/// When a page shows worked solutions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Worked {
    /// Once a part was answered, or once all was submitted where nothing is said before; seen, it freezes the credit of
    /// its question.
    #[default]
    After,
    /// Not before, and not after submitting.
    Never,
}

/// The table `[page]` of a blueprint.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Rules {
    /// What a package is known by, so that one that is made anew goes on with old answers; else it follows from title
    /// and seed.
    #[serde(skip)]
    pub id: Option<String>,
    /// The share of the points with which it is passed, from 0 to 1.
    pub pass: Option<f64>,
    /// How often a part may be answered; any number of times without.
    pub attempts: Option<u32>,
    /// When answers are said to be right or wrong.
    pub feedback: Feedback,
    /// When worked solutions are shown.
    pub solution: Worked,
}

/// Most attempts that can be stated: a package keeps their number in six bits.
const MAX_ATTEMPTS: i64 = 60;

/// Longest identity of a package: it is a name in a manifest and part of keys.
const MAX_ID_LENGTH: usize = 64;

impl Rules {
    pub(crate) fn read(table: &Table<'_>, faults: &mut Faults<'_>) -> Self {
        let rules = Self {
            id: id(table, faults),
            pass: pass(table),
            attempts: table
                .integer("attempts", "an integer from 1 to 60", 1..=MAX_ATTEMPTS)
                .map(|attempts| attempts as u32),
            feedback: faults.word(
                table,
                "feedback",
                &["at once", "after submitting", "never"],
                &[Feedback::AtOnce, Feedback::AfterSubmitting, Feedback::Never],
            ),
            solution: faults.word(
                table,
                "solution",
                &["after", "never"],
                &[Worked::After, Worked::Never],
            ),
        };
        table.finish_ref();
        rules
    }
}

fn id(table: &Table<'_>, faults: &mut Faults<'_>) -> Option<String> {
    let id = table.text("id")?;
    let is_plain = |sign: char| sign.is_ascii_alphanumeric() || "-_.".contains(sign);
    if id.value.is_empty() || id.value.len() > MAX_ID_LENGTH || !id.value.chars().all(is_plain) {
        faults.add(&BlueprintError::PageId(id.span));
        return None;
    }
    Some(id.value)
}

/// `"60 %"`, as a share.
fn pass(table: &Table<'_>) -> Option<f64> {
    let value = table.value("pass")?;
    let share = match &value.data {
        Data::Text(text) => text
            .trim()
            .strip_suffix('%')
            .and_then(|number| number.trim().parse::<f64>().ok())
            .filter(|percent| *percent > 0.0 && *percent <= 100.0),
        _ => None,
    };
    let percent = share.or_else(|| table.wrong("pass", "a percentage such as \"60 %\"", value));
    percent.map(|percent| percent / 100.0)
}
