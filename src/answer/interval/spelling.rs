//! Signs and words that join, in one spelling.

/// One spelling for signs and words that join.
pub(super) fn normalized(response: &str) -> String {
    let response = response.trim().trim_end_matches(['.', ',', ';']);
    let inner = response
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'))
        .filter(|inner| inner.contains(['<', '>', '≤', '≥']) && !inner.contains(['(', ')']));
    let response = inner.unwrap_or(response);
    let response = within_set(response).unwrap_or(response);
    let response = CONDITIONS
        .iter()
        .find_map(|word| response.strip_prefix(word)?.strip_prefix(' '))
        .unwrap_or(response);
    let called = called(response).or_else(|| onwards(response));
    let response = called.as_deref().unwrap_or(response);
    let mut text = format!(" {response} ");
    for (from, to) in [
        ("||", " ∪ "),
        (" & ", " ∩ "),
        (" union ", " ∪ "),
        (" or ", " ∪ "),
        (" and ", " ∩ "),
        (" in ", " ∈ "),
    ] {
        text = text.replace(from, to);
    }
    // A comma between two intervals or inequalities joins them as well.
    for close in [")", "]", "["] {
        for open in ["(", "[", "]"] {
            for join in [", ", ",", "; ", ";", "U", "u", " U ", " u "] {
                text = text.replace(
                    &format!("{close}{join}{open}"),
                    &format!("{close} ∪ {open}"),
                );
            }
        }
    }
    // `[0, 1[ m U ]2, 3] m`
    for open in ["(", "[", "]"] {
        text = text.replace(&format!(" U {open}"), &format!(" ∪ {open}"));
    }
    text.trim().to_owned()
}

/// `Interval(0.2, oo)` of SymPy, `Interval[{0.2, 1}]` of Mathematica, `RealRange(0.2, 1)` of Maple: closed intervals; and
/// `Interval.open(0, 1)`, `Interval.Lopen(0, 1)`, `Interval.Ropen(0, 1)`.
fn called(text: &str) -> Option<String> {
    const CALLS: [(&str, &str, &str, [char; 2]); 6] = [
        ("Interval.open(", ")", "(", ['(', ')']),
        ("Interval.Lopen(", ")", "(", ['(', ']']),
        ("Interval.Ropen(", ")", "(", ['[', ')']),
        ("Interval(", ")", "(", ['[', ']']),
        ("RealRange(", ")", "(", ['[', ']']),
        ("Interval[{", "}]", "[", ['[', ']']),
    ];
    let (lead, call) = match text.find("Interval").or_else(|| text.find("RealRange")) {
        Some(at) => text.split_at(at),
        None => return None,
    };
    CALLS.iter().find_map(|(open, close, bracket, [from, to])| {
        let inner = call.strip_prefix(open)?.strip_suffix(close)?;
        (!inner.contains(bracket)).then(|| format!("{lead}{from}{inner}{to}"))
    })
}

/// `0.2 or more`, `from 0.2 on`, `from 0.2 to infinity`.
fn onwards(text: &str) -> Option<String> {
    const BEHIND: [(&str, char); 8] = [
        (" or more", '≥'),
        (" or greater", '≥'),
        (" or larger", '≥'),
        (" or above", '≥'),
        (" or less", '≤'),
        (" or smaller", '≤'),
        (" or lower", '≤'),
        (" or below", '≤'),
    ];
    let from = |text: &str| {
        let bound = text.strip_prefix("from ")?;
        let ends = [
            " on",
            " onwards",
            " upwards",
            " to ∞",
            " to infinity",
            " to inf",
        ];
        ends.iter()
            .find_map(|end| bound.strip_suffix(end))
            .map(|bound| format!("≥ {bound}"))
    };
    let behind = || {
        BEHIND.iter().find_map(|(words, sign)| {
            let bound = text.strip_suffix(words)?;
            Some(format!("{sign} {bound}"))
        })
    };
    let has_more = |text: &str| text.contains(['<', '>', '≤', '≥', '=', '∈', '[', ']']);
    from(text).or_else(behind).filter(|_| !has_more(text))
}

/// Words before a condition.
const CONDITIONS: [&str; 6] = ["for", "if", "when", "whenever", "only if", "wenn"];

/// The condition of a set in braces, `{x | 0 < x < 3}`.
fn within_set(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('{')?.strip_suffix('}')?;
    let (element, condition) = inner.split_once(['|', ':'])?;
    let has_relation = |text: &str| text.contains(['<', '>', '≤', '≥']);
    (!has_relation(element) && (has_relation(condition) || condition.contains('∈')))
        .then_some(condition)
}

/// What stands in brackets around a whole condition, and what follows them.
pub(super) fn unbracketed(text: &str) -> Option<(&str, &str)> {
    let inner = text.strip_prefix('(')?;
    let mut depth = 1_usize;
    let close = inner.char_indices().find_map(|(at, char)| {
        match char {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        (depth == 0).then_some(at)
    })?;
    let (inner, behind) = (&inner[..close], inner[close + 1..].trim());
    let has_relation = |text: &str| text.contains(['<', '>', '≤', '≥']);
    (has_relation(inner) && !has_relation(behind)).then_some((inner.trim(), behind))
}

/// Signs that join, as they are typed.
pub(super) fn spelt(text: &str) -> String {
    let text = text.trim().replace('∩', "and").replace('∪', "or");
    text.replace('∈', "in")
}
