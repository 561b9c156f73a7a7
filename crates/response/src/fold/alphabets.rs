//! Letters and digits of other styles.

/// The ordinary letter or digit for one of another style.
pub(crate) fn unstyled(char: char) -> char {
    match char {
        '\u{1d400}'..='\u{1d7ff}' => mathematical(u32::from(char) - 0x1d400).unwrap_or(char),
        _ => char,
    }
}

/// The letter or digit at a place of the block of mathematical alphabets.
fn mathematical(place: u32) -> Option<char> {
    // Unicode's block from U+1D400: thirteen alphabets of 52 letters, from U+1D6A8 five of 58 Greek ones,
    // from U+1D7CE five sets of digits.
    const LETTERS: u32 = 13 * 52;
    const GREEK: u32 = 0x2a8;
    const DIGITS: u32 = 0x3ce;
    let of = |first: char, offset: u32| char::from_u32(u32::from(first) + offset);
    match place {
        0..LETTERS if place % 52 < 26 => of('A', place % 52),
        0..LETTERS => of('a', place % 52 - 26),
        GREEK..DIGITS if place < GREEK + 5 * 58 => match (place - GREEK) % 58 {
            17 => Some('Θ'),
            25 => Some('∇'),
            offset @ 0..25 => of('Α', offset),
            offset @ 26..51 => of('α', offset - 26),
            offset => ['∂', 'ϵ', 'ϑ', 'ϰ', 'ϕ', 'ϱ', 'ϖ']
                .get(offset as usize - 51)
                .copied(),
        },
        DIGITS.. => of('0', (place - DIGITS) % 10),
        _ => None,
    }
}
