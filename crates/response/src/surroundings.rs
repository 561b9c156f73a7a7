//! What people say around an answer: "so", "the answer is", quotation marks.

use std::ops::Range;

use super::list::cut;
use super::signs::{QUOTES, is_minus};
use super::words::{ASIDES, LEADS, TRAILS, WITHDRAWALS};
use vibank_formula::unit::Unit;
use vibank_source::{Span, lower};

/// Where the answer stands in what was typed.
pub(crate) fn answer_in(typed: &str) -> Range<usize> {
    let mut range = 0..typed.len();
    loop {
        let own = trimmed(typed, &range);
        let text = &typed[own.clone()];
        let inner = lead(text)
            .or_else(|| definition(text))
            .or_else(|| number_of_item(text))
            .map(|length| own.start + length..own.end)
            .or_else(|| trail(text).map(|length| own.start..own.end - length))
            .or_else(|| quotes(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| program(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| bracketed(text).then(|| own.start + 1..own.end - 1));
        match inner {
            Some(inner) => range = inner,
            None => return range,
        }
    }
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
    let bare = |word: &str| lower(word.trim_matches(['(', ')', '.', ',', '!', ':', ';']));
    let first = typed.split_whitespace().next();
    let last = typed.split_whitespace().next_back();
    let mut ends = [first, last].into_iter().flatten();
    ends.find(|word| WITHDRAWALS.contains(&bare(word).as_str()))
}

fn trimmed(typed: &str, range: &Range<usize>) -> Range<usize> {
    let text = &typed[range.clone()];
    let start = range.start + text.len() - text.trim_start().len();
    start..start + text.trim().len()
}

/// What comes after words, however they are spaced; `is_same` says when two words are.
pub(crate) fn behind_words<'t>(
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

/// The length of words before an answer, with the colon or the space after them.
fn lead(text: &str) -> Option<usize> {
    let first = text.chars().next()?;
    if first.is_ascii_digit() || "-+.([{$<".contains(first) && !text.starts_with("->") {
        return None;
    }
    LEADS.iter().find_map(|lead| {
        // Most answers begin with another letter than any of these words.
        let is_it = lead.as_bytes()[0].eq_ignore_ascii_case(&text.as_bytes()[0]);
        let behind = is_it
            .then(|| behind_words(text, lead, str::eq_ignore_ascii_case))
            .flatten()?;
        // The French set a space before a colon; `Hence, x = 3` has a comma.
        let behind = match behind.trim_start_matches(' ').strip_prefix(':') {
            Some(behind) => behind,
            None => {
                let behind = behind.strip_prefix(',').unwrap_or(behind);
                behind.starts_with(' ').then_some(behind)?
            }
        };
        // `=> 3` is at least three where nothing else relates.
        let relates =
            || behind.contains(['=', '<', '>', '≤', '≥', '≈', '∈']) || behind.contains(" in ");
        let is_lead = !behind.trim().is_empty() && (*lead != "=>" || relates());
        is_lead.then(|| text.len() - behind.len())
    })
}

/// The length of a number or letter before an answer, as the parts of a sheet have: `1) 5 m`, `(a) x = 5 m`, `1. -5 m`.
fn number_of_item(text: &str) -> Option<usize> {
    let open = usize::from(text.starts_with('('));
    let label = text[open..].chars().next()?;
    let behind = &text[open + label.len_utf8()..];
    let is_number = label.is_ascii_digit();
    if !is_number && !('a'..='h').contains(&label) || !enumeration(text).is_empty() {
        return None;
    }
    let begins_value = |behind: &str| {
        let behind = behind.trim_start();
        let unsigned = behind.strip_prefix(is_minus).unwrap_or(behind);
        unsigned.starts_with(|next: char| next.is_ascii_digit())
    };
    let (is_label, behind) = if let Some(behind) = behind.strip_prefix(')') {
        // Of a choice, `a) static`, letters are answers. `(2) x` may be a product; `(1) 5 m` is the same either way.
        let is_statement = behind.contains('=') || begins_value(behind);
        // The brackets of `1) 5 m 2) 6 m` are of several answers.
        let is_one = behind.matches('(').count() == behind.matches(')').count();
        let may_be_label = !is_number || label == '1';
        let is_sure = is_number && open == 0 || may_be_label && is_statement;
        (is_one && is_sure, behind)
    } else {
        let behind = behind.strip_prefix('.').filter(|_| open == 0)?;
        // `1. m` is a metre.
        let begins = behind
            .trim_start()
            .starts_with(|next: char| next.is_alphabetic() || next == '\\');
        let is_equation = label == '1' && begins && behind.contains('=');
        (is_number && (is_equation || begins_value(behind)), behind)
    };
    let is_apart = behind.starts_with(' ')
        && !behind.trim().is_empty()
        && !behind.trim_start().starts_with('=');
    (is_label && is_apart).then(|| text.len() - behind.len())
}

/// The labels of several answers, `1) … 2) …`, `(a) … (b) …`, `1. x = … 2. y = …`; none where that is not how the text
/// goes.
pub(crate) fn enumeration(text: &str) -> Vec<Range<usize>> {
    const STYLES: [(&str, char, &str); 5] = [
        ("", '1', ")"),
        ("(", '1', ")"),
        ("", 'a', ")"),
        ("(", 'a', ")"),
        ("", '1', "."),
    ];
    let start = text.trim_start();
    let head = start.strip_prefix('(').unwrap_or(start);
    let is_label = head.starts_with(['1', 'a']) && matches!(head.get(1..3), Some(") " | ". "));
    if !is_label {
        return Vec::new();
    }
    let mut found = STYLES.into_iter().map(|(open, first, close)| {
        let labels = labels(text, open, first, close);
        let are_labels = labels.len() > 1 && are_apart(text, &labels, close);
        labels.into_iter().filter(|_| are_labels).collect()
    });
    found
        .find(|labels: &Vec<_>| !labels.is_empty())
        .unwrap_or_default()
}

/// The labels of one style that follow each other in a text, the first one at its start.
fn labels(text: &str, open: &str, first: char, close: &str) -> Vec<Range<usize>> {
    const MAX_LABELS: u8 = 6;
    let (mut found, mut at) = (Vec::new(), text.len() - text.trim_start().len());
    for label in (0..MAX_LABELS).map(|place| char::from(first as u8 + place)) {
        let label = format!("{open}{label}{close} ");
        let place = if found.is_empty() {
            text[at..].starts_with(&label).then_some(at)
        } else {
            let next = text[at..].find(&format!(" {label}"));
            next.map(|place| at + place + 1)
        };
        let Some(place) = place else { break };
        at = place + label.len() - 1;
        found.push(place..at);
    }
    found
}

/// Whether a statement comes after each label: `(1) + (2) x` and `1. m + 2. m` are sums.
fn are_apart(text: &str, labels: &[Range<usize>], close: &str) -> bool {
    let ends = labels[1..]
        .iter()
        .map(|label| label.start)
        .chain([text.len()]);
    let mut pieces = labels
        .iter()
        .zip(ends)
        .map(|(label, end)| text[label.end..end].trim());
    pieces.all(|piece| {
        let goes_on = piece.ends_with(['+', '-', '*', '/', '=', '<', '>', '(', '^']);
        let is_statement =
            piece.contains('=') || piece.starts_with(|first: char| first.is_ascii_digit());
        // A number with a point is a label only where it can be no factor.
        let is_sure = close == ")" || is_statement || labels.len() > 2;
        !piece.is_empty() && !goes_on && is_sure
    })
}

/// Whether brackets stand around a whole statement, `(x = 3 m)`.
fn bracketed(text: &str) -> bool {
    let inner = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let Some(inner) =
        inner.filter(|inner| !inner.contains([',', ';', '<', '>', '≤', '≥', '!', '|']))
    else {
        return false;
    };
    let mut depth = 0_i32;
    let is_whole = inner.chars().all(|char| {
        depth += match char {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth >= 0
    });
    is_whole && inner.contains('=')
}

/// The length of a name that a function gets in a program, with what says of which argument it is one:
/// `x = lambda t:`, `f = @(t)`.
fn definition(text: &str) -> Option<usize> {
    const HEADS: &[&str] = &["lambda t:", "@(t)", "t ->", "t →", "t ↦"];
    let is_of_name = |char: char| char.is_alphanumeric() || "_()".contains(char);
    let start = text.trim_start();
    let behind = start.trim_start_matches(is_of_name);
    let is_name = behind.len() < start.len();
    let behind = behind.trim_start().strip_prefix(['=', ':'])?;
    let behind = behind.strip_prefix('=').unwrap_or(behind);
    let value = behind.trim_start();
    let body = HEADS.iter().find_map(|head| value.strip_prefix(head))?;
    (is_name && !body.trim().is_empty()).then(|| text.len() - body.len())
}

/// The lengths of what programs write around a function or a solution: `Function[t, …]`, `{{x -> …}}`.
fn program(text: &str) -> Option<(usize, usize)> {
    const HEADS: &[&str] = &["Function[t,", "Function[{t},", "Function[t_,"];
    let head = HEADS.iter().find(|head| text.starts_with(**head));
    if let Some(head) = head.filter(|_| text.ends_with(']')) {
        return Some((head.len(), 1));
    }
    let inner = text.strip_prefix('{')?.strip_suffix('}')?;
    // `{x1(t) = …, x2(t) = …}`, as Maple gives solutions.
    let is_set = || {
        let pieces = cut(inner, Span::new(0, inner.len()), &[',']);
        let is_equation = |piece: &Span| {
            let text = &inner[piece.range()];
            text.contains('=') && !text.contains(['<', '>', '!', '|', '{', '}'])
        };
        pieces.len() > 1 && pieces.iter().all(is_equation)
    };
    (text.contains("->") && !inner.is_empty() || is_set()).then_some((1, 1))
}

/// The length of words after an answer, of a remark in brackets, of a semicolon, or of a comma.
fn trail(text: &str) -> Option<usize> {
    // The sentence may end after them.
    let ended = text.strip_suffix('.').map_or(text, str::trim_end);
    let of_words = |text: &'_ str| TRAILS.iter().find(|trail| text.ends_with(**trail));
    let found = of_words(text).map(|words| (text, words));
    if let Some((own, words)) = found.or_else(|| Some((ended, of_words(ended)?))) {
        let before = &own[..own.len() - words.len()];
        let is_apart = before.ends_with([' ', ')', ']']) || words.starts_with(',');
        return is_apart.then(|| text.len() - before.len());
    }
    // A row of LaTeX that none follows.
    if text.ends_with("\\\\") {
        return Some(2);
    }
    if let Some(length) = comment(text) {
        return Some(length);
    }
    if let Some((before, aside)) = text
        .strip_suffix(')')
        .and_then(|text| text.rsplit_once(" ("))
    {
        let is_number = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
        let mut words = aside.split_whitespace();
        let is_said = words.all(|word| is_number(word) || ASIDES.contains(&word));
        // `12 (in)` has inches.
        let says_nothing = |word: &str| is_number(word) || ["in", "to"].contains(&word);
        let is_aside = is_said && !aside.split_whitespace().all(says_nothing);
        return is_aside.then(|| text.len() - before.len());
    }
    if let Some(before) = text.strip_suffix('!') {
        // `3!` is a factorial. The French set a space before the mark.
        let ends =
            |last: char| last.is_alphabetic() || before.ends_with(' ') && ")]}°²³".contains(last);
        return before.trim_end().ends_with(ends).then_some(1);
    }
    if let Some(before) = text.strip_suffix(';') {
        let ends = |last: char| last.is_alphanumeric() || ")]}°%²³'".contains(last);
        return before.trim_end().ends_with(ends).then_some(1);
    }
    let before = text.strip_suffix(',')?;
    before.ends_with(char::is_alphanumeric).then_some(1)
}

/// The length of a comment of a program, `# checked`, `// by Newton`. One that is a unit or says where it is measured is
/// more than that, and `k1 // k2` are springs in parallel.
fn comment(text: &str) -> Option<usize> {
    /// Longer words are no symbols of units.
    const MAX_UNIT: usize = 5;
    // Most responses have neither sign, and a search for two letters takes longer than one for their bytes.
    if !text.bytes().any(|byte| b"#/".contains(&byte)) {
        return None;
    }
    let (before, comment) = text.split_once(" # ").or_else(|| text.split_once(" // "))?;
    // A word after `//` that is as short as a letter of a formula may be one.
    let word = comment.split([' ', ',', ':']).next().unwrap_or(comment);
    let is_word =
        word.starts_with(char::is_alphabetic) && (text.contains(" # ") || word.chars().count() > 2);
    let is_unit = comment.len() <= MAX_UNIT && Unit::read(comment).is_ok();
    (is_word && !is_unit && !before.trim().is_empty()).then(|| text.len() - before.len())
}

/// The lengths of the marks around an answer.
fn quotes(text: &str) -> Option<(usize, usize)> {
    QUOTES.iter().find_map(|(open, close)| {
        let inner = text.strip_prefix(open)?.strip_suffix(close)?;
        let is_whole = !inner.trim().is_empty() && !inner.contains(open) && !inner.contains(close);
        is_whole.then_some((open.len(), close.len()))
    })
}

#[cfg(test)]
mod tests {
    use super::{answer_in, enumeration, withdrawn};

    #[test]
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
