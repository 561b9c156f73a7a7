//! Words from files and arguments as messages show them: on a terminal nothing in them does anything.

use std::borrow::Cow;

/// Most letters of a message: what is longer quotes a file that is not what it should be.
const MAX_LENGTH: usize = 2_000;

/// A message in which characters that steer a terminal are shown in place of what they do, cut in the middle where it
/// is long.
pub(crate) fn shown(message: &str) -> Cow<'_, str> {
    let visible = still(message);
    let count = visible.chars().count();
    if count <= MAX_LENGTH {
        return visible;
    }
    let half = MAX_LENGTH / 2;
    let beginning = visible.chars().take(half).chain(" … ".chars());
    beginning
        .chain(visible.chars().skip(count - half))
        .collect()
}

/// A text in which characters that steer a terminal are shown in place of what they do.
pub(crate) fn still(text: &str) -> Cow<'_, str> {
    if !text.contains(|char: char| char.is_control() && !matches!(char, '\n' | '\t')) {
        return Cow::Borrowed(text);
    }
    text.chars()
        .map(|char| match char {
            '\n' | '\t' => char,
            '\0'..='\u{1f}' => char::from_u32(u32::from(char) + 0x2400).unwrap_or(char),
            '\u{7f}' => '\u{2421}',
            _ if char.is_control() => '\u{fffd}',
            _ => char,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{MAX_LENGTH, shown};

    #[test]
    fn nothing_that_is_quoted_steers_the_terminal() {
        assert_eq!(shown("a\tb\nç"), "a\tb\nç");
        assert_eq!(
            shown("\u{1b}[31mred\u{7}\r\u{7f}\u{9b}2J"),
            "␛[31mred␇␍␡\u{fffd}2J"
        );
    }

    #[test]
    fn a_long_message_keeps_its_beginning_and_its_end() {
        let long = format!("begin {} end", "é".repeat(1_000_000));
        let cut = shown(&long);
        assert!(cut.starts_with("begin é") && cut.ends_with("é end"));
        assert!(cut.chars().count() < MAX_LENGTH + 10);
    }
}
