//! The text of a table in the encodings that spreadsheets save.

use unicode_normalization::{UnicodeNormalization as _, is_nfc};

/// A text, and whether its encoding had to be guessed.
#[derive(Debug, PartialEq)]
pub(crate) struct Decoded {
    pub(crate) text: String,
    pub(crate) is_guessed: bool,
}

/// Bytes that are not text, with their line, from 1.
#[derive(Debug, PartialEq)]
pub(crate) struct NoText {
    pub(crate) line: usize,
    pub(crate) found: &'static str,
}

/// What Windows-1252 has where ISO 8859-1 has control characters; five places are free.
const WINDOWS: [Option<char>; 32] = [
    Some('€'),
    None,
    Some('‚'),
    Some('ƒ'),
    Some('„'),
    Some('…'),
    Some('†'),
    Some('‡'),
    Some('ˆ'),
    Some('‰'),
    Some('Š'),
    Some('‹'),
    Some('Œ'),
    None,
    Some('Ž'),
    None,
    None,
    Some('‘'),
    Some('’'),
    Some('“'),
    Some('”'),
    Some('•'),
    Some('–'),
    Some('—'),
    Some('˜'),
    Some('™'),
    Some('š'),
    Some('›'),
    Some('œ'),
    None,
    Some('ž'),
    Some('Ÿ'),
];

/// Reads UTF-8, UTF-16 with or without a mark of byte order, and all else as Windows-1252; accents are [`composed`].
pub(crate) fn decode(bytes: Vec<u8>) -> Result<Decoded, NoText> {
    match bytes.as_slice() {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => {
            let found = "UTF-32";
            return Err(NoText { line: 1, found });
        }
        [0xff, 0xfe, rest @ ..] => return utf16(rest, u16::from_le_bytes).map(certain),
        [0xfe, 0xff, rest @ ..] => return utf16(rest, u16::from_be_bytes).map(certain),
        // A heading begins with letters of ASCII, or with a quotation mark.
        [a, 0, b, 0, ..] if *a > 0 && *b > 0 => {
            return utf16(&bytes, u16::from_le_bytes).map(certain);
        }
        [0, a, 0, b, ..] if *a > 0 && *b > 0 => {
            return utf16(&bytes, u16::from_be_bytes).map(certain);
        }
        _ => {}
    }
    if let Some(at) = bytes.iter().position(|byte| *byte == 0) {
        let found = "a byte that no text has";
        let line = line(&bytes, at);
        return Err(NoText { line, found });
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(certain(match text.strip_prefix('\u{feff}') {
            Some(rest) => rest.to_owned(),
            None => text,
        })),
        Err(error) => windows(error.as_bytes()),
    }
}

/// A text of which nothing was guessed.
fn certain(text: String) -> Decoded {
    Decoded {
        text: composed(text),
        is_guessed: false,
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, NoText> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let mut text = String::with_capacity(bytes.len());
    for char in char::decode_utf16(pairs.iter().map(|pair| unit(*pair))) {
        match char {
            Ok(char) => text.push(char),
            Err(_) => return Err(broken(&text)),
        }
    }
    if rest.is_empty() {
        Ok(text)
    } else {
        Err(broken(&text))
    }
}

/// Where a text breaks off that is no UTF-16.
fn broken(text: &str) -> NoText {
    NoText {
        line: line(text.as_bytes(), text.len()),
        found: "broken UTF-16",
    }
}

fn windows(bytes: &[u8]) -> Result<Decoded, NoText> {
    let mut text = String::with_capacity(bytes.len() + bytes.len() / 8);
    for (at, byte) in bytes.iter().enumerate() {
        let char = match byte {
            0x80..=0x9f => WINDOWS[usize::from(byte - 0x80)],
            _ => Some(char::from(*byte)),
        };
        let Some(char) = char else {
            let found = "neither UTF-8 nor Windows-1252";
            let line = line(bytes, at);
            return Err(NoText { line, found });
        };
        text.push(char);
    }
    Ok(Decoded {
        text,
        is_guessed: true,
    })
}

/// A text with each accent in one character with its letter. Some systems save `é` as `e` and an accent: the same id
/// from two files would be two students.
pub(crate) fn composed(text: String) -> String {
    // Nothing composes across the end of a line, and with one mark in a text all of it would be composed to compare.
    let is_composed = |line: &str| line.bytes().all(|byte| byte < FIRST_MARK) || is_nfc(line);
    if text.split_inclusive('\n').all(is_composed) {
        text
    } else {
        text.nfc().collect()
    }
}

/// The first byte of U+0300, below which no character goes together with another one.
const FIRST_MARK: u8 = 0xcc;

/// The line of a byte.
fn line(bytes: &[u8], at: usize) -> usize {
    bytes[..at].iter().filter(|byte| **byte == b'\n').count() + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIST: &str = "id;name\r\n1;Zoé Œuvré\r\n2;Jürgen Straße\r\n";

    fn read(bytes: impl Into<Vec<u8>>) -> (String, bool) {
        let decoded = decode(bytes.into()).expect("it is text");
        (decoded.text, decoded.is_guessed)
    }

    #[test]
    fn each_encoding_of_a_spreadsheet_gives_the_same_text() {
        let units = || LIST.encode_utf16();
        let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
        let all = [
            LIST.as_bytes().to_vec(),
            [b"\xef\xbb\xbf", LIST.as_bytes()].concat(),
            [b"\xff\xfe".as_slice(), &little].concat(),
            [b"\xfe\xff".as_slice(), &big].concat(),
            little,
            big,
        ];
        for bytes in all {
            assert_eq!(read(bytes.clone()), (LIST.to_owned(), false), "{bytes:?}");
        }
        // By the table of the code page: é E9, Œ 8C, ü FC, ß DF.
        let windows = b"id;name\r\n1;Zo\xe9 \x8cuvr\xe9\r\n2;J\xfcrgen Stra\xdfe\r\n";
        assert_eq!(read(windows), (LIST.to_owned(), true));
    }

    #[test]
    fn accents_are_composed_in_whatever_line_they_stand() {
        for (typed, meant) in [
            ("Zoe\u{301}\nJürgen\n", "Zoé\nJürgen\n"),
            ("a\nZoe\u{301}", "a\nZoé"),
            ("θ\u{307}\nω₁ = 5", "θ\u{307}\nω₁ = 5"),
            // The mark after a line belongs to nothing in it.
            ("e\n\u{301}", "e\n\u{301}"),
            ("\u{212b}", "Å"),
        ] {
            assert_eq!(composed(typed.to_owned()), meant, "{typed:?}");
        }
    }

    #[test]
    fn what_is_no_text_is_refused_with_its_line() {
        let broken: [(&[u8], usize); 5] = [
            (b"\xff\xfe\0\0i\0\0\0", 1),
            (b"id,name\n1,a\0b\n", 2),
            (b"id\n1\n\x81\n", 3),
            (b"\xff\xfei\0\n\0\0\xd8i\0", 2),
            (b"\xff\xfei\0\n\0x", 2),
        ];
        for (bytes, line) in broken {
            let error = decode(bytes.to_vec()).expect_err("it is not text");
            assert_eq!(error.line, line, "{bytes:?}");
        }
        assert_eq!(read(b""), (String::new(), false));
    }
}
