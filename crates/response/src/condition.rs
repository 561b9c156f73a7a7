//! Conditions that are said of a formula: `√(ω_n² - 2λ²) for ζ < 1/√2`, `M/l (uniform)`.

use super::words::{CONDITIONS, TURNING};
use vibank_source::lower;

/// What comes before the condition or the remark in words after a formula; none where a word turns what it says.
pub(crate) fn before(text: &str) -> Option<&str> {
    let text = text.trim_end_matches(['.', ' ']);
    let bracketed = text
        .strip_suffix(')')
        .and_then(|text| text.rsplit_once(" ("));
    let before = match bracketed {
        Some((before, said)) if is_condition(said) || is_remark(said) => Some(before),
        _ => CONDITIONS.iter().find_map(|word| {
            let (before, said) = text.split_once(&format!(" {word} "))?;
            compares(said).then_some(before)
        }),
    };
    let before = before?.trim_end().trim_end_matches(',').trim_end();
    (!before.is_empty()).then_some(before)
}

/// Whether a text begins with a word of conditions, and compares.
fn is_condition(said: &str) -> bool {
    let begins = |word: &str| {
        said.strip_prefix(word)
            .is_some_and(|rest| rest.starts_with(' '))
    };
    CONDITIONS.iter().any(|word| begins(word)) && compares(said)
}

fn compares(said: &str) -> bool {
    said.contains(['<', '>', '≤', '≥'])
}

/// Whether a text is of words alone, none of which says that the value is another one.
fn is_remark(said: &str) -> bool {
    /// Shorter words may be letters of a formula.
    const MIN_LETTERS: usize = 5;
    let mut words = said.split_whitespace();
    let is_word = |word: &str| word.chars().all(|char| char.is_alphabetic() || char == '-');
    let turns = |word: &str| TURNING.contains(&lower(word).as_str()) || lower(word) == "not";
    words
        .clone()
        .any(|word| word.chars().count() >= MIN_LETTERS)
        && words.all(|word| is_word(word) && !turns(word))
}

#[cfg(test)]
mod tests {
    use super::before;

    #[test]
    fn a_condition_is_no_part_of_a_formula() {
        for (typed, formula) in [
            ("sqrt(w^2 - 2λ^2), if w² > 2λ²", Some("sqrt(w^2 - 2λ^2)")),
            ("sqrt(a) for ζ < 1/√2", Some("sqrt(a)")),
            ("sqrt(a) (provided ζ<0.707)", Some("sqrt(a)")),
            ("M/l (uniform)", Some("M/l")),
            ("m g (upwards)", None),
            ("m g (not uniform)", None),
            ("2 (a + b)", None),
            ("a sin (omega t)", None),
            ("k/m for", None),
            ("k/m for m", None),
        ] {
            assert_eq!(before(typed), formula, "{typed}");
        }
    }
}
