//! The one statement of a response that answers, among others that say what else is known: `k = 3 N/m, m = 2 kg`,
//! `with k = 3 N/m we get ω = 5 rad/s`, `v = 3 m/s at x = 0`.

use super::Passage;
use super::arguments::without_arguments;
use super::aside::changes;
use super::sides::is_word;
use super::signs::is_apostrophe;
use super::statements::{label, moved, statements_by, word_at};
use super::surroundings::behind_word;
use super::words::{CONCLUSIONS, PLACES};
use vibank_source::Span;

/// The only statement that `answers` among others, or the first one where it has no equals sign; one with the `whole`
/// symbol of what is asked counts beside complex numbers.
pub(crate) fn answering<'t>(
    text: &'t str,
    answers: impl Fn(Passage<'t>) -> bool,
    is_whole: impl Fn(Passage<'t>) -> bool,
) -> Option<Span> {
    // `x = 3 m or y = 4 m` leaves a choice, an inequality is one that counts.
    let is_open = has_alternatives(text) || text.contains(['<', '>', '≤', '≥']);
    if is_open {
        return None;
    }
    // `x1 : x2 = 1 : 2` is a ratio.
    let mut colon = text.split(':');
    let is_led = colon.next().is_some_and(|before| before.contains('='));
    let start = text.len() - text.strip_prefix("with ").unwrap_or(text).len();
    let all = statements_by(&text[start..], |rest| {
        word_at(rest).or_else(|| conclusion_at(rest).filter(|_| is_led || !rest.starts_with(':')))
    });
    let all: Vec<Span> = all.into_iter().map(|own| moved(own, start)).collect();
    // `5 m (= 6 m)` says two things of one.
    let goes_on = |own: &Span| text[own.range()].starts_with('=');
    // `5 m, it is negative`
    let alters = |own: &Span| {
        let mut words = text[own.range()].split_whitespace();
        let has_digit = text[own.range()].contains(|char: char| char.is_ascii_digit());
        !has_digit && words.any(changes)
    };
    if all.len() < 2 || all.iter().any(|own| goes_on(own) || alters(own)) {
        return None;
    }
    let label = |own: &Span| label(text, *own).map(|label| Passage::of(&text[label.range()]));
    let mut answering: Vec<&Span> = all.iter().collect();
    answering.retain(|own| label(own).is_some_and(&answers));
    // `Z = 3 - 4j, |Z| = 5 Ω`
    let is_whole = |own: &Span| label(own).is_some_and(&is_whole);
    let is_complex = |own: &Span| Passage::of(&text[own.range()]).may_be_complex();
    let is_either = |own: &&Span| is_whole(own) != is_complex(own);
    if answering.len() > 1 && answering.iter().all(is_either) {
        answering.retain(|own| is_whole(own));
    }
    // `V'' = 3 J at θ = 0` says where the only value holds.
    let is_condition = |own: &Span| {
        let before = text[..own.range().start].trim_end();
        PLACES.iter().any(|word| before.ends_with(word))
    };
    match answering[..] {
        [only] => label(&all[0]).map(|_| *only),
        [] if label(&all[0]).is_none() || all[1..].iter().all(is_condition) => Some(all[0]),
        _ => None,
    }
}

/// Whether a word leaves a choice between what it joins, `x = 3 m or y = 4 m`.
pub(crate) fn has_alternatives(text: &str) -> bool {
    text.split_whitespace().any(|word| word == "or")
}

/// The length of the word with which a text begins and that says where a value holds, `at x = 0`.
fn condition_at(text: &str) -> Option<usize> {
    let mut places = PLACES.iter();
    let (word, behind) = places.find_map(|word| Some((word, behind_word(text, word)?)))?;
    let (label, _) = behind.split_once('=')?;
    let label = label.trim().trim_end_matches(is_apostrophe);
    is_word(without_arguments(label)).then_some(word.len())
}

/// The length of what follows from what stands before it, `we get T = 3 s` and `: T = 3 s`.
fn conclusion_at(text: &str) -> Option<usize> {
    let word = CONCLUSIONS.iter().find(|word| text.starts_with(**word))?;
    let (label, _) = text[word.len()..].split_once('=')?;
    is_word(without_arguments(label.trim())).then_some(word.len())
}

/// A text without what says at its end where it holds, `x < 3 m at t = 0`.
pub(crate) fn without_condition(text: &str) -> &str {
    let mut spaces = text.match_indices(' ');
    let relates = |rest: &str| rest.contains(['<', '>', '≤', '≥']);
    let found = spaces.find(|(at, _)| {
        let rest = &text[at + 1..];
        condition_at(rest).is_some() && !relates(rest) && relates(&text[..*at])
    });
    found.map_or(text, |(at, _)| text[..at].trim_end_matches([' ', ',']))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_statement_answers() {
        let of = |text: &'static str| {
            let answers = |label: Passage<'_>| label.is("k") || label.is("|k|");
            answering(text, answers, |label| label.is("|k|")).map(|place| &text[place.range()])
        };
        for (typed, answer) in [
            ("k = 3 N/m, K = 4 N/m", Some("k = 3 N/m")),
            ("K = 4 N/m; k = 3 N/m", Some("k = 3 N/m")),
            ("K = 4 N/m so k = 3 N/m", Some("k = 3 N/m")),
            ("with T = 4 s we get k = 3 N/m", Some("k = 3 N/m")),
            ("with T = 4 s: k = 3 N/m", Some("k = 3 N/m")),
            ("k = 3 N/m (T = 4 s, f = 5 Hz)", Some("k = 3 N/m")),
            ("3 N/m (T = 4 s)", Some("3 N/m")),
            ("k = 3 N/m at x = 0", Some("k = 3 N/m")),
            ("V = 3 N/m at x = 0", Some("V = 3 N/m")),
            ("3 N/m, it = negative", None),
            ("3 N/m, the spring = soft", Some("3 N/m")),
            ("=aω;π", None),
            ("3 N/m (= 4 N/m)", None),
            ("ω = 9; k = 3 N/m", Some("k = 3 N/m")),
            ("ω = 9; ω = 10", None),
            ("x1 : k = 3 : 4", None),
            ("k = 3 - 4j, |k| = 5 N/m", Some("|k| = 5 N/m")),
            ("|k| = 5 N/m, k = 3 - 4j", Some("|k| = 5 N/m")),
            ("k = 6 N/m, |k| = 5 N/m", None),
            ("k = 3 - 4j, |k| = 5j", None),
            ("k = 3 N/m, k = 4 N/m", None),
            ("k = 3 N/m or K = 4 N/m", None),
            ("K = 3 N/m, T = 4 s", None),
            ("k > 3 N/m, T = 4 s", None),
            ("k = 3 N/m", None),
        ] {
            assert_eq!(of(typed), answer, "{typed}");
        }
    }
}
