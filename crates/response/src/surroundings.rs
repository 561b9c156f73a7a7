//! What people say around an answer: "so", "the answer is", quotation marks.

mod after;
mod around;
mod before;
mod numbered;

use std::ops::Range;

use self::after::trail;
use self::around::{bracketed, fence, program, quotes};
use self::before::{bullet, definition, described, lead, named_equation, remark_before};
pub(crate) use self::numbered::enumeration;
use self::numbered::number_of_item;
use super::words::WITHDRAWALS;
use vibank_source::is_lower;

/// Where the answer stands in what was typed.
pub(crate) fn answer_in(typed: &str) -> Range<usize> {
    /// More layers than anybody puts around an answer.
    const MAX_LAYERS: usize = 24;
    let mut range = 0..typed.len();
    for _ in 0..MAX_LAYERS {
        let own = trimmed(typed, &range);
        let text = &typed[own.clone()];
        let inner = lead(text)
            .or_else(|| described(text))
            .or_else(|| named_equation(text))
            .or_else(|| remark_before(text))
            .or_else(|| bullet(text))
            .or_else(|| definition(text))
            .or_else(|| number_of_item(text))
            .map(|length| own.start + length..own.end)
            .or_else(|| trail(text).map(|length| own.start..own.end - length))
            .or_else(|| quotes(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| fence(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| program(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| bracketed(text).then(|| own.start + 1..own.end - 1));
        match inner {
            Some(inner) => range = inner,
            None => return range,
        }
    }
    range
}

/// What comes after the arrow with which a response begins, `=> 5 m`, where none asks for a bound.
pub fn behind_arrow(typed: &str) -> &str {
    let behind = typed.strip_prefix("=>").map(str::trim_start);
    behind.filter(|behind| !behind.is_empty()).unwrap_or(typed)
}

/// The words or the mark by which a response takes itself back: `~~5 m~~`, and where words are none of what may be
/// answered, `wrong: 5 m`, `5 m is wrong`.
pub fn withdrawn(typed: &str, may_be_words: bool) -> Option<&str> {
    // Two spaces of LaTeX come after what they part, a mark that strikes out before what it strikes.
    let struck = typed.match_indices("~~").find(|(at, mark)| {
        let behind = &typed[at + mark.len()..];
        let opens = typed[..*at]
            .chars()
            .next_back()
            .is_none_or(char::is_whitespace);
        let inner = behind.split_once("~~").map_or("", |(inner, _)| inner);
        opens && !inner.is_empty() && inner.trim() == inner && !inner.starts_with(['=', '+', '-'])
    });
    if let Some((at, mark)) = struck {
        return Some(&typed[at..at + mark.len()]);
    }
    let is_alone = !typed.trim().contains(char::is_whitespace);
    if may_be_words || is_alone {
        return None;
    }
    let first = typed.split_whitespace().next();
    let last = typed.split_whitespace().next_back();
    let mut ends = [first, last].into_iter().flatten();
    ends.find(|word| {
        let word = word.trim_matches(['(', ')', '.', ',', '!', ':', ';']);
        WITHDRAWALS.iter().any(|own| is_lower(word, own))
    })
}

fn trimmed(typed: &str, range: &Range<usize>) -> Range<usize> {
    let text = &typed[range.clone()];
    let start = range.start + text.len() - text.trim_start().len();
    start..start + text.trim().len()
}

/// What comes after a word and the space after it.
pub(crate) fn behind_word<'t>(text: &'t str, word: &str) -> Option<&'t str> {
    text.strip_prefix(word)?.strip_prefix(' ')
}

/// What comes after words, however they are spaced; `is_same` says when two words are, at least by their first letter.
#[inline]
pub(crate) fn behind_words<'t>(
    text: &'t str,
    words: &str,
    is_same: impl Fn(&str, &str) -> bool,
) -> Option<&'t str> {
    // To part words at their spaces takes longer than to see that they begin with another letter, as most of a table do:
    // that alone is done in the loop over the table.
    if begin_alike(text, words) {
        behind_each(text, words, is_same)
    } else {
        None
    }
}

