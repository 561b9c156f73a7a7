//! What people say around an answer: "so", "the answer is", quotation marks.

use std::ops::Range;

use super::list::cut;
use super::signs::QUOTES;
use super::words::{ASIDES, LEADS, TRAILS, WITHDRAWALS};
use vibank_source::Span;

/// Where the answer stands in what was typed.
pub(super) fn answer_in(typed: &str) -> Range<usize> {
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

/// The words or the mark by which a response takes itself back: `~~5 m~~`, and where words are none of what may be
/// answered, `wrong: 5 m`, `5 m is wrong`.
pub fn withdrawn(typed: &str, may_be_words: bool) -> Option<&str> {
    // Two spaces of LaTeX stand behind what they part, a mark that strikes out before what it strikes.
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
    let bare = |word: &str| {
        word.trim_matches(['(', ')', '.', ',', '!', ':', ';'])
            .to_lowercase()
    };
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

/// The length of words before an answer, with the colon or the space behind them.
fn lead(text: &str) -> Option<usize> {
    let first = text.chars().next()?;
    if first.is_ascii_digit() || "-+.([{$<".contains(first) && !text.starts_with("->") {
        return None;
    }
    LEADS.iter().find_map(|lead| {
        // Most answers begin with another letter than any of these words.
        let is_it = lead.as_bytes()[0].eq_ignore_ascii_case(&text.as_bytes()[0])
            && text
                .get(..lead.len())
                .is_some_and(|head| head.eq_ignore_ascii_case(lead));
        let behind = text.get(lead.len()..).filter(|_| is_it)?;
        // The French set a space before a colon; `Hence, x = 3` has a comma.
        let behind = match behind.trim_start_matches(' ').strip_prefix(':') {
            Some(behind) => behind,
            None => {
                let behind = behind.strip_prefix(',').unwrap_or(behind);
                behind.starts_with(' ').then_some(behind)?
            }
        };
        // `=> 3` is at least three where nothing else relates.
        let relates = || behind.contains(['=', '<', '>', '≤', '≥', '≈']);
        let is_lead = !behind.trim().is_empty() && (*lead != "=>" || relates());
        is_lead.then(|| text.len() - behind.len())
    })
}

/// The length of a number before an answer, as the parts of a sheet have: `1) 5 m`.
fn number_of_item(text: &str) -> Option<usize> {
    let (number, behind) = text.split_once(')')?;
    let is_number = number.len() == 1 && number.starts_with(|digit: char| digit.is_ascii_digit());
    // The brackets of `1) 5 m 2) 6 m` are of several answers.
    let open = behind.matches('(').count();
    let is_one = open == behind.matches(')').count();
    // Equations are handed back with a remark of their own.
    let is_apart = behind.starts_with(' ') && !behind.trim().is_empty() && !behind.contains('=');
    (is_number && is_one && is_apart).then(|| text.len() - behind.len())
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

/// The length of words behind an answer, of a remark in brackets, of a semicolon, or of a comma.
fn trail(text: &str) -> Option<usize> {
    let words = TRAILS.iter().find(|trail| text.ends_with(**trail));
    if let Some(words) = words {
        let before = &text[..text.len() - words.len()];
        let is_apart = before.ends_with([' ', ')', ']']) || words.starts_with(',');
        return is_apart.then_some(words.len());
    }
    // A row of LaTeX that none follows.
    if text.ends_with("\\\\") {
        return Some(2);
    }
    // A comment of a program.
    if let Some((before, comment)) = text.rsplit_once(" # ")
        && comment.starts_with(char::is_alphabetic)
    {
        return Some(text.len() - before.len());
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
        // `3!` is a factorial.
        return before.ends_with(char::is_alphabetic).then_some(1);
    }
    if let Some(before) = text.strip_suffix(';') {
        let ends = |last: char| last.is_alphanumeric() || ")]}°%²³'".contains(last);
        return before.trim_end().ends_with(ends).then_some(1);
    }
    let before = text.strip_suffix(',')?;
    before.ends_with(char::is_alphanumeric).then_some(1)
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
    use super::{answer_in, withdrawn};

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
}
