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
    pub(crate) graded: String,
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
    pub(crate) fairness: FairnessWords,
    pub(crate) report: ReportWords,
}

/// What the page on fairness says.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FairnessWords {
    pub(crate) title: String,
    pub(crate) is_fair: String,
    pub(crate) look_at_triangles: String,
    pub(crate) look_at_bold: String,
    pub(crate) apart: String,
    pub(crate) alike: String,
    pub(crate) pair: String,
    pub(crate) pair_of_several: String,
    pub(crate) gave_way: String,
    pub(crate) differ: String,
    pub(crate) repeats: String,
    pub(crate) unusual: String,
    pub(crate) item: String,
    pub(crate) to: String,
    pub(crate) answer: String,
    pub(crate) smallest: String,
    pub(crate) largest: String,
    pub(crate) unit: String,
}

/// What the item analysis says.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ReportWords {
    pub(crate) title: String,
    pub(crate) sheets: String,
    pub(crate) undecided: String,
    pub(crate) undecided_note: String,
    pub(crate) unused: String,
    pub(crate) absent: String,
    pub(crate) part: String,
    pub(crate) answer: String,
    pub(crate) why: String,
    pub(crate) times: String,
    pub(crate) rows: String,
    pub(crate) decisions: String,
    pub(crate) about: String,
    pub(crate) decided: String,
    pub(crate) by_whom: String,
    pub(crate) changed: String,
    pub(crate) mark: String,
    pub(crate) other_changes: String,
    pub(crate) no_change: String,
    pub(crate) more_decided: String,
    pub(crate) marks: String,
    pub(crate) points: String,
    pub(crate) group: String,
    pub(crate) open: String,
    pub(crate) mean: String,
    pub(crate) median: String,
    pub(crate) deviation: String,
    pub(crate) range: String,
    pub(crate) pass: String,
    pub(crate) groups_note: String,
    pub(crate) grade: String,
    pub(crate) all: String,
    pub(crate) without_group: String,
    pub(crate) to: String,
    pub(crate) passed_of: String,
    pub(crate) pass_mark: String,
    pub(crate) histogram: String,
    pub(crate) histogram_bar: String,
    pub(crate) histogram_pass: String,
    pub(crate) best: String,
    pub(crate) best_of_section: String,
    pub(crate) wrong_choice: String,
    pub(crate) wrong_choice_floor: String,
    pub(crate) rounded: String,
    pub(crate) rounded_up: String,
    pub(crate) rounded_down: String,
    pub(crate) full: String,
    pub(crate) overview: String,
    pub(crate) shares: String,
    pub(crate) percent: String,
    pub(crate) standard_deviation: String,
    pub(crate) middle_half: String,
    pub(crate) reliability: String,
    pub(crate) no_reliability: String,
    pub(crate) not_decided: String,
    pub(crate) left_out: String,
    pub(crate) error: String,
    pub(crate) parts: String,
    pub(crate) right: String,
    pub(crate) partial: String,
    pub(crate) wrong: String,
    pub(crate) unreadable: String,
    pub(crate) missing: String,
    pub(crate) facility: String,
    pub(crate) discrimination: String,
    pub(crate) mistakes: String,
    pub(crate) follow_through: String,
    pub(crate) negative: String,
    pub(crate) very_hard: String,
    pub(crate) very_easy: String,
    pub(crate) hardly_discriminates: String,
    pub(crate) parts_note: String,
}

/// A phrase with its places filled: `{count}` by the value of `count`.
pub(crate) fn filled(phrase: &str, values: &[(&str, &str)]) -> String {
    values
        .iter()
        .fold(phrase.to_owned(), |text, (name, value)| {
            text.replace(&format!("{{{name}}}"), value)
        })
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
    use std::collections::{BTreeMap, BTreeSet};

    use super::*;

    /// The phrases of a value by their keys.
    fn phrases(value: &serde_json::Value, path: &str, all: &mut BTreeMap<String, String>) {
        match value {
            serde_json::Value::String(phrase) => {
                all.insert(path.to_owned(), phrase.clone());
            }
            value => {
                for (key, value) in value.as_object().expect("words and groups of words") {
                    phrases(value, &format!("{path}.{key}"), all);
                }
            }
        }
    }

    fn places(phrase: &str) -> BTreeSet<&str> {
        let pieces = phrase.split('{').skip(1);
        pieces
            .map(|piece| piece.split_once('}').expect("it is closed").0)
            .collect()
    }

    #[test]
    fn each_language_has_all_words_and_places() {
        let [english, others @ ..] = &*Language::ALL
            .iter()
            .map(|language| {
                let mut all = BTreeMap::new();
                let words = serde_json::to_value(Words::of(*language)).expect("plain data");
                phrases(&words, language.code(), &mut all);
                let all = all.into_iter();
                let all =
                    all.map(|(key, phrase)| (key[language.code().len()..].to_owned(), phrase));
                all.collect::<BTreeMap<String, String>>()
            })
            .collect::<Vec<_>>()
        else {
            panic!("there are languages");
        };
        for other in others {
            for (key, phrase) in english {
                assert!(!other[key].trim().is_empty(), "{key}");
                assert_eq!(places(&other[key]), places(phrase), "{key}");
            }
        }
    }

    #[test]
    fn places_are_filled_by_their_names() {
        let values = [("count", "2"), ("all", "3")];
        assert_eq!(filled("{count} of {all}", &values), "2 of 3");
    }
}
