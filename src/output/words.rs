//! The words of layouts: headings and fixed phrases, one file a language in `templates/words/`.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::layouts;
use crate::message::Language;

/// What layouts print beside what a sheet holds. A place in a phrase is written `{count}`.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Words {
    pub(crate) answer_key: String,
    pub(crate) worked_solutions: String,
    pub(crate) feedback: String,
    pub(crate) all_answers: String,
    pub(crate) variant: String,
    pub(crate) duration: String,
    pub(crate) page: String,
    pub(crate) name: String,
    pub(crate) number: String,
    pub(crate) group: String,
    pub(crate) question: String,
    pub(crate) points: String,
    pub(crate) reached: String,
    pub(crate) sum: String,
    pub(crate) order: String,
    pub(crate) hint: String,
    pub(crate) formulas: String,
    pub(crate) figure: String,
    pub(crate) is_right: String,
    pub(crate) given_for: String,
    pub(crate) marked_by_hand: String,
    pub(crate) you_wrote: String,
    pub(crate) read_as: String,
    one_question: String,
    questions: String,
    one_point: String,
    many_points: String,
    reached_of: String,
    pub(crate) accepted: String,
    pub(crate) in_the_solution: String,
    pub(crate) by_hand: String,
    pub(crate) seat: String,
    pub(crate) room: String,
    pub(crate) no_room: String,
    pub(crate) no_group: String,
    pub(crate) spare_sheets: String,
    pub(crate) all_sheets: String,
    one_sheet: String,
    sheets: String,
    pub(crate) extra_time: String,
    large_print: String,
    pub(crate) attendance_list: String,
    pub(crate) seating_list: String,
    pub(crate) place: String,
    pub(crate) code: String,
    pub(crate) note: String,
    pub(crate) signature: String,
    /// Between the number of a page and how many there are.
    page_of: String,
}

impl Words {
    /// The words of a language.
    pub(crate) fn of(language: Language) -> &'static Self {
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
    pub(crate) fn questions(&self, count: usize) -> String {
        let phrase = if count == 1 {
            &self.one_question
        } else {
            &self.questions
        };
        phrase.replace("{count}", &count.to_string())
    }

    /// A count of sheets in words: `1 sheet`, `24 sheets`.
    pub(crate) fn sheets(&self, count: usize) -> String {
        let phrase = if count == 1 {
            &self.one_sheet
        } else {
            &self.sheets
        };
        phrase.replace("{count}", &count.to_string())
    }

    /// `large print, 18 pt`.
    pub(crate) fn large_print(&self, size: u8) -> String {
        self.large_print.replace("{points}", &size.to_string())
    }

    /// `2.5 points`; `points` is printed, `is_one` says whether it counts as a single one.
    pub(crate) fn points(&self, points: &str, is_one: bool) -> String {
        let phrase = if is_one {
            &self.one_point
        } else {
            &self.many_points
        };
        phrase.replace("{points}", points)
    }

    /// `2.5 of 4 points`.
    pub(crate) fn reached(&self, reached: &str, all: &str) -> String {
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
