//! Signs and words that join, in one spelling.

/// One spelling for signs and words that join. Ranges in words, which say nothing of their ends, are read where that
/// does not count.
pub(crate) fn normalized(response: &str, is_strict: bool) -> String {
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
    let called = called(response)
        .or_else(|| onwards(response))
        .or_else(|| ranges(response).filter(|_| !is_strict));
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

/// `Interval(0.2, oo)` of SymPy, `Interval[{0.2, 1}]` of Mathematica, `RealRange(0.2, 1)` of Maple: closed intervals, those
/// of Maple with `Open(…)` around an end that is not; `Interval.open(0, 1)`, `Interval.Lopen(0, 1)`,
/// `Interval.Ropen(0, 1)`, and a `Union(…)` of such.
fn called(text: &str) -> Option<String> {
    const CALLS: [(&str, [&str; 2]); 7] = [
        ("Interval.open(", ["(", ")"]),
        ("Interval.Lopen(", ["(", "]"]),
        ("Interval.Ropen(", ["[", ")"]),
        ("Interval(", ["[", "]"]),
        ("RealRange(", ["[", "]"]),
        ("Interval[{", ["[", "]"]),
        ("Interval[", ["[", "]"]),
    ];
    if !text.contains("Interval") && !text.contains("RealRange") {
        return None;
    }
    let inner = text
        .strip_prefix("Union(")
        .and_then(|text| text.strip_suffix(')'));
    let mut plain = inner.unwrap_or(text).to_owned();
    for (open, [from, to]) in CALLS {
        while let Some(at) = plain.find(open) {
            let start = at + open.len();
            let length = closing(&plain[start..])?;
            let (inner, end) = (&plain[start..start + length], start + length);
            let end = end + if open.ends_with("[{") { 2 } else { 1 };
            let (low, high) = inner.split_once(',')?;
            let opened = |end: &str| {
                let end = end.trim().strip_prefix("Open(")?.strip_suffix(')')?;
                Some(end.to_owned())
            };
            let (from, low) = opened(low).map_or((from, low.to_owned()), |low| ("(", low));
            let (to, high) = opened(high).map_or((to, high.to_owned()), |high| (")", high));
            let interval = format!("{from}{low},{high}{to}");
            plain.replace_range(at..end.min(plain.len()), &interval);
        }
    }
    Some(plain)
}

/// How far it is to where the bracket closes that stands open before a text.
fn closing(inner: &str) -> Option<usize> {
    let mut depth = 1_usize;
    inner.char_indices().find_map(|(at, char)| {
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        (depth == 0).then_some(at)
    })
}

/// `0.2 or more`, `from 0.2 on`, `x from 0.2 to infinity`.
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
        let (lead, bound) = text.split_once("from ")?;
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
            .map(|bound| format!("{lead}≥ {bound}"))
    };
    let behind = || {
        BEHIND.iter().find_map(|(words, sign)| {
            let bound = text.strip_suffix(words)?;
            Some(format!("{sign} {bound}"))
        })
    };
    from(text).or_else(behind).filter(|_| !is_in_signs(text))
}

/// Ranges in words, joined by `or`, as intervals in brackets.
fn ranges(text: &str) -> Option<String> {
    if is_in_signs(text) {
        return None;
    }
    let text = text.replace(" and from ", " or from ").replace('∪', " or ");
    let ranges: Option<Vec<String>> = text.split(" or ").map(|text| range(text.trim())).collect();
    Some(ranges?.join(" ∪ "))
}

/// `from 0.2 to 0.5 m`, `x between 0.2 and 0.5`, `0.2 … 0.5` and `0.2-0.5`, with both ends.
fn range(text: &str) -> Option<String> {
    const WORDS: [(&str, &str); 2] = [("from ", " to "), ("between ", " and ")];
    const SIGNS: [&str; 4] = [" to ", "…", "...", ".."];
    let in_words = WORDS.iter().find_map(|(word, join)| {
        let (lead, ends) = text.split_once(word)?;
        let (low, high) = ends.split_once(join)?;
        Some((lead, low, high))
    });
    let in_signs = || {
        let (lead, ends) = text.rsplit_once(['=', ':']).unwrap_or(("", text));
        let is_value = |end: &str| {
            let unsigned = end.trim().trim_start_matches(['-', '+']);
            unsigned.starts_with(|first: char| first.is_ascii_digit() || first == '.')
        };
        let joined = SIGNS.iter().find_map(|sign| ends.split_once(sign));
        let (low, high) = joined.or_else(|| dashed(ends.trim()))?;
        (is_value(low) && is_value(high)).then_some((lead, low, high))
    };
    let (lead, low, high) = in_words.or_else(in_signs)?;
    let lead = lead.trim().trim_end_matches(['=', ':']).trim();
    let lead = if lead.is_empty() {
        String::new()
    } else {
        format!("{lead} ∈ ")
    };
    Some(format!("{lead}[{}; {}]", low.trim(), high.trim()))
}

/// The values around a dash, `0.2 m-0.5 m`, which is no sign of an exponent.
fn dashed(text: &str) -> Option<(&str, &str)> {
    let joins = |(at, _): &(usize, &str)| {
        let before = text[..*at].trim_end();
        let is_exponent = before.strip_suffix(['e', 'E']).is_some_and(|before| {
            before.ends_with(|last: char| last.is_ascii_digit() || last == '.')
        });
        before.ends_with(char::is_alphanumeric) && !is_exponent
    };
    let (at, dash) = text.match_indices('-').find(joins)?;
    Some((&text[..at], &text[at + dash.len()..]))
}

/// Whether signs say what the values are.
fn is_in_signs(text: &str) -> bool {
    text.contains(['<', '>', '≤', '≥', '[', ']', '∈'])
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
pub(crate) fn unbracketed(text: &str) -> Option<(&str, &str)> {
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
pub(crate) fn spelt(text: &str) -> String {
    let text = text.trim().replace('∩', "and").replace('∪', "or");
    text.replace('∈', "in")
}