#[inline(never)]
fn behind_each<'t>(
    text: &'t str,
    words: &str,
    is_same: impl Fn(&str, &str) -> bool,
) -> Option<&'t str> {
    let mut rest = text;
    for (place, word) in words.split(' ').enumerate() {
        if place > 0 {
            rest = rest.strip_prefix(' ')?.trim_start_matches(' ');
        }
        let head = rest.get(..word.len())?;
        rest = is_same(head, word).then(|| &rest[word.len()..])?;
    }
    Some(rest)
}

/// Whether a text begins with a word.
// Of a table most words begin with another letter, and a comparison of texts is a call.
pub(crate) fn begins(text: &str, word: &str) -> bool {
    begin_alike(text, word) && text.starts_with(word)
}

/// Whether two texts may begin with the same letter, be it a capital in one of them.
#[inline]
fn begin_alike(text: &str, word: &str) -> bool {
    /// By which capital and small letters of ASCII differ.
    const CASE: u8 = 0x20;
    let first = text.as_bytes().first().zip(word.as_bytes().first());
    first.is_some_and(|(own, other)| (own ^ other) & !CASE == 0)
}

/// What stands before and after the last place of words.
// The search of the standard library prepares for long texts, which takes longer than to look through an answer.
fn split_at_last<'t>(text: &'t str, words: &str) -> Option<(&'t str, &'t str)> {
    let (text_bytes, own) = (text.as_bytes(), words.as_bytes());
    let last = text.len().checked_sub(words.len())?;
    let mut places = (0..=last).rev();
    let at = places.find(|at| text_bytes[*at] == own[0] && text_bytes[*at..].starts_with(own))?;
    Some((&text[..at], &text[at + words.len()..]))
}

#[cfg(test)]
mod tests {
    use super::{answer_in, enumeration, withdrawn};

