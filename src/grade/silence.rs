//! What people write where they have no answer.

use crate::answer::{Marking, Verdict};
use crate::source::lower;

/// Words of several languages, small, without signs around them.
const WORDS: [&str; 36] = [
    "n/a",
    "na",
    "no answer",
    "no idea",
    "none",
    "nothing",
    "blank",
    "empty",
    "skip",
    "skipped",
    "idk",
    "dk",
    "don't know",
    "dont know",
    "i don't know",
    "i dont know",
    "i do not know",
    "unknown",
    "not answered",
    "not attempted",
    "je ne sais pas",
    "je sais pas",
    "jsp",
    "nsp",
    "aucune idée",
    "pas de réponse",
    "sans réponse",
    "keine ahnung",
    "weiß nicht",
    "weiss nicht",
    "ich weiß nicht",
    "keine antwort",
    "no sé",
    "no se",
    "non lo so",
    "não sei",
];

/// A response that could not be read and says that there is no answer is missing; `n/a` where these are letters of
/// the question is read before and stays what it is.
pub(crate) fn heard(response: &str, marking: Marking) -> Marking {
    if marking.verdict == Verdict::Unreadable && is_no_answer(response) {
        Marking::missing()
    } else {
        marking
    }
}

/// Whether a text says that there is no answer: signs alone, or words for it.
fn is_no_answer(response: &str) -> bool {
    let words = lower(response.trim_matches(|sign: char| "?¿!.,-–—−_~/\\*…()[]: ".contains(sign)))
        .replace('’', "'");
    let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
    // Signs alone are a dash or a row of dots; more of them than a blank has room for are something mistyped.
    const MAX_SIGNS: usize = 40;
    let are_signs = words.is_empty() && response.chars().count() <= MAX_SIGNS;
    are_signs || WORDS.contains(&&*words)
}

#[cfg(test)]
mod tests {
    use super::is_no_answer;

    #[test]
    fn words_and_signs_for_no_answer_are_known() {
        for text in [
            "?",
            "??",
            "-",
            "–",
            "---",
            "…",
            "n/a",
            "N/A",
            "(n/a)",
            "Je ne sais pas",
            "je ne sais pas.",
            "I don’t know!",
            "idk",
            " keine  Ahnung ",
            "No sé",
            "/",
            "_____",
        ] {
            assert!(is_no_answer(text), "{text}");
        }
        for text in [
            "5?",
            "-3",
            "n/a m",
            "see back",
            "x",
            "0",
            "about seven",
            "nan",
        ] {
            assert!(!is_no_answer(text), "{text}");
        }
    }
}
