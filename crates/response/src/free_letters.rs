//! The letters of a formula that may mean anything.

use super::Lexicon;
use super::letters::{Letters, greek_word, letter, lowered};
use super::words::is_function;
use vibank_formula::expr::Name;
use vibank_notation::symbol;

/// Whether no run of letters is a word that joins or denies.
fn are_no_words(text: &str) -> bool {
    const WORDS: [&str; 24] = [
        "or", "and", "nor", "not", "no", "but", "so", "is", "if", "in", "to", "by", "at", "as",
        "of", "on", "for", "the", "are", "was", "one", "two", "yes", "oder",
    ];
    let mut runs = text.split(|char: char| !char.is_ascii_alphabetic());
    !runs.any(|run| WORDS.contains(&run))
}

/// Whether a run of letters is one with an index that is the beginning of a word, `Trot`, `Epot`.
fn is_letter_with_word(run: &str) -> bool {
    const INDICES: [&str; 9] = [
        "rot", "tot", "kin", "pot", "trans", "max", "min", "total", "tran",
    ];
    let index = run.get(1..).unwrap_or_default();
    INDICES.contains(&index)
}

/// The letters of a text as names; nothing where its letters are words, or where it has no sign of a formula.
pub(crate) fn lexicon(text: &str) -> Option<Lexicon> {
    /// Letters in a row that make a word, unless they are a function or a command.
    const WORD: usize = 4;
    let is_sign = |char: char| "+-*/^=<>≤≥√½¼¾\\".contains(char) || char.is_numeric();
    let mut runs = text.split(|char: char| !char.is_ascii_alphabetic());
    let is_word = |run: &str| {
        let is_command = ["frac", "mathrm", "text"].contains(&run);
        let is_known =
            is_command || is_function(run) || greek_word(run).is_some() || is_letter_with_word(run);
        run.len() >= WORD && !is_known
    };
    if !text.contains(is_sign) || runs.any(is_word) || !are_no_words(text) {
        return None;
    }
    let mut lexicon = Lexicon::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let Some((length, _)) = letter(rest).filter(|_| !first.is_ascii_digit()) else {
            rest = &rest[first.len_utf8()..];
            continue;
        };
        let is_index =
            |char: char| matches!(char, '0'..='9' | '₀'..='₉' | '_') || lowered(char).is_some();
        // `T_rot`, `T_{rot}`
        let is_word = |char: char| is_index(char) || char.is_ascii_alphabetic();
        let own = &rest[length..];
        let behind = match own.strip_prefix('_') {
            Some(index) => match index.strip_prefix('{').and_then(|own| own.split_once('}')) {
                Some((_, behind)) => behind,
                None => index.trim_start_matches(is_word),
            },
            None => own.trim_start_matches(is_index),
        };
        if let Some(name) = Letters::spelling(&rest[..rest.len() - behind.len()]) {
            lexicon.allow(&Name::new(name.as_str()), symbol(&name), false);
        }
        rest = behind;
    }
    Some(lexicon)
}
