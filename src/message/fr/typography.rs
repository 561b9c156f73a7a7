//! Les espaces insécables : French sets high punctuation off with a space at which no line is broken.

/// A text whose high punctuation comes after spaces that do not break. What is quoted between backticks was typed by
/// somebody, and stays as it is.
///
/// The full no-break space serves for all of them: the narrow one (U+202F), which some houses set before `;`, `!` and `?`,
/// is missing from too many fonts.
pub(crate) fn spaced(text: &str) -> String {
    let pieces = text.split('`').enumerate();
    let pieces = pieces.map(|(place, piece)| {
        if place % 2 == 0 {
            outside_quotes(piece)
        } else {
            piece.to_owned()
        }
    });
    pieces.collect::<Vec<_>>().join("`")
}

fn outside_quotes(text: &str) -> String {
    const HIGH: [char; 5] = [':', ';', '!', '?', '»'];
    let mut spaced = String::with_capacity(text.len());
    let mut signs = text.chars().peekable();
    while let Some(sign) = signs.next() {
        let is_before = sign == ' ' && signs.peek().is_some_and(|next| HIGH.contains(next));
        let is_behind = sign == ' ' && spaced.ends_with('«');
        spaced.push(if is_before || is_behind {
            '\u{a0}'
        } else {
            sign
        });
    }
    spaced
}

#[cfg(test)]
mod tests {
    use super::spaced;

    #[test]
    fn high_punctuation_stays_with_its_word() {
        assert_eq!(spaced("Ordre : a ; b"), "Ordre\u{a0}: a\u{a0}; b");
        assert_eq!(spaced("« oui » ?"), "«\u{a0}oui\u{a0}»\u{a0}?");
        assert_eq!(spaced("`a : b` : non"), "`a : b`\u{a0}: non");
        assert_eq!(spaced("12:30"), "12:30");
    }
}
