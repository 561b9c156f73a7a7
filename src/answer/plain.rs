//! One spelling for signs that look alike: letters pasted from typeset formulas, dollars around LaTeX.

use std::borrow::Cow;

/// A response in plain signs: without the marks that set off a formula in LaTeX, letters of mathematical
/// alphabets and wide digits as ordinary ones, signs without width left out.
///
/// # Errors
///
/// What to type instead of a dollar sign that encloses nothing.
///
/// ```
/// use vibank::answer::plain;
///
/// assert_eq!(plain(r"$\omega = 5$ rad/s").unwrap().trim(), r"\omega = 5  rad/s");
/// assert_eq!(plain("𝑘/𝑚").unwrap(), "k/m");
/// assert!(plain("5 $").is_err());
/// ```
pub fn plain(response: &str) -> Result<Cow<'_, str>, &'static str> {
    let is_plain = |byte: u8| (b' '..=b'~').contains(&byte) && !b"$\\`".contains(&byte);
    if response.bytes().all(is_plain) {
        return Ok(Cow::Borrowed(response));
    }
    let text: String = response.chars().filter_map(sign).collect();
    let text = text.replace("$$", "$");
    if text.matches('$').count() % 2 == 1 {
        return Err(
            "At `$`: a dollar sign is no unit, and encloses no formula here. Leave it out.",
        );
    }
    let text = text.replace('$', " ");
    let inner = text.trim();
    let displayed = [("\\(", "\\)"), ("\\[", "\\]")]
        .into_iter()
        .find_map(|(open, close)| inner.strip_prefix(open)?.strip_suffix(close));
    Ok(Cow::Owned(
        displayed.map_or_else(|| text.clone(), str::to_owned),
    ))
}

/// The plain sign for one that looks alike; none for one without width.
fn sign(char: char) -> Option<char> {
    Some(match char {
        '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{fe0e}' | '\u{fe0f}' | '\u{feff}' => return None,
        '\u{2061}'..='\u{2064}' | '\u{3000}' => ' ',
        '´' | '`' | '‘' | 'ʹ' | 'ʼ' => '\'',
        'º' | '˚' => '°',
        '⟨' | '〈' => '(',
        '⟩' | '〉' => ')',
        '∶' | '：' => ':',
        '“' | '”' => '"',
        '\u{2126}' => 'Ω',
        '\u{2206}' => 'Δ',
        'ℎ' => 'h',
        'ℯ' => 'e',
        'ⅈ' => 'i',
        'ⅉ' => 'j',
        '！'..='～' => char::from_u32(u32::from(char) - 0xfee0).unwrap_or(char),
        '\u{1d400}'..='\u{1d7ff}' => mathematical(u32::from(char) - 0x1d400).unwrap_or(char),
        _ => char,
    })
}

/// The letter or digit at a place of the block of mathematical alphabets.
fn mathematical(place: u32) -> Option<char> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pasted_letters_are_plain_ones() {
        for (pasted, meant) in [
            ("𝑚𝑥̈ + 𝑘𝑥 = 0", "mx\u{308} + kx = 0"),
            ("𝜔ₙ = √(𝑘/𝑚)", "ωₙ = √(k/m)"),
            ("𝛀𝐀𝐳𝟗", "ΩAz9"),
            ("ℎ𝒹", "hd"),
            ("５．２", "5.2"),
            ("x´´", "x''"),
            ("\u{feff}5\u{200b}", "5"),
            ("\\(k/m\\)", "k/m"),
            ("$$5$$", " 5 "),
        ] {
            assert_eq!(
                plain(pasted).expect("no dollar stands alone"),
                meant,
                "{pasted}"
            );
        }
    }

    #[test]
    fn a_dollar_alone_is_refused() {
        for typed in ["5 $", "$5", "$5$ $", "5 $$", "[[1, 2]] $"] {
            assert!(plain(typed).is_err(), "{typed}");
        }
    }
}
