//! Characters of a private-use area that stand for holes of a text; Markdown and LaTeX take them for letters.

/// The first of the characters that stand for holes.
// The private use area of Unicode begins here: nobody types these 6,400 characters.
const FIRST: u32 = 0xE000;
/// How many holes a text may have.
// They fit into the private use area.
pub const LIMIT: usize = 6000;
/// What stands for a written `<<`.
pub const LITERAL: char = '\u{F8FF}';

/// The character that stands for a hole; `None` from [`LIMIT`] on.
pub fn mark(hole: usize) -> Option<char> {
    (hole < LIMIT)
        .then(|| char::from_u32(FIRST + hole as u32))
        .flatten()
}

/// The hole that a character stands for.
pub fn hole(char: char) -> Option<u32> {
    u32::from(char)
        .checked_sub(FIRST)
        .filter(|hole| (*hole as usize) < LIMIT)
}

/// Whether a character belongs to the private-use area of these marks.
pub fn is_private(char: char) -> bool {
    ('\u{E000}'..='\u{F8FF}').contains(&char)
}
