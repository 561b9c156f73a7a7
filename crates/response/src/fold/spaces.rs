//! Spaces and letters of every width as ordinary ones, before anything else is read: what is said around an answer, words and
//! runs of signs are recognized by the spaces and signs of a keyboard.

use crate::signs::{Plain, escaped};

/// A text in spaces and letters of one width.
pub(crate) struct OneWidth {
    pub(crate) text: String,
    /// Where each byte of it stands in what was typed, and where that ends.
    places: Vec<u32>,
}

impl OneWidth {
    /// The text that was typed with others; none where it has only ordinary ones.
    pub(crate) fn of(typed: &str) -> Option<Self> {
        if typed.chars().all(|char| width(char) == Width::Ordinary) && !typed.contains('\\') {
            return None;
        }
        let (mut text, mut places) = (String::with_capacity(typed.len()), Vec::new());
        let mut at = 0;
        while let Some(char) = typed[at..].chars().next() {
            let (width, length) =
                escaped_space(&typed[at..]).unwrap_or((width(char), char.len_utf8()));
            match width {
                Width::Ordinary => text.push(char),
                Width::Wide(plain) => text.push(plain),
                Width::None => {}
            }
            places.resize(text.len(), at as u32);
            at += length;
            // A sign after two backslashes is not escaped.
            if char == '\\' && width == Width::Ordinary && typed[at..].starts_with('\\') {
                text.push('\\');
                places.resize(text.len(), at as u32);
                at += 1;
            }
        }
        if text == typed {
            return None;
        }
        places.push(typed.len() as u32);
        Some(Self { text, places })
    }

    /// The place in what was typed of a place in the text.
    pub(crate) fn place(&self, at: u32) -> u32 {
        self.places[at as usize]
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Width {
    Ordinary,
    /// Of another width than this one.
    Wide(char),
    None,
}

/// The space of LaTeX that begins a text, with its length; the one in braces parts thousands.
fn escaped_space(text: &str) -> Option<(Width, usize)> {
    const BRACED: &str = "{\\,}";
    if text.starts_with(BRACED) {
        return Some((Width::Wide(' '), BRACED.len()));
    }
    let sign = text.strip_prefix('\\')?.chars().next()?;
    match escaped(sign)? {
        Plain::Text(" ") => Some((Width::Wide(' '), 1 + sign.len_utf8())),
        Plain::Nothing => Some((Width::None, 1 + sign.len_utf8())),
        Plain::Text(_) => None,
    }
}

fn width(char: char) -> Width {
    match char {
        '\u{a0}' | '\u{2000}'..='\u{200a}' | '\u{202f}' | '\u{205f}' | '\u{3000}' => {
            Width::Wide(' ')
        }
        '\u{200b}'..='\u{200f}'
        | '\u{2060}'
        | '\u{ad}'
        | '\u{fe0e}'
        | '\u{fe0f}'
        | '\u{feff}'
        | '\r' => Width::None,
        '！'..='～' => {
            char::from_u32(u32::from(char) - 0xfee0).map_or(Width::Ordinary, Width::Wide)
        }
        _ => Width::Ordinary,
    }
}