    #[test]
    #[expect(clippy::too_many_lines, reason = "a table")]
    fn what_is_said_around_an_answer_is_no_part_of_it() {
        for (typed, answer) in [
            ("so ω = 5 rad/s", "ω = 5 rad/s"),
            ("The answer is 5 rad/s", "5 rad/s"),
            ("Answer: b", "b"),
            ("⇒ x = 3", "x = 3"),
            ("=> x = 3", "x = 3"),
            ("=> 3", "=> 3"),
            ("so, approx. 5", "5"),
            ("Hence, x = 3", "x = 3"),
            ("I got 5 m", "5 m"),
            ("Final answer: k/m", "k/m"),
            ("Lösung: k/m", "k/m"),
            ("-> 5 m", "5 m"),
            ("1) 5 m", "5 m"),
            ("1) 5 m 2) 6 m", "1) 5 m 2) 6 m"),
            ("a) -5 m", "-5 m"),
            ("(b) x = 5 m", "x = 5 m"),
            ("2) x = 5 m", "x = 5 m"),
            ("1. x'' = 0", "x'' = 0"),
            ("1. m", "1. m"),
            ("1. -5 m", "-5 m"),
            ("1. - 5 m", "1. - 5 m"),
            ("5 m # ok", "5 m"),
            ("I  get 5 m", "5 m"),
            ("5 m environ.", "5 m"),
            ("5 m approx.", "5 m"),
            ("5 m // Newton", "5 m"),
            ("(2) x = 5", "(2) x = 5"),
            ("(b) x + c", "(b) x + c"),
            ("a) static", "a) static"),
            ("a1) m x'' = -k x", "m x'' = -k x"),
            ("d2) (1, -0.5)", "(1, -0.5)"),
            ("b2) [1 2; 3 4]", "[1 2; 3 4]"),
            ("c2) k/m", "k/m"),
            ("a.1) 5 m", "5 m"),
            ("a1. x = 5 m", "x = 5 m"),
            ("a1. m", "a1. m"),
            ("(a1) m x'' = -k x", "m x'' = -k x"),
            ("(c1) x' + k x = 0", "(c1) x' + k x = 0"),
            ("a1) 5 m a2) 6 m", "a1) 5 m a2) 6 m"),
            ("a1 x) = 3", "a1 x) = 3"),
            ("a10) x", "a10) x"),
            ("Block 1: m x'' + k x = 0", "m x'' + k x = 0"),
            ("m1: m ẍ + k x = 0", "m ẍ + k x = 0"),
            ("eq. (2): m x'' + k x = 0", "m x'' + k x = 0"),
            ("2: m x'' + k x = 0", "m x'' + k x = 0"),
            ("ΣF = m a: -k x = m x''", "-k x = m x''"),
            ("k: m x'' = 0", "k: m x'' = 0"),
            ("2 k x: m + x'' = 0", "2 k x: m + x'' = 0"),
            ("mode 2: ω = 5 rad/s", "mode 2: ω = 5 rad/s"),
            ("m x'' + k x = 0 (block 1)", "m x'' + k x = 0"),
            ("m x'' + k x = 0 for cart 1", "m x'' + k x = 0"),
            ("m x'' + k x = 0 (x1, x2 to the right)", "m x'' + k x = 0"),
            (
                "m x'' + k x = F cos (omega t)",
                "m x'' + k x = F cos (omega t)",
            ),
            ("m x'' = -k (x double dot)", "m x'' = -k (x double dot)"),
            ("ω = 5 rad/s (mode 2)", "ω = 5 rad/s (mode 2)"),
            ("0 (translation)", "0"),
            ("[1 2; 3 4] (symmetric)", "[1 2; 3 4]"),
            ("19.4 rad/s (double)", "19.4 rad/s"),
            ("5 m (negative)", "5 m (negative)"),
            ("5 (metres)", "5 (metres)"),
            ("underdamped (double)", "underdamped (double)"),
            ("(1, -1), in phase", "(1, -1)"),
            ("k/m, in phase", "k/m, in phase"),
            ("k/m // from Newton", "k/m"),
            ("0.2 // mm", "0.2 // mm"),
            ("k1 // k2", "k1 // k2"),
            ("(x = 3 m)", "x = 3 m"),
            ("(x) = (3)", "(x) = (3)"),
            ("(x = 3, y = 2)", "(x = 3, y = 2)"),
            ("k/m ✓", "k/m"),
            ("k/m # checked", "k/m"),
            (r"k/m\\", "k/m"),
            ("5 m ;", "5 m"),
            ("so approx. 5 m (approx.)", "5 m"),
            ("\"5 m\"", "5 m"),
            ("“about 5 m”", "5 m"),
            ("**5**", "5"),
            ("5\"", "5\""),
            ("\"\"", "\"\""),
            ("k = 3 N/m,", "k = 3 N/m"),
            ("5,", "5"),
            ("5 m/s²;", "5 m/s²"),
            ("5; ;", "5; ;"),
            ("5 m (3 s.f.)", "5 m"),
            ("5 m (to 3 significant figures)", "5 m"),
            ("2 cos(3) (4)", "2 cos(3) (4)"),
            ("12 (in)", "12 (in)"),
            ("ζ = 0.285 (underdamped)", "ζ = 0.285"),
            ("121 mm (relaxed)", "121 mm"),
            ("20 mm (left)", "20 mm (left)"),
            ("20 (metres)", "20 (metres)"),
            ("2 sin(t) (in SI units)", "2 sin(t)"),
            ("lambda t: 2*t", "2*t"),
            ("x = lambda t: 2*t", "2*t"),
            ("f = @(t) 2*t", "2*t"),
            ("x(t) := t ↦ 2t", "2t"),
            ("x: t -> 2*t", "2*t"),
            ("Function[t, 2 t]", "2 t"),
            ("{{x -> 2}}", "x -> 2"),
            ("x = t", "x = t"),
            ("t -> 2*t", "2*t"),
            ("**Answer:** 5 m", "5 m"),
            ("**Answer**: x = 5 m", "x = 5 m"),
            ("**Final answer:** *5 m*", "5 m"),
            ("### Answer\nx = 5 m", "x = 5 m"),
            ("- **x = 5 m**", "x = 5 m"),
            ("- x = 5 m", "- x = 5 m"),
            ("- 5 m", "- 5 m"),
            ("* 5 m", "5 m"),
            ("> x = 5 m", "x = 5 m"),
            ("> 5 m", "> 5 m"),
            (">>> 5", "5"),
            ("Out[12]= 5", "5"),
            ("```\n5 m\n```", "5 m"),
            ("```python\nsqrt(k)\n```", "sqrt(k)"),
            ("__5 m__", "5 m"),
            ("2*x*", "2*x*"),
            ("\\text{so } x = 3", "x = 3"),
            ("\\text{kg}", "\\text{kg}"),
            ("Newton's second law: m x'' = -k x", "m x'' = -k x"),
            ("mode shape: (1, 2)", "(1, 2)"),
            ("above: x", "above: x"),
            ("theta: 3", "theta: 3"),
            ("so the answer is 5 m, since k = 3", "5 m"),
            ("5 m because k = 3", "5 m"),
            ("c as k", "c as k"),
            ("5 m (see above)", "5 m"),
            ("5 m (3sf)", "5 m"),
            ("0.4(dimensionless)", "0.4"),
            ("2 f(constant)", "2 f(constant)"),
            ("0.5 J per cycle", "0.5 J"),
            ("5 m [3 s.f.]", "5 m"),
            ("5 m to 3 s.f.", "5 m"),
            ("u = (1, 2), v = (3, 4)", "u = (1, 2), v = (3, 4)"),
            ("5 (newton metre)", "5 (newton metre)"),
            ("x (aperiodic)", "x (aperiodic)"),
            ("x = 0 (1)", "x = 0"),
            ("x = 0 (2)", "x = 0 (2)"),
            ("5 m✔", "5 m"),
            ("5 !", "5"),
            ("5!", "5!"),
            ("5 m?", "5 m"),
            ("?", "?"),
            ("k/m (see sheet 2)", "k/m"),
            ("la risposta è 5 m", "5 m"),
            ("答:5 m", "5 m"),
            ("所以 x = 5 m", "x = 5 m"),
            ("sons", "sons"),
            ("so", "so"),
        ] {
            assert_eq!(typed[answer_in(typed)].trim(), answer, "{typed}");
        }
    }

