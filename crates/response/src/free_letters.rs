//! The letters of a formula that may mean anything.

use super::Lexicon;
use super::letters::letter;
use vibank_formula::expr::Name;
use vibank_notation::symbol;

/// Whether no run of letters is a word that joins or denies.
pub(crate) fn are_no_words(text: &str) -> bool {
    const WORDS: [&str; 24] = [
        "or", "and", "nor", "not", "no", "but", "so", "is", "if", "in", "to", "by", "at", "as",
        "of", "on", "for", "the", "are", "was", "one", "two", "yes", "oder",
    ];
    let mut runs = text.split(|char: char| !char.is_ascii_alphabetic());
    !runs.any(|run| WORDS.contains(&run))
}

/// The letters of a text as names; nothing where its letters are words, or where it has no sign of a formula.
pub(crate) fn lexicon(text: &str) -> Option<Lexicon> {
    /// Letters in a row that make a word, unless they are a function or a command.
    const WORD: usize = 4;
    let is_sign = |char: char| "+-*/^=<>≤≥√½¼¾\\".contains(char) || char.is_numeric();
    let mut runs = text.split(|char: char| !char.is_ascii_alphabetic());
    let is_word = |run: &str| {
        let known = [
            "sqrt", "frac", "mathrm", "text", "theta", "omega", "Omega", "alpha", "zeta",
        ];
        run.len() >= WORD && !known.contains(&run)
    };
    if !text.contains(is_sign) || runs.any(is_word) {
        return None;
    }
    let mut lexicon = Lexicon::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (length, name) = letter(rest).unwrap_or((first.len_utf8(), String::new()));
        rest = &rest[length..];
        if name.is_empty() || first.is_ascii_digit() {
            continue;
        }
        let is_index = |char: char| matches!(char, '₀'..='₉' | '0'..='9' | '_');
        let behind = rest.trim_start_matches(is_index);
        let indices = &rest[..rest.len() - behind.len()];
        let digits = indices
            .char_indices()
            .filter_map(|(at, _)| letter(&indices[at..]));
        let name = digits.fold(name, |name, (_, digit)| name + &digit);
        lexicon.allow(&Name::new(name.as_str()), symbol(&name), false);
        rest = behind;
    }
    Some(lexicon)
}
