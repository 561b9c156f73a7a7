//! The known name that a mistyped one was meant to be.

/// The candidate that is nearest to `word`, if one is near: at most a third of its letters differ, or one of
/// them begins with the other.
///
/// ```
/// use vibank::source::nearest;
/// assert_eq!(nearest("omgea_n", ["m", "omega_n", "omega_d"]), Some("omega_n"));
/// assert_eq!(nearest("omega", ["m", "omega_n"]), Some("omega_n"));
/// assert_eq!(nearest("q", ["alpha", "beta"]), None);
/// ```
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = word.chars().take(64).collect();
    let limit = (letters.len() / 3).max(1);
    let is_begun = |candidate: &str| {
        !candidate.is_empty() && (candidate.starts_with(word) || word.starts_with(candidate))
    };
    candidates
        .into_iter()
        .map(|candidate| (distance(&letters, candidate), candidate))
        .filter(|(distance, candidate)| {
            let is_near = *distance <= limit && *distance < candidate.chars().count();
            is_near || (*distance <= 3 && is_begun(candidate))
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Number of letters to insert, delete, replace or swap with their neighbour.
fn distance(left: &[char], right: &str) -> usize {
    let right: Vec<char> = right.chars().take(64).collect();
    let mut before: Vec<usize> = Vec::new();
    let mut previous: Vec<usize> = (0..=right.len()).collect();
    for (i, a) in left.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, b) in right.iter().enumerate() {
            let replace = previous[j] + usize::from(!a.eq_ignore_ascii_case(b));
            let mut best = replace.min(previous[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && *a == right[j - 1] && left[i - 1] == *b {
                best = best.min(before[j - 1] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut previous, row);
    }
    previous[right.len()]
}