    #[test]
    fn what_is_taken_back_is_no_answer() {
        for (typed, mark) in [
            ("~~5 m~~", Some("~~")),
            ("6 m ~~5 m~~", Some("~~")),
            (r"x~~=~~5~~\mathrm{m}", None),
            ("x ~~=~~ 5", None),
            ("x ~~= 5~~m", None),
            ("~5 m", None),
            ("wrong: 5 m", Some("wrong:")),
            ("5 m is wrong.", Some("wrong.")),
            ("5 m (false)", Some("(false)")),
            ("false", None),
            ("5 m", None),
        ] {
            assert_eq!(withdrawn(typed, false), mark, "{typed}");
        }
        assert_eq!(withdrawn("the sign is wrong", true), None);
    }

    #[test]
    fn several_answers_bear_labels() {
        for (typed, labels) in [
            ("1) 5 m 2) 6 m", &["1)", "2)"][..]),
            ("(a) x = 5 m, (b) y = 6 m", &["(a)", "(b)"]),
            ("1. z = 0, 2. x = l", &["1.", "2."]),
            ("1. 5 m, 2. 6 m", &["1.", "2."]),
            ("1. ring 2. block 3. disk", &["1.", "2.", "3."]),
            ("1. m + 2. k", &[]),
            ("(1) + (2) x", &[]),
            ("1) 5 m", &[]),
            ("(a) (b)", &[]),
        ] {
            let found = enumeration(typed);
            let found: Vec<&str> = found.into_iter().map(|label| &typed[label]).collect();
            assert_eq!(found, labels, "{typed}");
        }
    }
}
