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
    let distance_to = EditDistance::from_word(word);
    let limit = (distance_to.letters.len() / 3).max(1);
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
        let Some(distance) = distance_to.word(candidate.chars(), limit) else {
            continue;
        };
        if distance < candidate.chars().count() || (distance <= 3 && is_begun(candidate)) {
            found = Some((distance, candidate));
        }
    }
    found.map(|(_, candidate)| candidate)
}

/// The number of letters to insert, delete, replace or swap with their neighbour to make other words of one; capitals of
/// ASCII are like small letters, and only the first 64 letters count.
///
/// The distance of optimal string alignment. A column of its table is one word of bits (H. Hyyrö, "A bit-vector algorithm
/// for computing Levenshtein and Damerau edit distances", Nordic Journal of Computing 10, 2003), so that a mistyped
/// identity is compared with those of a whole bank in the time of a keystroke.
///
/// ```
/// use vibank_source::EditDistance;
/// let distance = EditDistance::from_word("omgea");
/// assert_eq!(distance.word("omega".chars(), 2), Some(1));
/// assert_eq!(distance.word("Omega_n".chars(), 2), None);
/// ```
pub struct EditDistance {
    letters: Vec<char>,
    /// The places of each letter of ASCII, small, as bits.
    places: [u64; 128],
}

/// Letters of a word that are compared: as many as a word of bits has places.
const MAX_LENGTH: usize = u64::BITS as usize;

impl EditDistance {
    /// The distances of this word.
    pub fn from_word(word: &str) -> Self {
        let letters = word.chars().take(MAX_LENGTH);
        let letters: Vec<char> = letters.map(|letter| letter.to_ascii_lowercase()).collect();
        let mut places = [0; 128];
        for (place, letter) in letters.iter().enumerate() {
            if let Some(own) = places.get_mut(*letter as usize) {
                *own |= 1 << place;
            }
        }
        Self { letters, places }
    }

    /// The distance to a word, where it is at most `limit`.
    pub fn word(&self, other: impl IntoIterator<Item = char>, limit: usize) -> Option<usize> {
        let mut other_letters = ['\0'; MAX_LENGTH];
        let mut length = 0;
        for (place, letter) in other_letters.iter_mut().zip(other) {
            *place = letter.to_ascii_lowercase();
            length += 1;
        }
        let count = self.letters.len();
        if count.abs_diff(length) > limit {
            return None;
        }
        let Some(last) = count.checked_sub(1) else {
            return Some(length);
        };
        // Where the distance grows and shrinks by one from a letter of this word to the next, for the other word so far.
        let (mut grows, mut shrinks) = (u64::MAX, 0_u64);
        let (mut diagonal, mut places_before) = (0_u64, 0_u64);
        let mut distance = count;
        for (done, letter) in other_letters[..length].iter().enumerate() {
            let places = self.places_of(*letter);
            let swaps = ((!diagonal & places) << 1) & places_before;
            let carried = (places & grows).wrapping_add(grows) ^ grows;
            diagonal = carried | places | shrinks | swaps;
            let across_grows = shrinks | !(diagonal | grows);
            let across_shrinks = diagonal & grows;
            distance += ((across_grows >> last) & 1) as usize;
            distance -= ((across_shrinks >> last) & 1) as usize;
            // Each of the letters that are left makes it smaller by one at most.
            if distance > limit + (length - done - 1) {
                return None;
            }
            let across_grows = (across_grows << 1) | 1;
            grows = (across_shrinks << 1) | !(diagonal | across_grows);
            shrinks = across_grows & diagonal;
            places_before = places;
        }
        Some(distance).filter(|distance| *distance <= limit)
    }

    /// Where this word has a letter.
    fn places_of(&self, letter: char) -> u64 {
        if let Some(places) = self.places.get(letter as usize) {
            return *places;
        }
        let own = self.letters.iter().enumerate();
        own.filter(|(_, own)| **own == letter)
            .fold(0, |places, (place, _)| places | (1 << place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The distance by its definition, letter by letter.
    fn by_definition(left: &[char], right: &[char]) -> usize {
        let mut rows: Vec<Vec<usize>> = vec![(0..=right.len()).collect()];
        for (i, a) in left.iter().enumerate() {
            let mut row = vec![i + 1];
            for (j, b) in right.iter().enumerate() {
                let replaced = rows[i][j] + usize::from(a != b);
                let mut best = replaced.min(rows[i][j + 1] + 1).min(row[j] + 1);
                if i > 0 && j > 0 && *a == right[j - 1] && left[i - 1] == *b {
                    best = best.min(rows[i - 1][j - 1] + 1);
                }
                row.push(best);
            }
            rows.push(row);
        }
        rows[left.len()][right.len()]
    }

    /// Words of three letters, one of which is not of ASCII, up to the length that is compared.
    #[test]
    fn distances_are_those_of_the_definition() {
        let mut state = 1_u64;
        let mut draw = |bound: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) % bound
        };
        for round in 0..2_000 {
            let longest = if round % 2 == 0 { 9 } else { 65 };
            let mut word = || -> Vec<char> {
                let length = draw(longest);
                (0..length)
                    .map(|_| ['a', 'b', 'ω'][draw(3) as usize])
                    .collect()
            };
            let (left, right) = (word(), word());
            let expected = by_definition(&left, &right);
            let distance = EditDistance::from_word(&left.iter().collect::<String>());
            let right = || right.iter().copied();
            assert_eq!(distance.word(right(), expected), Some(expected), "{left:?}");
            if let Some(below) = expected.checked_sub(1) {
                assert_eq!(distance.word(right(), below), None, "{left:?}");
            }
        }
    }

    #[test]
    fn capitals_are_like_small_letters_and_the_far_end_does_not_count() {
        let distance = EditDistance::from_word("Spring-Mass");
        assert_eq!(distance.word("spring-mass".chars(), 0), Some(0));
        assert_eq!(distance.word("sprign-MASS".chars(), 1), Some(1));
        let long = "x".repeat(64);
        let distance = EditDistance::from_word(&format!("{long}y"));
        assert_eq!(distance.word(format!("{long}z").chars(), 0), Some(0));
        assert_eq!(EditDistance::from_word("").word("ab".chars(), 2), Some(2));
    }
}
