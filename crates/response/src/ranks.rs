//! Lists whose values are said to be the lower one, the second, that of a mode: `lower: 5 m, upper: 6 m`,
//! `5 m (in phase), 6 m (opposed)`.

use super::list::{cut, cut_where};
use super::signs::{is_between_digits, is_digit};
use super::words::RANKS;
use vibank_source::{Span, lower};

/// The values of a list in the order of what each is said to be, parted by semicolons; none where not each of so many has
/// a rank of its own.
pub(crate) fn in_order(text: &str, count: usize) -> Option<String> {
    let all = Span::new(0, text.len());
    let by_signs = cut(text, all, &[';', '\n']);
    let pieces = if by_signs.len() == count {
        by_signs
    } else {
        cut_where(text, all, |at, char| match char {
            ';' | '\n' => true,
            ',' => !is_between_digits(text, at),
            ' ' => text[at..].starts_with(" and "),
            _ => false,
        })
    };
    if pieces.len() != count || count < 2 {
        return None;
    }
    let ranked = pieces.iter().map(|piece| {
        let piece = text[piece.range()].trim();
        ranked(piece.strip_prefix("and ").unwrap_or(piece), count)
    });
    let mut ranked: Vec<(usize, &str)> = ranked.collect::<Option<_>>()?;
    vibank_dynamics::numerics::sort_by_key(&mut ranked, |(rank, _)| *rank);
    let is_whole = ranked.iter().map(|(rank, _)| *rank).eq(1..=count);
    let values: Vec<&str> = ranked.into_iter().map(|(_, value)| value).collect();
    is_whole.then(|| values.join("; "))
}

/// The rank that a piece has by the words before or after its value, and the value.
fn ranked(piece: &str, count: usize) -> Option<(usize, &str)> {
    let rank = |words: &str| {
        let words = lower(words.trim());
        let words = words.strip_prefix("the ").unwrap_or(&words);
        let ends = [" mode", " one", " frequency"];
        let words = ends
            .iter()
            .find_map(|end| words.strip_suffix(end))
            .unwrap_or(words);
        let (_, rank) = RANKS.iter().find(|(own, _)| *own == words)?;
        Some(rank.map_or(count, usize::from))
    };
    let behind = [" (", " → ", " -> ", ": ", ", "].iter().find_map(|sign| {
        let (value, words) = piece.rsplit_once(sign)?;
        let words = if *sign == " (" {
            words.strip_suffix(')')?
        } else {
            words
        };
        Some((rank(words)?, value.trim()))
    });
    let before = || {
        let number = piece
            .char_indices()
            .filter(|(at, _)| *at > 0 && piece[..*at].ends_with([' ', ':', '=']));
        let starts = number.map(|(at, _)| at);
        let mut said = starts.filter_map(|at| {
            let (words, value) = piece.split_at(at);
            let words = words.trim_end();
            let bare = words.trim_end_matches([':', '=']);
            // `1 8.98` has two numbers.
            let is_said = bare.len() < words.len() || !bare.ends_with(is_digit);
            Some((rank(bare)?, value.trim())).filter(|_| is_said)
        });
        // `first mode: 5 m`
        said.next_back()
    };
    let found = behind.or_else(before);
    found.filter(|(_, value)| value.contains(is_digit))
}

#[cfg(test)]
mod tests {
    use super::in_order;

    #[test]
    fn values_come_in_the_order_that_is_said() {
        for (typed, count, values) in [
            ("lower: 5 m, upper: 6 m", 2, Some("5 m; 6 m")),
            ("upper: 6 m, lower: 5 m", 2, Some("5 m; 6 m")),
            ("5 m (in phase); 6 m (opposed)", 2, Some("5 m; 6 m")),
            ("5,1 m (lower), 6,2 m (upper)", 2, Some("5,1 m; 6,2 m")),
            ("1: 5, 2: 6", 2, Some("5; 6")),
            ("5 m → mode 1; 6 m → mode 2", 2, Some("5 m; 6 m")),
            ("lowest 5, middle 6, highest 7", 3, Some("5; 6; 7")),
            ("first mode: 5 m and second mode: 6 m", 2, Some("5 m; 6 m")),
            ("lower: 5 m, lower: 6 m", 2, None),
            ("lower: 5 m, 6 m", 2, None),
            ("5 m, 6 m", 2, None),
            ("1 5, 2 6", 2, None),
        ] {
            assert_eq!(in_order(typed, count).as_deref(), values, "{typed}");
        }
    }
}
