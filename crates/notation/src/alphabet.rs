//! The alphabets of mathematics: bold, script and double-struck letters.

use super::Style;

/// The mathematical letter of a style; what has none stays as it is.
///
/// # References
///
/// The Unicode Standard, *Mathematical Alphanumeric Symbols*, U+1D400 to U+1D7FF, and the letters
/// that were encoded before it in U+2100 to U+214F.
pub(crate) fn styled(char: char, style: Style) -> Option<char> {
    // Bold italic capital Greek is upright in LaTeX, as the digits are.
    let (upper, lower, digit, greek_upper, greek_lower) = match style {
        Style::Bold => (0x1D400, 0x1D41A, 0x1D7CE, 0x1D6A8, 0x1D6C2),
        Style::BoldItalic => (0x1D468, 0x1D482, 0x1D7CE, 0x1D6A8, 0x1D736),
        Style::Script => (0x1D49C, 0x1D4B6, 0, 0, 0),
        Style::Double => (0x1D538, 0x1D552, 0x1D7D8, 0, 0),
        Style::Default | Style::Upright => return None,
    };
    let earlier = match (style, char) {
        (Style::Script, 'B') => 'ℬ',
        (Style::Script, 'E') => 'ℰ',
        (Style::Script, 'F') => 'ℱ',
        (Style::Script, 'H') => 'ℋ',
        (Style::Script, 'I') => 'ℐ',
        (Style::Script, 'L') => 'ℒ',
        (Style::Script, 'M') => 'ℳ',
        (Style::Script, 'R') => 'ℛ',
        (Style::Script, 'e') => 'ℯ',
        (Style::Script, 'g') => 'ℊ',
        (Style::Script, 'o') => 'ℴ',
        (Style::Double, 'C') => 'ℂ',
        (Style::Double, 'H') => 'ℍ',
        (Style::Double, 'N') => 'ℕ',
        (Style::Double, 'P') => 'ℙ',
        (Style::Double, 'Q') => 'ℚ',
        (Style::Double, 'R') => 'ℝ',
        (Style::Double, 'Z') => 'ℤ',
        _ => '\0',
    };
    if earlier != '\0' {
        return Some(earlier);
    }
    let (base, first) = match char {
        'A'..='Z' => (upper, 'A'),
        'a'..='z' => (lower, 'a'),
        '0'..='9' => (digit, '0'),
        'Α'..='Ω' => (greek_upper, 'Α'),
        'α'..='ω' => (greek_lower, 'α'),
        _ => return None,
    };
    if base == 0 {
        return None;
    }
    char::from_u32(base + (char as u32 - first as u32))
}
