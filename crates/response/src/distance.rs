//! Distances of a name from a place, `|x - 3 mm|`.

use super::Passage;

/// The two terms of a distance, and whether the second one is subtracted.
pub(crate) fn distance(text: &str) -> Option<([Passage<'_>; 2], bool)> {
    let framed = |open: &str, close: char| text.strip_prefix(open)?.strip_suffix(close);
    let inner = framed("|", '|').or_else(|| framed("abs(", ')'))?;
    if inner.contains(['|', '(', ')', '[', ']']) {
        return None;
    }
    let mut signs = inner.match_indices(['+', '-']).filter(|(at, _)| {
        let before = inner[..*at].trim_end();
        // `1e-3` has one in it, and so has `10^-3`.
        let is_exponent = before.ends_with(['e', 'E']) && before.len() == *at;
        !before.is_empty() && !is_exponent && !before.ends_with(['^', '*', '/', '+', '-'])
    });
    let (at, sign) = signs.next().filter(|_| signs.next().is_none())?;
    let terms = [&inner[..at], &inner[at + sign.len()..]].map(Passage::of);
    Some((terms, sign == "-"))
}

#[cfg(test)]
mod tests {
    use super::distance;

    #[test]
    fn a_distance_has_two_terms() {
        let shown = |text: &str| {
            let ([one, other], is_less) = distance(text)?;
            Some(format!("{one}; {other}; {is_less}"))
        };
        for (typed, terms) in [
            ("|x0 - 92.5 mm|", Some("x0; 92.5 mm; true")),
            ("|x0 + 1e-3 m|", Some("x0; 1e-3 m; false")),
            ("abs(3 mm - x)", Some("3 mm; x; true")),
            ("|-3 mm - x|", Some("-3 mm; x; true")),
            ("|x - a - b|", None),
            ("|x|", None),
            ("x - 3 mm", None),
        ] {
            assert_eq!(shown(typed).as_deref(), terms, "{typed}");
        }
    }
}
