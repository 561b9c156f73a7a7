//! When or where an answer holds: `v_max = 0.8 m/s at x = 0`, `x1 = 2mg/k for v = 0`.

use super::after::ends_in_value;
use crate::signs::{is_apostrophe, is_minus};
use crate::words::CIRCUMSTANCES;

/// The length of what says of an answer when or where it holds, with its word and the comma before it. What says of a
/// letter of the answer what it is stays: `c/(2√(km)) for k = k1 + k2`.
pub(crate) fn circumstance(text: &str) -> Option<usize> {
    if !text.contains('=') {
        return None;
    }
    let found = CIRCUMSTANCES.iter().filter_map(|word| {
        let places = text.match_indices(word).map(|(at, _)| at);
        let is_apart =
            |at: &usize| text[..*at].ends_with(' ') && text[at + word.len()..].starts_with(' ');
        Some((places.filter(is_apart).last()?, *word))
    });
    let (at, word) = found.max()?;
    let before = text[..at].trim_end().trim_end_matches(',').trim_end();
    let (subject, value) = text[at + word.len()..].split_once('=')?;
    let (subject, value) = (subject.trim(), value.trim());
    let relates = |text: &str| text.contains(['=', '<', '>', '≤', '≥', ';', '\n']);
    let is_of_name = |char: char| char.is_alphanumeric() || "_{}\\".contains(char);
    let is_name = subject.starts_with(|first: char| first.is_alphabetic() || first == '\\')
        && subject
            .chars()
            .all(|char| is_of_name(char) || is_apostrophe(char) || "\u{307}\u{308}".contains(char));
    if !is_name || value.is_empty() || relates(value) {
        return None;
    }
    let body = before.split_once('=').map_or(before, |(_, body)| body);
    let is_statement = !body.trim().is_empty() && !relates(before.replacen('=', "", 1).as_str());
    let begins = |first: char| first.is_ascii_digit() || "(√\\.".contains(first) || is_minus(first);
    let is_answer = before.contains('=') || body.trim_start().starts_with(begins);
    let name = before.split_once('=').map_or("", |(name, _)| name.trim());
    let is_free = if name.is_empty() || name.chars().all(is_of_name) {
        ends_in_value(body.trim()) || !body.contains(subject)
    } else {
        !before.contains(subject)
    };
    (is_statement && is_answer && is_free).then(|| text.len() - before.len())
}

#[cfg(test)]
mod tests {
    use super::circumstance;

    #[test]
    fn when_an_answer_holds_is_no_part_of_it() {
        for (typed, answer) in [
            ("v_max = 0.804 m/s at x = 0", "v_max = 0.804 m/s"),
            ("-21.4 J at θ=0", "-21.4 J"),
            ("x1 = 2(1-μ)mg/k for v = 0", "x1 = 2(1-μ)mg/k"),
            ("x_st = mg/k, when x'' = 0", "x_st = mg/k"),
            ("t = 0.3 s at s = 5 cm", "t = 0.3 s"),
            ("m y'' + k y = 0 at x = 0", "m y'' + k y = 0"),
            (
                "x'' + ω^2 x = 0, where ω = 3",
                "x'' + ω^2 x = 0, where ω = 3",
            ),
            (
                "ζ = c/(2√(km)) for k = k1 + k2",
                "ζ = c/(2√(km)) for k = k1 + k2",
            ),
            ("unstable at θ = π", "unstable at θ = π"),
            ("x in mm = 5", "x in mm = 5"),
            ("2 t for t < 1; 3 for t = 1", "2 t for t < 1; 3 for t = 1"),
            ("F = k x with x = m g/k", "F = k x with x = m g/k"),
            ("V = A at x = y = 0", "V = A at x = y = 0"),
        ] {
            let length = circumstance(typed).unwrap_or(0);
            assert_eq!(&typed[..typed.len() - length], answer, "{typed}");
        }
    }
}
