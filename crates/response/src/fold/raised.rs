//! Exponents in raised signs that are more than integers: `e⁻⁰·⁸⁵ᵗ`, `(k/m)¹ᐟ²`.

use super::Folder;
use crate::digits::raised;
use crate::signs::{is_digit, is_times};

/// Raised signs that integers are not made of, and what they are.
const RAISED: &[(char, char)] = &[
    ('⁺', '+'),
    ('⁽', '('),
    ('⁾', ')'),
    ('ᐟ', '/'),
    ('ᵗ', 't'),
    ('ⁿ', 'n'),
    ('ⁱ', 'i'),
    ('ʲ', 'j'),
    ('ᵏ', 'k'),
    ('ᵐ', 'm'),
    ('ᶜ', 'c'),
    ('ᵃ', 'a'),
    ('ᵇ', 'b'),
    ('ᵖ', 'p'),
    ('ʳ', 'r'),
    ('ˢ', 's'),
    ('ˣ', 'x'),
    ('ᵝ', 'β'),
    ('ᵞ', 'γ'),
    ('ᵟ', 'δ'),
    ('ᶿ', 'θ'),
    ('ᵠ', 'φ'),
];

/// What a raised sign is on the line.
fn lowered(char: char) -> Option<char> {
    if char.is_ascii() {
        return None;
    }
    let mut others = RAISED.iter();
    raised(char).or_else(|| Some(others.find(|(raised, _)| *raised == char)?.1))
}

impl Folder<'_> {
    /// The length of an exponent in raised signs that is more than an integer, and how it is written on the line.
    pub(crate) fn raised(&self) -> Option<(usize, String)> {
        let rest = self.rest();
        rest.chars().next().and_then(lowered)?;
        let before = self.typed[..self.at].chars().next_back();
        if !before.is_some_and(|last| last.is_alphanumeric() || ")]}".contains(last)) {
            return None;
        }
        let (mut plain, mut length, mut is_more) = (String::new(), 0, false);
        while let Some(char) = rest[length..].chars().next() {
            let behind = rest[length + char.len_utf8()..].chars().next();
            let is_within = || behind.and_then(lowered).is_some_and(is_digit);
            match lowered(char) {
                Some(own) => {
                    is_more |= !(own.is_ascii_digit() || own == '-');
                    plain.push(own);
                }
                // A point between raised digits is their decimal sign.
                None if (char == '.' || is_times(char)) && is_within() => {
                    is_more = true;
                    plain.push('.');
                }
                None => break,
            }
            length += char.len_utf8();
        }
        is_more.then(|| (length, format!("^({plain})")))
    }
}
