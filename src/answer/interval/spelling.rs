//! Signs and words that join, in one spelling.

/// One spelling for signs and words that join.
pub(super) fn normalized(response: &str) -> String {
    let response = response.trim().trim_end_matches(['.', ',', ';']);
    let inner = response
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'))
        .filter(|inner| inner.contains(['<', '>', '≤', '≥']) && !inner.contains(['(', ')']));
    let mut text = format!(" {} ", inner.unwrap_or(response));
    for (from, to) in [
        ("||", " ∪ "),
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
    text.trim().to_owned()
}

/// Signs that join, as they are typed.
pub(super) fn spelt(text: &str) -> String {
    let text = text.trim().replace('∩', "and").replace('∪', "or");
    text.replace('∈', "in")
}
