//! The known name that a mistyped one was meant to be.

/// The candidate that is nearest to `word`, if one is near: at most a third of its letters differ, or one of
/// them begins with the other.
///
/// ```
/// use vibank_source::nearest;
/// assert_eq!(nearest("omgea_n", ["m", "omega_n", "omega_d"]), Some("omega_n"));
/// assert_eq!(nearest("omega", ["m", "omega_n"]), Some("omega_n"));
/// assert_eq!(nearest("q", ["alpha", "beta"]), None);
/// ```
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = word.chars().take(MAX_LENGTH).collect();
    let limit = (letters.len() / 3).max(1);
    let is_begun = |candidate: &str| {
        !candidate.is_empty() && (candidate.starts_with(word) || word.starts_with(candidate))
    };
    let mut found: Option<(usize, &str)> = None;
    for candidate in candidates {
        let limit = if is_begun(candidate) {
            limit.max(3)
        } else {
            limit
        };
        // Only what is nearer than the nearest so far counts.
        let limit = match found {
            Some((0, _)) => break,
            Some((best, _)) => limit.min(best - 1),
            None => limit,
        };
        let Some(distance) = edit_distance(&letters, candidate.chars(), limit) else {
            continue;
        };
        if distance < candidate.chars().count() || (distance <= 3 && is_begun(candidate)) {
            found = Some((distance, candidate));
        }
    }
    found.map(|(_, candidate)| candidate)
}

/// Letters of a word that are compared.
const MAX_LENGTH: usize = 64;

/// The number of letters to insert, delete, replace or swap with their neighbour to make one word of another, where it is
/// at most `limit`; capitals of ASCII are like small letters, and only the first 64 letters count.
///
/// The distance of optimal string alignment, by rows, of which a limit needs few.
///
/// ```
/// use vibank_source::edit_distance;
/// let letters: Vec<char> = "omgea".chars().collect();
/// assert_eq!(edit_distance(&letters, "omega".chars(), 2), Some(1));
/// assert_eq!(edit_distance(&letters, "Omega_n".chars(), 2), None);
/// ```
pub fn edit_distance(
    left: &[char],
    right: impl IntoIterator<Item = char>,
    limit: usize,
) -> Option<usize> {
    let mut letters = ['\0'; MAX_LENGTH];
    let mut length = 0;
    for (place, letter) in letters.iter_mut().zip(right) {
        *place = letter;
        length += 1;
    }
    let left = &left[..left.len().min(MAX_LENGTH)];
    let right = &letters[..length];
    if left.len().abs_diff(length) > limit {
        return None;
    }
    let mut before = [0; MAX_LENGTH + 1];
    let mut previous: [usize; MAX_LENGTH + 1] = std::array::from_fn(|place| place);
    for (i, a) in left.iter().enumerate() {
        let mut row = [0; MAX_LENGTH + 1];
        row[0] = i + 1;
        for (j, b) in right.iter().enumerate() {
            let replace = previous[j] + usize::from(!a.eq_ignore_ascii_case(b));
            let mut best = replace.min(previous[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && *a == right[j - 1] && left[i - 1] == *b {
                best = best.min(before[j - 1] + 1);
            }
            row[j + 1] = best;
        }
        // A swap reaches over two rows; what is beyond the limit in both stays there.
        let is_beyond =
            |row: &[usize; MAX_LENGTH + 1]| row[..=length].iter().all(|own| *own > limit);
        if is_beyond(&row) && is_beyond(&previous) {
            return None;
        }
        before = std::mem::replace(&mut previous, row);
    }
    Some(previous[length]).filter(|distance| *distance <= limit)
}
