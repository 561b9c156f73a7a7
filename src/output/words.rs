//! The words of layouts: headings and fixed phrases, one file a language in `templates/words/`.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::layouts;
use crate::message::Language;

/// What layouts print beside what a sheet holds. A place in a phrase is written `{count}`.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Words {
    pub(super) answer_key: String,
    pub(super) worked_solutions: String,
    pub(super) feedback: String,
    pub(super) all_answers: String,
    pub(super) variant: String,
    pub(super) duration: String,
    pub(super) page: String,
    pub(super) name: String,
    pub(super) number: String,
    pub(super) group: String,
    pub(super) question: String,
    pub(super) points: String,
    pub(super) reached: String,
    pub(super) sum: String,
    pub(super) order: String,
    pub(super) hint: String,
    pub(super) formulas: String,
    pub(super) figure: String,
    pub(super) is_right: String,
    pub(super) given_for: String,
    pub(super) marked_by_hand: String,
    pub(super) you_wrote: String,
    pub(super) read_as: String,
    one_question: String,
    questions: String,
    one_point: String,
    many_points: String,
    reached_of: String,
    pub(super) accepted: String,
    pub(super) in_the_solution: String,
    pub(super) by_hand: String,
    pub(super) seat: String,
    pub(super) room: String,
    pub(super) no_room: String,
    pub(super) no_group: String,
    pub(super) spare_sheets: String,
    pub(super) all_sheets: String,
    one_sheet: String,
    sheets: String,
    pub(super) extra_time: String,
    large_print: String,
    pub(super) attendance_list: String,
    pub(super) seating_list: String,
    pub(super) place: String,
    pub(super) code: String,
    pub(super) note: String,
    pub(super) signature: String,
    /// Between the number of a page and how many there are.
    page_of: String,
}

impl Words {
    /// The words of a language.
    pub(super) fn of(language: Language) -> &'static Self {
        static ENGLISH: LazyLock<Words> = LazyLock::new(|| Words::read(Language::English));
        static FRENCH: LazyLock<Words> = LazyLock::new(|| Words::read(Language::French));
        match language {
            Language::English => &ENGLISH,
            Language::French => &FRENCH,
        }
    }

    fn read(language: Language) -> Self {
        let path = format!("words/{}.json", language.code());
        serde_json::from_str(layouts::text(&path)).expect("the files of words are tested")
    }

    /// A count of questions in words: `1 question`, `5 questions`.
    pub(super) fn questions(&self, count: usize) -> String {
        let phrase = if count == 1 {
            &self.one_question
        } else {
            &self.questions
        };
        phrase.replace("{count}", &count.to_string())
    }

    /// A count of sheets in words: `1 sheet`, `24 sheets`.
    pub(super) fn sheets(&self, count: usize) -> String {
        let phrase = if count == 1 {
            &self.one_sheet
        } else {
            &self.sheets
        };
        phrase.replace("{count}", &count.to_string())
    }

    /// `large print, 18 pt`.
    pub(super) fn large_print(&self, size: u8) -> String {
        self.large_print.replace("{points}", &size.to_string())
    }

    /// `2.5 points`; `points` is printed, `is_one` says whether it counts as a single one.
    pub(super) fn points(&self, points: &str, is_one: bool) -> String {
        let phrase = if is_one {
            &self.one_point
        } else {
            &self.many_points
        };
        phrase.replace("{points}", points)
    }

    /// `2.5 of 4 points`.
    pub(super) fn reached(&self, reached: &str, all: &str) -> String {
        self.reached_of
            .replace("{reached}", reached)
            .replace("{all}", all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_language_has_all_words() {
        for language in Language::ALL {
            let words = serde_json::to_value(Words::of(*language)).expect("plain data");
            for (key, word) in words.as_object().expect("an object") {
                let word = word.as_str().expect("a text");
                assert!(!word.trim().is_empty(), "{language:?} {key}");
                let places = word.matches('{').count();
                let due = match key.as_str() {
                    "one_question" | "questions" | "one_point" | "many_points" | "one_sheet"
                    | "sheets" | "large_print" => 1,
                    "reached_of" => 2,
                    _ => 0,
                };
                assert_eq!(places, due, "{language:?} {key}");
            }
        }
    }
}
